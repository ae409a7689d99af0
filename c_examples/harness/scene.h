/* The source of flight samples: an embedded flight or a log. */

#ifndef SCENE_H
#define SCENE_H

#include "flight_csv.h"
#include "settings.h"

enum { SCENE_CHUNK = 6000 }; /* a minute at 100 Hz */

/* What rounding may leave of a sample interval. */
#define SCENE_ROUNDING 1e-6

struct scene {
    sins_flight *flight; /* NULL: the log */
    struct flight_csv log;
    double flight_s; /* of the whole embedded flight */
    double rate_hz; /* of the samples; of a log 0 */
    double period_s; /* of the samples; of a log the mean */
    double duration_s;
    uint64_t samples; /* in all */
    uint64_t given;   /* so far */
    double first_time_s;
    int has_temperature; /* from the settings, linear in time */
    double temperature_c;
    double temperature_change_c_s;
    long line[SCENE_CHUNK]; /* of each sample of the last chunk of a log */
};

/* DONE, or FAILED or BAD_INPUT reported. */
int scene_open(struct scene *scene, const struct settings *set);

/* The next samples, up to count of them; how many in *got, 0 at the end. */
int scene_next(struct scene *scene, sins_flight_sample *samples, size_t count, size_t *got);

void scene_close(struct scene *scene);

#endif
