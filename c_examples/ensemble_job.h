/*
 * Flies the runs of a scene in blocks, and writes the table of their statistics. This part of a program does not depend on how the
 * program spreads an ensemble over threads, processes or machines. It opens no files. ensemble_mpi.c is such a program.
 *
 * The program that includes this file defines fail(), which prints an error and ends the program.
 */

#ifndef ENSEMBLE_JOB_H
#define ENSEMBLE_JOB_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sins_scene.h"

/* Number of runs in a block, and of rows of the table after the first row: the numbers that sins ensemble uses. */
#define BLOCK 64
#define ROWS 200
#define ROUNDING 1e-9

/* The job: the scene, its flight, and how the runs are divided. */
static struct {
    sins_scene *scene;
    sins_flight *flight; /* if the flight is made of manoeuvres; else NULL */
    sins_log *log;       /* if the flight is a log; else NULL */
    sins_scene_setup setup;
    sins_options options;
    double start_s;
    size_t samples, every, sources, count; /* count: number of statistics, one for each source in each row */
    uint64_t runs, blocks, key;            /* key: hash of all that the results depend on */
} job;

static void fail(const char *what, const char *why);

/* An error of the library ends the program with the library's sentence. */
#define CHECK(call) check(call, #call)

static void check(sins_status status, const char *call)
{
    char sentence[512] = "";

    if (status < 0) {
        sins_last_error(NULL, sentence, sizeof sentence, NULL);
        fail(call, sentence);
    }
}

static char *room(size_t size)
{
    char *memory = (char *)calloc(size, 1); /* C++ needs the cast */

    if (memory == NULL) {
        fail("memory", "there is not enough");
    }
    return memory;
}

/* FNV-1a of 64 bits. */
static uint64_t hash(uint64_t hash, const void *bytes, size_t size)
{
    const unsigned char *byte = (const unsigned char *)bytes;

    while (size-- > 0) {
        hash = (hash ^ *byte++) * 1099511628211u;
    }
    return hash;
}

static void get_sample(size_t k, sins_flight_sample *sample)
{
    SINS_INIT(*sample);
    if (job.log != NULL) {
        CHECK(sins_log_get_sample(job.log, k, sample, NULL));
    } else {
        CHECK(sins_flight_sample_at(job.flight, fmin((double)k / job.setup.rate_hz, job.setup.flown_s), sample));
    }
}

/* Prepares this number of runs of a scene, whose text is given; the first run is options.run of the scene. A log that is not NULL
 * replaces the flight of the scene. */
static void open_job(uint64_t runs, const char *scene, size_t scene_size, const char *log, size_t log_size)
{
    sins_flight_sample sample;
    sins_log_info info;
    sins_fault fault;
    char place[80];

    SINS_INIT(fault);
    SINS_INIT(info);
    SINS_INIT(job.setup);
    SINS_INIT(job.options);
    if (sins_scene_parse(scene, scene_size, &job.scene) == SINS_SCENE_HAS_FAULTS) {
        CHECK(sins_scene_get_fault(job.scene, 0, &fault));
        snprintf(place, sizeof place, "the scene, line %llu, column %llu", (unsigned long long)fault.line,
                 (unsigned long long)fault.column);
        fail(place, fault.sentence);
    }
    if (log != NULL) {
        CHECK(sins_log_parse(log, log_size, job.scene, &job.log, &fault));
        CHECK(sins_log_get_info(job.log, &info));
        CHECK(sins_scene_set_text(job.scene, SINS_SCENE_TEXT_LOG, "log"));
    } else {
        CHECK(sins_scene_create_flight(job.scene, &job.flight));
    }
    CHECK(sins_scene_get_value(job.scene, "unit.start", place, sizeof place, NULL));
    if (strcmp(place, "\"none\"") != 0) {
        fail("unit.start", "the runs side by side have no unit; `sins ensemble` flies each run of this scene with its unit");
    }
    CHECK(sins_scene_get_setup(job.scene, &job.setup));
    CHECK(sins_scene_get_options(job.scene, &job.options));
    job.samples = log != NULL ? (size_t)info.samples
                              : (size_t)floor(job.setup.flown_s / (1 / job.setup.rate_hz) + ROUNDING) + 1;
    get_sample(0, &sample);
    job.start_s = sample.time_s;
    job.every = (size_t)fmax(1, floor((double)(job.samples - 1) / ROWS + 0.5));
    job.sources = job.options.error_model == SINS_ERROR_MODEL_OFF ? 1 : 2;
    job.count = job.sources * (1 + (job.samples - 1 + job.every - 1) / job.every); /* at 0, every, 2 every ..., the end */
    job.runs = runs;
    job.blocks = (runs + BLOCK - 1) / BLOCK;
    job.key = hash(hash(hash(0, scene, scene_size), log, log_size), &runs, sizeof runs);
    job.key = hash(job.key, sins_version_string(), strlen(sins_version_string()));
}

