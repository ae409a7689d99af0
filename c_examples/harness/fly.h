/* The flight: samples into the simulator chunk by chunk, records out. */

#ifndef FLY_H
#define FLY_H

#include "record_file.h"
#include "scene.h"

/* What came of it. */
struct flown {
    uint64_t every; /* intervals between records */
    uint64_t steps;
    uint64_t records;
    double library_s; /* wall time in the library */
    int interrupted;
    double max_position_m, max_velocity_m_s, max_misalignment_rad; /* error data 2, lengths of the vectors */
    double max_model_position_m, max_model_velocity_m_s;           /* error data 1 less 2, likewise */
};

/* The files that are written on the way. */
struct flight_files {
    struct whole_file records;
    struct whole_file imu; /* without a stream: not wanted */
};

/* DONE, INTERRUPTED, or FAILED or BAD_INPUT reported. What was flown before is in files and result in any case. */
int fly(sins_sim *sim, struct scene *scene, const struct settings *set, struct flight_files *files,
        struct flown *result);

#endif
