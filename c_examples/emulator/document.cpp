/* The main window's document: its scene in files, its flight, and the commands of the menu. */
#include "app.h"

static const wchar_t REGISTRY[] = L"Software\\SINS_Emulator";
static const size_t RECENT = 8;

std::wstring registry_text(const wchar_t *name)
{
    WCHAR value[16384] = L"";
    DWORD size = sizeof value;
    RegGetValueW(HKEY_CURRENT_USER, REGISTRY, name, RRF_RT_REG_SZ, NULL, value, &size);
    return value;
}

void set_registry_text(const wchar_t *name, const std::wstring &value)
{
    DWORD size = (DWORD)((value.size() + 1) * sizeof(WCHAR));
    RegSetKeyValueW(HKEY_CURRENT_USER, REGISTRY, name, REG_SZ, value.c_str(), size);
}

/* Another scene is the document. */
void App::replaced(const std::wstring &path)
{
    path_ = path;
    saved_ = scene.text();
    flight_.reset();
    if (display_ != NULL) {
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
    if (path.size() > 4 &&
        lstrcmpiW(&path[path.size() - 4], L".csv") == 0) { /* a log, for this scene's simulator */
        why = scene.set_text(SINS_SCENE_TEXT_LOG, narrow(path));
        edited(why);
        return why.empty();
    }
    if (read_file(path, bytes, why)) {
        Faults faults = scene.read(bytes);
        for (size_t k = 0; k < faults.size() && k < 8; k++) {
            why += path + L":" + std::to_wstring(faults[k].item) + L": " + told(faults[k].sentence) + L"\n";
        }
    }
    if (!why.empty()) {
        say(window_, why);
        return false;
    }
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
    std::wstring all;
    recent_.erase(std::remove(recent_.begin(), recent_.end(), path), recent_.end());
    recent_.insert(recent_.begin(), path);
    recent_.resize(min(recent_.size(), RECENT));
    for (const std::wstring &own : recent_) {
        all += own + L"|";
    }
    set_registry_text(L"Recent", all);
    build_menu();
}

bool App::save(bool ask)
{
    std::wstring path = path_, why, log = wide(scene.words(SINS_SCENE_TEXT_LOG));
    if (path.empty() || ask) {
        path = ask_file(window_, true, "filter_scene", L"toml", path_);
    }
    if (path.empty()) {
        return false;
    }
    std::wstring log_path = is_absolute(log) ? log : folder() + log;
    if (same_file(path, log_path)) {
        say(window_, text("is_input", {path}));
        return false;
    }
    if (!log.empty() && folder_of(path) != folder()) { /* a log is seen from the scene's folder */
        scene.set_text(SINS_SCENE_TEXT_LOG, narrow(log_path));
    }
    auto write = [this](FILE *file) {
        return fwrite(scene.text().data(), 1, scene.text().size(), file) == scene.text().size();
    };
    if (!write_file(path, write, why)) {
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
    UINT buttons = MB_YESNOCANCEL | MB_ICONQUESTION;
    int answer = MessageBoxW(window_, text("save_changes").c_str(), text("title").c_str(), buttons);
    return answer == IDNO || (answer == IDYES && save(false));
}

void App::fly()
{
    std::wstring why;
    for (int k = 0; k < 3; k++) {
        if (pages_[k]->has_marks()) {
            show_page(k);
            say(window_, text("not_in_flight"));
            return;
        }
    }
    if (flight_ != NULL && flight_->status().state == Flight::PAUSED) {
        flight_->pause(false);
        return;
    }
    flight_.reset(new Flight());
    if (!flight_->start(scene, folder(), display_->pace(), why)) {
        flight_.reset();
        say(window_, why);
        return;
    }
    say_line(L"");
    show_page(3);
}

/* No output replaces the scene or the log that it came from. */
bool App::is_input(const std::wstring &path) const
{
    bool is_one = same_file(path, path_) || same_file(path, flight_->log_path());
    if (is_one) {
        say(window_, text("is_input", {path}));
    }
    return is_one;
}

/* The records, and beside them the measured increments if the scene names a file for them. */
void App::export_records(const std::wstring &path)
{
    std::wstring why, name = flight_->increments_name(), increments = folder_of(path) + name;
    bool is_own =
        is_absolute(name) || name.find_first_of(L"/\\:") != std::wstring::npos || increments == path;
    if (path.empty() || is_input(path)) {
        return;
    }
    if (!flight_->write_records(path, why)) {
        say(window_, why);
    } else if (!name.empty() && is_own) {
        say(window_, text("increments_name", {name}));
    } else if (!name.empty() && !is_input(increments) && !flight_->write_increments(increments, why)) {
        say(window_, why);
    }
}

void App::save_picture(const std::wstring &path)
{
    if (!path.empty() && !is_input(path) && !display_->plot().save(path)) {
        say(window_, text("cannot_write", {path, L"PNG"}));
    }
}

void App::command(int id)
{
    std::wstring path, why;
    bool of_flight = id == ID_EXPORT || id == ID_PICTURE || id == ID_COPY || id == ID_SNAPSHOT ||
                     id == ID_GO_BACK || id == ID_PAUSE || id == ID_STOP;
    leave_field();
    if (flight_ == NULL && of_flight) {
        say_line(text("nothing_flown"));
        return;
    }
    switch (id) {
    case ID_NEW: open_builtin(""); break;
    case ID_OPEN:
        path = may_discard() ? ask_file(window_, false, "filter_scene", L"toml") : L"";
        if (!path.empty()) {
            open(path);
        }
        break;
    case ID_SAVE: save(false); break;
    case ID_SAVE_AS: save(true); break;
    case ID_EXPORT: export_records(ask_file(window_, true, "filter_csv", L"csv", name_of(path_))); break;
    case ID_PICTURE: save_picture(ask_file(window_, true, "filter_png", L"png", name_of(path_))); break;
    case ID_COPY: say_line(text(display_->plot().copy() ? "copied" : "not_copied")); break;
    case ID_QUIT: SendMessageW(window_, WM_CLOSE, 0, 0); return;
    case ID_FLY: fly(); break;
    case ID_PAUSE: flight_->pause(flight_->status().state == Flight::FLYING); break;
    case ID_STOP: flight_->stop(); break;
    case ID_RESET:
        flight_.reset();
        say_line(L"");
        break;
    case ID_FAILURE: edit_failures(*this); break;
    case ID_SNAPSHOT:
        say_line(flight_->save_snapshot(why) ? text("snapshot_at", {shown(flight_->status().snapshot_s, 8)})
                                             : why);
        break;
    case ID_GO_BACK:
        flight_->go_back(why);
        say_line(why);
        break;
    case ID_RECOMMEND: recommend(*this); break;
    case ID_BUDGET: error_budget(*this); break;
    case ID_ENGLISH: change_language(false); break;
    case ID_CHINESE: change_language(true); break;
    case ID_ABOUT: say(window_, text("about", {wide(lib.sins_version_string())}), MB_ICONINFORMATION); break;
    default:
        if (id >= ID_BUILTIN && (size_t)(id - ID_BUILTIN) < builtins_.size()) {
            open_builtin(narrow(builtins_[(size_t)(id - ID_BUILTIN)]));
        } else if (id >= ID_RECENT && (size_t)(id - ID_RECENT) < recent_.size() && may_discard()) {
            open(std::wstring(recent_[(size_t)(id - ID_RECENT)]));
        } else if (id >= ID_PAGE && id < ID_PAGE + 4) {
            show_page(id - ID_PAGE);
        }
    }
    display_->update();
}
