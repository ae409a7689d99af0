/* The main window's document: its scene in files, its flight, and the commands of the menu and the command
 * line. */
#include <utility>

#include "app.h"

static const size_t RECENT = 8;

/* Another scene is the document. */
void App::replaced(const fs::path &path)
{
    document_.path = path;
    document_.saved = scene.text();
    document_.flight.reset();
    show_all();
}

void App::open(const fs::path &path)
{
    if (lstrcmpiW(path.extension().c_str(), L".csv") == 0) { /* a log, for this scene's simulator */
        scene.set_text(SINS_SCENE_TEXT_LOG, narrow(path));
        edited(L"");
        return;
    }
    std::wstring why;
    Faults faults = scene.read(read_file(path));
    for (size_t k = 0; k < faults.size() && k < 8; k++) {
        why += path.wstring() + L":" + std::to_wstring(faults[k].item) + L": " + told(faults[k].sentence) +
               L"\n";
    }
    if (!faults.empty()) {
        throw Refusal{why};
    }
    replaced(path);
    remember(path);
}

void App::open_builtin(const std::string &name)
{
    if (may_discard()) {
        scene = Scene(name);
        replaced(L"");
    }
}

/* The files that were open last: in the menu and in the registry. */
void App::remember(const fs::path &path)
{
    std::wstring all;
    std::erase(recent_, path.wstring());
    recent_.insert(recent_.begin(), path.wstring());
    recent_.resize(min(recent_.size(), RECENT));
    for (const std::wstring &own : recent_) {
        all += own + L"|";
    }
    set_registry_text(L"Recent", all);
    build_menu();
}

bool App::save(bool ask)
{
    std::wstring log = wide(scene.words(SINS_SCENE_TEXT_LOG));
    fs::path path = document_.path, log_path = folder() / log;
    if (path.empty() || ask) {
        path = ask_file(window_, true, "filter_scene", L"toml", path);
    }
    if (path.empty()) {
        return false;
    }
    if (same_file(path, log_path)) {
        throw Refusal{text("is_input", {path})};
    }
    if (!log.empty() && path.parent_path() != folder()) { /* a log is seen from the scene's folder */
        scene.set_text(SINS_SCENE_TEXT_LOG, narrow(log_path));
    }
    write_file(path, [this](const fs::path &to) {
        std::ofstream file(to, std::ios::binary);
        return (file << scene.text()).flush().good();
    });
    document_.path = path;
    document_.saved = scene.text();
    remember(path);
    show_title();
    return true;
}

bool App::may_discard()
{
    leave_field();
    if (scene.text() == document_.saved || is_unattended) {
        return true;
    }
    UINT buttons = MB_YESNOCANCEL | MB_ICONQUESTION;
    int answer = MessageBoxW(window_, text("save_changes").c_str(), text("title").c_str(), buttons);
    return answer == IDNO || (answer == IDYES && save(false));
}

void App::fly()
{
    for (int k = 0; k < 3; k++) {
        if (pages_[k]->has_marks()) {
            show_page(k);
            throw Refusal{text("not_in_flight")};
        }
    }
    if (flight() != NULL && flight()->status().state == Flight::PAUSED) {
        flight()->pause(false);
        return;
    }
    document_.flight.reset();
    document_.flight.reset(new Flight(scene, folder(), display_->pace()));
    say_line(L"");
    show_page(3);
}

/* No output replaces the scene or the log that it came from. */
void App::refuse_input(const fs::path &path)
{
    if (same_file(path, document_.path) || same_file(path, flight()->log_path())) {
        throw Refusal{text("is_input", {path})};
    }
}

/* The records, and beside them the measured increments if the scene names a file for them. */
void App::export_records(const fs::path &path)
{
    fs::path name = flight()->increments_name(), increments = path.parent_path() / name;
    if (path.empty()) {
        return;
    }
    refuse_input(path);
    flight()->write_records(path);
    if (!name.empty()) {
        if (name != name.filename() || increments == path) {
            throw Refusal{text("increments_name", {name})};
        }
        refuse_input(increments);
        flight()->write_increments(increments);
    }
}

