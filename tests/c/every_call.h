/* Calls every function that takes a handle with valid arguments; `answer` gets each status. null_calls() calls every function with
 * null for each pointer that may not be null.
 *
 * This file is written by build/ from the Rust sources; do not edit it. */

#ifndef EVERY_CALL_H
#define EVERY_CALL_H

#include "scene.h"

typedef void every_call_answer(const char *call, sins_status status, void *context);

/* Asserts that the answer is the status at `context`. */
static inline void every_answer_is(const char *call, sins_status status, void *context)
{
    if (status != *(const sins_status *)context) {
        fprintf(stderr, "%s gives %d\n", call, (int)status);
    }
    CHECK(status == *(const sins_status *)context);
}

#ifndef EVERY_CALL
#define EVERY_CALL(call) answer(#call, call, context)
#endif

/* A program with a small stack has `static` here. */
#ifndef EVERY_CALL_STORAGE
#define EVERY_CALL_STORAGE
#endif

/* All functions of a sins_sim, except those that destroy it and that read its last failure. */
static inline void every_call(sins_sim *sim, every_call_answer *answer, void *context)
{
    EVERY_CALL_STORAGE sins_options options[2];
    EVERY_CALL_STORAGE sins_flight_sample flight_sample[2];
    EVERY_CALL_STORAGE sins_gyro_params gyro_params[2];
    EVERY_CALL_STORAGE sins_accel_params accel_params[2];
    EVERY_CALL_STORAGE sins_altimeter_params altimeter_params[2];
    EVERY_CALL_STORAGE sins_navigation navigation[2];
    EVERY_CALL_STORAGE sins_errors errors[2];
    EVERY_CALL_STORAGE sins_imu imu[2];
    EVERY_CALL_STORAGE sins_accuracy accuracy[2];
    EVERY_CALL_STORAGE sins_truth_summary truth_summary[2];
    EVERY_CALL_STORAGE sins_covariance covariance[2];
    EVERY_CALL_STORAGE sins_record record[2];
    EVERY_CALL_STORAGE sins_failure failure[2];
    EVERY_CALL_STORAGE sins_initial_errors initial_errors[2];
    EVERY_CALL_STORAGE sins_mounting mounting[2];
    EVERY_CALL_STORAGE sins_gravity_params gravity_params[2];
    EVERY_CALL_STORAGE sins_imu_increment imu_increment[2];
    EVERY_CALL_STORAGE sins_correction correction[2];
    EVERY_CALL_STORAGE sins_compensation compensation[2];
    EVERY_CALL_STORAGE unsigned char bytes[SINS_SNAPSHOT_MAX_SIZE] = "";
    size_t size = 0;
    SINS_INIT(options[0]);
    SINS_INIT(options[1]);
    SINS_INIT(flight_sample[0]);
    SINS_INIT(flight_sample[1]);
    flight_sample[1].time_s = 0.01;
    SINS_INIT(gyro_params[0]);
    SINS_INIT(gyro_params[1]);
    gyro_params[0] = scene_gyro();
    SINS_INIT(accel_params[0]);
    SINS_INIT(accel_params[1]);
    accel_params[0] = scene_accel();
    SINS_INIT(altimeter_params[0]);
    SINS_INIT(altimeter_params[1]);
    altimeter_params[0] = scene_altimeter();
    SINS_INIT(navigation[0]);
    SINS_INIT(navigation[1]);
    navigation[0].quaternion_nb[0] = 1.0;
    SINS_INIT(errors[0]);
    SINS_INIT(errors[1]);
    SINS_INIT(imu[0]);
    SINS_INIT(imu[1]);
    SINS_INIT(accuracy[0]);
    SINS_INIT(accuracy[1]);
    SINS_INIT(truth_summary[0]);
    SINS_INIT(truth_summary[1]);
    SINS_INIT(covariance[0]);
    SINS_INIT(covariance[1]);
    SINS_INIT(record[0]);
    SINS_INIT(record[1]);
    SINS_INIT(failure[0]);
    SINS_INIT(failure[1]);
    SINS_INIT(initial_errors[0]);
    SINS_INIT(initial_errors[1]);
    initial_errors[0] = scene_initial_errors();
    SINS_INIT(mounting[0]);
    SINS_INIT(mounting[1]);
    SINS_INIT(gravity_params[0]);
    SINS_INIT(gravity_params[1]);
    SINS_INIT(imu_increment[0]);
    SINS_INIT(imu_increment[1]);
    imu_increment[0].interval_s = 0.01;
    imu_increment[0].count = 1;
    SINS_INIT(correction[0]);
    SINS_INIT(correction[1]);
    SINS_INIT(compensation[0]);
    SINS_INIT(compensation[1]);
    EVERY_CALL(sins_get_options(sim, options));
    EVERY_CALL(sins_get_gyro(sim, gyro_params));
    EVERY_CALL(sins_get_accel(sim, accel_params));
    EVERY_CALL(sins_get_altimeter(sim, altimeter_params));
    EVERY_CALL(sins_get_truth(sim, navigation));
    EVERY_CALL(sins_get_navigation(sim, navigation));
    EVERY_CALL(sins_get_errors(sim, 0, errors));
    EVERY_CALL(sins_get_imu(sim, imu));
    EVERY_CALL(sins_get_accuracy(sim, accuracy));
    EVERY_CALL(sins_get_truth_summary(sim, truth_summary));
    EVERY_CALL(sins_get_covariance(sim, covariance));
    EVERY_CALL(sins_get_record(sim, record));
    EVERY_CALL(sins_get_failure(sim, 0, 0, failure));
    EVERY_CALL(sins_get_initial_errors(sim, initial_errors));
    EVERY_CALL(sins_get_mounting(sim, mounting));
    EVERY_CALL(sins_get_gravity_disturbance(sim, gravity_params));
    EVERY_CALL(sins_get_imu_update(sim, 0, imu_increment));
    EVERY_CALL(sins_get_compensation(sim, compensation));
    EVERY_CALL(sins_set_gyro(sim, gyro_params));
    EVERY_CALL(sins_set_accel(sim, accel_params));
    EVERY_CALL(sins_set_altimeter(sim, altimeter_params));
    EVERY_CALL(sins_set_failure(sim, 0, 0, failure));
    EVERY_CALL(sins_set_initial_errors(sim, initial_errors));
    EVERY_CALL(sins_set_mounting(sim, mounting));
    EVERY_CALL(sins_set_gravity_disturbance(sim, gravity_params));
    EVERY_CALL(sins_push_sample(sim, flight_sample));
    EVERY_CALL(sins_step(sim));
    EVERY_CALL(sins_move_time(sim, 0.0));
    EVERY_CALL(sins_move_truth(sim, flight_sample));
    EVERY_CALL(sins_reposition(sim, flight_sample));
    EVERY_CALL(sins_reset(sim));
    EVERY_CALL(sins_run(sim, flight_sample, 2, 1, record, 2, &size));
    EVERY_CALL(sins_start_navigation(sim, navigation));
    EVERY_CALL(sins_push_imu(sim, imu_increment));
    EVERY_CALL(sins_correct(sim, correction));
    EVERY_CALL(sins_snapshot_size(sim, &size));
    EVERY_CALL(sins_snapshot_save(sim, bytes, sizeof bytes, &size));
    EVERY_CALL(sins_snapshot_load(sim, bytes, size));
}

