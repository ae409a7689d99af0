#include "scene.h"

#include <errno.h>
#include <math.h>
#include <string.h>

#include "complain.h"
#include "flight_plan.h"
#include "report.h"

/* The manoeuvres of the flight. DONE, or BAD_INPUT reported. */
static int make_plan(struct flight_plan *plan, const struct settings *set, double wanted_s)
{
    switch (set->kind) {
    case SCENE_MANOEUVRES:
        *plan = set->plan;
        plan->start = set->start;
        break;
    case SCENE_EMBEDDED:
        if (flight_plan_named(plan, set->builtin, wanted_s) != 0) {
            complain(set, "builtin", "%s: no such flight; \"sins_harness embedded list\" names them", set->builtin);
            return BAD_INPUT;
        }
        break;
    default:
        if (set->motion == MOTION_REST) {
            flight_plan_rest(plan, wanted_s);
        } else {
            flight_plan_patrol(plan, wanted_s);
        }
    }
    plan->start.earth = set->options.earth;
    return DONE;
}

static void take_temperature(struct scene *scene, const struct settings *set)
{
    scene->has_temperature = settings_has(set, "temperature_c");
    scene->temperature_c = set->temperature_c;
    scene->temperature_change_c_s = set->temperature_change_c_h / 3600;
}

static void give_temperature(const struct scene *scene, sins_flight_sample *sample)
{
    sample->flags |= SINS_SAMPLE_TEMPERATURE;
    sample->temperature_c =
        scene->temperature_c + scene->temperature_change_c_s * (sample->time_s - scene->first_time_s);
}

static int open_flight(struct scene *scene, const struct settings *set)
{
    static struct flight_plan plan;
    double wanted_s = set->hours * 3600;
    int code = make_plan(&plan, set, wanted_s);

    if (code != DONE) {
        return code;
    }
    if (refused_setting(set, NULL, sins_flight_create(&plan.start, plan.manoeuvres, plan.count, &scene->flight))) {
        return BAD_INPUT;
    }
    if (refused(NULL, sins_flight_duration(scene->flight, &scene->flight_s))) {
        return FAILED;
    }
    if (wanted_s > scene->flight_s * (1 + SCENE_ROUNDING)) {
        complain(set, "hours", "%g: the flight lasts %.4g h", set->hours, scene->flight_s / 3600);
        return BAD_INPUT;
    }
    scene->rate_hz = set->rate_hz;
    scene->period_s = 1 / set->rate_hz;
    scene->samples = (uint64_t)floor((wanted_s > 0 ? wanted_s : scene->flight_s) / scene->period_s + SCENE_ROUNDING) + 1;
    scene->duration_s = (double)(scene->samples - 1) * scene->period_s;
    return DONE;
}

/* Reads the whole log once: errors show before anything is flown, and its length is known. */
static int measure_log(struct scene *scene, const struct settings *set)
{
    sins_flight_sample sample;
    double last_time_s = 0;
    int found;

    while ((found = flight_csv_next(&scene->log, &sample)) == 1) {
        if (scene->samples == 0) {
            scene->first_time_s = sample.time_s;
        }
        if (set->hours > 0 && sample.time_s - scene->first_time_s > set->hours * 3600 * (1 + SCENE_ROUNDING)) {
            break;
        }
        last_time_s = sample.time_s;
        scene->samples++;
    }
    if (found < 0) {
        return BAD_INPUT;
    }
    if (scene->samples < 2) {
        report("%s: %s; a flight needs at least two", set->log, scene->samples == 0 ? "no sample" : "one sample");
        return BAD_INPUT;
    }
    scene->duration_s = fmax(last_time_s - scene->first_time_s, 0);
    scene->period_s = scene->duration_s / (double)(scene->samples - 1);
    return DONE;
}

/* A log that is not there is a fault of the line that names it. */
static int check_log(const struct settings *set)
{
    FILE *stream = fopen(set->log, "rb");

    if (stream == NULL) {
        complain(set, "log", "%s: %s", set->log, strerror(errno));
        return -1;
    }
    fclose(stream);
    return 0;
}

int scene_open(struct scene *scene, const struct settings *set)
{
    int code;

    memset(scene, 0, sizeof *scene);
    take_temperature(scene, set);
    if (set->kind != SCENE_FLIGHT) {
        return open_flight(scene, set);
    }
    if ((set->scene_file[0] != '\0' && check_log(set) != 0) || flight_csv_open(&scene->log, set->log) != 0) {
        return BAD_INPUT;
    }
    if (scene->has_temperature && (scene->log.flags & SINS_SAMPLE_TEMPERATURE) != 0) {
        complain(set, "temperature_c", "the log has a column of that name");
        return BAD_INPUT;
    }
    code = measure_log(scene, set);
    flight_csv_close(&scene->log);
    return code != DONE ? code : flight_csv_open(&scene->log, set->log) != 0 ? BAD_INPUT : DONE;
}

int scene_next(struct scene *scene, sins_flight_sample *samples, size_t count, size_t *got)
{
    for (*got = 0; *got < count && scene->given < scene->samples; (*got)++, scene->given++) {
        sins_flight_sample *sample = &samples[*got];

        if (scene->flight == NULL) {
            int found = flight_csv_next(&scene->log, sample);
            if (found <= 0) {
                return found < 0 ? BAD_INPUT : DONE;
            }
            scene->line[*got] = scene->log.line;
        } else {
            /* Rounding must not carry the last time over the end. */
            double time_s = fmin((double)scene->given / scene->rate_hz, scene->flight_s);

            sample->struct_size = sizeof *sample;
            if (refused(NULL, sins_flight_sample_at(scene->flight, time_s, sample))) {
                return FAILED;
            }
        }
        if (scene->has_temperature) {
            give_temperature(scene, sample);
        }
    }
    return DONE;
}

void scene_close(struct scene *scene)
{
    flight_csv_close(&scene->log);
    if (scene->flight != NULL) {
        sins_flight_destroy(scene->flight);
        scene->flight = NULL;
    }
}
