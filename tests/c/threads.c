/* Eight simulators and eight ensembles in parallel give the same bits as in series. One simulator and one ensemble that eight
 * threads drive at once fly as with one thread. Other threads read complete instants of this flight, in order. */

#define _XOPEN_SOURCE 600
#include <pthread.h>
#include <sched.h>
#include <string.h>

#include "scene.h"

enum { THREADS = 8, READERS = 2, STEPS = SCENE_COUNT - 1 };

static sins_flight_sample samples[SCENE_COUNT];

/* Records of the serial flights and of the parallel ones, each with its own seed. */
static sins_record expected[THREADS][STEPS], found[THREADS][STEPS];

/* Statistics at the end of the serial and of the parallel ensembles. The runs of thread i begin at number i. */
static sins_statistics expected_end[THREADS], found_end[THREADS];

static sins_ensemble *ensemble_from(int first_run)
{
    sins_sim *sim = scene_simulator(NULL, 0);
    sins_ensemble *ensemble = NULL;
    CHECK(sins_ensemble_create(sim, (uint64_t)first_run, SCENE_RUNS, &ensemble) == SINS_OK);
    CHECK(sins_destroy(sim) == SINS_OK);
    return ensemble;
}

static void get_end(sins_ensemble *ensemble, sins_statistics *end)
{
    SINS_INIT(*end);
    CHECK(sins_ensemble_get_statistics(ensemble, SINS_ERRORS_NAVIGATION, end) == SINS_OK);
    CHECK(sins_ensemble_destroy(ensemble) == SINS_OK);
}

static void *fly_own(void *number)
{
    int i = *(int *)number;
    sins_sim *sim = scene_simulator(NULL, (unsigned)i);
    sins_ensemble *ensemble = ensemble_from(i);
    scene_fly(sim, samples, found[i]);
    CHECK(sins_destroy(sim) == SINS_OK);
    CHECK(sins_ensemble_run(ensemble, samples, SCENE_COUNT) == SINS_OK);
    get_end(ensemble, &found_end[i]);
    return NULL;
}

static sins_sim *shared;
static sins_ensemble *shared_ensemble; /* its run 0 is `shared` */

static sins_status push(int to_ensemble, const sins_flight_sample *sample)
{
    return to_ensemble ? sins_ensemble_push_sample(shared_ensemble, sample) : sins_push_sample(shared, sample);
}

static sins_status step(int of_ensemble)
{
    return of_ensemble ? sins_ensemble_step(shared_ensemble) : sins_step(shared);
}

/* Counts of each thread, for the simulator and for the ensemble. */
static long pushed[THREADS][2], stepped[THREADS][2];

/* Pushes each sample that no other thread has pushed before, and steps. */
static void *drive_shared(void *number)
{
    int i = *(int *)number, k[2] = {0, 0}, which;
    while (k[0] < SCENE_COUNT || k[1] < SCENE_COUNT) {
        for (which = 0; which < 2; which++) {
            sins_status status;
            if (k[which] < SCENE_COUNT) {
                status = push(which, &samples[k[which]]);
                CHECK(status == SINS_OK || status == SINS_ERROR_TIME_ORDER || status == SINS_ERROR_QUEUE_FULL);
                pushed[i][which] += status == SINS_OK;
                k[which] += status != SINS_ERROR_QUEUE_FULL;
            }
            status = step(which);
            CHECK(status == SINS_OK || status == SINS_NEED_SAMPLE);
            stepped[i][which] += status == SINS_OK;
        }
        if (k[0] % 16 == i) {
            sched_yield();
        }
    }
    for (which = 0; which < 2; which++) {
        sins_status status;
        while ((status = step(which)) == SINS_OK) {
            stepped[i][which]++;
        }
        CHECK(status == SINS_NEED_SAMPLE);
    }
    return NULL;
}

/* Number of intervals flown at a time that was read. It never decreases. */
static size_t flown_at(double time_s, size_t last)
{
    size_t flown = (size_t)(time_s * 128.0);
    CHECK(flown >= last && flown <= STEPS);
    return flown;
}

