/* Every struct of the interface with sizes from 0 to twice its own. Each struct is on the heap and has exactly the bytes that
 * it states, so that AddressSanitizer detects an access beyond them. */

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "scene.h"

/* A struct of `size` bytes of `filling` that states its size. The statement itself needs four bytes. */
static void *stating(size_t size, int filling)
{
    uint32_t stated = (uint32_t)size;
    unsigned char *bytes = malloc(size < sizeof stated ? sizeof stated : size);
    CHECK(bytes != NULL);
    memset(bytes, filling, size);
    memcpy(bytes, &stated, sizeof stated);
    return bytes;
}

/* A struct shorter than in the first release is an error. A longer one than this release knows is valid if the tail is zero. */
#define INPUT_SIZES(type, call)                                                              \
    do {                                                                                     \
        uint32_t garbage = 0xffffffffu;                                                      \
        size_t size;                                                                         \
        for (size = 0; size <= 2 * sizeof(struct type); size++) {                            \
            struct type *pointer = stating(size, 0);                                         \
            int fits = size >= sizeof(struct type) && size % 8 == 0;                         \
            sins_status status = (call);                                                     \
            CHECK((status == SINS_ERROR_STRUCT_SIZE) == !fits);                              \
            if (fits && size > sizeof(struct type)) {                                        \
                ((unsigned char *)pointer)[size - 1] = 1;                                    \
                CHECK((call) == SINS_ERROR_STRUCT_SIZE);                                     \
            }                                                                                \
            free(pointer);                                                                   \
        }                                                                                    \
        {                                                                                    \
            struct type *pointer = (struct type *)(void *)&garbage;                          \
            CHECK((call) == SINS_ERROR_STRUCT_SIZE);                                         \
        }                                                                                    \
    } while (0)

/* Fields that fit into the host's struct are written. struct_size and the bytes unknown to this release are not changed. */
#define OUTPUT_SIZES(type, call)                                                             \
    do {                                                                                     \
        size_t size, i;                                                                      \
        for (size = 0; size <= 2 * sizeof(struct type); size++) {                            \
            struct type *pointer = stating(size, 0xa5);                                      \
            int fits = size >= sizeof(struct type) && size % 8 == 0;                         \
            size_t known = size < sizeof(struct type) ? size : sizeof(struct type);          \
            CHECK((call) == (fits ? SINS_OK : SINS_ERROR_STRUCT_SIZE));                      \
            CHECK(pointer->struct_size == size);                                             \
            for (i = fits ? known : 4; i < size; i++) {                                      \
                CHECK(((unsigned char *)pointer)[i] == 0xa5);                                \
            }                                                                                \
            free(pointer);                                                                   \
        }                                                                                    \
    } while (0)

/* The line of a record; NULL stands for a valid argument. */
static sins_status line_of(const sins_record *record, const sins_covariance *covariance)
{
    sins_record good = {.struct_size = sizeof good};
    char line[2048];
    return sins_record_line(record ? record : &good, NULL, 0, covariance, line, sizeof line, NULL);
}

static sins_status create_and_destroy(const sins_options *options)
{
    sins_sim *sim = NULL;
    sins_status status = sins_create(options, &sim);
    if (status == SINS_OK) {
        CHECK(sins_destroy(sim) == SINS_OK);
    } else {
        CHECK(sim == NULL);
    }
    return status;
}

/* A recommendation for `piece`, which has two samples. NULL stands for a valid argument: one second at rest, 1 m required. */
static sins_status recommend_for(const sins_flight_sample *piece, const sins_requirement *requirement,
                                 sins_options *options, sins_cost *cost)
{
    sins_flight_sample rest[2] = {{.struct_size = sizeof rest[0]}};
    sins_requirement good_requirement = {.struct_size = sizeof good_requirement, .position_m = 1.0};
    sins_options good_options = {.struct_size = sizeof good_options};
    sins_cost good_cost = {.struct_size = sizeof good_cost};
    rest[1].time_s = 1.0;
    return sins_recommend(NULL, piece ? piece : rest, 2, requirement ? requirement : &good_requirement,
                          options ? options : &good_options, cost ? cost : &good_cost);
}

static sins_status recommend(const sins_requirement *requirement, sins_options *options, sins_cost *cost)
{
    return recommend_for(NULL, requirement, options, cost);
}

