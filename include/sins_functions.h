/*
 * sins_functions.h - all functions of the library as a table, for hosts that look them up by themselves: by GetProcAddress() or dlsym().
 *
 *   #define DECLARE(result, name, arguments) result (SINS_CALL *name) arguments;
 *   struct functions { SINS_FUNCTIONS(DECLARE) };
 *
 * SINS_FUNCTIONS_SCENES are those that a library without the feature "scenes" lacks, SINS_FUNCTIONS_IDENTIFY without "identify".
 *
 * This file is written by build/ from the Rust sources; do not edit it.
 */

#ifndef SINS_FUNCTIONS_H
#define SINS_FUNCTIONS_H

#include "sins_analysis.h"
#include "sins_scene.h"

#define SINS_FUNCTIONS_ENGINE(X) \
    X(uint32_t, sins_abi_version, (void)) \
    X(const char *, sins_version_string, (void)) \
    X(const char *, sins_status_string, (sins_status status)) \
    X(sins_status, sins_create, (const sins_options *options, sins_sim **sim)) \
    X(sins_status, sins_destroy, (sins_sim *sim)) \
    X(sins_status, sins_get_options, (sins_sim *sim, sins_options *options)) \
    X(sins_status, sins_push_sample, (sins_sim *sim, const sins_flight_sample *sample)) \
    X(sins_status, sins_step, (sins_sim *sim)) \
    X(sins_status, sins_move_time, (sins_sim *sim, double time_s)) \
    X(sins_status, sins_move_truth, (sins_sim *sim, const sins_flight_sample *sample)) \
    X(sins_status, sins_reposition, (sins_sim *sim, const sins_flight_sample *sample)) \
    X(sins_status, sins_reset, (sins_sim *sim)) \
    X(sins_status, sins_last_error, (const sins_sim *sim, char *buffer, size_t capacity, size_t *needed)) \
    X(sins_status, sins_last_error_info, (const sins_sim *sim, sins_error_info *info)) \
    X(sins_status, sins_set_gyro, (sins_sim *sim, const sins_gyro_params *params)) \
    X(sins_status, sins_get_gyro, (sins_sim *sim, sins_gyro_params *params)) \
    X(sins_status, sins_set_accel, (sins_sim *sim, const sins_accel_params *params)) \
    X(sins_status, sins_get_accel, (sins_sim *sim, sins_accel_params *params)) \
    X(sins_status, sins_set_altimeter, (sins_sim *sim, const sins_altimeter_params *params)) \
    X(sins_status, sins_get_altimeter, (sins_sim *sim, sins_altimeter_params *params)) \
    X(sins_status, sins_get_truth, (sins_sim *sim, sins_navigation *truth)) \
    X(sins_status, sins_get_navigation, (sins_sim *sim, sins_navigation *navigation)) \
    X(sins_status, sins_get_errors, (sins_sim *sim, int32_t source, sins_errors *errors)) \
    X(sins_status, sins_get_imu, (sins_sim *sim, sins_imu *imu)) \
    X(sins_status, sins_get_accuracy, (sins_sim *sim, sins_accuracy *accuracy)) \
    X(sins_status, sins_get_truth_summary, (sins_sim *sim, sins_truth_summary *summary)) \
    X(sins_status, sins_get_covariance, (sins_sim *sim, sins_covariance *covariance)) \
    X(sins_status, sins_get_record, (sins_sim *sim, sins_record *record)) \
    X(sins_status, sins_record_line, (const sins_record *record, const double *sensor_errors, size_t count, const sins_covariance *covariance, char *buffer, size_t capacity, size_t *needed)) \
    X(sins_status, sins_run, (sins_sim *sim, const sins_flight_sample *samples, size_t count, size_t every, sins_record *records, size_t capacity, size_t *written)) \
    X(sins_status, sins_set_failure, (sins_sim *sim, int32_t sensor, int32_t axis, const sins_failure *failure)) \
    X(sins_status, sins_get_failure, (sins_sim *sim, int32_t sensor, int32_t axis, sins_failure *failure)) \
    X(sins_status, sins_set_initial_errors, (sins_sim *sim, const sins_initial_errors *errors)) \
    X(sins_status, sins_get_initial_errors, (sins_sim *sim, sins_initial_errors *errors)) \
    X(sins_status, sins_set_mounting, (sins_sim *sim, const sins_mounting *mounting)) \
    X(sins_status, sins_get_mounting, (sins_sim *sim, sins_mounting *mounting)) \
    X(sins_status, sins_set_gravity_disturbance, (sins_sim *sim, const sins_gravity_params *params)) \
    X(sins_status, sins_get_gravity_disturbance, (sins_sim *sim, sins_gravity_params *params)) \
    X(sins_status, sins_gyro_preset, (int32_t grade, sins_gyro_params *params)) \
    X(sins_status, sins_accel_preset, (int32_t grade, sins_accel_params *params)) \
    X(sins_status, sins_initial_preset, (int32_t grade, sins_initial_errors *errors)) \
    X(sins_status, sins_get_imu_update, (sins_sim *sim, int32_t update, sins_imu_increment *increment)) \
    X(sins_status, sins_start_navigation, (sins_sim *sim, const sins_navigation *navigation)) \
    X(sins_status, sins_push_imu, (sins_sim *sim, const sins_imu_increment *increment)) \
    X(sins_status, sins_correct, (sins_sim *sim, const sins_correction *correction)) \
    X(sins_status, sins_get_compensation, (sins_sim *sim, sins_compensation *compensation)) \
    X(sins_status, sins_snapshot_size, (sins_sim *sim, size_t *size)) \
    X(sins_status, sins_snapshot_save, (sins_sim *sim, void *buffer, size_t capacity, size_t *written)) \
    X(sins_status, sins_snapshot_load, (sins_sim *sim, const void *snapshot, size_t size)) \
    X(sins_status, sins_flight_create, (const sins_flight_start *start, const sins_manoeuvre *manoeuvres, size_t count, sins_flight **flight)) \
    X(sins_status, sins_flight_duration, (const sins_flight *flight, double *duration_s)) \
    X(sins_status, sins_flight_sample_at, (const sins_flight *flight, double time_s, sins_flight_sample *sample)) \
    X(sins_status, sins_flight_destroy, (sins_flight *flight)) \
    X(sins_status, sins_judge_create, (const sins_options *options, sins_judge **judge)) \
    X(sins_status, sins_judge_push, (sins_judge *judge, const sins_flight_sample *sample)) \
    X(sins_status, sins_judge_get_findings, (const sins_judge *judge, sins_finding *findings, size_t capacity, size_t *count)) \
    X(sins_status, sins_judge_destroy, (sins_judge *judge)) \
    X(sins_status, sins_recommend, (const sins_sim *configured, const sins_flight_sample *samples, size_t count, const sins_requirement *requirement, sins_options *options, sins_cost *cost)) \
    X(sins_status, sins_error_budget, (const sins_sim *configured, const sins_flight_sample *samples, size_t count, const sins_budget_request *request, sins_budget_row *rows, size_t capacity, size_t *written, sins_budget *budget)) \
    X(sins_status, sins_unit_create, (const sins_unit_params *params, int32_t mode, sins_unit **unit)) \
    X(sins_status, sins_unit_destroy, (sins_unit *unit)) \
    X(sins_status, sins_unit_set_params, (sins_unit *unit, const sins_unit_params *params)) \
    X(sins_status, sins_unit_get_params, (sins_unit *unit, sins_unit_params *params)) \
    X(sins_status, sins_unit_select, (sins_unit *unit, int32_t mode)) \
    X(sins_status, sins_unit_set_power, (sins_unit *unit, int32_t power)) \
    X(sins_status, sins_unit_set_alignment, (sins_unit *unit, int32_t kind)) \
    X(sins_status, sins_unit_press_test, (sins_unit *unit)) \
    X(sins_status, sins_unit_enter_position, (sins_unit *unit, double latitude_rad, double longitude_rad)) \
    X(sins_status, sins_unit_enter_heading, (sins_unit *unit, double heading_rad)) \
    X(sins_status, sins_unit_set_stored, (sins_unit *unit, double latitude_rad, double longitude_rad, double heading_rad)) \
    X(sins_status, sins_unit_update, (sins_unit *unit, sins_sim *sim)) \
    X(sins_status, sins_unit_push_fix, (sins_unit *unit, sins_sim *sim, const sins_unit_fix *fix)) \
    X(sins_status, sins_unit_snapshot_save, (sins_unit *unit, void *buffer, size_t capacity, size_t *written)) \
    X(sins_status, sins_unit_snapshot_load, (sins_unit *unit, const void *snapshot, size_t size)) \
    X(sins_status, sins_unit_get_status, (sins_unit *unit, sins_unit_status *status)) \
    X(sins_status, sins_unit_get_navigation, (sins_unit *unit, const sins_sim *sim, sins_unit_navigation *navigation)) \
    X(sins_status, sins_bus_words, (const sins_unit_status *status, const sins_unit_navigation *navigation, const sins_bus_inputs *inputs, double from_s, double to_s, sins_bus_word *words, size_t capacity, size_t *count)) \
    X(sins_status, sins_bus_get_label, (size_t index, sins_bus_label *label)) \
    X(sins_status, sins_bus_decode, (uint32_t word, uint32_t flags, sins_bus_label *label)) \
    X(sins_status, sins_ensemble_create, (const sins_sim *configured, uint64_t first_run, size_t runs, sins_ensemble **ensemble)) \
    X(sins_status, sins_ensemble_destroy, (sins_ensemble *ensemble)) \
    X(sins_status, sins_ensemble_push_sample, (sins_ensemble *ensemble, const sins_flight_sample *sample)) \
    X(sins_status, sins_ensemble_step, (sins_ensemble *ensemble)) \
    X(sins_status, sins_ensemble_run, (sins_ensemble *ensemble, const sins_flight_sample *samples, size_t count)) \
    X(sins_status, sins_ensemble_reposition, (sins_ensemble *ensemble, const sins_flight_sample *sample)) \
    X(sins_status, sins_ensemble_reset, (sins_ensemble *ensemble)) \
    X(sins_status, sins_ensemble_set_failure, (sins_ensemble *ensemble, int32_t sensor, int32_t axis, const sins_failure *failure)) \
    X(sins_status, sins_ensemble_get_runs, (sins_ensemble *ensemble, uint64_t *first_run, size_t *runs)) \
    X(sins_status, sins_ensemble_get_truth, (sins_ensemble *ensemble, sins_navigation *truth)) \
    X(sins_status, sins_ensemble_get_navigation, (sins_ensemble *ensemble, uint64_t run, sins_navigation *navigation)) \
    X(sins_status, sins_ensemble_get_errors, (sins_ensemble *ensemble, uint64_t run, int32_t source, sins_errors *errors)) \
    X(sins_status, sins_ensemble_get_all_errors, (sins_ensemble *ensemble, int32_t source, sins_errors *errors, size_t capacity)) \
    X(sins_status, sins_ensemble_get_imu, (sins_ensemble *ensemble, uint64_t run, sins_imu *imu)) \
    X(sins_status, sins_ensemble_get_diverged, (sins_ensemble *ensemble, size_t index, uint64_t *run)) \
    X(sins_status, sins_ensemble_correct, (sins_ensemble *ensemble, uint64_t run, const sins_correction *correction)) \
    X(sins_status, sins_ensemble_get_compensation, (sins_ensemble *ensemble, uint64_t run, sins_compensation *compensation)) \
    X(sins_status, sins_ensemble_get_statistics, (sins_ensemble *ensemble, int32_t source, sins_statistics *statistics)) \
    X(sins_status, sins_statistics_add, (sins_statistics *statistics, const sins_errors *errors)) \
    X(sins_status, sins_statistics_merge, (sins_statistics *into, const sins_statistics *other)) \
    X(sins_status, sins_statistics_figures, (const sins_statistics *statistics, sins_figures *figures)) \
    X(sins_status, sins_meets, (const sins_statistics *statistics, double radius_m, double percent, sins_verdict *verdict)) \
    X(sins_status, sins_ensemble_snapshot_size, (sins_ensemble *ensemble, size_t *size)) \
    X(sins_status, sins_ensemble_snapshot_save, (sins_ensemble *ensemble, void *buffer, size_t capacity, size_t *written)) \
    X(sins_status, sins_ensemble_snapshot_load, (sins_ensemble *ensemble, const void *snapshot, size_t size))

