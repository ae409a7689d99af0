/* The document: a scene as sections of keys, each text checked, read and written by the library. */
#pragma once
#include <utility>

#include "library.h"
#include "text.h"

/* A key of a scene, as sins_scene_write_keys() tells it. */
struct Key {
    std::string section, name, doc, takes, unit, si_name;
    std::vector<std::string> words; /* of a choice; the first is the default */
    int count;                      /* numbers: 1, 3 or 9; 0: no number */
    bool is_text;
    std::string path() const { return section + "." + name; }
    std::string si_unit() const;
    double units_per_si() const;
    /* Whether a single number sets this element. */
    bool single_sets(int element) const;
};
const std::vector<Key> &keys();
const Key *key_of(const std::string &path);
/* What a key means, with unit and range: for its tool tip. */
std::wstring tip_of(const Key &key);

/* A section of a scene, or one item of a list as [[manoeuvre]]: keys and values as they stand in the text. */
struct Item {
    std::string section;
    std::vector<std::pair<std::string, std::string>> entries;
    /* The value of a key in its unit, under whichever name it stands; "": the default. */
    std::string get(const Key &key) const;
    /* Sets it; "" takes it out. in_si: under its SI name. */
    void set(const Key &key, const std::string &value, bool in_si = false);
};
typedef std::vector<Item> Items;

struct Fault {
    size_t item; /* of the items that were read; (size_t)-1: of none */
    std::string path;
    std::string sentence;
};

struct Change {
    std::string path, value;
    bool in_si;
};

class Scene {
public:
    /* The built-in scene of a name; "": the default scene. */
    explicit Scene(const std::string &builtin = "");
    /* Makes this scene what the text says. With faults it stays what it was. */
    bool read(const std::string &text, std::vector<Fault> &faults);
    bool read(const Items &items, std::vector<Fault> &faults);
    /* Makes all changes that the library takes; the faults are of the others. */
    std::vector<Fault> change(std::vector<Change> changes);
    /* Changes by a function of the library on the handle; false: it was refused, see last_error(). */
    bool take(sins_status status);

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
/* The numbers of a value; with a key the single number is spread over its elements. */
std::vector<std::string> numbers(const std::string &value, const Key &key);
