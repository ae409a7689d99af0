#include "scene_plan.h"

#include <string.h>

#include "complain.h"
#include "option_table.h"

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
