/* Null pointers, and stale, made-up and wrong-kind handles, through every function: every call returns the right status,
 * changes nothing, and leaves its own failure. */

#include <stdint.h>
#include <string.h>

#include "every_call.h"
#include "failure_is.h"

/* The kinds of invalid handles. */
enum { NULL_HANDLE, STALE, MADE_UP, OTHER_KIND, WRONG_HANDLES };

static sins_sim *wrong_sims[WRONG_HANDLES];
static sins_flight *wrong_flights[WRONG_HANDLES];
static sins_scene *wrong_scenes[WRONG_HANDLES];
static sins_log *wrong_logs[WRONG_HANDLES];
static sins_ensemble *wrong_ensembles[WRONG_HANDLES];

static sins_flight *make_flight(void)
{
    sins_flight_start start = {.struct_size = sizeof start};
    sins_manoeuvre rest = {.struct_size = sizeof rest};
    sins_flight *flight = NULL;
    rest.duration_s = 10.0;
    CHECK(sins_flight_create(&start, &rest, 1, &flight) == SINS_OK);
    return flight;
}

static void make_wrong_handles(sins_sim *sim, sins_flight *flight)
{
    sins_sim *stale = NULL;
    sins_flight *stale_flight = make_flight();
    CHECK(sins_create(NULL, &stale) == SINS_OK);
    CHECK(sins_destroy(stale) == SINS_OK);
    CHECK(sins_flight_destroy(stale_flight) == SINS_OK);
    wrong_sims[NULL_HANDLE] = NULL;
    wrong_sims[STALE] = stale;
    wrong_sims[MADE_UP] = (sins_sim *)(uintptr_t)0xdeadbeef;
    wrong_sims[OTHER_KIND] = (sins_sim *)(void *)flight;
    wrong_flights[NULL_HANDLE] = NULL;
    wrong_flights[STALE] = stale_flight;
    wrong_flights[MADE_UP] = (sins_flight *)(uintptr_t)4;
    wrong_flights[OTHER_KIND] = (sins_flight *)(void *)sim;
    wrong_scenes[STALE] = scene_of_text();
    wrong_scenes[MADE_UP] = (sins_scene *)(uintptr_t)3;
    wrong_scenes[OTHER_KIND] = (sins_scene *)(void *)sim;
    wrong_logs[STALE] = scene_log();
    wrong_logs[MADE_UP] = (sins_log *)(uintptr_t)0xfffffff4;
    wrong_logs[OTHER_KIND] = (sins_log *)(void *)flight;
    wrong_ensembles[STALE] = scene_ensemble();
    wrong_ensembles[MADE_UP] = (sins_ensemble *)(uintptr_t)0xfffffff5;
    wrong_ensembles[OTHER_KIND] = (sins_ensemble *)(void *)sim;
    CHECK(sins_ensemble_destroy(wrong_ensembles[STALE]) == SINS_OK);
    CHECK(sins_scene_destroy(wrong_scenes[STALE]) == SINS_OK);
    CHECK(sins_log_destroy(wrong_logs[STALE]) == SINS_OK);
}

