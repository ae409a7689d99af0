/* Push, step, run, reads, setters, reset, reposition and saving in a real-time frame make no allocation and no system call, so
 * they never wait. The kernel kills the program at the first system call, while other threads fly, create and destroy. */

#define _GNU_SOURCE
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <math.h>
#include <pthread.h>
#include <stddef.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "allocator.h"
#include "scene.h"

/* A copy of stderr with its own number. The frame may write only there, when a check fails. */
enum { COMPLAINTS = 200 };

#define FRAME_CHECK(condition)                                                      \
    do {                                                                            \
        if (!(condition)) {                                                         \
            static const char text[] = "frame: " #condition " does not hold\n";     \
            syscall(SYS_write, COMPLAINTS, text, sizeof text - 1);                  \
            syscall(SYS_exit_group, 1);                                             \
        }                                                                           \
    } while (0)

static sins_flight_sample samples[SCENE_COUNT];
static volatile int over;

/* Other threads: one is always in a long call, and the handles of another go through all slots of the table. */
static void *fly_all_the_time(void *handle)
{
    static sins_record records[SCENE_COUNT - 1];
    sins_sim *sim = handle;
    while (!over) {
        scene_fly(sim, samples, records);
        CHECK(sins_reset(sim) == SINS_OK);
    }
    return NULL;
}

static void *create_and_destroy_all_the_time(void *unused)
{
    (void)unused;
    while (!over) {
        sins_sim *sim = NULL;
        CHECK(sins_create(NULL, &sim) == SINS_OK);
        CHECK(sins_destroy(sim) == SINS_OK);
    }
    return NULL;
}

static void forbid_system_calls(void)
{
    struct sock_filter filter[] = {
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, nr)),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_exit_group, 3, 0),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, SYS_write, 0, 3),
        BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(struct seccomp_data, args[0])),
        BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, COMPLAINTS, 0, 1),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
        BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_KILL_PROCESS),
    };
    struct sock_fprog program = {sizeof filter / sizeof filter[0], filter};
    CHECK(dup2(STDERR_FILENO, COMPLAINTS) == COMPLAINTS);
    CHECK(prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0);
    CHECK(prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) == 0);
}

/* Some reads have no value before the first interval. */
static int is_answer(sins_status status, int flown)
{
    return status == SINS_OK || (!flown && status == SINS_NEED_SAMPLE);
}

