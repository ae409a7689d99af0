/* A handle that is in a call of the same thread, or in a call that will never end: further calls return SINS_ERROR_BAD_STATE
 * instead of waiting forever. Cases: signal handlers that use the handle they interrupt, siglongjmp() out of a call, fork()
 * while another thread is in a call. A thread that is cancelled within a call leaves its handle free. */

#define _GNU_SOURCE
#include <pthread.h>
#include <setjmp.h>
#include <signal.h>
#include <string.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include "every_call.h"

enum { INTERRUPTIONS = 200, FORKS = 30, CANCELLATIONS = 100, PATIENCE_S = 120 };

static sins_flight_sample samples[SCENE_COUNT];
static sins_record expected[SCENE_COUNT - 1], found[SCENE_COUNT - 1];
static sins_statistics expected_end, found_end;
static sins_sim *used, *other;
static sins_ensemble *used_ensemble;
static volatile sig_atomic_t interruptions, ensemble_interruptions;
static sigjmp_buf *volatile way_out;

/* Ends the program if it waits forever. */
static void *watch(void *unused)
{
    static const char text[] = "waits for ever\n";
    sleep(PATIENCE_S);
    _exit(write(STDERR_FILENO, text, sizeof text - 1) > 0 ? 1 : 2);
    return unused;
}

/* Whether calls on the handle return SINS_ERROR_BAD_STATE; then all functions must return it. */
static int is_held(sins_sim *sim)
{
    static const sins_status bad_state = SINS_ERROR_BAD_STATE;
    sins_options options = {.struct_size = sizeof options};
    char text[100];
    sins_status status = sins_get_options(sim, &options);
    if (status == SINS_OK) {
        return 0;
    }
    CHECK(status == SINS_ERROR_BAD_STATE);
    every_call(sim, every_answer_is, (void *)&bad_state);
    CHECK(sins_last_error(sim, text, sizeof text, NULL) == SINS_ERROR_BAD_STATE);
    CHECK(sins_destroy(sim) == SINS_ERROR_BAD_STATE);
    return 1;
}

/* Whether calls on the ensemble return SINS_ERROR_BAD_STATE; then all functions must return it. */
static int is_ensemble_held(sins_ensemble *ensemble)
{
    static const sins_status bad_state = SINS_ERROR_BAD_STATE;
    uint64_t first_run;
    size_t runs;
    sins_status status = sins_ensemble_get_runs(ensemble, &first_run, &runs);
    if (status == SINS_OK) {
        return 0;
    }
    CHECK(status == SINS_ERROR_BAD_STATE);
    every_ensemble_call(ensemble, every_answer_is, (void *)&bad_state);
    CHECK(sins_ensemble_destroy(ensemble) == SINS_ERROR_BAD_STATE);
    return 1;
}

/* A signal handler that uses the interrupted handles. Another handle works as usual. */
static void interrupt(int signal)
{
    int held = is_held(used), ensemble_held = is_ensemble_held(used_ensemble);
    (void)signal;
    interruptions += held;
    ensemble_interruptions += ensemble_held;
    if (held || ensemble_held) {
        CHECK(sins_step(other) == SINS_NEED_SAMPLE);
        if (way_out != NULL) {
            siglongjmp(*way_out, 1);
        }
    }
}

static void interrupt_every_half_millisecond(int on)
{
    struct itimerval timer;
    memset(&timer, 0, sizeof timer);
    timer.it_interval.tv_usec = timer.it_value.tv_usec = on ? 500 : 0;
    CHECK(setitimer(ITIMER_REAL, &timer, NULL) == 0);
}

static void fly_and_compare(sins_sim *sim)
{
    scene_fly(sim, samples, found);
    CHECK(memcmp(found, expected, sizeof expected) == 0);
    CHECK(sins_reset(sim) == SINS_OK);
}

static void fly_ensemble(sins_ensemble *ensemble, sins_statistics *end)
{
    SINS_INIT(*end);
    CHECK(sins_ensemble_run(ensemble, samples, SCENE_COUNT) == SINS_OK);
    CHECK(sins_ensemble_get_statistics(ensemble, SINS_ERRORS_NAVIGATION, end) == SINS_OK);
    CHECK(sins_ensemble_reset(ensemble) == SINS_OK);
}

static void fly_and_compare_ensemble(sins_ensemble *ensemble)
{
    fly_ensemble(ensemble, &found_end);
    CHECK(memcmp(&found_end, &expected_end, sizeof found_end) == 0);
}

static volatile int over;

/* Blocks or unblocks SIGALRM for this thread and for those that it creates; `how` is SIG_BLOCK or SIG_UNBLOCK. */
static void alarms(int how)
{
    sigset_t set;
    sigemptyset(&set);
    sigaddset(&set, SIGALRM);
    CHECK(pthread_sigmask(how, &set, NULL) == 0);
}

/* Reads continuously, so that the interrupted thread sometimes waits for another thread. */
static void *read_all_the_time(void *unused)
{
    alarms(SIG_BLOCK);
    while (!over) {
        sins_options options = {.struct_size = sizeof options};
        CHECK(sins_get_options(used, &options) == SINS_OK);
    }
    return unused;
}

static void signal_handlers(void)
{
    pthread_t reader;
    CHECK(pthread_create(&reader, NULL, read_all_the_time, NULL) == 0);
    interrupt_every_half_millisecond(1);
    while (interruptions < INTERRUPTIONS || ensemble_interruptions < INTERRUPTIONS) {
        fly_and_compare(used);
        fly_and_compare_ensemble(used_ensemble);
    }
    interrupt_every_half_millisecond(0);
    over = 1;
    CHECK(pthread_join(reader, NULL) == 0);
}

