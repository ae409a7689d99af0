#include "option_table.h"

#include <stdio.h>
#include <string.h>

static void append(char *text, size_t capacity, const char *piece)
{
    size_t length = strlen(text);

    snprintf(text + length, capacity - length, "%s", piece);
}

static void append_number(char *text, size_t capacity, const char *before, double number)
{
    char piece[40];

    snprintf(piece, sizeof piece, "%s%.6g", before, number);
    append(text, capacity, piece);
}

static const void *place(const struct settings *set, const struct option *option)
{
    return (const char *)set + option->at;
}

static void describe(const struct settings *set, const struct option *option, char *text, size_t capacity)
{
    struct option_shape shape = option_shape(option);
    const double *values = (const double *)place(set, option);
    const double *single = NULL; /* what a single number would have set */
    size_t i;
    int is_set = 0, is_single = 1;

    for (i = 0; i < shape.count; i++) {
        is_set = is_set || values[i] != 0;
        single = single == NULL && shape.single >> i & 1 ? &values[i] : single;
    }
    if (!is_set) {
        return;
    }
    for (i = 0; i < shape.count; i++) {
        is_single = is_single && single != NULL && values[i] == (shape.single >> i & 1 ? *single : 0);
    }
    append(text, capacity, text[0] == '\0' ? "" : ", ");
    append(text, capacity, option->noun);
    if (is_single) {
        append_number(text, capacity, " ", *single / option->unit);
    } else {
        for (i = 0; i < shape.count; i++) {
            append_number(text, capacity, i == 0 ? " " : "/", values[i] / option->unit);
        }
    }
    append(text, capacity, " ");
    append(text, capacity, option->unit_text);
}

void option_word_of(const char *field, int32_t index, char *word, size_t capacity)
{
    const char *words = option_of_field(field)->operand;

    for (; index > 0; index--) {
        words = strchr(words, '|') + 1;
    }
    snprintf(word, capacity, "%.*s", (int)strcspn(words, "|"), words);
}

void option_word(const struct settings *set, const char *field, char *word, size_t capacity)
{
    option_word_of(field, *(const int32_t *)place(set, option_of_field(field)), word, capacity);
}

void options_describe(const struct settings *set, enum option_group group, char *text, size_t capacity)
{
    size_t i;

    text[0] = '\0';
    for (i = 0; i < option_table_length; i++) {
        if (option_table[i].group == group) {
            describe(set, &option_table[i], text, capacity);
        }
    }
    if (group == GROUP_START && set->initial.alignment == SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS) {
        append(text, capacity, text[0] == '\0' ? "levelling and gyrocompassing" : ", levelling and gyrocompassing");
    }
    if (text[0] == '\0') {
        append(text, capacity, "none");
    }
}