static void read_everything(sins_sim *sim, int flown)
{
    sins_navigation navigation = {.struct_size = sizeof navigation};
    sins_correction correction = {.struct_size = sizeof correction, .position_enu_m = {1.0}, .gyro_bias_rad_s = {1e-9}};
    sins_compensation compensation = {.struct_size = sizeof compensation};
    sins_imu imu = {.struct_size = sizeof imu};
    sins_imu_increment part = {.struct_size = sizeof part};
    sins_errors errors = {.struct_size = sizeof errors};
    sins_accuracy accuracy = {.struct_size = sizeof accuracy};
    sins_record record = {.struct_size = sizeof record};
    sins_options options = {.struct_size = sizeof options};
    sins_gyro_params gyro = {.struct_size = sizeof gyro};
    sins_accel_params accel = {.struct_size = sizeof accel};
    sins_altimeter_params altimeter = {.struct_size = sizeof altimeter};
    sins_failure failure = {.struct_size = sizeof failure};
    sins_initial_errors initial = {.struct_size = sizeof initial};
    sins_mounting mounting = {.struct_size = sizeof mounting};
    sins_gravity_params gravity = {.struct_size = sizeof gravity};
    sins_truth_summary summary = {.struct_size = sizeof summary};
    sins_covariance covariance = {.struct_size = sizeof covariance};
    char text[200];
    size_t needed;
    sins_error_info info = {.struct_size = sizeof info};
    FRAME_CHECK(sins_get_options(sim, &options) == SINS_OK);
    if (options.covariance == SINS_COVARIANCE_ON) {
        FRAME_CHECK(is_answer(sins_get_covariance(sim, &covariance), flown));
    } else {
        FRAME_CHECK(sins_get_covariance(sim, &covariance) == SINS_ERROR_BAD_STATE);
    }
    if (options.truth_summary == SINS_SUMMARY_ON) {
        FRAME_CHECK(is_answer(sins_get_truth_summary(sim, &summary), flown));
    } else {
        FRAME_CHECK(sins_get_truth_summary(sim, &summary) == SINS_ERROR_BAD_STATE);
    }
    FRAME_CHECK(is_answer(sins_get_truth(sim, &navigation), flown));
    FRAME_CHECK(is_answer(sins_get_navigation(sim, &navigation), flown));
    FRAME_CHECK(is_answer(sins_get_imu(sim, &imu), flown));
    FRAME_CHECK(is_answer(sins_get_imu_update(sim, 0, &part), flown));
    FRAME_CHECK(sins_correct(sim, &correction) == (flown ? SINS_OK : SINS_ERROR_BAD_STATE));
    FRAME_CHECK(sins_get_compensation(sim, &compensation) == SINS_OK);
    FRAME_CHECK(is_answer(sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &errors), flown));
    FRAME_CHECK(is_answer(sins_get_errors(sim, SINS_ERRORS_MODEL, &errors), flown));
    FRAME_CHECK(is_answer(sins_get_accuracy(sim, &accuracy), flown));
    FRAME_CHECK(is_answer(sins_get_record(sim, &record), flown));
    FRAME_CHECK(sins_get_options(sim, &options) == SINS_OK);
    FRAME_CHECK(sins_get_gyro(sim, &gyro) == SINS_OK);
    FRAME_CHECK(sins_get_accel(sim, &accel) == SINS_OK);
    FRAME_CHECK(sins_get_altimeter(sim, &altimeter) == SINS_OK);
    FRAME_CHECK(sins_get_failure(sim, SINS_SENSOR_GYRO, 1, &failure) == SINS_OK);
    FRAME_CHECK(sins_get_initial_errors(sim, &initial) == SINS_OK);
    FRAME_CHECK(sins_get_mounting(sim, &mounting) == SINS_OK);
    FRAME_CHECK(sins_get_gravity_disturbance(sim, &gravity) == SINS_OK);
    FRAME_CHECK(sins_last_error(sim, text, sizeof text, &needed) == SINS_OK);
    FRAME_CHECK(sins_last_error_info(sim, &info) == SINS_OK);
}

/* Calls that are allowed in flight: settings and snapshots. */
static void set_and_save(sins_sim *sim)
{
    static unsigned char snapshot[SINS_SNAPSHOT_MAX_SIZE];
    sins_gyro_params gyro = scene_gyro();
    sins_accel_params accel = scene_accel();
    sins_altimeter_params altimeter = scene_altimeter();
    sins_failure failure = {.struct_size = sizeof failure, .kind = SINS_FAILURE_STUCK};
    size_t size = 0, written = 1;
    FRAME_CHECK(sins_set_gyro(sim, &gyro) == SINS_OK);
    FRAME_CHECK(sins_set_accel(sim, &accel) == SINS_OK);
    FRAME_CHECK(sins_set_altimeter(sim, &altimeter) == SINS_OK);
    FRAME_CHECK(sins_set_failure(sim, SINS_SENSOR_ALTIMETER, 0, &failure) == SINS_OK);
    FRAME_CHECK(sins_snapshot_size(sim, &size) == SINS_OK);
    FRAME_CHECK(sins_snapshot_save(sim, snapshot, sizeof snapshot, &written) == SINS_OK && written == size);
}

/* Settings that are allowed before a flight. */
static void start_again(sins_sim *sim)
{
    sins_initial_errors initial = scene_initial_errors();
    sins_mounting mounting = {.struct_size = sizeof mounting, .lever_arm_m = {1.0, 2.0, 3.0}};
    sins_gravity_params gravity = {.struct_size = sizeof gravity, .anomaly_m_s2 = 1e-4};
    FRAME_CHECK(sins_move_time(sim, 1e6) == SINS_OK);
    FRAME_CHECK(sins_move_truth(sim, &samples[0]) == SINS_OK);
    FRAME_CHECK(sins_reposition(sim, &samples[0]) == SINS_OK);
    FRAME_CHECK(sins_set_initial_errors(sim, &initial) == SINS_OK);
    FRAME_CHECK(sins_reset(sim) == SINS_OK);
    FRAME_CHECK(sins_set_mounting(sim, &mounting) == SINS_OK);
    FRAME_CHECK(sins_set_gravity_disturbance(sim, &gravity) == SINS_OK);
}

