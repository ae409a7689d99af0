/* Every option of the command line and every key of a scene file: how it is read, where it goes, how it is told. */

#ifndef OPTION_TABLE_H
#define OPTION_TABLE_H

#include <stddef.h>

#include "settings.h"

enum option_kind {
    OPTION_FLAG, /* on the command line without a value, in a file true or false */
    OPTION_TEXT,
    OPTION_CHOICE, /* one of the words of operand, whose constants count from 0 in that order */
    OPTION_GRADES, /* likewise, for two constants in turn */
    OPTION_COUNT,
    OPTION_SEED,
    OPTION_NUMBER,
    OPTION_VECTOR,   /* three numbers */
    OPTION_AXES,     /* one number for all axes or three */
    OPTION_CROSS,    /* one number for all elements off the diagonal, or nine, row by row */
    OPTION_DIAGONAL, /* one number for all elements on the diagonal, or nine */
    OPTION_MATRIX    /* nine numbers */
};

enum option_group {
    GROUP_FLIGHT,
    GROUP_MANOEUVRE,
    GROUP_SINUSOID,
    GROUP_MODEL,
    GROUP_GYRO,
    GROUP_ACCEL,
    GROUP_ALTIMETER,
    GROUP_START,
    GROUP_MOUNTING,
    GROUP_GRAVITY,
    GROUP_FAILURE,
    GROUP_OUTPUT,
    OPTION_GROUPS
};

/* A group is a section of a scene file. */
struct option_section {
    const char *name;
    int is_array; /* [[name]], any number of them */
    const char *heading;
};

struct option {
    enum option_group group;
    enum option_kind kind;
    const char *name;    /* on the command line; NULL: not there */
    const char *key;     /* in the section of a scene file; NULL: not there */
    const char *operand; /* of numbers NULL */
    const char *noun;
    const char *field;   /* in struct settings; what is the library's as its sentences spell it */
    size_t at;           /* likewise */
    double unit;         /* SI per unit; of a flag the constant that it sets */
    const char *unit_text;
    double low, high; /* in the option's unit; 0, 0: the library knows the limits */
};

/* How many doubles an option has, and which of them a single number sets: bit i for element i, 0: none. */
struct option_shape {
    size_t count;
    unsigned single;
};

extern const struct option_section option_sections[OPTION_GROUPS];
extern const struct option option_table[];
extern const size_t option_table_length;

/* The option whose field this is; NULL: none. */
const struct option *option_of_field(const char *field);

/* All zero for what is no double. */
struct option_shape option_shape(const struct option *option);

/* "one number for all axes, or three": what the option takes. */
void option_expects(const struct option *option, char *text, size_t capacity);

/* Sets an option of any kind to a value. 0, or -1 and what the option takes in `expected`. */
int option_set(struct settings *set, const struct option *option, const struct value *value, char *expected,
               size_t capacity);

/* The word for what the choice at a field is set to. */
void option_word(const struct settings *set, const char *field, char *word, size_t capacity);

/* Likewise for the constant `index`. */
void option_word_of(const char *field, int32_t index, char *word, size_t capacity);

/* The errors of a group that are set, as a sentence in the units of data sheets; "none" if all are 0. */
void options_describe(const struct settings *set, enum option_group group, char *text, size_t capacity);

/* The pages of --help and --keys, on standard output. */
void options_print_help(void);
void options_print_keys(void);

#endif
