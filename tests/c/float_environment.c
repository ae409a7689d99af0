/* The host's floating-point state: with any state on entry, the results have the same bits, and the whole state is restored on
 * exit. The states have every exception unmasked (a raised one ends this program), every rounding, denormals flushed, x87 at 24
 * bits, and its registers in use. */

#if defined(__i386__)
/* The host's own numbers must not use x87, whose registers are full. */
#pragma GCC target("sse2,fpmath=sse")
#endif

#include <stdint.h>
#include <string.h>

#include "every_call.h"

#if defined(__x86_64__) || defined(__i386__)

enum { NO_REGISTERS, MMX_REGISTERS, X87_REGISTERS };

/* MXCSR, and the control, status and tag words of x87 with its registers, which MMX shares. */
typedef struct {
    uint32_t mxcsr;
    uint16_t x87[3];
    uint16_t in_use; /* the registers to fill: one of the values above */
    unsigned char registers[80];
} float_state;

static float_state get_state(void)
{
    float_state state;
    struct {
        uint32_t environment[7];
        unsigned char registers[80];
    } x87;
    int k;
    memset(&state, 0, sizeof state);
    /* fnsave resets x87; frstor restores it. */
    __asm__ volatile("fnsave %0\n\tfrstor %0" : "=m"(x87));
    __asm__ volatile("stmxcsr %0" : "=m"(state.mxcsr));
    state.x87[0] = (uint16_t)x87.environment[0];
    state.x87[1] = (uint16_t)x87.environment[1];
    state.x87[2] = (uint16_t)x87.environment[2];
    /* The content of an empty register is undefined. Registers are stored from the top of the stack, tags are not. */
    for (k = 0; k < 8; k++) {
        int tag = state.x87[2] >> 2 * ((k + (state.x87[1] >> 11)) % 8) & 3;
        if (tag != 3) {
            memcpy(state.registers + 10 * k, x87.registers + 10 * k, 10);
        }
    }
    return state;
}

static void set_state(float_state state)
{
    static const uint64_t values[8] = {1, 0x7ff0000000000001, 3, 0x8000000000000000, 5, 0, 7, ~(uint64_t)0};
    __asm__ volatile("emms\n\tfnclex\n\tfldcw %0" ::"m"(state.x87[0]));
    if (state.in_use == MMX_REGISTERS) {
        __asm__ volatile("movq (%0), %%mm0\n\tmovq 8(%0), %%mm1\n\tmovq 16(%0), %%mm2\n\tmovq 24(%0), %%mm3\n\t"
                         "movq 32(%0), %%mm4\n\tmovq 40(%0), %%mm5\n\tmovq 48(%0), %%mm6\n\tmovq 56(%0), %%mm7" ::"r"(values),
                         "m"(values));
    } else if (state.in_use == X87_REGISTERS) {
        __asm__ volatile("fldpi\n\tfldz\n\tfld1");
    }
    __asm__ volatile("ldmxcsr %0" ::"m"(state.mxcsr));
}

enum { STATES = 64 };

/* MXCSR takes all combinations of rounding, masks and flushing, without and with all exception flags set. Each has an x87 control
 * word; these take all combinations of precision (24, 53, 64 bits), rounding and masks. The x87 registers are empty, all in use
 * (as MMX leaves them without EMMS), or three in use. */
static float_state state_of(int i)
{
    static const uint32_t precisions[3] = {0x000, 0x200, 0x300};
    int j = 7 * i % 24;
    float_state state;
    memset(&state, 0, sizeof state);
    state.mxcsr = (uint32_t)(i & 3) << 13 | (i & 4 ? 0x1f80u : 0) | (i & 8 ? 0x8000u : 0) | (i & 16 ? 0x0040u : 0);
    state.mxcsr |= i & 32 ? 0x3fu : 0;
    state.x87[0] = (uint16_t)(0x40 | precisions[j % 3] | (uint32_t)(j / 3 % 4) << 10 | (j / 12 ? 0x3fu : 0));
    state.in_use = (uint16_t)(i / 3 % 3);
    return state;
}

