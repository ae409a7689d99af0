#include "fly.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "complain.h"
#include "host.h"
#include "imu_file.h"
#include "progress.h"
#include "report.h"

/* A chunk of samples, the records that they make, and the sensors' errors up to each record. */
static sins_flight_sample samples[SCENE_CHUNK];
static sins_record records[SCENE_CHUNK];
static struct sensor_errors sensors[SCENE_CHUNK];

/* Integral of the sensors' errors since the last record [rad], [m/s], and over which time [s]. */
struct sensor_sum {
    double angle_rad[3];
    double velocity_m_s[3];
    double time_s;
};

struct run {
    sins_sim *sim;
    struct scene *scene;
    struct flight_files *files;
    struct flown *result;
    struct progress progress;
    struct sensor_sum sum;
    const struct failure_plan *failures;
    struct failure_progress failure_progress;
    double time_s;  /* to which the flight has come */
    int by_sample; /* the increments of each sample are wanted, for their errors or their file, or failures come and go */
    int is_at_end;
};

static void add_sensors(struct sensor_sum *sum, const sins_imu *imu)
{
    int axis;

    for (axis = 0; axis < 3; axis++) {
        sum->angle_rad[axis] += imu->measured_angle_rad[axis] - imu->ideal_angle_rad[axis];
        sum->velocity_m_s[axis] += imu->measured_velocity_m_s[axis] - imu->ideal_velocity_m_s[axis];
    }
    sum->time_s += imu->interval_s;
}

/* The mean; the sum begins anew. */
static struct sensor_errors take_mean(struct sensor_sum *sum)
{
    struct sensor_errors mean;
    int axis;

    for (axis = 0; axis < 3; axis++) {
        mean.gyro_rad_s[axis] = sum->angle_rad[axis] / sum->time_s;
        mean.accel_m_s2[axis] = sum->velocity_m_s[axis] / sum->time_s;
    }
    memset(sum, 0, sizeof *sum);
    return mean;
}

