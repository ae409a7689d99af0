/* The main window: four pages, the scene as its document, and the commands of the menu. */
#pragma once
#include <utility>

#include "display_page.h"
#include "failure_dialog.h"
#include "general_page.h"
#include "study_dialog.h"
#include "trajectory_page.h"

#include <shellapi.h>

/* What the program keeps from run to run: "Language", "Recent". */
inline const wchar_t REGISTRY[] = L"Software\\SINS_Emulator";

inline std::wstring registry_text(const wchar_t *name) {
    WCHAR value[16384] = L"";
    DWORD size = sizeof value;
    RegGetValueW(HKEY_CURRENT_USER, REGISTRY, name, RRF_RT_REG_SZ, NULL, value, &size);
    return value;
}

inline void set_registry_text(const wchar_t *name, const std::wstring &value) {
    DWORD size = (DWORD)((value.size() + 1) * sizeof(WCHAR));
    RegSetKeyValueW(HKEY_CURRENT_USER, REGISTRY, name, REG_SZ, value.c_str(), size);
}

class App : public Dialog, public Document {
public:
    explicit App(const Texts &arguments) : arguments_(arguments) {
        for (const std::string &name : sins::Scene::builtin_names())
            builtins_.push_back(wide(name));
        for (const std::string &file : split(narrow(registry_text(L"Recent")), "|"))
            recent_.push_back(wide(file));
        recent_.pop_back(); /* behind the last "|" there is none */
    }

    /* True: the language changed, and the window is to be built again. */
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
        show_title();
        say_line(fault);
        for (int k = 0; k < 3; k++)
            pages_[k]->refresh(false);
    }

    void say_line(const std::wstring &sentence) override { set(IDC_STATUS, sentence); }

    void open_builtin(const std::string &name) override {
        if (may_discard()) {
            scene = Scene(name);
            replaced(L"");
        }
    }

    void command(int id) override {
        static const int OF_FLIGHT[] = {ID_EXPORT, ID_PICTURE, ID_COPY, ID_SNAPSHOT, ID_GO_BACK, ID_PAUSE, ID_STOP};
        std::wstring name = path.stem();
        size_t builtin = id - ID_BUILTIN, recent = id - ID_RECENT, page = id - ID_PAGE;
        leave_field();
        if (flight == NULL && std::find(OF_FLIGHT, std::end(OF_FLIGHT), id) != std::end(OF_FLIGHT)) {
            say_line(text("nothing_flown"));
            return;
        }
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
        case ID_ABOUT: say(window_, text("about", {wide(sins::version_string())}), MB_ICONINFORMATION); break;
        default:
            if (builtin < builtins_.size())
                open_builtin(narrow(builtins_[builtin]));
            else if (recent < recent_.size() && may_discard())
                open(recent_[recent]);
            else if (page < 4)
                show_page((int)page);
        }
        display_->update();
    }

