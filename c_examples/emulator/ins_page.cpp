/* Initial conditions of the INS, with its mounting and its altimeter: panel (c) of the paper's figure 2. */
#include "app.h"

void InsPage::on_init()
{
    static const struct {
        int id;
        const char *path;
    } VECTORS[] = {{IDC_POSITION, "start.position_m"}, {IDC_POSITION_SIGMA, "start.position_sigma_m"},
                   {IDC_VELOCITY, "start.velocity_m_s"}, {IDC_VELOCITY_SIGMA, "start.velocity_sigma_m_s"},
                   {IDC_MISALIGNMENT, "start.misalignment_arcmin"}, {IDC_MISALIGNMENT_SIGMA, "start.misalignment_sigma_arcmin"},
                   {IDC_ARM, "mounting.lever_arm_m"}, {IDC_BORESIGHT, "mounting.boresight_deg"},
                   {IDC_ARM_ERROR, "mounting.lever_arm_error_mm"}, {IDC_BORESIGHT_ERROR, "mounting.boresight_error_arcsec"}};
    std::vector<Field> fields = {{IDC_ALIGNMENT, "start.alignment", 0}, {IDC_BARO_BIAS, "altimeter.bias_m", 0},
                                 {IDC_BARO_NOISE, "altimeter.noise_m", 0}, {IDC_BARO_SIGMA, "altimeter.markov_sigma_m", 0},
                                 {IDC_BARO_TIME, "altimeter.markov_time_s", 0}, {IDC_BARO_SCALE, "altimeter.scale_factor_ppm", 0},
                                 {IDC_BARO_LAG, "altimeter.lag_s", 0}};
    for (const auto &vector : VECTORS) {
        for (int k = 0; k < 3; k++) {
            fields.push_back({vector.id + k, vector.path, k});
        }
    }
    exchange(fields);
}
