/* Which effects matter? The flight is five minutes of manoeuvres, with tactical sensors, a boresight error of an arc minute and a
 * deflection of the vertical. The program prints the contribution of each error. It marks the errors that can be left out if a
 * change of the position error by 10 m is tolerated. A host uses its own flight and its own sensors instead. */

#include <stdio.h>
#include <stdlib.h>

#include "sins_analysis.h"
#include "sins_flight.h"

#define RATE_HZ 50
#define FLIGHT_S 300
#define COUNT ((size_t)RATE_HZ * FLIGHT_S + 1)

/* Prints why a call failed: the library keeps the sentence with the simulator of the call, or, for NULL, with the thread. */
static sins_status checked(sins_status status, const sins_sim *sim)
{
    char sentence[512] = "";

    if (status < 0) {
        sins_last_error(sim, sentence, sizeof sentence, NULL);
        fprintf(stderr, "budget: %s\n", sentence);
    }
    return status;
}

/* Turns to the left and to the right. */
static sins_status make_flight(sins_flight **flight)
{
    sins_flight_start start;
    sins_manoeuvre weave;

    SINS_INIT(start);
    SINS_INIT(weave);
    start.latitude_rad = 47.0 * SINS_DEG;
    start.height_m = 3000.0;
    start.speed_m_s = 120.0;
    weave.kind = SINS_MANOEUVRE_S_TURN;
    weave.duration_s = FLIGHT_S;
    weave.heading_change_rad = 60.0 * SINS_DEG;
    weave.turns = 2.0;
    weave.ramp_s = 10.0;
    return checked(sins_flight_create(&start, &weave, 1, flight), NULL);
}

/* The simulator that the host flies, with all its errors. */
static sins_status configure(sins_sim **sim)
{
    sins_options options;
    sins_gyro_params gyro;
    sins_accel_params accel;
    sins_mounting mounting;
    sins_gravity_params gravity;
    sins_status status;

    SINS_INIT(options); /* a host uses its own options; here: the defaults, at 50 Hz */
    options.sample_period_s = 1.0 / RATE_HZ;
    SINS_INIT(gyro);
    SINS_INIT(accel);
    status = checked(sins_gyro_preset(SINS_GRADE_TACTICAL, &gyro), NULL);
    if (status == SINS_OK) {
        status = checked(sins_accel_preset(SINS_GRADE_TACTICAL, &accel), NULL);
    }
    gyro.scale_factor[2] = 150.0 * SINS_PPM;
    accel.misalignment_rad[2] = 1.0 * SINS_ARCSEC;
    SINS_INIT(mounting);
    mounting.lever_arm_m[1] = 3.0;
    mounting.boresight_error_rad[2] = 1.0 * SINS_ARCMIN;
    SINS_INIT(gravity);
    gravity.deflection_north_rad = 5.0 * SINS_ARCSEC;
    if (status == SINS_OK) {
        status = checked(sins_create(&options, sim), NULL);
    }
    if (status == SINS_OK) {
        status = checked(sins_set_gyro(*sim, &gyro), *sim);
    }
    if (status == SINS_OK) {
        status = checked(sins_set_accel(*sim, &accel), *sim);
    }
    if (status == SINS_OK) {
        status = checked(sins_set_mounting(*sim, &mounting), *sim);
    }
    return status == SINS_OK ? checked(sins_set_gravity_disturbance(*sim, &gravity), *sim) : status;
}

static sins_status ask(const sins_flight_sample *samples)
{
    sins_sim *sim = NULL;
    sins_budget_request request;
    sins_budget_row rows[16];
    sins_budget budget;
    size_t count = 0, k;
    sins_status status = configure(&sim);

    SINS_INIT(request);
    request.time_steps = 1;
    request.position_m = 10.0;
    SINS_INIT(budget);
    SINS_INIT(rows[0]); /* struct_size of the first row is the distance between rows */
    if (status == SINS_OK) { /* a host passes the simulator that it flies, at any time */
        status = checked(sins_error_budget(sim, samples, COUNT, &request, rows, sizeof rows / sizeof rows[0], &count, &budget),
                         NULL);
    }
    sins_destroy(sim); /* if no handle was made, the library returns an error, which does not matter */
    if (status != SINS_OK) {
        return status;
    }
    printf("%-28s %12s %12s %12s\n", "", "m", "m/s", "rad");
    for (k = 0; k < count; k++) {
        printf("%-28s %12.3g %12.3g %12.3g%s%s\n", rows[k].effect, rows[k].position_m, rows[k].velocity_m_s,
               rows[k].attitude_rad, rows[k].flags & SINS_BUDGET_RANDOM ? " 1 sigma" : "",
               rows[k].flags & SINS_BUDGET_CAN_BE_LEFT_OUT ? ", can be left out" : "");
    }
    printf("%-28s %12.3g %12.3g %12.3g\n", "all together", budget.position_m, budget.velocity_m_s,
           budget.attitude_rad);
    printf("%-28s %12.3g %12.3g %12.3g\n", "not their sum", budget.remainder_position_m,
           budget.remainder_velocity_m_s, budget.remainder_attitude_rad);
    printf("left out: a change of %.3g m, limit %.3g m\n", budget.left_out_position_m, request.position_m);
    printf("all together is from %d runs; 95 %% interval of the random part: %.2f to %.2f times its figure\n",
           (int)budget.runs, budget.sigma_low, budget.sigma_high);
    for (k = 0; k < count; k++) {
        fprintf(stderr, "%-28s %6.0f ns a step\n", rows[k].effect, rows[k].ns_per_step);
    }
    return status;
}

int main(void)
{
    sins_flight *flight = NULL;
    sins_flight_sample *samples = (sins_flight_sample *)malloc(COUNT * sizeof *samples);
    sins_status status = SINS_ERROR_OUT_OF_MEMORY;
    size_t k;

    if (samples == NULL) {
        fprintf(stderr, "budget: no memory for the samples\n");
    } else {
        status = make_flight(&flight);
    }
    for (k = 0; status == SINS_OK && k < COUNT; k++) {
        SINS_INIT(samples[k]);
        status = checked(sins_flight_sample_at(flight, (double)k / RATE_HZ, &samples[k]), NULL);
    }
    if (status == SINS_OK) {
        status = ask(samples);
    }
    sins_flight_destroy(flight);
    free(samples);
    return status == SINS_OK ? 0 : 1;
}