/* All functions of a sins_flight, except those that destroy it and that read its last failure. */
static inline void every_flight_call(sins_flight *flight, every_call_answer *answer, void *context)
{
    EVERY_CALL_STORAGE sins_flight_sample flight_sample[2];
    double numbers[6] = {0.0};
    SINS_INIT(flight_sample[0]);
    SINS_INIT(flight_sample[1]);
    flight_sample[1].time_s = 0.01;
    EVERY_CALL(sins_flight_duration(flight, numbers));
    EVERY_CALL(sins_flight_sample_at(flight, 0.0, flight_sample));
}

/* All functions of a sins_judge, except those that destroy it and that read its last failure. */
static inline void every_judge_call(sins_judge *judge, every_call_answer *answer, void *context)
{
    EVERY_CALL_STORAGE sins_flight_sample flight_sample[2];
    EVERY_CALL_STORAGE sins_finding finding[2];
    size_t size = 0;
    SINS_INIT(flight_sample[0]);
    SINS_INIT(flight_sample[1]);
    flight_sample[1].time_s = 0.01;
    SINS_INIT(finding[0]);
    SINS_INIT(finding[1]);
    EVERY_CALL(sins_judge_get_findings(judge, finding, 2, &size));
    EVERY_CALL(sins_judge_push(judge, flight_sample));
    EVERY_CALL(sins_judge_push_log(judge, NULL));
}

/* All functions of a sins_identify, except those that destroy it and that read its last failure. */
static inline void every_identify_call(sins_identify *identify, every_call_answer *answer, void *context)
{
    EVERY_CALL_STORAGE sins_flight_sample flight_sample[2];
    EVERY_CALL_STORAGE sins_recorded_increment recorded_increment[2];
    EVERY_CALL_STORAGE sins_identified identified[2];
    EVERY_CALL_STORAGE sins_identified_parameter identified_parameter[2];
    EVERY_CALL_STORAGE sins_identify_check_request identify_check_request[2];
    EVERY_CALL_STORAGE sins_identified_check identified_check[2];
    EVERY_CALL_STORAGE sins_identified_span identified_span[2];
    EVERY_CALL_STORAGE unsigned char bytes[SCENE_RUNS * SINS_SNAPSHOT_MAX_SIZE] = "";
    size_t size = 0;
    SINS_INIT(flight_sample[0]);
    SINS_INIT(flight_sample[1]);
    flight_sample[1].time_s = 0.01;
    SINS_INIT(recorded_increment[0]);
    SINS_INIT(recorded_increment[1]);
    SINS_INIT(identified[0]);
    SINS_INIT(identified[1]);
    SINS_INIT(identified_parameter[0]);
    SINS_INIT(identified_parameter[1]);
    SINS_INIT(identify_check_request[0]);
    SINS_INIT(identify_check_request[1]);
    SINS_INIT(identified_check[0]);
    SINS_INIT(identified_check[1]);
    SINS_INIT(identified_span[0]);
    SINS_INIT(identified_span[1]);
    EVERY_CALL(sins_identify_get_parameter(identify, 0, identified_parameter));
    EVERY_CALL(sins_identify_get_scene(identify, (char *)bytes, sizeof bytes, &size));
    EVERY_CALL(sins_identify_get_span(identify, 0, identified_span));
    EVERY_CALL(sins_identify_push_samples(identify, flight_sample, 2));
    EVERY_CALL(sins_identify_push_increments(identify, recorded_increment, 2));
    EVERY_CALL(sins_identify_solve(identify, identified));
    EVERY_CALL(sins_identify_check(identify, identify_check_request, identified_check));
}

/* All functions of a sins_unit, except those that destroy it and that read its last failure. */
static inline void every_unit_call(sins_unit *unit, sins_sim *sim, every_call_answer *answer, void *context)
{
    EVERY_CALL_STORAGE sins_unit_params unit_params[2];
    EVERY_CALL_STORAGE sins_unit_fix unit_fix[2];
    EVERY_CALL_STORAGE sins_unit_status unit_status[2];
    EVERY_CALL_STORAGE sins_unit_navigation unit_navigation[2];
    EVERY_CALL_STORAGE unsigned char bytes[SCENE_RUNS * SINS_SNAPSHOT_MAX_SIZE] = "";
    size_t size = 0;
    SINS_INIT(unit_params[0]);
    SINS_INIT(unit_params[1]);
    SINS_INIT(unit_fix[0]);
    SINS_INIT(unit_fix[1]);
    SINS_INIT(unit_status[0]);
    SINS_INIT(unit_status[1]);
    SINS_INIT(unit_navigation[0]);
    SINS_INIT(unit_navigation[1]);
    EVERY_CALL(sins_unit_get_params(unit, unit_params));
    EVERY_CALL(sins_unit_get_status(unit, unit_status));
    EVERY_CALL(sins_unit_get_navigation(unit, sim, unit_navigation));
    EVERY_CALL(sins_unit_set_params(unit, unit_params));
    EVERY_CALL(sins_unit_set_power(unit, 0));
    EVERY_CALL(sins_unit_set_alignment(unit, 0));
    EVERY_CALL(sins_unit_set_stored(unit, 0.0, 0.0, 0.0));
    EVERY_CALL(sins_unit_select(unit, 0));
    EVERY_CALL(sins_unit_press_test(unit));
    EVERY_CALL(sins_unit_enter_position(unit, 0.0, 0.0));
    EVERY_CALL(sins_unit_enter_heading(unit, 0.0));
    EVERY_CALL(sins_unit_update(unit, sim));
    EVERY_CALL(sins_unit_push_fix(unit, sim, unit_fix));
    EVERY_CALL(sins_unit_snapshot_save(unit, bytes, sizeof bytes, &size));
    EVERY_CALL(sins_unit_snapshot_load(unit, bytes, size));
}

