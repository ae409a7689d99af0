/* The main window: five pages, the scene as its document, and the commands of the menu. */
#pragma once
#include "cockpit_page.h"
#include "display_page.h"
#include "general_page.h"
#include "study_dialog.h"
#include "trajectory_page.h"

#include <shellapi.h>

/* Options of the command line and their values. */
typedef std::map<std::wstring, std::wstring> Options;

class App : public Dialog, public Document {
public:
    explicit App(const Options &options) : options_(options) {}

    /* Runs the window. True: the language has changed, and the window must be created again. */
    bool run() {
        HACCEL keys = LoadAcceleratorsW(NULL, MAKEINTRESOURCEW(IDR_KEYS));
        MSG message;
        changes_language_ = false;
        create(NULL, IDD_MAIN);
        while (!(is_unattended && has_failed) && GetMessageW(&message, NULL, 0, 0) > 0) {
            if (!TranslateAcceleratorW(window_, keys, &message) && !IsDialogMessageW(window_, &message)) {
                TranslateMessage(&message);
                DispatchMessageW(&message);
            }
        }
        return changes_language_;
    }

    void edited(const std::wstring &fault) override {
        note_change();
        show_scene(fault, false);
    }

    void named(bool is_other) override {
        build_menu();
        show_scene(L"", is_other);
    }

    void say_line(const std::wstring &sentence) override { set(IDC_STATUS, sentence); }

    bool may_discard() override {
        leave_field();
        if (is_saved() || is_unattended)
            return true;
        UINT buttons = MB_YESNOCANCEL | MB_ICONQUESTION;
        int answer = MessageBoxW(window_, text("save_changes").c_str(), text("title").c_str(), buttons);
        return answer == IDNO || (answer == IDYES && save(path));
    }

    void command(int id) override {
        std::wstring name = path.stem();
        size_t builtin = id - ID_BUILTIN, recent = id - ID_RECENT, page = id - ID_PAGE;
        leave_field();
        if (flight == NULL && ((id >= ID_EXPORT && id <= ID_STOP) || id == ID_PRINT)) {
            say_line(text("nothing_flown"));
            return;
        }
        const bool is_once = flight != NULL && flight->is_live() && (id == ID_PAUSE || id == ID_SNAPSHOT || id == ID_GO_BACK);
        if (is_once || (is_live && (id == ID_RECOMMEND || id == ID_BUDGET)))
            throw Refusal(text("not_live"));
        switch (id) {
        case ID_NEW: open_builtin(""); break;
        case ID_OPEN:
            if (may_discard())
                open(ask_file(window_, false, "filter_scene", L"toml"));
            break;
        case ID_SAVE: save(path); break;
        case ID_SAVE_AS: save(L""); break;
        case ID_EXPORT: export_records(ask_file(window_, true, "filter_csv", L"csv", name)); break;
        case ID_PICTURE: save_picture(ask_file(window_, true, "filter_png", L"png", name)); break;
        case ID_COPY: say_line(text(display_->plot().copy() ? "copied" : "not_copied")); break;
        case ID_PRINT: display_->plot().print(window_, name); break;
        case ID_UNDO: /* rejected input first */
            if (std::none_of(pages_, pages_ + 3, [](auto &own) { return own->has_marks(); }))
                undo();
            show_scene(L"", true);
            break;
        case ID_QUIT: SendMessageW(window_, WM_CLOSE, 0, 0); return;
        case ID_FLY: fly(); break;
        case ID_PAUSE: flight->pause(flight->status().state == Flight::FLYING); break;
        case ID_STOP: flight->stop(); break;
        case ID_RESET:
            flight.reset();
            say_line(L"");
            break;
        case ID_FAILURE: FailureDialog(*this).modal(window_, IDD_FAILURE); break;
        case ID_SNAPSHOT:
            flight->save_snapshot();
            say_line(text("snapshot_at", {shown(flight->status().snapshot_s, 8)}));
            break;
        case ID_GO_BACK: flight->go_back(); break;
        case ID_RECOMMEND: StudyDialog(*this, RECOMMEND).modal(window_, IDD_STUDY); break;
        case ID_BUDGET: StudyDialog(*this, BUDGET).modal(window_, IDD_STUDY); break;
        case ID_ENGLISH:
        case ID_CHINESE: change_language(id == ID_CHINESE); return;
        case ID_ABOUT: say(window_, lines("about", {wide(PROGRAM_VERSION), wide(sins::version_string())}), MB_ICONINFORMATION); break;
        case ID_HELP_KEYS: say(window_, lines("help"), MB_ICONINFORMATION); break;
        default:
            if (builtin < builtins_.size())
                open_builtin(narrow(builtins_[builtin]));
            else if (recent < recent_.size() && may_discard())
                open(fs::path(recent_[recent]));
            else if (page < PAGES)
                show_page((int)page);
        }
        display_->update();
    }

protected:
    void on_init() override {
        if (IsRectEmpty(&place_)) {
            RECT work = {};
            SystemParametersInfoW(SPI_GETWORKAREA, 0, &work, 0);
            RECT wanted = {work.left, work.top, work.left + scaled(960), work.top + scaled(700)};
            IntersectRect(&place_, &wanted, &work);
        }
        pages_[0] = std::make_unique<TrajectoryPage>(*this);
        pages_[1] = std::make_unique<GeneralPage>(*this);
        pages_[2] = std::make_unique<Page>(*this); /* start of the INS: panel (c) of the paper's figure 2 */
        pages_[3].reset(display_ = new DisplayPage(*this));
        pages_[4] = std::make_unique<CockpitPage>(*this);
        Texts names = parts("tabs");
        for (int k = 0; k < PAGES; k++) {
            TCITEMW tab = {.mask = TCIF_TEXT, .pszText = names[k].data()};
            SendMessageW(item(IDC_TABS), TCM_INSERTITEMW, k, (LPARAM)&tab);
            pages_[k]->create(window_, IDD_TRAJECTORY + k);
        }
        MoveWindow(window_, place_.left, place_.top, place_.right - place_.left, place_.bottom - place_.top, FALSE);
        SendMessageW(window_, WM_SETICON, ICON_BIG, (LPARAM)LoadIconW(GetModuleHandleW(NULL), MAKEINTRESOURCEW(IDR_ICON)));
        named(true);
        show_page(page_);
        SetTimer(window_, 1, 100, NULL);
        ShowWindow(window_, SW_SHOWDEFAULT);
        follow_command_line();
    }

