#include "app.h"

#include <shellapi.h>

App::App() : scene("simulation2"), saved_(scene.text())
{
    char name[64];
    for (size_t k = 0; lib.sins_scene_builtin_name(k, name, sizeof name, NULL) == SINS_OK; k++) {
        builtins_.push_back(wide(name));
    }
    for (const std::string &path : split(narrow(registry_text(L"Recent")), "|")) {
        if (!path.empty()) {
            recent_.push_back(wide(path));
        }
    }
}

void App::create_window(HINSTANCE instance)
{
    WNDCLASSEXW main = {};
    RECT work = {0, 0, 960, 700};
    main.cbSize = sizeof main;
    main.lpfnWndProc = procedure;
    main.hInstance = instance;
    main.hCursor = LoadCursorW(NULL, (LPCWSTR)IDC_ARROW);
    main.hIcon = LoadIconW(instance, MAKEINTRESOURCEW(1));
    main.hbrBackground = (HBRUSH)(COLOR_WINDOW + 1);
    main.lpszClassName = L"SINS_Emulator";
    RegisterClassExW(&main);
    Plot::register_class();
    SystemParametersInfoW(SPI_GETWORKAREA, 0, &work, 0);
    int width = min(scaled(960), (int)(work.right - work.left));
    int height = min(scaled(700), (int)(work.bottom - work.top));
    CreateWindowExW(WS_EX_ACCEPTFILES | WS_EX_CONTROLPARENT, main.lpszClassName, L"",
                    WS_OVERLAPPEDWINDOW | WS_CLIPCHILDREN, CW_USEDEFAULT, CW_USEDEFAULT, width, height, NULL,
                    NULL, instance, this);
}

int App::run(HINSTANCE instance)
{
    static ACCEL keys[] = {{FVIRTKEY | FCONTROL, 'O', ID_OPEN},     {FVIRTKEY | FCONTROL, 'S', ID_SAVE},
                           {FVIRTKEY | FCONTROL, '1', ID_PAGE},     {FVIRTKEY | FCONTROL, '2', ID_PAGE + 1},
                           {FVIRTKEY | FCONTROL, '3', ID_PAGE + 2}, {FVIRTKEY | FCONTROL, '4', ID_PAGE + 3}};
    HACCEL table = CreateAcceleratorTableW(keys, sizeof keys / sizeof keys[0]);
    MSG message;
    create_window(instance);
    follow_command_line();
    build();
    ShowWindow(window_, SW_SHOWDEFAULT);
    if (runs_ && !has_failed) {
        fly();
    }
    SetTimer(window_, 1, 100, NULL);
    while (!(is_unattended && has_failed) && GetMessageW(&message, NULL, 0, 0) > 0) {
        if (!TranslateAcceleratorW(window_, table, &message) && !IsDialogMessageW(window_, &message)) {
            TranslateMessage(&message);
            DispatchMessageW(&message);
        }
    }
    return has_failed ? 1 : 0;
}

LRESULT CALLBACK App::procedure(HWND window, UINT message, WPARAM wparam, LPARAM lparam)
{
    App *app = (App *)GetWindowLongPtrW(window, GWLP_USERDATA);
    if (message == WM_NCCREATE) {
        app = (App *)((CREATESTRUCTW *)lparam)->lpCreateParams;
        app->window_ = window;
        SetWindowLongPtrW(window, GWLP_USERDATA, (LONG_PTR)app);
    }
    return app == NULL ? DefWindowProcW(window, message, wparam, lparam)
                       : app->handle(message, wparam, lparam);
}

