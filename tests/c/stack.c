/* Each function needs at most 48 KB of stack, so that a thread with 64 KB can call it; sins_identify_solve() and sins_identify_check() at
 * most 256 KB. The stack below a call is filled with a pattern; the lowest byte that has changed after the call gives the depth. */

#define _GNU_SOURCE
#include <math.h>
#include <pthread.h>
#include <string.h>

#include "scene.h"
#include "sins_functions.h"
#include "small_stack.h"

enum { DEEPEST = 48 * 1024, DEEPEST_SOLVE = 256 * 1024, FUNCTIONS = 180, PAINT = 0x5a, SAMPLES = 8 };

static struct {
    char name[40];
    size_t bytes;
    int has_succeeded;
} deepest[FUNCTIONS];

static sins_flight_sample samples[SCENE_COUNT];
static sins_record records[SAMPLES];
static sins_budget_row rows[64];
static unsigned char snapshot[SINS_SNAPSHOT_MAX_SIZE], play_snapshot[SINS_PLAY_SNAPSHOT_MAX_SIZE];
static char text[65536];
static const char other_file[] = "time_s,r,pitch_deg,heading_deg\n0,1,0,0\n1,2,0,0\n";
static char *bottom;

static void find_bottom(void)
{
    pthread_attr_t attributes;
    void *lowest = NULL;
    size_t size = 0;
    CHECK(pthread_getattr_np(pthread_self(), &attributes) == 0);
    CHECK(pthread_attr_getstack(&attributes, &lowest, &size) == 0);
    CHECK(pthread_attr_destroy(&attributes) == 0);
    bottom = lowest;
}

/* Fills the free stack below this frame, except for the part that the loop itself may use. */
static __attribute__((noinline)) void paint(void)
{
    volatile char *end = (char *)__builtin_frame_address(0) - 512, *place;
    for (place = bottom; place < end; place++) {
        *place = PAINT;
    }
}

/* `call` is the text of a call that has just returned. */
static __attribute__((noinline)) sins_status measured(const char *call, sins_status status)
{
    const volatile char *place = bottom;
    size_t length = strcspn(call, "("), depth, k = 0;
    while (*place == PAINT) {
        place++;
    }
    depth = (size_t)((const char *)__builtin_frame_address(0) - place);
    while (deepest[k].name[0] != '\0' && !(strncmp(deepest[k].name, call, length) == 0 && deepest[k].name[length] == '\0')) {
        k++;
    }
    CHECK(k < FUNCTIONS && length < sizeof deepest[k].name);
    memcpy(deepest[k].name, call, length);
    deepest[k].has_succeeded |= status >= SINS_OK;
    deepest[k].bytes = depth > deepest[k].bytes ? depth : deepest[k].bytes;
    return status;
}

/* MEASURE: a call that must succeed. TRY: a call with any answer. */
#define TRY(call) (paint(), measured(#call, call))
#define MEASURE(call) CHECK(TRY(call) == SINS_OK)
/* A call that returns no status. */
#define MEASURE_VALUE(call) (paint(), (void)(call), (void)measured(#call, SINS_OK))

/* Every call of every_call.h is measured; its variables are not on the small stack. */
#define EVERY_CALL(call) ((void)answer, (void)context, (void)TRY(call))
#define EVERY_CALL_STORAGE static

#include "every_call.h"

static sins_correction correction = {.struct_size = sizeof correction, .position_enu_m = {1.0}, .gyro_bias_rad_s = {1e-9}};

/* A simulator with every effect on. */
static sins_sim *with_everything(const sins_options *options)
{
    sins_initial_errors initial = scene_initial_errors();
    sins_failure stuck = {.struct_size = sizeof stuck, .kind = SINS_FAILURE_STUCK};
    sins_mounting mounting = {.struct_size = sizeof mounting, .lever_arm_m = {1.5, 3.0, -0.8}, .boresight_error_rad = {1e-3}};
    sins_gravity_params gravity = {.struct_size = sizeof gravity, .deflection_north_rad = 1e-5};
    sins_sim *sim = scene_simulator(options, 1);
    initial.alignment = SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS;
    CHECK(sins_set_initial_errors(sim, &initial) == SINS_OK && sins_set_mounting(sim, &mounting) == SINS_OK);
    CHECK(sins_set_gravity_disturbance(sim, &gravity) == SINS_OK);
    CHECK(sins_set_failure(sim, SINS_SENSOR_ACCEL, 1, &stuck) == SINS_OK);
    return sim;
}

