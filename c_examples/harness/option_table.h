/* Every option: how it is read, where it goes, how it is told. */

#ifndef OPTION_TABLE_H
#define OPTION_TABLE_H

#include <stddef.h>

#include "settings.h"

enum option_kind {
    OPTION_FLAG,
    OPTION_TEXT,
    OPTION_CHOICE, /* one of the words of operand, whose constants count from 0 in that order */
    OPTION_COUNT,
    OPTION_SEED,
    OPTION_PRESET,
    OPTION_NUMBER,
    OPTION_AXES,   /* one number for all axes or three */
    OPTION_MATRIX, /* one number for all elements off the diagonal or six, row by row */
    OPTION_MARKOV, /* standard deviation and correlation time, for each of `count` axes */
    OPTION_VECTOR  /* three numbers */
};

enum option_group { GROUP_RUN, GROUP_MODEL, GROUP_GYRO, GROUP_ACCEL, GROUP_ALTIMETER, GROUP_START };

struct option {
    enum option_group group;
    enum option_kind kind;
    const char *name;
    const char *operand;
    const char *noun;
    const char *unit_text;
    size_t at;        /* in struct settings */
    size_t time_at;   /* OPTION_MARKOV: of the correlation time */
    size_t count;     /* OPTION_MARKOV: axes */
    double unit;      /* SI per unit */
    double low, high; /* in the option's unit */
};

extern const struct option option_table[];
extern const size_t option_table_length;

/* How many numbers an option has in settings, and which of the doubles there they are. */
size_t option_elements(const struct option *option, const size_t **which);

/* Reads the value of any option but a flag. 0, or -1 reported. */
int option_read(struct settings *set, const struct option *option, const char *value);

/* All options, on standard output. */
void options_print_help(void);

/* The word for what a choice is set to. */
void option_word(const struct settings *set, const char *name, char *word, size_t capacity);

/* The errors of a group that are set, as a sentence in the units of data sheets; "none" if all are 0. */
void options_describe(const struct settings *set, enum option_group group, char *text, size_t capacity);

#endif
