#include "command_line.h"

#include <stdio.h>
#include <string.h>

#include "option_table.h"
#include "report.h"
#include "scene_file.h"

static int read_option(struct settings *set, const struct option *option, const char *argument)
{
    struct value value;
    char expected[160];

    if (option->kind == OPTION_FLAG) {
        value.type = VALUE_TRUTH;
        value.whole = 1;
    } else {
        value_of_argument(&value, argument);
    }
    if (option->kind == OPTION_TEXT) {
        value.type = VALUE_TEXT; /* a number is a name, too */
    }
    set->line[option - option_table] = SET_BY_COMMAND;
    if (option_set(set, option, &value, expected, sizeof expected) == 0) {
        return 0;
    }
    report("%s %s: expected %s", option->name, argument[0] == '\0' ? "\"\"" : argument, expected);
    return -1;
}

static int read_options(struct settings *set, int count, char **arguments)
{
    int i;

    for (i = 0; i < count; i++) {
        const struct option *option = option_table;

        while (option < option_table + option_table_length
               && (option->name == NULL || strcmp(option->name, arguments[i]) != 0)) {
            option++;
        }
        if (option == option_table + option_table_length) {
            report("%s: no such option; --help lists them", arguments[i]);
            return -1;
        }
        if (option->kind != OPTION_FLAG && ++i == count) {
            report("%s: expected a value after it", option->name);
            return -1;
        }
        if (read_option(set, option, arguments[i]) != 0) {
            return -1;
        }
    }
    return 0;
}

static int is_scene_file(const char *argument)
{
    size_t length = strlen(argument);

    return length > 5 && strcmp(argument + length - 5, ".toml") == 0;
}

/* What a scene of the command line flies: a log or a built-in flight. */
static int read_operand(struct settings *set, int count, char **arguments)
{
    char *target = set->kind == SCENE_FLIGHT ? set->log : set->builtin;

    if (count < 2 || arguments[1][0] == '\0' || strncmp(arguments[1], "--", 2) == 0
        || strlen(arguments[1]) >= VALUE_TEXT_SIZE) {
        report("%s: expected %s after it, up to %d bytes", arguments[0],
               set->kind == SCENE_FLIGHT ? "FILE.csv" : "NAME, or list,", VALUE_TEXT_SIZE - 1);
        return 0;
    }
    memcpy(target, arguments[1], strlen(arguments[1]) + 1);
    return 2;
}

/* The scene and its operand; gives how many arguments they took, 0 reported. */
static int read_scene(struct settings *set, int count, char **arguments, const struct scene_text *text)
{
    static const char *const names[] = { "simulation1", "simulation2", "flight", "embedded" };
    static const char *const known = "simulation1, simulation2, flight FILE.csv, embedded NAME or SCENE.toml";
    int kind;

    if (count == 0) {
        report("which scene? %s; --help tells more", known);
        return 0;
    }
    if (is_scene_file(arguments[0])) {
        if (strlen(arguments[0]) >= sizeof set->scene_file) {
            report("%s: the path is longer than %d bytes", arguments[0], (int)sizeof set->scene_file - 1);
            return 0;
        }
        memcpy(set->scene_file, arguments[0], strlen(arguments[0]) + 1);
        return scene_file_apply(set, text->bytes, text->length) == 0;
    }
    for (kind = 0; kind < 4 && strcmp(arguments[0], names[kind]) != 0; kind++) {
    }
    if (kind == 4) {
        report("%s: no such scene; expected %s", arguments[0], known);
        return 0;
    }
    set->kind = (enum scene_kind)kind;
    if (set->kind == SCENE_SIMULATION2) {
        set->grades[0] = set->grades[1] = SINS_GRADE_PAPER_SIMULATION2;
    }
    return set->kind < SCENE_FLIGHT ? 1 : read_operand(set, count, arguments);
}

/* The scene, then the options that override it, on sensors of these grades. */
static int read_once(struct settings *set, const int32_t *grades, int count, char **arguments,
                     const struct scene_text *text)
{
    int taken = settings_begin(set, grades) == 0 ? read_scene(set, count, arguments, text) : 0;

    return taken == 0 ? -1 : read_options(set, count - taken, arguments + taken);
}

int command_line_read(struct settings *set, int count, char **arguments)
{
    static struct scene_text text;
    int32_t grades[2] = { 0, 0 };
    int is_page = count > 0 && (strcmp(arguments[0], "--help") == 0 || strcmp(arguments[0], "--keys") == 0);

    if (is_page) {
        return settings_begin(set, grades) == 0 ? read_options(set, count, arguments) : -1;
    }
    if (count > 0 && is_scene_file(arguments[0]) && scene_file_load(&text, arguments[0]) != 0) {
        return -1;
    }
    if (read_once(set, grades, count, arguments, &text) != 0) {
        return -1;
    }
    if (set->grades[0] != 0 || set->grades[1] != 0) {
        /* Presets come first, wherever they stand: which they are is known now. */
        memcpy(grades, set->grades, sizeof grades);
        if (read_once(set, grades, count, arguments, &text) != 0) {
            return -1;
        }
    }
    return settings_complete(set);
}