/* A flight, rejected samples and steps, navigation from increments, and every function at each stage. */
static void fly(const sins_options *options)
{
    sins_navigation start = {.struct_size = sizeof start, .quaternion_nb = {1.0}};
    sins_imu_increment increment = {.struct_size = sizeof increment, .interval_s = 0.01, .count = 5};
    sins_gyro_params ideal = {.struct_size = sizeof ideal};
    sins_error_info info = {.struct_size = sizeof info};
    sins_record record = {.struct_size = sizeof record};
    sins_covariance covariance = {.struct_size = sizeof covariance};
    sins_errors model = {.struct_size = sizeof model};
    sins_sim *sim = with_everything(options), *first = with_everything(options);
    size_t size;
    int k;
    MEASURE(sins_push_sample(first, &samples[0]));
    every_call(first, NULL, NULL);
    CHECK(sins_destroy(first) == SINS_OK);
    for (k = 0; k < SAMPLES; k++) {
        MEASURE(sins_push_sample(sim, &samples[k]));
        TRY(sins_push_sample(sim, &samples[0])); /* rejected */
        MEASURE(sins_last_error(sim, text, sizeof text, NULL));
        MEASURE(sins_last_error_info(sim, &info));
        TRY(sins_step(sim));
        MEASURE(sins_get_errors(sim, SINS_ERRORS_MODEL, &model));
    }
    MEASURE(sins_snapshot_save(sim, snapshot, sizeof snapshot, &size));
    every_call(sim, NULL, NULL);
    MEASURE(sins_snapshot_load(sim, snapshot, size));
    MEASURE(sins_get_record(sim, &record));
    MEASURE(sins_get_covariance(sim, &covariance));
    MEASURE(sins_record_line(&record, NULL, 0, &covariance, NULL, 0, &size));
    MEASURE(sins_correct(sim, &correction));
    MEASURE(sins_run(sim, &samples[SAMPLES], SAMPLES, 1, records, SAMPLES, NULL));
    MEASURE(sins_move_time(sim, 1e6));
    MEASURE(sins_move_truth(sim, &samples[0]));
    MEASURE(sins_run(sim, &samples[1], SAMPLES, 1, records, SAMPLES, NULL));
    MEASURE(sins_reposition(sim, &samples[0]));
    every_call(sim, NULL, NULL);
    MEASURE(sins_reset(sim));
    MEASURE(sins_set_gyro(sim, &ideal));
    MEASURE(sins_start_navigation(sim, &start));
    for (k = 0; k < 3; k++) {
        MEASURE(sins_push_imu(sim, &increment));
        MEASURE(sins_correct(sim, &correction));
    }
    MEASURE(sins_destroy(sim));
}

/* Two runs with everything on. */
static void fly_ensemble(const sins_options *options)
{
    static sins_statistics statistics, sum;
    sins_figures figures = {.struct_size = sizeof figures};
    sins_verdict verdict = {.struct_size = sizeof verdict};
    sins_errors errors = {.struct_size = sizeof errors};
    sins_flight_sample sample = samples[0];
    sins_scene *scene = scene_of_text();
    sins_sim *sim = with_everything(options);
    sins_ensemble *ensemble = NULL, *first = NULL;
    MEASURE(sins_ensemble_create(sim, SCENE_FIRST_RUN, 2, &ensemble));
    MEASURE(sins_ensemble_create(sim, SCENE_FIRST_RUN, 2, &first));
    SINS_INIT(statistics);
    SINS_INIT(sum);
    MEASURE(sins_scene_prepare_ensemble(scene, ensemble, 0.0, &sample));
    MEASURE(sins_ensemble_push_sample(first, &samples[0]));
    every_ensemble_call(first, NULL, NULL); /* before the first step */
    MEASURE(sins_ensemble_push_sample(ensemble, &samples[0]));
    MEASURE(sins_ensemble_push_sample(ensemble, &samples[1]));
    MEASURE(sins_ensemble_step(ensemble));
    MEASURE(sins_ensemble_run(ensemble, &samples[2], SAMPLES));
    MEASURE(sins_ensemble_correct(ensemble, SCENE_FIRST_RUN, &correction));
    MEASURE(sins_ensemble_get_statistics(ensemble, SINS_ERRORS_MODEL, &statistics));
    MEASURE(sins_statistics_add(&statistics, &errors));
    MEASURE(sins_statistics_merge(&sum, &statistics));
    MEASURE(sins_statistics_figures(&sum, &figures));
    MEASURE(sins_meets(&sum, 1.0, 95.0, &verdict));
    every_ensemble_call(ensemble, NULL, NULL);
    CHECK(sins_ensemble_destroy(ensemble) == SINS_OK && sins_ensemble_destroy(first) == SINS_OK);
    CHECK(sins_destroy(sim) == SINS_OK && sins_scene_destroy(scene) == SINS_OK);
}