/* Jumps out of a call. The handle and its memory are lost. */
static void long_jump(int out_of_ensemble)
{
    sigjmp_buf buffer;
    way_out = &buffer;
    if (sigsetjmp(buffer, 1) == 0) {
        interrupt_every_half_millisecond(1);
        while (out_of_ensemble) {
            fly_ensemble(used_ensemble, &found_end);
        }
        for (;;) {
            scene_fly(used, samples, found);
            CHECK(sins_reset(used) == SINS_OK);
        }
    }
    interrupt_every_half_millisecond(0);
    way_out = NULL;
    CHECK(out_of_ensemble ? is_ensemble_held(used_ensemble) : is_held(used));
}

static sins_sim *shared;
static sins_ensemble *shared_ensemble;

static void *fly_all_the_time(void *unused)
{
    static sins_record records[SCENE_COUNT - 1];
    static sins_statistics end;
    alarms(SIG_BLOCK);
    while (!over) {
        scene_fly(shared, samples, records);
        CHECK(sins_reset(shared) == SINS_OK);
        fly_ensemble(shared_ensemble, &end);
    }
    return unused;
}

static void *fly_until_cancelled(void *sim)
{
    static sins_record records[SCENE_COUNT - 1];
    CHECK(pthread_setcanceltype(PTHREAD_CANCEL_ASYNCHRONOUS, NULL) == 0);
    for (;;) {
        size_t written;
        sins_run(sim, samples, SCENE_COUNT, 1, records, SCENE_COUNT - 1, &written);
        sins_reset(sim);
    }
}

/* A thread that can be cancelled at any instruction is cancelled within a call: the call returns first, and the handle is free. */
static void cancellations(void)
{
    sins_sim *sim = scene_simulator(NULL, 4);
    int i;
    for (i = 0; i < CANCELLATIONS; i++) {
        pthread_t flier;
        void *result;
        CHECK(pthread_create(&flier, NULL, fly_until_cancelled, sim) == 0);
        usleep(300 * (1 + i % 7));
        CHECK(pthread_cancel(flier) == 0 && pthread_join(flier, &result) == 0 && result == PTHREAD_CANCELED);
        CHECK(!is_held(sim));
    }
    CHECK(sins_reset(sim) == SINS_OK);
    fly_and_compare(sim);
    CHECK(sins_destroy(sim) == SINS_OK);
}

/* In a child, a handle that another thread of the parent was using is not available; all other handles are. Counts the forks
 * with a simulator in use and those with an ensemble in use. */
static void forks(int held[2])
{
    pthread_t flier;
    int i;
    shared = scene_simulator(NULL, 4);
    shared_ensemble = scene_ensemble();
    over = 0;
    CHECK(pthread_create(&flier, NULL, fly_all_the_time, NULL) == 0);
    for (i = 0; i < FORKS; i++) {
        int status;
        pid_t child;
        usleep(1000 * (1 + i % 3));
        child = fork();
        CHECK(child >= 0);
        if (child == 0) {
            int is = is_held(shared), is_ensemble = is_ensemble_held(shared_ensemble);
            alarm(PATIENCE_S);
            CHECK(is || sins_destroy(shared) == SINS_OK);
            CHECK(is_ensemble || sins_ensemble_destroy(shared_ensemble) == SINS_OK);
            CHECK(sins_destroy(other) == SINS_OK);
            fly_and_compare(scene_simulator(NULL, 4));
            fly_and_compare_ensemble(scene_ensemble());
            _exit(4 + is + 2 * is_ensemble);
        }
        CHECK(waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) >= 4);
        held[0] += WEXITSTATUS(status) % 2;
        held[1] += WEXITSTATUS(status) / 2 % 2;
    }
    over = 1;
    CHECK(pthread_join(flier, NULL) == 0);
    CHECK(!is_held(shared) && sins_destroy(shared) == SINS_OK);
    CHECK(!is_ensemble_held(shared_ensemble) && sins_ensemble_destroy(shared_ensemble) == SINS_OK);
}

int main(void)
{
    pthread_t watcher;
    struct sigaction action;
    sins_sim *sim;
    int held[2] = {0, 0};

    memset(&action, 0, sizeof action);
    action.sa_handler = interrupt;
    scene_samples(samples);
    used = scene_simulator(NULL, 4);
    scene_fly(used, samples, expected);
    CHECK(sins_reset(used) == SINS_OK);
    used_ensemble = scene_ensemble();
    fly_ensemble(used_ensemble, &expected_end);
    CHECK(sins_create(NULL, &other) == SINS_OK);
    alarms(SIG_BLOCK);
    CHECK(pthread_create(&watcher, NULL, watch, NULL) == 0);
    CHECK(sigaction(SIGALRM, &action, NULL) == 0);
    alarms(SIG_UNBLOCK);

    signal_handlers();
    long_jump(0);
    CHECK(sins_destroy(used) == SINS_ERROR_BAD_STATE);
    used = scene_simulator(NULL, 4);
    long_jump(1);
    CHECK(sins_destroy(used) == SINS_OK);
    sim = scene_simulator(NULL, 4);
    fly_and_compare(sim);
    CHECK(sins_destroy(sim) == SINS_OK);
    CHECK(signal(SIGALRM, SIG_DFL) != SIG_ERR);
    cancellations();
    forks(held);
    CHECK(held[0] > 0 && held[1] > 0);
    CHECK(sins_destroy(other) == SINS_OK);
    printf("reentry: %d calls from signal handlers, two jumps out of a call, %d cancellations, %d of %d forks within one: none waits\n",
           (int)(interruptions + ensemble_interruptions), CANCELLATIONS, held[0] + held[1], FORKS);
    return 0;
}
