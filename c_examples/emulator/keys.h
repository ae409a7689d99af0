/* The keys of a scene, as the library gives them, and the values that stand under them in its text. */
#pragma once
#include "library.h"

struct Key {
    std::string section, name, path, doc, takes, unit, si_name;
    std::vector<std::string> words; /* of a choice; the first is the default */
    size_t count;                   /* numbers: 1, 3 or 9; 0: no number */
    bool is_switch() const { return !words.empty() && words[0] == "false"; }
    bool is_text() const { return words.empty() && count == 0; }
    std::wstring si_unit() const;
    double units_per_si() const;
    /* Whether a single number sets this element. */
    bool single_sets(size_t element) const;
    /* What a word, as it stands in the scene, is called; "" is the default. */
    std::wstring word_label(const std::string &word) const { return label(path + "." + word, word); }
    Texts word_labels() const;
    size_t index_of(const std::string &value) const; /* of a word; the default if it is none */
    /* What the key means, its unit and its range. */
    std::wstring tip() const;
};
const std::vector<Key> &keys();
/* By its path, in its own unit or in SI; NULL: none. */
const Key *key_of(const std::string &path);

/* A text as a value of TOML, and back. */
std::string in_quotes(const std::string &text);
std::string unquoted(const std::string &value);
/* What a user typed, as TOML: all but a number in quotes, so that the library says what it expected. */
std::string toml(const std::wstring &typed);
/* The numbers of a value, "" for 0; a single number is spread over the elements that it sets. */
std::vector<std::string> numbers(const std::string &value, const Key &key);
/* Numbers as a value: "[1, 0, 0]"; "" if all are "". */
std::string list_of(const std::vector<std::string> &numbers);
