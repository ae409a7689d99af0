/* A panic is injected into a call: the handle returns SINS_ERROR_INTERNAL from then on, other handles fly to the same bits,
 * nothing is printed, nothing leaks, and the library can still be unloaded. Argument: a second copy of the library. */

#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>
#include <string.h>

#include "allocator.h"
#include "every_call.h"

/* A function of a library that was built with --cfg sins_fault_injection. */
sins_status sins_inject_panic(sins_sim *sim);

enum { THREADS = 8 };

static sins_flight_sample samples[SCENE_COUNT];
static sins_record expected[SCENE_COUNT - 1], found[SCENE_COUNT - 1];

static void every_call_is_refused(sins_sim *sim)
{
    sins_status defect = SINS_ERROR_INTERNAL;
    char text[100];
    every_call(sim, every_answer_is, &defect);
    CHECK(sins_last_error(sim, text, sizeof text, NULL) == SINS_OK && strstr(text, "defect") != NULL);
}

static sins_sim *break_one(void)
{
    sins_sim *sim = scene_simulator(NULL, 2);
    CHECK(sins_push_sample(sim, &samples[0]) == SINS_OK && sins_push_sample(sim, &samples[1]) == SINS_OK);
    CHECK(sins_inject_panic(sim) == SINS_ERROR_INTERNAL);
    return sim;
}

static void *break_many(void *unused)
{
    int i;
    (void)unused;
    for (i = 0; i < 10; i++) {
        sins_sim *sim = break_one();
        CHECK(sins_inject_panic(NULL) == SINS_ERROR_INTERNAL);
        CHECK(sins_step(sim) == SINS_ERROR_INTERNAL);
        CHECK(sins_destroy(sim) == SINS_OK);
    }
    return NULL;
}

/* A separate copy of the library panics and is unloaded. */
static void unload_after_a_panic(const char *path)
{
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    sins_status (*inject)(sins_sim *) = NULL;
    CHECK(library != NULL);
    *(void **)&inject = dlsym(library, "sins_inject_panic");
    CHECK(inject != NULL && inject != sins_inject_panic && inject(NULL) == SINS_ERROR_INTERNAL);
    CHECK(dlclose(library) == 0);
    CHECK(dlopen(path, RTLD_NOW | RTLD_NOLOAD) == NULL);
}

int main(int count, char **arguments)
{
    pthread_t threads[THREADS];
    sins_sim *good, *broken;
    long living;
    int i;

    CHECK(count == 2);
    scene_samples(samples);
    good = scene_simulator(NULL, 1);
    scene_fly(good, samples, expected);
    CHECK(sins_reset(good) == SINS_OK);

    broken = break_one();
    every_call_is_refused(broken);
    CHECK(sins_destroy(broken) == SINS_OK);
    CHECK(sins_destroy(broken) == SINS_ERROR_BAD_HANDLE);
    CHECK(sins_inject_panic(NULL) == SINS_ERROR_INTERNAL);

    living = allocator_living;
    for (i = 0; i < 10; i++) {
        CHECK(sins_destroy(break_one()) == SINS_OK);
    }
    CHECK(allocator_living == living);

    for (i = 0; i < THREADS; i++) {
        CHECK(pthread_create(&threads[i], NULL, break_many, NULL) == 0);
    }
    scene_fly(good, samples, found);
    for (i = 0; i < THREADS; i++) {
        CHECK(pthread_join(threads[i], NULL) == 0);
    }
    CHECK(memcmp(expected, found, sizeof expected) == 0);
    CHECK(sins_destroy(good) == SINS_OK);

    unload_after_a_panic(arguments[1]);
    printf("panic: caught, told, and the matter of one handle\n");
    return 0;
}
