/* What the command line sets, in SI and radians. */

#ifndef SETTINGS_H
#define SETTINGS_H

#include "sins.h"

enum scene_kind { SCENE_SIMULATION1, SCENE_SIMULATION2, SCENE_FLIGHT, SCENE_EMBEDDED };

enum { MOTION_NONE = -1, MOTION_REST = 0, MOTION_PATROL = 1 };

struct settings {
    enum scene_kind kind;
    const char *scene;   /* as given */
    const char *operand; /* log file or name of the embedded flight; NULL */
    int32_t motion;      /* MOTION_... of simulation1 and simulation2 */
    const char *motion_name; /* of a log its file, of an embedded flight its name */
    const char *out;
    const char *name; /* base name of the output files */
    const char *imu;  /* file of the measured increments; NULL: none */
    char default_name[256];
    double hours;   /* 0: the scene's own */
    double rate_hz; /* 0: a log's own time stamps */
    double every_s; /* 0: such that about 2000 records result */
    int32_t no_model;
    int32_t quiet;
    int32_t help;
    sins_options options;
    sins_gyro_params gyro;
    sins_accel_params accel;
    sins_altimeter_params altimeter;
    sins_initial_errors initial;
};

/* Reads the command line. 0, or -1 reported. */
int settings_read(struct settings *set, int count, char **arguments);

/* The sensor errors of the paper's simulation 2. 0, or -1 reported. */
int settings_preset(struct settings *set);

/* Whether neither gyros nor accelerometers have errors. */
int settings_has_ideal_sensors(const struct settings *set);

/* Creates the simulator. DONE, or BAD_INPUT with the library's sentence reported. */
int settings_create(const struct settings *set, sins_sim **sim);

#endif