/* Correct and wrong calls of a frame. */
static void fly_frames(sins_sim *sim, const sins_sim *stale)
{
    sins_navigation navigation = {.struct_size = sizeof navigation};
    int k;
    FRAME_CHECK(sins_step(sim) == SINS_NEED_SAMPLE);
    read_everything(sim, 0);
    for (k = 0; k < SCENE_COUNT / 2; k++) {
        sins_flight_sample wrong = samples[k];
        wrong.height_m = NAN;
        FRAME_CHECK(sins_push_sample(sim, &wrong) == SINS_ERROR_INVALID_ARGUMENT);
        FRAME_CHECK(sins_push_sample(sim, &samples[k]) == SINS_OK);
        FRAME_CHECK(sins_push_sample(sim, &samples[k]) == SINS_ERROR_TIME_ORDER);
        wrong = samples[k + 1];
        wrong.latitude_rad = -0.7;
        FRAME_CHECK(sins_push_sample(sim, &wrong) == SINS_ERROR_DISCONTINUITY);
        FRAME_CHECK(sins_push_sample(sim, NULL) == SINS_ERROR_NULL_POINTER);
        FRAME_CHECK(sins_step(sim) == (k == 0 ? SINS_NEED_SAMPLE : SINS_OK));
        read_everything(sim, k > 0);
        if (k % 64 == 63) {
            set_and_save(sim);
        }
        FRAME_CHECK(sins_get_navigation((sins_sim *)stale, &navigation) == SINS_ERROR_BAD_HANDLE);
    }
    for (; k < SCENE_COUNT / 2 + 16; k++) {
        FRAME_CHECK(sins_push_sample(sim, &samples[k]) == SINS_OK);
    }
    FRAME_CHECK(sins_push_sample(sim, &samples[k]) == SINS_ERROR_QUEUE_FULL);
    FRAME_CHECK(sins_run(sim, &samples[k], SCENE_COUNT - k, 0, NULL, 0, NULL) == SINS_OK);
    start_again(sim);
}

/* Navigation on increments, until the solution leaves its range. */
static void navigate_frames(sins_sim *sim)
{
    sins_imu_increment increment = {.struct_size = sizeof increment};
    sins_navigation navigation = {.struct_size = sizeof navigation};
    int k;
    sins_status status = SINS_OK;
    increment.interval_s = 0.01;
    increment.count = 5;
    for (k = 0; k < 5; k++) {
        increment.velocity_m_s[3 * k] = 5e3;
        increment.angle_rad[3 * k + 1] = 1e-4;
    }
    for (k = 0; k < 10 && status == SINS_OK; k++) {
        status = sins_push_imu(sim, &increment);
        FRAME_CHECK(sins_get_navigation(sim, &navigation) == SINS_OK);
    }
    FRAME_CHECK(status == SINS_ERROR_DIVERGED && k > 1);
}

/* A scene with a failure, updates and a temperature, and a log. */
static void fly_scene_frames(sins_scene *scene, sins_sim *sim, sins_flight *flight, sins_log *log)
{
    sins_flight_sample sample = {.struct_size = sizeof sample};
    int k;
    for (k = 0; k < 129; k++) {
        FRAME_CHECK(sins_flight_sample_at(flight, scene_time(k), &sample) == SINS_OK);
        FRAME_CHECK(sins_scene_prepare(scene, sim, 0.0, &sample) == SINS_OK);
        FRAME_CHECK(sample.flags & SINS_SAMPLE_TEMPERATURE);
        FRAME_CHECK(sins_push_sample(sim, &sample) == SINS_OK);
        FRAME_CHECK(sins_step(sim) == (k == 0 ? SINS_NEED_SAMPLE : SINS_OK));
    }
    for (k = 0; k < 3; k++) {
        FRAME_CHECK(sins_log_get_sample(log, (size_t)k, &sample, NULL) == SINS_OK);
    }
}