static double length(const double *vector)
{
    return sqrt(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
}

static double distance(const double *a, const double *b)
{
    double difference[3];
    int axis;

    for (axis = 0; axis < 3; axis++) {
        difference[axis] = a[axis] - b[axis];
    }
    return length(difference);
}

static void keep_record(struct run *run, const sins_record *record, const struct sensor_errors *mean)
{
    struct flown *result = run->result;
    const sins_record_errors *data1 = &record->model_errors, *data2 = &record->navigation_errors;
    int has_model = (data1->flags & SINS_ERRORS_NOT_COMPUTED) == 0;

    record_file_row(&run->files->records, record, mean);
    result->records++;
    result->max_position_m = fmax(result->max_position_m, length(data2->position_enu_m));
    if (has_model) {
        result->max_model_position_m =
            fmax(result->max_model_position_m, distance(data1->position_enu_m, data2->position_enu_m));
    }
    if ((data2->flags & SINS_ERRORS_NEAR_POLE) != 0) {
        return; /* east, north and up misalignment mean nothing there */
    }
    result->max_velocity_m_s = fmax(result->max_velocity_m_s, length(data2->velocity_enu_m_s));
    result->max_misalignment_rad = fmax(result->max_misalignment_rad, length(data2->misalignment_enu_rad));
    if (has_model) {
        result->max_model_velocity_m_s =
            fmax(result->max_model_velocity_m_s, distance(data1->velocity_enu_m_s, data2->velocity_enu_m_s));
    }
}

/* Failures that begin or end with the next step. */
static sins_status advance_failures(struct run *run)
{
    return failure_plan_advance(run->failures, &run->failure_progress, run->sim,
                                run->time_s - run->scene->first_time_s, SCENE_ROUNDING * run->scene->period_s);
}

/* Flies the chunk: in one call, or sample by sample where the increments are wanted. *made: records. */
static sins_status fly_samples(struct run *run, size_t count, size_t *made)
{
    size_t piece = run->by_sample ? 1 : count, i;
    sins_imu imu;

    imu.struct_size = sizeof imu;
    *made = 0;
    for (i = 0; i < count; i += piece) {
        size_t written = 0;
        sins_status status = advance_failures(run);

        if (status >= 0) {
            status = sins_run(run->sim, &samples[i], piece, (size_t)run->result->every, &records[*made],
                              SCENE_CHUNK - *made, &written);
        }
        run->time_s = samples[i + piece - 1].time_s;
        if (status >= 0 && run->by_sample) {
            status = sins_get_imu(run->sim, &imu);
        }
        if (status >= 0 && run->by_sample) {
            add_sensors(&run->sum, &imu);
            if (run->files->imu.stream != NULL) {
                imu_file_row(&run->files->imu, &imu);
            }
            if (written > 0) {
                sensors[*made] = take_mean(&run->sum);
            }
        }
        *made += written;
        if (status < 0) {
            return status;
        }
    }
    return SINS_OK;
}

/* How many samples of the chunk were flown: the intervals since those before it. */
static size_t samples_flown(const struct run *run)
{
    sins_accuracy accuracy;

    accuracy.struct_size = sizeof accuracy;
    return sins_get_accuracy(run->sim, &accuracy) == SINS_OK ? (size_t)(accuracy.intervals - run->result->steps) : 0;
}

/* The library's sentence about sample `at` of the chunk, with its line in the log. */
static int report_failure(const struct run *run, sins_status status, size_t at)
{
    const struct scene *scene = run->scene;
    char sentence[512];
    char *index_in_chunk;

    library_sentence(run->sim, sentence, sizeof sentence);
    index_in_chunk = strstr(sentence, " (samples[");
    if (index_in_chunk != NULL) {
        *index_in_chunk = '\0'; /* means nothing to the user: line and time do */
    }
    at = at < SCENE_CHUNK ? at : SCENE_CHUNK - 1;
    if (scene->flight == NULL) {
        fprintf(stderr, "%s:%ld: %s\n", scene->log.path, scene->line[at], sentence);
    } else {
        report("at %.10g s: %s", samples[at].time_s, sentence);
    }
    return status == SINS_ERROR_INVALID_ARGUMENT || status == SINS_ERROR_TIME_ORDER
                || status == SINS_ERROR_DISCONTINUITY
             ? BAD_INPUT
             : FAILED;
}

/* Intervals between records. 0: the option is below one interval, reported. */
static uint64_t spacing(const struct scene *scene, const struct settings *set)
{
    double intervals;

    if (set->every_s == 0 || scene->period_s == 0) {
        intervals = floor((double)(scene->samples - 1) / 2000 + 0.5);
        return intervals < 1 ? 1 : (uint64_t)intervals;
    }
    intervals = floor(set->every_s / scene->period_s + 0.5);
    if (intervals < 1) {
        complain(set, "every_s", "%g: expected at least the sample interval, %.6g s", set->every_s, scene->period_s);
        return 0;
    }
    return (uint64_t)intervals;
}

/* The first sample and the record of the start. */
static int begin(struct run *run)
{
    struct sensor_errors none;
    sins_status status;
    size_t got;
    int code = scene_next(run->scene, samples, 1, &got);

    if (code != DONE) {
        return code;
    }
    status = sins_push_sample(run->sim, &samples[0]);
    if (status < 0) {
        return report_failure(run, status, 0);
    }
    if (refused(run->sim, sins_get_record(run->sim, &records[0]))) {
        return FAILED;
    }
    run->time_s = samples[0].time_s;
    memset(&none, 0, sizeof none);
    record_file_header(&run->files->records);
    if (run->files->imu.stream != NULL) {
        imu_file_header(&run->files->imu);
    }
    keep_record(run, &records[0], &none);
    return DONE;
}

static int fly_chunk(struct run *run)
{
    size_t got, made, flown_samples, i;
    sins_status status;
    double began_s;
    int code = scene_next(run->scene, samples, SCENE_CHUNK, &got);

    run->is_at_end = got == 0;
    if (code != DONE || run->is_at_end) {
        return code;
    }
    began_s = host_seconds();
    status = fly_samples(run, got, &made);
    run->result->library_s += host_seconds() - began_s;
    flown_samples = status < 0 ? samples_flown(run) : got;
    run->result->steps += flown_samples;
    for (i = 0; i < made; i++) {
        keep_record(run, &records[i], &sensors[i]);
    }
    if (status < 0) {
        progress_end(&run->progress);
        return report_failure(run, status, flown_samples);
    }
    progress_show(&run->progress, samples[got - 1].time_s - run->scene->first_time_s);
    if (whole_file_check(&run->files->records) != 0) {
        return FAILED;
    }
    return run->files->imu.stream == NULL || whole_file_check(&run->files->imu) == 0 ? DONE : FAILED;
}

int fly(sins_sim *sim, struct scene *scene, const struct settings *set, struct flight_files *files,
        struct flown *result)
{
    struct run run;
    size_t i;
    int code;

    memset(&run, 0, sizeof run);
    memset(result, 0, sizeof *result);
    run.sim = sim;
    run.scene = scene;
    run.files = files;
    run.result = result;
    run.failures = &set->failures;
    run.by_sample = files->imu.stream != NULL || !settings_has_ideal_sensors(set) || set->failures.count > 0;
    result->every = spacing(scene, set);
    if (result->every == 0) {
        return BAD_INPUT;
    }
    for (i = 0; i < SCENE_CHUNK; i++) {
        records[i].struct_size = sizeof records[i];
    }
    code = begin(&run);
    progress_begin(&run.progress, scene->duration_s, set->quiet);
    while (code == DONE && !run.is_at_end && !host_interrupted()) {
        code = fly_chunk(&run);
    }
    progress_end(&run.progress);
    return code == DONE && !run.is_at_end ? INTERRUPTED : code;
}