/* All functions of a sins_ensemble, except those that destroy it and that read its last failure. */
static inline void every_ensemble_call(sins_ensemble *ensemble, every_call_answer *answer, void *context)
{
    EVERY_CALL_STORAGE sins_flight_sample flight_sample[2];
    EVERY_CALL_STORAGE sins_navigation navigation[2];
    EVERY_CALL_STORAGE sins_errors errors[2];
    EVERY_CALL_STORAGE sins_imu imu[2];
    EVERY_CALL_STORAGE sins_failure failure[2];
    EVERY_CALL_STORAGE sins_correction correction[2];
    EVERY_CALL_STORAGE sins_compensation compensation[2];
    EVERY_CALL_STORAGE sins_statistics statistics[2];
    EVERY_CALL_STORAGE unsigned char bytes[SCENE_RUNS * SINS_SNAPSHOT_MAX_SIZE] = "";
    size_t size = 0;
    uint64_t word = 0;
    SINS_INIT(flight_sample[0]);
    SINS_INIT(flight_sample[1]);
    flight_sample[1].time_s = 0.01;
    SINS_INIT(navigation[0]);
    SINS_INIT(navigation[1]);
    navigation[0].quaternion_nb[0] = 1.0;
    SINS_INIT(errors[0]);
    SINS_INIT(errors[1]);
    SINS_INIT(imu[0]);
    SINS_INIT(imu[1]);
    SINS_INIT(failure[0]);
    SINS_INIT(failure[1]);
    SINS_INIT(correction[0]);
    SINS_INIT(correction[1]);
    SINS_INIT(compensation[0]);
    SINS_INIT(compensation[1]);
    SINS_INIT(statistics[0]);
    SINS_INIT(statistics[1]);
    EVERY_CALL(sins_ensemble_get_runs(ensemble, &word, &size));
    EVERY_CALL(sins_ensemble_get_truth(ensemble, navigation));
    EVERY_CALL(sins_ensemble_get_navigation(ensemble, SCENE_FIRST_RUN, navigation));
    EVERY_CALL(sins_ensemble_get_errors(ensemble, SCENE_FIRST_RUN, 0, errors));
    EVERY_CALL(sins_ensemble_get_all_errors(ensemble, 0, errors, 2));
    EVERY_CALL(sins_ensemble_get_imu(ensemble, SCENE_FIRST_RUN, imu));
    EVERY_CALL(sins_ensemble_get_diverged(ensemble, 0, &word));
    EVERY_CALL(sins_ensemble_get_compensation(ensemble, SCENE_FIRST_RUN, compensation));
    EVERY_CALL(sins_ensemble_get_statistics(ensemble, 0, statistics));
    EVERY_CALL(sins_ensemble_set_failure(ensemble, 0, 0, failure));
    EVERY_CALL(sins_ensemble_push_sample(ensemble, flight_sample));
    EVERY_CALL(sins_ensemble_step(ensemble));
    EVERY_CALL(sins_ensemble_run(ensemble, flight_sample, 2));
    EVERY_CALL(sins_ensemble_reposition(ensemble, flight_sample));
    EVERY_CALL(sins_ensemble_reset(ensemble));
    EVERY_CALL(sins_ensemble_correct(ensemble, SCENE_FIRST_RUN, correction));
    EVERY_CALL(sins_ensemble_snapshot_size(ensemble, &size));
    EVERY_CALL(sins_ensemble_snapshot_save(ensemble, bytes, sizeof bytes, &size));
    EVERY_CALL(sins_ensemble_snapshot_load(ensemble, bytes, size));
}

