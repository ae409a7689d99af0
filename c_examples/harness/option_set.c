#include "option_table.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

struct option_shape option_shape(const struct option *option)
{
    static const struct option_shape none = { 0, 0 }, number = { 1, 0x1 }, vector = { 3, 0x0 }, axes = { 3, 0x7 },
                                     cross = { 9, 0xEE }, diagonal = { 9, 0x111 }, matrix = { 9, 0x0 };

    switch (option->kind) {
    case OPTION_NUMBER:
        return number;
    case OPTION_VECTOR:
        return vector;
    case OPTION_AXES:
        return axes;
    case OPTION_CROSS:
        return cross;
    case OPTION_DIAGONAL:
        return diagonal;
    case OPTION_MATRIX:
        return matrix;
    default:
        return none;
    }
}

static void *place(struct settings *set, const struct option *option)
{
    return (char *)set + option->at;
}

static int is_one_number(const struct value *value)
{
    return value->type == VALUE_WHOLE || value->type == VALUE_NUMBER;
}

static int set_text(struct settings *set, const struct option *option, const struct value *value)
{
    if (value->type != VALUE_TEXT || value->text[0] == '\0') {
        return -1;
    }
    memcpy(place(set, option), value->text, sizeof value->text);
    return 0;
}

static int set_choice(struct settings *set, const struct option *option, const struct value *value)
{
    const char *words = option->operand;
    int32_t *target = (int32_t *)place(set, option);
    int32_t index;

    for (index = 0; value->type == VALUE_TEXT && *words != '\0'; index++) {
        size_t length = strcspn(words, "|");

        if (strlen(value->text) == length && strncmp(value->text, words, length) == 0) {
            target[0] = index;
            if (option->kind == OPTION_GRADES) {
                target[1] = index;
            }
            return 0;
        }
        words += length + (words[length] == '|');
    }
    return -1;
}

static int set_flag(struct settings *set, const struct option *option, const struct value *value)
{
    if (value->type != VALUE_TRUTH) {
        return -1;
    }
    *(int32_t *)place(set, option) = value->whole ? (int32_t)option->unit : 0;
    return 0;
}

static int set_count(struct settings *set, const struct option *option, const struct value *value)
{
    if (value->type != VALUE_WHOLE || value->whole > INT32_MAX) {
        return -1;
    }
    *(int32_t *)place(set, option) = (int32_t)value->whole;
    return 0;
}

static int set_seed(struct settings *set, const struct option *option, const struct value *value)
{
    if (value->type != VALUE_WHOLE) {
        return -1;
    }
    *(uint64_t *)place(set, option) = value->whole;
    return 0;
}

static int set_numbers(struct settings *set, const struct option *option, const struct value *value)
{
    struct option_shape shape = option_shape(option);
    double *target = (double *)place(set, option);
    int is_single = is_one_number(value) && shape.single != 0;
    size_t i;

    if (!is_single && (value->type != VALUE_ARRAY || value->count != shape.count)) {
        return -1;
    }
    for (i = 0; option->low < option->high && i < value->count; i++) {
        if (!(value->numbers[i] >= option->low && value->numbers[i] <= option->high)) {
            return -1;
        }
    }
    for (i = 0; i < shape.count; i++) {
        double number = !is_single ? value->numbers[i] : shape.single >> i & 1 ? value->numbers[0] : 0;

        target[i] = number * option->unit;
    }
    return 0;
}

static const char *numbers_expected(enum option_kind kind)
{
    switch (kind) {
    case OPTION_AXES:
        return "one number for all axes, or three";
    case OPTION_VECTOR:
        return "three numbers";
    case OPTION_CROSS:
        return "one number for all elements off the diagonal, or nine row by row";
    case OPTION_DIAGONAL:
        return "one number for all elements of the diagonal, or nine row by row";
    case OPTION_MATRIX:
        return "nine numbers row by row";
    default:
        return "a number";
    }
}

void option_expects(const struct option *option, char *text, size_t capacity)
{
    switch (option->kind) {
    case OPTION_FLAG:
        snprintf(text, capacity, "true or false");
        break;
    case OPTION_TEXT:
        snprintf(text, capacity, "%s, up to %d bytes", option->operand, VALUE_TEXT_SIZE - 1);
        break;
    case OPTION_CHOICE:
    case OPTION_GRADES:
        snprintf(text, capacity, "%s", option->operand);
        break;
    case OPTION_COUNT:
    case OPTION_SEED:
        snprintf(text, capacity, "a whole number");
        break;
    default:
        if (option->low < option->high) {
            snprintf(text, capacity, "%s, from %g to %g [%s]", numbers_expected(option->kind), option->low,
                     option->high, option->unit_text);
        } else {
            snprintf(text, capacity, "%s", numbers_expected(option->kind));
        }
    }
}

int option_set(struct settings *set, const struct option *option, const struct value *value, char *expected,
               size_t capacity)
{
    int failed;

    switch (option->kind) {
    case OPTION_FLAG:
        failed = set_flag(set, option, value);
        break;
    case OPTION_TEXT:
        failed = set_text(set, option, value);
        break;
    case OPTION_CHOICE:
    case OPTION_GRADES:
        failed = set_choice(set, option, value);
        break;
    case OPTION_COUNT:
        failed = set_count(set, option, value);
        break;
    case OPTION_SEED:
        failed = set_seed(set, option, value);
        break;
    default:
        failed = set_numbers(set, option, value);
    }
    if (failed) {
        option_expects(option, expected, capacity);
    }
    return failed;
}
