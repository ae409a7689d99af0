/* The exchange between the fields of a dialog and the keys of a scene, and what a dialog asks and says
 * besides. */
#include <set>

#include "dialog.h"

void Dialog::bind(HWND control, const std::string &path, size_t element)
{
    const Key *key = key_of(path);
    fields_[control] = {key, element, "", L""};
    if (!key->words.empty()) {
        fill(control, key->word_labels());
    }
    if (key->count > 0) {
        SendMessageW(control, EM_SETCUEBANNER, FALSE, (LPARAM)L"0");
    }
    tip(control, key->tip());
}

void Dialog::unbind(HWND control)
{
    fields_.erase(control);
    mark(control, L"");
}

void Dialog::cue(const std::string &path, const std::wstring &text) const
{
    for (const auto &entry : fields_) {
        if (entry.second.key->path() == path) {
            SendMessageW(entry.first, EM_SETCUEBANNER, FALSE, (LPARAM)text.c_str());
        }
    }
}

void Dialog::enable_fields(const std::string &begin, bool enabled) const
{
    for (const auto &entry : fields_) {
        if (begins(entry.second.key->path(), begin)) {
            EnableWindow(entry.first, enabled);
        }
    }
}

void Dialog::mark(HWND control, const std::wstring &sentence)
{
    auto found = marked_.find(control);
    if ((found == marked_.end() ? L"" : found->second) != sentence) {
        marked_[control] = sentence;
        if (sentence.empty()) {
            marked_.erase(control);
        }
        InvalidateRect(control, NULL, TRUE);
    }
}

void Dialog::load(const std::function<std::string(const std::string &path)> &value, bool all_is_new)
{
    for (auto &entry : fields_) {
        HWND control = entry.first;
        Field &field = entry.second;
        const Key &key = *field.key;
        std::string own = value(key.path());
        double number;
        if (marked_.count(control) != 0 && !all_is_new) {
            continue;
        }
        mark(control, L"");
        if (!key.words.empty()) {
            SendMessageW(control, CB_SETCURSEL, key.index_of(own), 0);
        } else if (key.count > 0) {
            own = numbers(own, key)[field.element];
            if (key.path() == si_path_ && number_of(own, number)) {
                own = shortest(number / key.units_per_si());
            }
        }
        if (key.words.empty()) {
            bool is_decimal =
                own.find_first_not_of("0123456789") != std::string::npos && number_of(own, number);
            std::wstring text = is_decimal ? shown(number, 15) : wide(unquoted(own));
            if (text != window_text(control)) {
                SetWindowTextW(control, text.c_str());
            }
        }
        field.loaded = own;
        field.shown = text_of(control, field);
    }
}

/* What a control shows now. */
std::wstring Dialog::text_of(HWND control, const Field &field) const
{
    const Key &key = *field.key;
    if (key.words.empty()) {
        return window_text(control);
    }
    return wide(key.words[(size_t)max((LRESULT)0, SendMessageW(control, CB_GETCURSEL, 0, 0))]);
}

/* The value of a control: as it was loaded, unless it was changed. */
std::string Dialog::value_of(HWND control, const Field &field) const
{
    std::wstring now = text_of(control, field);
    bool is_quoted = field.key->is_text ? !now.empty() : !field.key->words.empty() && !field.key->is_switch();
    if (now == field.shown) {
        return field.loaded;
    }
    return is_quoted ? quoted(narrow(now)) : field.key->is_switch() ? narrow(now) : toml(now);
}

std::vector<Change> Dialog::changes() const
{
    std::vector<Change> changes;
    std::set<const Key *> done;
    for (const auto &entry : fields_) {
        const Key *key = entry.second.key;
        if (text_of(entry.first, entry.second) == entry.second.shown || !done.insert(key).second) {
            continue;
        }
        std::vector<std::string> elements(max((size_t)1, key->count));
        for (const auto &other : fields_) {
            if (other.second.key == key) {
                elements[other.second.element] = value_of(other.first, other.second);
            }
        }
        changes.push_back(
            {key->path(), key->count > 1 ? list_of(elements) : elements[0], key->path() == si_path_});
    }
    return changes;
}

std::wstring Dialog::mark_faults(const Faults &faults)
{
    for (const auto &entry : fields_) {
        const Field &field = entry.second;
        std::wstring sentence;
        std::string typed = narrow(window_text(entry.first));
        double number;
        bool is_sound = field.key->count > 1 && (typed.empty() || number_of(typed, number));
        for (const Fault &fault : faults) {
            size_t bracket = fault.sentence.find(field.key->name + "[");
            size_t digit = bracket + field.key->name.size() + 1;
            bool has_element = bracket != std::string::npos;
            bool is_own = has_element ? (size_t)atoi(&fault.sentence[digit]) == field.element : !is_sound;
            if (key_of(fault.path) == field.key && is_own) {
                sentence = told(fault.sentence);
            }
        }
        mark(entry.first, sentence);
        tip(entry.first, sentence.empty() ? field.key->tip() : sentence);
    }
    return told(faults);
}

/* Whether this notification says that a field has a new value. */
bool Dialog::is_change(HWND control, int code) const
{
    auto found = fields_.find(control);
    if (found == fields_.end()) {
        return false;
    }
    return code == (found->second.key->words.empty() ? (int)EN_KILLFOCUS : (int)CBN_SELCHANGE);
}

std::wstring ask_file(HWND owner, bool save, const std::string &filter, const wchar_t *ending,
                      const std::wstring &proposal)
{
    WCHAR path[32768] = L"";
    std::wstring pairs = text(filter) + L'\0';
    OPENFILENAMEW ask = {};
    std::replace(pairs.begin(), pairs.end(), L';', L'\0');
    lstrcpynW(path, proposal.c_str(), 32768);
    ask.lStructSize = sizeof ask;
    ask.hwndOwner = owner;
    ask.lpstrFilter = pairs.c_str();
    ask.lpstrFile = path;
    ask.nMaxFile = 32768;
    ask.lpstrDefExt = ending;
    ask.Flags = OFN_NOCHANGEDIR | OFN_HIDEREADONLY | (save ? OFN_OVERWRITEPROMPT : OFN_FILEMUSTEXIST);
    return (save ? GetSaveFileNameW(&ask) : GetOpenFileNameW(&ask)) ? path : L"";
}

int scaled(int pixels)
{
    HDC screen = GetDC(NULL);
    int dots = GetDeviceCaps(screen, LOGPIXELSY);
    ReleaseDC(NULL, screen);
    return MulDiv(pixels, dots, 96);
}

bool is_unattended = false, has_failed = false;

void say(HWND owner, const std::wstring &sentence, UINT icon)
{
    if (!is_unattended) {
        MessageBoxW(owner, sentence.c_str(), text("title").c_str(), MB_OK | icon);
        return;
    }
    std::string line = "SINS_Emulator: " + narrow(sentence) + "\n";
    DWORD written;
    WriteFile(GetStdHandle(STD_ERROR_HANDLE), line.data(), (DWORD)line.size(), &written, NULL);
    has_failed = true;
}