/* A right turn by 1 rad/s at 100 m/s, with a fix at every sample: the last fixes find the attitude and correct the solution. */
static void align_in_flight(sins_unit *unit)
{
    sins_unit_params params = {.struct_size = sizeof params, .power_up_test_s = 1e-3, .coarse_alignment_s = 0.1,
                               .in_flight_alignment_s = 1.0, .in_flight_heading_rad = 1.0};
    sins_unit_status status = {.struct_size = sizeof status};
    sins_unit_fix fix = {.struct_size = sizeof fix};
    sins_flight_sample sample = {.struct_size = sizeof sample};
    sins_sim *sim = NULL;
    int k;
    CHECK(sins_create(NULL, &sim) == SINS_OK && sins_unit_set_params(unit, &params) == SINS_OK);
    CHECK(sins_unit_set_power(unit, SINS_UNIT_POWER_NONE) == SINS_OK);
    for (k = 0; k < 300; k++) {
        double heading = 0.01 * k;
        sample.time_s = 0.01 * k;
        sample.heading_rad = heading;
        fix.velocity_enu_m_s[0] = sample.velocity_enu_m_s[0] = 100.0 * sin(heading);
        fix.velocity_enu_m_s[1] = sample.velocity_enu_m_s[1] = 100.0 * cos(heading);
        fix.longitude_rad = sample.longitude_rad = 100.0 * (1.0 - cos(heading)) / 6378137.0;
        fix.latitude_rad = sample.latitude_rad = 100.0 * sin(heading) / 6335439.0;
        CHECK(sins_push_sample(sim, &sample) == SINS_OK && (sins_step(sim) == SINS_OK) == (k > 0));
        if (k > 0) {
            CHECK(sins_unit_update(unit, sim) == SINS_OK);
            MEASURE(sins_unit_push_fix(unit, sim, &fix));
        }
        if (k == 1) {
            CHECK(sins_unit_set_power(unit, SINS_UNIT_POWER_AIRCRAFT) == SINS_OK && sins_unit_select(unit, SINS_UNIT_NAV) == SINS_OK);
            CHECK(sins_unit_set_alignment(unit, SINS_UNIT_ALIGNMENT_IN_FLIGHT) == SINS_OK);
        }
    }
    CHECK(sins_unit_get_status(unit, &status) == SINS_OK && status.state == SINS_UNIT_STATE_NAVIGATION);
    CHECK(sins_destroy(sim) == SINS_OK);
}