protected:
    void on_init() override {
        RECT work = {};
        Texts names = parts("tabs");
        SystemParametersInfoW(SPI_GETWORKAREA, 0, &work, 0);
        if (IsRectEmpty(&place_)) {
            RECT wanted = {work.left, work.top, work.left + scaled(960), work.top + scaled(700)};
            IntersectRect(&place_, &wanted, &work);
        }
        pages_[0] = std::make_unique<TrajectoryPage>(*this);
        pages_[1] = std::make_unique<GeneralPage>(*this);
        pages_[2] = std::make_unique<Page>(*this); /* start of the INS: panel (c) of the paper's figure 2 */
        pages_[3].reset(display_ = new DisplayPage(*this));
        for (int k = 0; k < 4; k++) {
            TCITEMW tab = {};
            tab.mask = TCIF_TEXT;
            tab.pszText = names[k].data();
            SendMessageW(item(IDC_TABS), TCM_INSERTITEMW, k, (LPARAM)&tab);
            pages_[k]->create(window_, IDD_TRAJECTORY + k);
        }
        build_menu();
        MoveWindow(window_, place_.left, place_.top, place_.right - place_.left, place_.bottom - place_.top, FALSE);
        show_all();
        show_page(page_);
        SetTimer(window_, 1, 100, NULL);
        ShowWindow(window_, SW_SHOWDEFAULT);
        follow_command_line();
    }

    void on_command(int id, int) override {
        if (id == IDOK) /* Enter: the field is done */
            leave_field();
        else
            command(id);
    }

    void on_notify(NMHDR *notice) override {
        if (notice->idFrom == IDC_TABS && notice->code == (UINT)TCN_SELCHANGE)
            show_page(TabCtrl_GetCurSel(item(IDC_TABS)));
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

    static void translate(HMENU menu) {
        for (int k = 0; k < GetMenuItemCount(menu); k++) {
            WCHAR words[128] = L"";
            GetMenuStringW(menu, k, words, 128, MF_BYPOSITION);
            std::vector<std::string> pieces = split(narrow(words), "\t"); /* and the key */
            std::wstring own = text(pieces[0]) + (pieces.size() > 1 ? L"\t" + wide(pieces[1]) : L"");
            MENUITEMINFOW info = {};
            info.cbSize = sizeof info;
            info.fMask = MIIM_STRING;
            info.dwTypeData = own.data();
            if (!pieces[0].empty())
                SetMenuItemInfoW(menu, k, TRUE, &info);
            translate(GetSubMenu(menu, k));
        }
    }

    void build_menu() {
        HMENU before = GetMenu(window_);
        HMENU menu = LoadMenuIndirectW(resource(MAKEINTRESOURCEW(4), IDR_MENU)); /* RT_MENU */
        translate(menu);
        auto fill = [menu](UINT id, const std::string &title, const Texts &words) {
            HMENU popup = CreatePopupMenu();
            for (size_t k = 0; k < words.size(); k++) {
                std::string name = narrow(words[k]);
                AppendMenuW(popup, MF_STRING, id + k, label("builtin." + name, name).c_str());
            }
            UINT kind = MF_BYCOMMAND | MF_POPUP | (words.empty() ? MF_GRAYED : 0);
            ModifyMenuW(menu, id, kind, (UINT_PTR)popup, text(title).c_str());
        };
        fill(ID_BUILTIN, "&Built-in scenes", builtins_);
        fill(ID_RECENT, "&Recent scenes", recent_);
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
        for (auto &page : pages_) {
            MoveWindow(page->window(), client.left, client.top, client.right - client.left, client.bottom - client.top,
                       TRUE);
        }
    }

    void show_page(int index) {
        page_ = index;
        TabCtrl_SetCurSel(item(IDC_TABS), index);
        for (int k = 0; k < 4; k++)
            ShowWindow(pages_[k]->window(), k == index ? SW_SHOW : SW_HIDE);
        SetWindowPos(pages_[index]->window(), HWND_TOP, 0, 0, 0, 0, SWP_NOMOVE | SWP_NOSIZE);
        RedrawWindow(window_, NULL, NULL, RDW_INVALIDATE | RDW_ALLCHILDREN | RDW_UPDATENOW);
    }

    void show_title() {
        std::wstring name = path.empty() ? text("new_name") : path.filename().wstring();
        name += scene.text() != saved_ ? L"* - " : L" - ";
        SetWindowTextW(window_, (name + text("title")).c_str());
    }

    void show_all() {
        say_line(L"");
        for (auto &page : pages_)
            page->refresh(true);
        show_title();
    }

    void change_language(bool chinese) {
        language = chinese;
        set_registry_text(L"Language", chinese ? L"zh" : L"en");
        changes_language_ = true;
        GetWindowRect(window_, &place_);
        DestroyWindow(window_);
    }

    /* What was typed counts, though the field has the focus still. */
    void leave_field() {
        HWND focus = GetFocus();
        if (IsChild(window_, focus) && is_of_class(focus, L"Edit")) { /* a button would take it for a click */
            WPARAM left = MAKEWPARAM(GetDlgCtrlID(focus), EN_KILLFOCUS);
            SendMessageW(GetParent(focus), WM_COMMAND, left, (LPARAM)focus);
        }
    }

    /* Scenes in files: scene_files.h. */

    void replaced(const fs::path &file);
    void open(const fs::path &file);
    void remember(const fs::path &file);
    bool save(fs::path file);
    bool may_discard();

    /* The flight. */

    void fly() {
        for (int k = 0; k < 3; k++) {
            if (pages_[k]->has_marks()) {
                show_page(k);
                throw Refusal(text("not_in_flight"));
            }
        }
        if (flight != NULL && flight->status().state == Flight::PAUSED) {
            flight->pause(false);
            return;
        }
        flight.reset();
        flight = std::make_unique<Flight>(scene, folder(), display_->pace());
        say_line(L"");
        show_page(3);
    }

    /* No output replaces the scene or the log that it came from. */
    void refuse_input(const fs::path &file) {
        if (same_file(file, path) || same_file(file, flight->log_path()))
            throw Refusal(text("is_input", {file}));
    }

    /* The records, and beside them the measured increments if the scene names a file for them. */
    void export_records(const fs::path &file) {
        fs::path name = flight->increments_name(), increments = file.parent_path() / name;
        if (file.empty())
            return;
        refuse_input(file);
        flight->write_records(file);
        if (!name.empty()) {
            if (name != name.filename() || increments == file)
                throw Refusal(text("increments_name", {name}));
            refuse_input(increments);
            flight->write_increments(increments);
        }
    }

    void save_picture(const fs::path &file) {
        if (!file.empty()) {
            refuse_input(file);
            display_->plot().save(file);
        }
    }

    /* The command line: command_line.h. */

    void follow_command_line();
    void finish_unattended();

    Texts arguments_, builtins_, recent_;
    std::string saved_ = scene.text(); /* as it was opened or saved */
    fs::path export_folder_, picture_path_;
    std::unique_ptr<Page> pages_[4];
    DisplayPage *display_ = NULL; /* the last of them */
    RECT place_ = {};             /* of the window, and its page, when it is built again */
    int page_ = 0;
    bool changes_language_ = false;
};
