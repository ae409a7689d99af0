/* The main window's command line, and what it asks for at the end of a flight. */
#pragma once
#include "app.h"

/* /scene FILE or NAME of a built-in scene, /run, /export FOLDER, /picture FILE, /quit; or a FILE. */
inline void App::follow_command_line() {
    Texts arguments = std::exchange(arguments_, {});
    bool runs = false;
    for (size_t k = 0; k < arguments.size(); k++) {
        const std::wstring &option = arguments[k];
        const std::wstring value = k + 1 < arguments.size() ? arguments[k + 1] : L"";
        bool has_value = true;
        if (option == L"/scene" && value.find(L'.') == std::wstring::npos) {
            open_builtin(narrow(value));
        } else if (option == L"/scene") {
            open(value);
        } else if (option == L"/export") {
            export_folder_ = value;
        } else if (option == L"/picture") {
            picture_path_ = value;
        } else if (option != L"/language") {
            has_value = false;
            runs = runs || option == L"/run";
            if (!option.starts_with(L"/"))
                open(option);
        }
        k += has_value;
    }
    if (runs)
        fly();
}

/* At the end of a flight: what the command line asked for. */
inline void App::finish_unattended() {
    Flight::Status status = flight->status();
    bool has_more = !export_folder_.empty() || !picture_path_.empty() || is_unattended;
    if (status.state == Flight::FLYING || status.state == Flight::PAUSED || !has_more)
        return;
    fs::path folder = std::exchange(export_folder_, {}), picture = std::exchange(picture_path_, {});
    if (status.state == Flight::FAILED && is_unattended)
        say(window_, status.sentence);
    if (!folder.empty()) {
        fs::create_directories(folder);
        export_records(folder / ((path.empty() ? L"flight" : path.stem().wstring()) + L".csv"));
    }
    save_picture(picture);
    if (is_unattended) {
        flight.reset();
        DestroyWindow(window_);
    }
}