#elif defined(__aarch64__)

typedef struct {
    uint64_t fpcr;
} float_state;

static float_state get_state(void)
{
    float_state state;
    __asm__ volatile("mrs %0, fpcr" : "=r"(state.fpcr));
    return state;
}

static void set_state(float_state state)
{
    __asm__ volatile("msr fpcr, %0" ::"r"(state.fpcr));
}

enum { STATES = 32 };

/* Rounding, flushing, default NaN, and the traps, which a processor may lack. */
static float_state state_of(int i)
{
    float_state state;
    state.fpcr = (uint64_t)(i & 3) << 22 | (i & 4 ? 1u << 24 : 0) | (i & 8 ? 1u << 25 : 0) | (i & 16 ? 0x9f00u : 0);
    return state;
}
#endif

enum { COUNT = 129 };

/* Everything that a host can read of a flight. */
typedef struct {
    sins_record record;
    sins_navigation truth, navigation, alone;
    sins_errors errors, model;
    sins_imu imu;
    sins_compensation compensation;
    sins_imu_increment part;
    sins_accuracy accuracy;
    sins_truth_summary summary;
    sins_covariance covariance;
    sins_options options, recommended;
    sins_cost cost;
    sins_budget budget;
    sins_identified identified;
    sins_identified_check checked;
    sins_identified_span span;
    sins_identified_parameter parameter;
    sins_budget_row rows[SCENE_BUDGET_ROWS];
    sins_gyro_params gyro;
    sins_accel_params accel;
    sins_initial_errors initial;
    const char *texts[2];
    uint32_t version, reserved;
    double duration_s;
    sins_flight_sample piece[COUNT];
    sins_unit_navigation shown;
    sins_bus_word words[64];
    sins_bus_label label;
    unsigned char unit[SINS_UNIT_SNAPSHOT_MAX_SIZE];
    sins_error_info info;
    char sentence[200], written[8192], keys[32768], name[32];
    sins_fault fault;
    sins_flight_sample of_log;
    sins_scene_key key;
    char line[2048];
    char value[128];
    sins_record of_scene, of_play;
    sins_statistics statistics, model_statistics;
    sins_figures figures;
    sins_verdict verdict;
} results;

static void ignore(const char *call, sins_status status, void *context)
{
    (void)call;
    (void)status;
    (void)context;
}

/* Reads, flies and writes a scene and a log. */
static void fly_scene(results *found)
{
    sins_scene *scene = scene_of_text(), *other = NULL;
    sins_log *log = scene_log();
    sins_play *play = scene_play();
    sins_sim *sim = NULL, *of_play = NULL;
    sins_flight *flight = NULL;
    sins_flight_sample sample = {.struct_size = sizeof sample};
    int k;
    SINS_INIT(found->fault);
    SINS_INIT(found->of_log);
    SINS_INIT(found->of_scene);
    CHECK(sins_scene_parse("[gyro]\nbias_deg_h = 1e999\n", 26, &other) == SINS_SCENE_HAS_FAULTS);
    CHECK(sins_scene_get_fault(other, 0, &found->fault) == SINS_OK && sins_scene_destroy(other) == SINS_OK);
    CHECK(sins_scene_create(&other) == SINS_OK && sins_scene_destroy(other) == SINS_OK);
    CHECK(sins_scene_create_builtin("patrol", &other) == SINS_OK && sins_scene_destroy(other) == SINS_OK);
    CHECK(sins_scene_write(scene, found->written, sizeof found->written, NULL) == SINS_OK);
    CHECK(sins_scene_builtin_name(1, found->name, sizeof found->name, NULL) == SINS_OK);
    CHECK(sins_scene_write_keys(found->keys, sizeof found->keys, NULL) == SINS_OK);
    SINS_INIT(found->key);
    CHECK(sins_scene_get_key(20, &found->key) == SINS_OK);
    CHECK(sins_scene_set_values(scene, "gyro.bias_deg_h[2] = 1e-3") == SINS_OK);
    CHECK(sins_scene_get_value(scene, "gyro.bias_rad_s", found->value, sizeof found->value, NULL) == SINS_OK);
    CHECK(sins_scene_create_simulator(scene, &sim) == SINS_OK);
    CHECK(sins_scene_create_flight(scene, &flight) == SINS_OK);
    for (k = 0; k < COUNT; k++) {
        CHECK(sins_flight_sample_at(flight, scene_time(k), &sample) == SINS_OK);
        CHECK(sins_scene_prepare(scene, sim, 0.0, &sample) == SINS_OK);
        CHECK(sins_push_sample(sim, &sample) == SINS_OK && sins_step(sim) >= SINS_OK);
    }
    CHECK(sins_get_record(sim, &found->of_scene) == SINS_OK);
    CHECK(sins_log_get_sample(log, 2, &found->of_log, NULL) == SINS_OK);
    every_log_call(log, ignore, NULL);
    every_scene_call(scene, sim, ignore, NULL);
    SINS_INIT(found->of_play);
    CHECK(sins_play_run(play, &found->of_play, 1, NULL) == SINS_OK);
    for (k = 0; k < COUNT; k++) {
        CHECK(sins_play_next(play) == SINS_OK);
    }
    CHECK(sins_play_get_simulator(play, &of_play) == SINS_OK && sins_get_record(of_play, &found->of_play) == SINS_OK);
    every_play_call(play, scene, ignore, NULL);
    CHECK(sins_play_destroy(play) == SINS_OK);
    CHECK(sins_destroy(sim) == SINS_OK && sins_flight_destroy(flight) == SINS_OK);
    CHECK(sins_scene_destroy(scene) == SINS_OK && sins_log_destroy(log) == SINS_OK);
}

