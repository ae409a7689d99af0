/* Sizes and offsets of every struct: the same for every compiler, word size and packing. Compiled, not run, also under
 * -fpack-struct=4 and -fpack-struct=1, as C99 and as C++11. */

#include "sins.h"

#ifdef __cplusplus
#define CHECK(condition) static_assert(condition, #condition)
#else
#define CHECK(condition) extern const char checked[(condition) ? 1 : -1]
#endif

/* Checks also the size that the header states for other languages. */
#define SIZE(type, stated, size) CHECK(sizeof(struct type) == (size) && (stated) == (size))
#define AT(type, field, offset) CHECK(offsetof(struct type, field) == (offset))

SIZE(sins_options, SINS_SIZEOF_OPTIONS, 104);
AT(sins_options, struct_size, 0);
AT(sins_options, reserved, 4);
AT(sins_options, frame, 8);
AT(sins_options, signal, 44);
AT(sins_options, seed, 48);
AT(sins_options, closed_loop_time_s, 64);
AT(sins_options, max_acceleration_m_s2, 88);
AT(sins_options, truth_summary, 96);
AT(sins_options, covariance, 100);

SIZE(sins_error_info, SINS_SIZEOF_ERROR_INFO, 152);
AT(sins_error_info, flags, 4);
AT(sins_error_info, status, 8);
AT(sins_error_info, field, 16);
AT(sins_error_info, index, 112);
AT(sins_error_info, value, 128);
AT(sins_error_info, maximum, 144);

/* Layout of sins_gyro_params and sins_accel_params in the library. The test writes this file from the table of sensor
 * parameters. */
#include "sensor_layout.h"

AT(sins_gyro_params, struct_size, 0);
AT(sins_gyro_params, reserved, 4);
AT(sins_gyro_params, bias_rad_s, 8);
AT(sins_accel_params, struct_size, 0);
AT(sins_accel_params, reserved, 4);
AT(sins_accel_params, bias_m_s2, 8);

SIZE(sins_altimeter_params, SINS_SIZEOF_ALTIMETER_PARAMS, 56);
AT(sins_altimeter_params, lag_s, 48);

SIZE(sins_failure, SINS_SIZEOF_FAILURE, 56);
AT(sins_failure, kind, 8);
AT(sins_failure, size, 16);
AT(sins_failure, density, 24);
AT(sins_failure, interval_s, 32);
AT(sins_failure, probability, 48);

SIZE(sins_initial_errors, SINS_SIZEOF_INITIAL_ERRORS, 160);
AT(sins_initial_errors, position_enu_m, 8);
AT(sins_initial_errors, alignment, 152);

SIZE(sins_mounting, SINS_SIZEOF_MOUNTING, 104);
AT(sins_mounting, reserved, 4);
AT(sins_mounting, lever_arm_m, 8);
AT(sins_mounting, boresight_rad, 32);
AT(sins_mounting, lever_arm_error_m, 56);
AT(sins_mounting, boresight_error_rad, 80);

SIZE(sins_gravity_params, SINS_SIZEOF_GRAVITY_PARAMS, 80);
AT(sins_gravity_params, reserved, 4);
AT(sins_gravity_params, deflection_north_rad, 8);
AT(sins_gravity_params, deflection_east_rad, 32);
AT(sins_gravity_params, anomaly_m_s2, 56);
AT(sins_gravity_params, anomaly_distance_m, 72);

SIZE(sins_flight_sample, SINS_SIZEOF_FLIGHT_SAMPLE, 144);
AT(sins_flight_sample, flags, 4);
AT(sins_flight_sample, time_s, 8);
AT(sins_flight_sample, velocity_enu_m_s, 40);
AT(sins_flight_sample, roll_rad, 64);
AT(sins_flight_sample, angular_rate_rad_s, 88);
AT(sins_flight_sample, specific_force_m_s2, 112);
AT(sins_flight_sample, temperature_c, 136);

