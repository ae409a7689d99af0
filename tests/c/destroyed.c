/* Handles destroyed during use: threads call every function on a handle while another thread destroys the handle. Before, each
 * call works normally; afterwards, each call returns SINS_ERROR_BAD_HANDLE. */

#define _XOPEN_SOURCE 600
#include <pthread.h>
#include <string.h>

#include "every_call.h"

enum { USERS = 3, ROUNDS = 300 };

static sins_sim *sim, *kept;
static sins_flight *flight;
static sins_ensemble *ensemble;
static sins_unit *unit;
static pthread_barrier_t barrier;

/* The state of a handle as its user sees it. */
typedef struct {
    int gone;
    long calls;
} view;

/* Other users' calls come between, so a call may also be too early, too late, or one too many. No run has diverged, so
 * sins_ensemble_get_diverged() has no valid index, and the arrays of every_call.h have less room than the ensemble has runs. */
static void allowed(const char *call, sins_status status, void *context)
{
    view *seen = context;
    int good = status == SINS_OK || status == SINS_NEED_SAMPLE || status == SINS_ERROR_BAD_STATE ||
               status == SINS_ERROR_TIME_ORDER || status == SINS_ERROR_QUEUE_FULL ||
               (status == SINS_ERROR_INVALID_ARGUMENT && strstr(call, "sins_ensemble_get_diverged") == call) ||
               (status == SINS_ERROR_BUFFER_TOO_SMALL && strstr(call, "sins_ensemble_get_all_errors") == call);
    if (status == SINS_ERROR_BAD_HANDLE) {
        seen->gone = 1;
    } else if (!good || seen->gone) {
        fprintf(stderr, "%s gives %d%s\n", call, (int)status, seen->gone ? " from beyond" : "");
        CHECK(!"a right answer");
    }
    seen->calls++;
}

static void *use(void *calls)
{
    int round;
    for (round = 0; round < ROUNDS; round++) {
        view of_sim = {0, 0}, of_flight = {0, 0}, of_ensemble = {0, 0}, of_unit = {0, 0};
        char text[200];
        pthread_barrier_wait(&barrier);
        while (!of_sim.gone || !of_flight.gone || !of_ensemble.gone || !of_unit.gone) {
            sins_status status;
            every_call(sim, allowed, &of_sim);
            every_flight_call(flight, allowed, &of_flight);
            every_ensemble_call(ensemble, allowed, &of_ensemble);
            every_unit_call(unit, kept, allowed, &of_unit);
            status = sins_last_error(sim, text, sizeof text, NULL);
            CHECK(status == SINS_ERROR_BAD_HANDLE || (status == SINS_OK && !of_sim.gone));
        }
        *(long *)calls += of_sim.calls + of_flight.calls + of_ensemble.calls + of_unit.calls;
        CHECK(sins_destroy(sim) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_flight_destroy(flight) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_ensemble_destroy(ensemble) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_unit_destroy(unit) == SINS_ERROR_BAD_HANDLE);
        pthread_barrier_wait(&barrier);
    }
    return NULL;
}

int main(void)
{
    pthread_t users[USERS];
    long calls[USERS] = {0};
    int round, i;
    kept = scene_simulator(NULL, 2);
    CHECK(pthread_barrier_init(&barrier, NULL, USERS + 1) == 0);
    for (i = 0; i < USERS; i++) {
        CHECK(pthread_create(&users[i], NULL, use, &calls[i]) == 0);
    }
    for (round = 0; round < ROUNDS; round++) {
        volatile int wait;
        sim = scene_simulator(NULL, 1);
        flight = scene_flight();
        ensemble = scene_ensemble();
        unit = scene_unit();
        pthread_barrier_wait(&barrier);
        for (wait = 0; wait < 1000 * (round % 20); wait++) {
        }
        CHECK(sins_destroy(sim) == SINS_OK);
        CHECK(sins_flight_destroy(flight) == SINS_OK);
        CHECK(sins_ensemble_destroy(ensemble) == SINS_OK);
        CHECK(sins_unit_destroy(unit) == SINS_OK);
        pthread_barrier_wait(&barrier);
    }
    for (i = 0; i < USERS; i++) {
        CHECK(pthread_join(users[i], NULL) == 0);
        calls[0] += i > 0 ? calls[i] : 0;
    }
    CHECK(sins_destroy(kept) == SINS_OK);
    printf("destroyed: %d handles of each kind under %ld calls\n", ROUNDS, calls[0]);
    return 0;
}