/* The same by one object, which has a unit too. */
static void fly_play_frames(sins_play *play, sins_flight *flight)
{
    static unsigned char snapshot[SINS_PLAY_SNAPSHOT_MAX_SIZE];
    static sins_record play_records[4];
    sins_imu imu = {.struct_size = sizeof imu};
    sins_flight_sample sample = {.struct_size = sizeof sample};
    sins_unit_status status = {.struct_size = sizeof status};
    sins_unit_navigation shown = {.struct_size = sizeof shown};
    size_t written;
    int k;
    SINS_INIT(play_records[0]);
    for (k = 0; k < 65; k++) {
        FRAME_CHECK(sins_play_next(play) == SINS_OK);
        FRAME_CHECK(sins_play_get_shown(play, &status, &shown) == (k == 0 ? SINS_NEED_SAMPLE : SINS_OK));
    }
    for (; k < 129; k++) {
        FRAME_CHECK(sins_flight_sample_at(flight, scene_time(k), &sample) == SINS_OK);
        FRAME_CHECK(sins_play_push(play, &sample) == SINS_OK);
        FRAME_CHECK(sins_play_push(play, &sample) == SINS_ERROR_TIME_ORDER);
    }
    FRAME_CHECK(sins_play_run(play, play_records, 4, &written) == SINS_OK && written == 4);
    FRAME_CHECK(sins_play_run_imu(play, &imu, 1, &written) == SINS_OK && written == 1);
    FRAME_CHECK(sins_play_snapshot_save(play, snapshot, sizeof snapshot, &written) == SINS_OK);
}

/* An ensemble with every effect: all calls except for those that create or load one. */
static void fly_ensemble_frames(sins_ensemble *ensemble, sins_scene *scene)
{
    static unsigned char snapshot[SCENE_RUNS * SINS_SNAPSHOT_MAX_SIZE];
    static sins_statistics statistics, sum;
    sins_figures figures = {.struct_size = sizeof figures};
    sins_verdict verdict = {.struct_size = sizeof verdict};
    sins_navigation navigation = {.struct_size = sizeof navigation};
    sins_imu imu = {.struct_size = sizeof imu};
    sins_correction correction = {.struct_size = sizeof correction, .position_enu_m = {1.0}};
    sins_compensation compensation = {.struct_size = sizeof compensation};
    sins_errors errors = {.struct_size = sizeof errors}, all[SCENE_RUNS] = {{.struct_size = sizeof errors}};
    sins_failure stuck = {.struct_size = sizeof stuck, .kind = SINS_FAILURE_STUCK};
    uint64_t run;
    size_t runs, size, written;
    int k;
    SINS_INIT(statistics);
    SINS_INIT(sum);
    FRAME_CHECK(sins_ensemble_get_statistics(ensemble, SINS_ERRORS_NAVIGATION, &statistics) == SINS_NEED_SAMPLE);
    FRAME_CHECK(sins_ensemble_get_runs(ensemble, &run, &runs) == SINS_OK && runs == SCENE_RUNS);
    for (k = 0; k < 65; k++) {
        sins_flight_sample sample = samples[k];
        FRAME_CHECK(sins_scene_prepare_ensemble(scene, ensemble, 0.0, &sample) == SINS_OK);
        FRAME_CHECK(sins_ensemble_push_sample(ensemble, &sample) == SINS_OK);
        FRAME_CHECK(sins_ensemble_push_sample(ensemble, &sample) == SINS_ERROR_TIME_ORDER);
        FRAME_CHECK(sins_ensemble_step(ensemble) == (k == 0 ? SINS_NEED_SAMPLE : SINS_OK));
        FRAME_CHECK(sins_ensemble_get_truth(ensemble, &navigation) == SINS_OK);
        FRAME_CHECK(sins_ensemble_get_navigation(ensemble, run, &navigation) == SINS_OK);
        FRAME_CHECK(is_answer(sins_ensemble_get_imu(ensemble, run + 1, &imu), k > 0));
        FRAME_CHECK(sins_ensemble_correct(ensemble, run, &correction) == (k > 0 ? SINS_OK : SINS_ERROR_BAD_STATE));
        FRAME_CHECK(sins_ensemble_get_compensation(ensemble, run, &compensation) == SINS_OK);
        FRAME_CHECK(sins_ensemble_get_errors(ensemble, run + 2, SINS_ERRORS_MODEL, &errors) == SINS_OK);
        FRAME_CHECK(sins_ensemble_get_all_errors(ensemble, SINS_ERRORS_MODEL, all, SCENE_RUNS) == SINS_OK);
        FRAME_CHECK(sins_ensemble_get_errors(ensemble, run + 3, SINS_ERRORS_MODEL, &errors)
                    == SINS_ERROR_INVALID_ARGUMENT);
        FRAME_CHECK(sins_ensemble_get_diverged(ensemble, 0, &run) == SINS_ERROR_INVALID_ARGUMENT);
        FRAME_CHECK(sins_ensemble_get_statistics(ensemble, SINS_ERRORS_NAVIGATION, &statistics) == SINS_OK);
        FRAME_CHECK(sins_statistics_add(&statistics, &errors) == SINS_OK);
        FRAME_CHECK(sins_statistics_merge(&sum, &statistics) == SINS_OK);
        FRAME_CHECK(sins_statistics_figures(&sum, &figures) == SINS_OK);
        FRAME_CHECK(sins_meets(&sum, 1.0, 95.0, &verdict) == SINS_OK);
    }
    FRAME_CHECK(sins_ensemble_set_failure(ensemble, SINS_SENSOR_ACCEL, 1, &stuck) == SINS_OK);
    FRAME_CHECK(sins_ensemble_run(ensemble, &samples[k], 64) == SINS_OK);
    FRAME_CHECK(sins_ensemble_snapshot_size(ensemble, &size) == SINS_OK);
    FRAME_CHECK(sins_ensemble_snapshot_save(ensemble, snapshot, sizeof snapshot, &written) == SINS_OK && size == written);
    FRAME_CHECK(sins_ensemble_reposition(ensemble, &samples[0]) == SINS_OK);
    FRAME_CHECK(sins_ensemble_reset(ensemble) == SINS_OK);
}

