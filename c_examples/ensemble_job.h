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

/* The job: the scene, its flight, and how the runs are divided. */
static struct {
    sins_scene *scene;
    sins_flight *flight; /* if the flight is made of manoeuvres; else NULL */
    sins_log *log;       /* if the flight is a log; else NULL */
    sins_scene_setup setup;
    sins_options options;
    sins_scene_samples flown;
    /* The error data of a row: 2 (navigation minus truth); 1 (error equations), if the scene turns them on; and of a scene with a unit 3:
     * data 2 of the runs whose unit shows position, velocity, attitude and heading as valid. */
    int data[3], has_unit;
    size_t samples, every, sources, count; /* count: number of statistics, one for each source in each row */
    uint64_t runs, blocks, key;            /* key: hash of all that the results depend on */
} job;

static void fail(const char *what, const char *why);

/* An error of the library ends the program with the library's sentence. sim: the simulator of the call; NULL: a call without one. */
#define CHECK(call) check(call, NULL, #call)

static void check(sins_status status, sins_sim *sim, const char *call)
{
    char sentence[512] = "";

    if (status < 0) {
        sins_last_error(sim, sentence, sizeof sentence, NULL);
        fail(call, sentence);
    }
}

/* Whether an error is one of this run alone, which diverges. The truth of the other runs continues, unless it is too near a pole. */
static int is_of_run(sins_status status, sins_sim *sim)
{
    sins_error_info info;

    SINS_INIT(info);
    if (status != SINS_ERROR_DIVERGED && status != SINS_ERROR_SINGULAR) {
        return 0;
    }
    CHECK(sins_last_error_info(sim, &info));
    return strcmp(info.field, "cosine of sample.latitude_rad") != 0;
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
    sins_fault fault;
    char place[80];

    SINS_INIT(fault);
    SINS_INIT(job.flown);
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
        CHECK(sins_scene_set_text(job.scene, SINS_SCENE_TEXT_LOG, "log"));
        CHECK(sins_scene_set_values(job.scene, "flight.hours =")); /* the log is flown whole */
    } else {
        CHECK(sins_scene_create_flight(job.scene, &job.flight));
    }
    CHECK(sins_scene_get_value(job.scene, "unit.start", place, sizeof place, NULL));
    job.has_unit = strcmp(place, "\"none\"") != 0;
    CHECK(sins_scene_get_setup(job.scene, &job.setup));
    CHECK(sins_scene_get_options(job.scene, &job.options));
    CHECK(sins_scene_get_samples(job.scene, job.log, &job.flown));
    job.samples = (size_t)job.flown.count;
    job.every = (size_t)fmax(1, floor((double)(job.samples - 1) / ROWS + 0.5));
    job.data[job.sources++] = 2;
    if (job.options.error_model != SINS_ERROR_MODEL_OFF) {
        job.data[job.sources++] = 1;
    }
    if (job.has_unit) {
        job.data[job.sources++] = 3;
        CHECK(sins_scene_set_values(job.scene, "options.covariance = off\noptions.truth_summary = off")); /* of the truth alone */
    }
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

/* Whether the table has a row of sample k. */
static int is_row(size_t k)
{
    return k % job.every == 0 || k + 1 == job.samples;
}

static int32_t source_of(int data)
{
    return data == 1 ? SINS_ERRORS_MODEL : SINS_ERRORS_NAVIGATION;
}

/* Flies runs side by side, without units, and puts their statistics into those of each row. */
static void fly_side_by_side(uint64_t first, size_t runs, sins_statistics *rows)
{
    sins_sim *sim = NULL;
    sins_ensemble *ensemble = NULL;
    sins_flight_sample sample;
    size_t k, source;

    CHECK(sins_scene_create_simulator(job.scene, &sim));
    CHECK(sins_ensemble_create(sim, first, runs, &ensemble));
    for (k = 0; k < job.samples; k++) {
        get_sample(k, &sample);
        CHECK(sins_scene_prepare_ensemble(job.scene, ensemble, job.flown.start_s, &sample));
        CHECK(sins_ensemble_push_sample(ensemble, &sample));
        CHECK(sins_ensemble_step(ensemble)); /* SINS_NEED_SAMPLE at the first one */
        for (source = 0; source < job.sources && is_row(k); source++) {
            CHECK(sins_ensemble_get_statistics(ensemble, source_of(job.data[source]), rows++));
        }
    }
    CHECK(sins_ensemble_destroy(ensemble));
    CHECK(sins_destroy(sim));
}

