#include "settings.h"

#include <stdio.h>
#include <string.h>

#include "complain.h"
#include "option_table.h"
#include "report.h"

int settings_begin(struct settings *set, const int32_t *grades)
{
    memset(set, 0, sizeof *set);
    strcpy(set->out, "sins_out");
    set->motion = MOTION_NONE;
    SINS_INIT(set->options);
    SINS_INIT(set->gyro);
    SINS_INIT(set->accel);
    SINS_INIT(set->altimeter);
    SINS_INIT(set->initial);
    SINS_INIT(set->mounting);
    SINS_INIT(set->gravity);
    SINS_INIT(set->failure);
    SINS_INIT(set->start);
    return (grades[0] != 0 && refused(NULL, sins_gyro_preset(grades[0], &set->gyro)))
                || (grades[1] != 0 && refused(NULL, sins_accel_preset(grades[1], &set->accel)))
             ? -1
             : 0;
}

/* The field of the first option of a section that was set; NULL: none. With a field's begin: of those alone. */
static const char *field_set(const struct settings *set, enum option_group group, const char *begin)
{
    size_t i;

    for (i = 0; i < option_table_length; i++) {
        if (set->line[i] != SET_NOWHERE && option_table[i].group == group
            && strncmp(option_table[i].field, begin, strlen(begin)) == 0) {
            return option_table[i].field;
        }
    }
    return NULL;
}

int settings_has(const struct settings *set, const char *field)
{
    size_t i;

    for (i = 0; i < option_table_length; i++) {
        if (set->line[i] != SET_NOWHERE && strcmp(option_table[i].field, field) == 0) {
            return 1;
        }
    }
    return 0;
}

/* The line of a planned failure of the altimeter; 0: none. */
static long altimeter_failure(const struct settings *set)
{
    size_t i;

    for (i = 0; i < set->failures.count; i++) {
        if (set->failures.failures[i].sensor == SINS_SENSOR_ALTIMETER) {
            return set->failures.failures[i].line;
        }
    }
    return 0;
}

static int check_together(const struct settings *set)
{
    const char *altimeter = field_set(set, GROUP_ALTIMETER, ""), *start = field_set(set, GROUP_FLIGHT, "start.");

    if (set->kind >= SCENE_FLIGHT && set->motion != MOTION_NONE) {
        complain(set, "motion", "only simulation1 and simulation2 have a choice of motions");
    } else if (set->kind == SCENE_FLIGHT && set->rate_hz != 0) {
        complain(set, "rate_hz", "a flight log has its own time stamps");
    } else if (set->kind != SCENE_FLIGHT && set->options.sample_period_s != 0) {
        complain(set, "options.sample_period_s", "only for a log; this flight is sampled at rate_hz");
    } else if (start != NULL && set->kind != SCENE_MANOEUVRES) {
        complain(set, start, "only for [[manoeuvre]]s; this flight has its own start");
    } else if (settings_has(set, "temperature_change_c_h") && !settings_has(set, "temperature_c")) {
        complain(set, "temperature_change_c_h", "only with temperature_c, from which it goes on");
    } else if (altimeter != NULL && set->options.vertical != SINS_VERTICAL_DAMPED) {
        complain(set, altimeter, "altimeter errors act with the vertical channel damped alone");
    } else if (altimeter_failure(set) != 0 && set->options.vertical != SINS_VERTICAL_DAMPED) {
        complain_at(set, altimeter_failure(set), "[[failure]]: the altimeter acts with the vertical channel damped alone");
    } else if (strpbrk(set->name, "/\\") != NULL) {
        complain(set, "name", "\"%s\" has a folder; expected a name without, the folder by itself", set->name);
    } else {
        return 0;
    }
    return -1;
}

static const char *without_folders(const char *path)
{
    const char *separator;

    while ((separator = strpbrk(path, "/\\")) != NULL) {
        path = separator + 1;
    }
    return path;
}

/* The names of the motion and of the output files. */
static void set_names(struct settings *set)
{
    static const char *const scenes[] = { "simulation1", "simulation2", "flight", "embedded", "manoeuvres" };
    const char *source = set->scene_file[0] != '\0' ? set->scene_file : set->log;
    const char *motion = set->motion == MOTION_REST ? "rest" : "patrol";
    char *ending;

    set->scene = scenes[set->kind];
    set->motion_name = set->kind == SCENE_FLIGHT     ? without_folders(set->log)
                     : set->kind == SCENE_EMBEDDED   ? set->builtin
                     : set->kind == SCENE_MANOEUVRES ? without_folders(set->scene_file)
                                                     : motion;
    if (set->name[0] != '\0') {
        return;
    }
    if (set->kind < SCENE_FLIGHT) {
        snprintf(set->name, sizeof set->name, "%s_%s", set->scene, motion);
        return;
    }
    snprintf(set->name, sizeof set->name, "%s", source[0] != '\0' ? without_folders(source) : set->builtin);
    ending = strrchr(set->name, '.');
    if (ending != NULL && ending != set->name) {
        *ending = '\0';
    }
}

int settings_complete(struct settings *set)
{
    if (check_together(set) != 0) {
        return -1;
    }
    if (set->kind < SCENE_FLIGHT) {
        set->motion = set->motion == MOTION_NONE ? MOTION_PATROL : set->motion;
        set->hours = set->hours == 0 ? 48 : set->hours;
    }
    if (set->kind != SCENE_FLIGHT) {
        set->rate_hz = set->rate_hz == 0 ? 100 : set->rate_hz;
        set->options.sample_period_s = 1 / set->rate_hz;
    }
    set_names(set);
    return 0;
}

int settings_has_ideal_sensors(const struct settings *set)
{
    sins_gyro_params gyro;
    sins_accel_params accel;

    SINS_INIT(gyro);
    SINS_INIT(accel);
    return memcmp(&gyro, &set->gyro, sizeof gyro) == 0 && memcmp(&accel, &set->accel, sizeof accel) == 0;
}

int settings_create(const struct settings *set, sins_sim **sim)
{
    if (refused_setting(set, NULL, sins_create(&set->options, sim))) {
        return BAD_INPUT;
    }
    if (refused_setting(set, *sim, sins_set_gyro(*sim, &set->gyro))
        || refused_setting(set, *sim, sins_set_accel(*sim, &set->accel))
        || refused_setting(set, *sim, sins_set_altimeter(*sim, &set->altimeter))
        || refused_setting(set, *sim, sins_set_initial_errors(*sim, &set->initial))
        || refused_setting(set, *sim, sins_set_mounting(*sim, &set->mounting))
        || refused_setting(set, *sim, sins_set_gravity_disturbance(*sim, &set->gravity))) {
        sins_destroy(*sim);
        *sim = NULL;
        return BAD_INPUT;
    }
    return DONE;
}
