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
static sins_unit *wrong_units[WRONG_HANDLES];
static sins_play *wrong_plays[WRONG_HANDLES];
static sins_judge *wrong_judges[WRONG_HANDLES];
static sins_identify *wrong_identifies[WRONG_HANDLES];

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
    wrong_units[STALE] = scene_unit();
    wrong_units[MADE_UP] = (sins_unit *)(uintptr_t)0xfffffff6;
    wrong_units[OTHER_KIND] = (sins_unit *)(void *)sim;
    wrong_plays[STALE] = scene_play();
    wrong_plays[MADE_UP] = (sins_play *)(uintptr_t)0xfffffff7;
    wrong_plays[OTHER_KIND] = (sins_play *)(void *)sim;
    wrong_judges[STALE] = scene_judge();
    wrong_judges[MADE_UP] = (sins_judge *)(uintptr_t)0xfffffff8;
    wrong_judges[OTHER_KIND] = (sins_judge *)(void *)flight;
    wrong_identifies[STALE] = scene_identify();
    wrong_identifies[MADE_UP] = (sins_identify *)(uintptr_t)0xfffffff9;
    wrong_identifies[OTHER_KIND] = (sins_identify *)(void *)sim;
    CHECK(sins_identify_destroy(wrong_identifies[STALE]) == SINS_OK);
    CHECK(sins_judge_destroy(wrong_judges[STALE]) == SINS_OK);
    CHECK(sins_play_destroy(wrong_plays[STALE]) == SINS_OK);
    CHECK(sins_unit_destroy(wrong_units[STALE]) == SINS_OK);
    CHECK(sins_ensemble_destroy(wrong_ensembles[STALE]) == SINS_OK);
    CHECK(sins_scene_destroy(wrong_scenes[STALE]) == SINS_OK);
    CHECK(sins_log_destroy(wrong_logs[STALE]) == SINS_OK);
}

/* Asserts that the answer is SINS_ERROR_BAD_HANDLE. The sentence of the earlier failure stays, or an argument is at fault. */
static void is_refused(const char *call, sins_status status, void *unused)
{
    (void)unused;
    if (status != SINS_ERROR_BAD_HANDLE) {
        fprintf(stderr, "%s gives %d\n", call, (int)status);
    }
    CHECK(status == SINS_ERROR_BAD_HANDLE);
    if (strstr(sentence_of(NULL), "4711") == NULL) {
        failure_is(NULL, status);
        CHECK(strstr(sentence_of(NULL), ": is null, made up, destroyed, or of another kind") != NULL);
        plant(NULL);
    }
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
    sins_unit *unit = scene_unit();
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
        every_log_call(wrong_logs[i], is_refused, NULL);
        every_ensemble_call(wrong_ensembles[i], is_refused, NULL);
        every_unit_call(wrong_units[i], living, is_refused, NULL);
        every_play_call(wrong_plays[i], scene, is_refused, NULL);
        every_judge_call(wrong_judges[i], is_refused, NULL);
        every_identify_call(wrong_identifies[i], is_refused, NULL);
        is_refused("sins_identify_destroy", sins_identify_destroy(wrong_identifies[i]), NULL);
        is_refused("sins_judge_destroy", sins_judge_destroy(wrong_judges[i]), NULL);
        is_refused("sins_play_destroy", sins_play_destroy(wrong_plays[i]), NULL);
        is_refused("sins_unit_update", sins_unit_update(unit, sim), NULL);
        is_refused("sins_unit_destroy", sins_unit_destroy(wrong_units[i]), NULL);
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
    CHECK(sins_scene_destroy(scene) == SINS_OK && sins_unit_destroy(unit) == SINS_OK);
}

/* A scene in flight whose simulator or unit the host destroyed names it, and can be destroyed. */
static void lent_handles(void)
{
    sins_play *play = scene_play();
    sins_sim *sim = NULL;
    sins_unit *unit = NULL;
    char text[100];
    CHECK(sins_play_next(play) == SINS_OK);
    CHECK(sins_play_get_simulator(play, &sim) == SINS_OK && sins_play_get_unit(play, &unit) == SINS_OK);
    CHECK(sins_unit_destroy(unit) == SINS_OK && sins_play_next(play) == SINS_ERROR_BAD_HANDLE);
    CHECK(sins_last_error(NULL, text, sizeof text, NULL) == SINS_OK && strstr(text, "unit of the scene in flight") == text);
    CHECK(sins_play_destroy(play) == SINS_OK && sins_destroy(sim) == SINS_ERROR_BAD_HANDLE);
    play = scene_play();
    CHECK(sins_play_get_simulator(play, &sim) == SINS_OK && sins_play_get_unit(play, &unit) == SINS_OK);
    CHECK(sins_destroy(sim) == SINS_OK && sins_play_next(play) == SINS_ERROR_BAD_HANDLE);
    CHECK(sins_last_error(NULL, text, sizeof text, NULL) == SINS_OK
          && strstr(text, "simulator of the scene in flight") == text);
    CHECK(sins_play_destroy(play) == SINS_OK && sins_unit_destroy(unit) == SINS_ERROR_BAD_HANDLE);
}

/* Each call leaves its own failure: on the simulator that `sim` points to, or on this thread. */
static void is_null_pointer(const char *call, sins_status status, void *sim)
{
    if (status != SINS_ERROR_NULL_POINTER) {
        fprintf(stderr, "%s gives %d\n", call, (int)status);
    }
    CHECK(status == SINS_ERROR_NULL_POINTER);
    left(sim, call, status);
    plant(sim);
}

static void null_pointers(sins_sim *sim, sins_flight *flight)
{
    sins_scene *scene = scene_of_text();
    sins_log *log = scene_log();
    sins_ensemble *ensemble = scene_ensemble();
    sins_unit *unit = scene_unit();
    sins_play *play = scene_play();
    sins_judge *judge = scene_judge();
    sins_identify *identify = scene_identify();
    sins_record record = {.struct_size = sizeof record};
    char text[16];
    plant(sim);
    /* Null only with a count of 0. */
    is_null_pointer("sins_record_line", sins_record_line(&record, NULL, 6, NULL, text, sizeof text, NULL), sim);
    null_calls(sim, flight, judge, identify, unit, ensemble, scene, log, play, is_null_pointer, sim);
    CHECK(sins_last_error(sim, NULL, 0, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_last_error_info(sim, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_scene_destroy(scene) == SINS_OK && sins_log_destroy(log) == SINS_OK);
    CHECK(sins_play_destroy(play) == SINS_OK && sins_judge_destroy(judge) == SINS_OK);
    CHECK(sins_identify_destroy(identify) == SINS_OK);
    CHECK(sins_ensemble_destroy(ensemble) == SINS_OK && sins_unit_destroy(unit) == SINS_OK);
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
    lent_handles();

    CHECK(sins_get_navigation(sim, &after) == SINS_OK);
    CHECK(memcmp(&before, &after, sizeof before) == 0);
    CHECK(sins_destroy(sim) == SINS_OK);
    CHECK(sins_flight_destroy(flight) == SINS_OK);
    printf("misuse: every answer is the right one\n");
    return 0;
}
