#include "text.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <map>
#include <utility>

static WORD primary = LANG_ENGLISH;

std::wstring wide(const std::string &utf8)
{
    int size = MultiByteToWideChar(CP_UTF8, 0, utf8.data(), (int)utf8.size(), NULL, 0);
    std::wstring text((size_t)size, L'\0');
    MultiByteToWideChar(CP_UTF8, 0, utf8.data(), (int)utf8.size(), &text[0], size);
    return text;
}

std::string narrow(const std::wstring &text)
{
    int size = WideCharToMultiByte(CP_UTF8, 0, text.data(), (int)text.size(), NULL, 0, NULL, NULL);
    std::string utf8((size_t)size, '\0');
    WideCharToMultiByte(CP_UTF8, 0, text.data(), (int)text.size(), &utf8[0], size, NULL, NULL);
    return utf8;
}

void set_language(WORD chosen)
{
    primary = chosen == LANG_CHINESE ? LANG_CHINESE : LANG_ENGLISH;
}

WORD language()
{
    return primary;
}

/* The bytes of a resource: in the user's language, or else in any. */
static const void *resource(LPCWSTR type, UINT id, DWORD *size = NULL)
{
    WORD chosen = primary == LANG_CHINESE ? MAKELANGID(LANG_CHINESE, SUBLANG_CHINESE_SIMPLIFIED)
                                          : MAKELANGID(LANG_ENGLISH, SUBLANG_ENGLISH_US);
    HRSRC found = FindResourceExW(NULL, type, MAKEINTRESOURCEW(id), chosen);
    if (found != NULL && size != NULL) {
        *size = SizeofResource(NULL, found);
    }
    return found == NULL ? NULL : LockResource(LoadResource(NULL, found));
}

std::wstring text(UINT id)
{
    /* Strings lie in blocks of 16, each behind its length. */
    const WCHAR *string = (const WCHAR *)resource(MAKEINTRESOURCEW(6), id / 16 + 1);
    for (UINT k = 0; string != NULL && k < id % 16; k++) {
        string += 1 + *string;
    }
    return string == NULL ? L"" : std::wstring(string + 1, *string);
}

std::vector<std::wstring> parts(UINT id)
{
    std::vector<std::wstring> result;
    for (const std::string &part : split(narrow(text(id)), ";")) {
        result.push_back(wide(part));
    }
    return result;
}

std::wstring text(UINT id, const std::wstring &first, const std::wstring &second)
{
    std::wstring result = text(id);
    size_t at = result.find(L"%2");
    if (at != std::wstring::npos) {
        result.replace(at, 2, second);
    }
    at = result.find(L"%1");
    return at == std::wstring::npos ? result : result.replace(at, 2, first);
}

const DLGTEMPLATE *dialog_template(UINT id)
{
    return (const DLGTEMPLATE *)resource(MAKEINTRESOURCEW(5), id);
}

HMENU menu_of(UINT id)
{
    return LoadMenuIndirectW(resource(MAKEINTRESOURCEW(4), id));
}

std::wstring label(const std::string &path, const std::string &otherwise)
{
    static std::map<WORD, std::map<std::string, std::wstring>> labels;
    std::map<std::string, std::wstring> &own = labels[primary];
    if (own.empty()) {
        DWORD size = 0;
        const char *bytes = (const char *)resource(MAKEINTRESOURCEW(10), IDR_KEYS, &size);
        for (const std::string &line : split(bytes == NULL ? "" : std::string(bytes, size), "\n")) {
            size_t equals = line.find(" = ");
            if (equals != std::string::npos) {
                own[line.substr(0, equals)] = wide(line.substr(equals + 3));
            }
        }
        own[""] = L"";
    }
    auto found = own.find(path);
    return found == own.end() ? wide(otherwise) : found->second;
}

std::string shortest(double value)
{
    char digits[400];
    double size = std::fabs(value);
    if (size == 0 || (size >= 1e-5 && size < 1e15)) {
        return std::string(digits, std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed).ptr);
    }
    std::string text(digits, std::to_chars(digits, digits + sizeof digits, value, std::chars_format::scientific).ptr);
    size_t sign = text.find('e') + 1; /* "e+22" is to be "e22", "e-07" "e-7" */
    while (sign > 0 && sign < text.size() && (text[sign] == '+' || (text[sign] == '0' && sign + 1 < text.size()))) {
        text.erase(sign, 1);
    }
    while (sign > 0 && sign + 2 < text.size() && text[sign] == '-' && text[sign + 1] == '0') {
        text.erase(sign + 1, 1);
    }
    return text;
}