/* All functions of a sins_scene, except those that destroy it and that read its last failure. */
static inline void every_scene_call(sins_scene *scene, sins_sim *sim, every_call_answer *answer, void *context)
{
    EVERY_CALL_STORAGE sins_options options[2];
    EVERY_CALL_STORAGE sins_flight_sample flight_sample[2];
    EVERY_CALL_STORAGE sins_failure failure[2];
    EVERY_CALL_STORAGE sins_flight_start flight_start[2];
    EVERY_CALL_STORAGE sins_manoeuvre manoeuvre[2];
    EVERY_CALL_STORAGE sins_fault fault[2];
    EVERY_CALL_STORAGE sins_scene_setup scene_setup[2];
    EVERY_CALL_STORAGE sins_planned_failure planned_failure[2];
    EVERY_CALL_STORAGE sins_scene_samples scene_samples[2];
    sins_sim *made_sim = NULL;
    sins_flight *made_flight = NULL;
    sins_unit *made_unit = NULL;
    sins_play *made_play = NULL;
    sins_ensemble *ensemble = scene_ensemble();
    sins_unit *unit = scene_unit();
    EVERY_CALL_STORAGE unsigned char bytes[SCENE_RUNS * SINS_SNAPSHOT_MAX_SIZE] = "";
    size_t size = 0;
    SINS_INIT(options[0]);
    SINS_INIT(options[1]);
    SINS_INIT(flight_sample[0]);
    SINS_INIT(flight_sample[1]);
    flight_sample[1].time_s = 0.01;
    SINS_INIT(failure[0]);
    SINS_INIT(failure[1]);
    SINS_INIT(flight_start[0]);
    SINS_INIT(flight_start[1]);
    flight_start[0].speed_m_s = 100.0;
    SINS_INIT(manoeuvre[0]);
    SINS_INIT(manoeuvre[1]);
    manoeuvre[0].duration_s = manoeuvre[1].duration_s = 60.0;
    manoeuvre[0].kind = manoeuvre[1].kind = SINS_MANOEUVRE_STRAIGHT;
    SINS_INIT(fault[0]);
    SINS_INIT(fault[1]);
    SINS_INIT(scene_setup[0]);
    SINS_INIT(scene_setup[1]);
    SINS_INIT(planned_failure[0]);
    SINS_INIT(planned_failure[1]);
    SINS_INIT(scene_samples[0]);
    SINS_INIT(scene_samples[1]);
    EVERY_CALL(sins_scene_get_fault(scene, 0, fault));
    EVERY_CALL(sins_scene_get_options(scene, options));
    EVERY_CALL(sins_scene_get_setup(scene, scene_setup));
    EVERY_CALL(sins_scene_get_manoeuvres(scene, flight_start, manoeuvre, 2, &size, &size));
    EVERY_CALL(sins_scene_get_text(scene, 0, (char *)bytes, sizeof bytes, &size));
    EVERY_CALL(sins_scene_get_failure_count(scene, &size));
    EVERY_CALL(sins_scene_get_failure(scene, 0, planned_failure));
    EVERY_CALL(sins_scene_get_value(scene, "gyro.bias_deg_h[1]", (char *)bytes, sizeof bytes, &size));
    EVERY_CALL(sins_scene_get_samples(scene, NULL, scene_samples));
    EVERY_CALL(sins_scene_set_manoeuvres(scene, flight_start, manoeuvre, 2, 1));
    EVERY_CALL(sins_scene_set_text(scene, 0, "another"));
    EVERY_CALL(sins_scene_set_values(scene, "gyro.bias_deg_h[1] = 0.5"));
    EVERY_CALL(sins_scene_set_items(scene, "failure", ""));
    EVERY_CALL(sins_scene_write(scene, (char *)bytes, sizeof bytes, &size));
    EVERY_CALL(sins_scene_create_simulator(scene, &made_sim));
    EVERY_CALL(sins_scene_create_flight(scene, &made_flight));
    EVERY_CALL(sins_scene_prepare(scene, sim, 0.0, flight_sample));
    EVERY_CALL(sins_scene_prepare_ensemble(scene, ensemble, 0.0, flight_sample));
    EVERY_CALL(sins_scene_create_unit(scene, &made_unit));
    EVERY_CALL(sins_scene_update_unit(scene, unit, sim, 0.0));
    EVERY_CALL(sins_scene_log_file_name(scene, 0, (char *)bytes, sizeof bytes, &size));
    EVERY_CALL(sins_scene_give_log_file(scene, "patrol", (char *)bytes, 1));
    EVERY_CALL(sins_play_create(scene, NULL, &made_play));
    CHECK(made_sim == NULL || sins_destroy(made_sim) == SINS_OK);
    CHECK(made_flight == NULL || sins_flight_destroy(made_flight) == SINS_OK);
    CHECK(made_unit == NULL || sins_unit_destroy(made_unit) == SINS_OK);
    CHECK(made_play == NULL || sins_play_destroy(made_play) == SINS_OK);
    CHECK(sins_ensemble_destroy(ensemble) == SINS_OK && sins_unit_destroy(unit) == SINS_OK);
}

/* All functions of a sins_log, except those that destroy it and that read its last failure. */
static inline void every_log_call(sins_log *log, every_call_answer *answer, void *context)
{
    EVERY_CALL_STORAGE sins_flight_sample flight_sample[2];
    EVERY_CALL_STORAGE sins_log_info log_info[2];
    uint64_t word = 0;
    SINS_INIT(flight_sample[0]);
    SINS_INIT(flight_sample[1]);
    flight_sample[1].time_s = 0.01;
    SINS_INIT(log_info[0]);
    SINS_INIT(log_info[1]);
    EVERY_CALL(sins_log_get_info(log, log_info));
    EVERY_CALL(sins_log_get_sample(log, 0, flight_sample, &word));
}

/* All functions of a sins_play, except those that destroy it and that read its last failure. */
static inline void every_play_call(sins_play *play, sins_scene *scene, every_call_answer *answer, void *context)
{
    EVERY_CALL_STORAGE sins_flight_sample flight_sample[2];
    EVERY_CALL_STORAGE sins_imu imu[2];
    EVERY_CALL_STORAGE sins_record record[2];
    EVERY_CALL_STORAGE sins_unit_status unit_status[2];
    EVERY_CALL_STORAGE sins_unit_navigation unit_navigation[2];
    sins_sim *made_sim = NULL;
    sins_unit *made_unit = NULL;
    EVERY_CALL_STORAGE unsigned char bytes[SCENE_RUNS * SINS_SNAPSHOT_MAX_SIZE] = "";
    size_t size = 0;
    SINS_INIT(flight_sample[0]);
    SINS_INIT(flight_sample[1]);
    flight_sample[1].time_s = 0.01;
    SINS_INIT(imu[0]);
    SINS_INIT(imu[1]);
    SINS_INIT(record[0]);
    SINS_INIT(record[1]);
    SINS_INIT(unit_status[0]);
    SINS_INIT(unit_status[1]);
    SINS_INIT(unit_navigation[0]);
    SINS_INIT(unit_navigation[1]);
    EVERY_CALL(sins_play_get_simulator(play, &made_sim));
    EVERY_CALL(sins_play_get_unit(play, &made_unit));
    EVERY_CALL(sins_play_get_shown(play, unit_status, unit_navigation));
    EVERY_CALL(sins_play_set_plan(play, scene));
    EVERY_CALL(sins_play_next(play));
    EVERY_CALL(sins_play_push(play, flight_sample));
    EVERY_CALL(sins_play_run(play, record, 2, &size));
    EVERY_CALL(sins_play_run_imu(play, imu, 2, &size));
    EVERY_CALL(sins_play_snapshot_save(play, bytes, sizeof bytes, &size));
    EVERY_CALL(sins_play_snapshot_load(play, bytes, size));
}

