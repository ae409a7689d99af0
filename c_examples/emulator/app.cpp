#include "app.h"

#include <shellapi.h>

App::App(Document &document) : scene(document.scene), document_(document)
{
    char name[64];
    for (size_t k = 0; lib.sins_scene_builtin_name(k, name, sizeof name, NULL) == SINS_OK; k++) {
        builtins.push_back(wide(name));
    }
    for (const std::string &path : split(narrow(registry_text(L"Recent")), "|")) {
        recent_.push_back(wide(path));
    }
    recent_.pop_back(); /* behind the last "|" there is none */
    pages_[0].reset(trajectory_page(*this));
    pages_[1].reset(general_page(*this));
    pages_[2].reset(new Page(*this)); /* initial conditions of the INS: panel (c) of the paper's figure 2 */
    pages_[3].reset(display_);
}

bool App::run()
{
    HACCEL keys = LoadAcceleratorsW(NULL, MAKEINTRESOURCEW(IDR_KEYS));
    MSG message;
    create(NULL, IDD_MAIN);
    while (!(is_unattended && has_failed) && GetMessageW(&message, NULL, 0, 0) > 0) {
        if (!TranslateAcceleratorW(window_, keys, &message) && !IsDialogMessageW(window_, &message)) {
            TranslateMessage(&message);
            DispatchMessageW(&message);
        }
    }
    return changes_language_;
}

void App::on_init()
{
    RECT work = {};
    Texts names = parts("tabs");
    SystemParametersInfoW(SPI_GETWORKAREA, 0, &work, 0);
    if (IsRectEmpty(&document_.place)) {
        RECT wanted = {work.left, work.top, work.left + scaled(960), work.top + scaled(700)};
        IntersectRect(&document_.place, &wanted, &work);
    }
    for (int k = 0; k < 4; k++) {
        TCITEMW tab = {};
        tab.mask = TCIF_TEXT;
        tab.pszText = names[k].data();
        SendMessageW(item(IDC_TABS), TCM_INSERTITEMW, k, (LPARAM)&tab);
        pages_[k]->create(window_, IDD_TRAJECTORY + k);
    }
    build_menu();
    const RECT &place = document_.place;
    MoveWindow(window_, place.left, place.top, place.right - place.left, place.bottom - place.top, FALSE);
    show_all();
    show_page(document_.page);
    SetTimer(window_, 1, 100, NULL);
    ShowWindow(window_, SW_SHOWDEFAULT);
    follow_command_line();
}

static void translate(HMENU menu)
{
    for (int k = 0; k < GetMenuItemCount(menu); k++) {
        WCHAR words[128] = L"";
        GetMenuStringW(menu, k, words, 128, MF_BYPOSITION);
        std::vector<std::string> pieces = split(narrow(words), "\t"); /* and the key */
        std::wstring own = text(pieces[0]) + (pieces.size() > 1 ? L"\t" + wide(pieces[1]) : L"");
        MENUITEMINFOW info = {};
        info.cbSize = sizeof info;
        info.fMask = MIIM_STRING;
        info.dwTypeData = own.data();
        if (!pieces[0].empty()) {
            SetMenuItemInfoW(menu, k, TRUE, &info);
        }
        translate(GetSubMenu(menu, k));
    }
}

void App::build_menu()
{
    HMENU before = GetMenu(window_),
          menu = LoadMenuIndirectW(resource(MAKEINTRESOURCEW(4), IDR_MENU)); /* RT_MENU */
    translate(menu);
    auto fill = [menu](UINT id, const std::string &title, const Texts &words) {
        HMENU popup = CreatePopupMenu();
        for (size_t k = 0; k < words.size(); k++) {
            AppendMenuW(popup, MF_STRING, id + k,
                        label("builtin." + narrow(words[k]), narrow(words[k])).c_str());
        }
        UINT kind = MF_BYCOMMAND | MF_POPUP | (words.empty() ? MF_GRAYED : 0);
        ModifyMenuW(menu, id, kind, (UINT_PTR)popup, text(title).c_str());
    };
    fill(ID_BUILTIN, "&Built-in scenes", builtins);
    fill(ID_RECENT, "&Recent scenes", recent_);
    SetMenu(window_, menu);
    DestroyMenu(before);
}