static void translate(HMENU menu)
{
    for (int k = 0; k < GetMenuItemCount(menu); k++) {
        WCHAR words[128] = L"";
        MENUITEMINFOW info = {};
        GetMenuStringW(menu, (UINT)k, words, 128, MF_BYPOSITION);
        std::wstring all = words,
                     key = all.substr(all.find(L'\t') == std::wstring::npos ? all.size() : all.find(L'\t'));
        std::wstring own = text(narrow(all.substr(0, all.size() - key.size()))) + key;
        info.cbSize = sizeof info;
        info.fMask = MIIM_STRING;
        info.dwTypeData = &own[0];
        if (!all.empty()) {
            SetMenuItemInfoW(menu, (UINT)k, TRUE, &info);
        }
        translate(GetSubMenu(menu, k));
    }
}

void App::build_menu()
{
    HMENU before = GetMenu(window_),
          menu = LoadMenuIndirectW(resource(MAKEINTRESOURCEW(4), IDR_MENU)); /* RT_MENU */
    HMENU builtins = CreatePopupMenu(), recent = CreatePopupMenu();
    translate(menu);
    for (size_t k = 0; k < builtins_.size(); k++) {
        std::string name = narrow(builtins_[k]);
        AppendMenuW(builtins, MF_STRING, ID_BUILTIN + k, label("builtin." + name, name).c_str());
    }
    for (size_t k = 0; k < recent_.size(); k++) {
        AppendMenuW(recent, MF_STRING, ID_RECENT + k, recent_[k].c_str());
    }
    UINT popup = MF_BYCOMMAND | MF_POPUP;
    ModifyMenuW(menu, ID_BUILTIN, popup, (UINT_PTR)builtins, text("&Built-in scenes").c_str());
    ModifyMenuW(menu, ID_RECENT, popup | (recent_.empty() ? MF_GRAYED : 0), (UINT_PTR)recent,
                text("&Recent scenes").c_str());
    SetMenu(window_, menu);
    DestroyMenu(before);
}

/* Menu, pages and status line, in the language of the moment. */
void App::build()
{
    static HFONT font = CreateFontW(-scaled(12), 0, 0, 0, FW_NORMAL, 0, 0, 0, DEFAULT_CHARSET, 0, 0,
                                    CLEARTYPE_QUALITY, 0, L"MS Shell Dlg 2");
    int page = tabs_ == NULL ? 0 : TabCtrl_GetCurSel(tabs_);
    const DWORD STYLE = WS_CHILD | WS_VISIBLE;
    build_menu();
    for (auto &own : pages_) {
        own.reset();
    }
    DestroyWindow(tabs_);
    DestroyWindow(status_);
    tabs_ = CreateWindowExW(0, WC_TABCONTROLW, NULL, STYLE | WS_TABSTOP | WS_CLIPSIBLINGS, 0, 0, 0, 0,
                            window_, NULL, NULL, NULL);
    status_ = CreateWindowExW(0, STATUSCLASSNAMEW, NULL, STYLE | SBARS_SIZEGRIP, 0, 0, 0, 0, window_, NULL,
                              NULL, NULL);
    SendMessageW(tabs_, WM_SETFONT, (WPARAM)font, FALSE);
    display_ = new DisplayPage(*this);
    pages_[0].reset(trajectory_page(*this));
    pages_[1].reset(general_page(*this));
    pages_[2].reset(new Page(*this)); /* initial conditions of the INS: panel (c) of the paper's figure 2 */
    pages_[3].reset(display_);
    Texts titles = parts("tabs");
    for (int k = 0; k < 4; k++) {
        TCITEMW tab = {};
        tab.mask = TCIF_TEXT;
        tab.pszText = &titles[(size_t)k][0];
        TabCtrl_InsertItem(tabs_, k, &tab);
        pages_[k]->create(window_, IDD_TRAJECTORY + (UINT)k);
        pages_[k]->refresh(true);
    }
    show_title();
    layout();
    show_page(page);
}

void App::layout()
{
    RECT client, bar;
    GetClientRect(window_, &client);
    SendMessageW(status_, WM_SIZE, 0, 0);
    GetWindowRect(status_, &bar);
    client.bottom -= bar.bottom - bar.top;
    MoveWindow(tabs_, 0, 0, client.right, client.bottom, TRUE);
    TabCtrl_AdjustRect(tabs_, FALSE, &client);
    for (auto &page : pages_) {
        MoveWindow(page->window(), client.left, client.top, client.right - client.left,
                   client.bottom - client.top, TRUE);
    }
}