/* The statistics of an ensemble after one second. */
static void fly_ensemble(results *found)
{
    sins_ensemble *ensemble = scene_ensemble();
    sins_errors errors = {.struct_size = sizeof errors, .position_enu_m = {1.0 / 3.0, -2e3, 0.1}};
    SINS_INIT(found->statistics);
    SINS_INIT(found->model_statistics);
    SINS_INIT(found->figures);
    SINS_INIT(found->verdict);
    CHECK(sins_ensemble_run(ensemble, found->piece, COUNT) == SINS_OK);
    CHECK(sins_ensemble_get_statistics(ensemble, SINS_ERRORS_NAVIGATION, &found->statistics) == SINS_OK);
    CHECK(sins_ensemble_get_statistics(ensemble, SINS_ERRORS_MODEL, &found->model_statistics) == SINS_OK);
    CHECK(sins_statistics_merge(&found->statistics, &found->model_statistics) == SINS_OK);
    CHECK(sins_statistics_add(&found->statistics, &errors) == SINS_OK);
    CHECK(sins_statistics_figures(&found->statistics, &found->figures) == SINS_OK);
    CHECK(sins_meets(&found->statistics, 1.0, 95.0, &found->verdict) == SINS_OK);
    CHECK(found->figures.runs == 2 * SCENE_RUNS + 1 && found->figures.cep50_m > 0.0);
    every_ensemble_call(ensemble, ignore, NULL);
    CHECK(sins_ensemble_destroy(ensemble) == SINS_OK);
}

