/* Calls every function that takes a handle once with valid arguments; `answer` gets each status. */

#ifndef EVERY_CALL_H
#define EVERY_CALL_H

#include "scene.h"

typedef void every_call_answer(const char *call, sins_status status, void *context);

#define EVERY_CALL(call) answer(#call, call, context)

static inline void every_read(sins_sim *sim, every_call_answer *answer, void *context)
{
    sins_navigation navigation = {.struct_size = sizeof navigation};
    sins_imu imu = {.struct_size = sizeof imu};
    sins_errors errors = {.struct_size = sizeof errors};
    sins_accuracy accuracy = {.struct_size = sizeof accuracy};
    sins_record record = {.struct_size = sizeof record};
    sins_truth_summary summary = {.struct_size = sizeof summary};
    sins_covariance covariance = {.struct_size = sizeof covariance};
    EVERY_CALL(sins_get_truth(sim, &navigation));
    EVERY_CALL(sins_get_navigation(sim, &navigation));
    EVERY_CALL(sins_get_imu(sim, &imu));
    EVERY_CALL(sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &errors));
    EVERY_CALL(sins_get_errors(sim, SINS_ERRORS_MODEL, &errors));
    EVERY_CALL(sins_get_accuracy(sim, &accuracy));
    EVERY_CALL(sins_get_record(sim, &record));
    EVERY_CALL(sins_get_truth_summary(sim, &summary));
    EVERY_CALL(sins_get_covariance(sim, &covariance));
}

/* All functions of a simulator except for sins_destroy() and sins_last_error(), which return another status. */
static inline void every_call(sins_sim *sim, every_call_answer *answer, void *context)
{
    sins_gyro_params gyro = scene_gyro();
    sins_accel_params accel = scene_accel();
    sins_altimeter_params altimeter = scene_altimeter();
    sins_initial_errors initial = scene_initial_errors();
    sins_failure failure = {.struct_size = sizeof failure};
    sins_mounting mounting = {.struct_size = sizeof mounting};
    sins_gravity_params gravity = {.struct_size = sizeof gravity};
    sins_flight_sample sample = {.struct_size = sizeof sample};
    sins_navigation start = {.struct_size = sizeof start};
    sins_imu_increment increment = {.struct_size = sizeof increment};
    sins_options options = {.struct_size = sizeof options};
    unsigned char snapshot[SINS_SNAPSHOT_MAX_SIZE];
    size_t size = 0;
    start.quaternion_nb[0] = 1.0;
    increment.interval_s = 0.01;
    increment.count = 1;
    EVERY_CALL(sins_set_gyro(sim, &gyro));
    EVERY_CALL(sins_set_accel(sim, &accel));
    EVERY_CALL(sins_set_altimeter(sim, &altimeter));
    EVERY_CALL(sins_set_failure(sim, SINS_SENSOR_ACCEL, 1, &failure));
    EVERY_CALL(sins_set_initial_errors(sim, &initial));
    EVERY_CALL(sins_set_mounting(sim, &mounting));
    EVERY_CALL(sins_set_gravity_disturbance(sim, &gravity));
    EVERY_CALL(sins_get_options(sim, &options));
    EVERY_CALL(sins_get_gyro(sim, &gyro));
    EVERY_CALL(sins_get_accel(sim, &accel));
    EVERY_CALL(sins_get_altimeter(sim, &altimeter));
    EVERY_CALL(sins_get_failure(sim, SINS_SENSOR_ACCEL, 1, &failure));
    EVERY_CALL(sins_get_initial_errors(sim, &initial));
    EVERY_CALL(sins_get_mounting(sim, &mounting));
    EVERY_CALL(sins_get_gravity_disturbance(sim, &gravity));
    EVERY_CALL(sins_push_sample(sim, &sample));
    EVERY_CALL(sins_step(sim));
    sample.time_s = 0.01;
    EVERY_CALL(sins_run(sim, &sample, 1, 0, NULL, 0, NULL));
    every_read(sim, answer, context);
    EVERY_CALL(sins_snapshot_size(sim, &size));
    EVERY_CALL(sins_snapshot_save(sim, snapshot, sizeof snapshot, &size));
    EVERY_CALL(sins_snapshot_load(sim, snapshot, size));
    EVERY_CALL(sins_move_time(sim, 1.0));
    EVERY_CALL(sins_move_truth(sim, &sample));
    EVERY_CALL(sins_reposition(sim, &sample));
    EVERY_CALL(sins_reset(sim));
    EVERY_CALL(sins_start_navigation(sim, &start));
    EVERY_CALL(sins_push_imu(sim, &increment));
    EVERY_CALL(sins_reset(sim));
}

/* All functions of a flight except for sins_flight_destroy(). */
static inline void every_flight_call(sins_flight *flight, every_call_answer *answer, void *context)
{
    sins_flight_sample sample = {.struct_size = sizeof sample};
    double duration;
    EVERY_CALL(sins_flight_duration(flight, &duration));
    EVERY_CALL(sins_flight_sample_at(flight, 0.0, &sample));
}