/* The budget of one second at rest. A NULL `row` stands for a valid one; a NULL request or budget is passed on. */
static sins_status budget_of(const sins_budget_request *request, sins_budget_row *row, sins_budget *budget)
{
    sins_flight_sample piece[2] = {{.struct_size = sizeof piece[0]}};
    sins_budget_row good_row = {.struct_size = sizeof good_row};
    piece[1].time_s = 1.0;
    return sins_error_budget(NULL, piece, 2, request, row ? row : &good_row, 1, NULL, budget);
}

/* A flight of one manoeuvre; NULL stands for a valid argument. */
static sins_status create_flight(const sins_flight_start *start, const sins_manoeuvre *manoeuvre)
{
    sins_flight_start good_start = {.struct_size = sizeof good_start};
    sins_manoeuvre rest = {.struct_size = sizeof rest, .duration_s = 1.0};
    sins_flight *flight = NULL;
    sins_status status = sins_flight_create(start ? start : &good_start, manoeuvre ? manoeuvre : &rest, 1, &flight);
    CHECK((status == SINS_OK) == (flight != NULL));
    CHECK(flight == NULL || sins_flight_destroy(flight) == SINS_OK);
    return status;
}

static sins_status push_first(sins_sim *sim, const sins_flight_sample *sample)
{
    CHECK(sins_reset(sim) == SINS_OK);
    return sins_push_sample(sim, sample);
}

static sins_status run_first(sins_sim *sim, const sins_flight_sample *sample)
{
    CHECK(sins_reset(sim) == SINS_OK);
    return sins_run(sim, sample, 1, 0, NULL, 0, NULL);
}

/* A record from an interval at rest. */
static sins_status run_for_record(sins_sim *sim, sins_record *record)
{
    sins_flight_sample rest[2] = {{.struct_size = sizeof rest[0]}};
    rest[1].time_s = 0.01;
    CHECK(sins_reset(sim) == SINS_OK);
    return sins_run(sim, rest, 2, 1, record, 1, NULL);
}

/* Arrays of every stride: samples in and records out. The library must not access bytes after the last record. */
static void strides(sins_sim *sim)
{
    enum { COUNT = 3 };
    size_t in, out, k;
    for (in = sizeof(sins_flight_sample); in <= 2 * sizeof(sins_flight_sample); in += 8) {
        for (out = sizeof(sins_record); out <= 2 * sizeof(sins_record); out += 8) {
            unsigned char *samples = calloc(COUNT, in), *records = malloc((COUNT - 1) * out);
            sins_log *log = NULL;
            size_t written = 0;
            CHECK(samples != NULL && records != NULL);
            memset(records, 0xa5, (COUNT - 1) * out);
            ((sins_record *)(void *)records)->struct_size = (uint32_t)out;
            for (k = 0; k < COUNT; k++) {
                sins_flight_sample sample = {.struct_size = (uint32_t)in};
                sample.time_s = 0.01 * (double)k;
                memcpy(samples + k * in, &sample, sizeof sample);
            }
            CHECK(sins_reset(sim) == SINS_OK);
            CHECK(sins_run(sim, (sins_flight_sample *)(void *)samples, COUNT, 1, (sins_record *)(void *)records, COUNT - 2,
                           &written) == SINS_ERROR_BUFFER_TOO_SMALL);
            CHECK(sins_run(sim, (sins_flight_sample *)(void *)samples, COUNT, 1, (sins_record *)(void *)records, COUNT - 1,
                           &written) == SINS_OK);
            CHECK(written == COUNT - 1);
            CHECK(sins_log_create((sins_flight_sample *)(void *)samples, COUNT, &log) == SINS_OK && sins_log_destroy(log) == SINS_OK);
            CHECK(out > sizeof(sins_record) || in % sizeof(sins_flight_sample) != 0 ||
                  recommend_for((sins_flight_sample *)(void *)(samples + in), NULL, NULL, NULL) == SINS_OK);
            for (k = 0; k < (COUNT - 1) * out; k++) {
                CHECK(k % out < sizeof(sins_record) || records[k] == 0xa5);
            }
            free(samples);
            free(records);
        }
    }
}

/* The fault of an invalid log. Returns SINS_OK instead of the status that reports the fault. */
static sins_status fault_of_log(sins_fault *fault)
{
    sins_log *log = NULL;
    sins_status status = sins_log_parse("time_s", 6, NULL, &log, fault);
    CHECK(log == NULL);
    return status == SINS_ERROR_INVALID_ARGUMENT ? SINS_OK : status;
}