void App::show_page(int index)
{
    TabCtrl_SetCurSel(tabs_, index);
    for (int k = 0; k < 4; k++) {
        ShowWindow(pages_[k]->window(), k == index ? SW_SHOW : SW_HIDE);
    }
    SetWindowPos(pages_[index]->window(), HWND_TOP, 0, 0, 0, 0, SWP_NOMOVE | SWP_NOSIZE);
    RedrawWindow(window_, NULL, NULL, RDW_INVALIDATE | RDW_ALLCHILDREN | RDW_UPDATENOW);
}

void App::show_title()
{
    std::wstring name = path_.empty() ? text("new_name") : path_.substr(folder().size());
    SetWindowTextW(window_, (name + (scene.text() != saved_ ? L"* - " : L" - ") + text("title")).c_str());
}

void App::say_line(const std::wstring &sentence)
{
    SendMessageW(status_, SB_SETTEXTW, 0, (LPARAM)sentence.c_str());
}

void App::edited(const std::wstring &fault)
{
    show_title();
    say_line(fault);
    for (int k = 0; k < 3; k++) {
        pages_[k]->refresh(false);
    }
}

void App::change_language(bool chinese)
{
    set_language(chinese);
    set_registry_text(L"Language", chinese ? L"zh" : L"en");
    build();
}

/* What was typed counts, though the field has the focus still. */
void App::leave_field()
{
    HWND focus = GetFocus();
    WCHAR kind[16] = L"";
    GetClassNameW(focus, kind, 16);
    if (IsChild(window_, focus) && lstrcmpiW(kind, L"Edit") == 0) { /* a button would take it for a click */
        WPARAM left = MAKEWPARAM(GetDlgCtrlID(focus), EN_KILLFOCUS);
        SendMessageW(GetParent(focus), WM_COMMAND, left, (LPARAM)focus);
    }
}

LRESULT App::handle(UINT message, WPARAM wparam, LPARAM lparam)
{
    switch (message) {
    case WM_SIZE:
        if (display_ != NULL) {
            layout();
        }
        return 0;
    case WM_GETMINMAXINFO: ((MINMAXINFO *)lparam)->ptMinTrackSize = {scaled(780), scaled(560)}; return 0;
    case WM_COMMAND:
        if (LOWORD(wparam) == IDOK) { /* Enter: the field is done */
            leave_field();
        } else {
            command(LOWORD(wparam));
        }
        return 0;
    case WM_NOTIFY:
        if (((NMHDR *)lparam)->hwndFrom == tabs_ && ((NMHDR *)lparam)->code == (UINT)TCN_SELCHANGE) {
            show_page(TabCtrl_GetCurSel(tabs_));
        }
        return 0;
    case WM_TIMER:
        if (flight_ != NULL) {
            display_->update();
            finish_unattended();
        }
        return 0;
    case WM_DROPFILES: {
        WCHAR path[32768] = L"";
        DragQueryFileW((HDROP)wparam, 0, path, 32768);
        DragFinish((HDROP)wparam);
        if (may_discard()) {
            open(path);
        }
        return 0;
    }
    case WM_CLOSE:
        if (may_discard()) {
            flight_.reset();
            DestroyWindow(window_);
        }
        return 0;
    case WM_DESTROY: PostQuitMessage(0); return 0;
    }
    return DefWindowProcW(window_, message, wparam, lparam);
}

void Page::refresh(bool all_is_new)
{
    load([this](const std::string &path) { return app_.scene.get(path); }, all_is_new);
}

void Page::on_change(int, int)
{
    std::vector<Change> made = changes();
    if (!made.empty() || has_marks()) {
        app_.edited(mark_faults(app_.scene.change(made)));
    }
}
