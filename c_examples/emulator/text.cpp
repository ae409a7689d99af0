#include "text.h"

#include <atomic>
#include <charconv>
#include <cmath>
#include <fstream>
#include <map>
#include <regex>

struct Language {
    std::map<std::string, std::wstring> texts;
    std::vector<std::pair<std::wregex, std::wstring>> rules; /* kinds of sentences of the library */
};

static Language languages[2]; /* English, Chinese: written once, as threads read them */
static std::atomic<int> chosen{0};
static const WORD IDS[] = {MAKELANGID(LANG_ENGLISH, SUBLANG_ENGLISH_US),
                           MAKELANGID(LANG_CHINESE, SUBLANG_CHINESE_SIMPLIFIED)};

std::wstring wide(const std::string &utf8)
{
    std::wstring text(utf8.size(), L'\0');
    text.resize(MultiByteToWideChar(CP_UTF8, 0, utf8.data(), utf8.size(), text.data(), text.size()));
    return text;
}

std::string narrow(const std::wstring &text)
{
    std::string utf8(3 * text.size(), '\0');
    utf8.resize(
        WideCharToMultiByte(CP_UTF8, 0, text.data(), text.size(), utf8.data(), utf8.size(), NULL, NULL));
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
    static const std::string RULE = "rule ";
    Language &own = languages[chinese];
    DWORD size = 0;
    chosen = chinese;
    const char *bytes = (const char *)resource(MAKEINTRESOURCEW(10), IDR_TEXTS, &size); /* RT_RCDATA */
    for (const std::string &line : split(own.texts.empty() ? std::string(bytes, size) : "", "\n")) {
        size_t equals = line.find(" = ");
        if (equals != std::string::npos && line.starts_with(RULE)) {
            std::string sentence = line.substr(RULE.size(), equals - RULE.size());
            own.rules.push_back({std::wregex(wide(sentence)), wide(line.substr(equals + 3))});
        } else if (equals != std::string::npos) {
            own.texts[line.substr(0, equals)] = wide(line.substr(equals + 3));
        }
    }
}

bool is_chinese()
{
    return chosen == 1;
}

std::wstring label(const std::string &name, const std::string &otherwise)
{
    auto found = languages[chosen].texts.find(name);
    return found == languages[chosen].texts.end() ? wide(otherwise) : found->second;
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

/* "gyro.bias_deg_h[1] = -3: must be ...": the field, its element and value, and the rule. */
std::wstring told(const std::string &sentence)
{
    static const std::wregex FIELD(L"([^ \\[:]*)(.*?): (.*)");
    std::wstring own = wide(sentence);
    std::wsmatch found;
    if (!std::regex_match(own, found, FIELD)) {
        return label(sentence, sentence);
    }
    for (const auto &[rule, translation] : languages[chosen].rules) {
        if (std::regex_match(found[3].str(), rule)) {
            std::wstring name = label(narrow(found[1]), narrow(found[1]));
            name = name.substr(0, name.find(L'\uff1b')); /* its first part */
            return name + found[2].str() + L"\uff1a" + std::regex_replace(found[3].str(), rule, translation);
        }
    }
    return own;
}

std::string shortest(double value)
{
    char digits[400];
    double size = std::fabs(value);
    auto form =
        size == 0 || (size >= 1e-5 && size < 1e15) ? std::chars_format::fixed : std::chars_format::scientific;
    std::string text(digits, std::to_chars(digits, digits + sizeof digits, value, form).ptr);
    size_t exponent = text.find('e') + 1;
    return exponent == 0 ? text : text.substr(0, exponent) + std::to_string(atoi(&text[exponent]));
}

std::wstring shown(double value, int digits)
{
    char text[64];
    auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits);
    return wide(std::string(text, end.ptr));
}

bool number_of(const std::string &text, double &value)
{
    const char *first = text.c_str() + (text[0] == '+' ? 1 : 0), *last = text.c_str() + text.size();
    std::from_chars_result read = std::from_chars(first, last, value);
    return first != last && read.ec == std::errc() && read.ptr == last && std::isfinite(value);
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

/* A file that cannot be read or written, with the system's sentence. */
static Refusal refusal(const char *name, const fs::path &path, DWORD error)
{
    WCHAR sentence[256] = L"";
    DWORD flags = FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS | FORMAT_MESSAGE_MAX_WIDTH_MASK;
    FormatMessageW(flags, NULL, error, 0, sentence, 256, NULL);
    return {text(name, {path.wstring(), sentence})};
}

std::string read_file(const fs::path &path)
{
    std::error_code none;
    uintmax_t size = fs::file_size(path, none);
    std::ifstream file(path, std::ios::binary);
    if (!file) {
        throw refusal("cannot_read", path, GetLastError());
    }
    std::string bytes(min(size, (uintmax_t)1 << 30), '\0');
    if (size != bytes.size() || !file.read(bytes.data(), bytes.size())) {
        throw refusal("cannot_read", path, size > bytes.size() ? ERROR_FILE_TOO_LARGE : GetLastError());
    }
    return bytes;
}

void write_file(const fs::path &path, const std::function<bool(const fs::path &beside)> &write)
{
    fs::path beside = path.wstring() + L".new";
    if (!write(beside) || !MoveFileExW(beside.c_str(), path.c_str(), MOVEFILE_REPLACE_EXISTING)) {
        DWORD error = GetLastError();
        DeleteFileW(beside.c_str());
        throw refusal("cannot_write", path, error);
    }
}

bool same_file(const fs::path &one, const fs::path &other)
{
    std::error_code none;
    return fs::equivalent(one, other, none);
}
