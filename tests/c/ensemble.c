/* Each run of an ensemble equals the simulator of its number to the bit. Statistics do not depend on how the runs were
 * split. An ensemble continues to the same bits from any snapshot. Each rejected call has its sentence. */

#include <string.h>

#include "failure_is.h"
#include "scene.h"

enum { COUNT = 257, RUNS = 6, FIRST_RUN = 40 };

static sins_flight_sample samples[SCENE_COUNT];
static int32_t model = SINS_ERROR_MODEL_RK4; /* or SINS_ERROR_MODEL_OFF */

static sins_sim *simulator(uint64_t run)
{
    sins_options options = {.struct_size = sizeof options};
    options.error_model = model;
    options.seed = 11;
    options.run = run;
    return scene_simulator(&options, 0);
}

static sins_ensemble *ensemble_of(uint64_t first_run, size_t runs)
{
    sins_sim *configured = simulator(0);
    sins_ensemble *ensemble = NULL;
    CHECK(sins_ensemble_create(configured, first_run, runs, &ensemble) == SINS_OK);
    CHECK(sins_destroy(configured) == SINS_OK);
    return ensemble;
}

/* Compares all reads of run FIRST_RUN + k with those of the simulator. */
static void compare(sins_ensemble *ensemble, sins_sim *sim, int k)
{
    static const int32_t sources[] = {SINS_ERRORS_NAVIGATION, SINS_ERRORS_MODEL};
    sins_navigation of_run = {.struct_size = sizeof of_run}, of_sim = {.struct_size = sizeof of_sim};
    sins_imu imu_of_run = {.struct_size = sizeof imu_of_run}, imu_of_sim = {.struct_size = sizeof imu_of_sim};
    sins_errors all[RUNS] = {{.struct_size = sizeof all[0]}};
    uint64_t run = FIRST_RUN + (uint64_t)k;
    int i;
    CHECK(sins_ensemble_get_navigation(ensemble, run, &of_run) == SINS_OK && sins_get_navigation(sim, &of_sim) == SINS_OK);
    CHECK(memcmp(&of_run, &of_sim, sizeof of_run) == 0);
    CHECK(sins_ensemble_get_truth(ensemble, &of_run) == SINS_OK && sins_get_truth(sim, &of_sim) == SINS_OK);
    CHECK(memcmp(&of_run, &of_sim, sizeof of_run) == 0);
    CHECK(sins_ensemble_get_imu(ensemble, run, &imu_of_run) == sins_get_imu(sim, &imu_of_sim));
    CHECK(memcmp(&imu_of_run, &imu_of_sim, sizeof imu_of_run) == 0);
    for (i = 0; i < 2; i++) {
        sins_errors errors_of_run = {.struct_size = sizeof errors_of_run}, errors_of_sim = errors_of_run;
        sins_status status = sins_ensemble_get_errors(ensemble, run, sources[i], &errors_of_run);
        CHECK(status == sins_get_errors(sim, sources[i], &errors_of_sim));
        CHECK(status == (i == 1 && model == SINS_ERROR_MODEL_OFF ? SINS_ERROR_BAD_STATE : SINS_OK));
        CHECK(memcmp(&errors_of_run, &errors_of_sim, sizeof errors_of_run) == 0);
        CHECK(sins_ensemble_get_all_errors(ensemble, sources[i], all, RUNS) == status);
        CHECK(status != SINS_OK || memcmp(&all[k], &errors_of_sim, sizeof all[k]) == 0);
    }
}

/* A run that has diverged is flagged among the errors of all; the others have those of their simulators. The statistics of all these
 * errors, added one by one, are those of the ensemble. */
