/* Scenes: their keys, and their values by paths such as "gyro.bias_deg_h[1]" and "manoeuvre[3].bank_deg". */
#pragma once
#include "library.h"
#include "text.h"

/* A key of the scene format, in the user's language. */
struct Key : sins_scene_key {
    std::string path(bool in_si = false) const { return std::string(section) + "." + (in_si ? si_name : name); }
    bool is_choice() const { return kind == SINS_SCENE_KEY_WORD || kind == SINS_SCENE_KEY_FLAG; }
    std::vector<std::string> choices() const {
        return split(std::string(kind == SINS_SCENE_KEY_FLAG ? "false|true" : words), '|');
    }
    std::wstring meaning() const { return label(path(), sins_scene_key::meaning); }
    std::wstring word_label(const std::string &word) const { return label(path() + "." + word, word); }

    /* Default value of one number. */
    std::string default_number() const { return elements > 1 ? "0" : default_value; }

    /* Whether an item with these words can have the key. A condition is "kind=turn|s_turn sensor=gyro". */
    bool applies(const std::function<std::string(const std::string &name)> &word_of) const {
        std::vector<std::string> terms = split(std::string(condition), ' ');
        return std::all_of(terms.begin(), terms.end(), [&](const std::string &term) {
            size_t equals = term.find('=');
            std::string words = "|" + term.substr(equals + 1) + "|";
            return words.find("|" + word_of(term.substr(0, equals)) + "|") != words.npos;
        });
    }

    /* Meaning, unit and range. */
    std::wstring tip() const {
        std::wstring tip = meaning() + (*unit ? L" [" + wide(unit) + L"]" : L"");
        bool or_zero = (flags & SINS_SCENE_KEY_ZERO_IS_OFF) != 0;
        if ((flags & SINS_SCENE_KEY_LIMITS) != 0)
            tip += L"\n" + text(or_zero ? "range_or_0" : "range", {shown(minimum, 6), shown(maximum, 6)});
        return tip;
    }
};

inline const std::vector<Key> &keys() {
    static const std::vector<sins_scene_key> found = sins::Scene::keys();
    static const std::vector<Key> all(found.begin(), found.end());
    return all;
}

/* The key of a path, which may have places in lists, or NULL. */
inline const Key *key_of(const std::string &path) {
    static const std::regex PLACE("\\[\\d+\\]");
    std::string plain = std::regex_replace(path, PLACE, "");
    auto own = std::find_if(keys().begin(), keys().end(), [&](const Key &key) { return key.path() == plain; });
    return own == keys().end() ? NULL : &*own;
}

inline std::string place(const std::string &list, size_t index) { return list + "[" + std::to_string(index) + "]"; }

/* The paths of the numbers of a value, or the path itself. */
inline std::vector<std::string> elements_of(const std::string &path) {
    const Key *key = key_of(path);
    std::vector<std::string> paths;
    for (int k = 0; key != NULL && k < max(1, key->elements); k++)
        paths.push_back(key->elements > 1 ? place(path, k) : path);
    return paths;
}

/* Puts a text into the quotes of a scene; unquoted() removes them. */
inline std::string in_quotes(const std::string &text) {
    return "\"" + std::regex_replace(text, std::regex("[\"\\\\]"), "\\$&") + "\"";
}

inline std::string unquoted(const std::string &value) {
    bool is_quoted = value.size() > 1 && value[0] == '"';
    return is_quoted ? std::regex_replace(value.substr(1, value.size() - 2), std::regex("\\\\(.)"), "$1") : value;
}

/* A sentence of the library in the user's language. With limits, it is made of the name, the value and the
 * limits. Otherwise a rule of the language translates it; each rule has one kind of sentence after
 * "gyro.bias_deg_h[1] = -3: ". */
