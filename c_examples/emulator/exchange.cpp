#include "exchange.h"

/* A digit string is a whole number of up to 64 bits, and must not go through a double. */
static bool is_whole(const std::string &text)
{
    return text.find_first_not_of("0123456789") == std::string::npos && text.size() < 20 && (text.size() == 1 || text[0] != '0');
}

std::string toml(const std::wstring &typed)
{
    std::string text = narrow(typed);
    double number;
    size_t first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
    text = first == std::string::npos ? "" : text.substr(first, last - first + 1);
    return text.empty() ? "" : is_whole(text) ? text : number_of(text, number) ? shortest(number) : quoted(text);
}

void ExchangeDialog::exchange(const std::vector<Field> &fields)
{
    fields_ = fields;
    for (const Field &field : fields) {
        const Key *key = key_of(field.path);
        if (!key->words.empty() && key->words[0] != "false") {
            std::vector<std::wstring> words;
            for (const std::string &word : key->words) {
                words.push_back(label(key->path() + "." + word, word));
            }
            fill(field.id, words);
        }
        if (key->count > 0) {
            cue(field.id, L"0");
        }
        tip(field.id, tip_of(*key));
    }
}

void ExchangeDialog::load(const std::function<std::string(const std::string &path)> &value, bool all_is_new)
{
    for (const Field &field : fields_) {
        const Key &key = *key_of(field.path);
        std::string own = value(field.path);
        double number;
        if (is_marked(field.id) && !all_is_new) {
            continue;
        }
        mark(field.id, L"");
        if (!key.words.empty()) {
            size_t index = 0;
            while (index < key.words.size() && key.words[index] != unquoted(own)) {
                index++;
            }
            index = index == key.words.size() ? 0 : index;
            choose(field.id, (int)index);
            CheckDlgButton(window_, field.id, index == 1 ? BST_CHECKED : BST_UNCHECKED);
        } else if (key.count > 0) {
            own = numbers(own, key)[(size_t)field.element];
            if (field.path == si_path_ && number_of(own, number)) {
                own = shortest(number / key.units_per_si());
            }
            set(field.id, is_whole(own) ? wide(own) : number_of(own, number) ? shown(number, 15) : wide(unquoted(own)));
        } else {
            set(field.id, wide(unquoted(own)));
        }
        loaded_[field.id] = own;
        shown_[field.id] = text_of(field);
    }
}

/* What a control shows now. */
std::wstring ExchangeDialog::text_of(const Field &field) const
{
    const Key &key = *key_of(field.path);
    if (key.words.empty()) {
        return get(field.id);
    }
    return wide(key.words[(size_t)(key.words[0] == "false" ? checked(field.id) : max(0, chosen(field.id)))]);
}

/* The value of a control: as it was loaded, unless it was changed. */
std::string ExchangeDialog::value_of(const Field &field) const
{
    const Key &key = *key_of(field.path);
    std::wstring now = text_of(field);
    if (now == shown_.at(field.id)) {
        return loaded_.at(field.id);
    }
    if (!key.words.empty()) {
        return key.words[0] == "false" ? narrow(now) : quoted(narrow(now));
    }
    return key.is_text ? (now.empty() ? "" : quoted(narrow(now))) : toml(now);
}

std::vector<Change> ExchangeDialog::changes() const
{
    std::vector<Change> changes;
    std::set<std::string> done;
    for (const Field &field : fields_) {
        const Key &key = *key_of(field.path);
        if (text_of(field) == shown_.at(field.id) || !done.insert(field.path).second) {
            continue;
        }
        std::string value = value_of(field);
        if (key.count > 1) {
            bool is_off = true;
            value = "[";
            for (const Field &other : fields_) {
                if (other.path == field.path) {
                    std::string element = value_of(other);
                    is_off = is_off && element.empty();
                    value += (value.size() > 1 ? ", " : "") + (element.empty() ? "0" : element);
                }
            }
            value = is_off ? "" : value + "]";
        }
        changes.push_back({field.path, value, field.path == si_path_});
    }
    return changes;
}

std::wstring ExchangeDialog::mark_faults(const std::vector<Fault> &faults)
{
    for (const Field &field : fields_) {
        const Key *key = key_of(field.path);
        std::wstring sentence;
        for (const Fault &fault : faults) {
            size_t bracket = fault.sentence.find(key->name + "[");
            bool is_other = bracket != std::string::npos && atoi(fault.sentence.c_str() + bracket + key->name.size() + 1) != field.element;
            double number;
            bool is_sound = key->count > 1 && bracket == std::string::npos && (get(field.id).empty() || number_of(narrow(get(field.id)), number))
                            && text_of(field) == shown_.at(field.id);
            if (key_of(fault.path) == key && !is_other && !is_sound) {
                sentence = wide(fault.sentence);
            }
        }
        mark(field.id, sentence);
        tip(field.id, sentence.empty() ? tip_of(*key) : sentence);
    }
    return faults.empty() ? L"" : wide(faults[0].sentence);
}

bool ExchangeDialog::is_change(int id, int code) const
{
    for (const Field &field : fields_) {
        if (field.id == id) {
            const Key &key = *key_of(field.path);
            return code == (key.words.empty() ? (int)EN_KILLFOCUS : key.words[0] == "false" ? (int)BN_CLICKED : (int)CBN_SELCHANGE);
        }
    }
    return false;
}