/* A unit through all its modes: all calls except for those that create or destroy one. */
static void fly_unit_frames(sins_sim *sim, sins_unit *unit)
{
    unsigned char snapshot[SINS_UNIT_SNAPSHOT_MAX_SIZE];
    sins_unit_params params = {.struct_size = sizeof params};
    sins_unit_status status = {.struct_size = sizeof status};
    sins_unit_navigation navigation = {.struct_size = sizeof navigation};
    sins_unit_fix fix = {.struct_size = sizeof fix};
    sins_bus_word words[64] = {{.struct_size = sizeof words[0]}};
    sins_bus_label label = {.struct_size = sizeof label};
    sins_status answer;
    size_t size;
    int k;
    FRAME_CHECK(sins_unit_get_params(unit, &params) == SINS_OK);
    params.power_up_test_s = params.power_down_s = params.erection_s = params.realignment_s = 0.05;
    params.alignment_s = 0.2;
    FRAME_CHECK(sins_unit_set_params(unit, &params) == SINS_OK);
    FRAME_CHECK(sins_unit_set_stored(unit, 0.7, 2.0, 0.0) == SINS_OK);
    FRAME_CHECK(sins_unit_set_power(unit, SINS_UNIT_POWER_BATTERY) == SINS_OK);
    FRAME_CHECK(sins_unit_press_test(unit) == SINS_OK);
    for (k = 0; k < SCENE_COUNT; k++) {
        FRAME_CHECK(sins_push_sample(sim, &samples[k]) == SINS_OK);
        FRAME_CHECK(sins_unit_select(unit, k / 100 % 4) == SINS_OK);
        FRAME_CHECK(sins_unit_set_alignment(unit, k / 256) == SINS_OK);
        if (sins_step(sim) == SINS_OK) {
            FRAME_CHECK(sins_unit_update(unit, sim) == SINS_OK);
            fix.latitude_rad = samples[k].latitude_rad;
            fix.longitude_rad = samples[k].longitude_rad;
            fix.height_m = samples[k].height_m;
            memcpy(fix.velocity_enu_m_s, samples[k].velocity_enu_m_s, sizeof fix.velocity_enu_m_s);
            FRAME_CHECK(sins_unit_push_fix(unit, sim, &fix) == SINS_OK);
        }
        answer = sins_unit_enter_position(unit, samples[k].latitude_rad, samples[k].longitude_rad);
        FRAME_CHECK(answer == SINS_OK || answer == SINS_ERROR_BAD_STATE);
        answer = sins_unit_enter_heading(unit, 0.0);
        FRAME_CHECK(answer == SINS_OK || answer == SINS_ERROR_BAD_STATE);
        FRAME_CHECK(sins_unit_get_status(unit, &status) == SINS_OK);
        FRAME_CHECK(sins_unit_get_navigation(unit, sim, &navigation) == SINS_OK);
        FRAME_CHECK(sins_bus_words(&status, &navigation, NULL, scene_time(k), scene_time(k + 1), words, 64, &size) == SINS_OK);
        FRAME_CHECK(size == 0 || sins_bus_decode(words[0].word, 0, &label) == SINS_OK);
        FRAME_CHECK(sins_bus_get_label(0, &label) == SINS_OK);
        FRAME_CHECK(sins_unit_snapshot_save(unit, snapshot, sizeof snapshot, &size) == SINS_OK);
        FRAME_CHECK(sins_unit_snapshot_load(unit, snapshot, size) == SINS_OK);
    }
}

