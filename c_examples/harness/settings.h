/* What the command line and a scene file set, in SI and radians. */

#ifndef SETTINGS_H
#define SETTINGS_H

#include "failure_plan.h"
#include "flight_plan.h"
#include "sins.h"
#include "value.h"

enum scene_kind { SCENE_SIMULATION1, SCENE_SIMULATION2, SCENE_FLIGHT, SCENE_EMBEDDED, SCENE_MANOEUVRES };

enum { MOTION_NONE = -1, MOTION_REST = 0, MOTION_PATROL = 1 };

/* At least as many as there are options, sections of a scene file, and keys of a manoeuvre. */
enum { SETTINGS_OPTIONS = 192, SETTINGS_SECTIONS = 16, MANOEUVRE_KEYS = 8 };

/* Where an option was set: a line of the scene file from 1, or one of these. */
enum { SET_NOWHERE = 0, SET_BY_COMMAND = -1 };

/* One term of the manoeuvre of sinusoids. */
struct sinusoid {
    int32_t channel;
    double amplitude_rad; /* of every channel but the speed */
    double amplitude_m_s; /* of the speed */
    double frequency_hz;
    double phase_rad;
};

/* Where a manoeuvre and its keys stand in the scene file. */
struct manoeuvre_lines {
    long header;
    long key[MANOEUVRE_KEYS];
};

struct settings {
    enum scene_kind kind;
    const char *scene;                 /* the kind in a word */
    char scene_file[VALUE_TEXT_SIZE];  /* empty: none */
    char title[VALUE_TEXT_SIZE];       /* the scene in words; empty: none */
    char log[VALUE_TEXT_SIZE];         /* of SCENE_FLIGHT */
    char builtin[VALUE_TEXT_SIZE];     /* of SCENE_EMBEDDED */
    int32_t motion;                    /* MOTION_... of simulation1 and simulation2 */
    const char *motion_name;           /* of a log its file, of an embedded flight its name */
    char out[VALUE_TEXT_SIZE];
    char name[VALUE_TEXT_SIZE]; /* base name of the output files */
    char imu[VALUE_TEXT_SIZE];  /* file of the measured increments; empty: none */
    double hours;   /* 0: the scene's own */
    double rate_hz; /* 0: a log's own time stamps */
    double temperature_c; /* at the begin; where no option sets it, samples have none but those of a log */
    double temperature_change_c_h;
    double every_s; /* 0: such that about 2000 records result */
    int32_t quiet;
    int32_t help;
    int32_t keys;
    int32_t grades[2]; /* SINS_GRADE_... that gyro and accel begin with, 0: ideal */
    sins_options options;
    sins_gyro_params gyro;
    sins_accel_params accel;
    sins_altimeter_params altimeter;
    sins_initial_errors initial;
    sins_mounting mounting;
    sins_gravity_params gravity;
    sins_failure failure;           /* the one that is being read */
    struct planned_failure failing; /* likewise; its own failure is taken at the end of its section */
    struct failure_plan failures;
    sins_flight_start start;  /* of SCENE_MANOEUVRES */
    sins_manoeuvre manoeuvre; /* the one that is being read */
    struct sinusoid sinusoid; /* likewise */
    struct flight_plan plan;
    struct manoeuvre_lines manoeuvre_lines[FLIGHT_PLAN_MANOEUVRES];
    long section_line[SETTINGS_SECTIONS];
    long line[SETTINGS_OPTIONS];
};

/* Everything off, or the recommended. 0, or -1 reported. */
int settings_begin(struct settings *set, const int32_t *grades);

/* Completes what was left open, and checks what single options cannot tell: whether they go together. 0, or -1
 * reported. */
int settings_complete(struct settings *set);

/* Whether an option has set the field. */
int settings_has(const struct settings *set, const char *field);

/* Whether neither gyros nor accelerometers have errors. */
int settings_has_ideal_sensors(const struct settings *set);

/* Creates the simulator. DONE, or BAD_INPUT with the library's sentence reported. */
int settings_create(const struct settings *set, sins_sim **sim);

#endif
