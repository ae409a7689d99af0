/* The program: the library is loaded, and the window shown. */
#include "app.h"

#include <shellapi.h>

sins_loader lib;

static const wchar_t REGISTRY[] = L"Software\\SINS_Emulator";

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

/* The library lies beside the program: from nowhere else is it loaded. */
static bool load_library()
{
    WCHAR program[32768];
    char message[2048];
    GetModuleFileNameW(NULL, program, 32768);
    fs::path path = fs::path(program).parent_path() / L"sins.dll";
    if (sins_loader_open(&lib, narrow(path).c_str(), message, sizeof message)) {
        if (lib.has_scenes) {
            return true;
        }
        snprintf(message, sizeof message, "sins.dll: built without scenes, which this program needs");
    }
    say(NULL, wide(message), MB_ICONERROR);
    return false;
}

int WINAPI wWinMain(HINSTANCE, HINSTANCE, LPWSTR, int)
{
    INITCOMMONCONTROLSEX controls = {sizeof controls, ICC_WIN95_CLASSES};
    std::wstring language = registry_text(L"Language");
    bool is_system_chinese = PRIMARYLANGID(GetUserDefaultUILanguage()) == LANG_CHINESE;
    int count = 0;
    LPWSTR *words = CommandLineToArgvW(GetCommandLineW(), &count);
    Texts arguments(words + 1, words + count);
    auto chosen = std::find(arguments.begin(), arguments.end(), L"/language");
    language = arguments.end() - chosen > 1 ? chosen[1] : language;
    is_unattended = std::find(arguments.begin(), arguments.end(), L"/quit") != arguments.end();
    set_language(language.empty() ? is_system_chinese : language == L"zh");
    if (!load_library()) {
        return 1;
    }
    InitCommonControlsEx(&controls);
    Plot::register_class();
    Document document;
    document.arguments = arguments;
    while (App(document).run()) {
    }
    return has_failed ? 1 : 0;
}