/* Sets a flight of one manoeuvre; NULL stands for a valid argument, a rest. */
static sins_status set_manoeuvres(sins_scene *scene, const sins_flight_start *start, const sins_manoeuvre *manoeuvre)
{
    sins_flight_start good_start = {.struct_size = sizeof good_start};
    sins_manoeuvre rest = {.struct_size = sizeof rest, .duration_s = 1.0};
    return sins_scene_set_manoeuvres(scene, start ? start : &good_start, manoeuvre ? manoeuvre : &rest, 1, 1);
}

static sins_status get_manoeuvres(sins_scene *scene, sins_flight_start *start, sins_manoeuvre *manoeuvre)
{
    sins_manoeuvre good = {.struct_size = sizeof good};
    size_t count;
    return sins_scene_get_manoeuvres(scene, start, manoeuvre ? manoeuvre : &good, 1, &count, NULL);
}

static void struct_sizes_of_scenes(sins_sim *sim)
{
    sins_scene *scene = NULL, *faulty = NULL;
    sins_play *play = NULL;
    sins_log *log = scene_log();
    CHECK(sins_scene_create(&scene) == SINS_OK);
    CHECK(sins_scene_parse("[", 1, &faulty) == SINS_SCENE_HAS_FAULTS);
    INPUT_SIZES(sins_flight_start, set_manoeuvres(scene, pointer, NULL));
    INPUT_SIZES(sins_manoeuvre, set_manoeuvres(scene, NULL, pointer));
    OUTPUT_SIZES(sins_flight_start, get_manoeuvres(scene, pointer, NULL));
    OUTPUT_SIZES(sins_manoeuvre, get_manoeuvres(scene, NULL, pointer));
    OUTPUT_SIZES(sins_options, sins_scene_get_options(scene, pointer));
    OUTPUT_SIZES(sins_scene_setup, sins_scene_get_setup(scene, pointer));
    OUTPUT_SIZES(sins_fault, sins_scene_get_fault(faulty, 0, pointer));
    OUTPUT_SIZES(sins_fault, fault_of_log(pointer));
    OUTPUT_SIZES(sins_scene_key, sins_scene_get_key(0, pointer));
    OUTPUT_SIZES(sins_scene_samples, sins_scene_get_samples(scene, log, pointer));
    OUTPUT_SIZES(sins_log_info, sins_log_get_info(log, pointer));
    OUTPUT_SIZES(sins_flight_sample, sins_log_get_sample(log, 0, pointer, NULL));
    INPUT_SIZES(sins_flight_sample, sins_scene_prepare(scene, sim, 0.0, pointer));
    CHECK(sins_scene_destroy(scene) == SINS_OK && sins_scene_destroy(faulty) == SINS_OK);
    scene = scene_of_text();
    OUTPUT_SIZES(sins_planned_failure, sins_scene_get_failure(scene, 0, pointer));
    play = scene_play();
    CHECK(sins_play_next(play) == SINS_OK && sins_play_next(play) == SINS_OK);
    OUTPUT_SIZES(sins_unit_status, sins_play_get_shown(play, pointer, NULL));
    OUTPUT_SIZES(sins_unit_navigation, sins_play_get_shown(play, NULL, pointer));
    OUTPUT_SIZES(sins_record, sins_play_run(play, pointer, 1, NULL));
    OUTPUT_SIZES(sins_imu, sins_play_run_imu(play, pointer, 1, NULL));
    CHECK(sins_play_destroy(play) == SINS_OK);
    CHECK(sins_scene_destroy(scene) == SINS_OK && sins_log_destroy(log) == SINS_OK);
}

