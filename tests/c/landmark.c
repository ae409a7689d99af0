/* A pilot's update: the function of docs/close_the_loop.md, in flight at several latitudes. */

#include <math.h>

#include "check.h"
#include "sins.h"

#include "landmark.h"

static void fly(double latitude_rad)
{
    sins_sim *sim = NULL;
    sins_flight_sample sample;
    sins_initial_errors initial;
    sins_errors before, after;
    int k;
    SINS_INIT(sample);
    SINS_INIT(initial);
    SINS_INIT(before);
    SINS_INIT(after);
    initial.position_enu_m[0] = 2000.0;
    initial.position_enu_m[1] = -1500.0;
    initial.velocity_enu_m_s[1] = 1.0;
    sample.latitude_rad = latitude_rad;
    sample.longitude_rad = 1.0;
    sample.height_m = 3000.0;
    CHECK(sins_create(NULL, &sim) == SINS_OK && sins_set_initial_errors(sim, &initial) == SINS_OK);
    CHECK(update_position(sim, 0.0, 0.0) == SINS_ERROR_BAD_STATE);
    for (k = 0; k < 100; k++) {
        sample.time_s = k / 16.0;
        CHECK(sins_push_sample(sim, &sample) == SINS_OK && sins_step(sim) == (k == 0 ? SINS_NEED_SAMPLE : SINS_OK));
    }
    CHECK(sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &before) == SINS_OK);
    CHECK(update_position(sim, sample.latitude_rad, sample.longitude_rad) == SINS_OK);
    CHECK(sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &after) == SINS_OK);
    for (k = 0; k < 2; k++) {
        CHECK(fabs(before.position_enu_m[k]) > 1000.0 && fabs(after.position_enu_m[k]) < 0.007 * fabs(before.position_enu_m[k]));
        CHECK(fabs(after.velocity_enu_m_s[k] - before.velocity_enu_m_s[k]) < 1e-12);
    }
    CHECK(sins_destroy(sim) == SINS_OK);
}

int main(void)
{
    fly(0.0);
    fly(-0.6);
    fly(1.0);
    return 0;
}
