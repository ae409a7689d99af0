/* Functions of the system for all windows: sizes, texts of windows, message boxes, file dialogs. */
#pragma once
#include "text.h"

/* Converts pixels at 96 dots per inch to pixels of the screen. */
inline int scaled(int pixels) {
    HDC screen = GetDC(NULL);
    int dots = GetDeviceCaps(screen, LOGPIXELSY);
    ReleaseDC(NULL, screen);
    return MulDiv(pixels, dots, 96);
}

inline std::wstring window_text(HWND window) {
    std::wstring text(GetWindowTextLengthW(window) + 1, L'\0');
    text.resize(GetWindowTextW(window, text.data(), (int)text.size()));
    return text;
}

inline bool is_of_class(HWND window, const wchar_t *name) {
    WCHAR own[32] = L"";
    GetClassNameW(window, own, 32);
    return lstrcmpiW(own, name) == 0;
}

/* Shows a sentence in a message box. If the program runs unattended (/quit), it prints the sentence to the
 * error output and fails. */
inline bool is_unattended = false, has_failed = false;

inline void say(HWND owner, const std::wstring &sentence, UINT icon = MB_ICONWARNING) {
    if (!is_unattended) {
        MessageBoxW(owner, sentence.c_str(), text("title").c_str(), MB_OK | icon);
        return;
    }
    std::string line = "SINS_Emulator: " + narrow(sentence) + "\n";
    DWORD written;
    WriteFile(GetStdHandle(STD_ERROR_HANDLE), line.data(), (DWORD)line.size(), &written, NULL);
    has_failed = true;
}

/* Asks the user for a file; "" if the user cancels. */
inline std::wstring ask_file(HWND owner, bool save, const std::string &filter, const wchar_t *ending,
                             const std::wstring &proposal = L"") {
    WCHAR path[32768] = L"";
    std::wstring pairs = text(filter) + L'\0';
    DWORD flags = OFN_NOCHANGEDIR | OFN_HIDEREADONLY | (save ? OFN_OVERWRITEPROMPT : OFN_FILEMUSTEXIST);
    std::replace(pairs.begin(), pairs.end(), L'|', L'\0');
    lstrcpynW(path, proposal.c_str(), 32768);
    OPENFILENAMEW ask = {.lStructSize = sizeof ask, .hwndOwner = owner, .lpstrFilter = pairs.c_str(), .lpstrFile = path,
                         .nMaxFile = 32768, .Flags = flags, .lpstrDefExt = ending};
    return (save ? GetSaveFileNameW(&ask) : GetOpenFileNameW(&ask)) ? path : L"";
}