    void on_command(int id, int code) override {
        if (id == IDC_TABS && code == (int)TCN_SELCHANGE)
            show_page(TabCtrl_GetCurSel(item(IDC_TABS)));
        else if (id == IDOK) /* Enter: the field is done */
            leave_field();
        else if (code >= 0)
            command(id);
    }

    bool on_message(UINT message, WPARAM wparam, LPARAM lparam) override {
        WCHAR file[32768] = L"";
        switch (message) {
        case WM_SIZE: layout_pages(); return true;
        case WM_GETMINMAXINFO: ((MINMAXINFO *)lparam)->ptMinTrackSize = {scaled(780), scaled(560)}; return true;
        case WM_TIMER:
            if (flight != NULL) {
                display_->update();
                finish_unattended();
            }
            return true;
        case WM_DROPFILES:
            DragQueryFileW((HDROP)wparam, 0, file, 32768);
            DragFinish((HDROP)wparam);
            if (may_discard())
                open(file);
            return true;
        case WM_CLOSE:
            if (may_discard()) {
                flight.reset();
                DestroyWindow(window_);
            }
            return true;
        case WM_DESTROY: PostQuitMessage(0); return true;
        }
        return false;
    }

private:
    /* The window. */

    void build_menu() {
        HMENU before = GetMenu(window_), menu = LoadMenuIndirectW(resource(MAKEINTRESOURCEW(4), IDR_MENU).data());
        auto fill = [menu](int position, UINT id, const Texts &words) {
            HMENU popup = GetSubMenu(GetSubMenu(menu, 0), position);
            for (size_t k = 0; k < words.size(); k++)
                AppendMenuW(popup, MF_STRING, id + k, label("builtin." + narrow(words[k]), narrow(words[k])).c_str());
            if (!words.empty())
                DeleteMenu(popup, 0, MF_BYPOSITION); /* the entry for an empty list */
        };
        fill(4, ID_RECENT, recent_);
        fill(5, ID_BUILTIN, builtins_);
        SetMenu(window_, menu);
        DestroyMenu(before);
    }

    void layout_pages() {
        RECT client, bar;
        GetClientRect(window_, &client);
        SendMessageW(item(IDC_STATUS), WM_SIZE, 0, 0);
        GetWindowRect(item(IDC_STATUS), &bar);
        client.bottom -= bar.bottom - bar.top;
        MoveWindow(item(IDC_TABS), 0, 0, client.right, client.bottom, TRUE);
        TabCtrl_AdjustRect(item(IDC_TABS), FALSE, &client);
        int width = client.right - client.left, height = client.bottom - client.top;
        for (auto &page : pages_)
            MoveWindow(page->window(), client.left, client.top, width, height, TRUE);
    }

