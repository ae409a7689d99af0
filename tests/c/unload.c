/* The library is loaded at run time: two copies of it side by side, and rounds of load, work on two threads, unload. After each
 * round, memory and mappings are the same as before, and the host can fork. On Windows, where the library stays, the number of
 * TLS indexes is the same as before. Arguments: two copies of the library. */

#define _GNU_SOURCE
#include <fcntl.h>
#include <pthread.h>
#include <string.h>
#include <unistd.h>

#if defined(_WIN32)
#include "tls_indexes_left.h"
#else
#include "allocator.h"
#include <sys/wait.h>
#endif
#include "../../c_examples/sins_loader.h"
#include "check.h"

/* The copy in use, under the functions' own names for the code below. */
static sins_loader in_use;

#define sins_create in_use.sins_create
#define sins_destroy in_use.sins_destroy
#define sins_last_error in_use.sins_last_error
#define sins_set_gyro in_use.sins_set_gyro
#define sins_set_accel in_use.sins_set_accel
#define sins_set_altimeter in_use.sins_set_altimeter
#define sins_set_initial_errors in_use.sins_set_initial_errors
#define sins_push_sample in_use.sins_push_sample
#define sins_run in_use.sins_run
#define sins_step in_use.sins_step
#define sins_flight_create in_use.sins_flight_create
#define sins_flight_sample_at in_use.sins_flight_sample_at
#define sins_flight_destroy in_use.sins_flight_destroy
#define sins_recommend in_use.sins_recommend

#include "scene.h"

enum { COPIES = 2 };

static sins_flight_sample samples[SCENE_COUNT];
static sins_record expected[SCENE_COUNT - 1], found[COPIES][SCENE_COUNT - 1];

static void load(const char *path)
{
    char message[1000];
    if (!sins_loader_open(&in_use, path, message, sizeof message)) {
        fprintf(stderr, "%s\n", message);
        exit(1);
    }
}