void App::save_picture(const fs::path &path)
{
    if (!path.empty()) {
        refuse_input(path);
        display_->plot().save(path);
    }
}

void App::command(int id)
{
    static const int OF_FLIGHT[] = {ID_EXPORT,  ID_PICTURE, ID_COPY, ID_SNAPSHOT,
                                    ID_GO_BACK, ID_PAUSE,   ID_STOP};
    std::wstring path, name = document_.path.stem();
    size_t builtin = id - ID_BUILTIN, recent = id - ID_RECENT, page = id - ID_PAGE;
    leave_field();
    if (flight() == NULL && std::find(OF_FLIGHT, std::end(OF_FLIGHT), id) != std::end(OF_FLIGHT)) {
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
    case ID_EXPORT: export_records(ask_file(window_, true, "filter_csv", L"csv", name)); break;
    case ID_PICTURE: save_picture(ask_file(window_, true, "filter_png", L"png", name)); break;
    case ID_COPY: say_line(text(display_->plot().copy() ? "copied" : "not_copied")); break;
    case ID_QUIT: SendMessageW(window_, WM_CLOSE, 0, 0); return;
    case ID_FLY: fly(); break;
    case ID_PAUSE: flight()->pause(flight()->status().state == Flight::FLYING); break;
    case ID_STOP: flight()->stop(); break;
    case ID_RESET:
        document_.flight.reset();
        say_line(L"");
        break;
    case ID_FAILURE: edit_failures(*this); break;
    case ID_SNAPSHOT:
        flight()->save_snapshot();
        say_line(text("snapshot_at", {shown(flight()->status().snapshot_s, 8)}));
        break;
    case ID_GO_BACK: flight()->go_back(); break;
    case ID_RECOMMEND: recommend(*this); break;
    case ID_BUDGET: error_budget(*this); break;
    case ID_ENGLISH:
    case ID_CHINESE: change_language(id == ID_CHINESE); return;
    case ID_ABOUT: say(window_, text("about", {wide(lib.sins_version_string())}), MB_ICONINFORMATION); break;
    default:
        if (builtin < builtins.size()) {
            open_builtin(narrow(builtins[builtin]));
        } else if (recent < recent_.size() && may_discard()) {
            open(recent_[recent]);
        } else if (page < 4) {
            show_page((int)page);
        }
    }
    display_->update();
}

/* /scene FILE or NAME of a built-in scene, /run, /export FOLDER, /picture FILE, /quit; or a FILE. */
void App::follow_command_line()
{
    Texts arguments = std::exchange(document_.arguments, {});
    bool runs = false;
    for (size_t k = 0; k < arguments.size(); k++) {
        const std::wstring &option = arguments[k], value = k + 1 < arguments.size() ? arguments[k + 1] : L"";
        bool has_value = true;
        if (option == L"/scene" && value.find(L'.') == std::wstring::npos) {
            open_builtin(narrow(value));
        } else if (option == L"/scene") {
            open(value);
        } else if (option == L"/export") {
            document_.export_folder = value;
        } else if (option == L"/picture") {
            document_.picture_path = value;
        } else if (option != L"/language") {
            has_value = false;
            runs = runs || option == L"/run";
            if (!option.starts_with(L"/")) {
                open(option);
            }
        }
        k += has_value;
    }
    if (runs) {
        fly();
    }
}

/* At the end of a flight: what the command line asked for. */
void App::finish_unattended()
{
    Flight::Status status = flight()->status();
    bool has_more = !document_.export_folder.empty() || !document_.picture_path.empty() || is_unattended;
    if (status.state == Flight::FLYING || status.state == Flight::PAUSED || !has_more) {
        return;
    }
    fs::path folder = std::exchange(document_.export_folder, {}),
             picture = std::exchange(document_.picture_path, {});
    if (status.state == Flight::FAILED && is_unattended) {
        say(window_, status.sentence);
    }
    if (!folder.empty()) {
        std::wstring name = document_.path.empty() ? L"flight" : document_.path.stem().wstring();
        fs::create_directories(folder);
        export_records(folder / (name + L".csv"));
    }
    save_picture(picture);
    if (is_unattended) {
        document_.flight.reset();
        DestroyWindow(window_);
    }
}