/* Statistics of no runs. */
static void clear_statistics(sins_statistics *statistics)
{
    size_t k;

    for (k = 0; k < job.count; k++) {
        SINS_INIT(statistics[k]);
    }
}

static void merge_statistics(sins_statistics *into, const sins_statistics *from, size_t count)
{
    for (; count > 0; count--) {
        CHECK(sins_statistics_merge(into++, from++));
    }
}

/* Flies the runs of a block. At the end of the flight it adds their statistics to those of each row. */
static void fly_block(uint64_t block, sins_statistics *statistics)
{
    uint64_t first = block * BLOCK, left = job.runs - first;
    sins_statistics *now = (sins_statistics *)(void *)room(job.count * sizeof *now);
    sins_sim *sim = NULL;
    sins_ensemble *ensemble = NULL;
    sins_flight_sample sample;
    size_t k, row = 0, source;

    clear_statistics(now);
    CHECK(sins_scene_create_simulator(job.scene, &sim));
    CHECK(sins_ensemble_create(sim, job.options.run + first, (size_t)(left < BLOCK ? left : BLOCK), &ensemble));
    for (k = 0; k < job.samples; k++) {
        get_sample(k, &sample);
        CHECK(sins_scene_prepare_ensemble(job.scene, ensemble, job.start_s, &sample));
        CHECK(sins_ensemble_push_sample(ensemble, &sample));
        CHECK(sins_ensemble_step(ensemble)); /* SINS_NEED_SAMPLE at the first one */
        for (source = 0; source < job.sources && (k % job.every == 0 || k + 1 == job.samples); source++) {
            CHECK(sins_ensemble_get_statistics(ensemble, source == 0 ? SINS_ERRORS_NAVIGATION : SINS_ERRORS_MODEL,
                                               &now[row++]));
        }
    }
    merge_statistics(statistics, now, job.count);
    CHECK(sins_ensemble_destroy(ensemble));
    CHECK(sins_destroy(sim));
    free(now);
}

/* Writes the table of sins ensemble: error data 2 (navigation minus truth), and error data 1 (error equations) if the scene turns
 * them on. */
static void write_table(FILE *file, const sins_statistics *statistics)
{
    static const char *const figures[] = {"mean", "sigma", "rms"};
    static const char *const states[] = {"position_east_m",       "position_north_m",       "position_up_m",
                                         "velocity_east_m_s",     "velocity_north_m_s",     "velocity_up_m_s",
                                         "misalignment_east_rad", "misalignment_north_rad", "misalignment_up_rad"};
    sins_flight_sample sample;
    sins_figures f;
    double values[27];
    size_t k, at, column;

    fprintf(file, "time_s,error_data,runs,diverged,out_of_range");
    for (column = 0; column < 27; column++) {
        fprintf(file, ",%s_%s", figures[column / 9], states[column % 9]);
    }
    fprintf(file, ",position_covariance_east_north_m2,cep50_m,r95_m,largest_m\n");
    SINS_INIT(f);
    for (k = 0; k < job.count; k++) {
        at = k / job.sources * job.every;
        get_sample(at < job.samples ? at : job.samples - 1, &sample);
        CHECK(sins_statistics_figures(&statistics[k], &f));
        fprintf(file, "%.6f,%d,%llu,%llu,%llu", sample.time_s, k % job.sources == 0 ? 2 : 1, (unsigned long long)f.runs,
                (unsigned long long)f.diverged, (unsigned long long)f.out_of_range);
        /* In sins_figures, the means of the nine states, their sigmas and their root mean squares follow each other. */
        memcpy(values, (const char *)&f + offsetof(sins_figures, mean_position_enu_m), sizeof values);
        for (column = 0; column < 27; column++) {
            fprintf(file, ",%.9e", values[column]);
        }
        fprintf(file, ",%.9e,%.9e,%.9e,%.9e\n", f.covariance[1], f.cep50_m, f.r95_m, f.largest_radial_m);
    }
}

#endif