#define SINS_FUNCTIONS_SCENES(X) \
    X(sins_status, sins_scene_create, (sins_scene **scene)) \
    X(sins_status, sins_scene_parse, (const char *text, size_t size, sins_scene **scene)) \
    X(sins_status, sins_scene_get_fault, (const sins_scene *scene, size_t index, sins_fault *fault)) \
    X(sins_status, sins_scene_create_builtin, (const char *name, sins_scene **scene)) \
    X(sins_status, sins_scene_builtin_name, (size_t index, char *buffer, size_t capacity, size_t *needed)) \
    X(sins_status, sins_scene_write, (const sins_scene *scene, char *buffer, size_t capacity, size_t *needed)) \
    X(sins_status, sins_scene_write_keys, (char *buffer, size_t capacity, size_t *needed)) \
    X(sins_status, sins_scene_create_simulator, (const sins_scene *scene, sins_sim **sim)) \
    X(sins_status, sins_scene_create_flight, (const sins_scene *scene, sins_flight **flight)) \
    X(sins_status, sins_scene_destroy, (sins_scene *scene)) \
    X(sins_status, sins_scene_prepare, (const sins_scene *scene, sins_sim *sim, double flight_start_s, sins_flight_sample *sample)) \
    X(sins_status, sins_scene_prepare_ensemble, (const sins_scene *scene, sins_ensemble *ensemble, double flight_start_s, sins_flight_sample *sample)) \
    X(sins_status, sins_scene_create_unit, (const sins_scene *scene, sins_unit **unit)) \
    X(sins_status, sins_scene_update_unit, (const sins_scene *scene, sins_unit *unit, sins_sim *sim, double flight_start_s)) \
    X(sins_status, sins_scene_get_options, (const sins_scene *scene, sins_options *options)) \
    X(sins_status, sins_scene_get_setup, (const sins_scene *scene, sins_scene_setup *setup)) \
    X(sins_status, sins_scene_get_manoeuvres, (const sins_scene *scene, sins_flight_start *start, sins_manoeuvre *manoeuvres, size_t capacity, size_t *count, size_t *repeat)) \
    X(sins_status, sins_scene_set_manoeuvres, (sins_scene *scene, const sins_flight_start *start, const sins_manoeuvre *manoeuvres, size_t count, size_t repeat)) \
    X(sins_status, sins_scene_get_text, (const sins_scene *scene, int32_t which, char *buffer, size_t capacity, size_t *needed)) \
    X(sins_status, sins_scene_set_text, (sins_scene *scene, int32_t which, const char *text)) \
    X(sins_status, sins_scene_get_failure_count, (const sins_scene *scene, size_t *count)) \
    X(sins_status, sins_scene_get_failure, (const sins_scene *scene, size_t index, sins_planned_failure *failure)) \
    X(sins_status, sins_scene_get_key, (size_t index, sins_scene_key *key)) \
    X(sins_status, sins_scene_get_value, (const sins_scene *scene, const char *path, char *buffer, size_t capacity, size_t *needed)) \
    X(sins_status, sins_scene_set_values, (sins_scene *scene, const char *values)) \
    X(sins_status, sins_scene_set_items, (sins_scene *scene, const char *list, const char *items)) \
    X(sins_status, sins_scene_log_file_name, (const sins_scene *scene, size_t index, char *buffer, size_t capacity, size_t *needed)) \
    X(sins_status, sins_scene_give_log_file, (sins_scene *scene, const char *name, const char *text, size_t size)) \
    X(sins_status, sins_log_parse, (const char *text, size_t size, const sins_scene *scene, sins_log **log, sins_fault *fault)) \
    X(sins_status, sins_log_create, (const sins_flight_sample *samples, size_t count, sins_log **log)) \
    X(sins_status, sins_log_get_info, (const sins_log *log, sins_log_info *info)) \
    X(sins_status, sins_log_get_sample, (const sins_log *log, size_t index, sins_flight_sample *sample, uint64_t *line)) \
    X(sins_status, sins_judge_push_log, (sins_judge *judge, const sins_log *log)) \
    X(sins_status, sins_log_destroy, (sins_log *log)) \
    X(sins_status, sins_scene_get_samples, (const sins_scene *scene, const sins_log *log, sins_scene_samples *samples)) \
    X(sins_status, sins_play_create, (const sins_scene *scene, const sins_log *log, sins_play **play)) \
    X(sins_status, sins_play_next, (sins_play *play)) \
    X(sins_status, sins_play_push, (sins_play *play, const sins_flight_sample *sample)) \
    X(sins_status, sins_play_run, (sins_play *play, sins_record *records, size_t capacity, size_t *written)) \
    X(sins_status, sins_play_run_imu, (sins_play *play, sins_imu *imu, size_t capacity, size_t *written)) \
    X(sins_status, sins_play_set_plan, (sins_play *play, const sins_scene *scene)) \
    X(sins_status, sins_play_get_simulator, (sins_play *play, sins_sim **sim)) \
    X(sins_status, sins_play_get_unit, (sins_play *play, sins_unit **unit)) \
    X(sins_status, sins_play_get_shown, (sins_play *play, sins_unit_status *status, sins_unit_navigation *navigation)) \
    X(sins_status, sins_play_destroy, (sins_play *play)) \
    X(sins_status, sins_play_snapshot_save, (sins_play *play, void *buffer, size_t capacity, size_t *written)) \
    X(sins_status, sins_play_snapshot_load, (sins_play *play, const void *snapshot, size_t size))