static void struct_sizes(sins_sim *sim, sins_flight *flight)
{
    sins_sim *fresh = NULL;
    sins_judge *judge = scene_judge();
    size_t count = 0;
    CHECK(sins_create(NULL, &fresh) == SINS_OK);
    INPUT_SIZES(sins_options, create_and_destroy(pointer));
    INPUT_SIZES(sins_gyro_params, sins_set_gyro(fresh, pointer));
    INPUT_SIZES(sins_accel_params, sins_set_accel(fresh, pointer));
    INPUT_SIZES(sins_altimeter_params, sins_set_altimeter(fresh, pointer));
    INPUT_SIZES(sins_failure, sins_set_failure(fresh, SINS_SENSOR_ACCEL, 2, pointer));
    INPUT_SIZES(sins_initial_errors, sins_set_initial_errors(fresh, pointer));
    INPUT_SIZES(sins_mounting, sins_set_mounting(fresh, pointer));
    INPUT_SIZES(sins_gravity_params, sins_set_gravity_disturbance(fresh, pointer));
    INPUT_SIZES(sins_flight_sample, sins_reposition(fresh, pointer));
    INPUT_SIZES(sins_flight_sample, sins_move_truth(fresh, pointer));
    CHECK(sins_reset(fresh) == SINS_OK);
    INPUT_SIZES(sins_navigation, sins_start_navigation(fresh, pointer));
    INPUT_SIZES(sins_imu_increment, sins_push_imu(fresh, pointer));
    INPUT_SIZES(sins_flight_sample, push_first(fresh, pointer));
    INPUT_SIZES(sins_flight_sample, run_first(fresh, pointer));
    INPUT_SIZES(sins_flight_start, create_flight(pointer, NULL));
    INPUT_SIZES(sins_manoeuvre, create_flight(NULL, pointer));
    INPUT_SIZES(sins_requirement, recommend(pointer, NULL, NULL));

    INPUT_SIZES(sins_budget_request, budget_of(pointer, NULL, NULL));

    OUTPUT_SIZES(sins_budget_row, budget_of(NULL, pointer, NULL));
    OUTPUT_SIZES(sins_budget, budget_of(NULL, NULL, pointer));
    OUTPUT_SIZES(sins_options, recommend(NULL, pointer, NULL));
    OUTPUT_SIZES(sins_cost, recommend(NULL, NULL, pointer));
    OUTPUT_SIZES(sins_navigation, sins_get_truth(sim, pointer));
    OUTPUT_SIZES(sins_navigation, sins_get_navigation(sim, pointer));
    OUTPUT_SIZES(sins_imu, sins_get_imu(sim, pointer));
    INPUT_SIZES(sins_correction, sins_correct(sim, pointer));
    OUTPUT_SIZES(sins_compensation, sins_get_compensation(sim, pointer));
    OUTPUT_SIZES(sins_imu_increment, sins_get_imu_update(sim, 0, pointer));
    OUTPUT_SIZES(sins_errors, sins_get_errors(sim, SINS_ERRORS_NAVIGATION, pointer));
    OUTPUT_SIZES(sins_errors, sins_get_errors(sim, SINS_ERRORS_MODEL, pointer));
    OUTPUT_SIZES(sins_truth_summary, sins_get_truth_summary(sim, pointer));
    OUTPUT_SIZES(sins_covariance, sins_get_covariance(sim, pointer));
    OUTPUT_SIZES(sins_accuracy, sins_get_accuracy(sim, pointer));
    OUTPUT_SIZES(sins_record, sins_get_record(sim, pointer));
    OUTPUT_SIZES(sins_record, run_for_record(fresh, pointer));
    INPUT_SIZES(sins_record, line_of(pointer, NULL));
    INPUT_SIZES(sins_covariance, line_of(NULL, pointer));
    OUTPUT_SIZES(sins_options, sins_get_options(sim, pointer));
    OUTPUT_SIZES(sins_error_info, sins_last_error_info(sim, pointer));
    OUTPUT_SIZES(sins_gyro_params, sins_get_gyro(sim, pointer));
    OUTPUT_SIZES(sins_accel_params, sins_get_accel(sim, pointer));
    OUTPUT_SIZES(sins_altimeter_params, sins_get_altimeter(sim, pointer));
    OUTPUT_SIZES(sins_failure, sins_get_failure(sim, SINS_SENSOR_ACCEL, 2, pointer));
    OUTPUT_SIZES(sins_initial_errors, sins_get_initial_errors(sim, pointer));
    OUTPUT_SIZES(sins_mounting, sins_get_mounting(sim, pointer));
    OUTPUT_SIZES(sins_gravity_params, sins_get_gravity_disturbance(sim, pointer));
    OUTPUT_SIZES(sins_gyro_params, sins_gyro_preset(SINS_GRADE_PAPER_SIMULATION2, pointer));
    OUTPUT_SIZES(sins_accel_params, sins_accel_preset(SINS_GRADE_PAPER_SIMULATION2, pointer));
    OUTPUT_SIZES(sins_initial_errors, sins_initial_preset(SINS_GRADE_PAPER_SIMULATION2, pointer));
    OUTPUT_SIZES(sins_flight_sample, sins_flight_sample_at(flight, 0.0, pointer));
    OUTPUT_SIZES(sins_finding, sins_judge_get_findings(judge, pointer, 1, &count));
    CHECK(count == 1);
    INPUT_SIZES(sins_flight_sample, sins_judge_push(judge, pointer));
    CHECK(sins_judge_destroy(judge) == SINS_OK);
    strides(fresh);
    CHECK(sins_destroy(fresh) == SINS_OK);
}

