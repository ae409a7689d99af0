/* Texts: UTF-16 of Windows and UTF-8 of the library, the language of the user, numbers, files. */
#pragma once
#include <winsock2.h> /* before windows.h */

#include <windows.h>

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <regex>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "resource.h"

namespace fs = std::filesystem;
using std::max;
using std::min;

typedef std::vector<std::wstring> Texts;

inline std::wstring wide(const std::string &utf8) {
    std::wstring text(utf8.size(), L'\0');
    text.resize(MultiByteToWideChar(CP_UTF8, 0, utf8.data(), utf8.size(), text.data(), text.size()));
    return text;
}

inline std::string narrow(const std::wstring &text) {
    std::string utf8(3 * text.size(), '\0');
    utf8.resize(WideCharToMultiByte(CP_UTF8, 0, text.data(), text.size(), utf8.data(), utf8.size(), NULL, NULL));
    return utf8;
}

/* Exception with the reason for the user why an action is not done. */
struct Refusal : std::runtime_error {
    explicit Refusal(const std::wstring &sentence) : std::runtime_error(narrow(sentence)) {}
};

/* The pieces of a text. There is no empty piece after the last separator. */
template <class Text> std::vector<Text> split(const Text &text, typename Text::value_type separator) {
    std::vector<Text> pieces;
    std::basic_istringstream<typename Text::value_type> stream(text);
    for (Text piece; std::getline(stream, piece, separator);)
        pieces.push_back(piece);
    return pieces;
}

/* The language of all texts and dialogs: 0 English, 1 Chinese. */
inline std::atomic<int> language{0};

inline std::string_view resource(LPCWSTR type, UINT id, int of = language) {
    static const WORD IDS[] = {MAKELANGID(LANG_ENGLISH, SUBLANG_ENGLISH_US),
                               MAKELANGID(LANG_CHINESE, SUBLANG_CHINESE_SIMPLIFIED)};
    HRSRC found = FindResourceExW(NULL, type, MAKEINTRESOURCEW(id), IDS[of]);
    return {(const char *)LockResource(LoadResource(NULL, found)), SizeofResource(NULL, found)};
}

/* The texts of a language by their names. */
inline std::map<std::string, std::wstring> read_texts(int of) {
    std::map<std::string, std::wstring> texts;
    for (const std::string &line : split(std::string(resource(MAKEINTRESOURCEW(10), IDR_TEXTS, of)), '\n')) {
        size_t equals = line.find(" = ");
        texts[line.substr(0, equals)] = wide(line.substr(equals + 3));
    }
    return texts;
}

/* All texts. They are read only once, because threads use them. */
inline const std::map<std::string, std::wstring> &all_texts() {
    static const std::map<std::string, std::wstring> languages[] = {read_texts(0), read_texts(1)};
    return languages[language];
}

/* A name of the library in the user's language: scene keys, their words, effects. */
inline std::wstring label(const std::string &name, const std::string &otherwise) {
    auto found = all_texts().find(name);
    return found == all_texts().end() ? wide(otherwise) : found->second;
}

/* A text of the resources by its name, with values for %1, %2, ... Without such a text: the name itself. */
inline std::wstring text(const std::string &name, const Texts &values = {}) {
    std::wstring result = label(name, name);
    for (size_t k = values.size(); k-- > 0;) {
        size_t at = result.find(L"%" + std::to_wstring(k + 1));
        if (at != std::wstring::npos)
            result.replace(at, 2, values[k]);
    }
    return result;
}

inline Texts parts(const std::string &name) { return split(text(name), L';'); }

/* The shortest text that reads back to the bit, like the program `sins` writes it. */
inline std::string shortest(double value) {
    char digits[400];
    double size = std::fabs(value);
    bool is_plain = size == 0 || (size >= 1e-5 && size < 1e15);
    auto form = is_plain ? std::chars_format::fixed : std::chars_format::scientific;
    std::string text(digits, std::to_chars(digits, digits + sizeof digits, value, form).ptr);
    size_t exponent = text.find('e') + 1;
    return exponent == 0 ? text : text.substr(0, exponent) + std::to_string(atoi(&text[exponent]));
}

/* A number with `digits` significant digits. */
inline std::wstring shown(double value, int digits) {
    char text[64];
    auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits);
    return wide(std::string(text, end.ptr));
}

/* Reads a whole text as a number, with any locale. False: it is not a number, or not finite. */
inline bool number_of(const std::string &text, double &value) {
    const char *first = text.c_str() + (text[0] == '+' ? 1 : 0), *last = text.c_str() + text.size();
    std::from_chars_result read = std::from_chars(first, last, value);
    return first != last && read.ec == std::errc() && read.ptr == last && std::isfinite(value);
}

/* The error of a file that cannot be read or written, with the system's sentence. */
inline Refusal refusal(const char *name, const fs::path &path) {
    WCHAR sentence[256] = L"";
    DWORD flags = FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS | FORMAT_MESSAGE_MAX_WIDTH_MASK;
    FormatMessageW(flags, NULL, GetLastError(), 0, sentence, 256, NULL);
    return Refusal(text(name, {path.wstring(), sentence}));
}

inline std::string read_file(const fs::path &path) {
    std::ifstream file(path, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(file), {});
    if (!file.is_open() || file.bad())
        throw refusal("cannot_read", path);
    return bytes;
}

/* Writes a temporary file in the same folder and renames it at the end: the file is complete, or it is
 * not changed. */
inline void write_file(const fs::path &path, const std::function<bool(const fs::path &beside)> &write) {
    fs::path beside = path.wstring() + L".new";
    if (!write(beside) || !MoveFileExW(beside.c_str(), path.c_str(), MOVEFILE_REPLACE_EXISTING)) {
        Refusal why = refusal("cannot_write", path);
        DeleteFileW(beside.c_str());
        throw why;
    }
}

/* Whether two paths name the same file. */
inline bool same_file(const fs::path &one, const fs::path &other) {
    std::error_code none;
    return fs::equivalent(one, other, none);
}
