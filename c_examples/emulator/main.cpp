/* The program: the library is loaded, and the window shown. */
#include "command_line.h"
#include "scene_files.h"

/* The library lies beside the program: from nowhere else is it loaded. */
static bool load_library() {
    WCHAR program[32768];
    char message[2048];
    GetModuleFileNameW(NULL, program, 32768);
    fs::path path = fs::path(program).parent_path() / L"sins.dll";
    if (sins_loader_open(&lib, narrow(path).c_str(), message, sizeof message)) {
        if (lib.has_scenes)
            return true;
        snprintf(message, sizeof message, "sins.dll: built without scenes, which this program needs");
    }
    say(NULL, wide(message), MB_ICONERROR);
    return false;
}

int WINAPI wWinMain(HINSTANCE, HINSTANCE, LPWSTR, int) {
    INITCOMMONCONTROLSEX controls = {sizeof controls, ICC_WIN95_CLASSES};
    std::wstring kept = registry_text(L"Language");
    bool is_system_chinese = PRIMARYLANGID(GetUserDefaultUILanguage()) == LANG_CHINESE;
    int count = 0;
    LPWSTR *words = CommandLineToArgvW(GetCommandLineW(), &count);
    Texts arguments(words + 1, words + count);
    auto option = std::find(arguments.begin(), arguments.end(), L"/language");
    kept = arguments.end() - option > 1 ? option[1] : kept;
    language = kept.empty() ? is_system_chinese : kept == L"zh";
    is_unattended = std::find(arguments.begin(), arguments.end(), L"/quit") != arguments.end();
    if (!load_library())
        return 1;
    InitCommonControlsEx(&controls);
    Plot::register_class();
    App app(arguments);
    while (app.run()) {
    }
    return has_failed ? 1 : 0;
}