/* Three runs, one second at rest. */
static void fly_ensemble(sins_ensemble *ensemble, sins_statistics *statistics)
{
    sins_flight_sample rest[2] = {{.struct_size = sizeof rest[0]}};
    rest[1].time_s = 1.0;
    CHECK(sins_ensemble_run(ensemble, rest, 2) == SINS_OK);
    CHECK(sins_ensemble_get_statistics(ensemble, SINS_ERRORS_NAVIGATION, statistics) == SINS_OK);
}

static sins_status push_first_of_ensemble(sins_ensemble *ensemble, const sins_flight_sample *sample)
{
    CHECK(sins_ensemble_reset(ensemble) == SINS_OK);
    return sins_ensemble_push_sample(ensemble, sample);
}

static sins_status run_first_of_ensemble(sins_ensemble *ensemble, const sins_flight_sample *sample)
{
    CHECK(sins_ensemble_reset(ensemble) == SINS_OK);
    return sins_ensemble_run(ensemble, sample, 1);
}

/* Adds the statistics `from` to statistics without a run. */
static sins_status merge(const sins_statistics *from)
{
    static sins_statistics into;
    SINS_INIT(into);
    return sins_statistics_merge(&into, from);
}

static sins_status figures_of(const sins_statistics *statistics)
{
    sins_figures figures = {.struct_size = sizeof figures};
    return sins_statistics_figures(statistics, &figures);
}

static sins_status verdict_of(const sins_statistics *statistics)
{
    sins_verdict verdict = {.struct_size = sizeof verdict};
    return sins_meets(statistics, 1.0, 95.0, &verdict);
}

static void struct_sizes_of_ensembles(void)
{
    static sins_statistics statistics;
    sins_ensemble *ensemble = scene_ensemble();
    sins_scene *scene = scene_of_text();
    SINS_INIT(statistics);
    INPUT_SIZES(sins_flight_sample, push_first_of_ensemble(ensemble, pointer));
    INPUT_SIZES(sins_flight_sample, run_first_of_ensemble(ensemble, pointer));
    INPUT_SIZES(sins_flight_sample, sins_ensemble_reposition(ensemble, pointer));
    INPUT_SIZES(sins_flight_sample,
                      sins_scene_prepare_ensemble(scene, ensemble, 0.0, pointer));
    CHECK(sins_ensemble_reset(ensemble) == SINS_OK);
    INPUT_SIZES(sins_failure, sins_ensemble_set_failure(ensemble, SINS_SENSOR_ACCEL, 2, pointer));
    fly_ensemble(ensemble, &statistics);
    OUTPUT_SIZES(sins_navigation, sins_ensemble_get_truth(ensemble, pointer));
    OUTPUT_SIZES(sins_navigation, sins_ensemble_get_navigation(ensemble, SCENE_FIRST_RUN, pointer));
    OUTPUT_SIZES(sins_imu, sins_ensemble_get_imu(ensemble, SCENE_FIRST_RUN, pointer));
    INPUT_SIZES(sins_correction, sins_ensemble_correct(ensemble, SCENE_FIRST_RUN, pointer));
    OUTPUT_SIZES(sins_compensation, sins_ensemble_get_compensation(ensemble, SCENE_FIRST_RUN, pointer));
    OUTPUT_SIZES(sins_errors, sins_ensemble_get_errors(ensemble, SCENE_FIRST_RUN, SINS_ERRORS_MODEL, pointer));
    OUTPUT_SIZES(sins_figures, sins_statistics_figures(&statistics, pointer));
    OUTPUT_SIZES(sins_verdict, sins_meets(&statistics, 1.0, 95.0, pointer));
    OUTPUT_SIZES(sins_statistics, sins_ensemble_get_statistics(ensemble, SINS_ERRORS_NAVIGATION, pointer));
    INPUT_SIZES(sins_statistics, merge(pointer));
    INPUT_SIZES(sins_statistics, figures_of(pointer));
    INPUT_SIZES(sins_statistics, verdict_of(pointer));
    /* Statistics of zeros are a valid sum. */
    INPUT_SIZES(sins_statistics, sins_statistics_merge(pointer, &statistics));
    CHECK(sins_ensemble_destroy(ensemble) == SINS_OK && sins_scene_destroy(scene) == SINS_OK);
}