/* Each record equals one of the serial flight, and the errors of run 0 equal those of such a record. */
static void *read_shared(void *reads)
{
    size_t last = 0, last_of_run = 0;
    while (last < STEPS || last_of_run < STEPS) {
        sins_errors errors = {.struct_size = sizeof errors};
        const sins_record_errors *same;
        sins_record record = {.struct_size = sizeof record};
        sins_status status = sins_get_record(shared, &record);
        CHECK(status == SINS_OK || status == SINS_NEED_SAMPLE);
        if (status == SINS_OK && record.time_s > 0.0) {
            last = flown_at(record.time_s, last);
            CHECK(memcmp(&record, &expected[0][last - 1], sizeof record) == 0);
            ++*(long *)reads;
        }
        status = sins_ensemble_get_errors(shared_ensemble, 0, SINS_ERRORS_NAVIGATION, &errors);
        CHECK(status == SINS_OK || status == SINS_NEED_SAMPLE);
        if (status == SINS_OK && errors.time_s > 0.0) {
            last_of_run = flown_at(errors.time_s, last_of_run);
            same = &expected[0][last_of_run - 1].navigation_errors;
            CHECK(memcmp(errors.position_enu_m, same->position_enu_m, sizeof same->position_enu_m) == 0);
            CHECK(memcmp(errors.misalignment_enu_rad, same->misalignment_enu_rad, sizeof same->misalignment_enu_rad) == 0);
            ++*(long *)reads;
        }
    }
    return NULL;
}

int main(void)
{
    pthread_t threads[THREADS], readers[READERS];
    int numbers[THREADS], i, which;
    long reads[READERS] = {0}, pushes[2] = {0, 0}, steps[2] = {0, 0};

    scene_samples(samples);
    for (i = 0; i < THREADS; i++) {
        numbers[i] = i;
        fly_own(&numbers[i]);
    }
    memcpy(expected, found, sizeof expected);
    memcpy(expected_end, found_end, sizeof expected_end);
    CHECK(memcmp(expected[0], expected[1], sizeof expected[0]) != 0);
    CHECK(memcmp(&expected_end[0], &expected_end[1], sizeof expected_end[0]) != 0);
    memset(found, 0, sizeof found);
    memset(found_end, 0, sizeof found_end);
    for (i = 0; i < THREADS; i++) {
        CHECK(pthread_create(&threads[i], NULL, fly_own, &numbers[i]) == 0);
    }
    for (i = 0; i < THREADS; i++) {
        CHECK(pthread_join(threads[i], NULL) == 0);
    }
    CHECK(memcmp(expected, found, sizeof expected) == 0);
    CHECK(memcmp(expected_end, found_end, sizeof expected_end) == 0);

    shared = scene_simulator(NULL, 0);
    shared_ensemble = ensemble_from(0);
    for (i = 0; i < READERS; i++) {
        CHECK(pthread_create(&readers[i], NULL, read_shared, &reads[i]) == 0);
    }
    for (i = 0; i < THREADS; i++) {
        CHECK(pthread_create(&threads[i], NULL, drive_shared, &numbers[i]) == 0);
    }
    for (i = 0; i < THREADS; i++) {
        CHECK(pthread_join(threads[i], NULL) == 0);
        for (which = 0; which < 2; which++) {
            pushes[which] += pushed[i][which];
            steps[which] += stepped[i][which];
        }
    }
    for (i = 0; i < READERS; i++) {
        CHECK(pthread_join(readers[i], NULL) == 0);
    }
    /* Each sample was pushed once and each interval was flown once, by any of the threads. */
    for (which = 0; which < 2; which++) {
        CHECK(pushes[which] == SCENE_COUNT && steps[which] == STEPS);
    }
    get_end(shared_ensemble, &found_end[0]);
    CHECK(memcmp(&found_end[0], &expected_end[0], sizeof found_end[0]) == 0);
    found[0][0].struct_size = sizeof found[0][0];
    CHECK(sins_get_record(shared, &found[0][0]) == SINS_OK);
    CHECK(memcmp(&found[0][0], &expected[0][STEPS - 1], sizeof found[0][0]) == 0);
    CHECK(sins_destroy(shared) == SINS_OK);
    printf("threads: %d in parallel and %d on one simulator and one ensemble are bit-equal to serial, %ld reads meanwhile\n", THREADS,
           THREADS, reads[0] + reads[1]);
    return 0;
}
