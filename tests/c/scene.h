/* A flight with many manoeuvres and a simulator with every effect on, for tests that need any flight. */

#ifndef SCENE_H
#define SCENE_H

#include "check.h"
#include "sins_analysis.h"
#include "sins_scene.h"

/* 8 s at 128 Hz: times that are exact in binary. */
enum { SCENE_COUNT = 1025 };

static inline double scene_time(int k)
{
    return k / 128.0;
}

/* A roll, a loop, a steep turn. */
static inline sins_flight *scene_flight(void)
{
    sins_flight_start start = {.struct_size = sizeof start};
    sins_manoeuvre manoeuvres[3] = {{.struct_size = sizeof manoeuvres[0]}};
    sins_flight *flight = NULL;
    start.latitude_rad = 0.7;
    start.longitude_rad = 2.0;
    start.height_m = 3000.0;
    start.speed_m_s = 150.0;
    manoeuvres[0].kind = SINS_MANOEUVRE_ROLL;
    manoeuvres[0].duration_s = 2.0;
    manoeuvres[0].turns = 1.0;
    manoeuvres[1].kind = SINS_MANOEUVRE_TURN;
    manoeuvres[1].heading_change_rad = 0.8;
    manoeuvres[1].bank_rad = 1.2;
    manoeuvres[1].ramp_s = 0.5;
    manoeuvres[2].kind = SINS_MANOEUVRE_LOOP;
    manoeuvres[2].duration_s = 20.0;
    manoeuvres[2].turns = 1.0;
    manoeuvres[2].ramp_s = 1.0;
    CHECK(sins_flight_create(&start, manoeuvres, 3, &flight) == SINS_OK);
    return flight;
}

static inline void scene_samples(sins_flight_sample samples[SCENE_COUNT])
{
    sins_flight *flight = scene_flight();
    int k;
    for (k = 0; k < SCENE_COUNT; k++) {
        samples[k].struct_size = sizeof samples[k];
        CHECK(sins_flight_sample_at(flight, scene_time(k), &samples[k]) == SINS_OK);
    }
    CHECK(sins_flight_destroy(flight) == SINS_OK);
}

static inline sins_gyro_params scene_gyro(void)
{
    sins_gyro_params gyro = {.struct_size = sizeof gyro};
    int axis;
    for (axis = 0; axis < 3; axis++) {
        gyro.bias_rad_s[axis] = 1e-6;
        gyro.bias_sigma_rad_s[axis] = 1e-6;
        gyro.markov_sigma_rad_s[axis] = 1e-6;
        gyro.markov_time_s[axis] = 10.0;
        gyro.random_walk_rad_sqrt_s[axis] = 1e-5;
        gyro.rate_random_walk_rad_s_sqrt_s[axis] = 1e-7;
        gyro.rate_ramp_rad_s2[axis] = 1e-8;
        gyro.flicker_rad_s[axis] = 1e-6;
        gyro.quantization_rad[axis] = 1e-6;
        gyro.scale_factor[axis] = 1e-4;
        gyro.scale_factor_asymmetry[axis] = 1e-5;
        gyro.scale_factor_nonlinearity_s_rad[axis] = 1e-5;
        gyro.misalignment_rad[3 * axis + (axis + 1) % 3] = 1e-4;
        gyro.g_sensitivity_rad_s_per_m_s2[4 * axis] = 1e-7;
        gyro.range_rad_s[axis] = 3.0;
        gyro.bandwidth_hz[axis] = 40.0;
        gyro.dead_zone_rad_s[axis] = 1e-6;
    }
    return gyro;
}

static inline sins_accel_params scene_accel(void)
{
    sins_accel_params accel = {.struct_size = sizeof accel};
    int axis;
    for (axis = 0; axis < 3; axis++) {
        accel.bias_m_s2[axis] = 1e-3;
        accel.bias_sigma_m_s2[axis] = 1e-3;
        accel.markov_sigma_m_s2[axis] = 1e-3;
        accel.markov_time_s[axis] = 10.0;
        accel.velocity_random_walk_m_s_sqrt_s[axis] = 1e-3;
        accel.acceleration_random_walk_m_s2_sqrt_s[axis] = 1e-4;
        accel.ramp_m_s3[axis] = 1e-5;
        accel.flicker_m_s2[axis] = 1e-3;
        accel.quantization_m_s[axis] = 1e-4;
        accel.scale_factor[axis] = 1e-4;
        accel.scale_factor_asymmetry[axis] = 1e-5;
        accel.scale_factor_nonlinearity_s2_m[axis] = 1e-6;
        accel.misalignment_rad[3 * axis + (axis + 1) % 3] = 1e-4;
        accel.range_m_s2[axis] = 25.0;
        accel.bandwidth_hz[axis] = 40.0;
        accel.dead_zone_m_s2[axis] = 1e-4;
        accel.lever_arm_m[4 * axis] = 0.1;
        accel.vibration_rectification_s2_m[axis] = 1e-6;
    }
    return accel;
}