#define SINS_FUNCTIONS_IDENTIFY(X) \
    X(sins_status, sins_identify_create, (const sins_options *options, const sins_identify_request *request, sins_identify **identify)) \
    X(sins_status, sins_identify_push_samples, (sins_identify *identify, const sins_flight_sample *samples, size_t count)) \
    X(sins_status, sins_identify_push_increments, (sins_identify *identify, const sins_recorded_increment *increments, size_t count)) \
    X(sins_status, sins_identify_solve, (sins_identify *identify, sins_identified *identified)) \
    X(sins_status, sins_identify_get_parameter, (const sins_identify *identify, size_t index, sins_identified_parameter *parameter)) \
    X(sins_status, sins_identify_get_scene, (const sins_identify *identify, char *buffer, size_t capacity, size_t *needed)) \
    X(sins_status, sins_identify_destroy, (sins_identify *identify)) \
    X(sins_status, sins_identify_check, (sins_identify *identify, const sins_identify_check_request *request, sins_identified_check *check)) \
    X(sins_status, sins_identify_get_span, (const sins_identify *identify, size_t index, sins_identified_span *span))

#define SINS_FUNCTIONS(X) SINS_FUNCTIONS_ENGINE(X) SINS_FUNCTIONS_SCENES(X) SINS_FUNCTIONS_IDENTIFY(X)

#endif /* SINS_FUNCTIONS_H */
