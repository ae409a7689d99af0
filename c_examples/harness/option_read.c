#include "option_table.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "report.h"

static void *place(struct settings *set, size_t at)
{
    return (char *)set + at;
}

static int expected(const struct option *option, const char *value, const char *what)
{
    report("%s %s: expected %s", option->name, value, what);
    return -1;
}

static int read_choice(struct settings *set, const struct option *option, const char *value)
{
    const char *words = option->operand;
    int32_t index;

    for (index = 0; *words != '\0'; index++) {
        size_t length = strcspn(words, "|");

        if (strlen(value) == length && strncmp(value, words, length) == 0) {
            *(int32_t *)place(set, option->at) = index;
            return 0;
        }
        words += length + (words[length] == '|');
    }
    return expected(option, value, option->operand);
}

static int read_count(struct settings *set, const struct option *option, const char *value)
{
    double number;
    char what[64];

    if (number_read(value, &number) && number == floor(number) && number >= option->low && number <= option->high) {
        *(int32_t *)place(set, option->at) = (int32_t)number;
        return 0;
    }
    snprintf(what, sizeof what, "a whole number from %g to %g", option->low, option->high);
    return expected(option, value, what);
}

static int read_seed(struct settings *set, const struct option *option, const char *value)
{
    unsigned long long number;

    errno = 0;
    number = strtoull(value, NULL, 10);
    if (*value == '\0' || value[strspn(value, "0123456789")] != '\0' || errno != 0) {
        return expected(option, value, "a whole number from 0 to 18446744073709551615");
    }
    *(uint64_t *)place(set, option->at) = number;
    return 0;
}

static int read_preset(struct settings *set, const struct option *option, const char *value)
{
    if (strcmp(value, option->operand) != 0) {
        return expected(option, value, option->operand);
    }
    return settings_preset(set);
}

static int read_markov(struct settings *set, const struct option *option, const char *value)
{
    double *sigma = (double *)place(set, option->at);
    double *time_s = (double *)place(set, option->time_at);
    double numbers[2];
    size_t axis;
    char what[128];

    if (numbers_read(value, numbers, 2) != 2 || !(numbers[0] >= 0 && numbers[0] <= option->high)
        || !(numbers[1] >= 1e-9 && numbers[1] <= 1e15)) {
        snprintf(what, sizeof what, "%s, from 0 to %g [%s] and from 1e-9 to 1e15 [s]", option->operand, option->high,
                 option->unit_text);
        return expected(option, value, what);
    }
    for (axis = 0; axis < option->count; axis++) {
        sigma[axis] = numbers[0] * option->unit;
        time_s[axis] = numbers[1];
    }
    return 0;
}

static const char *shape_of(enum option_kind kind)
{
    switch (kind) {
    case OPTION_NUMBER:
        return "a number";
    case OPTION_AXES:
        return "one number, or three with commas";
    case OPTION_MATRIX:
        return "one number, or six with commas";
    default:
        return "three numbers with commas";
    }
}

static int read_numbers(struct settings *set, const struct option *option, const char *value)
{
    double *target = (double *)place(set, option->at);
    double numbers[6];
    const size_t *which;
    size_t full = option_elements(option, &which), count = numbers_read(value, numbers, full), i;
    int is_good = count == full || (count == 1 && option->kind != OPTION_VECTOR);

    for (i = 0; i < count; i++) {
        is_good = is_good && numbers[i] >= option->low && numbers[i] <= option->high;
    }
    if (!is_good) {
        char what[128];

        snprintf(what, sizeof what, "%s, from %g to %g [%s]", shape_of(option->kind), option->low, option->high,
                 option->unit_text);
        return expected(option, value, what);
    }
    for (i = 0; i < full; i++) {
        target[which[i]] = numbers[count == 1 ? 0 : i] * option->unit;
    }
    return 0;
}

int option_read(struct settings *set, const struct option *option, const char *value)
{
    switch (option->kind) {
    case OPTION_TEXT:
        *(const char **)place(set, option->at) = value;
        return *value == '\0' ? expected(option, "\"\"", option->operand) : 0;
    case OPTION_CHOICE:
        return read_choice(set, option, value);
    case OPTION_COUNT:
        return read_count(set, option, value);
    case OPTION_SEED:
        return read_seed(set, option, value);
    case OPTION_PRESET:
        return read_preset(set, option, value);
    case OPTION_MARKOV:
        return read_markov(set, option, value);
    default:
        return read_numbers(set, option, value);
    }
}