void App::layout()
{
    RECT client, bar;
    GetClientRect(window_, &client);
    SendMessageW(item(IDC_STATUS), WM_SIZE, 0, 0);
    GetWindowRect(item(IDC_STATUS), &bar);
    client.bottom -= bar.bottom - bar.top;
    MoveWindow(item(IDC_TABS), 0, 0, client.right, client.bottom, TRUE);
    TabCtrl_AdjustRect(item(IDC_TABS), FALSE, &client);
    for (auto &page : pages_) {
        MoveWindow(page->window(), client.left, client.top, client.right - client.left,
                   client.bottom - client.top, TRUE);
    }
}

void App::show_page(int index)
{
    document_.page = index;
    TabCtrl_SetCurSel(item(IDC_TABS), index);
    for (int k = 0; k < 4; k++) {
        ShowWindow(pages_[k]->window(), k == index ? SW_SHOW : SW_HIDE);
    }
    SetWindowPos(pages_[index]->window(), HWND_TOP, 0, 0, 0, 0, SWP_NOMOVE | SWP_NOSIZE);
    RedrawWindow(window_, NULL, NULL, RDW_INVALIDATE | RDW_ALLCHILDREN | RDW_UPDATENOW);
}

void App::show_title()
{
    std::wstring name = document_.path.empty() ? text("new_name") : document_.path.filename().wstring();
    SetWindowTextW(window_,
                   (name + (scene.text() != document_.saved ? L"* - " : L" - ") + text("title")).c_str());
}

void App::say_line(const std::wstring &sentence)
{
    set(IDC_STATUS, sentence);
}

void App::edited(const std::wstring &fault)
{
    show_title();
    say_line(fault);
    for (int k = 0; k < 3; k++) {
        pages_[k]->refresh(false);
    }
}

void App::show_all()
{
    say_line(L"");
    for (auto &page : pages_) {
        page->refresh(true);
    }
    show_title();
}

void App::change_language(bool chinese)
{
    set_language(chinese);
    set_registry_text(L"Language", chinese ? L"zh" : L"en");
    changes_language_ = true;
    GetWindowRect(window_, &document_.place);
    DestroyWindow(window_);
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

void App::on_command(int id, int)
{
    if (id == IDOK) { /* Enter: the field is done */
        leave_field();
    } else {
        command(id);
    }
}

void App::on_notify(NMHDR *notice)
{
    if (notice->idFrom == IDC_TABS && notice->code == (UINT)TCN_SELCHANGE) {
        show_page(TabCtrl_GetCurSel(item(IDC_TABS)));
    }
}

bool App::on_message(UINT message, WPARAM wparam, LPARAM lparam)
{
    WCHAR path[32768] = L"";
    switch (message) {
    case WM_SIZE: layout(); return true;
    case WM_GETMINMAXINFO: ((MINMAXINFO *)lparam)->ptMinTrackSize = {scaled(780), scaled(560)}; return true;
    case WM_TIMER:
        if (flight() != NULL) {
            display_->update();
            finish_unattended();
        }
        return true;
    case WM_DROPFILES:
        DragQueryFileW((HDROP)wparam, 0, path, 32768);
        DragFinish((HDROP)wparam);
        if (may_discard()) {
            open(path);
        }
        return true;
    case WM_CLOSE:
        if (may_discard()) {
            document_.flight.reset();
            DestroyWindow(window_);
        }
        return true;
    case WM_DESTROY: PostQuitMessage(0); return true;
    }
    return false;
}

void Page::refresh(bool all_is_new)
{
    load([this](const Field &field) { return app_.scene.get(field.key->path); }, all_is_new);
}

void Page::on_change(int, int)
{
    std::vector<Change> made = changes();
    if (!made.empty() || has_marks()) {
        app_.edited(mark_faults(app_.scene.change(made)));
    }
}

void Page::on_refusal(const std::wstring &sentence)
{
    app_.say_line(sentence);
}
