#include "app.h"

#include <shellapi.h>

static const UINT_PTR TIMER = 1;
static const wchar_t REGISTRY[] = L"Software\\SINS_Emulator";
static const size_t RECENT = 8;

App::App() : scene("simulation2"), saved_(scene.text()) {}

std::wstring registry_text(const wchar_t *name)
{
    WCHAR value[16384] = L"";
    DWORD size = sizeof value - sizeof value[0];
    RegGetValueW(HKEY_CURRENT_USER, REGISTRY, name, RRF_RT_REG_SZ, NULL, value, &size);
    return value;
}

void set_registry_text(const wchar_t *name, const std::wstring &value)
{
    RegSetKeyValueW(HKEY_CURRENT_USER, REGISTRY, name, REG_SZ, value.c_str(), (DWORD)((value.size() + 1) * sizeof(WCHAR)));
}

int App::run(HINSTANCE instance)
{
    WNDCLASSEXW main = {};
    main.cbSize = sizeof main;
    main.lpfnWndProc = procedure;
    main.hInstance = instance;
    main.hCursor = LoadCursorW(NULL, (LPCWSTR)IDC_ARROW);
    main.hIcon = LoadIconW(instance, MAKEINTRESOURCEW(1));
    main.hbrBackground = (HBRUSH)(COLOR_WINDOW + 1);
    main.lpszClassName = L"SINS_Emulator";
    RegisterClassExW(&main);
    Plot::register_class();
    RECT work = {0, 0, 960, 700};
    SystemParametersInfoW(SPI_GETWORKAREA, 0, &work, 0);
    int width = min(scaled(960), (int)(work.right - work.left)), height = min(scaled(700), (int)(work.bottom - work.top));
    window_ = CreateWindowExW(WS_EX_ACCEPTFILES | WS_EX_CONTROLPARENT, main.lpszClassName, L"", WS_OVERLAPPEDWINDOW | WS_CLIPCHILDREN,
                              CW_USEDEFAULT, CW_USEDEFAULT, width, height, NULL, NULL, instance, this);
    automatic();
    build();
    ShowWindow(window_, SW_SHOWDEFAULT);
    if (runs_ && !has_failed) {
        fly();
    }
    SetTimer(window_, TIMER, 100, NULL);
    MSG message;
    ACCEL accelerators[6] = {{FVIRTKEY | FCONTROL, 'O', ID_OPEN}, {FVIRTKEY | FCONTROL, 'S', ID_SAVE}};
    for (WORD k = 0; k < 4; k++) {
        accelerators[2 + k] = {FVIRTKEY | FCONTROL, (WORD)('1' + k), (WORD)(ID_PAGE + k)};
    }
    HACCEL table = CreateAcceleratorTableW(accelerators, 6);
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
    return app == NULL ? DefWindowProcW(window, message, wparam, lparam) : app->handle(message, wparam, lparam);
}

