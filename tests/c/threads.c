/* One handle from eight threads, eight handles in parallel, a handle destroyed under its users. */

#include <pthread.h>
#include <string.h>

#include "check.h"
#include "sins.h"

enum { THREADS = 8, STEPS = 4000 };

static sins_sim *shared;

static sins_flight_sample sample_at(int k)
{
    sins_flight_sample sample = {.struct_size = sizeof sample};
    sample.time_s = k / 128.0;
    sample.latitude_rad = 0.5;
    sample.heading_rad = 0.01 * k;
    return sample;
}

static sins_sim *make(unsigned seed)
{
    sins_options options = {.struct_size = sizeof options};
    sins_gyro_params gyro = {.struct_size = sizeof gyro};
    sins_sim *sim = NULL;
    options.seed = seed;
    CHECK(sins_create(&options, &sim) == SINS_OK);
    CHECK(sins_gyro_preset(SINS_GRADE_PAPER_SIMULATION2, &gyro) == SINS_OK);
    CHECK(sins_set_gyro(sim, &gyro) == SINS_OK);
    return sim;
}

static void fly(sins_sim *sim)
{
    int k;
    for (k = 0; k <= STEPS; k++) {
        sins_flight_sample sample = sample_at(k);
        CHECK(sins_push_sample(sim, &sample) == SINS_OK);
        CHECK(sins_step(sim) == (k == 0 ? SINS_NEED_SAMPLE : SINS_OK));
    }
}

static void *fly_own(void *result)
{
    sins_navigation *navigation = result;
    sins_sim *sim = make(5);
    fly(sim);
    navigation->struct_size = sizeof *navigation;
    CHECK(sins_get_navigation(sim, navigation) == SINS_OK);
    CHECK(sins_destroy(sim) == SINS_OK);
    return NULL;
}

/* Reads while the worker steps: each read is of one instant, and time never runs back. */
static void *read_shared(void *unused)
{
    double last = -1.0;
    int reads;
    (void)unused;
    for (reads = 0; reads < STEPS; reads++) {
        sins_navigation truth = {.struct_size = sizeof truth};
        sins_errors errors = {.struct_size = sizeof errors};
        sins_status status = sins_get_truth(shared, &truth);
        if (status == SINS_ERROR_BAD_HANDLE) {
            break; /* destroyed meanwhile, and said so */
        }
        CHECK(status == SINS_OK || status == SINS_NEED_SAMPLE);
        if (status == SINS_OK) {
            CHECK(truth.time_s >= last);
            CHECK(truth.latitude_rad == 0.5 && truth.velocity_enu_m_s[0] == 0.0);
            last = truth.time_s;
            status = sins_get_errors(shared, SINS_ERRORS_NAVIGATION, &errors);
            CHECK(status == SINS_ERROR_BAD_HANDLE || (status == SINS_OK && errors.time_s >= last));
        }
    }
    return NULL;
}

int main(void)
{
    pthread_t threads[THREADS];
    sins_navigation expected = {.struct_size = sizeof expected}, results[THREADS];
    int i;

    fly_own(&expected);
    memset(results, 0, sizeof results);
    for (i = 0; i < THREADS; i++) {
        CHECK(pthread_create(&threads[i], NULL, fly_own, &results[i]) == 0);
    }
    for (i = 0; i < THREADS; i++) {
        CHECK(pthread_join(threads[i], NULL) == 0);
        CHECK(memcmp(&results[i], &expected, sizeof expected) == 0);
    }

    shared = make(5);
    for (i = 0; i < THREADS; i++) {
        CHECK(pthread_create(&threads[i], NULL, read_shared, NULL) == 0);
    }
    fly(shared);
    CHECK(sins_get_navigation(shared, &results[0]) == SINS_OK);
    CHECK(memcmp(&results[0], &expected, sizeof expected) == 0);
    CHECK(sins_destroy(shared) == SINS_OK);
    for (i = 0; i < THREADS; i++) {
        CHECK(pthread_join(threads[i], NULL) == 0);
    }
    CHECK(sins_destroy(shared) == SINS_ERROR_BAD_HANDLE);
    printf("threads: parallel handles are bit-equal, a shared one is serialised\n");
    return 0;
}