SIZE(sins_navigation, SINS_SIZEOF_NAVIGATION, 128);
AT(sins_navigation, time_s, 8);
AT(sins_navigation, velocity_enu_m_s, 40);
AT(sins_navigation, quaternion_nb, 88);
AT(sins_navigation, flags, 120);

SIZE(sins_errors, SINS_SIZEOF_ERRORS, 144);
AT(sins_errors, position_enu_m, 16);
AT(sins_errors, velocity_enu_m_s, 64);
AT(sins_errors, misalignment_enu_rad, 88);
AT(sins_errors, flags, 136);

SIZE(sins_imu, SINS_SIZEOF_IMU, 216);
AT(sins_imu, flags, 4);
AT(sins_imu, interval_s, 16);
AT(sins_imu, ideal_angle_rad, 24);
AT(sins_imu, measured_force_m_s2, 192);

SIZE(sins_truth_summary, SINS_SIZEOF_TRUTH_SUMMARY, 232);
AT(sins_truth_summary, intervals, 8);
AT(sins_truth_summary, flown_s, 32);
AT(sins_truth_summary, sideslip_max_rad, 168);
AT(sins_truth_summary, height_max_at_s, 224);

SIZE(sins_covariance, SINS_SIZEOF_COVARIANCE, 776);
AT(sins_covariance, flags, 4);
AT(sins_covariance, time_s, 8);
AT(sins_covariance, covariance, 16);
AT(sins_covariance, position_sigma_enu_m, 664);
AT(sins_covariance, misalignment_sigma_enu_rad, 712);
AT(sins_covariance, ellipse_major_m, 736);
AT(sins_covariance, radial_95_m, 768);

SIZE(sins_accuracy, SINS_SIZEOF_ACCURACY, 256);
AT(sins_accuracy, window_samples, 32);
AT(sins_accuracy, closure_position_enu_m, 96);
AT(sins_accuracy, inconsistent_samples, 224);
AT(sins_accuracy, intervals, 232);
AT(sins_accuracy, trim_force_max_m_s2, 248);

SIZE(sins_imu_increment, SINS_SIZEOF_IMU_INCREMENT, 264);
AT(sins_imu_increment, count, 16);
AT(sins_imu_increment, angle_rad, 24);
AT(sins_imu_increment, velocity_m_s, 144);

SIZE(sins_record_solution, SINS_SIZEOF_RECORD_SOLUTION, 112);
SIZE(sins_record_errors, SINS_SIZEOF_RECORD_ERRORS, 128);
SIZE(sins_record, SINS_SIZEOF_RECORD, 496);
AT(sins_record, truth, 16);
AT(sins_record, navigation, 128);
AT(sins_record, navigation_errors, 240);
AT(sins_record, model_errors, 368);

SIZE(sins_flight_start, SINS_SIZEOF_FLIGHT_START, 72);
AT(sins_flight_start, earth, 64);

SIZE(sins_requirement, SINS_SIZEOF_REQUIREMENT, 48);
AT(sins_requirement, time_steps, 4);
AT(sins_requirement, duration_s, 8);
AT(sins_requirement, position_m, 16);
AT(sins_requirement, attitude_rad, 32);
AT(sins_requirement, margin, 40);

SIZE(sins_cost, SINS_SIZEOF_COST, 96);
AT(sins_cost, reserved, 4);
AT(sins_cost, duration_s, 8);
AT(sins_cost, position_m, 16);
AT(sins_cost, reference_position_m, 40);
AT(sins_cost, share, 64);
AT(sins_cost, instructions_per_step, 72);
AT(sins_cost, ns_per_step, 80);
AT(sins_cost, tried, 88);

SIZE(sins_budget_request, SINS_SIZEOF_BUDGET_REQUEST, 40);
AT(sins_budget_request, time_steps, 4);
AT(sins_budget_request, runs, 8);
AT(sins_budget_request, attitude_rad, 32);

