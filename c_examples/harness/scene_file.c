#include "scene_file.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "complain.h"
#include "nearest.h"
#include "option_table.h"
#include "report.h"
#include "scene_plan.h"

enum { MOST_FAULTS = 20 };

static const enum option_group NO_GROUP = OPTION_GROUPS;

struct reading {
    struct settings *set;
    struct toml_item item;
    enum option_group group; /* of the section that is being read; NO_GROUP: none that is known */
    int is_in_manoeuvre;
    int faults;
};

int scene_file_load(struct scene_text *text, const char *path)
{
    FILE *stream = fopen(path, "rb");
    int failed;

    if (stream == NULL) {
        report("%s: %s", path, strerror(errno));
        return -1;
    }
    errno = 0;
    text->length = fread(text->bytes, 1, sizeof text->bytes, stream);
    failed = ferror(stream);
    if (failed) {
        report("%s: %s", path, strerror(errno));
    }
    fclose(stream);
    return failed ? -1 : 0;
}

/* The key that a misspelt one may have been meant for: every section has one. */
static const struct option *nearest_key(enum option_group group, const char *name)
{
    const struct option *nearest = NULL;
    size_t i, best = 0;

    for (i = 0; i < option_table_length; i++) {
        const struct option *option = &option_table[i];

        if (option->group == group && option->key != NULL) {
            size_t distance = name_distance(name, option->key);

            if (nearest == NULL || distance < best) {
                nearest = option;
                best = distance;
            }
        }
    }
    return nearest;
}

static const struct option *find_key(enum option_group group, const char *name)
{
    size_t i;

    for (i = 0; i < option_table_length; i++) {
        const struct option *option = &option_table[i];

        if (option->group == group && option->key != NULL && strcmp(option->key, name) == 0) {
            return option;
        }
    }
    return NULL;
}

static void refuse_key(struct reading *reading)
{
    const struct toml_item *item = &reading->item;
    const char *section = option_sections[reading->group].name;
    int group;

    reading->faults++;
    for (group = 0; group < OPTION_GROUPS; group++) {
        if (find_key((enum option_group)group, item->name) != NULL) {
            complain_at(reading->set, item->line, "%s.%s: unknown key; did you mean %s.%s?", section, item->name,
                        option_sections[group].name, item->name);
            return;
        }
    }
    complain_at(reading->set, item->line, "%s.%s: unknown key; did you mean %s?", section, item->name,
                nearest_key(reading->group, item->name)->key);
}

static void take_key(struct reading *reading)
{
    const struct toml_item *item = &reading->item;
    const char *section = option_sections[reading->group].name;
    const struct option *option = find_key(reading->group, item->name);
    char found[80], expected[160];
    long *line;

    if (option == NULL) {
        refuse_key(reading);
        return;
    }
    line = &reading->set->line[option - option_table];
    if (*line != SET_NOWHERE) {
        reading->faults++;
        complain_at(reading->set, item->line, "%s.%s: stands already in line %ld", section, item->name, *line);
        return;
    }
    *line = item->line;
    if (option_set(reading->set, option, &item->value, expected, sizeof expected) != 0) {
        reading->faults++;
        value_print(&item->value, found, sizeof found);
        complain_at(reading->set, item->line, "%s.%s = %s: expected %s", section, item->name, found, expected);
    }
}

static void refuse_section(struct reading *reading)
{
    const char *name = reading->item.name;
    size_t best = name_distance(name, option_sections[0].name);
    int nearest = 0, group;

    for (group = 1; group < OPTION_GROUPS; group++) {
        size_t distance = name_distance(name, option_sections[group].name);

        if (distance < best) {
            best = distance;
            nearest = group;
        }
    }
    reading->faults++;
    complain_at(reading->set, reading->item.line, "[%s]: unknown section; did you mean %s%s%s?", name,
                option_sections[nearest].is_array ? "[[" : "[", option_sections[nearest].name,
                option_sections[nearest].is_array ? "]]" : "]");
}

/* Ends what was read before a section of this group. */
static void leave_section(struct reading *reading, enum option_group next)
{
    if (reading->group == GROUP_SINUSOID) {
        reading->faults += sinusoid_take(reading->set) != 0;
    }
    if (reading->group == GROUP_FAILURE) {
        reading->faults += failure_take(reading->set) != 0;
    }
    if (reading->is_in_manoeuvre && next != GROUP_SINUSOID) {
        reading->faults += manoeuvre_take(reading->set) != 0;
        reading->is_in_manoeuvre = 0;
    }
    reading->group = NO_GROUP;
}