/* The call leaves its own failure. The two functions that read failures leave none and are not checked here. */
#define NULL_POINTER(call)                              \
    do {                                                \
        plant(sim);                                     \
        CHECK((call) == SINS_ERROR_NULL_POINTER);       \
        left(sim, #call, SINS_ERROR_NULL_POINTER);      \
    } while (0)

/* Asserts that the answer is SINS_ERROR_BAD_HANDLE. */
static void is_refused(const char *call, sins_status status, void *unused)
{
    (void)unused;
    if (status != SINS_ERROR_BAD_HANDLE) {
        fprintf(stderr, "%s gives %d\n", call, (int)status);
    }
    CHECK(status == SINS_ERROR_BAD_HANDLE);
    left(NULL, call, status);
    plant(NULL);
}

/* sins_recommend() and sins_error_budget() are the only functions that accept NULL for a simulator. */
static sins_status wrong_configured(const sins_sim *sim)
{
    sins_flight_sample piece[2] = {{.struct_size = sizeof piece[0]}, {.time_s = 0.01}};
    sins_requirement requirement = {.struct_size = sizeof requirement, .position_m = 1.0};
    sins_options options = {.struct_size = sizeof options};
    sins_cost cost = {.struct_size = sizeof cost};
    sins_budget_row row[1] = {{.struct_size = sizeof row[0]}};
    sins_status status = sins_recommend(sim, piece, 2, &requirement, &options, &cost);
    char text[100];
    CHECK(options.subsamples == 0 && cost.tried == 0);
    CHECK(sins_last_error(NULL, text, sizeof text, NULL) == SINS_OK && strstr(text, "configured: ") == text);
    plant(NULL);
    CHECK(sins_error_budget(sim, piece, 2, NULL, row, 1, NULL, NULL) == status && row[0].position_m == 0.0);
    CHECK(sins_last_error(NULL, text, sizeof text, NULL) == SINS_OK && strstr(text, "configured: ") == text);
    return status;
}

/* An invalid handle makes no ensemble. */
static void wrong_template(const sins_sim *sim)
{
    sins_ensemble *made = NULL;
    char text[100];
    CHECK(sins_ensemble_create(sim, 0, 1, &made) == SINS_ERROR_BAD_HANDLE && made == NULL);
    CHECK(sins_last_error(NULL, text, sizeof text, NULL) == SINS_OK && strstr(text, "configured: ") == text);
}

static void handles(sins_sim *living)
{
    sins_scene *scene = scene_of_text();
    int i;
    for (i = 0; i < WRONG_HANDLES; i++) {
        sins_sim *sim = wrong_sims[i];
        sins_flight_sample sample = {.struct_size = sizeof sample};
        size_t written = 77, needed = 77;
        double duration = -1.0;
        char text[8] = "before";
        sins_error_info info = {.struct_size = sizeof info};

        plant(NULL);
        every_call(sim, is_refused, NULL);
        every_flight_call(wrong_flights[i], is_refused, NULL);
        every_scene_call(wrong_scenes[i], living, is_refused, NULL);
        every_fault_call(wrong_scenes[i], is_refused, NULL);
        every_log_call(wrong_logs[i], is_refused, NULL);
        every_ensemble_call(wrong_ensembles[i], is_refused, NULL);
        wrong_template(sim);
        is_refused("sins_scene_prepare_ensemble", sins_scene_prepare_ensemble(scene, wrong_ensembles[i], 0.0, &sample),
                   NULL);
        is_refused("sins_ensemble_destroy", sins_ensemble_destroy(wrong_ensembles[i]), NULL);
        is_refused("sins_scene_prepare", sins_scene_prepare(scene, sim, 0.0, &sample), NULL);
        is_refused("sins_scene_destroy", sins_scene_destroy(wrong_scenes[i]), NULL);
        is_refused("sins_log_destroy", sins_log_destroy(wrong_logs[i]), NULL);
        is_refused("sins_destroy", sins_destroy(sim), NULL);
        is_refused("sins_flight_destroy", sins_flight_destroy(wrong_flights[i]), NULL);

        /* Nothing is written. */
        CHECK(i == NULL_HANDLE || wrong_configured(sim) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_run(sim, &sample, 1, 0, NULL, 0, &written) == SINS_ERROR_BAD_HANDLE && written == 77);
        CHECK(sins_flight_duration(wrong_flights[i], &duration) == SINS_ERROR_BAD_HANDLE && duration == -1.0);
        if (i != NULL_HANDLE) {
            CHECK(sins_last_error(sim, text, sizeof text, &needed) == SINS_ERROR_BAD_HANDLE);
            CHECK(needed == 77 && strcmp(text, "before") == 0);
            CHECK(sins_last_error_info(sim, &info) == SINS_ERROR_BAD_HANDLE && info.index == 0);
        }
    }
    CHECK(sins_scene_destroy(scene) == SINS_OK);
}

static void null_pointers_of_scenes(sins_sim *sim)
{
    sins_scene *scene = scene_of_text(), *made = NULL;
    sins_log *log = scene_log(), *made_log = NULL;
    sins_flight_start start = {.struct_size = sizeof start};
    sins_manoeuvre manoeuvres[4] = {{.struct_size = sizeof manoeuvres[0]}};
    char text[16];
    size_t count;
    NULL_POINTER(sins_scene_create(NULL));
    NULL_POINTER(sins_scene_create_builtin(NULL, &made));
    NULL_POINTER(sins_scene_create_builtin("patrol", NULL));
    NULL_POINTER(sins_scene_parse(NULL, 1, &made));
    NULL_POINTER(sins_scene_parse(scene_text, 1, NULL));
    NULL_POINTER(sins_scene_get_fault(scene, 0, NULL));
    NULL_POINTER(sins_scene_write(scene, NULL, 100, NULL));
    NULL_POINTER(sins_scene_write_keys(NULL, 100, NULL));
    NULL_POINTER(sins_scene_get_key(0, NULL));
    NULL_POINTER(sins_scene_get_value(scene, NULL, text, sizeof text, NULL));
    NULL_POINTER(sins_scene_get_value(scene, "gyro.bias_deg_h", NULL, 100, NULL));
    NULL_POINTER(sins_scene_set_values(scene, NULL));
    NULL_POINTER(sins_scene_set_items(scene, NULL, ""));
    NULL_POINTER(sins_scene_set_items(scene, "failure", NULL));
    NULL_POINTER(sins_scene_get_samples(scene, log, NULL));
    NULL_POINTER(sins_scene_create_simulator(scene, NULL));
    NULL_POINTER(sins_scene_create_flight(scene, NULL));
    NULL_POINTER(sins_scene_prepare(scene, sim, 0.0, NULL));
    NULL_POINTER(sins_scene_prepare_ensemble(scene, NULL, 0.0, NULL));
    NULL_POINTER(sins_scene_get_options(scene, NULL));
    NULL_POINTER(sins_scene_get_setup(scene, NULL));
    NULL_POINTER(sins_scene_get_text(scene, SINS_SCENE_TEXT_TITLE, NULL, 100, NULL));
    NULL_POINTER(sins_scene_set_text(scene, SINS_SCENE_TEXT_TITLE, NULL));
    NULL_POINTER(sins_scene_get_failure_count(scene, NULL));
    NULL_POINTER(sins_scene_get_failure(scene, 0, NULL));
    NULL_POINTER(sins_scene_builtin_name(0, NULL, 100, NULL));
    NULL_POINTER(sins_scene_get_manoeuvres(scene, &start, NULL, 4, &count, NULL));
    NULL_POINTER(sins_scene_get_manoeuvres(scene, &start, manoeuvres, 4, NULL, NULL));
    NULL_POINTER(sins_scene_set_manoeuvres(scene, NULL, manoeuvres, 4, 1));
    NULL_POINTER(sins_scene_set_manoeuvres(scene, &start, NULL, 4, 1));
    NULL_POINTER(sins_log_parse(NULL, 1, &made_log, NULL));
    NULL_POINTER(sins_log_parse(scene_log_text, 1, NULL, NULL));
    NULL_POINTER(sins_log_get_info(log, NULL));
    NULL_POINTER(sins_log_get_sample(log, 0, NULL, NULL));
    CHECK(made == NULL && made_log == NULL);
    CHECK(sins_scene_destroy(scene) == SINS_OK && sins_log_destroy(log) == SINS_OK);
}

static void null_pointers_of_ensembles(sins_sim *sim)
{
    static sins_statistics statistics;
    sins_figures figures = {.struct_size = sizeof figures};
    sins_ensemble *ensemble = scene_ensemble();
    sins_flight_sample sample = {.struct_size = sizeof sample};
    SINS_INIT(statistics);
    CHECK(sins_ensemble_push_sample(ensemble, &sample) == SINS_OK);
    sample.time_s = 0.01;
    CHECK(sins_ensemble_run(ensemble, &sample, 1) == SINS_OK);
    NULL_POINTER(sins_ensemble_create(sim, 0, 1, NULL));
    NULL_POINTER(sins_ensemble_push_sample(ensemble, NULL));
    NULL_POINTER(sins_ensemble_run(ensemble, NULL, 1));
    NULL_POINTER(sins_ensemble_reposition(ensemble, NULL));
    NULL_POINTER(sins_ensemble_set_failure(ensemble, SINS_SENSOR_GYRO, 0, NULL));
    NULL_POINTER(sins_ensemble_get_truth(ensemble, NULL));
    NULL_POINTER(sins_ensemble_get_navigation(ensemble, SCENE_FIRST_RUN, NULL));
    NULL_POINTER(sins_ensemble_get_imu(ensemble, SCENE_FIRST_RUN, NULL));
    NULL_POINTER(sins_ensemble_get_errors(ensemble, SCENE_FIRST_RUN, SINS_ERRORS_NAVIGATION, NULL));
    NULL_POINTER(sins_ensemble_get_diverged(ensemble, 0, NULL));
    NULL_POINTER(sins_ensemble_get_statistics(ensemble, SINS_ERRORS_NAVIGATION, NULL));
    NULL_POINTER(sins_ensemble_snapshot_size(ensemble, NULL));
    NULL_POINTER(sins_ensemble_snapshot_save(ensemble, NULL, 100000, NULL));
    NULL_POINTER(sins_ensemble_snapshot_load(ensemble, NULL, 0));
    NULL_POINTER(sins_statistics_merge(NULL, &statistics));
    NULL_POINTER(sins_statistics_merge(&statistics, NULL));
    NULL_POINTER(sins_statistics_figures(NULL, &figures));
    NULL_POINTER(sins_statistics_figures(&statistics, NULL));
    CHECK(sins_ensemble_destroy(ensemble) == SINS_OK);
}

static void null_pointers(sins_sim *sim, sins_flight *flight)
{
    sins_flight_start start = {.struct_size = sizeof start};
    sins_manoeuvre rest = {.struct_size = sizeof rest};
    sins_flight *made = NULL;
    sins_flight_sample piece[2] = {{.struct_size = sizeof piece[0]}};
    sins_requirement requirement = {.struct_size = sizeof requirement, .position_m = 1.0};
    sins_options options = {.struct_size = sizeof options};
    sins_cost cost = {.struct_size = sizeof cost};
    sins_flight_sample next = {.struct_size = sizeof next, .time_s = 0.02};
    sins_budget_row row[1] = {{.struct_size = sizeof row[0]}};
    sins_record record = {.struct_size = sizeof record};
    char text[16];
    rest.duration_s = 1.0;
    piece[1].time_s = 0.01;

    NULL_POINTER(sins_create(NULL, NULL));
    CHECK(sins_last_error(sim, NULL, 0, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_last_error_info(sim, NULL) == SINS_ERROR_NULL_POINTER);
    NULL_POINTER(sins_set_gyro(sim, NULL));
    NULL_POINTER(sins_set_accel(sim, NULL));
    NULL_POINTER(sins_set_altimeter(sim, NULL));
    NULL_POINTER(sins_set_failure(sim, SINS_SENSOR_GYRO, 0, NULL));
    NULL_POINTER(sins_set_mounting(sim, NULL));
    NULL_POINTER(sins_set_gravity_disturbance(sim, NULL));
    NULL_POINTER(sins_set_initial_errors(sim, NULL));
    NULL_POINTER(sins_get_gyro(sim, NULL));
    NULL_POINTER(sins_get_accel(sim, NULL));
    NULL_POINTER(sins_get_altimeter(sim, NULL));
    NULL_POINTER(sins_get_failure(sim, SINS_SENSOR_GYRO, 0, NULL));
    NULL_POINTER(sins_get_mounting(sim, NULL));
    NULL_POINTER(sins_get_gravity_disturbance(sim, NULL));
    NULL_POINTER(sins_get_initial_errors(sim, NULL));
    NULL_POINTER(sins_push_sample(sim, NULL));
    NULL_POINTER(sins_run(sim, NULL, 1, 0, NULL, 0, NULL));
    NULL_POINTER(sins_run(sim, &next, 1, 1, NULL, 1, NULL));
    NULL_POINTER(sins_get_truth(sim, NULL));
    NULL_POINTER(sins_get_navigation(sim, NULL));
    NULL_POINTER(sins_get_imu(sim, NULL));
    NULL_POINTER(sins_get_errors(sim, SINS_ERRORS_NAVIGATION, NULL));
    NULL_POINTER(sins_get_accuracy(sim, NULL));
    NULL_POINTER(sins_get_record(sim, NULL));
    NULL_POINTER(sins_record_line(&record, NULL, 6, NULL, text, sizeof text, NULL));
    NULL_POINTER(sins_record_line(&record, NULL, 0, NULL, NULL, sizeof text, NULL));
    NULL_POINTER(sins_get_options(sim, NULL));
    NULL_POINTER(sins_start_navigation(sim, NULL));
    NULL_POINTER(sins_push_imu(sim, NULL));
    NULL_POINTER(sins_get_truth_summary(sim, NULL));
    NULL_POINTER(sins_get_covariance(sim, NULL));
    NULL_POINTER(sins_move_truth(sim, NULL));
    NULL_POINTER(sins_reposition(sim, NULL));
    NULL_POINTER(sins_snapshot_size(sim, NULL));
    NULL_POINTER(sins_snapshot_save(sim, NULL, 10000, NULL));
    NULL_POINTER(sins_snapshot_load(sim, NULL, 0));
    NULL_POINTER(sins_gyro_preset(SINS_GRADE_PAPER_SIMULATION2, NULL));
    NULL_POINTER(sins_accel_preset(SINS_GRADE_PAPER_SIMULATION2, NULL));
    NULL_POINTER(sins_flight_create(NULL, &rest, 1, &made));
    NULL_POINTER(sins_flight_create(&start, NULL, 1, &made));
    NULL_POINTER(sins_flight_create(&start, &rest, 1, NULL));
    NULL_POINTER(sins_flight_duration(flight, NULL));
    NULL_POINTER(sins_flight_sample_at(flight, 0.0, NULL));
    CHECK(made == NULL);
    NULL_POINTER(sins_recommend(sim, NULL, 2, &requirement, &options, &cost));
    NULL_POINTER(sins_recommend(sim, piece, 2, NULL, &options, &cost));
    NULL_POINTER(sins_recommend(sim, piece, 2, &requirement, NULL, &cost));
    NULL_POINTER(sins_recommend(sim, piece, 2, &requirement, &options, NULL));
    NULL_POINTER(sins_error_budget(sim, NULL, 2, NULL, row, 1, NULL, NULL));
    NULL_POINTER(sins_error_budget(sim, piece, 2, NULL, NULL, 1, NULL, NULL));
}

int main(void)
{
    sins_options options = {.struct_size = sizeof options};
    sins_sim *sim = NULL;
    sins_flight *flight = make_flight();
    sins_flight_sample sample = {.struct_size = sizeof sample};
    sins_navigation before = {.struct_size = sizeof before}, after = {.struct_size = sizeof after};

    options.error_model = SINS_ERROR_MODEL_RK4;
    CHECK(sins_create(&options, &sim) == SINS_OK);
    CHECK(sins_push_sample(sim, &sample) == SINS_OK);
    sample.time_s = 0.01;
    CHECK(sins_push_sample(sim, &sample) == SINS_OK);
    CHECK(sins_step(sim) == SINS_OK);
    CHECK(sins_get_navigation(sim, &before) == SINS_OK);

    make_wrong_handles(sim, flight);
    handles(sim);
    null_pointers(sim, flight);
    null_pointers_of_scenes(sim);
    null_pointers_of_ensembles(sim);

    CHECK(sins_get_navigation(sim, &after) == SINS_OK);
    CHECK(memcmp(&before, &after, sizeof before) == 0);
    CHECK(sins_destroy(sim) == SINS_OK);
    CHECK(sins_flight_destroy(flight) == SINS_OK);
    printf("misuse: every answer is the right one\n");
    return 0;
}