/* Work of every kind: flights, sensors, records, a sentence of this thread, a recommendation. */
static void work(sins_record records[SCENE_COUNT - 1])
{
    sins_sim *sim = NULL;
    sins_flight *flight = NULL;
    sins_flight_sample sample = {.struct_size = sizeof sample};
    sins_options options = {.struct_size = sizeof options};
    sins_requirement requirement = {.struct_size = sizeof requirement, .position_m = 10.0};
    sins_cost cost = {.struct_size = sizeof cost};
    char text[200];
    CHECK(sins_create(&options, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_last_error(NULL, text, sizeof text, NULL) == SINS_OK && strstr(text, "sim") == text);
    flight = scene_flight();
    CHECK(sins_flight_sample_at(flight, scene_time(7), &sample) == SINS_OK && sins_flight_destroy(flight) == SINS_OK);
    CHECK(memcmp(&sample, &samples[7], sizeof sample) == 0);
    sim = scene_simulator(NULL, 4);
    scene_fly(sim, samples, records);
    CHECK(sins_recommend(sim, samples, 129, &requirement, &options, &cost) == SINS_OK);
    CHECK(sins_destroy(sim) == SINS_OK);
}

/* Two copies: each has its own handles, and one continues to work when the other is unloaded. */
static void side_by_side(char *const paths[COPIES])
{
    sins_loader copies[COPIES];
    sins_sim *sims[COPIES];
    sins_flight *flights[COPIES];
    int i;
    for (i = 0; i < COPIES; i++) {
        load(paths[i]);
        copies[i] = in_use;
        scene_samples(samples);
        work(found[i]);
        sims[i] = scene_simulator(NULL, 4);
        flights[i] = scene_flight();
    }
    CHECK(copies[0].library != copies[1].library);
    CHECK(memcmp(found[0], found[1], sizeof found[0]) == 0);
    memcpy(expected, found[0], sizeof expected);
    for (i = 0; i < COPIES; i++) {
        in_use = copies[i];
        CHECK(sins_step(sims[1 - i]) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_destroy(sims[1 - i]) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_flight_destroy(flights[1 - i]) == SINS_ERROR_BAD_HANDLE);
    }
    for (i = 0; i < COPIES; i++) {
        in_use = copies[i];
        CHECK(sins_destroy(sims[i]) == SINS_OK && sins_flight_destroy(flights[i]) == SINS_OK);
        work(found[i]);
        CHECK(memcmp(found[i], expected, sizeof expected) == 0);
        CHECK(sins_loader_close(&in_use));
    }
}

#if defined(_WIN32)

/* More rounds than TLS indexes exist, with work in some rounds. */
enum { ROUNDS = 2000, IDLE_ROUNDS = 19 };

static long allocator_calls; /* not counted on Windows */

static void leaves_nothing(int round)
{
    static int before;
    int left = tls_indexes_left();
    if (round == 0) {
        before = left;
    }
    if (left != before) {
        fprintf(stderr, "round %d: %d TLS indexes left, %d before\n", round, left, before);
    }
    CHECK(left == before);
}

#else

enum { ROUNDS = 100, IDLE_ROUNDS = 0, MAPPINGS_SIZE = 1 << 16 };

/* The memory mappings except for heap and stack, as text. Reads them without the allocator. */
static void mappings(char text[MAPPINGS_SIZE])
{
    static char whole[MAPPINGS_SIZE];
    size_t length = 0;
    ssize_t piece;
    char *line, *rest = whole;
    int file = open("/proc/self/maps", O_RDONLY);
    CHECK(file >= 0);
    while ((piece = read(file, whole + length, sizeof whole - 1 - length)) > 0) {
        length += (size_t)piece;
    }
    CHECK(piece == 0 && length < sizeof whole - 1 && close(file) == 0);
    whole[length] = '\0';
    text[0] = '\0';
    while ((line = strsep(&rest, "\n")) != NULL) {
        if (strstr(line, "[heap]") == NULL && strstr(line, "[stack]") == NULL) {
            strcat(strcat(text, line), "\n");
        }
    }
}

/* Whether a child process starts and ends. Nothing of the unloaded library may be called in it. */
static int can_fork(void)
{
    int status;
    pid_t child = fork();
    if (child == 0) {
        _exit(0);
    }
    return child > 0 && waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

static void leaves_nothing(int round)
{
    static char before[MAPPINGS_SIZE], after[MAPPINGS_SIZE];
    static long living;
    mappings(after);
    CHECK(strstr(after, "libsins") == NULL);
    /* The loader's lists and the arena of the visiting thread are created in the first rounds. */
    if (round < 2) {
        memcpy(before, after, sizeof before);
        living = allocator_living;
    }
    if (strcmp(before, after) != 0 || living != allocator_living) {
        fprintf(stderr, "round %d: %ld blocks, %ld before; before:\n%safter:\n%s", round, allocator_living, living, before,
                after);
    }
    CHECK(strcmp(before, after) == 0 && living == allocator_living);
    CHECK(can_fork());
}

#endif

/* A thread that outlives the library in every round. */
static pthread_barrier_t barrier;
static sins_sim *visited;

static void *visit(void *unused)
{
    int round;
    (void)unused;
    for (round = 0; round < ROUNDS; round++) {
        long calls;
        pthread_barrier_wait(&barrier); /* loaded */
        /* A thread's first calls on a simulator do not allocate, like the later ones; the loader does not allocate either. */
        calls = allocator_calls;
        CHECK(sins_push_sample(visited, &samples[0]) == SINS_OK && sins_step(visited) == SINS_NEED_SAMPLE);
        CHECK(sins_push_sample(visited, &samples[1]) == SINS_OK && sins_step(visited) == SINS_OK);
        CHECK(sins_push_sample(visited, &samples[1]) == SINS_ERROR_TIME_ORDER);
        CHECK(allocator_calls == calls);
        if (round % (1 + IDLE_ROUNDS) == 0) {
            work(found[1]);
        }
        pthread_barrier_wait(&barrier); /* done */
    }
    return NULL;
}

int main(int count, char **paths)
{
    pthread_t visitor;
    sins_sim *earlier = NULL;
    int round;

    CHECK(count == 1 + COPIES);
    side_by_side(paths + 1);

    CHECK(pthread_barrier_init(&barrier, NULL, 2) == 0);
    CHECK(pthread_create(&visitor, NULL, visit, NULL) == 0);
    for (round = 0; round < ROUNDS; round++) {
        load(paths[1]);
        CHECK(sins_create(NULL, &visited) == SINS_OK);
        pthread_barrier_wait(&barrier);
        if (round % (1 + IDLE_ROUNDS) == 0) {
            work(found[0]);
        }
        pthread_barrier_wait(&barrier);
        CHECK(memcmp(found[0], expected, sizeof expected) == 0 && memcmp(found[1], expected, sizeof expected) == 0);
        CHECK(sins_destroy(visited) == SINS_OK);

        /* A handle of an unloaded library is invalid in the next one. */
        CHECK(sins_destroy(earlier) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_create(NULL, &earlier) == SINS_OK);
        CHECK(sins_destroy(earlier) == SINS_OK);
        CHECK(sins_create(NULL, &earlier) == SINS_OK);
        CHECK(sins_destroy(earlier) == SINS_OK);
        CHECK(sins_loader_close(&in_use));
        leaves_nothing(round);
    }
    CHECK(pthread_join(visitor, NULL) == 0);
    printf("unload: two copies side by side, %d rounds of load and unload leave nothing\n", round);
    return 0;
}