template <class Info> std::wstring told(const std::string &sentence, const std::string &what, const Info &info) {
    const uint32_t LIMITS = SINS_ERROR_INFO_MINIMUM | SINS_ERROR_INFO_MAXIMUM;
    const std::wstring whole = wide(sentence), end = whole.substr(min(whole.find(L": ") + 2, whole.size()));
    const Key *key = key_of(what);
    std::wstring name = (key == NULL ? L"" : key->meaning() + L" ") + wide(what);
    if (language == 1 && (info.flags & LIMITS) == LIMITS) {
        const char *kind = (info.flags & SINS_ERROR_INFO_VALUE) != 0 ? "limits" : "expected";
        return text(kind, {name, shown(info.value, 6), shown(info.minimum, 6), shown(info.maximum, 6)});
    }
    const auto &texts = all_texts();
    for (auto rule = texts.lower_bound("rule "); rule != texts.end() && rule->first.starts_with("rule "); rule++) {
        const std::wregex kind(wide(rule->first.substr(5)));
        if (std::regex_match(end, kind))
            return name + L"\uff1a" + std::regex_replace(end, kind, rule->second);
    }
    return whole;
}

inline std::wstring told(const sins_fault &fault) { return told(fault.sentence, fault.path, fault); }

inline std::wstring told(const std::exception &error) {
    const sins::Error *own = dynamic_cast<const sins::Error *>(&error);
    return own == NULL ? wide(error.what()) : told(error.what(), own->info().field, own->info());
}

/* The same of a scene in flight, without the time and the line with which the sentence begins. */
inline std::wstring told_in_flight(const std::exception &error) {
    const sins::Error *own = dynamic_cast<const sins::Error *>(&error);
    const std::string sentence = std::regex_replace(std::string(error.what()), std::regex("^at .*? s(, line \\d+ of the log)?: "), "");
    return own == NULL ? wide(sentence) : told(sentence, own->info().field, own->info());
}

typedef std::vector<sins_fault> Faults;

inline std::wstring told(const Faults &faults) { return faults.empty() ? L"" : told(faults[0]); }

/* Whether a fault is about the value at a path, or about all values of its key. */
inline bool is_about(const sins_fault &fault, const std::string &path) {
    return path == fault.path || path.starts_with(std::string(fault.path) + "[");
}

/* Values by their paths, without the quotes of words and texts. "" stands for the default. */
typedef std::map<std::string, std::string> Changes;

/* A scene that can be copied and whose values the user changes. A change with faults does not change the scene. */
class Scene : public sins::Scene {
public:
    Scene(sins::Scene &&own = {}) : sins::Scene(std::move(own)) {}
    Scene(const Scene &other) : sins::Scene(other.write()) {}
    Scene(Scene &&) = default;
    Scene &operator=(Scene &&) = default;

    /* The value at a path, or "". */
    std::string get(const std::string &path) const {
        try {
            return value(path);
        } catch (const sins::Error &) {
            return "";
        }
    }

    /* Sets all values at once. */
    Faults set(const Changes &changes) {
        std::string lines;
        for (const auto &[path, value] : changes)
            lines += path + " = " + value + "\n";
        set_values(lines);
        return faults();
    }

    /* Sets all changes that the library accepts, and returns the faults of the others. */
    Faults set_valid(Changes changes) {
        Faults faults = set(changes);
        size_t before = changes.size();
        for (const sins_fault &fault : faults)
            std::erase_if(changes, [&](const auto &change) { return is_about(fault, change.first); });
        if (changes.size() < before && !changes.empty())
            set_valid(changes);
        return faults;
    }

    /* The items of a list, "manoeuvre", "failure" or "update", in the text format of a scene. */
    std::vector<std::string> items(const std::string &list) const {
        std::vector<std::string> items;
        for (std::string item; !(item = get(place(list, items.size()))).empty();)
            items.push_back(item);
        return items;
    }

    Faults set_items(const std::string &list, const std::vector<std::string> &items) {
        std::string all;
        for (const std::string &item : items)
            all += item + "\n";
        sins::Scene::set_items(list, all);
        return faults();
    }
};