/* A unit that aligns for a second of the simulator, and navigates for the next. */
static void fly_unit(results *found)
{
    sins_unit *unit = NULL;
    sins_sim *sim = NULL;
    sins_unit_params params = {.struct_size = sizeof params, .power_up_test_s = 0.1, .alignment_s = 0.5};
    sins_flight_sample sample = {.struct_size = sizeof sample, .latitude_rad = 0.7};
    sins_unit_status status;
    sins_bus_label label = {.struct_size = sizeof label};
    size_t size = 0;
    int k;
    CHECK(sins_create(NULL, &sim) == SINS_OK && sins_unit_create(&params, SINS_UNIT_OFF, &unit) == SINS_OK);
    CHECK(sins_unit_select(unit, SINS_UNIT_NAV) == SINS_OK);
    for (k = 0; k < COUNT; k++) {
        sample.time_s = scene_time(k);
        CHECK(sins_push_sample(sim, &sample) == SINS_OK && sins_step(sim) == (k == 0 ? SINS_NEED_SAMPLE : SINS_OK));
        CHECK(k == 0 || sins_unit_update(unit, sim) == SINS_OK);
        CHECK(k != 20 || sins_unit_enter_position(unit, 0.7, 0.0) == SINS_OK);
    }
    SINS_INIT(found->shown);
    CHECK(sins_unit_get_navigation(unit, sim, &found->shown) == SINS_OK);
    CHECK(found->shown.validity & SINS_UNIT_VALID_VELOCITY);
    SINS_INIT(status);
    SINS_INIT(found->words[0]);
    SINS_INIT(found->label);
    CHECK(sins_unit_get_status(unit, &status) == SINS_OK);
    CHECK(sins_bus_words(&status, &found->shown, NULL, 0.0, 0.04, found->words, 64, &size) == SINS_OK && size > 20);
    CHECK(sins_bus_decode(found->words[0].word, 0, &found->label) == SINS_OK);
    CHECK(sins_bus_get_label(1, &label) == SINS_OK);
    CHECK(sins_unit_snapshot_save(unit, found->unit, sizeof found->unit, &size) == SINS_OK);
    every_unit_call(unit, sim, ignore, NULL);
    CHECK(sins_unit_destroy(unit) == SINS_OK && sins_destroy(sim) == SINS_OK);
}