SIZE(sins_budget_row, SINS_SIZEOF_BUDGET_ROW, 152);
AT(sins_budget_row, flags, 4);
AT(sins_budget_row, effect, 8);
AT(sins_budget_row, field, 40);
AT(sins_budget_row, position_m, 88);
AT(sins_budget_row, end_position_m, 112);
AT(sins_budget_row, share, 136);
AT(sins_budget_row, ns_per_step, 144);

SIZE(sins_budget, SINS_SIZEOF_BUDGET, 128);
AT(sins_budget, reserved, 4);
AT(sins_budget, runs, 16);
AT(sins_budget, flights, 24);
AT(sins_budget, sigma_low, 32);
AT(sins_budget, position_m, 48);
AT(sins_budget, remainder_position_m, 72);
AT(sins_budget, left_out_attitude_rad, 112);
AT(sins_budget, ns_per_step, 120);

SIZE(sins_manoeuvre, SINS_SIZEOF_MANOEUVRE, 240);
AT(sins_manoeuvre, kind, 8);
AT(sins_manoeuvre, duration_s, 16);
AT(sins_manoeuvre, channel, 72);
AT(sins_manoeuvre, amplitude, 96);
AT(sins_manoeuvre, phase_rad, 192);

SIZE(sins_fault, SINS_SIZEOF_FAULT, 408);
AT(sins_fault, count, 8);
AT(sins_fault, column, 24);
AT(sins_fault, value, 32);
AT(sins_fault, path, 56);
AT(sins_fault, sentence, 152);

SIZE(sins_scene_key, SINS_SIZEOF_SCENE_KEY, 592);
AT(sins_scene_key, count, 8);
AT(sins_scene_key, kind, 16);
AT(sins_scene_key, si_per_unit, 32);
AT(sins_scene_key, section, 56);
AT(sins_scene_key, unit, 160);
AT(sins_scene_key, default_value, 208);
AT(sins_scene_key, words, 240);
AT(sins_scene_key, meaning, 464);

SIZE(sins_scene_setup, SINS_SIZEOF_SCENE_SETUP, 72);
AT(sins_scene_setup, flight, 8);
AT(sins_scene_setup, quiet, 16);
AT(sins_scene_setup, duration_s, 24);
AT(sins_scene_setup, every_s, 64);

SIZE(sins_scene_samples, SINS_SIZEOF_SCENE_SAMPLES, 48);
AT(sins_scene_samples, count, 8);
AT(sins_scene_samples, start_s, 24);
AT(sins_scene_samples, duration_s, 40);

SIZE(sins_planned_failure, SINS_SIZEOF_PLANNED_FAILURE, 80);
AT(sins_planned_failure, sensor, 8);
AT(sins_planned_failure, from_s, 16);
AT(sins_planned_failure, kind, 32);
AT(sins_planned_failure, size, 40);
AT(sins_planned_failure, probability, 72);

SIZE(sins_log_info, SINS_SIZEOF_LOG_INFO, 216);
AT(sins_log_info, samples, 8);
AT(sins_log_info, duration_s, 16);
AT(sins_log_info, title, 24);

SIZE(sins_statistics, SINS_SIZEOF_STATISTICS, 14920);
AT(sins_statistics, layout, 4);
AT(sins_statistics, runs, 8);
AT(sins_statistics, largest_radial, 40);
AT(sins_statistics, sums, 48);
AT(sins_statistics, products, 192);
AT(sins_statistics, histogram, 912);
AT(sins_statistics, reserved, 14916);

SIZE(sins_figures, SINS_SIZEOF_FIGURES, 936);
AT(sins_figures, runs, 8);
AT(sins_figures, mean_position_enu_m, 40);
AT(sins_figures, sigma_position_enu_m, 112);
AT(sins_figures, rms_misalignment_enu_rad, 232);
AT(sins_figures, covariance, 256);
AT(sins_figures, rms_radial_m, 904);
AT(sins_figures, largest_radial_m, 928);