/* All functions of no handle. */
static inline void every_other_call(sins_sim *sim, sins_scene *scene, every_call_answer *answer, void *context)
{
    EVERY_CALL_STORAGE sins_options options[2];
    EVERY_CALL_STORAGE sins_flight_sample flight_sample[2];
    EVERY_CALL_STORAGE sins_gyro_params gyro_params[2];
    EVERY_CALL_STORAGE sins_accel_params accel_params[2];
    EVERY_CALL_STORAGE sins_errors errors[2];
    EVERY_CALL_STORAGE sins_covariance covariance[2];
    EVERY_CALL_STORAGE sins_record record[2];
    EVERY_CALL_STORAGE sins_initial_errors initial_errors[2];
    EVERY_CALL_STORAGE sins_flight_start flight_start[2];
    EVERY_CALL_STORAGE sins_manoeuvre manoeuvre[2];
    EVERY_CALL_STORAGE sins_requirement requirement[2];
    EVERY_CALL_STORAGE sins_cost cost[2];
    EVERY_CALL_STORAGE sins_budget_request budget_request[2];
    EVERY_CALL_STORAGE sins_budget_row budget_row[2];
    EVERY_CALL_STORAGE sins_budget budget[2];
    EVERY_CALL_STORAGE sins_identify_request identify_request[2];
    EVERY_CALL_STORAGE sins_unit_params unit_params[2];
    EVERY_CALL_STORAGE sins_unit_status unit_status[2];
    EVERY_CALL_STORAGE sins_unit_navigation unit_navigation[2];
    EVERY_CALL_STORAGE sins_bus_inputs bus_inputs[2];
    EVERY_CALL_STORAGE sins_bus_word bus_word[2];
    EVERY_CALL_STORAGE sins_bus_label bus_label[2];
    EVERY_CALL_STORAGE sins_statistics statistics[2];
    EVERY_CALL_STORAGE sins_figures figures[2];
    EVERY_CALL_STORAGE sins_verdict verdict[2];
    EVERY_CALL_STORAGE sins_fault fault[2];
    EVERY_CALL_STORAGE sins_scene_key scene_key[2];
    sins_sim *made_sim = NULL;
    sins_flight *made_flight = NULL;
    sins_judge *made_judge = NULL;
    sins_identify *made_identify = NULL;
    sins_unit *made_unit = NULL;
    sins_ensemble *made_ensemble = NULL;
    sins_scene *made_scene = NULL;
    sins_log *made_log = NULL;
    EVERY_CALL_STORAGE unsigned char bytes[SCENE_RUNS * SINS_SNAPSHOT_MAX_SIZE] = "";
    size_t size = 0;
    double numbers[6] = {0.0};
    SINS_INIT(options[0]);
    SINS_INIT(options[1]);
    SINS_INIT(flight_sample[0]);
    SINS_INIT(flight_sample[1]);
    flight_sample[1].time_s = 0.01;
    SINS_INIT(gyro_params[0]);
    SINS_INIT(gyro_params[1]);
    gyro_params[0] = scene_gyro();
    SINS_INIT(accel_params[0]);
    SINS_INIT(accel_params[1]);
    accel_params[0] = scene_accel();
    SINS_INIT(errors[0]);
    SINS_INIT(errors[1]);
    SINS_INIT(covariance[0]);
    SINS_INIT(covariance[1]);
    SINS_INIT(record[0]);
    SINS_INIT(record[1]);
    SINS_INIT(initial_errors[0]);
    SINS_INIT(initial_errors[1]);
    initial_errors[0] = scene_initial_errors();
    SINS_INIT(flight_start[0]);
    SINS_INIT(flight_start[1]);
    flight_start[0].speed_m_s = 100.0;
    SINS_INIT(manoeuvre[0]);
    SINS_INIT(manoeuvre[1]);
    manoeuvre[0].duration_s = manoeuvre[1].duration_s = 60.0;
    manoeuvre[0].kind = manoeuvre[1].kind = SINS_MANOEUVRE_STRAIGHT;
    SINS_INIT(requirement[0]);
    SINS_INIT(requirement[1]);
    requirement[0].position_m = 1.0;
    SINS_INIT(cost[0]);
    SINS_INIT(cost[1]);
    SINS_INIT(budget_request[0]);
    SINS_INIT(budget_request[1]);
    SINS_INIT(budget_row[0]);
    SINS_INIT(budget_row[1]);
    SINS_INIT(budget[0]);
    SINS_INIT(budget[1]);
    SINS_INIT(identify_request[0]);
    SINS_INIT(identify_request[1]);
    SINS_INIT(unit_params[0]);
    SINS_INIT(unit_params[1]);
    SINS_INIT(unit_status[0]);
    SINS_INIT(unit_status[1]);
    SINS_INIT(unit_navigation[0]);
    SINS_INIT(unit_navigation[1]);
    SINS_INIT(bus_inputs[0]);
    SINS_INIT(bus_inputs[1]);
    SINS_INIT(bus_word[0]);
    SINS_INIT(bus_word[1]);
    SINS_INIT(bus_label[0]);
    SINS_INIT(bus_label[1]);
    SINS_INIT(statistics[0]);
    SINS_INIT(statistics[1]);
    SINS_INIT(figures[0]);
    SINS_INIT(figures[1]);
    SINS_INIT(verdict[0]);
    SINS_INIT(verdict[1]);
    SINS_INIT(fault[0]);
    SINS_INIT(fault[1]);
    SINS_INIT(scene_key[0]);
    SINS_INIT(scene_key[1]);
    EVERY_CALL(sins_create(options, &made_sim));
    CHECK(made_sim == NULL || sins_destroy(made_sim) == SINS_OK);
    EVERY_CALL(sins_record_line(record, numbers, 6, covariance, (char *)bytes, sizeof bytes, &size));
    EVERY_CALL(sins_gyro_preset(SINS_GRADE_CONSUMER, gyro_params));
    EVERY_CALL(sins_accel_preset(SINS_GRADE_CONSUMER, accel_params));
    EVERY_CALL(sins_initial_preset(SINS_GRADE_CONSUMER, initial_errors));
    EVERY_CALL(sins_flight_create(flight_start, manoeuvre, 2, &made_flight));
    CHECK(made_flight == NULL || sins_flight_destroy(made_flight) == SINS_OK);
    EVERY_CALL(sins_judge_create(options, &made_judge));
    CHECK(made_judge == NULL || sins_judge_destroy(made_judge) == SINS_OK);
    EVERY_CALL(sins_recommend(sim, flight_sample, 2, requirement, options, cost));
    EVERY_CALL(sins_error_budget(sim, flight_sample, 2, budget_request, budget_row, 2, &size, budget));
    EVERY_CALL(sins_identify_create(options, identify_request, &made_identify));
    CHECK(made_identify == NULL || sins_identify_destroy(made_identify) == SINS_OK);
    EVERY_CALL(sins_unit_create(unit_params, 0, &made_unit));
    CHECK(made_unit == NULL || sins_unit_destroy(made_unit) == SINS_OK);
    EVERY_CALL(sins_bus_words(unit_status, unit_navigation, bus_inputs, 0.0, 0.0, bus_word, 2, &size));
    EVERY_CALL(sins_bus_get_label(0, bus_label));
    EVERY_CALL(sins_bus_decode(0x600000cb, 0, bus_label));
    EVERY_CALL(sins_ensemble_create(sim, SCENE_FIRST_RUN, 1, &made_ensemble));
    CHECK(made_ensemble == NULL || sins_ensemble_destroy(made_ensemble) == SINS_OK);
    EVERY_CALL(sins_statistics_add(statistics, errors));
    EVERY_CALL(sins_statistics_merge(statistics, statistics + 1));
    EVERY_CALL(sins_statistics_figures(statistics, figures));
    EVERY_CALL(sins_meets(statistics, 1.0, 95.0, verdict));
    EVERY_CALL(sins_scene_create(&made_scene));
    CHECK(made_scene == NULL || sins_scene_destroy(made_scene) == SINS_OK);
    EVERY_CALL(sins_scene_parse((char *)bytes, 1, &made_scene));
    CHECK(made_scene == NULL || sins_scene_destroy(made_scene) == SINS_OK);
    EVERY_CALL(sins_scene_create_builtin("patrol", &made_scene));
    CHECK(made_scene == NULL || sins_scene_destroy(made_scene) == SINS_OK);
    EVERY_CALL(sins_scene_builtin_name(0, (char *)bytes, sizeof bytes, &size));
    EVERY_CALL(sins_scene_write_keys((char *)bytes, sizeof bytes, &size));
    EVERY_CALL(sins_scene_get_key(0, scene_key));
    EVERY_CALL(sins_log_parse((char *)bytes, 1, scene, &made_log, fault));
    CHECK(made_log == NULL || sins_log_destroy(made_log) == SINS_OK);
    EVERY_CALL(sins_log_create(flight_sample, 2, &made_log));
    CHECK(made_log == NULL || sins_log_destroy(made_log) == SINS_OK);
}