/* All functions of an ensemble except for sins_ensemble_destroy(). */
static inline void every_ensemble_call(sins_ensemble *ensemble, every_call_answer *answer, void *context)
{
    unsigned char snapshot[SCENE_RUNS * SINS_SNAPSHOT_MAX_SIZE];
    sins_statistics statistics;
    sins_navigation navigation = {.struct_size = sizeof navigation};
    sins_imu imu = {.struct_size = sizeof imu};
    sins_errors errors = {.struct_size = sizeof errors};
    sins_failure failure = {.struct_size = sizeof failure};
    sins_flight_sample sample = {.struct_size = sizeof sample};
    uint64_t run;
    size_t runs, size = 0;
    SINS_INIT(statistics);
    EVERY_CALL(sins_ensemble_set_failure(ensemble, SINS_SENSOR_ACCEL, 1, &failure));
    EVERY_CALL(sins_ensemble_push_sample(ensemble, &sample));
    EVERY_CALL(sins_ensemble_step(ensemble));
    sample.time_s = 0.01;
    EVERY_CALL(sins_ensemble_run(ensemble, &sample, 1));
    EVERY_CALL(sins_ensemble_get_runs(ensemble, &run, &runs));
    EVERY_CALL(sins_ensemble_get_truth(ensemble, &navigation));
    EVERY_CALL(sins_ensemble_get_navigation(ensemble, SCENE_FIRST_RUN, &navigation));
    EVERY_CALL(sins_ensemble_get_imu(ensemble, SCENE_FIRST_RUN + 1, &imu));
    EVERY_CALL(sins_ensemble_get_errors(ensemble, SCENE_FIRST_RUN + 2, SINS_ERRORS_MODEL, &errors));
    EVERY_CALL(sins_ensemble_get_diverged(ensemble, 0, &run));
    EVERY_CALL(sins_ensemble_get_statistics(ensemble, SINS_ERRORS_NAVIGATION, &statistics));
    EVERY_CALL(sins_ensemble_snapshot_size(ensemble, &size));
    EVERY_CALL(sins_ensemble_snapshot_save(ensemble, snapshot, sizeof snapshot, &size));
    EVERY_CALL(sins_ensemble_snapshot_load(ensemble, snapshot, size));
    EVERY_CALL(sins_ensemble_reposition(ensemble, &sample));
    EVERY_CALL(sins_ensemble_reset(ensemble));
}

/* All functions of a scene except for sins_scene_destroy(). sins_scene_prepare() takes `sim`. */
static inline void every_scene_call(sins_scene *scene, sins_sim *sim, every_call_answer *answer, void *context)
{
    sins_options options = {.struct_size = sizeof options};
    sins_scene_setup setup = {.struct_size = sizeof setup};
    sins_planned_failure failure = {.struct_size = sizeof failure};
    sins_flight_sample sample = {.struct_size = sizeof sample};
    sins_ensemble *ensemble = scene_ensemble();
    sins_sim *made = NULL;
    sins_flight *flight = NULL;
    sins_scene_samples samples = {.struct_size = sizeof samples};
    sins_flight_start start = {.struct_size = sizeof start};
    sins_manoeuvre manoeuvres[1] = {{.struct_size = sizeof manoeuvres[0]}};
    char text[8192];
    size_t count, repeat;
    EVERY_CALL(sins_scene_set_text(scene, SINS_SCENE_TEXT_TITLE, "another"));
    start.speed_m_s = 100.0;
    manoeuvres[0].kind = SINS_MANOEUVRE_STRAIGHT;
    manoeuvres[0].duration_s = 60.0;
    EVERY_CALL(sins_scene_set_manoeuvres(scene, &start, manoeuvres, 1, 2));
    EVERY_CALL(sins_scene_get_manoeuvres(scene, &start, manoeuvres, 1, &count, &repeat));
    EVERY_CALL(sins_scene_get_options(scene, &options));
    EVERY_CALL(sins_scene_get_setup(scene, &setup));
    EVERY_CALL(sins_scene_get_text(scene, SINS_SCENE_TEXT_TITLE, text, sizeof text, NULL));
    EVERY_CALL(sins_scene_set_values(scene, "gyro.bias_deg_h[1] = 0.5\nfailure[0].from_s = 3"));
    EVERY_CALL(sins_scene_get_value(scene, "gyro.bias_deg_h[1]", text, sizeof text, NULL));
    EVERY_CALL(sins_scene_get_samples(scene, NULL, &samples));
    EVERY_CALL(sins_scene_set_items(scene, "manoeuvre", "[[manoeuvre]]\nkind = \"straight\"\nduration_s = 60\n"));
    EVERY_CALL(sins_scene_get_failure_count(scene, &count));
    EVERY_CALL(sins_scene_get_failure(scene, 0, &failure));
    EVERY_CALL(sins_scene_write(scene, text, sizeof text, NULL));
    EVERY_CALL(sins_scene_create_simulator(scene, &made));
    EVERY_CALL(sins_scene_create_flight(scene, &flight));
    EVERY_CALL(sins_scene_prepare(scene, sim, 0.0, &sample));
    EVERY_CALL(sins_scene_prepare_ensemble(scene, ensemble, 0.0, &sample));
    CHECK(sins_ensemble_destroy(ensemble) == SINS_OK);
    CHECK(made == NULL || sins_destroy(made) == SINS_OK);
    CHECK(flight == NULL || sins_flight_destroy(flight) == SINS_OK);
}

/* The function for a scene whose text has faults. */
static inline void every_fault_call(sins_scene *scene, every_call_answer *answer, void *context)
{
    sins_fault fault = {.struct_size = sizeof fault};
    EVERY_CALL(sins_scene_get_fault(scene, 0, &fault));
}

/* All functions of a log except for sins_log_destroy(). */
static inline void every_log_call(sins_log *log, every_call_answer *answer, void *context)
{
    sins_log_info info = {.struct_size = sizeof info};
    sins_flight_sample sample = {.struct_size = sizeof sample};
    uint64_t line;
    EVERY_CALL(sins_log_get_info(log, &info));
    EVERY_CALL(sins_log_get_sample(log, 1, &sample, &line));
}

/* Asserts that the answer is the status at `context`. */
static inline void every_answer_is(const char *call, sins_status status, void *context)
{
    if (status != *(const sins_status *)context) {
        fprintf(stderr, "%s gives %d\n", call, (int)status);
    }
    CHECK(status == *(const sins_status *)context);
}

#endif