std::wstring shown(double value, int digits)
{
    char text[64];
    return wide(std::string(text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr));
}

bool number_of(const std::string &text, double &value)
{
    const char *first = text.c_str() + (text[0] == '+' ? 1 : 0), *last = text.c_str() + text.size();
    std::from_chars_result read = std::from_chars(first, last, value);
    return first != last && read.ec == std::errc() && read.ptr == last && std::isfinite(value);
}

bool begins(const std::string &text, const char *with)
{
    return text.compare(0, std::string(with).size(), with) == 0;
}

std::vector<std::string> split(const std::string &text, const std::string &by)
{
    std::vector<std::string> result;
    size_t from = 0, at;
    while ((at = text.find(by, from)) != std::string::npos) {
        result.push_back(text.substr(from, at - from));
        from = at + by.size();
    }
    result.push_back(text.substr(from));
    return result;
}

bool read_file(const std::wstring &path, std::string &bytes, std::wstring &why)
{
    HANDLE file = CreateFileW(path.c_str(), GENERIC_READ, FILE_SHARE_READ, NULL, OPEN_EXISTING, 0, NULL);
    LARGE_INTEGER size = {};
    bool done = file != INVALID_HANDLE_VALUE && GetFileSizeEx(file, &size) && size.QuadPart < 1ll << 30;
    DWORD read = 0;
    if (done) {
        bytes.resize((size_t)size.QuadPart);
        done = ReadFile(file, &bytes[0], (DWORD)bytes.size(), &read, NULL) && read == bytes.size();
    }
    why = done ? L"" : text(IDS_CANNOT_READ, path, system_sentence(size.QuadPart >> 30 ? ERROR_FILE_TOO_LARGE : GetLastError()));
    if (file != INVALID_HANDLE_VALUE) {
        CloseHandle(file);
    }
    return done;
}

bool write_file(const std::wstring &path, const std::string &bytes, std::wstring &why)
{
    bool is_first = true;
    return write_file(path, [&] { return std::exchange(is_first, false) ? bytes : std::string(); }, why);
}

bool write_file(const std::wstring &path, const std::function<std::string()> &piece, std::wstring &why)
{
    std::wstring beside = path + L".new";
    HANDLE file = CreateFileW(beside.c_str(), GENERIC_WRITE, 0, NULL, CREATE_ALWAYS, 0, NULL);
    bool done = file != INVALID_HANDLE_VALUE;
    for (std::string bytes; done && !(bytes = piece()).empty();) {
        DWORD written = 0;
        done = WriteFile(file, bytes.data(), (DWORD)bytes.size(), &written, NULL) && written == bytes.size();
    }
    DWORD error = done ? 0 : GetLastError();
    if (file != INVALID_HANDLE_VALUE && !CloseHandle(file) && done) {
        done = false;
        error = GetLastError();
    }
    if (done && !MoveFileExW(beside.c_str(), path.c_str(), MOVEFILE_REPLACE_EXISTING)) {
        done = false;
        error = GetLastError();
    }
    if (!done) {
        DeleteFileW(beside.c_str());
        why = text(IDS_CANNOT_WRITE, path, system_sentence(error));
    }
    return done;
}

/* What a file is, whatever it is called; 0 where there is none. */
static unsigned long long identity(const std::wstring &path, DWORD &volume)
{
    BY_HANDLE_FILE_INFORMATION info = {};
    HANDLE file = CreateFileW(path.c_str(), 0, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, NULL, OPEN_EXISTING, 0, NULL);
    if (file != INVALID_HANDLE_VALUE) {
        GetFileInformationByHandle(file, &info);
        CloseHandle(file);
    }
    volume = info.dwVolumeSerialNumber;
    return (unsigned long long)info.nFileIndexHigh << 32 | info.nFileIndexLow;
}

bool same_file(const std::wstring &one, const std::wstring &other)
{
    DWORD volume, other_volume;
    unsigned long long first = identity(one, volume), second = identity(other, other_volume);
    return first != 0 && first == second && volume == other_volume;
}

std::wstring folder_of(const std::wstring &path)
{
    size_t end = path.find_last_of(L"/\\");
    return end == std::wstring::npos ? L"" : path.substr(0, end + 1);
}

std::wstring name_of(const std::wstring &path)
{
    std::wstring name = path.substr(folder_of(path).size());
    return name.substr(0, name.rfind(L'.'));
}

std::wstring system_sentence(DWORD error)
{
    WCHAR sentence[256] = L"";
    FormatMessageW(FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS, NULL, error, 0, sentence, 256, NULL);
    std::wstring text = sentence;
    return text.substr(0, text.find_last_not_of(L"\r\n ") + 1);
}
