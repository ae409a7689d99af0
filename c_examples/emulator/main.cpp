/* The program: the library is loaded, and the command line followed. */
#include "app.h"

#include <shellapi.h>

sins_loader lib;

/* The library lies beside the program: from nowhere else is it loaded. */
static bool load_library()
{
    WCHAR program[32768];
    char message[2048];
    GetModuleFileNameW(NULL, program, 32768);
    if (sins_loader_open(&lib, narrow(folder_of(program) + L"sins.dll").c_str(), message, sizeof message)) {
        if (lib.has_scenes) {
            return true;
        }
        snprintf(message, sizeof message, "sins.dll: built without scenes, which this program needs");
    }
    say(NULL, wide(message), MB_ICONERROR);
    return false;
}

int WINAPI wWinMain(HINSTANCE instance, HINSTANCE, LPWSTR, int)
{
    INITCOMMONCONTROLSEX controls = {sizeof controls, ICC_WIN95_CLASSES};
    std::wstring chosen = registry_text(L"Language");
    bool is_system_chinese = PRIMARYLANGID(GetUserDefaultUILanguage()) == LANG_CHINESE;
    is_unattended = wcsstr(GetCommandLineW(), L"/quit") != NULL;
    InitCommonControlsEx(&controls);
    set_language(chosen.empty() ? is_system_chinese : chosen == L"zh");
    return load_library() ? App().run(instance) : 1;
}

/* /scene FILE or NAME of a built-in scene, /run, /export FOLDER, /picture FILE, /language en or zh, /quit; or
 * a FILE. */
void App::follow_command_line()
{
    int count = 0;
    LPWSTR *arguments = CommandLineToArgvW(GetCommandLineW(), &count);
    for (int k = 1; k < count; k++) {
        std::wstring option = arguments[k], value;
        if (option == L"/scene" || option == L"/export" || option == L"/picture" || option == L"/language") {
            value = ++k < count ? arguments[k] : L"";
        }
        if (option == L"/scene" && value.find(L'.') == std::wstring::npos) {
            scene = Scene(narrow(value));
            saved_ = scene.text();
        } else if (option == L"/scene") {
            open(value);
        } else if (option == L"/export") {
            export_folder_ = value;
        } else if (option == L"/picture") {
            picture_path_ = value;
        } else if (option == L"/language") {
            set_language(value == L"zh");
        } else if (option == L"/run") {
            runs_ = true;
        } else if (option != L"/quit") {
            open(option);
        }
    }
    LocalFree(arguments);
}

/* At the end of a flight: what the command line asked for. */
void App::finish_unattended()
{
    Flight::Status status = flight_->status();
    bool has_more = !export_folder_.empty() || !picture_path_.empty() || is_unattended;
    if (status.state == Flight::FLYING || status.state == Flight::PAUSED || !has_more) {
        return;
    }
    if (status.state == Flight::FAILED && is_unattended) {
        say(window_, status.sentence);
    }
    if (!export_folder_.empty()) {
        CreateDirectoryW(export_folder_.c_str(), NULL);
        export_records(export_folder_ + L"\\" + (path_.empty() ? L"flight" : name_of(path_)) + L".csv");
    }
    save_picture(picture_path_);
    export_folder_ = picture_path_ = L"";
    if (is_unattended) {
        flight_.reset();
        DestroyWindow(window_);
    }
}
