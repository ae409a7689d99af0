/* The main window's scenes in files: open, save, and those that were open last. */
#pragma once
#include "app.h"

/* Another scene is the document. */
inline void App::replaced(const fs::path &file) {
    path = file;
    saved_ = scene.text();
    flight.reset();
    show_all();
}

inline void App::open(const fs::path &file) {
    if (file.empty())
        return;
    if (lstrcmpiW(file.extension().c_str(), L".csv") == 0) { /* a log, for this scene's simulator */
        edited(told(scene.set({{"flight.file", in_quotes(narrow(file))}})));
        return;
    }
    std::wstring why;
    for (const sins_fault &fault : scene.read(read_file(file)))
        why += file.wstring() + L":" + std::to_wstring(fault.line) + L": " + told(fault) + L"\n";
    if (!why.empty())
        throw Refusal(why.substr(0, 2000));
    replaced(file);
    remember(file);
}

/* The files that were open last: in the menu and in the registry. */
inline void App::remember(const fs::path &file) {
    std::wstring all;
    std::erase(recent_, file.wstring());
    recent_.insert(recent_.begin(), file.wstring());
    recent_.resize(min(recent_.size(), (size_t)8));
    for (const std::wstring &own : recent_)
        all += own + L"|";
    set_registry_text(L"Recent", all);
    build_menu();
}

/* Into a file, or into one that the user names. */
inline bool App::save(fs::path file) {
    std::wstring log = wide(scene->text(SINS_SCENE_TEXT_LOG));
    fs::path log_path = folder() / log;
    if (file.empty())
        file = ask_file(window_, true, "filter_scene", L"toml", path);
    if (file.empty())
        return false;
    if (same_file(file, log_path))
        throw Refusal(text("is_input", {file}));
    if (!log.empty() && file.parent_path() != folder()) /* a log is seen from the scene's folder */
        scene.set({{"flight.file", in_quotes(narrow(log_path))}});
    write_file(file, [this](const fs::path &to) {
        std::ofstream stream(to, std::ios::binary);
        return (stream << scene.text()).flush().good();
    });
    path = file;
    saved_ = scene.text();
    remember(path);
    show_title();
    return true;
}

inline bool App::may_discard() {
    leave_field();
    if (scene.text() == saved_ || is_unattended)
        return true;
    UINT buttons = MB_YESNOCANCEL | MB_ICONQUESTION;
    int answer = MessageBoxW(window_, text("save_changes").c_str(), text("title").c_str(), buttons);
    return answer == IDNO || (answer == IDYES && save(path));
}