static inline sins_altimeter_params scene_altimeter(void)
{
    sins_altimeter_params altimeter = {.struct_size = sizeof altimeter};
    altimeter.bias_m = 3.0;
    altimeter.markov_sigma_m = 2.0;
    altimeter.markov_time_s = 30.0;
    altimeter.noise_m = 1.0;
    altimeter.scale_factor = 1e-3;
    altimeter.lag_s = 0.5;
    return altimeter;
}

static inline sins_initial_errors scene_initial_errors(void)
{
    sins_initial_errors initial = {.struct_size = sizeof initial};
    int axis;
    for (axis = 0; axis < 3; axis++) {
        initial.position_enu_m[axis] = 10.0;
        initial.position_sigma_enu_m[axis] = 5.0;
        initial.velocity_sigma_enu_m_s[axis] = 0.1;
        initial.misalignment_sigma_enu_rad[axis] = 1e-3;
    }
    return initial;
}

/* `options` may be NULL: then both error data, and draws with `seed`. */
static inline sins_sim *scene_simulator(const sins_options *options, unsigned seed)
{
    sins_options own = {.struct_size = sizeof own};
    sins_gyro_params gyro = scene_gyro();
    sins_accel_params accel = scene_accel();
    sins_altimeter_params altimeter = scene_altimeter();
    sins_initial_errors initial = scene_initial_errors();
    sins_sim *sim = NULL;
    own.error_model = SINS_ERROR_MODEL_RK4;
    own.truth_summary = SINS_SUMMARY_ON;
    own.covariance = SINS_COVARIANCE_ON;
    own.seed = seed;
    CHECK(sins_create(options ? options : &own, &sim) == SINS_OK);
    CHECK(sins_set_gyro(sim, &gyro) == SINS_OK);
    CHECK(sins_set_accel(sim, &accel) == SINS_OK);
    CHECK(sins_set_altimeter(sim, &altimeter) == SINS_OK);
    CHECK(sins_set_initial_errors(sim, &initial) == SINS_OK);
    return sim;
}

/* Three runs of the simulator, from number 7. */
enum { SCENE_FIRST_RUN = 7, SCENE_RUNS = 3 };

static inline sins_ensemble *scene_ensemble(void)
{
    sins_sim *sim = scene_simulator(NULL, 5);
    sins_ensemble *ensemble = NULL;
    CHECK(sins_ensemble_create(sim, SCENE_FIRST_RUN, SCENE_RUNS, &ensemble) == SINS_OK);
    CHECK(sins_destroy(sim) == SINS_OK);
    return ensemble;
}

static inline sins_unit *scene_unit(void)
{
    sins_unit *unit = NULL;
    CHECK(sins_unit_create(NULL, SINS_UNIT_NAV, &unit) == SINS_OK);
    return unit;
}

/* A judge that has found one thing: a time stamp that is not later than the one before. */
static inline sins_judge *scene_judge(void)
{
    sins_flight_sample sample = {.struct_size = sizeof sample};
    sins_judge *judge = NULL;
    CHECK(sins_judge_create(NULL, &judge) == SINS_OK);
    CHECK(sins_judge_push(judge, &sample) == SINS_OK && sins_judge_push(judge, &sample) == SINS_OK);
    return judge;
}

/* What the sensors of a simulator measured in its last interval, on a clock that is behind. */
static inline sins_recorded_increment scene_increment(sins_sim *sim, double behind_s)
{
    sins_recorded_increment increment = {.struct_size = sizeof increment};
    sins_imu imu = {.struct_size = sizeof imu};
    int k;
    CHECK(sins_get_imu(sim, &imu) == SINS_OK);
    increment.time_s = imu.time_s - behind_s;
    increment.interval_s = imu.interval_s;
    for (k = 0; k < 3; k++) {
        increment.angle_rad[k] = imu.measured_angle_rad[k];
        increment.velocity_m_s[k] = imu.measured_velocity_m_s[k];
    }
    return increment;
}

/* A minute at rest, which ends before time 0, with sensors that have white noise; solved and checked. The times are exact, so that the
 * program raises no floating-point flag. */
static inline sins_identify *scene_identify_of(int32_t prior)
{
    sins_flight_sample sample = {.struct_size = sizeof sample, .latitude_rad = 0.7};
    sins_recorded_increment increment;
    sins_gyro_params gyro = {.struct_size = sizeof gyro};
    sins_accel_params accel = {.struct_size = sizeof accel};
    sins_identify_request request = {.struct_size = sizeof request, .flags = SINS_IDENTIFY_STATES, .prior = prior};
    sins_identify_check_request of_check = {.struct_size = sizeof of_check, .twins = 40};
    sins_sim *sim = NULL;
    sins_identify *identify = NULL;
    int k;
    for (k = 0; k < 3; k++) {
        gyro.random_walk_rad_sqrt_s[k] = 1e-5;
        accel.velocity_random_walk_m_s_sqrt_s[k] = 1e-3;
    }
    CHECK(sins_create(NULL, &sim) == SINS_OK && sins_set_gyro(sim, &gyro) == SINS_OK && sins_set_accel(sim, &accel) == SINS_OK);
    CHECK(sins_identify_create(NULL, &request, &identify) == SINS_OK);
    for (k = -500; k < 0; k++) {
        sample.time_s = 0.125 * k;
        CHECK(sins_push_sample(sim, &sample) == SINS_OK && sins_identify_push_samples(identify, &sample, 1) == SINS_OK);
        if (sins_step(sim) == SINS_OK) {
            increment = scene_increment(sim, 0.0);
            CHECK(sins_identify_push_increments(identify, &increment, 1) == SINS_OK);
        }
    }
    CHECK(sins_identify_check(identify, &of_check, NULL) == SINS_OK);
    CHECK(sins_identify_solve(identify, NULL) == SINS_OK);
    CHECK(sins_destroy(sim) == SINS_OK);
    return identify;
}