static void fly_unit(const sins_options *options)
{
    sins_unit_params params = {.struct_size = sizeof params, .power_up_test_s = 0.01, .alignment_s = 0.1};
    sins_unit_status status = {.struct_size = sizeof status};
    sins_unit_navigation navigation = {.struct_size = sizeof navigation};
    sins_bus_word word = {.struct_size = sizeof word};
    static const char UNIT_SCENE[] = "[flight]\nbuiltin = \"rest\"\n[unit]\nstart = \"off\"\n";
    sins_scene *scene = NULL;
    sins_unit *unit = NULL;
    sins_sim *sim = NULL;
    size_t size;
    int k;
    CHECK(sins_create(options, &sim) == SINS_OK);
    CHECK(sins_unit_create(&params, SINS_UNIT_OFF, &unit) == SINS_OK && sins_unit_select(unit, SINS_UNIT_NAV) == SINS_OK);
    CHECK(sins_unit_set_power(unit, SINS_UNIT_POWER_BATTERY) == SINS_OK);
    for (k = 0; k < SAMPLES; k++) {
        CHECK(sins_push_sample(sim, &samples[k]) == SINS_OK);
        if (sins_step(sim) == SINS_OK) {
            MEASURE(sins_unit_update(unit, sim));
            MEASURE(sins_unit_get_status(unit, &status));
            MEASURE(sins_unit_get_navigation(unit, sim, &navigation));
            TRY(sins_unit_enter_position(unit, 0.0, 0.0)); /* while it aligns */
            TRY(sins_unit_enter_heading(unit, 0.0));
        }
        CHECK(sins_unit_set_alignment(unit, k % 5) == SINS_OK && sins_unit_select(unit, k / 2 % 4) == SINS_OK);
    }
    align_in_flight(unit);
    TRY(sins_bus_words(&status, &navigation, NULL, 0.0, 1.0, &word, 1, &size));
    every_unit_call(unit, sim, NULL, NULL);
    CHECK(sins_unit_destroy(unit) == SINS_OK);
    MEASURE(sins_scene_parse(UNIT_SCENE, sizeof UNIT_SCENE - 1, &scene)); /* a built-in flight: a scene within a scene */
    MEASURE(sins_scene_create_unit(scene, &unit));
    MEASURE(sins_scene_update_unit(scene, unit, sim, 0.0));
    CHECK(sins_unit_destroy(unit) == SINS_OK && sins_scene_destroy(scene) == SINS_OK);
    CHECK(sins_destroy(sim) == SINS_OK);
}

static void ask(const sins_options *options)
{
    sins_requirement requirement = {.struct_size = sizeof requirement, .position_m = 1e-20};
    sins_options answer = {.struct_size = sizeof answer};
    sins_cost cost = {.struct_size = sizeof cost};
    sins_gyro_params gyro = {.struct_size = sizeof gyro, .bias_rad_s = {1e-6}};
    sins_accel_params accel = {.struct_size = sizeof accel, .velocity_random_walk_m_s_sqrt_s = {1e-3}};
    sins_altimeter_params altimeter = {.struct_size = sizeof altimeter, .noise_m = 1.0};
    sins_initial_errors initial = {.struct_size = sizeof initial, .alignment = SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS};
    sins_mounting mounting = {.struct_size = sizeof mounting, .lever_arm_m = {1.0}, .lever_arm_error_m = {1.0}};
    sins_gravity_params gravity = {.struct_size = sizeof gravity, .deflection_north_rad = 1e-5};
    sins_budget_request request = {.struct_size = sizeof request, .runs = 8, .position_m = 1e-9};
    sins_budget budget = {.struct_size = sizeof budget};
    sins_sim *sim = NULL;
    CHECK(sins_create(options, &sim) == SINS_OK && sins_set_mounting(sim, &mounting) == SINS_OK);
    CHECK(TRY(sins_recommend(sim, samples, SAMPLES, &requirement, &answer, &cost)) == SINS_REQUIREMENT_NOT_MET);
    CHECK(sins_set_gyro(sim, &gyro) == SINS_OK && sins_set_accel(sim, &accel) == SINS_OK);
    CHECK(sins_set_altimeter(sim, &altimeter) == SINS_OK && sins_set_initial_errors(sim, &initial) == SINS_OK);
    CHECK(sins_set_gravity_disturbance(sim, &gravity) == SINS_OK);
    rows[0].struct_size = sizeof rows[0];
    MEASURE(sins_error_budget(sim, samples, SAMPLES, &request, rows, 64, NULL, &budget));
    CHECK(sins_destroy(sim) == SINS_OK);
}