static void a_run_that_diverged_is_flagged(void)
{
    static sins_statistics added, whole, before_error;
    sins_ensemble *ensemble = ensemble_of(FIRST_RUN, RUNS);
    sins_correction fall = {.struct_size = sizeof fall, .position_enu_m = {0.0, 0.0, 4.95e5}, .velocity_enu_m_s = {0.0, 0.0, 9e3}};
    sins_errors all[RUNS] = {{.struct_size = sizeof all[0]}}, before[RUNS], one = {.struct_size = sizeof one};
    int k;
    SINS_INIT(added);
    SINS_INIT(whole);
    memset(&all[1], 0xa5, sizeof all - sizeof all[0]); /* as from malloc */
    memcpy(before, all, sizeof all);
    CHECK(sins_ensemble_get_all_errors(ensemble, SINS_ERRORS_NAVIGATION, all, RUNS) == SINS_NEED_SAMPLE);
    CHECK(sins_ensemble_run(ensemble, samples, 2) == SINS_OK);
    CHECK(sins_ensemble_get_all_errors(ensemble, SINS_ERRORS_NAVIGATION, all, RUNS - 1) == SINS_ERROR_BUFFER_TOO_SMALL);
    CHECK(strcmp(sentence_of(NULL), "capacity = 5: is too small; needed: 6") == 0);
    CHECK(memcmp(before, all, sizeof all) == 0);
    for (k = 0; k < 9; k++) { /* faster than the loop of the vertical channel lifts it */
        CHECK(sins_ensemble_correct(ensemble, FIRST_RUN + 2, &fall) == SINS_OK);
        fall.position_enu_m[2] = 0.0;
    }
    CHECK(sins_ensemble_run(ensemble, &samples[2], COUNT - 2) == SINS_OK);
    CHECK(sins_ensemble_get_all_errors(ensemble, SINS_ERRORS_NAVIGATION, all, RUNS) == SINS_OK);
    for (k = 0; k < RUNS; k++) {
        CHECK(all[k].struct_size == sizeof one && all[k].time_s == samples[COUNT - 1].time_s);
        if (k == 2) {
            CHECK(all[k].flags == SINS_ERRORS_NOT_COMPUTED && all[k].position_enu_m[2] == 0.0);
        } else {
            CHECK(sins_ensemble_get_errors(ensemble, FIRST_RUN + (uint64_t)k, SINS_ERRORS_NAVIGATION, &one) == SINS_OK);
            CHECK(memcmp(&all[k], &one, sizeof one) == 0);
        }
        CHECK(sins_statistics_add(&added, &all[k]) == SINS_OK);
    }
    CHECK(sins_ensemble_get_statistics(ensemble, SINS_ERRORS_NAVIGATION, &whole) == SINS_OK);
    CHECK(memcmp(&added, &whole, sizeof added) == 0 && added.runs == RUNS && added.diverged == 1);
    added.runs++;
    before_error = added;
    CHECK(sins_statistics_add(&added, &all[0]) == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(memcmp(&added, &before_error, sizeof added) == 0);
    CHECK(sins_ensemble_destroy(ensemble) == SINS_OK);
}

/* Sample by sample and with sins_ensemble_run(), with a reposition, a reset, and a failure in flight. */
static void runs_are_simulators(void)
{
    sins_ensemble *ensemble = ensemble_of(FIRST_RUN, RUNS);
    sins_failure noise = {.struct_size = sizeof noise, .kind = SINS_FAILURE_NOISE, .density = 1e-4};
    sins_sim *sims[RUNS];
    int i, k, round;
    for (i = 0; i < RUNS; i++) {
        sims[i] = simulator(FIRST_RUN + (uint64_t)i);
    }
    for (round = 0; round < 2; round++) {
        for (k = 0; k < 64; k++) {
            CHECK(sins_ensemble_push_sample(ensemble, &samples[k]) == SINS_OK);
            CHECK(sins_ensemble_step(ensemble) == (k == 0 ? SINS_NEED_SAMPLE : SINS_OK));
            for (i = 0; i < RUNS; i++) {
                CHECK(sins_push_sample(sims[i], &samples[k]) == SINS_OK && sins_step(sims[i]) >= SINS_OK);
                compare(ensemble, sims[i], i);
            }
        }
        CHECK(sins_ensemble_set_failure(ensemble, SINS_SENSOR_GYRO, 1, &noise) == SINS_OK);
        CHECK(sins_ensemble_run(ensemble, &samples[k], COUNT - k) == SINS_OK);
        for (i = 0; i < RUNS; i++) {
            CHECK(sins_set_failure(sims[i], SINS_SENSOR_GYRO, 1, &noise) == SINS_OK);
            CHECK(sins_run(sims[i], &samples[k], (size_t)(COUNT - k), 0, NULL, 0, NULL) == SINS_OK);
            compare(ensemble, sims[i], i);
            CHECK(sins_reposition(sims[i], &samples[500]) == SINS_OK);
        }
        CHECK(sins_ensemble_reposition(ensemble, &samples[500]) == SINS_OK);
        /* A gap of 0.75 s, soon after the first intervals. */
        CHECK(sins_ensemble_run(ensemble, &samples[501], 4) == SINS_OK);
        CHECK(sins_ensemble_run(ensemble, &samples[600], 10) == SINS_GAP);
        for (i = 0; i < RUNS; i++) {
            CHECK(sins_run(sims[i], &samples[501], 4, 0, NULL, 0, NULL) == SINS_OK);
            CHECK(sins_run(sims[i], &samples[600], 10, 0, NULL, 0, NULL) == SINS_GAP);
            compare(ensemble, sims[i], i);
            CHECK(sins_reset(sims[i]) == SINS_OK);
        }
        CHECK(sins_ensemble_reset(ensemble) == SINS_OK);
    }
    for (i = 0; i < RUNS; i++) {
        CHECK(sins_destroy(sims[i]) == SINS_OK);
    }
    CHECK(sins_ensemble_destroy(ensemble) == SINS_OK);
}

static void statistics_of(uint64_t first_run, size_t runs, int32_t source, sins_statistics *statistics)
{
    sins_ensemble *ensemble = ensemble_of(first_run, runs);
    SINS_INIT(*statistics);
    CHECK(sins_ensemble_get_statistics(ensemble, source, statistics) == SINS_NEED_SAMPLE);
    CHECK(statistics->runs == 0);
    CHECK(sins_ensemble_run(ensemble, samples, COUNT) == SINS_OK);
    CHECK(sins_ensemble_get_statistics(ensemble, source, statistics) == SINS_OK);
    CHECK(sins_ensemble_destroy(ensemble) == SINS_OK);
}

/* All six runs are within the largest error, and none is within a micrometre: enough to reject 95 %, too few to decide on 50 %. */
static void a_verdict(const sins_statistics *statistics, const sins_figures *figures)
{
    sins_verdict verdict = {.struct_size = sizeof verdict};
    CHECK(sins_meets(statistics, figures->largest_radial_m, 95.0, &verdict) == SINS_OK);
    CHECK(verdict.decision == SINS_DECISION_UNDECIDED && verdict.runs == 6 && verdict.inside == 6);
    CHECK(verdict.more_runs == 73 - 6 && verdict.fraction_high == 1.0);
    CHECK(sins_meets(statistics, 1e-6, 95.0, &verdict) == SINS_OK);
    CHECK(verdict.decision == SINS_DECISION_NOT_MET && verdict.inside == 0 && verdict.more_runs == 0);
    CHECK(sins_meets(statistics, 0.0, 95.0, &verdict) == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sins_meets(statistics, 1.0, 100.0, &verdict) == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(strcmp(sentence_of(NULL), "percent = 100: must be above 0 and below 100") == 0);
}

static void any_split_is_the_same(void)
{
    static sins_statistics whole, parts[3], sum;
    static const int order[3][3] = {{0, 1, 2}, {2, 0, 1}, {1, 2, 0}};
    int32_t source;
    int i, k;
    for (source = SINS_ERRORS_NAVIGATION; source <= SINS_ERRORS_MODEL; source++) {
        sins_figures figures = {.struct_size = sizeof figures};
        statistics_of(FIRST_RUN, 6, source, &whole);
        statistics_of(FIRST_RUN, 1, source, &parts[0]);
        statistics_of(FIRST_RUN + 1, 3, source, &parts[1]);
        statistics_of(FIRST_RUN + 4, 2, source, &parts[2]);
        for (i = 0; i < 3; i++) {
            SINS_INIT(sum);
            for (k = 0; k < 3; k++) {
                CHECK(sins_statistics_merge(&sum, &parts[order[i][k]]) == SINS_OK);
            }
            CHECK(memcmp(&sum, &whole, sizeof sum) == 0);
        }
        CHECK(sins_statistics_figures(&whole, &figures) == SINS_OK);
        CHECK(figures.runs == 6 && figures.diverged == 0 && figures.out_of_range == 0);
        CHECK(figures.cep50_m > 0.0 && figures.cep50_m <= figures.r95_m && figures.r95_m <= figures.largest_radial_m);
        a_verdict(&whole, &figures);
        for (i = 0; i < 3; i++) {
            double mean = figures.mean_velocity_enu_m_s[i], sigma = figures.sigma_velocity_enu_m_s[i];
            double rms = figures.rms_velocity_enu_m_s[i];
            CHECK(sigma > 0.0 && fabs(sigma * sigma - figures.covariance[10 * (i + 3)]) < 1e-15 * sigma * sigma);
            CHECK(fabs(rms * rms - mean * mean - 5.0 / 6.0 * sigma * sigma) < 1e-14 * rms * rms);
            CHECK(figures.covariance[9 * i + 4] == figures.covariance[9 * 4 + i]);
        }
    }
    parts[0].runs++;
    CHECK(sins_statistics_merge(&sum, &parts[0]) == SINS_ERROR_INVALID_ARGUMENT);
    failure_is(NULL, SINS_ERROR_INVALID_ARGUMENT);
    CHECK(strstr(sentence_of(NULL), "sum of statistics.histogram = 1: is damaged") != NULL);
    CHECK(memcmp(&sum, &whole, sizeof sum) == 0);
}

static void goes_on_from_a_snapshot(void)
{
    static unsigned char bytes[RUNS * SINS_SNAPSHOT_MAX_SIZE], again[sizeof bytes];
    static sins_statistics expected, found;
    sins_ensemble *saved = ensemble_of(FIRST_RUN, RUNS), *other = ensemble_of(0, 1);
    size_t size = 0, written = 77, runs = 0;
    uint64_t first_run = 0;
    SINS_INIT(expected);
    SINS_INIT(found);
    CHECK(sins_ensemble_run(saved, samples, 100) == SINS_OK);
    CHECK(sins_ensemble_snapshot_size(saved, &size) == SINS_OK && size <= sizeof bytes);
    CHECK(sins_ensemble_snapshot_save(saved, bytes, size - 1, &written) == SINS_ERROR_BUFFER_TOO_SMALL && written == 77);
    CHECK(strstr(sentence_of(NULL), "capacity = ") == sentence_of(NULL));
    CHECK(sins_ensemble_snapshot_save(saved, bytes, sizeof bytes, &written) == SINS_OK && written == size);
    CHECK(sins_ensemble_snapshot_load(other, bytes, size - 1) == SINS_ERROR_SNAPSHOT);
    bytes[size / 2] ^= 1;
    CHECK(sins_ensemble_snapshot_load(other, bytes, size) == SINS_ERROR_SNAPSHOT);
    bytes[size / 2] ^= 1;
    CHECK(sins_ensemble_get_runs(other, &first_run, &runs) == SINS_OK && first_run == 0 && runs == 1);
    CHECK(sins_ensemble_snapshot_load(other, bytes, size) == SINS_OK);
    CHECK(sins_ensemble_get_runs(other, &first_run, &runs) == SINS_OK && first_run == FIRST_RUN && runs == RUNS);
    CHECK(sins_ensemble_run(saved, &samples[100], 100) == SINS_OK && sins_ensemble_run(other, &samples[100], 100) == SINS_OK);
    CHECK(sins_ensemble_get_statistics(saved, SINS_ERRORS_NAVIGATION, &expected) == SINS_OK);
    CHECK(sins_ensemble_get_statistics(other, SINS_ERRORS_NAVIGATION, &found) == SINS_OK);
    CHECK(memcmp(&expected, &found, sizeof found) == 0);
    CHECK(sins_ensemble_snapshot_save(saved, bytes, sizeof bytes, &size) == SINS_OK);
    CHECK(sins_ensemble_snapshot_save(other, again, sizeof again, &written) == SINS_OK);
    CHECK(size == written && memcmp(bytes, again, size) == 0);
    CHECK(sins_ensemble_destroy(saved) == SINS_OK && sins_ensemble_destroy(other) == SINS_OK);
}

static void refusals(void)
{
    sins_ensemble *ensemble = ensemble_of(FIRST_RUN, RUNS), *none = NULL;
    sins_sim *sim = simulator(0);
    sins_errors errors = {.struct_size = sizeof errors};
    sins_imu imu = {.struct_size = sizeof imu};
    sins_flight_sample wrong[3];
    uint64_t run = 99;
    CHECK(sins_ensemble_get_errors(ensemble, FIRST_RUN, SINS_ERRORS_NAVIGATION, &errors) == SINS_NEED_SAMPLE);
    CHECK(sins_ensemble_get_imu(ensemble, FIRST_RUN, &imu) == SINS_NEED_SAMPLE);
    CHECK(sins_ensemble_get_errors(ensemble, FIRST_RUN - 1, SINS_ERRORS_NAVIGATION, &errors) == SINS_ERROR_INVALID_ARGUMENT);
    failure_is(NULL, SINS_ERROR_INVALID_ARGUMENT);
    CHECK(strcmp(sentence_of(NULL), "run = 39: must be from 40 to 45") == 0);
    CHECK(sins_ensemble_get_errors(ensemble, FIRST_RUN, 2, &errors) == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sins_ensemble_get_diverged(ensemble, 0, &run) == SINS_ERROR_INVALID_ARGUMENT && run == 99);
    failure_is(NULL, SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sins_ensemble_create(sim, 0, 0, &none) == SINS_ERROR_INVALID_ARGUMENT);
    failure_is(NULL, SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sins_push_sample(sim, &samples[0]) == SINS_OK);
    CHECK(sins_ensemble_create(sim, 0, 1, &none) == SINS_ERROR_BAD_STATE && none == NULL);
    /* The sentence names the faulty sample, and the samples before it were flown. */
    memcpy(wrong, samples, sizeof wrong);
    wrong[2].height_m = 1e9;
    CHECK(sins_ensemble_run(ensemble, wrong, 3) == SINS_ERROR_INVALID_ARGUMENT);
    failure_is(NULL, SINS_ERROR_INVALID_ARGUMENT);
    CHECK(strstr(sentence_of(NULL), "(samples[2])") != NULL);
    CHECK(sins_ensemble_run(ensemble, &samples[2], 1) == SINS_OK);
    CHECK(sins_destroy(sim) == SINS_OK && sins_ensemble_destroy(ensemble) == SINS_OK);
}

int main(void)
{
    scene_samples(samples);
    runs_are_simulators();
    a_run_that_diverged_is_flagged();
    model = SINS_ERROR_MODEL_OFF;
    runs_are_simulators();
    a_run_that_diverged_is_flagged();
    goes_on_from_a_snapshot();
    model = SINS_ERROR_MODEL_RK4;
    any_split_is_the_same();
    goes_on_from_a_snapshot();
    refusals();
    printf("ensemble: %d runs are the simulators of their numbers\n", RUNS);
    return 0;
}
