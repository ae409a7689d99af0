/* The frame function of docs/flight_simulators.md: flight along the equator with a pause, its clock running or not, and a slew. */
#include "check.h"
#include "frame.h"
#include <math.h>

/* 200 m/s east on the equator, position and velocity in closed form. */
static void fly_to(sins_flight_sample *sample, double time_s, double east_m)
{
    sample->time_s = time_s;
    sample->velocity_enu_m_s[0] = 200.0;
    sample->longitude_rad = east_m / 6378137.0;
    sample->heading_rad = 90.0 * SINS_DEG;
}

static void flight(double clock_in_pause)
{
    frame_ins ins = {NULL, 0, 0};
    sins_flight_sample sample;
    sins_navigation navigation;
    sins_errors errors;
    double time_s = 0.0, east_m = 0.0;
    int k;
    SINS_INIT(sample);
    SINS_INIT(navigation);
    SINS_INIT(errors);
    CHECK(sins_create(NULL, &ins.sim) == SINS_OK);
    fly_to(&sample, 0.0, 0.0);
    CHECK(frame(&ins, &sample, 1, 0, &navigation) == SINS_NEED_SAMPLE);
    for (k = 0; k < 3000; k++) {
        int is_paused = k >= 1000 && k < 1300, is_slewing = k >= 2000 && k < 2100;
        if (k > 0) {
            time_s += is_paused ? clock_in_pause : 0.02;
            east_m += is_slewing ? 100.0 : is_paused ? 0.0 : 200.0 * 0.02;
        }
        fly_to(&sample, time_s, east_m);
        CHECK(frame(&ins, &sample, is_paused, is_slewing, &navigation) >= SINS_OK);
    }
    CHECK(sins_get_errors(ins.sim, SINS_ERRORS_NAVIGATION, &errors) == SINS_OK);
    /* The time stamps are sums of 0.02 s, which round to 1e-12 s: 200 m/s times 3000 roundings of 7e-15 s. */
    CHECK(fabs(errors.position_enu_m[0]) < 1e-6 && fabs(errors.position_enu_m[1]) < 1e-6);
    CHECK(fabs(navigation.time_s - time_s) < 1e-9 && fabs(navigation.longitude_rad * 6378137.0 - east_m) < 1e-6);
    CHECK(sins_destroy(ins.sim) == SINS_OK);
}

int main(void)
{
    flight(0.0);
    flight(0.02);
    return 0;
}