/* A text of the largest size that opens brackets and never closes them. */
static void parse_deep(const char *begin, const char *open)
{
    static char deep[1 << 20];
    sins_scene *scene = NULL;
    size_t size = strlen(begin), step = strlen(open);
    memcpy(deep, begin, size);
    for (; size + step <= sizeof deep; size += step) {
        memcpy(deep + size, open, step);
    }
    CHECK(TRY(sins_scene_parse(deep, size, &scene)) == SINS_SCENE_HAS_FAULTS);
    MEASURE(sins_scene_destroy(scene));
}

static void call_with_scenes(void)
{
    sins_fault fault = {.struct_size = sizeof fault};
    sins_scene_key key = {.struct_size = sizeof key};
    sins_play *play = NULL;
    sins_unit_status status;
    sins_unit_navigation shown;
    sins_flight_sample sample = {.struct_size = sizeof sample};
    sins_scene *scene = NULL, *other = NULL;
    sins_log *log = NULL;
    sins_judge *judge = NULL;
    sins_sim *sim = NULL;
    sins_flight *flight = NULL;
    sins_flight_start start = {.struct_size = sizeof start};
    static sins_manoeuvre manoeuvres[4];
    sins_flight_sample log_samples[2];
    sins_imu imu;
    size_t count;
    int k;
    parse_deep("a = ", "[");
    parse_deep("a = ", "{ a = ");
    parse_deep("", "a.");
    parse_deep("[", "a.");
    parse_deep("a = [", "[],");
    manoeuvres[0].struct_size = sizeof manoeuvres[0];
    MEASURE(sins_scene_create_builtin("aerobatics", &other));
    MEASURE(sins_scene_create_flight(other, &flight));
    CHECK(sins_flight_destroy(flight) == SINS_OK);
    MEASURE(sins_scene_destroy(other));
    CHECK(TRY(sins_scene_parse("[gyro]\nbais = 1\n[a.b]\nc = [1, 'x']\n", 31, &other)) == SINS_SCENE_HAS_FAULTS);
    MEASURE(sins_scene_get_fault(other, 0, &fault));
    MEASURE(sins_scene_destroy(other));
    MEASURE(sins_scene_parse(scene_text, sizeof scene_text - 1, &scene));
    MEASURE(sins_scene_get_key(20, &key));
    MEASURE(sins_scene_get_value(scene, "failure[0]", text, sizeof text, NULL));
    MEASURE(sins_scene_set_items(scene, "failure", text));
    MEASURE(sins_scene_set_values(scene, "gyro.bias_deg_h[2] = 0.5\noptions.scheme = paper"));
    MEASURE(sins_scene_create_simulator(scene, &sim));
    MEASURE(sins_scene_create_flight(scene, &flight));
    for (k = 0; k < 18; k++) { /* to an update */
        MEASURE(sins_flight_sample_at(flight, scene_time(k), &sample));
        MEASURE(sins_scene_prepare(scene, sim, 0.0, &sample));
        CHECK(sins_push_sample(sim, &sample) == SINS_OK);
        TRY(sins_step(sim));
    }
    MEASURE(sins_scene_set_values(scene, "unit.start = \"off\""));
    MEASURE(sins_play_create(scene, NULL, &play));
    MEASURE(sins_play_run(play, records, 1, &count));
    SINS_INIT(imu);
    MEASURE(sins_play_run_imu(play, &imu, 1, &count));
    MEASURE(sins_play_next(play));
    for (k = 3; k < 18; k++) {
        MEASURE(sins_flight_sample_at(flight, scene_time(k), &sample));
        MEASURE(sins_play_push(play, &sample));
    }
    CHECK(TRY(sins_play_push(play, &sample)) == SINS_ERROR_TIME_ORDER);
    SINS_INIT(status);
    SINS_INIT(shown);
    MEASURE(sins_play_get_shown(play, &status, &shown));
    MEASURE(sins_play_set_plan(play, scene));
    MEASURE(sins_play_snapshot_save(play, play_snapshot, sizeof play_snapshot, &count));
    MEASURE(sins_play_snapshot_load(play, play_snapshot, count));
    MEASURE(sins_play_destroy(play));
    MEASURE(sins_scene_get_manoeuvres(scene, &start, manoeuvres, 4, &count, NULL));
    MEASURE(sins_scene_set_manoeuvres(scene, &start, manoeuvres, count, 1));
    MEASURE(sins_scene_set_text(scene, SINS_SCENE_TEXT_BUILTIN, "patrol"));
    MEASURE(sins_scene_get_text(scene, SINS_SCENE_TEXT_BUILTIN, text, sizeof text, NULL));
    MEASURE(sins_log_parse(scene_log_text, sizeof scene_log_text - 1, NULL, &log, NULL));
    CHECK(sins_judge_create(NULL, &judge) == SINS_OK);
    MEASURE(sins_judge_push_log(judge, log));
    CHECK(sins_judge_destroy(judge) == SINS_OK);
    MEASURE(sins_log_destroy(log));
    log_samples[0] = log_samples[1] = sample;
    log_samples[1].time_s += 1.0;
    MEASURE(sins_log_create(log_samples, 2, &log));
    MEASURE(sins_log_destroy(log));
    CHECK(TRY(sins_log_create(log_samples, 1, &log)) == SINS_ERROR_INVALID_ARGUMENT);
    TRY(sins_log_parse(scene_text, sizeof scene_text - 1, NULL, &log, &fault));
    CHECK(sins_scene_set_values(scene, "log.roll = { col = \"r\", file = \"r.csv\" }") == SINS_OK);
    MEASURE(sins_scene_log_file_name(scene, 0, text, sizeof text, NULL));
    MEASURE(sins_scene_give_log_file(scene, "r.csv", other_file, sizeof other_file - 1));
    MEASURE(sins_log_parse(scene_log_text, sizeof scene_log_text - 1, scene, &log, NULL));
    MEASURE(sins_log_destroy(log));
    CHECK(sins_destroy(sim) == SINS_OK && sins_flight_destroy(flight) == SINS_OK && sins_scene_destroy(scene) == SINS_OK);
}

