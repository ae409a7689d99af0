/* Which options are good enough? The requirement is an error of at most 1 m in an hour, with a sensor block in the nose. The
 * program gives the library two minutes of a flight, and then flies the recommended options for the whole hour. A host gives a
 * piece of its own flight instead. */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "sins_analysis.h"
#include "sins_flight.h"

#define RATE_HZ 50
#define PIECE_S 120
#define FLIGHT_S 3600

/* Prints why a call failed: the library keeps the sentence with the simulator of the call, or, for NULL, with the thread. */
static sins_status checked(sins_status status, const sins_sim *sim)
{
    char sentence[512] = "";

    if (status < 0) {
        sins_last_error(sim, sentence, sizeof sentence, NULL);
        fprintf(stderr, "recommend: %s\n", sentence);
    }
    return status;
}

/* A weaving flight with vibration at 2 Hz. */
static sins_status make_flight(sins_flight **flight)
{
    sins_flight_start start;
    sins_manoeuvre weave;

    SINS_INIT(start);
    SINS_INIT(weave);
    start.latitude_rad = 47.0 * SINS_DEG;
    start.height_m = 3000.0;
    start.speed_m_s = 120.0;
    weave.kind = SINS_MANOEUVRE_SINUSOIDS;
    weave.duration_s = FLIGHT_S;
    weave.ramp_s = 5.0;
    weave.sinusoid_count = 3;
    weave.channel[0] = SINS_CHANNEL_COURSE;
    weave.amplitude[0] = 30.0 * SINS_DEG;
    weave.frequency_hz[0] = 1.0 / 60.0;
    weave.channel[1] = SINS_CHANNEL_ROLL;
    weave.amplitude[1] = 1.0 * SINS_DEG;
    weave.frequency_hz[1] = 2.0;
    weave.channel[2] = SINS_CHANNEL_PITCH;
    weave.amplitude[2] = 1.0 * SINS_DEG;
    weave.frequency_hz[2] = 2.0;
    weave.phase_rad[2] = 90.0 * SINS_DEG;
    return checked(sins_flight_create(&start, &weave, 1, flight), NULL);
}

/* The simulator that the host flies, with these options and its sensor block in the nose. */
static sins_status configure(const sins_options *options, sins_sim **sim)
{
    sins_mounting mounting;
    sins_status status = checked(sins_create(options, sim), NULL);

    SINS_INIT(mounting);
    mounting.lever_arm_m[1] = 3.0;
    mounting.lever_arm_m[2] = -0.8;
    return status == SINS_OK ? checked(sins_set_mounting(*sim, &mounting), *sim) : status;
}

/* The distance from the truth after the whole flight with ideal sensors. Its causes are the options, and the sample rate, which is
 * low for a vibration of 2 Hz. */
static sins_status fly(const sins_options *options, sins_flight *flight, double *distance_m)
{
    sins_sim *sim = NULL;
    sins_flight_sample sample;
    sins_errors errors;
    sins_status status = configure(options, &sim);
    long k;

    SINS_INIT(sample);
    SINS_INIT(errors);
    for (k = 0; status >= 0 && k <= (long)RATE_HZ * FLIGHT_S; k++) {
        status = checked(sins_flight_sample_at(flight, (double)k / RATE_HZ, &sample), NULL);
        if (status == SINS_OK) {
            status = checked(sins_push_sample(sim, &sample), sim);
        }
        if (status >= 0) {
            status = checked(sins_step(sim), sim);
        }
    }
    if (status == SINS_OK) {
        status = checked(sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &errors), sim);
    }
    *distance_m = sqrt(errors.position_enu_m[0] * errors.position_enu_m[0] +
                       errors.position_enu_m[1] * errors.position_enu_m[1]);
    sins_destroy(sim);
    return status;
}

static sins_status ask_and_fly(sins_flight *flight, sins_flight_sample *piece)
{
    static const char *const schemes[] = {"exact", "the paper's", "polynomial"};
    const size_t count = (size_t)RATE_HZ * PIECE_S + 1;
    sins_requirement requirement;
    sins_options options;
    sins_cost cost;
    sins_sim *configured = NULL;
    double distance_m = 0.0;
    sins_status status = SINS_OK;
    size_t k;

    for (k = 0; status == SINS_OK && k < count; k++) {
        SINS_INIT(piece[k]);
        status = checked(sins_flight_sample_at(flight, (double)k / RATE_HZ, &piece[k]), NULL);
    }
    SINS_INIT(requirement);
    requirement.time_steps = 1;
    requirement.position_m = 1.0;
    requirement.duration_s = FLIGHT_S;
    SINS_INIT(options); /* a host uses its own options; here: the defaults, at 50 Hz */
    options.sample_period_s = 1.0 / RATE_HZ;
    SINS_INIT(cost);
    if (status == SINS_OK) {
        status = configure(&options, &configured);
    }
    if (status == SINS_OK) {
        status = checked(sins_recommend(configured, piece, count, &requirement, &options, &cost), NULL);
    }
    sins_destroy(configured); /* if no handle was made, the library returns an error, which does not matter */
    if (status < 0) {
        return status;
    }
    printf("%s 1 m an hour: scheme %s, %d subsamples, %d updates a sample\n",
           status == SINS_OK ? "meets" : "comes closest to", schemes[options.scheme], (int)options.subsamples,
           (int)options.updates_per_sample);
    printf("predicted: %.2g m, %.2g m/s, %.2g rad\n", cost.position_m, cost.velocity_m_s, cost.attitude_rad);
    fprintf(stderr, "%.0f ns a step on this machine\n", cost.ns_per_step);

    status = fly(&options, flight, &distance_m);
    if (status == SINS_OK) {
        printf("flown for an hour: %.2g m\n", distance_m);
    }
    return status;
}

int main(void)
{
    sins_flight *flight = NULL;
    sins_flight_sample *piece = (sins_flight_sample *)malloc(((size_t)RATE_HZ * PIECE_S + 1) * sizeof *piece);
    sins_status status = SINS_ERROR_OUT_OF_MEMORY;

    if (piece == NULL) {
        fprintf(stderr, "recommend: no memory for the samples\n");
    } else {
        status = make_flight(&flight);
    }
    if (status == SINS_OK) {
        status = ask_and_fly(flight, piece);
        sins_flight_destroy(flight);
    }
    free(piece);
    return status == SINS_OK ? 0 : 1;
}
