/* The smallest host: an hour at rest with a gyro bias of 0.01 deg/h, and the position error that the bias causes. */

#include <stdio.h>

#include "sins.h"

int main(void)
{
    sins_sim *sim = NULL;
    sins_gyro_params gyro;
    sins_flight_sample sample;
    sins_errors errors;
    sins_status status;

    SINS_INIT(gyro); /* all zero: an ideal gyro */
    SINS_INIT(sample);
    SINS_INIT(errors);
    gyro.bias_rad_s[0] = 0.01 * SINS_DEG_PER_HOUR;
    sample.latitude_rad = 39.9 * SINS_DEG;

    status = sins_create(NULL, &sim);
    if (status == SINS_OK) {
        status = sins_set_gyro(sim, &gyro);
    }
    for (; status >= 0 && sample.time_s <= 3600.0; sample.time_s += 1.0) {
        status = sins_push_sample(sim, &sample);
        if (status >= 0) {
            status = sins_step(sim); /* SINS_NEED_SAMPLE at the first one */
        }
    }
    if (status == SINS_OK && sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &errors) == SINS_OK) {
        printf("%.0f m east, %.0f m north\n", errors.position_enu_m[0], errors.position_enu_m[1]);
    }
    sins_destroy(sim);
    return status == SINS_OK ? 0 : 1;
}