/* Every function of every handle after a short flight with everything on. */
static void call_every_function(void)
{
    sins_sim *sim = scene_simulator(NULL, 1), *fresh = scene_simulator(NULL, 1);
    sins_flight *flight = scene_flight();
    sins_judge *judge = scene_judge();
    sins_unit *unit = scene_unit();
    sins_ensemble *ensemble = scene_ensemble();
    sins_scene *scene = scene_of_text();
    sins_log *log = scene_log();
    sins_play *play = scene_play();
    CHECK(sins_run(sim, samples, 2, 0, NULL, 0, NULL) == SINS_OK && sins_ensemble_run(ensemble, samples, 2) == SINS_OK);
    CHECK(sins_play_next(play) == SINS_OK && sins_play_next(play) == SINS_OK);
    every_other_call(fresh, scene, NULL, NULL);
    every_call(fresh, NULL, NULL);
    every_play_call(play, scene, NULL, NULL);
    every_log_call(log, NULL, NULL);
    every_unit_call(unit, sim, NULL, NULL);
    every_scene_call(scene, sim, NULL, NULL);
    every_ensemble_call(ensemble, NULL, NULL);
    every_judge_call(judge, NULL, NULL);
    every_flight_call(flight, NULL, NULL);
    every_call(sim, NULL, NULL);
    MEASURE(sins_destroy(sim));
    MEASURE(sins_destroy(fresh));
    MEASURE(sins_flight_destroy(flight));
    MEASURE(sins_judge_destroy(judge));
    MEASURE(sins_unit_destroy(unit));
    MEASURE(sins_ensemble_destroy(ensemble));
    MEASURE(sins_scene_destroy(scene));
    MEASURE(sins_log_destroy(log));
    MEASURE(sins_play_destroy(play));
    MEASURE_VALUE(sins_abi_version());
    MEASURE_VALUE(sins_version_string());
    MEASURE_VALUE(sins_status_string(SINS_OK));
}

