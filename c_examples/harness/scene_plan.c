#include "scene_plan.h"

#include <math.h>
#include <string.h>

#include "complain.h"
#include "option_table.h"
#include "report.h"

enum { SINUSOIDS = sizeof((sins_manoeuvre *)0)->amplitude / sizeof(double) };

static void forget_lines(struct settings *set, enum option_group group)
{
    size_t i;

    for (i = 0; i < option_table_length; i++) {
        if (option_table[i].group == group) {
            set->line[i] = SET_NOWHERE;
        }
    }
}

void manoeuvre_begin(struct settings *set)
{
    forget_lines(set, GROUP_MANOEUVRE);
    SINS_INIT(set->manoeuvre);
}

int manoeuvre_take(struct settings *set)
{
    long header = set->section_line[GROUP_MANOEUVRE];
    const struct option *first = option_of_field("manoeuvre.kind");
    struct manoeuvre_lines *lines;
    int i;

    if (!settings_has(set, "manoeuvre.kind")) {
        complain_at(set, header, "[[manoeuvre]]: expected its kind");
        return -1;
    }
    if (set->plan.count == FLIGHT_PLAN_MANOEUVRES) {
        complain_at(set, header, "[[manoeuvre]]: more than %d", FLIGHT_PLAN_MANOEUVRES);
        return -1;
    }
    lines = &set->manoeuvre_lines[set->plan.count];
    lines->header = header;
    for (i = 0; i < MANOEUVRE_KEYS; i++) {
        lines->key[i] = first[i].group == GROUP_MANOEUVRE ? set->line[first - option_table + i] : (long)SET_NOWHERE;
    }
    set->plan.manoeuvres[set->plan.count++] = set->manoeuvre;
    return 0;
}

void sinusoid_begin(struct settings *set)
{
    forget_lines(set, GROUP_SINUSOID);
    memset(&set->sinusoid, 0, sizeof set->sinusoid);
}

int sinusoid_take(struct settings *set)
{
    const struct sinusoid *sinusoid = &set->sinusoid;
    long header = set->section_line[GROUP_SINUSOID];
    int is_speed = sinusoid->channel == SINS_CHANNEL_SPEED;
    int32_t i = set->manoeuvre.sinusoid_count;

    if (!settings_has(set, "sinusoid.channel")) {
        complain_at(set, header, "[[manoeuvre.sinusoid]]: expected its channel");
        return -1;
    }
    if (settings_has(set, is_speed ? "sinusoid.amplitude_rad" : "sinusoid.amplitude_m_s")) {
        complain(set, is_speed ? "sinusoid.amplitude_rad" : "sinusoid.amplitude_m_s",
                 "not of this channel; expected %s", is_speed ? "amplitude_m_s" : "amplitude_deg");
        return -1;
    }
    if (i == SINUSOIDS) {
        complain_at(set, header, "[[manoeuvre.sinusoid]]: more than %d in a manoeuvre", SINUSOIDS);
        return -1;
    }
    set->manoeuvre.channel[i] = sinusoid->channel;
    set->manoeuvre.amplitude[i] = is_speed ? sinusoid->amplitude_m_s : sinusoid->amplitude_rad;
    set->manoeuvre.frequency_hz[i] = sinusoid->frequency_hz;
    set->manoeuvre.phase_rad[i] = sinusoid->phase_rad;
    set->manoeuvre.sinusoid_count = i + 1;
    return 0;
}

void failure_begin(struct settings *set)
{
    forget_lines(set, GROUP_FAILURE);
    SINS_INIT(set->failure);
    memset(&set->failing, 0, sizeof set->failing);
}

/* Of the keys of a field that has one for each sensor, only its own may be set. 0, or -1 reported. */
static int check_unit(const struct settings *set, const char *field)
{
    const struct option *first = option_of_field(field);
    const struct option *own = first + set->failing.sensor, *option;

    for (option = first; option <= first + SINS_SENSOR_ALTIMETER; option++) {
        if (option != own && set->line[option - option_table] != SET_NOWHERE) {
            complain_at(set, set->line[option - option_table], "failure.%s: not of this sensor; expected %s",
                        option->key, own->key);
            return -1;
        }
    }
    return 0;
}

/* Whether the library takes it, in its own sentence. 0, or -1 reported. */
static int check_failure(const struct settings *set)
{
    sins_sim *sim = NULL;
    int failed;

    if (refused(NULL, sins_create(NULL, &sim))) {
        return -1;
    }
    failed = refused_setting(set, sim,
                             sins_set_failure(sim, set->failing.sensor, set->failing.axis, &set->failure));
    sins_destroy(sim);
    return failed ? -1 : 0;
}

static int check_output(const struct settings *set, long header)
{
    int is_altimeter = set->failing.sensor == SINS_SENSOR_ALTIMETER;

    if (!settings_has(set, "failing.sensor") || !settings_has(set, "failure.kind")) {
        complain_at(set, header, "[[failure]]: expected its %s",
                    settings_has(set, "failing.sensor") ? "kind" : "sensor");
    } else if (is_altimeter && settings_has(set, "failing.axis")) {
        complain(set, "failing.axis", "the altimeter has one output alone");
    } else if (!is_altimeter && !settings_has(set, "failing.axis")) {
        complain_at(set, header, "[[failure]]: expected its axis");
    } else if (set->failing.until_s <= set->failing.from_s) {
        complain(set, "failing.until_s", "%g: expected more than from_s, %g", set->failing.until_s,
                 set->failing.from_s);
    } else {
        return check_unit(set, "failure.size") != 0 || check_unit(set, "failure.density") != 0 ? -1
                                                                                           : check_failure(set);
    }
    return -1;
}

int failure_take(struct settings *set)
{
    long header = set->section_line[GROUP_FAILURE];
    const struct planned_failure *other;

    if (!settings_has(set, "failing.until_s")) {
        set->failing.until_s = HUGE_VAL;
    }
    if (check_output(set, header) != 0) {
        return -1;
    }
    if (set->failure.kind == SINS_FAILURE_NONE) {
        return 0;
    }
    other = failure_plan_overlap(&set->failures, &set->failing);
    if (other != NULL) {
        complain_at(set, header, "[[failure]]: overlaps in time with that of line %ld, of the same output", other->line);
        return -1;
    }
    if (set->failures.count == FAILURE_PLAN_FAILURES) {
        complain_at(set, header, "[[failure]]: more than %d", FAILURE_PLAN_FAILURES);
        return -1;
    }
    set->failing.line = header;
    set->failing.failure = set->failure;
    set->failures.failures[set->failures.count++] = set->failing;
    return 0;
}
