#include "settings.h"

#include <stdio.h>
#include <string.h>

#include "option_table.h"
#include "report.h"

static int read_options(struct settings *set, int count, char **arguments)
{
    int i;

    for (i = 0; i < count; i++) {
        const struct option *option = option_table;

        while (option < option_table + option_table_length && strcmp(option->name, arguments[i]) != 0) {
            option++;
        }
        if (option == option_table + option_table_length) {
            report("%s: no such option; --help lists them", arguments[i]);
            return -1;
        }
        if (option->kind == OPTION_FLAG) {
            *(int32_t *)(void *)((char *)set + option->at) = 1;
        } else if (i + 1 == count) {
            report("%s: expected %s after it", option->name, option->operand);
            return -1;
        } else if (option_read(set, option, arguments[++i]) != 0) {
            return -1;
        }
    }
    return 0;
}

/* The scene and its operand; gives how many arguments they took, 0 reported. */
static int read_scene(struct settings *set, int count, char **arguments)
{
    static const char *const names[] = { "simulation1", "simulation2", "flight", "embedded" };
    int kind;

    if (count == 0) {
        report("which scene? simulation1, simulation2, flight FILE.csv or embedded NAME; --help tells more");
        return 0;
    }
    for (kind = 0; kind < 4 && strcmp(arguments[0], names[kind]) != 0; kind++) {
    }
    if (kind == 4) {
        report("%s: no such scene; expected simulation1, simulation2, flight FILE.csv or embedded NAME", arguments[0]);
        return 0;
    }
    set->kind = (enum scene_kind)kind;
    set->scene = names[kind];
    if (set->kind < SCENE_FLIGHT) {
        return 1;
    }
    if (count < 2 || arguments[1][0] == '\0' || strncmp(arguments[1], "--", 2) == 0) {
        report("%s: expected %s after it", names[kind], set->kind == SCENE_FLIGHT ? "FILE.csv" : "NAME, or list");
        return 0;
    }
    set->operand = arguments[1];
    return 2;
}

/* What single options cannot tell: whether they go together. */
static int check_together(const struct settings *set)
{
    const sins_altimeter_params *altimeter = &set->altimeter;
    int has_altimeter_errors = altimeter->bias_m != 0 || altimeter->noise_m != 0 || altimeter->markov_sigma_m != 0
                            || altimeter->scale_factor != 0 || altimeter->lag_s != 0;

    if (set->kind >= SCENE_FLIGHT && set->motion != MOTION_NONE) {
        report("--motion: only simulation1 and simulation2 have a choice of motions");
    } else if (set->kind == SCENE_FLIGHT && set->rate_hz != 0) {
        report("--rate %g: a flight log has its own time stamps", set->rate_hz);
    } else if (has_altimeter_errors && set->options.vertical != SINS_VERTICAL_DAMPED) {
        report("--baro-...: altimeter errors act with --vertical damped alone");
    } else if (set->name != NULL && strpbrk(set->name, "/\\") != NULL) {
        report("--name %s: expected a name without folders; --out names the folder", set->name);
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
    char *name = set->default_name;
    char *ending;

    if (set->kind < SCENE_FLIGHT) {
        set->motion_name = set->motion == MOTION_REST ? "rest" : "patrol";
        snprintf(name, sizeof set->default_name, "%s_%s", set->scene, set->motion_name);
    } else {
        set->motion_name = without_folders(set->operand);
        snprintf(name, sizeof set->default_name, "%s", set->motion_name);
        ending = strrchr(name, '.');
        if (ending != NULL && ending != name) {
            *ending = '\0';
        }
    }
    if (set->name == NULL) {
        set->name = name;
    }
}

int settings_preset(struct settings *set)
{
    return refused(NULL, sins_gyro_preset(SINS_GRADE_PAPER_SIMULATION2, &set->gyro))
                || refused(NULL, sins_accel_preset(SINS_GRADE_PAPER_SIMULATION2, &set->accel))
             ? -1
             : 0;
}

static void set_defaults(struct settings *set)
{
    memset(set, 0, sizeof *set);
    set->out = "sins_out";
    set->motion = MOTION_NONE;
    set->options.struct_size = sizeof set->options;
    set->gyro.struct_size = sizeof set->gyro;
    set->accel.struct_size = sizeof set->accel;
    set->altimeter.struct_size = sizeof set->altimeter;
    set->initial.struct_size = sizeof set->initial;
    set->options.vertical = SINS_VERTICAL_FOLLOW_TRUTH;
}

/* What the command line left open. */
static void complete(struct settings *set)
{
    if (set->kind < SCENE_FLIGHT) {
        set->motion = set->motion == MOTION_NONE ? MOTION_PATROL : set->motion;
        set->hours = set->hours == 0 ? 48 : set->hours;
    }
    if (set->kind != SCENE_FLIGHT) {
        set->rate_hz = set->rate_hz == 0 ? 100 : set->rate_hz;
        set->options.sample_period_s = 1 / set->rate_hz;
    }
    set->options.error_model = set->no_model ? SINS_ERROR_MODEL_OFF : SINS_ERROR_MODEL_RK4;
    set_names(set);
}

int settings_read(struct settings *set, int count, char **arguments)
{
    int taken;

    set_defaults(set);
    if (count > 0 && strcmp(arguments[0], "--help") == 0) {
        set->help = 1;
        return 0;
    }
    taken = read_scene(set, count, arguments);
    if (taken == 0 || (set->kind == SCENE_SIMULATION2 && settings_preset(set) != 0)
        || read_options(set, count - taken, arguments + taken) != 0 || check_together(set) != 0) {
        return -1;
    }
    complete(set);
    return 0;
}

int settings_has_ideal_sensors(const struct settings *set)
{
    sins_gyro_params gyro;
    sins_accel_params accel;

    memset(&gyro, 0, sizeof gyro);
    memset(&accel, 0, sizeof accel);
    gyro.struct_size = set->gyro.struct_size;
    accel.struct_size = set->accel.struct_size;
    return memcmp(&gyro, &set->gyro, sizeof gyro) == 0 && memcmp(&accel, &set->accel, sizeof accel) == 0;
}

int settings_create(const struct settings *set, sins_sim **sim)
{
    if (refused(NULL, sins_create(&set->options, sim))) {
        return BAD_INPUT;
    }
    if (refused(*sim, sins_set_gyro(*sim, &set->gyro)) || refused(*sim, sins_set_accel(*sim, &set->accel))
        || refused(*sim, sins_set_altimeter(*sim, &set->altimeter))
        || refused(*sim, sins_set_initial_errors(*sim, &set->initial))) {
        sins_destroy(*sim);
        *sim = NULL;
        return BAD_INPUT;
    }
    return DONE;
}