/* Flies one second with every effect. Every function is called with this floating-point state. */
static void fly(const float_state *state, results *found)
{
    sins_correction correction;
    sins_requirement requirement = {.struct_size = sizeof requirement, .position_m = 1e-7};
    sins_imu_increment increment = {.struct_size = sizeof increment, .interval_s = 0.0078125, .count = 1};
    float_state normal = get_state(), before, after;
    sins_flight *flight;
    sins_judge *judge;
    sins_identify *identify;
    sins_sim *sim, *other;
    int k;

    memset(found, 0, sizeof *found);
    SINS_INIT(found->record);
    SINS_INIT(found->truth);
    SINS_INIT(found->navigation);
    SINS_INIT(found->alone);
    SINS_INIT(found->errors);
    SINS_INIT(found->model);
    SINS_INIT(found->imu);
    SINS_INIT(found->compensation);
    SINS_INIT(correction);
    correction.position_enu_m[0] = correction.gyro_bias_rad_s[1] = 1.0 / 1024.0;
    SINS_INIT(found->part);
    SINS_INIT(found->accuracy);
    SINS_INIT(found->summary);
    SINS_INIT(found->covariance);
    SINS_INIT(found->options);
    SINS_INIT(found->recommended);
    SINS_INIT(found->cost);
    SINS_INIT(found->identified);
    SINS_INIT(found->checked);
    SINS_INIT(found->span);
    SINS_INIT(found->parameter);
    SINS_INIT(found->gyro);
    SINS_INIT(found->accel);
    SINS_INIT(found->initial);
    SINS_INIT(found->info);

    if (state != NULL) {
        set_state(*state);
    }
    before = get_state();
    found->version = sins_abi_version();
    found->texts[0] = sins_version_string();
    found->texts[1] = sins_status_string(SINS_ERROR_TIME_ORDER);
    CHECK(sins_gyro_preset(SINS_GRADE_CONSUMER, &found->gyro) == SINS_OK);
    CHECK(sins_accel_preset(SINS_GRADE_CONSUMER, &found->accel) == SINS_OK);
    CHECK(sins_initial_preset(SINS_GRADE_CONSUMER, &found->initial) == SINS_OK);
    sim = scene_simulator(NULL, 1);
    other = scene_simulator(NULL, 2);
    flight = scene_flight();
    CHECK(sins_flight_duration(flight, &found->duration_s) == SINS_OK);
    for (k = 0; k < COUNT; k++) {
        found->piece[k].struct_size = sizeof found->piece[k];
        /* The times are exact in binary, so the host's own arithmetic raises no exception and rounds nothing. */
        CHECK(sins_flight_sample_at(flight, scene_time(k), &found->piece[k]) == SINS_OK);
        CHECK(sins_push_sample(sim, &found->piece[k]) == SINS_OK);
        CHECK(sins_step(sim) == (k == 0 ? SINS_NEED_SAMPLE : SINS_OK));
    }
    CHECK(sins_push_sample(sim, &found->piece[3]) == SINS_ERROR_TIME_ORDER);
    CHECK(sins_last_error(sim, found->sentence, sizeof found->sentence, NULL) == SINS_OK);
    CHECK(sins_last_error_info(sim, &found->info) == SINS_OK);
    CHECK(sins_get_record(sim, &found->record) == SINS_OK);
    CHECK(sins_record_line(&found->record, NULL, 0, NULL, found->line, sizeof found->line, NULL) == SINS_OK);
    CHECK(sins_get_truth(sim, &found->truth) == SINS_OK);
    CHECK(sins_get_navigation(sim, &found->navigation) == SINS_OK);
    CHECK(sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &found->errors) == SINS_OK);
    CHECK(sins_get_errors(sim, SINS_ERRORS_MODEL, &found->model) == SINS_OK);
    CHECK(sins_get_imu(sim, &found->imu) == SINS_OK);
    CHECK(sins_get_imu_update(sim, 0, &found->part) == SINS_OK);
    CHECK(sins_correct(sim, &correction) == SINS_OK);
    CHECK(sins_get_compensation(sim, &found->compensation) == SINS_OK);
    CHECK(sins_get_accuracy(sim, &found->accuracy) == SINS_OK);
    CHECK(sins_get_truth_summary(sim, &found->summary) == SINS_OK);
    CHECK(sins_get_covariance(sim, &found->covariance) == SINS_OK);
    CHECK(sins_get_options(sim, &found->options) == SINS_OK);
    CHECK(sins_recommend(sim, found->piece, COUNT, &requirement, &found->recommended, &found->cost) == SINS_OK);
    /* Only a few samples: the budget measures the time of each effect in many rounds. */
    CHECK(scene_budget(found->piece, 5, found->rows, &found->budget) == SINS_OK);
    found->cost.ns_per_step = found->budget.ns_per_step = 0.0; /* times */
    for (k = 0; k < SCENE_BUDGET_ROWS; k++) {
        found->rows[k].ns_per_step = 0.0;
    }
    CHECK(sins_start_navigation(other, &found->navigation) == SINS_OK);
    CHECK(sins_push_imu(other, &increment) == SINS_OK);
    CHECK(sins_get_navigation(other, &found->alone) == SINS_OK);
    every_call(other, ignore, NULL);
    every_flight_call(flight, ignore, NULL);
    judge = scene_judge();
    every_judge_call(judge, ignore, NULL);
    CHECK(sins_judge_destroy(judge) == SINS_OK);
    identify = scene_identify();
    CHECK(sins_identify_get_parameter(identify, 5, &found->parameter) == SINS_OK);
    CHECK(sins_identify_solve(identify, &found->identified) == SINS_OK);
    CHECK(sins_identify_check(identify, NULL, &found->checked) == SINS_OK);
    CHECK(sins_identify_get_span(identify, 0, &found->span) == SINS_OK);
    every_identify_call(identify, ignore, NULL);
    CHECK(sins_identify_destroy(identify) == SINS_OK);
    fly_scene(found);
    fly_ensemble(found);
    fly_unit(found);
    CHECK(sins_flight_destroy(flight) == SINS_OK);
    CHECK(sins_destroy(sim) == SINS_OK && sins_destroy(other) == SINS_OK);
    after = get_state();
    set_state(normal);
    /* Control bits, exception flags and registers. */
    CHECK(memcmp(&before, &after, sizeof before) == 0);
}

int main(void)
{
    static results expected, found;
    int i;

    fly(NULL, &expected);
    for (i = 0; i < STATES; i++) {
        float_state state = state_of(i);
        fly(&state, &found);
        CHECK(memcmp(&expected, &found, sizeof expected) == 0);
    }
    printf("float_environment: same bits under %d states\n", i);
    return 0;
}