/* Every function with null for each pointer that may not be null. */
static inline void null_calls(sins_sim *sim, sins_flight *flight, sins_judge *judge, sins_identify *identify, sins_unit *unit, sins_ensemble *ensemble, sins_scene *scene, sins_log *log, sins_play *play, every_call_answer *answer, void *context)
{
    EVERY_CALL_STORAGE sins_options options[2];
    EVERY_CALL_STORAGE sins_flight_sample flight_sample[2];
    EVERY_CALL_STORAGE sins_errors errors[2];
    EVERY_CALL_STORAGE sins_covariance covariance[2];
    EVERY_CALL_STORAGE sins_record record[2];
    EVERY_CALL_STORAGE sins_failure failure[2];
    EVERY_CALL_STORAGE sins_flight_start flight_start[2];
    EVERY_CALL_STORAGE sins_manoeuvre manoeuvre[2];
    EVERY_CALL_STORAGE sins_finding finding[2];
    EVERY_CALL_STORAGE sins_requirement requirement[2];
    EVERY_CALL_STORAGE sins_cost cost[2];
    EVERY_CALL_STORAGE sins_budget_request budget_request[2];
    EVERY_CALL_STORAGE sins_budget_row budget_row[2];
    EVERY_CALL_STORAGE sins_budget budget[2];
    EVERY_CALL_STORAGE sins_identify_request identify_request[2];
    EVERY_CALL_STORAGE sins_unit_params unit_params[2];
    EVERY_CALL_STORAGE sins_unit_status unit_status[2];
    EVERY_CALL_STORAGE sins_unit_navigation unit_navigation[2];
    EVERY_CALL_STORAGE sins_bus_inputs bus_inputs[2];
    EVERY_CALL_STORAGE sins_bus_word bus_word[2];
    EVERY_CALL_STORAGE sins_statistics statistics[2];
    EVERY_CALL_STORAGE sins_figures figures[2];
    EVERY_CALL_STORAGE sins_verdict verdict[2];
    EVERY_CALL_STORAGE sins_fault fault[2];
    sins_flight *made_flight = NULL;
    sins_scene *made_scene = NULL;
    sins_log *made_log = NULL;
    EVERY_CALL_STORAGE unsigned char bytes[SCENE_RUNS * SINS_SNAPSHOT_MAX_SIZE] = "";
    size_t size = 0;
    uint64_t word = 0;
    double numbers[6] = {0.0};
    SINS_INIT(options[0]);
    SINS_INIT(options[1]);
    SINS_INIT(flight_sample[0]);
    SINS_INIT(flight_sample[1]);
    flight_sample[1].time_s = 0.01;
    SINS_INIT(errors[0]);
    SINS_INIT(errors[1]);
    SINS_INIT(covariance[0]);
    SINS_INIT(covariance[1]);
    SINS_INIT(record[0]);
    SINS_INIT(record[1]);
    SINS_INIT(failure[0]);
    SINS_INIT(failure[1]);
    SINS_INIT(flight_start[0]);
    SINS_INIT(flight_start[1]);
    flight_start[0].speed_m_s = 100.0;
    SINS_INIT(manoeuvre[0]);
    SINS_INIT(manoeuvre[1]);
    manoeuvre[0].duration_s = manoeuvre[1].duration_s = 60.0;
    manoeuvre[0].kind = manoeuvre[1].kind = SINS_MANOEUVRE_STRAIGHT;
    SINS_INIT(finding[0]);
    SINS_INIT(finding[1]);
    SINS_INIT(requirement[0]);
    SINS_INIT(requirement[1]);
    requirement[0].position_m = 1.0;
    SINS_INIT(cost[0]);
    SINS_INIT(cost[1]);
    SINS_INIT(budget_request[0]);
    SINS_INIT(budget_request[1]);
    SINS_INIT(budget_row[0]);
    SINS_INIT(budget_row[1]);
    SINS_INIT(budget[0]);
    SINS_INIT(budget[1]);
    SINS_INIT(identify_request[0]);
    SINS_INIT(identify_request[1]);
    SINS_INIT(unit_params[0]);
    SINS_INIT(unit_params[1]);
    SINS_INIT(unit_status[0]);
    SINS_INIT(unit_status[1]);
    SINS_INIT(unit_navigation[0]);
    SINS_INIT(unit_navigation[1]);
    SINS_INIT(bus_inputs[0]);
    SINS_INIT(bus_inputs[1]);
    SINS_INIT(bus_word[0]);
    SINS_INIT(bus_word[1]);
    SINS_INIT(statistics[0]);
    SINS_INIT(statistics[1]);
    SINS_INIT(figures[0]);
    SINS_INIT(figures[1]);
    SINS_INIT(verdict[0]);
    SINS_INIT(verdict[1]);
    SINS_INIT(fault[0]);
    SINS_INIT(fault[1]);
    EVERY_CALL(sins_create(options, NULL));
    EVERY_CALL(sins_get_options(sim, NULL));
    EVERY_CALL(sins_push_sample(sim, NULL));
    EVERY_CALL(sins_move_truth(sim, NULL));
    EVERY_CALL(sins_reposition(sim, NULL));
    EVERY_CALL(sins_set_gyro(sim, NULL));
    EVERY_CALL(sins_get_gyro(sim, NULL));
    EVERY_CALL(sins_set_accel(sim, NULL));
    EVERY_CALL(sins_get_accel(sim, NULL));
    EVERY_CALL(sins_set_altimeter(sim, NULL));
    EVERY_CALL(sins_get_altimeter(sim, NULL));
    EVERY_CALL(sins_get_truth(sim, NULL));
    EVERY_CALL(sins_get_navigation(sim, NULL));
    EVERY_CALL(sins_get_errors(sim, 0, NULL));
    EVERY_CALL(sins_get_imu(sim, NULL));
    EVERY_CALL(sins_get_accuracy(sim, NULL));
    EVERY_CALL(sins_get_truth_summary(sim, NULL));
    EVERY_CALL(sins_get_covariance(sim, NULL));
    EVERY_CALL(sins_get_record(sim, NULL));
    EVERY_CALL(sins_record_line(record, numbers, 6, covariance, NULL, sizeof bytes, &size));
    EVERY_CALL(sins_run(sim, NULL, 2, 1, record, 2, &size));
    EVERY_CALL(sins_run(sim, flight_sample, 2, 1, NULL, 2, &size));
    EVERY_CALL(sins_set_failure(sim, 0, 0, NULL));
    EVERY_CALL(sins_get_failure(sim, 0, 0, NULL));
    EVERY_CALL(sins_set_initial_errors(sim, NULL));
    EVERY_CALL(sins_get_initial_errors(sim, NULL));
    EVERY_CALL(sins_set_mounting(sim, NULL));
    EVERY_CALL(sins_get_mounting(sim, NULL));
    EVERY_CALL(sins_set_gravity_disturbance(sim, NULL));
    EVERY_CALL(sins_get_gravity_disturbance(sim, NULL));
    EVERY_CALL(sins_gyro_preset(SINS_GRADE_CONSUMER, NULL));
    EVERY_CALL(sins_accel_preset(SINS_GRADE_CONSUMER, NULL));
    EVERY_CALL(sins_initial_preset(SINS_GRADE_CONSUMER, NULL));
    EVERY_CALL(sins_get_imu_update(sim, 0, NULL));
    EVERY_CALL(sins_start_navigation(sim, NULL));
    EVERY_CALL(sins_push_imu(sim, NULL));
    EVERY_CALL(sins_correct(sim, NULL));
    EVERY_CALL(sins_get_compensation(sim, NULL));
    EVERY_CALL(sins_snapshot_size(sim, NULL));
    EVERY_CALL(sins_snapshot_save(sim, NULL, sizeof bytes, &size));
    EVERY_CALL(sins_snapshot_load(sim, NULL, size));
    EVERY_CALL(sins_flight_create(NULL, manoeuvre, 2, &made_flight));
    EVERY_CALL(sins_flight_create(flight_start, NULL, 2, &made_flight));
    EVERY_CALL(sins_flight_create(flight_start, manoeuvre, 2, NULL));
    EVERY_CALL(sins_flight_duration(flight, NULL));
    EVERY_CALL(sins_flight_sample_at(flight, 0.0, NULL));
    EVERY_CALL(sins_judge_create(options, NULL));
    EVERY_CALL(sins_judge_push(judge, NULL));
    EVERY_CALL(sins_judge_get_findings(judge, NULL, 2, &size));
    EVERY_CALL(sins_judge_get_findings(judge, finding, 2, NULL));
    EVERY_CALL(sins_recommend(sim, NULL, 2, requirement, options, cost));
    EVERY_CALL(sins_recommend(sim, flight_sample, 2, NULL, options, cost));
    EVERY_CALL(sins_recommend(sim, flight_sample, 2, requirement, NULL, cost));
    EVERY_CALL(sins_recommend(sim, flight_sample, 2, requirement, options, NULL));
    EVERY_CALL(sins_error_budget(sim, NULL, 2, budget_request, budget_row, 2, &size, budget));
    EVERY_CALL(sins_error_budget(sim, flight_sample, 2, budget_request, NULL, 2, &size, budget));
    EVERY_CALL(sins_identify_create(options, identify_request, NULL));
    EVERY_CALL(sins_identify_push_samples(identify, NULL, 2));
    EVERY_CALL(sins_identify_push_increments(identify, NULL, 2));
    EVERY_CALL(sins_identify_get_parameter(identify, 0, NULL));
    EVERY_CALL(sins_identify_get_scene(identify, NULL, sizeof bytes, &size));
    EVERY_CALL(sins_identify_get_span(identify, 0, NULL));
    EVERY_CALL(sins_unit_create(unit_params, 0, NULL));
    EVERY_CALL(sins_unit_set_params(unit, NULL));
    EVERY_CALL(sins_unit_get_params(unit, NULL));
    EVERY_CALL(sins_unit_push_fix(unit, sim, NULL));
    EVERY_CALL(sins_unit_snapshot_save(unit, NULL, sizeof bytes, &size));
    EVERY_CALL(sins_unit_snapshot_load(unit, NULL, size));
    EVERY_CALL(sins_unit_get_status(unit, NULL));
    EVERY_CALL(sins_unit_get_navigation(unit, sim, NULL));
    EVERY_CALL(sins_bus_words(NULL, unit_navigation, bus_inputs, 0.0, 0.0, bus_word, 2, &size));
    EVERY_CALL(sins_bus_words(unit_status, NULL, bus_inputs, 0.0, 0.0, bus_word, 2, &size));
    EVERY_CALL(sins_bus_words(unit_status, unit_navigation, bus_inputs, 0.0, 0.0, bus_word, 2, NULL));
    EVERY_CALL(sins_bus_get_label(0, NULL));
    EVERY_CALL(sins_bus_decode(0x600000cb, 0, NULL));
    EVERY_CALL(sins_ensemble_create(sim, SCENE_FIRST_RUN, 1, NULL));
    EVERY_CALL(sins_ensemble_push_sample(ensemble, NULL));
    EVERY_CALL(sins_ensemble_run(ensemble, NULL, 2));
    EVERY_CALL(sins_ensemble_reposition(ensemble, NULL));
    EVERY_CALL(sins_ensemble_set_failure(ensemble, 0, 0, NULL));
    EVERY_CALL(sins_ensemble_get_truth(ensemble, NULL));
    EVERY_CALL(sins_ensemble_get_navigation(ensemble, SCENE_FIRST_RUN, NULL));
    EVERY_CALL(sins_ensemble_get_errors(ensemble, SCENE_FIRST_RUN, 0, NULL));
    EVERY_CALL(sins_ensemble_get_all_errors(ensemble, 0, NULL, 2));
    EVERY_CALL(sins_ensemble_get_imu(ensemble, SCENE_FIRST_RUN, NULL));
    EVERY_CALL(sins_ensemble_get_diverged(ensemble, 0, NULL));
    EVERY_CALL(sins_ensemble_correct(ensemble, SCENE_FIRST_RUN, NULL));
    EVERY_CALL(sins_ensemble_get_compensation(ensemble, SCENE_FIRST_RUN, NULL));
    EVERY_CALL(sins_ensemble_get_statistics(ensemble, 0, NULL));
    EVERY_CALL(sins_statistics_add(NULL, errors));
    EVERY_CALL(sins_statistics_add(statistics, NULL));
    EVERY_CALL(sins_statistics_merge(NULL, statistics + 1));
    EVERY_CALL(sins_statistics_merge(statistics, NULL));
    EVERY_CALL(sins_statistics_figures(NULL, figures));
    EVERY_CALL(sins_statistics_figures(statistics, NULL));
    EVERY_CALL(sins_meets(NULL, 1.0, 95.0, verdict));
    EVERY_CALL(sins_meets(statistics, 1.0, 95.0, NULL));
    EVERY_CALL(sins_ensemble_snapshot_size(ensemble, NULL));
    EVERY_CALL(sins_ensemble_snapshot_save(ensemble, NULL, sizeof bytes, &size));
    EVERY_CALL(sins_ensemble_snapshot_load(ensemble, NULL, size));
    EVERY_CALL(sins_scene_create(NULL));
    EVERY_CALL(sins_scene_parse(NULL, 1, &made_scene));
    EVERY_CALL(sins_scene_parse((char *)bytes, 1, NULL));
    EVERY_CALL(sins_scene_get_fault(scene, 0, NULL));
    EVERY_CALL(sins_scene_create_builtin(NULL, &made_scene));
    EVERY_CALL(sins_scene_create_builtin("patrol", NULL));
    EVERY_CALL(sins_scene_builtin_name(0, NULL, sizeof bytes, &size));
    EVERY_CALL(sins_scene_write(scene, NULL, sizeof bytes, &size));
    EVERY_CALL(sins_scene_write_keys(NULL, sizeof bytes, &size));
    EVERY_CALL(sins_scene_create_simulator(scene, NULL));
    EVERY_CALL(sins_scene_create_flight(scene, NULL));
    EVERY_CALL(sins_scene_prepare(scene, sim, 0.0, NULL));
    EVERY_CALL(sins_scene_prepare_ensemble(scene, ensemble, 0.0, NULL));
    EVERY_CALL(sins_scene_create_unit(scene, NULL));
    EVERY_CALL(sins_scene_get_options(scene, NULL));
    EVERY_CALL(sins_scene_get_setup(scene, NULL));
    EVERY_CALL(sins_scene_get_manoeuvres(scene, flight_start, NULL, 2, &size, &size));
    EVERY_CALL(sins_scene_get_manoeuvres(scene, flight_start, manoeuvre, 2, NULL, &size));
    EVERY_CALL(sins_scene_set_manoeuvres(scene, NULL, manoeuvre, 2, 1));
    EVERY_CALL(sins_scene_set_manoeuvres(scene, flight_start, NULL, 2, 1));
    EVERY_CALL(sins_scene_get_text(scene, 0, NULL, sizeof bytes, &size));
    EVERY_CALL(sins_scene_set_text(scene, 0, NULL));
    EVERY_CALL(sins_scene_get_failure_count(scene, NULL));
    EVERY_CALL(sins_scene_get_failure(scene, 0, NULL));
    EVERY_CALL(sins_scene_get_key(0, NULL));
    EVERY_CALL(sins_scene_get_value(scene, NULL, (char *)bytes, sizeof bytes, &size));
    EVERY_CALL(sins_scene_get_value(scene, "gyro.bias_deg_h[1]", NULL, sizeof bytes, &size));
    EVERY_CALL(sins_scene_set_values(scene, NULL));
    EVERY_CALL(sins_scene_set_items(scene, NULL, ""));
    EVERY_CALL(sins_scene_set_items(scene, "failure", NULL));
    EVERY_CALL(sins_scene_log_file_name(scene, 0, NULL, sizeof bytes, &size));
    EVERY_CALL(sins_scene_give_log_file(scene, NULL, (char *)bytes, 1));
    EVERY_CALL(sins_scene_give_log_file(scene, "patrol", NULL, 1));
    EVERY_CALL(sins_log_parse(NULL, 1, scene, &made_log, fault));
    EVERY_CALL(sins_log_parse((char *)bytes, 1, scene, NULL, fault));
    EVERY_CALL(sins_log_create(NULL, 2, &made_log));
    EVERY_CALL(sins_log_create(flight_sample, 2, NULL));
    EVERY_CALL(sins_log_get_info(log, NULL));
    EVERY_CALL(sins_log_get_sample(log, 0, NULL, &word));
    EVERY_CALL(sins_scene_get_samples(scene, NULL, NULL));
    EVERY_CALL(sins_play_create(scene, NULL, NULL));
    EVERY_CALL(sins_play_push(play, NULL));
    EVERY_CALL(sins_play_run(play, NULL, 2, &size));
    EVERY_CALL(sins_play_run_imu(play, NULL, 2, &size));
    EVERY_CALL(sins_play_get_simulator(play, NULL));
    EVERY_CALL(sins_play_get_unit(play, NULL));
    EVERY_CALL(sins_play_snapshot_save(play, NULL, sizeof bytes, &size));
    EVERY_CALL(sins_play_snapshot_load(play, NULL, size));
}

#endif