int main(void)
{
    enum { FRAMES = 2, SCHEMES = 3, VERTICALS = 3, SIGNALS = 2, ALL = FRAMES * SCHEMES * VERTICALS * SIGNALS };
    sins_sim *sims[ALL], *navigators[FRAMES * SCHEMES], *stale = NULL;
    sins_scene *scene = scene_of_text();
    sins_log *log = scene_log();
    sins_ensemble *ensemble = scene_ensemble();
    sins_sim *of_scene = NULL, *of_unit = scene_simulator(NULL, 3);
    sins_unit *unit = scene_unit();
    sins_play *play = scene_play();
    sins_flight *flight = NULL;
    sins_navigation start = {.struct_size = sizeof start};
    pthread_t others[2];
    long allocations;
    int i, navigator_count = 0;

    CHECK(sins_scene_create_simulator(scene, &of_scene) == SINS_OK);
    CHECK(sins_scene_create_flight(scene, &flight) == SINS_OK);
    scene_samples(samples);
    for (i = 0; i < ALL; i++) {
        sins_options options = {.struct_size = sizeof options};
        options.frame = i % FRAMES;
        options.scheme = i / FRAMES % SCHEMES;
        options.vertical = i / (FRAMES * SCHEMES) % VERTICALS;
        options.signal = i / (FRAMES * SCHEMES * VERTICALS);
        options.subsamples = 1 + i % 5;
        options.updates_per_sample = 1 + i % 2;
        options.error_model = SINS_ERROR_MODEL_RK4;
        options.truth_summary = i % 3 ? SINS_SUMMARY_ON : SINS_SUMMARY_OFF;
        options.covariance = i % 2 ? SINS_COVARIANCE_ON : SINS_COVARIANCE_OFF;
        sims[i] = scene_simulator(&options, 0);
        if (i < FRAMES * SCHEMES) {
            sins_gyro_params gyro = scene_gyro(); /* the accelerometers have no limit of their range */
            sins_sim *navigator = NULL;
            CHECK(sins_create(&options, &navigator) == SINS_OK);
            CHECK(sins_set_gyro(navigator, &gyro) == SINS_OK);
            start.quaternion_nb[0] = 1.0;
            CHECK(sins_start_navigation(navigator, &start) == SINS_OK);
            navigators[navigator_count++] = navigator;
        }
    }
    /* The table of handles has 4096 places, which are used in turn: a handle of the busy thread gets the place of the stale one. */
    for (i = 0; i < 4096; i++) {
        sins_sim *sim = NULL;
        CHECK(sins_create(NULL, &sim) == SINS_OK && sins_destroy(sim) == SINS_OK);
        stale = i == 0 ? sim : stale;
    }
    CHECK(pthread_create(&others[0], NULL, fly_all_the_time, scene_simulator(NULL, 9)) == 0);
    CHECK(pthread_create(&others[1], NULL, create_and_destroy_all_the_time, NULL) == 0);

    /* Printed now, because printing is forbidden later. */
    printf("real_time: %d simulators and %d navigators under a ban on system calls\n", ALL, navigator_count);
    fflush(stdout);
    forbid_system_calls();
    allocations = allocator_calls;
    for (i = 0; i < ALL; i++) {
        fly_frames(sims[i], stale);
    }
    fly_scene_frames(scene, of_scene, flight, log);
    fly_play_frames(play, flight);
    fly_ensemble_frames(ensemble, scene);
    fly_unit_frames(of_unit, unit);
    for (i = 0; i < navigator_count; i++) {
        navigate_frames(navigators[i]);
    }
    FRAME_CHECK(allocator_calls == allocations);
    over = 1;
    syscall(SYS_exit_group, 0);
    return 1;
}
