/* The document: a scene as sections of keys, each text checked, read and written by the library. */
#pragma once
#include "keys.h"

/* A section of a scene, or one item of a list as [[manoeuvre]]: keys and values as they stand in the text. */
struct Item {
    std::string section;
    std::vector<std::pair<std::string, std::string>> entries;
    std::vector<Item> items; /* a manoeuvre's sinusoids; those without entries do not count */
    /* The value of a key in its unit, under whichever name it stands; "": the default. */
    std::string get(const std::string &path) const;
    /* Sets it; "" takes it out. in_si: under its SI name. */
    void set(const std::string &path, const std::string &value, bool in_si = false);
    /* Words of the item, as "gyro x stuck", and its values: for a row of a list. */
    Texts described() const;
};
typedef std::vector<Item> Items;

struct Fault {
    size_t item, nested; /* the section or item, and its item from 1 on, or 0; of a text: the line, and 0 */
    std::string path, sentence;
};
typedef std::vector<Fault> Faults;
/* The first of them, in the user's language; "": none. */
std::wstring told(const Faults &faults);

struct Change {
    std::string path, value;
    size_t nested; /* as in a fault */
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
    /* After a call of the library that sets something: its error is thrown. */
    void taken(sins_status status);
    /* A text, of enum sins_scene_text. */
    void set_text(int which, const std::string &text)
    {
        taken(lib.sins_scene_set_text(handle_, which, text.c_str()));
    }
    std::string words(int which) const;

    const Items &items() const { return items_; }
    std::string get(const std::string &path) const;
    const std::string &text() const { return text_; }
    sins_scene *handle() const { return handle_; }
    sins_scene_setup setup() const;

private:
    Handle<sins_scene> handle_;
    std::string text_;
    Items items_;
};