/* Identification, whose solution and check take more stack. */
static void call_identify(void)
{
    sins_identify *identify;
    sins_flight_sample sample = {.struct_size = sizeof sample, .latitude_rad = 0.7};
    sins_recorded_increment increment = {.struct_size = sizeof increment, .interval_s = 0.1, .velocity_m_s = {0.0, 0.0, 0.98}};
    sins_identify_check_request of_check = {.struct_size = sizeof of_check, .twins = 40};
    find_bottom();
    identify = scene_identify();
    every_identify_call(identify, NULL, NULL);
    MEASURE(sins_identify_destroy(identify));
    identify = scene_identify();
    MEASURE(sins_identify_push_samples(identify, &sample, 1));
    MEASURE(sins_identify_push_increments(identify, &increment, 1));
    MEASURE(sins_identify_solve(identify, NULL));
    MEASURE(sins_identify_check(identify, &of_check, NULL));
    CHECK(sins_identify_destroy(identify) == SINS_OK);
}

static void call_all(void)
{
    sins_options options = {.struct_size = sizeof options, .subsamples = 5, .updates_per_sample = 16};
    find_bottom();
    call_every_function();
    call_with_scenes();
    options.error_model = SINS_ERROR_MODEL_RK4;
    options.truth_summary = SINS_SUMMARY_ON;
    options.covariance = SINS_COVARIANCE_ON;
    for (options.frame = SINS_FRAME_EARTH_FIXED; options.frame <= SINS_FRAME_GEOGRAPHIC; options.frame++) {
        for (options.scheme = SINS_SCHEME_EXACT; options.scheme <= SINS_SCHEME_POLYNOMIAL; options.scheme++) {
            for (options.signal = SINS_SIGNAL_PHYSICAL; options.signal <= SINS_SIGNAL_CLOSED_LOOP; options.signal++) {
                fly(&options);
                fly_ensemble(&options);
                fly_unit(&options);
            }
        }
        options.scheme = SINS_SCHEME_EXACT;
        options.signal = SINS_SIGNAL_PHYSICAL;
        ask(&options);
    }
}

/* Whether a function was measured, with success. No run has diverged, and no unit waits for its heading in ATT. */
static int has_succeeded(const char *name)
{
    size_t k = 0;
    while (deepest[k].name[0] != '\0' && strcmp(deepest[k].name, name) != 0) {
        k++;
    }
    if (!deepest[k].has_succeeded && strcmp(name, "sins_ensemble_get_diverged") != 0 &&
        strcmp(name, "sins_unit_enter_heading") != 0) {
        fprintf(stderr, "%s did not succeed\n", name);
        return 0;
    }
    return 1;
}

#define COUNT_SUCCESS(result, name, arguments) succeeded += has_succeeded(#name), all++;

int main(void)
{
    int k;
    size_t most = 0, most_solve = 0, succeeded = 0, all = 0;
    const char *name_most = "", *name_solve = "";
    scene_samples(samples);
    records[0].struct_size = sizeof records[0];
    for (k = 0; k < SCENE_COUNT; k++) {
        samples[k].flags |= SINS_SAMPLE_TEMPERATURE;
        samples[k].temperature_c = 20.0 + k;
    }
    on_a_small_stack(call_all);
    on_a_stack(DEEPEST_SOLVE + SMALL_STACK - DEEPEST, call_identify);
    for (k = 0; k < FUNCTIONS && deepest[k].name[0] != '\0'; k++) {
        printf("%6zu %s\n", deepest[k].bytes, deepest[k].name);
        if (strcmp(deepest[k].name, "sins_identify_solve") == 0 || strcmp(deepest[k].name, "sins_identify_check") == 0) {
#ifndef __SANITIZE_ADDRESS__
            CHECK(deepest[k].bytes <= DEEPEST_SOLVE);
#endif
            if (deepest[k].bytes > most_solve) {
                most_solve = deepest[k].bytes;
                name_solve = deepest[k].name;
            }
        } else if (deepest[k].bytes > most) {
            most = deepest[k].bytes;
            name_most = deepest[k].name;
        }
    }
#ifndef __SANITIZE_ADDRESS__
    CHECK(most <= DEEPEST);
#endif
    SINS_FUNCTIONS(COUNT_SUCCESS)
    CHECK(succeeded == all);
    printf("stack: %zu KB (`%s`); %zu KB (`%s`)\n", (most + 1023) / 1024, name_most, (most_solve + 1023) / 1024, name_solve);
    return 0;
}