/* Whether a known section may stand here; else -1, reported. */
static int check_section(const struct reading *reading, enum option_group group)
{
    const struct option_section *section = &option_sections[group];
    long before = reading->set->section_line[group], line = reading->item.line;

    if (section->is_array != (reading->item.kind == TOML_ARRAY_OF_TABLES)) {
        complain_at(reading->set, line, section->is_array ? "[%s]: expected [[%s]]" : "[[%s]]: expected [%s]",
                    section->name, section->name);
    } else if (!section->is_array && before != SET_NOWHERE) {
        complain_at(reading->set, line, "[%s]: stands already in line %ld", section->name, before);
    } else if (group == GROUP_SINUSOID && !reading->is_in_manoeuvre) {
        complain_at(reading->set, line, "[[%s]]: expected right behind its [[manoeuvre]]", section->name);
    } else {
        return 0;
    }
    return -1;
}

static void take_section(struct reading *reading)
{
    int group = 0;

    while (group < OPTION_GROUPS && strcmp(option_sections[group].name, reading->item.name) != 0) {
        group++;
    }
    leave_section(reading, (enum option_group)group);
    if (group == OPTION_GROUPS) {
        refuse_section(reading);
        return;
    }
    if (check_section(reading, (enum option_group)group) != 0) {
        reading->faults++;
        return;
    }
    reading->group = (enum option_group)group;
    reading->set->section_line[group] = reading->item.line;
    if (group == GROUP_MANOEUVRE) {
        reading->is_in_manoeuvre = 1;
        manoeuvre_begin(reading->set);
    } else if (group == GROUP_SINUSOID) {
        sinusoid_begin(reading->set);
    } else if (group == GROUP_FAILURE) {
        failure_begin(reading->set);
    }
}

static int is_separator(char letter)
{
    return letter == '/' || letter == '\\';
}

/* A log is named as seen from the folder of the scene file. */
static int place_log(struct settings *set)
{
    size_t folder = strlen(set->scene_file), length = strlen(set->log);

    while (folder > 0 && !is_separator(set->scene_file[folder - 1])) {
        folder--;
    }
    if (is_separator(set->log[0]) || (set->log[1] == ':' && is_separator(set->log[2]))) {
        return 0; /* from the root, or on a drive */
    }
    if (folder + length >= sizeof set->log) {
        complain(set, "log", "with its folder more than %d bytes", (int)sizeof set->log - 1);
        return -1;
    }
    memmove(set->log + folder, set->log, length + 1);
    memcpy(set->log, set->scene_file, folder);
    return 0;
}

/* What the flight is made of: one of three. */
static int take_flight(struct settings *set)
{
    int sources = (set->log[0] != '\0') + (set->builtin[0] != '\0') + (set->plan.count > 0);

    if (sources != 1) {
        complain_at(set, set->section_line[GROUP_FLIGHT], "[flight]: expected %s file, builtin or [[manoeuvre]]s",
                    sources == 0 ? "a flight:" : "one alone of");
        return -1;
    }
    set->kind = set->log[0] != '\0' ? SCENE_FLIGHT : set->builtin[0] != '\0' ? SCENE_EMBEDDED : SCENE_MANOEUVRES;
    return set->kind == SCENE_FLIGHT ? place_log(set) : 0;
}

int scene_file_apply(struct settings *set, const char *bytes, size_t length)
{
    struct toml_reader reader;
    struct reading reading;
    int found = 0, has_section = 0;

    memset(&reading, 0, sizeof reading);
    reading.set = set;
    reading.group = NO_GROUP;
    toml_begin(&reader, bytes, length);
    while (reading.faults < MOST_FAULTS && (found = toml_next(&reader, &reading.item)) == 1) {
        if (reading.item.kind != TOML_KEY) {
            has_section = 1;
            take_section(&reading);
        } else if (reading.group != NO_GROUP) {
            take_key(&reading);
        } else if (!has_section) {
            reading.faults++;
            complain_at(set, reading.item.line, "%s: expected a [section] before it", reading.item.name);
        }
    }
    if (found < 0) {
        complain_at(set, reader.line, "%s", reader.problem);
        return -1;
    }
    leave_section(&reading, NO_GROUP);
    return reading.faults > 0 ? -1 : take_flight(set);
}
