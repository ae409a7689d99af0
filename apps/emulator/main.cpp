/* The program: loads the library and shows the window. */
#include "app.h"

/* Loads the library, only from the folder of the program. */
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

/* /scene FILE or NAME of a built-in scene, /run, /export FOLDER, /picture FILE, /quit, /language en|zh; or a FILE. */
static Options options_of(int count, LPWSTR *words) {
    static const std::set<std::wstring> WITH_VALUE = {L"/scene", L"/export", L"/picture", L"/language"};
    Options options;
    for (int k = 1; k < count; k++) {
        std::wstring word = words[k];
        if (!word.starts_with(L"/"))
            options[L""] = word;
        else
            options[word] = WITH_VALUE.count(word) != 0 && k + 1 < count ? words[++k] : L"";
    }
    return options;
}

int WINAPI wWinMain(HINSTANCE, HINSTANCE, LPWSTR, int) {
    INITCOMMONCONTROLSEX controls = {sizeof controls, ICC_WIN95_CLASSES};
    int count = 0;
    LPWSTR *words = CommandLineToArgvW(GetCommandLineW(), &count);
    Options options = options_of(count, words);
    std::wstring kept = options.count(L"/language") != 0 ? options[L"/language"] : registry_text(L"Language");
    bool is_system_chinese = PRIMARYLANGID(GetUserDefaultUILanguage()) == LANG_CHINESE;
    language = kept.empty() ? is_system_chinese : kept == L"zh";
    is_unattended = options.count(L"/quit") != 0;
    if (!load_library())
        return 1;
    InitCommonControlsEx(&controls);
    App app(options);
    while (app.run()) {
    }
    return has_failed ? 1 : 0;
}
