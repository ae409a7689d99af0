/* Scenes: their keys, and their values by paths, "gyro.bias_deg_h[1]", "manoeuvre[3].bank_deg". */
#pragma once
#include "library.h"
#include "text.h"

/* A key of the scene format, in the user's language. */
struct Key : sins_scene_key {
    std::string path() const { return std::string(section) + "." + name; }
    bool is_choice() const { return kind == SINS_SCENE_KEY_WORD || kind == SINS_SCENE_KEY_FLAG; }
    bool is_number() const { return kind == SINS_SCENE_KEY_NUMBERS || kind == SINS_SCENE_KEY_WHOLE; }
    std::vector<std::string> choices() const { return split(kind == SINS_SCENE_KEY_FLAG ? "false|true" : words, "|"); }
    std::wstring meaning() const { return label(path(), sins_scene_key::meaning); }
    std::wstring word_label(const std::string &word) const { return label(path() + "." + word, word); }

    /* Of one number. */
    std::string default_number() const { return elements > 1 ? "0" : default_value; }

    /* Whether an item with such words can have it: "kind=turn|s_turn sensor=gyro". */
    template <class Word> bool applies(Word word_of) const {
        std::vector<std::string> terms = split(condition, " ");
        return !*condition || std::all_of(terms.begin(), terms.end(), [&](const std::string &term) {
            size_t equals = term.find('=');
            std::string words = "|" + term.substr(equals + 1) + "|";
            return words.find("|" + word_of(term.substr(0, equals)) + "|") != words.npos;
        });
    }

    /* What it means, its unit and its range. */
    std::wstring tip() const {
        std::wstring tip = meaning() + (*unit ? L" [" + wide(unit) + L"]" : L"");
        if ((flags & SINS_SCENE_KEY_LIMITS) != 0) {
            bool or_zero = (flags & SINS_SCENE_KEY_ZERO_IS_OFF) != 0;
            tip += L"\n" + text(or_zero ? "range_or_0" : "range", {shown(minimum, 6), shown(maximum, 6)});
        }
        return tip;
    }
};

inline const std::vector<Key> &keys() {
    static const std::vector<Key> all = [] {
        std::vector<Key> keys;
        for (const sins_scene_key &key : sins::Scene::keys())
            keys.push_back({key});
        return keys;
    }();
    return all;
}

/* The key of a path, without and with places in lists; NULL: none. */
inline const Key *key_of(const std::string &path) {
    static const std::regex PLACE("\\[\\d+\\]");
    std::string plain = std::regex_replace(path, PLACE, "");
    auto own = std::find_if(keys().begin(), keys().end(), [&](const Key &key) { return key.path() == plain; });
    return own == keys().end() ? NULL : &*own;
}

/* A text as it stands in a scene, and back. */
inline std::string in_quotes(const std::string &text) {
    return "\"" + std::regex_replace(text, std::regex("[\"\\\\]"), "\\$&") + "\"";
}

inline std::string unquoted(const std::string &value) {
    bool is_quoted = value.size() > 1 && value[0] == '"';
    return is_quoted ? std::regex_replace(value.substr(1, value.size() - 2), std::regex("\\\\(.)"), "$1") : value;
}

/* A sentence of the library in the user's language: about what, its value and limits; else by the rules of
 * the language, each a kind of sentence behind "gyro.bias_deg_h[1] = -3: ". */
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

typedef std::vector<sins_fault> Faults;

inline std::wstring told(const Faults &faults) { return faults.empty() ? L"" : told(faults[0]); }

/* Whether a fault is about the value at a path, or about all values of its key. */
inline bool is_about(const sins_fault &fault, const std::string &path) {
    return path == fault.path || path.starts_with(std::string(fault.path) + "[");
}

/* A value, without the quotes of words and texts; "": the default. */
struct Change {
    std::string path, value;
};

class Scene {
public:
    /* The built-in scene of a name; "": the default scene. */
    explicit Scene(const std::string &builtin = "")
        : scene_(builtin.empty() ? sins::Scene() : sins::Scene::builtin(builtin)), text_(scene_.write()) {}
    Scene(const Scene &other) : scene_(other.text_), text_(other.text_) {}
    Scene(Scene &&) = default;
    Scene &operator=(Scene &&) = default;

    const sins::Scene *operator->() const { return &scene_; }
    const std::string &text() const { return text_; }

    /* Makes this scene what the text says. With faults it stays what it was. */
    Faults read(const std::string &text) {
        sins::Scene read(text);
        Faults faults = read.faults();
        if (faults.empty()) {
            scene_ = std::move(read);
            text_ = scene_.write();
        }
        return faults;
    }

    /* "": there is none. */
    std::string get(const std::string &path) const {
        try {
            return scene_.value(path);
        } catch (const sins::Error &) {
            return "";
        }
    }

    /* All at once; with faults the scene stays what it was. */
    Faults set(const std::vector<Change> &changes) {
        std::string lines;
        for (const Change &change : changes)
            lines += change.path + " = " + change.value + "\n";
        return after(scene_.set_values(lines));
    }

    /* All changes that the library takes; the faults are of the others. */
    Faults set_valid(std::vector<Change> changes) {
        Faults faults = set(changes);
        size_t erased = std::erase_if(changes, [&](const Change &change) {
            return std::any_of(faults.begin(), faults.end(),
                               [&](const sins_fault &fault) { return is_about(fault, change.path); });
        });
        if (erased > 0 && !changes.empty())
            set_valid(changes);
        return faults;
    }

    /* The items of a list, "manoeuvre" or "failure", as they stand in the text. */
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
        return after(scene_.set_items(list, all));
    }

    void set_manoeuvres(const sins_flight_start &start, const std::vector<sins_manoeuvre> &all, size_t repeat) {
        scene_.set_manoeuvres(start, all, repeat);
        after(true);
    }

    static std::string place(const std::string &list, size_t index) { return list + "[" + std::to_string(index) + "]"; }

private:
    /* The faults of a change that was rejected. */
    Faults after(bool done) {
        text_ = done ? scene_.write() : text_;
        return done ? Faults() : scene_.faults();
    }

    sins::Scene scene_;
    std::string text_;
};
