/* Eight handles in parallel are bit-equal to serial; one handle driven by eight threads at once flies as by one, and who reads it
 * meanwhile reads whole instants of that flight, in order. */

#define _XOPEN_SOURCE 600
#include <pthread.h>
#include <sched.h>
#include <string.h>

#include "scene.h"

enum { THREADS = 8, READERS = 2, STEPS = SCENE_COUNT - 1 };

static sins_flight_sample samples[SCENE_COUNT];

/* The serial flights, each with a seed of its own. */
static sins_record expected[THREADS][STEPS], found[THREADS][STEPS];

static void *fly_own(void *number)
{
    int i = *(int *)number;
    sins_sim *sim = scene_simulator(NULL, (unsigned)i);
    scene_fly(sim, samples, found[i]);
    CHECK(sins_destroy(sim) == SINS_OK);
    return NULL;
}

static sins_sim *shared;
static long pushed[THREADS], stepped[THREADS];

/* Pushes the samples that no other thread was quicker with, and steps. */
static void *drive_shared(void *number)
{
    int i = *(int *)number, k = 0;
    sins_status status;
    while (k < SCENE_COUNT) {
        status = sins_push_sample(shared, &samples[k]);
        CHECK(status == SINS_OK || status == SINS_ERROR_TIME_ORDER || status == SINS_ERROR_QUEUE_FULL);
        pushed[i] += status == SINS_OK;
        k += status != SINS_ERROR_QUEUE_FULL;
        status = sins_step(shared);
        CHECK(status == SINS_OK || status == SINS_NEED_SAMPLE);
        stepped[i] += status == SINS_OK;
        if (k % 16 == i) {
            sched_yield();
        }
    }
    while ((status = sins_step(shared)) == SINS_OK) {
        stepped[i]++;
    }
    CHECK(status == SINS_NEED_SAMPLE);
    return NULL;
}

/* Each record is one of the serial flight's, and time never runs back. */
static void *read_shared(void *reads)
{
    size_t last = 0;
    while (last < STEPS) {
        sins_record record = {.struct_size = sizeof record};
        sins_status status = sins_get_record(shared, &record);
        CHECK(status == SINS_OK || status == SINS_NEED_SAMPLE);
        if (status == SINS_OK && record.time_s > 0.0) {
            size_t flown = (size_t)(record.time_s * 128.0);
            CHECK(flown >= last && flown <= STEPS);
            CHECK(memcmp(&record, &expected[0][flown - 1], sizeof record) == 0);
            last = flown;
            ++*(long *)reads;
        }
    }
    return NULL;
}

int main(void)
{
    pthread_t threads[THREADS], readers[READERS];
    int numbers[THREADS], i;
    long reads[READERS] = {0}, pushes = 0, steps = 0;

    scene_samples(samples);
    for (i = 0; i < THREADS; i++) {
        numbers[i] = i;
        fly_own(&numbers[i]);
    }
    memcpy(expected, found, sizeof expected);
    CHECK(memcmp(expected[0], expected[1], sizeof expected[0]) != 0);
    memset(found, 0, sizeof found);
    for (i = 0; i < THREADS; i++) {
        CHECK(pthread_create(&threads[i], NULL, fly_own, &numbers[i]) == 0);
    }
    for (i = 0; i < THREADS; i++) {
        CHECK(pthread_join(threads[i], NULL) == 0);
    }
    CHECK(memcmp(expected, found, sizeof expected) == 0);

    shared = scene_simulator(NULL, 0);
    for (i = 0; i < READERS; i++) {
        CHECK(pthread_create(&readers[i], NULL, read_shared, &reads[i]) == 0);
    }
    for (i = 0; i < THREADS; i++) {
        CHECK(pthread_create(&threads[i], NULL, drive_shared, &numbers[i]) == 0);
    }
    for (i = 0; i < THREADS; i++) {
        CHECK(pthread_join(threads[i], NULL) == 0);
        pushes += pushed[i];
        steps += stepped[i];
    }
    for (i = 0; i < READERS; i++) {
        CHECK(pthread_join(readers[i], NULL) == 0);
    }
    /* Each sample went in once and each interval was flown once, whoever did it. */
    CHECK(pushes == SCENE_COUNT && steps == STEPS);
    found[0][0].struct_size = sizeof found[0][0];
    CHECK(sins_get_record(shared, &found[0][0]) == SINS_OK);
    CHECK(memcmp(&found[0][0], &expected[0][STEPS - 1], sizeof found[0][0]) == 0);
    CHECK(sins_destroy(shared) == SINS_OK);
    printf("threads: %d in parallel and %d on one handle are bit-equal to serial, %ld reads meanwhile\n", THREADS, THREADS,
           reads[0] + reads[1]);
    return 0;
}