    /* Shows a page. Keys never go to a hidden page: a focus within another one moves on, and its field is done. */
    void show_page(int index) {
        HWND shown = pages_[index]->window(), focus = GetFocus();
        page_ = index;
        TabCtrl_SetCurSel(item(IDC_TABS), index);
        ShowWindow(shown, SW_SHOW);
        if (focus != NULL && !IsChild(shown, focus) &&
            std::any_of(std::begin(pages_), std::end(pages_), [=](auto &page) { return IsChild(page->window(), focus); })) {
            HWND first = GetNextDlgTabItem(shown, NULL, FALSE);
            SetFocus(first != NULL ? first : item(IDC_TABS));
        }
        for (int k = 0; k < PAGES; k++)
            ShowWindow(pages_[k]->window(), k == index ? SW_SHOW : SW_HIDE);
        SetWindowPos(shown, HWND_TOP, 0, 0, 0, 0, SWP_NOMOVE | SWP_NOSIZE);
        RedrawWindow(window_, NULL, NULL, RDW_INVALIDATE | RDW_ALLCHILDREN | RDW_UPDATENOW);
    }

    /* A text with a line for each part. */
    static std::wstring lines(const std::string &name, const Texts &values = {}) {
        std::wstring all = text(name, values);
        std::replace(all.begin(), all.end(), L';', L'\n');
        return all;
    }

    void show_scene(const std::wstring &fault, bool all_is_new) {
        std::wstring name = path.empty() ? text("new_name") : path.filename().wstring();
        SetWindowTextW(window_, (name + (is_saved() ? L" - " : L"* - ") + text("title")).c_str());
        say_line(fault);
        for (auto &page : pages_)
            page->refresh(all_is_new);
    }

    void change_language(bool chinese) {
        language = chinese;
        set_registry_text(L"Language", chinese ? L"zh" : L"en");
        changes_language_ = true;
        GetWindowRect(window_, &place_);
        DestroyWindow(window_);
    }

    /* Takes a typed value although the field still has the focus. */
    void leave_field() {
        HWND focus = GetFocus();
        bool is_list = is_of_class(focus, L"ComboBox");
        WPARAM left = MAKEWPARAM(GetDlgCtrlID(focus), is_list ? CBN_KILLFOCUS : EN_KILLFOCUS);
        if (IsChild(window_, focus) && (is_list || is_of_class(focus, L"Edit"))) /* a button would take it for a click */
            SendMessageW(GetParent(focus), WM_COMMAND, left, (LPARAM)focus);
    }

    /* The flight. */

    void fly() {
        for (int k = 0; k < 3; k++) {
            if (pages_[k]->has_marks()) {
                show_page(k);
                throw Refusal(text("not_in_flight") + L"\n" + pages_[k]->first_fault());
            }
        }
        if (flight != NULL && flight->status().state == Flight::PAUSED) {
            flight->pause(false);
            return;
        }
        const Scene own = flown();
        if (Faults faults = own.faults(); !faults.empty())
            throw Refusal(told(faults));
        flight.reset();
        flight = std::make_unique<Flight>(own, folder(), display_->pace(), is_live ? &live_source : NULL);
        say_line(L"");
        show_page(3);
    }

    void save_picture(const fs::path &file) {
        if (file.empty())
            return;
        refuse_input(file);
        display_->plot().save(file);
    }

    /* The command line. */

    std::wstring take(const wchar_t *option) { /* once */
        auto own = options_.extract(option);
        return own ? own.mapped() : L"";
    }

    void follow_command_line() {
        std::wstring name = take(L"/scene");
        if (!name.empty() && name.find(L'.') == name.npos)
            open_builtin(narrow(name));
        else
            open(name);
        open(take(L""));
        if (options_.extract(L"/run"))
            fly();
    }

    void finish_unattended() {
        if (flight->is_under_way())
            return;
        Flight::Status status = flight->status();
        fs::path folder = take(L"/export");
        if (status.state == Flight::FAILED && is_unattended)
            say(window_, status.sentence);
        if (!folder.empty()) {
            fs::create_directories(folder);
            export_records(folder / ((path.empty() ? L"flight" : path.stem().wstring()) + L".csv"));
        }
        save_picture(take(L"/picture"));
        if (is_unattended) {
            flight.reset();
            DestroyWindow(window_);
        }
    }

    Options options_;
    const Texts builtins_ = builtins();
    static constexpr int PAGES = 5;
    std::unique_ptr<Page> pages_[PAGES];
    DisplayPage *display_ = NULL; /* the page before the last */
    RECT place_ = {};             /* place and page of the window when it is created again */
    int page_ = 0;
    bool changes_language_ = false;
};