static sins_status create_unit(const sins_unit_params *params)
{
    sins_unit *unit = NULL;
    sins_status status = sins_unit_create(params, SINS_UNIT_OFF, &unit);
    CHECK(status != SINS_OK || sins_unit_destroy(unit) == SINS_OK);
    return status;
}

/* All words of a millisecond; NULL: a struct of the right size. */
static sins_status words_of(const sins_unit_status *status, const sins_unit_navigation *navigation, const sins_bus_inputs *inputs)
{
    sins_unit_status own_status = {.struct_size = sizeof own_status};
    sins_unit_navigation own_navigation = {.struct_size = sizeof own_navigation};
    size_t count;
    return sins_bus_words(status ? status : &own_status, navigation ? navigation : &own_navigation, inputs, 0.0, 0.001, NULL, 0,
                          &count);
}

static sins_status first_word(sins_bus_word *word)
{
    sins_unit_status status = {.struct_size = sizeof status, .state = SINS_UNIT_STATE_NAVIGATION};
    sins_unit_navigation navigation = {.struct_size = sizeof navigation};
    size_t count;
    sins_status answer = sins_bus_words(&status, &navigation, NULL, 0.0, 0.1, word, 1, &count);
    return answer == SINS_ERROR_BUFFER_TOO_SMALL ? SINS_OK : answer;
}

static void struct_sizes_of_units(sins_sim *sim)
{
    sins_unit *unit = scene_unit();
    INPUT_SIZES(sins_unit_params, create_unit(pointer));
    INPUT_SIZES(sins_unit_params, sins_unit_set_params(unit, pointer));
    INPUT_SIZES(sins_unit_fix, sins_unit_push_fix(unit, sim, pointer));
    OUTPUT_SIZES(sins_unit_params, sins_unit_get_params(unit, pointer));
    OUTPUT_SIZES(sins_unit_status, sins_unit_get_status(unit, pointer));
    OUTPUT_SIZES(sins_unit_navigation, sins_unit_get_navigation(unit, sim, pointer));
    INPUT_SIZES(sins_unit_status, words_of(pointer, NULL, NULL));
    INPUT_SIZES(sins_unit_navigation, words_of(NULL, pointer, NULL));
    INPUT_SIZES(sins_bus_inputs, words_of(NULL, NULL, pointer));
    OUTPUT_SIZES(sins_bus_word, first_word(pointer));
    OUTPUT_SIZES(sins_bus_label, sins_bus_get_label(3, pointer));
    CHECK(sins_unit_destroy(unit) == SINS_OK);
}

int main(void)
{
    sins_options options = {.struct_size = sizeof options};
    sins_flight_sample sample = {.struct_size = sizeof sample};
    sins_flight *flight = scene_flight();
    sins_sim *sim = NULL;
    options.error_model = SINS_ERROR_MODEL_RK4;
    options.truth_summary = SINS_SUMMARY_ON;
    options.covariance = SINS_COVARIANCE_ON;
    CHECK(sins_create(&options, &sim) == SINS_OK);
    CHECK(sins_push_sample(sim, &sample) == SINS_OK);
    sample.time_s = 0.01;
    CHECK(sins_push_sample(sim, &sample) == SINS_OK && sins_step(sim) == SINS_OK);
    struct_sizes(sim, flight);
    struct_sizes_of_scenes(sim);
    struct_sizes_of_ensembles();
    struct_sizes_of_units(sim);
    CHECK(sins_destroy(sim) == SINS_OK && sins_flight_destroy(flight) == SINS_OK);
    printf("struct_sizes: every struct, from 0 to twice its size\n");
    return 0;
}
