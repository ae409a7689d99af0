/* Deliberate mistakes of a host that the tools must find. They show that the tools look into the library. Argument: overrun,
 * uninitialized or race. */

#include <pthread.h>
#include <stdlib.h>
#include <string.h>

#include "scene.h"

static sins_sim *sim;
static sins_navigation truth;

static void *read_truth(void *unused)
{
    (void)unused;
    CHECK(sins_get_truth(sim, &truth) == SINS_OK);
    return NULL;
}

int main(int count, char **arguments)
{
    const char *mistake = count == 2 ? arguments[1] : "";
    sim = scene_simulator(NULL, 0);
    if (strcmp(mistake, "overrun") == 0) {
        /* One byte less than the stated size. */
        sins_gyro_params gyro = scene_gyro(), *shorter = malloc(sizeof gyro - 1);
        memcpy(shorter, &gyro, sizeof gyro - 1);
        sins_set_gyro(sim, shorter);
        free(shorter);
    } else if (strcmp(mistake, "uninitialized") == 0) {
        sins_gyro_params *filled = malloc(sizeof *filled);
        filled->struct_size = sizeof *filled;
        filled->reserved = 0;
        sins_set_gyro(sim, filled);
        free(filled);
    } else if (strcmp(mistake, "race") == 0) {
        /* Two threads, one output. */
        pthread_t threads[2];
        sins_flight_sample sample = {.struct_size = sizeof sample};
        truth.struct_size = sizeof truth;
        CHECK(sins_push_sample(sim, &sample) == SINS_OK);
        CHECK(pthread_create(&threads[0], NULL, read_truth, NULL) == 0);
        CHECK(pthread_create(&threads[1], NULL, read_truth, NULL) == 0);
        truth.latitude_rad = 1.0;
        CHECK(pthread_join(threads[0], NULL) == 0 && pthread_join(threads[1], NULL) == 0);
    } else {
        return 2;
    }
    CHECK(sins_destroy(sim) == SINS_OK);
    return 0;
}