static inline sins_identify *scene_identify(void)
{
    return scene_identify_of(0);
}

/* A record of every interval. */
static inline void scene_fly(sins_sim *sim, const sins_flight_sample *samples, sins_record records[SCENE_COUNT - 1])
{
    size_t written = 0;
    records[0].struct_size = sizeof records[0];
    CHECK(sins_run(sim, samples, SCENE_COUNT, 1, records, SCENE_COUNT - 1, &written) == SINS_OK);
    CHECK(written == SCENE_COUNT - 1);
}

/* A scene with manoeuvres, errors, a failure and updates, and a flight log. */
static const char scene_text[] =
    "[flight]\ntitle = \"a turn\"\nlatitude_deg = 40\nheight_m = 3000\nspeed_m_s = 150\nrate_hz = 128\ntemperature_c = 20\n"
    "[[manoeuvre]]\nkind = \"turn\"\nheading_change_deg = 90\nbank_deg = 30\n"
    "[[manoeuvre]]\nkind = \"sinusoids\"\nduration_s = 60\n[[manoeuvre.sinusoid]]\nchannel = \"course\"\n"
    "amplitude_deg = 5\nfrequency_hz = 0.1\n"
    "[options]\nscheme = \"polynomial\"\n[gyro]\npreset = \"tactical\"\nbias_deg_h = [0.1, -0.2, 0.3]\n"
    "[[failure]]\nsensor = \"gyro\"\naxis = \"z\"\nkind = \"stuck\"\nfrom_s = 0.25\nuntil_s = 0.5\n"
    "[[update]]\nkind = \"position\"\nat_s = 0.125\nevery_s = 0.25\nsigma_m = 10\n";
static const char scene_log_text[] =
    "# at rest\ntime_s,latitude_deg,longitude_deg,height_m,roll_deg,pitch_deg,heading_deg,temperature_c\n"
    "0,40,10,100,0,1,90,20\n0.01,40,10,100,0,1,90,20\n0.02,40,10,100,0,1,90,20\n";

static inline sins_scene *scene_of_text(void)
{
    sins_scene *scene = NULL;
    CHECK(sins_scene_parse(scene_text, sizeof scene_text - 1, &scene) == SINS_OK);
    return scene;
}

/* The same with a unit that aligns. */
static inline sins_play *scene_play(void)
{
    sins_scene *scene = scene_of_text();
    sins_play *play = NULL;
    CHECK(sins_scene_set_values(scene, "unit.start = \"off\"") == SINS_OK);
    CHECK(sins_scene_set_items(scene, "panel", "[[panel]]\nkind = \"align\"\nat_s = 0.1\n") == SINS_OK);
    CHECK(sins_play_create(scene, NULL, &play) == SINS_OK && sins_scene_destroy(scene) == SINS_OK);
    return play;
}

static inline sins_log *scene_log(void)
{
    sins_log *log = NULL;
    CHECK(sins_log_parse(scene_log_text, sizeof scene_log_text - 1, NULL, &log, NULL) == SINS_OK);
    return log;
}

enum { SCENE_BUDGET_ROWS = 3 };

/* The budget of a bias and of a random noise in a flight of these samples. */
static inline sins_status scene_budget(const sins_flight_sample *samples, size_t count,
                                       sins_budget_row rows[SCENE_BUDGET_ROWS], sins_budget *budget)
{
    sins_gyro_params gyro = {.struct_size = sizeof gyro};
    sins_budget_request request = {.struct_size = sizeof request, .runs = 8, .position_m = 1.0};
    sins_sim *sim = NULL;
    sins_status status;
    gyro.bias_rad_s[0] = 1e-6;
    gyro.random_walk_rad_sqrt_s[1] = 1e-5;
    rows[0].struct_size = sizeof rows[0];
    budget->struct_size = sizeof *budget;
    status = sins_create(NULL, &sim);
    if (status == SINS_OK) {
        CHECK(sins_set_gyro(sim, &gyro) == SINS_OK);
        status = sins_error_budget(sim, samples, count, &request, rows, SCENE_BUDGET_ROWS, NULL, budget);
        CHECK(sins_destroy(sim) == SINS_OK);
    }
    return status;
}

#endif