/* Adds a run to the statistics of a row. Without errors it counts as diverged. */
static void add_run(sins_sim *sim, sins_unit *unit, int has_diverged, sins_statistics *row)
{
    static const uint32_t whole =
        SINS_UNIT_VALID_POSITION | SINS_UNIT_VALID_VELOCITY | SINS_UNIT_VALID_ATTITUDE | SINS_UNIT_VALID_HEADING;
    sins_unit_status shown;
    sins_errors errors;
    sins_status status;
    size_t source;

    SINS_INIT(shown);
    CHECK(sins_unit_get_status(unit, &shown));
    for (source = 0; source < job.sources; source++) {
        SINS_INIT(errors);
        errors.flags = SINS_ERRORS_NOT_COMPUTED;
        status = has_diverged ? SINS_OK : sins_get_errors(sim, source_of(job.data[source]), &errors);
        if (!is_of_run(status, sim)) {
            check(status, sim, "sins_get_errors");
        }
        if (job.data[source] != 3 || errors.flags == SINS_ERRORS_NOT_COMPUTED || (shown.validity & whole) == whole) {
            CHECK(sins_statistics_add(&row[source], &errors));
        }
    }
}

/* Flies one run with a unit of its own, and adds it to the statistics of each row. */
static void fly_with_unit(uint64_t run, sins_statistics *rows)
{
    sins_play *play = NULL;
    sins_sim *sim = NULL;
    sins_unit *unit = NULL;
    sins_status status = SINS_OK;
    char number[48];
    size_t k;

    snprintf(number, sizeof number, "options.run = %llu", (unsigned long long)run);
    CHECK(sins_scene_set_values(job.scene, number));
    CHECK(sins_play_create(job.scene, job.log, &play));
    CHECK(sins_play_get_simulator(play, &sim));
    CHECK(sins_play_get_unit(play, &unit));
    for (k = 0; k < job.samples; k++) {
        if (status >= 0 && !is_of_run(status = sins_play_next(play), NULL)) {
            check(status, NULL, "sins_play_next");
        }
        if (is_row(k)) {
            add_run(sim, unit, status < 0, rows);
            rows += job.sources;
        }
    }
    CHECK(sins_play_destroy(play));
}

/* Flies the runs of a block. At the end of the flight it adds their statistics to those of each row. */
static void fly_block(uint64_t block, sins_statistics *statistics)
{
    uint64_t first = job.options.run + block * BLOCK, left = job.runs - block * BLOCK, k;
    uint64_t runs = left < BLOCK ? left : BLOCK;
    sins_statistics *now = (sins_statistics *)(void *)room(job.count * sizeof *now);

    clear_statistics(now);
    if (job.has_unit) {
        for (k = 0; k < runs; k++) {
            fly_with_unit(first + k, now);
        }
    } else {
        fly_side_by_side(first, (size_t)runs, now);
    }
    merge_statistics(statistics, now, job.count);
    free(now);
}

/* Writes numbers of the table; if there are too few runs for them, empty fields. */
static void write_numbers(FILE *file, const double *numbers, size_t count, int are_enough)
{
    for (; count > 0; count--, numbers++) {
        if (are_enough) {
            fprintf(file, ",%.9e", *numbers);
        } else {
            fprintf(file, ",");
        }
    }
}

/* Writes the table of sins ensemble. */
static void write_table(FILE *file, const sins_statistics *statistics)
{
    static const char *const figures[] = {"mean", "sigma", "rms"};
    static const char *const states[] = {"position_east_m",       "position_north_m",       "position_up_m",
                                         "velocity_east_m_s",     "velocity_north_m_s",     "velocity_up_m_s",
                                         "misalignment_east_rad", "misalignment_north_rad", "misalignment_up_rad"};
    sins_flight_sample sample;
    sins_figures f;
    double values[27];
    uint64_t good;
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
        fprintf(file, "%.6f,%d,%llu,%llu,%llu", sample.time_s, job.data[k % job.sources], (unsigned long long)f.runs,
                (unsigned long long)f.diverged, (unsigned long long)f.out_of_range);
        good = f.runs - f.diverged - f.out_of_range;
        /* In sins_figures, the means of the nine states, their sigmas and their root mean squares follow each other. */
        memcpy(values, (const char *)&f + offsetof(sins_figures, mean_position_enu_m), sizeof values);
        write_numbers(file, values, 9, good > 0);
        write_numbers(file, values + 9, 9, good > 1); /* of one run there is no scatter */
        write_numbers(file, values + 18, 9, good > 0);
        write_numbers(file, &f.covariance[1], 1, good > 1);
        write_numbers(file, &f.cep50_m, 1, good > 0);
        write_numbers(file, &f.r95_m, 1, good > 0);
        write_numbers(file, &f.largest_radial_m, 1, good > 0);
        fprintf(file, "\n");
    }
}

#endif