/* Menu, pages and status line, in the language of the moment. */
void App::build()
{
    static HFONT font = CreateFontW(-scaled(12), 0, 0, 0, FW_NORMAL, 0, 0, 0, DEFAULT_CHARSET, 0, 0, CLEARTYPE_QUALITY, 0, L"MS Shell Dlg 2");
    int page = tabs_ == NULL ? 0 : TabCtrl_GetCurSel(tabs_);
    HMENU before = GetMenu(window_), menu = menu_of(IDR_MENU), builtins = CreatePopupMenu();
    char name[64];
    builtins_.clear();
    for (size_t k = 0; lib.sins_scene_builtin_name(k, name, sizeof name, NULL) == SINS_OK; k++) {
        builtins_.push_back(wide(name));
        AppendMenuW(builtins, MF_STRING, ID_BUILTIN + k, label("builtin." + std::string(name), name).c_str());
    }
    HMENU file = GetSubMenu(menu, 0);
    ModifyMenuW(file, ID_BUILTIN, MF_BYCOMMAND | MF_POPUP, (UINT_PTR)builtins, parts(IDS_NEW_NAME)[1].c_str());
    SetMenu(window_, menu);
    DestroyMenu(before);
    for (auto &own : pages_) {
        own.reset();
    }
    if (tabs_ != NULL) {
        DestroyWindow(tabs_);
        DestroyWindow(status_);
    }
    tabs_ = CreateWindowExW(0, WC_TABCONTROLW, NULL, WS_CHILD | WS_VISIBLE | WS_TABSTOP | WS_CLIPSIBLINGS, 0, 0, 0, 0, window_, NULL, NULL, NULL);
    status_ = CreateWindowExW(0, STATUSCLASSNAMEW, NULL, WS_CHILD | WS_VISIBLE | SBARS_SIZEGRIP, 0, 0, 0, 0, window_, NULL, NULL, NULL);
    SendMessageW(tabs_, WM_SETFONT, (WPARAM)font, FALSE);
    std::vector<std::wstring> titles = parts(IDS_TABS);
    for (size_t k = 0; k < titles.size(); k++) {
        TCITEMW tab = {};
        tab.mask = TCIF_TEXT;
        tab.pszText = &titles[k][0];
        SendMessageW(tabs_, TCM_INSERTITEMW, k, (LPARAM)&tab);
    }
    display_ = new DisplayPage(*this);
    pages_[0].reset(new TrajectoryPage(*this));
    pages_[1].reset(new GeneralPage(*this));
    pages_[2].reset(new InsPage(*this));
    pages_[3].reset(display_);
    for (UINT k = 0; k < 4; k++) {
        pages_[k]->create(window_, IDD_TRAJECTORY + k);
        pages_[k]->refresh(true);
    }
    recent_.clear();
    for (const std::string &path : split(narrow(registry_text(L"Recent")), "|")) {
        if (!path.empty()) {
            recent_.push_back(wide(path));
        }
    }
    remember(L"");
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
    SendMessageW(tabs_, TCM_ADJUSTRECT, FALSE, (LPARAM)&client);
    for (auto &page : pages_) {
        if (page != NULL) {
            MoveWindow(page->window(), client.left, client.top, client.right - client.left, client.bottom - client.top, TRUE);
        }
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
    std::wstring name = path_.empty() ? parts(IDS_NEW_NAME)[0] : path_.substr(folder_of(path_).size());
    SetWindowTextW(window_, (name + (scene.text() != saved_ ? L"* - " : L" - ") + text(IDS_TITLE)).c_str());
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

/* Another scene is the document. */
void App::replaced(const std::wstring &path)
{
    path_ = path;
    saved_ = scene.text();
    flight_.reset();
    if (pages_[0] != NULL) {
        say_line(L"");
        for (auto &page : pages_) {
            page->refresh(true);
        }
        show_title();
    }
}

bool App::open(const std::wstring &path)
{
    std::string bytes;
    std::wstring why;
    std::vector<Fault> faults;
    Scene other;
    std::wstring ending = path.size() > 4 ? path.substr(path.size() - 4) : L"";
    if (lstrcmpiW(ending.c_str(), L".csv") == 0) { /* a log: flown by the simulator of this scene */
        std::string name = narrow(path);
        bool done = scene.take(lib.sins_scene_set_text(scene.handle(), SINS_SCENE_TEXT_LOG, name.c_str()));
        edited(done ? L"" : wide(last_error()));
        return done;
    }
    if (!read_file(path, bytes, why)) {
        say(window_, why);
        return false;
    }
    if (!other.read(bytes, faults)) {
        for (size_t k = 0; k < faults.size() && k < 8; k++) {
            why += path + L":" + std::to_wstring(faults[k].item) + L": " + wide(faults[k].sentence) + L"\n";
        }
        say(window_, why);
        return false;
    }
    scene = std::move(other);
    replaced(path);
    remember(path);
    return true;
}

void App::open_builtin(const std::string &name)
{
    if (may_discard()) {
        scene = Scene(name);
        replaced(L"");
    }
}

/* The files that were open last: in the menu and in the registry. */
void App::remember(const std::wstring &path)
{
    std::vector<std::wstring> before;
    std::wstring all;
    before.swap(recent_);
    if (!path.empty()) {
        recent_.push_back(path);
    }
    for (const std::wstring &other : before) {
        if (other != path && recent_.size() < RECENT) {
            recent_.push_back(other);
        }
    }
    HMENU file = GetSubMenu(GetMenu(window_), 0), menu = CreatePopupMenu();
    for (size_t k = 0; k < recent_.size(); k++) {
        AppendMenuW(menu, MF_STRING, ID_RECENT + k, recent_[k].c_str());
        all += recent_[k] + L"|";
    }
    for (int k = 0; k < GetMenuItemCount(file); k++) {
        if (GetMenuItemID(file, k) == ID_RECENT || k == 4) { /* behind Save as: a popup has no number */
            ModifyMenuW(file, (UINT)k, MF_BYPOSITION | MF_POPUP | (recent_.empty() ? MF_GRAYED : 0), (UINT_PTR)menu, parts(IDS_NEW_NAME)[2].c_str());
            break;
        }
    }
    if (!path.empty()) {
        set_registry_text(L"Recent", all);
    }
}

bool App::save(bool ask)
{
    std::wstring path = path_.empty() || ask ? ask_file(window_, true, IDS_FILTER_SCENE, L"toml", path_) : path_, why;
    std::wstring log = wide(scene.words(SINS_SCENE_TEXT_LOG));
    bool is_relative = !log.empty() && log.find(L':') == std::wstring::npos && log.find_first_of(L"/\\") != 0;
    if (path.empty()) {
        return false;
    }
    if (is_relative && folder_of(path) != folder()) { /* a log is seen from the scene's folder */
        log = folder() + log;
        is_relative = false;
        scene.take(lib.sins_scene_set_text(scene.handle(), SINS_SCENE_TEXT_LOG, narrow(log).c_str()));
    }
    if (same_file(path, is_relative ? folder() + log : log)) {
        say(window_, text(IDS_IS_INPUT, path));
        return false;
    }
    if (!write_file(path, scene.text(), why)) {
        say(window_, why);
        return false;
    }
    path_ = path;
    saved_ = scene.text();
    remember(path);
    show_title();
    return true;
}

bool App::may_discard()
{
    leave_field();
    if (scene.text() == saved_ || is_unattended) {
        return true;
    }
    int answer = MessageBoxW(window_, text(IDS_SAVE_CHANGES).c_str(), text(IDS_TITLE).c_str(), MB_YESNOCANCEL | MB_ICONQUESTION);
    return answer == IDNO || (answer == IDYES && save(false));
}

bool App::fly()
{
    std::wstring why;
    for (int k = 0; k < 3; k++) {
        if (pages_[k]->has_faults()) {
            show_page(k);
            say(window_, text(IDS_NOT_IN_FLIGHT));
            return false;
        }
    }
    if (flight_ != NULL && flight_->status().state == Flight::PAUSED) {
        flight_->pause(false);
        return true;
    }
    flight_.reset(new Flight());
    if (!flight_->start(scene, folder(), display_->pace(), why)) {
        flight_.reset();
        say(window_, why);
        return false;
    }
    say_line(L"");
    show_page(3);
    return true;
}

/* No output replaces the scene or the log that it came from. */
bool App::is_input(const std::wstring &path) const
{
    bool is_one = same_file(path, path_) || (flight_ != NULL && same_file(path, flight_->log_path()));
    if (is_one) {
        say(window_, text(IDS_IS_INPUT, path));
    }
    return is_one;
}

void App::export_records(const std::wstring &path)
{
    std::wstring why;
    if (!path.empty() && !is_input(path) && !flight_->write_records(path, why)) {
        say(window_, why);
    }
}

void App::change_language(WORD chosen)
{
    set_language(chosen);
    set_registry_text(L"Language", chosen == LANG_CHINESE ? L"zh" : L"en");
    build();
}

void App::command(int id)
{
    std::wstring path, why;
    leave_field();
    if (flight_ == NULL && (id == ID_EXPORT || id == ID_PICTURE || id == ID_COPY || id == ID_SNAPSHOT || id == ID_GO_BACK)) {
        say_line(text(IDS_NOTHING_FLOWN));
        return;
    }
    switch (id) {
    case ID_NEW: open_builtin(""); break;
    case ID_OPEN:
        path = may_discard() ? ask_file(window_, false, IDS_FILTER_SCENE, L"toml") : L"";
        if (!path.empty()) {
            open(path);
        }
        break;
    case ID_SAVE: save(false); break;
    case ID_SAVE_AS: save(true); break;
    case ID_EXPORT: export_records(ask_file(window_, true, IDS_FILTER_CSV, L"csv", name_of(path_))); break;
    case ID_PICTURE:
        path = ask_file(window_, true, IDS_FILTER_PNG, L"png", name_of(path_));
        if (!path.empty() && !is_input(path) && !display_->plot().save(path)) {
            say(window_, text(IDS_CANNOT_WRITE, path, L"PNG"));
        }
        break;
    case ID_COPY: display_->plot().copy(); break;
    case ID_QUIT: SendMessageW(window_, WM_CLOSE, 0, 0); break;
    case ID_FLY: fly(); break;
    case ID_PAUSE:
        if (flight_ != NULL) {
            flight_->pause(flight_->status().state == Flight::FLYING);
        }
        break;
    case ID_STOP:
        if (flight_ != NULL) {
            flight_->stop();
        }
        break;
    case ID_RESET:
        flight_.reset();
        say_line(L"");
        break;
    case ID_FAILURE: edit_failures(*this); break;
    case ID_SNAPSHOT:
        say_line(flight_->save_snapshot(why) ? text(IDS_SNAPSHOT_AT, shown(flight_->status().snapshot_s, 8)) : why);
        break;
    case ID_GO_BACK:
        if (!flight_->go_back(why)) {
            say_line(why);
        }
        break;
    case ID_RECOMMEND: recommend(*this); break;
    case ID_BUDGET: error_budget(*this); break;
    case ID_ENGLISH: change_language(LANG_ENGLISH); break;
    case ID_CHINESE: change_language(LANG_CHINESE); break;
    case ID_ABOUT: say(window_, text(IDS_ABOUT, wide(lib.sins_version_string())), MB_ICONINFORMATION); break;
    default:
        if (id >= ID_PAGE && id < ID_PAGE + 4) {
            show_page(id - ID_PAGE);
        } else if (id >= ID_RECENT && (size_t)(id - ID_RECENT) < recent_.size() && may_discard()) {
            open(std::wstring(recent_[(size_t)(id - ID_RECENT)]));
        } else if (id >= ID_BUILTIN && (size_t)(id - ID_BUILTIN) < builtins_.size()) {
            open_builtin(narrow(builtins_[(size_t)(id - ID_BUILTIN)]));
        }
    }
    display_->update(flight_.get());
}

/* What was typed counts, though the field has the focus still. */
void App::leave_field()
{
    HWND focus = GetFocus();
    if (focus != NULL && IsChild(window_, focus)) {
        SendMessageW(GetParent(focus), WM_COMMAND, MAKEWPARAM(GetDlgCtrlID(focus), EN_KILLFOCUS), (LPARAM)focus);
    }
}

LRESULT App::handle(UINT message, WPARAM wparam, LPARAM lparam)
{
    switch (message) {
    case WM_SIZE:
        if (tabs_ != NULL) {
            layout();
        }
        return 0;
    case WM_GETMINMAXINFO:
        ((MINMAXINFO *)lparam)->ptMinTrackSize = {scaled(780), scaled(560)};
        return 0;
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
            display_->update(flight_.get());
            finish_automatic();
        }
        return 0;
    case WM_DROPFILES: {
        WCHAR path[32768];
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
    case WM_DESTROY:
        PostQuitMessage(0);
        return 0;
    }
    return DefWindowProcW(window_, message, wparam, lparam);
}
