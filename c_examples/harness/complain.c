#include "complain.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "report.h"

/* The option that was set there; else any that could have been. */
static const struct option *option_that_set(const struct settings *set, const char *field)
{
    const struct option *option = option_of_field(field);
    size_t i;

    for (i = 0; i < option_table_length; i++) {
        if (set->line[i] != SET_NOWHERE && strcmp(option_table[i].field, field) == 0) {
            return &option_table[i];
        }
    }
    return option;
}

static void begin_at(const struct settings *set, long line)
{
    if (line > 0) {
        fprintf(stderr, "%s:%ld: ", set->scene_file, line);
    } else if (set->scene_file[0] != '\0') {
        fprintf(stderr, "%s: ", set->scene_file);
    } else {
        fputs("sins_harness: ", stderr);
    }
}

/* Where an option was set; the header of its section, if it was not. */
static void begin(const struct settings *set, const struct option *option, long line)
{
    if (line == SET_BY_COMMAND || (line == SET_NOWHERE && set->scene_file[0] == '\0')) {
        fprintf(stderr, option->name != NULL ? "sins_harness: %s: " : "sins_harness: ", option->name);
        return;
    }
    begin_at(set, line != SET_NOWHERE ? line : set->section_line[option->group]);
    fprintf(stderr, "%s.%s: ", option_sections[option->group].name, option->key != NULL ? option->key : option->name);
}

void complain(const struct settings *set, const char *field, const char *format, ...)
{
    const struct option *option = option_that_set(set, field);
    va_list arguments;

    begin(set, option, set->line[option - option_table]);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
}

void complain_at(const struct settings *set, long line, const char *format, ...)
{
    va_list arguments;

    begin_at(set, line);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
}

/* About manoeuvre `index` of the scene file: at the key that sets the field, or at its header. */
static void begin_at_manoeuvre(const struct settings *set, const struct option *option, size_t index)
{
    const struct manoeuvre_lines *lines = &set->manoeuvre_lines[index];
    const struct option *first = option_of_field("manoeuvre.kind");
    long line = option != NULL && option->group == GROUP_MANOEUVRE ? lines->key[option - first] : (long)SET_NOWHERE;

    begin_at(set, line != SET_NOWHERE ? line : lines->header);
    fprintf(stderr, "manoeuvre%s%s: ", line != SET_NOWHERE ? "." : "", line != SET_NOWHERE ? option->key : "");
}

int refused_setting(const struct settings *set, const sins_sim *sim, sins_status status)
{
    char sentence[512], field[64];
    const struct option *option;
    const char *bracket;

    if (status >= 0) {
        return 0;
    }
    library_sentence(sim, sentence, sizeof sentence);
    snprintf(field, sizeof field, "%.*s", (int)strcspn(sentence, "[ :"), sentence);
    option = option_that_set(set, field);
    bracket = sentence[strlen(field)] == '[' ? sentence + strlen(field) + 1 : NULL;
    if (bracket != NULL && (option == NULL || option->group == GROUP_MANOEUVRE)
        && strtoul(bracket, NULL, 10) < set->plan.count && set->kind == SCENE_MANOEUVRES) {
        begin_at_manoeuvre(set, option, strtoul(bracket, NULL, 10));
    } else if (option != NULL) {
        begin(set, option, set->line[option - option_table]);
    } else {
        begin_at(set, 0);
    }
    fprintf(stderr, "%s\n", sentence);
    return 1;
}
