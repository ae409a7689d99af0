/* Samples of a turn at 200 m/s and 100 Hz, and a simulator for them with sensors of a grade. */

#ifndef TURN_H
#define TURN_H

#include "check.h"
#include "sins_flight.h"

static void make_samples(sins_flight_sample *samples, int count)
{
    sins_flight_start start = {.struct_size = sizeof start};
    sins_manoeuvre turn = {.struct_size = sizeof turn};
    sins_flight *flight = NULL;
    int k;
    start.speed_m_s = 200.0;
    turn.kind = SINS_MANOEUVRE_TURN;
    turn.heading_change_rad = 2.0;
    turn.bank_rad = 0.6;
    CHECK(sins_flight_create(&start, &turn, 1, &flight) == SINS_OK);
    for (k = 0; k < count; k++) {
        samples[k].struct_size = sizeof samples[k];
        CHECK(sins_flight_sample_at(flight, k * 0.01, &samples[k]) == SINS_OK);
    }
    CHECK(sins_flight_destroy(flight) == SINS_OK);
}

static inline sins_sim *make_simulator(const sins_options *options, int32_t grade)
{
    sins_gyro_params gyro = {.struct_size = sizeof gyro};
    sins_accel_params accel = {.struct_size = sizeof accel};
    sins_sim *sim = NULL;
    CHECK(sins_create(options, &sim) == SINS_OK);
    CHECK(sins_gyro_preset(grade, &gyro) == SINS_OK);
    CHECK(sins_accel_preset(grade, &accel) == SINS_OK);
    CHECK(sins_set_gyro(sim, &gyro) == SINS_OK);
    CHECK(sins_set_accel(sim, &accel) == SINS_OK);
    return sim;
}

#endif
