/* The document: a scene as sections of keys, each text checked, read and written by the library. */
#pragma once
#include <utility>

#include "library.h"
#include "text.h"

/* A key of a scene, as sins_scene_write_keys() gives it. */
struct Key {
    std::string section, name, doc, takes, unit, si_name;
    std::vector<std::string> words; /* of a choice; the first is the default */
    size_t count;                   /* numbers: 1, 3 or 9; 0: no number */
    bool is_text;
    std::string path() const { return section + "." + name; }
    bool is_switch() const { return !words.empty() && words[0] == "false"; }
    std::string si_unit() const;
    double units_per_si() const;
    /* Whether a single number sets this element. */
    bool single_sets(size_t element) const;
    /* What a word, as it stands in the scene, is called; "" is the default. */
    std::wstring word_label(const std::string &word) const { return label(path() + "." + word, word); }
    Texts word_labels() const;
    size_t index_of(const std::string &value) const; /* of a word; the default if it is none */
    /* What the key means, its unit and its range. */
    std::wstring tip() const;
};
const std::vector<Key> &keys();
/* By its path, in its own unit or in SI; NULL: none. */
const Key *key_of(const std::string &path);

/* A section of a scene, or one item of a list as [[manoeuvre]]: keys and values as they stand in the text. */
struct Item {
    std::string section;
    std::vector<std::pair<std::string, std::string>> entries;
    std::vector<Item> items; /* a manoeuvre's sinusoids */
    /* The value of a key in its unit, under whichever name it stands; "": the default. */
    std::string get(const Key &key) const;
    std::string get(const std::string &path) const { return get(*key_of(path)); }
    /* Sets it; "" takes it out. in_si: under its SI name. */
    void set(const std::string &path, const std::string &value, bool in_si = false);
    /* Words of the item, as "gyro x stuck", and its values: for a row of a list. */
    Texts described() const;
};
typedef std::vector<Item> Items;

struct Fault {
    size_t item; /* the section or item; of a text read as a whole: the line */
    std::string path, sentence;
};
typedef std::vector<Fault> Faults;
/* The first of them, in the user's language; "": none. */
std::wstring told(const Faults &faults);

struct Change {
    std::string path, value;
    bool in_si;
};

class Scene {
public:
    /* The built-in scene of a name; "": the default scene. */
    explicit Scene(const std::string &builtin = "");
    /* Makes this scene what the text says. With faults it stays what it was. */
    Faults read(const std::string &text);
    Faults read(const Items &items);
    /* Makes all changes that the library takes; the faults are of the others. */
    Faults change(std::vector<Change> changes);
    /* The items of a list, "manoeuvre" or "failure". */
    Items list(const std::string &section) const;
    Faults set_list(const std::string &section, const Items &items);
    /* Sets a text, of enum sins_scene_text. The sentence of the fault, or "". */
    std::wstring set_text(int which, const std::string &text);
    /* After a call of the library that sets something. The sentence of its fault, or "". */
    std::wstring taken(sins_status status);

    const Items &items() const { return items_; }
    std::string get(const std::string &path) const;
    const std::string &text() const { return text_; }
    sins_scene *handle() const { return handle_; }
    sins_scene_setup setup() const;
    std::string words(int which) const; /* of enum sins_scene_text */

private:
    void write_back();
    Handle<sins_scene> handle_;
    std::string text_;
    Items items_;
};

/* A text as a value of TOML, and back. */
std::string quoted(const std::string &text);
std::string unquoted(const std::string &value);
/* What a user typed, as TOML: all but a number in quotes, so that the library says what it expected. */
std::string toml(const std::wstring &typed);
/* The numbers of a value, "" for 0; a single number is spread over the elements that it sets. */
std::vector<std::string> numbers(const std::string &value, const Key &key);
/* Numbers as a value: "[1, 0, 0]"; "" if all are "". */
std::string list_of(const std::vector<std::string> &numbers);
