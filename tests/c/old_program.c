/* A program that calls the exports of the shim in docs/paper.md: the errors are those of the library, to the bit. */
#include "sins.h"
#include "check.h"

int SinsInit(double drift_deg_h, double bias_g);
int SinsStep(const double flight[10], double error[6]);
void SinsExit(void);

int main(void)
{
    double flight[10] = {0, 39.9, 116.4, 50, 0, 0, 0, 0, 0, 30}, error[6] = {0, 0, 0, 0, 0, 0};
    sins_sim *sim = NULL;
    sins_gyro_params gyro;
    sins_accel_params accel;
    sins_flight_sample sample;
    sins_errors errors;
    int axis;
    SINS_INIT(gyro);
    SINS_INIT(accel);
    SINS_INIT(sample);
    SINS_INIT(errors);
    for (axis = 0; axis < 3; axis++) {
        gyro.bias_rad_s[axis] = 0.01 * SINS_DEG_PER_HOUR;
        accel.bias_m_s2[axis] = 1e-5 * SINS_STANDARD_GRAVITY;
    }
    sample.latitude_rad = 39.9 * SINS_DEG;
    sample.longitude_rad = 116.4 * SINS_DEG;
    sample.height_m = 50;
    sample.heading_rad = 30 * SINS_DEG;
    CHECK(sins_create(NULL, &sim) == SINS_OK && sins_set_gyro(sim, &gyro) == SINS_OK && sins_set_accel(sim, &accel) == SINS_OK);
    CHECK(SinsInit(0.5, 0.0) == 1 && SinsInit(0.01, 1e-5) == 1);
    CHECK(SinsStep(flight, error) == 0 && sins_push_sample(sim, &sample) == SINS_OK);
    for (sample.time_s = 1; sample.time_s <= 600; sample.time_s += 1) {
        flight[0] = sample.time_s;
        CHECK(SinsStep(flight, error) == 1);
        CHECK(sins_push_sample(sim, &sample) == SINS_OK && sins_step(sim) == SINS_OK);
    }
    CHECK(sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &errors) == SINS_OK);
    for (axis = 0; axis < 3; axis++) {
        CHECK(error[axis] == errors.position_enu_m[axis] && error[3 + axis] == errors.velocity_enu_m_s[axis]);
    }
    CHECK(error[0] != 0.0);
    CHECK(SinsStep(flight, error) == 0); /* the same time again */
    SinsExit();
    CHECK(SinsStep(flight, error) == 0);
    return sins_destroy(sim);
}
