#include "text.h"

#include <atomic>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>

namespace fs = std::filesystem;

typedef std::map<std::string, std::wstring> Language;

static Language languages[2]; /* English, Chinese: written once, as threads read them */
static std::atomic<int> chosen{0};
static const WORD IDS[] = {MAKELANGID(LANG_ENGLISH, SUBLANG_ENGLISH_US),
                           MAKELANGID(LANG_CHINESE, SUBLANG_CHINESE_SIMPLIFIED)};

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

const void *resource(LPCWSTR type, UINT id, DWORD *size)
{
    HRSRC found = FindResourceExW(NULL, type, MAKEINTRESOURCEW(id), IDS[chosen]);
    if (size != NULL) {
        *size = SizeofResource(NULL, found);
    }
    return LockResource(LoadResource(NULL, found));
}

void set_language(bool chinese)
{
    Language &own = languages[chinese ? 1 : 0];
    DWORD size = 0;
    chosen = chinese ? 1 : 0;
    const char *bytes = (const char *)resource(MAKEINTRESOURCEW(10), IDR_TEXTS, &size); /* RT_RCDATA */
    for (const std::string &line : split(own.empty() ? std::string(bytes, size) : "", "\n")) {
        size_t equals = line.find(" = ");
        if (equals != std::string::npos) {
            own[line.substr(0, equals)] = wide(line.substr(equals + 3));
        }
    }
}

bool is_chinese()
{
    return chosen == 1;
}

std::wstring label(const std::string &name, const std::string &otherwise)
{
    const Language &texts = languages[chosen];
    auto found = texts.find(name);
    return found == texts.end() ? wide(otherwise) : found->second;
}

std::wstring text(const std::string &name, const Texts &values)
{
    std::wstring result = label(name, name);
    for (size_t k = values.size(); k-- > 0;) {
        size_t at = result.find(L"%" + std::to_wstring(k + 1));
        if (at != std::wstring::npos) {
            result.replace(at, 2, values[k]);
        }
    }
    return result;
}

Texts parts(const std::string &name)
{
    Texts result;
    for (const std::string &part : split(narrow(text(name)), ";")) {
        result.push_back(wide(part));
    }
    return result;
}

/* Whether a sentence is of a kind, "must be from %1 to %2", and what stands in place of %1 and %2. */
static bool matches(const std::string &sentence, const std::string &kind, Texts &values)
{
    size_t from = 0, at = 0, place;
    values.clear();
    while ((place = kind.find('%', from)) != std::string::npos) {
        std::string before = kind.substr(from, place - from);
        size_t next = kind.find('%', place + 1);
        std::string behind = kind.substr(place + 2, next == std::string::npos ? next : next - place - 2);
        size_t end = behind.empty() ? sentence.size() : sentence.find(behind, at + before.size());
        if (sentence.compare(at, before.size(), before) != 0 || end == std::string::npos) {
            return false;
        }
        values.push_back(wide(sentence.substr(at + before.size(), end - at - before.size())));
        from = place + 2;
        at = end;
    }
    return sentence.substr(at) == kind.substr(from);
}

std::wstring told(const std::string &sentence)
{
    const Language &texts = languages[chosen];
    size_t colon = sentence.find(": "), name_end = sentence.find_first_of(" [:");
    if (colon == std::string::npos) {
        return label(sentence, sentence);
    }
    auto rule =
        texts.lower_bound("rule/"); /* backwards: of two kinds that begin alike the longer one counts */
    while (rule != texts.begin() && begins((--rule)->first, "rule.")) {
        Texts values;
        if (matches(sentence.substr(colon + 2), rule->first.substr(5), values)) {
            std::wstring name = label(sentence.substr(0, name_end), sentence.substr(0, name_end));
            name = name.substr(0, name.find(L'\uff1b')); /* its first part */
            std::wstring value = wide(sentence.substr(name_end, colon - name_end));
            return name + value + L"\uff1a" + text(rule->first, values);
        }
    }
    return wide(sentence);
}

std::string shortest(double value)
{
    char digits[400];
    double size = std::fabs(value);
    bool is_fixed = size == 0 || (size >= 1e-5 && size < 1e15);
    char *end = std::to_chars(digits, digits + sizeof digits, value,
                              is_fixed ? std::chars_format::fixed : std::chars_format::scientific)
                    .ptr;
    std::string text(digits, end);
    size_t exponent = text.find('e');
    return exponent == std::string::npos
               ? text
               : text.substr(0, exponent + 1) + std::to_string(atoi(&text[exponent + 1]));
}

std::wstring shown(double value, int digits)
{
    char text[64];
    return wide(
        std::string(text, std::to_chars(text, text + 64, value, std::chars_format::general, digits).ptr));
}

bool number_of(const std::string &text, double &value)
{
    const char *first = text.c_str() + (text[0] == '+' ? 1 : 0), *last = text.c_str() + text.size();
    std::from_chars_result read = std::from_chars(first, last, value);
    return first != last && read.ec == std::errc() && read.ptr == last && std::isfinite(value);
}

bool begins(const std::string &text, const std::string &with)
{
    return text.compare(0, with.size(), with) == 0;
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

static std::wstring system_sentence(DWORD error)
{
    WCHAR sentence[256] = L"";
    FormatMessageW(FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS, NULL, error, 0, sentence, 256,
                   NULL);
    std::wstring text = sentence;
    return text.substr(0, text.find_last_not_of(L"\r\n ") + 1);
}

bool read_file(const std::wstring &path, std::string &bytes, std::wstring &why)
{
    FILE *file = _wfopen(path.c_str(), L"rb");
    char piece[65536];
    size_t size;
    bytes.clear();
    while (file != NULL && bytes.size() < 1 << 30 && (size = fread(piece, 1, sizeof piece, file)) > 0) {
        bytes.append(piece, size);
    }
    bool done = file != NULL && feof(file);
    if (!done) {
        why = text("cannot_read",
                   {path, system_sentence(bytes.size() >> 30 ? ERROR_FILE_TOO_LARGE : GetLastError())});
    }
    if (file != NULL) {
        fclose(file);
    }
    return done;
}

bool write_file(const std::wstring &path, const std::function<bool(FILE *)> &write, std::wstring &why)
{
    std::wstring beside = path + L".new";
    FILE *file = _wfopen(beside.c_str(), L"wb");
    bool done = file != NULL && write(file);
    DWORD error = GetLastError();
    if (file != NULL && fclose(file) != 0 && done) {
        done = false;
        error = GetLastError();
    }
    if (done && !MoveFileExW(beside.c_str(), path.c_str(), MOVEFILE_REPLACE_EXISTING)) {
        done = false;
        error = GetLastError();
    }
    if (!done) {
        DeleteFileW(beside.c_str());
        why = text("cannot_write", {path, system_sentence(error)});
    }
    return done;
}

bool same_file(const std::wstring &one, const std::wstring &other)
{
    std::error_code none;
    return !one.empty() && !other.empty() && fs::equivalent(one, other, none);
}

bool is_absolute(const std::wstring &path)
{
    return fs::path(path).has_root_path();
}

std::wstring folder_of(const std::wstring &path)
{
    return path.substr(0, path.find_last_of(L"/\\") + 1);
}

std::wstring name_of(const std::wstring &path)
{
    return fs::path(path).stem().wstring();
}
