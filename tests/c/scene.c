/* Scene files and the command line into settings: each key in SI, shapes, presets, manoeuvres; the reader of TOML by
 * itself. */

#include <stdint.h>
#include <string.h>

#include "../../c_examples/harness/command_line.h"
#include "../../c_examples/harness/nearest.h"
#include "../../c_examples/harness/option_table.h"
#include "../../c_examples/harness/scene_file.h"
#include "check.h"

#define PI 3.14159265358979323846
#define G 9.80665

static struct settings set;

/* Reads a scene in settings without presets. 0 if it is taken. */
static int read(const char *text)
{
    const int32_t ideal[2] = { 0, 0 };

    CHECK(settings_begin(&set, ideal) == 0);
    strcpy(set.scene_file, "scene.toml");
    return scene_file_apply(&set, text, strlen(text));
}

#define REST "[[manoeuvre]]\nkind = \"rest\"\nduration_s = 1\n"

static void take(const char *text)
{
    char scene[1024];

    snprintf(scene, sizeof scene, REST "%s", text);
    CHECK(read(scene) == 0);
}

struct in_si {
    enum option_group group;
    const char *key;
    const double *place;
    size_t count;
    double si; /* of 1 in the key's unit */
};

/* What each key means, told anew. */
static const struct in_si keys_in_si[] = {
    { GROUP_FLIGHT, "hours", &set.hours, 1, 1 },
    { GROUP_FLIGHT, "rate_hz", &set.rate_hz, 1, 1 },
    { GROUP_FLIGHT, "temperature_c", &set.temperature_c, 1, 1 },
    { GROUP_FLIGHT, "temperature_change_c_h", &set.temperature_change_c_h, 1, 1 },
    { GROUP_FLIGHT, "latitude_deg", &set.start.latitude_rad, 1, PI / 180 },
    { GROUP_FLIGHT, "longitude_deg", &set.start.longitude_rad, 1, PI / 180 },
    { GROUP_FLIGHT, "height_m", &set.start.height_m, 1, 1 },
    { GROUP_FLIGHT, "speed_m_s", &set.start.speed_m_s, 1, 1 },
    { GROUP_FLIGHT, "heading_deg", &set.start.heading_rad, 1, PI / 180 },
    { GROUP_FLIGHT, "roll_deg", &set.start.roll_rad, 1, PI / 180 },
    { GROUP_FLIGHT, "pitch_deg", &set.start.pitch_rad, 1, PI / 180 },
    { GROUP_MODEL, "closed_loop_time_s", &set.options.closed_loop_time_s, 1, 1 },
    { GROUP_MODEL, "sample_period_s", &set.options.sample_period_s, 1, 1 },
    { GROUP_MODEL, "max_gap_s", &set.options.max_gap_s, 1, 1 },
    { GROUP_MODEL, "max_acceleration_m_s2", &set.options.max_acceleration_m_s2, 1, 1 },
    { GROUP_GYRO, "bias_deg_h", set.gyro.bias_rad_s, 3, PI / 180 / 3600 },
    { GROUP_GYRO, "bias_sigma_deg_h", set.gyro.bias_sigma_rad_s, 3, PI / 180 / 3600 },
    { GROUP_GYRO, "markov_sigma_deg_h", set.gyro.markov_sigma_rad_s, 3, PI / 180 / 3600 },
    { GROUP_GYRO, "markov_time_s", set.gyro.markov_time_s, 3, 1 },
    { GROUP_GYRO, "random_walk_deg_sqrt_h", set.gyro.random_walk_rad_sqrt_s, 3, PI / 180 / 60 },
    { GROUP_GYRO, "rate_random_walk_deg_h_sqrt_h", set.gyro.rate_random_walk_rad_s_sqrt_s, 3, PI / 180 / 3600 / 60 },
    { GROUP_GYRO, "rate_ramp_deg_h2", set.gyro.rate_ramp_rad_s2, 3, PI / 180 / 3600 / 3600 },
    { GROUP_GYRO, "flicker_deg_h", set.gyro.flicker_rad_s, 3, PI / 180 / 3600 },
    { GROUP_GYRO, "quantization_arcsec", set.gyro.quantization_rad, 3, PI / 648000 },
    { GROUP_GYRO, "scale_factor_ppm", set.gyro.scale_factor, 3, 1e-6 },
    { GROUP_GYRO, "scale_factor_asymmetry_ppm", set.gyro.scale_factor_asymmetry, 3, 1e-6 },
    { GROUP_GYRO, "scale_factor_nonlinearity_ppm_per_deg_s", set.gyro.scale_factor_nonlinearity_s_rad, 3,
      1e-6 * 180 / PI },
    { GROUP_GYRO, "misalignment_arcsec", set.gyro.misalignment_rad, 9, PI / 648000 },
    { GROUP_GYRO, "g_sensitivity_deg_h_per_g", set.gyro.g_sensitivity_rad_s_per_m_s2, 9, PI / 180 / 3600 / G },
    { GROUP_GYRO, "range_deg_s", set.gyro.range_rad_s, 3, PI / 180 },
    { GROUP_GYRO, "bandwidth_hz", set.gyro.bandwidth_hz, 3, 1 },
    { GROUP_GYRO, "dead_zone_deg_h", set.gyro.dead_zone_rad_s, 3, PI / 180 / 3600 },
    { GROUP_GYRO, "reference_temperature_c", &set.gyro.reference_temperature_c, 1, 1 },
    { GROUP_GYRO, "bias_temperature_deg_h_per_k", set.gyro.bias_temperature_rad_s_per_k, 3, PI / 180 / 3600 },
    { GROUP_GYRO, "bias_temperature2_deg_h_per_k2", set.gyro.bias_temperature2_rad_s_per_k2, 3, PI / 180 / 3600 },
    { GROUP_GYRO, "scale_factor_temperature_ppm_per_k", set.gyro.scale_factor_temperature_per_k, 3, 1e-6 },
    { GROUP_GYRO, "scale_factor_temperature2_ppm_per_k2", set.gyro.scale_factor_temperature2_per_k2, 3, 1e-6 },
    { GROUP_GYRO, "scale_factor_sigma_ppm", set.gyro.scale_factor_sigma, 3, 1e-6 },
    { GROUP_GYRO, "misalignment_sigma_arcsec", set.gyro.misalignment_sigma_rad, 9, PI / 648000 },
    { GROUP_ACCEL, "bias_micro_g", set.accel.bias_m_s2, 3, 1e-6 * G },
    { GROUP_ACCEL, "bias_sigma_micro_g", set.accel.bias_sigma_m_s2, 3, 1e-6 * G },
    { GROUP_ACCEL, "markov_sigma_micro_g", set.accel.markov_sigma_m_s2, 3, 1e-6 * G },
    { GROUP_ACCEL, "markov_time_s", set.accel.markov_time_s, 3, 1 },
    { GROUP_ACCEL, "random_walk_micro_g_sqrt_hz", set.accel.velocity_random_walk_m_s_sqrt_s, 3, 1e-6 * G },
    { GROUP_ACCEL, "acceleration_random_walk_micro_g_sqrt_h", set.accel.acceleration_random_walk_m_s2_sqrt_s, 3,
      1e-6 * G / 60 },
    { GROUP_ACCEL, "ramp_micro_g_h", set.accel.ramp_m_s3, 3, 1e-6 * G / 3600 },
    { GROUP_ACCEL, "flicker_micro_g", set.accel.flicker_m_s2, 3, 1e-6 * G },
    { GROUP_ACCEL, "quantization_mm_s", set.accel.quantization_m_s, 3, 1e-3 },
    { GROUP_ACCEL, "scale_factor_ppm", set.accel.scale_factor, 3, 1e-6 },
    { GROUP_ACCEL, "scale_factor_asymmetry_ppm", set.accel.scale_factor_asymmetry, 3, 1e-6 },
    { GROUP_ACCEL, "scale_factor_nonlinearity_ppm_per_g", set.accel.scale_factor_nonlinearity_s2_m, 3, 1e-6 / G },
    { GROUP_ACCEL, "misalignment_arcsec", set.accel.misalignment_rad, 9, PI / 648000 },
    { GROUP_ACCEL, "range_g", set.accel.range_m_s2, 3, G },
    { GROUP_ACCEL, "bandwidth_hz", set.accel.bandwidth_hz, 3, 1 },
    { GROUP_ACCEL, "dead_zone_micro_g", set.accel.dead_zone_m_s2, 3, 1e-6 * G },
    { GROUP_ACCEL, "lever_arm_mm", set.accel.lever_arm_m, 9, 1e-3 },
    { GROUP_ACCEL, "vibration_rectification_micro_g_per_g2", set.accel.vibration_rectification_s2_m, 3, 1e-6 / G },
    { GROUP_ACCEL, "reference_temperature_c", &set.accel.reference_temperature_c, 1, 1 },
    { GROUP_ACCEL, "bias_temperature_micro_g_per_k", set.accel.bias_temperature_m_s2_per_k, 3, 1e-6 * G },
    { GROUP_ACCEL, "bias_temperature2_micro_g_per_k2", set.accel.bias_temperature2_m_s2_per_k2, 3, 1e-6 * G },
    { GROUP_ACCEL, "scale_factor_temperature_ppm_per_k", set.accel.scale_factor_temperature_per_k, 3, 1e-6 },
    { GROUP_ACCEL, "scale_factor_temperature2_ppm_per_k2", set.accel.scale_factor_temperature2_per_k2, 3, 1e-6 },
    { GROUP_ACCEL, "scale_factor_sigma_ppm", set.accel.scale_factor_sigma, 3, 1e-6 },
    { GROUP_ACCEL, "misalignment_sigma_arcsec", set.accel.misalignment_sigma_rad, 9, PI / 648000 },
    { GROUP_ALTIMETER, "bias_m", &set.altimeter.bias_m, 1, 1 },
    { GROUP_ALTIMETER, "noise_m", &set.altimeter.noise_m, 1, 1 },
    { GROUP_ALTIMETER, "markov_sigma_m", &set.altimeter.markov_sigma_m, 1, 1 },
    { GROUP_ALTIMETER, "markov_time_s", &set.altimeter.markov_time_s, 1, 1 },
    { GROUP_ALTIMETER, "scale_factor_ppm", &set.altimeter.scale_factor, 1, 1e-6 },
    { GROUP_ALTIMETER, "lag_s", &set.altimeter.lag_s, 1, 1 },
    { GROUP_START, "position_m", set.initial.position_enu_m, 3, 1 },
    { GROUP_START, "velocity_m_s", set.initial.velocity_enu_m_s, 3, 1 },
    { GROUP_START, "misalignment_arcmin", set.initial.misalignment_enu_rad, 3, PI / 10800 },
    { GROUP_START, "position_sigma_m", set.initial.position_sigma_enu_m, 3, 1 },
    { GROUP_START, "velocity_sigma_m_s", set.initial.velocity_sigma_enu_m_s, 3, 1 },
    { GROUP_START, "misalignment_sigma_arcmin", set.initial.misalignment_sigma_enu_rad, 3, PI / 10800 },
    { GROUP_MOUNTING, "lever_arm_m", set.mounting.lever_arm_m, 3, 1 },
    { GROUP_MOUNTING, "boresight_deg", set.mounting.boresight_rad, 3, PI / 180 },
    { GROUP_MOUNTING, "lever_arm_error_mm", set.mounting.lever_arm_error_m, 3, 1e-3 },
    { GROUP_MOUNTING, "boresight_error_arcsec", set.mounting.boresight_error_rad, 3, PI / 648000 },
    { GROUP_GRAVITY, "deflection_north_arcsec", &set.gravity.deflection_north_rad, 1, PI / 648000 },
    { GROUP_GRAVITY, "deflection_north_sigma_arcsec", &set.gravity.deflection_north_sigma_rad, 1, PI / 648000 },
    { GROUP_GRAVITY, "deflection_north_distance_km", &set.gravity.deflection_north_distance_m, 1, 1e3 },
    { GROUP_GRAVITY, "deflection_east_arcsec", &set.gravity.deflection_east_rad, 1, PI / 648000 },
    { GROUP_GRAVITY, "deflection_east_sigma_arcsec", &set.gravity.deflection_east_sigma_rad, 1, PI / 648000 },
    { GROUP_GRAVITY, "deflection_east_distance_km", &set.gravity.deflection_east_distance_m, 1, 1e3 },
    { GROUP_GRAVITY, "anomaly_mgal", &set.gravity.anomaly_m_s2, 1, 1e-5 },
    { GROUP_GRAVITY, "anomaly_sigma_mgal", &set.gravity.anomaly_sigma_m_s2, 1, 1e-5 },
    { GROUP_GRAVITY, "anomaly_distance_km", &set.gravity.anomaly_distance_m, 1, 1e3 },
    { GROUP_OUTPUT, "every_s", &set.every_s, 1, 1 }
};

enum { KEYS_IN_SI = sizeof keys_in_si / sizeof keys_in_si[0] };

/* Both are products of a few factors: equal to a few roundings. */
static int is_near(double value, double expected)
{
    return value >= expected * (1 - 1e-15) && value <= expected * (1 + 1e-15);
}

/* A different number for each element: none can stand in another's place. */
static void every_number_arrives_in_si(void)
{
    static const char *const values[] = { "", "1", "", "[1, 2, 3]", "", "", "", "", "", "[1, 2, 3, 4, 5, 6, 7, 8, 9]" };
    size_t k, i, numbers = 0;

    for (k = 0; k < KEYS_IN_SI; k++) {
        const struct in_si *key = &keys_in_si[k];
        char text[256];

        snprintf(text, sizeof text, "[%s]\n%s = %s\n", option_sections[key->group].name, key->key, values[key->count]);
        take(text);
        for (i = 0; i < key->count; i++) {
            CHECK(is_near(key->place[i], (double)(i + 1) * key->si));
        }
    }
    for (i = 0; i < option_table_length; i++) {
        const struct option *option = &option_table[i];

        numbers += option->key != NULL && option_shape(option).count > 0 && !option_sections[option->group].is_array;
    }
    CHECK(numbers == KEYS_IN_SI);
}

static void a_single_number_stands_for_all(void)
{
    size_t i;

    take("[gyro]\nbandwidth_hz = 2\nmarkov_time_s = 3.5\ng_sensitivity_deg_h_per_g = 1\nmisalignment_arcsec = 1\n");
    for (i = 0; i < 3; i++) {
        CHECK(set.gyro.bandwidth_hz[i] == 2 && set.gyro.markov_time_s[i] == 3.5);
    }
    for (i = 0; i < 9; i++) {
        CHECK((set.gyro.g_sensitivity_rad_s_per_m_s2[i] != 0) == (i % 4 == 0));
        CHECK((set.gyro.misalignment_rad[i] != 0) == (i % 4 != 0));
    }
    CHECK(read(REST "[accelerometer]\nlever_arm_mm = 1\n") != 0);
    CHECK(read(REST "[start]\nposition_m = 1\n") != 0);
}

struct word {
    const char *section, *key, *word;
    const int32_t *place;
    int32_t constant;
};

static void every_word_is_its_constant(void)
{
    static const struct word words[] = {
        { "options", "scheme", "exact", &set.options.scheme, SINS_SCHEME_EXACT },
        { "options", "scheme", "paper", &set.options.scheme, SINS_SCHEME_PAPER },
        { "options", "scheme", "polynomial", &set.options.scheme, SINS_SCHEME_POLYNOMIAL },
        { "options", "frame", "earth", &set.options.frame, SINS_FRAME_EARTH_FIXED },
        { "options", "frame", "geographic", &set.options.frame, SINS_FRAME_GEOGRAPHIC },
        { "options", "vertical", "damped", &set.options.vertical, SINS_VERTICAL_DAMPED },
        { "options", "vertical", "follow", &set.options.vertical, SINS_VERTICAL_FOLLOW_TRUTH },
        { "options", "vertical", "free", &set.options.vertical, SINS_VERTICAL_FREE },
        { "options", "error_model", "off", &set.options.error_model, SINS_ERROR_MODEL_OFF },
        { "options", "error_model", "rk4", &set.options.error_model, SINS_ERROR_MODEL_RK4 },
        { "options", "earth", "wgs84", &set.options.earth, SINS_EARTH_WGS84 },
        { "options", "earth", "cgcs2000", &set.options.earth, SINS_EARTH_CGCS2000 },
        { "options", "earth", "grs80", &set.options.earth, SINS_EARTH_GRS80 },
        { "options", "earth", "krassovsky", &set.options.earth, SINS_EARTH_KRASSOVSKY1940 },
        { "options", "gravity", "normal", &set.options.gravity, SINS_GRAVITY_NORMAL },
        { "options", "gravity", "somigliana", &set.options.gravity, SINS_GRAVITY_SOMIGLIANA },
        { "options", "axes", "rfu", &set.options.axes, SINS_AXES_RIGHT_FORWARD_UP },
        { "options", "axes", "frd", &set.options.axes, SINS_AXES_FORWARD_RIGHT_DOWN },
        { "options", "signal", "physical", &set.options.signal, SINS_SIGNAL_PHYSICAL },
        { "options", "signal", "closed-loop", &set.options.signal, SINS_SIGNAL_CLOSED_LOOP },
        { "gyro", "preset", "ideal", &set.grades[0], 0 },
        { "gyro", "preset", "strategic", &set.grades[0], SINS_GRADE_STRATEGIC },
        { "gyro", "preset", "navigation", &set.grades[0], SINS_GRADE_NAVIGATION },
        { "gyro", "preset", "tactical", &set.grades[0], SINS_GRADE_TACTICAL },
        { "gyro", "preset", "industrial", &set.grades[0], SINS_GRADE_INDUSTRIAL },
        { "gyro", "preset", "consumer", &set.grades[0], SINS_GRADE_CONSUMER },
        { "gyro", "preset", "paper2", &set.grades[0], SINS_GRADE_PAPER_SIMULATION2 },
        { "accelerometer", "preset", "consumer", &set.grades[1], SINS_GRADE_CONSUMER },
        { "start", "alignment", "given", &set.initial.alignment, SINS_ALIGNMENT_GIVEN },
        { "start", "alignment", "gyrocompass", &set.initial.alignment, SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS }
    };
    size_t i;

    for (i = 0; i < sizeof words / sizeof words[0]; i++) {
        char text[128];

        snprintf(text, sizeof text, "[%s]\n%s = \"%s\"\n", words[i].section, words[i].key, words[i].word);
        take(text);
        CHECK(*words[i].place == words[i].constant);
    }
    take("[options]\nsubsamples = 3\nupdates_per_sample = 4\nseed = 9223372036854775807\nrun = 12\n"
         "[output]\nquiet = true\nfolder = 'a\\b'\nname = \"caf\\u00e9\"\nimu = \"i.csv\"\n[flight]\ntitle = \"T\"\n");
    CHECK(set.options.subsamples == 3 && set.options.updates_per_sample == 4 && set.quiet == 1);
    CHECK(set.options.seed == INT64_MAX && set.options.run == 12);
    CHECK(strcmp(set.out, "a\\b") == 0 && strcmp(set.name, "caf\xC3\xA9") == 0 && strcmp(set.imu, "i.csv") == 0);
    CHECK(strcmp(set.title, "T") == 0);
}

static void manoeuvres_arrive_in_turn(void)
{
    static const char *const kinds[] = { "rest", "straight", "accelerate", "climb",    "turn",
                                         "roll", "loop",     "s_turn",     "sinusoids" };
    const sins_manoeuvre *manoeuvre;
    int32_t i;

    CHECK(read("[[manoeuvre]]\nkind = \"turn\"\nheading_change_deg = 90\nbank_deg = 30\nramp_s = 2\n"
               "[[manoeuvre]]\nkind = \"sinusoids\"\nduration_s = 60\n"
               "[[manoeuvre.sinusoid]]\nchannel = \"speed\"\namplitude_m_s = 4\nfrequency_hz = 0.5\n"
               "[[manoeuvre.sinusoid]]\nchannel = \"roll\"\namplitude_deg = 180\nfrequency_hz = 2\nphase_deg = 90\n"
               "[[manoeuvre]]\nkind = \"accelerate\"\nspeed_change_m_s = 5\nheight_change_m = 6\nturns = 7\n"
               "[options]\n") == 0);
    CHECK(set.kind == SCENE_MANOEUVRES && set.plan.count == 3);
    manoeuvre = set.plan.manoeuvres;
    CHECK(manoeuvre[0].struct_size == sizeof *manoeuvre && manoeuvre[0].kind == SINS_MANOEUVRE_TURN);
    CHECK(is_near(manoeuvre[0].heading_change_rad, PI / 2) && is_near(manoeuvre[0].bank_rad, PI / 6));
    CHECK(manoeuvre[0].ramp_s == 2 && manoeuvre[0].duration_s == 0 && manoeuvre[0].sinusoid_count == 0);
    CHECK(manoeuvre[1].kind == SINS_MANOEUVRE_SINUSOIDS && manoeuvre[1].sinusoid_count == 2);
    CHECK(manoeuvre[1].duration_s == 60 && manoeuvre[1].bank_rad == 0);
    CHECK(manoeuvre[1].channel[0] == SINS_CHANNEL_SPEED && manoeuvre[1].channel[1] == SINS_CHANNEL_ROLL);
    CHECK(manoeuvre[1].amplitude[0] == 4 && is_near(manoeuvre[1].amplitude[1], PI));
    CHECK(manoeuvre[1].frequency_hz[0] == 0.5 && manoeuvre[1].frequency_hz[1] == 2);
    CHECK(manoeuvre[1].phase_rad[0] == 0 && is_near(manoeuvre[1].phase_rad[1], PI / 2));
    CHECK(manoeuvre[2].speed_change_m_s == 5 && manoeuvre[2].height_change_m == 6 && manoeuvre[2].turns == 7);
    CHECK(set.manoeuvre_lines[1].header == 6 && set.manoeuvre_lines[2].header == 18);
    for (i = 0; i < 9; i++) {
        char text[64];

        snprintf(text, sizeof text, "[[manoeuvre]]\nkind = \"%s\"\n", kinds[i]);
        CHECK(read(text) == 0 && set.plan.manoeuvres[0].kind == i);
    }
}

static void failures_arrive_in_turn(void)
{
    static const char *const kinds[] = { "none", "stuck", "dead", "bias_step", "spikes", "noise", "drop_outs" };
    static const char *const bodies[] = { "", "", "", "size_m = 1", "size_m = 1\ninterval_s = 2\nduration_s = 1",
                                          "density_m_sqrt_hz = 1", "probability = 0.5" };
    static const int32_t constants[] = { SINS_FAILURE_NONE,   SINS_FAILURE_STUCK, SINS_FAILURE_DEAD,
                                         SINS_FAILURE_BIAS_STEP, SINS_FAILURE_SPIKES, SINS_FAILURE_NOISE,
                                         SINS_FAILURE_DROP_OUTS };
    const struct planned_failure *planned = set.failures.failures;
    int i;

    CHECK(read(REST "[[failure]]\nsensor = 'gyro'\naxis = 'z'\nkind = 'spikes'\nsize_deg_h = 180\ninterval_s = 2\n"
               "duration_s = 0.25\nfrom_s = 3\nuntil_s = 4.5\n"
               "[[failure]]\nsensor = 'accelerometer'\naxis = 'y'\nkind = 'noise'\ndensity_micro_g_sqrt_hz = 2\n"
               "[[failure]]\nsensor = 'altimeter'\nkind = 'bias_step'\nsize_m = 30\n"
               "[[failure]]\nsensor = 'accelerometer'\naxis = 'x'\nkind = 'bias_step'\nsize_micro_g = 3\n"
               "[[failure]]\nsensor = 'gyro'\naxis = 'x'\nkind = 'noise'\ndensity_deg_sqrt_h = 60\n"
               "[[failure]]\nsensor = 'altimeter'\nkind = 'none'\n[options]\n") == 0);
    CHECK(set.failures.count == 5);
    CHECK(planned[0].sensor == SINS_SENSOR_GYRO && planned[0].axis == 2 && planned[0].line == 4);
    CHECK(planned[0].from_s == 3 && planned[0].until_s == 4.5 && is_near(planned[0].failure.size, PI / 3600));
    CHECK(planned[0].failure.interval_s == 2 && planned[0].failure.duration_s == 0.25);
    CHECK(planned[1].sensor == SINS_SENSOR_ACCEL && planned[1].axis == 1 && planned[1].from_s == 0);
    CHECK(planned[1].until_s > 1e300 && is_near(planned[1].failure.density, 2e-6 * G) && planned[1].failure.size == 0);
    CHECK(planned[2].sensor == SINS_SENSOR_ALTIMETER && planned[2].axis == 0 && planned[2].failure.size == 30);
    CHECK(planned[3].axis == 0 && is_near(planned[3].failure.size, 3e-6 * G));
    CHECK(is_near(planned[4].failure.density, PI / 180));
    for (i = 0; i < 7; i++) {
        char text[128];

        snprintf(text, sizeof text, "[[failure]]\nsensor = 'altimeter'\nkind = '%s'\n%s\n", kinds[i], bodies[i]);
        take(text);
        CHECK(set.failure.kind == constants[i] && set.failures.count == (i > 0));
    }
    take("[[failure]]\nsensor = 'altimeter'\nkind = 'noise'\ndensity_m_sqrt_hz = 0.5\n");
    CHECK(planned[0].failure.density == 0.5 && set.failures.count == 1);
    take("[[failure]]\nsensor = 'altimeter'\nkind = 'drop_outs'\nprobability = 0.125\n");
    CHECK(planned[0].failure.probability == 0.125);
}

/* What of the library's constants and of the struct the harness counts on. */
static void as_many_manoeuvres_and_keys_as_there_is_room(void)
{
    static char text[FLIGHT_PLAN_MANOEUVRES * 40];
    size_t i, keys = 0;

    for (i = 0; i < option_table_length; i++) {
        keys += option_table[i].group == GROUP_MANOEUVRE;
    }
    CHECK(keys <= MANOEUVRE_KEYS);
    text[0] = '\0';
    for (i = 0; i < FLIGHT_PLAN_MANOEUVRES; i++) {
        strcat(text + 28 * i, "[[manoeuvre]]\nkind = 'roll'\n");
    }
    CHECK(strlen(text) == 28 * FLIGHT_PLAN_MANOEUVRES);
    CHECK(read(text) == 0 && set.plan.count == FLIGHT_PLAN_MANOEUVRES);
    strcat(text, "[[manoeuvre]]\nkind = 'rest'\n");
    CHECK(read(text) != 0);
}

static void command(int count, const char *const *arguments)
{
    char *copies[8];
    static char texts[8][64];
    int i;

    for (i = 0; i < count; i++) {
        copies[i] = strcpy(texts[i], arguments[i]);
    }
    CHECK(command_line_read(&set, count, copies) == 0);
}

static void presets_come_first_and_the_command_line_last(void)
{
    const char *const plain[] = { "scene_test.toml" };
    const char *const options[] = { "scene_test.toml", "--gyro-bias", "5", "--preset", "tactical", "--seed", "3" };
    sins_gyro_params consumer, tactical;
    FILE *file = fopen("scene_test.toml", "wb");

    CHECK(file != NULL);
    fputs("[gyro]\nbias_sigma_deg_h = 7\nbias_deg_h = 1\npreset = 'consumer'\n[flight]\nbuiltin = 'rest'\n", file);
    fclose(file);
    SINS_INIT(consumer);
    SINS_INIT(tactical);
    CHECK(sins_gyro_preset(SINS_GRADE_CONSUMER, &consumer) == SINS_OK);
    CHECK(sins_gyro_preset(SINS_GRADE_TACTICAL, &tactical) == SINS_OK);

    command(1, plain);
    CHECK(set.gyro.range_rad_s[0] == consumer.range_rad_s[0] && consumer.range_rad_s[0] > 0);
    CHECK(is_near(set.gyro.bias_sigma_rad_s[2], 7 * PI / 180 / 3600));
    CHECK(is_near(set.gyro.bias_rad_s[2], PI / 180 / 3600) && set.options.seed == 0);
    CHECK(set.options.vertical == SINS_VERTICAL_DAMPED && set.options.error_model == SINS_ERROR_MODEL_OFF);
    CHECK(strcmp(set.name, "scene_test") == 0);

    /* The file's preset is replaced, its other keys stay, but for those that the command line sets. */
    command(7, options);
    CHECK(set.gyro.range_rad_s[0] == 0 && set.gyro.random_walk_rad_sqrt_s[1] == tactical.random_walk_rad_sqrt_s[1]);
    CHECK(is_near(set.gyro.bias_sigma_rad_s[2], 7 * PI / 180 / 3600));
    CHECK(is_near(set.gyro.bias_rad_s[2], 5 * PI / 180 / 3600) && set.options.seed == 3);
    remove("scene_test.toml");
}

static void a_log_lies_beside_its_scene(void)
{
    static const char *const logs[][2] = {
        { "a.csv", "folder/a.csv" }, { "a:", "folder/a:" }, { "a:b", "folder/a:b" }, { "../a", "folder/../a" },
        { "/a", "/a" },              { "\\a", "\\a" },      { "a:/b", "a:/b" },      { "a:\\b", "a:\\b" }
    };
    const int32_t ideal[2] = { 0, 0 };
    char text[64];
    size_t i;

    for (i = 0; i < sizeof logs / sizeof logs[0]; i++) {
        CHECK(settings_begin(&set, ideal) == 0);
        strcpy(set.scene_file, "folder/scene.toml");
        snprintf(text, sizeof text, "[flight]\nfile = '%s'\n", logs[i][0]);
        CHECK(scene_file_apply(&set, text, strlen(text)) == 0);
        CHECK(strcmp(set.log, logs[i][1]) == 0);
    }
}

/* The same file by ever longer ways: a path is taken whole or not at all. */
static void a_path_is_never_cut(void)
{
    static const char name[] = "scene_test.toml";
    static char path[VALUE_TEXT_SIZE + 2];
    size_t length;
    FILE *file = fopen(name, "wb");

    CHECK(file != NULL);
    fputs("[flight]\nbuiltin = 'rest'\n", file);
    fclose(file);
    for (length = VALUE_TEXT_SIZE - 3; length < VALUE_TEXT_SIZE + 2; length += 2) {
        size_t folders = length - (sizeof name - 1), i;
        char *argument = path;

        for (i = 0; i < folders; i++) {
            path[i] = i % 2 == folders % 2 ? '.' : '/';
        }
        strcpy(path + folders, name);
        CHECK((command_line_read(&set, 1, &argument) == 0) == (length < VALUE_TEXT_SIZE));
        CHECK(length >= VALUE_TEXT_SIZE || strcmp(set.scene_file, path) == 0);
    }
    remove(name);
}

/* A value as the reader of TOML reads it. 1 if it is taken. */
static int value_of(const char *text, struct toml_item *item)
{
    struct toml_reader reader;
    char line[256];

    snprintf(line, sizeof line, "key = %s", text);
    toml_begin(&reader, line, strlen(line));
    return toml_next(&reader, item) == 1 && toml_next(&reader, item) == 0;
}

static void values_are_what_toml_says(void)
{
    static const struct {
        const char *text;
        enum value_type type;
        double number;
    } numbers[] = {
        { "0", VALUE_WHOLE, 0 },          { "+7", VALUE_WHOLE, 7 },       { "-7", VALUE_NUMBER, -7 },
        { "1_000", VALUE_WHOLE, 1000 },   { "0.5 # half", VALUE_NUMBER, 0.5 }, { "1e3", VALUE_NUMBER, 1000 },
        { "-0.0", VALUE_NUMBER, 0 },      { "6.02_2E+2_3", VALUE_NUMBER, 6.022e23 }, { "5e-0_1", VALUE_NUMBER, 0.5 },
        { "9223372036854775807", VALUE_WHOLE, 9223372036854775807.0 }
    };
    static const char *const refused[] = {
        "", "01", "1.", ".5", "1__0", "1_", "_1", "1e", "1e400", "--1", "0x1F", "0b1", "0o7", "inf", "-nan", "1,2",
        "9223372036854775808", "1979-05-27", "07:32:00", "True", "yes", "\"open", "'open", "\"\"\"a\"\"\"", "'''a'''",
        "\"\\q\"", "\"\\u00\"", "\"\\u0000\"", "\"\\uD800\"", "\"\\U00110000\"", "[1", "[1 2]", "[,]", "[1,,2]",
        "['a']", "[true]", "[[1]]", "{ a = 1 }", "1 2", "\"a\" b", "[1,2,3,4,5,6,7,8,9,10]",
        "1234567890123456789012345678901234567890123456789012345678901234"
    };
    struct toml_item item;
    size_t i;

    for (i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        CHECK(value_of(numbers[i].text, &item));
        CHECK(item.value.type == numbers[i].type && item.value.numbers[0] == numbers[i].number);
    }
    for (i = 0; i < sizeof refused / sizeof refused[0]; i++) {
        CHECK(!value_of(refused[i], &item));
    }
    CHECK(value_of("[ # three\r\n 1,\n\n 2.5, 3, ] # end", &item) && item.value.type == VALUE_ARRAY);
    CHECK(item.value.count == 3 && item.value.numbers[1] == 2.5);
    CHECK(value_of("[]", &item) && item.value.count == 0);
    CHECK(value_of("true", &item) && item.value.type == VALUE_TRUTH && item.value.whole == 1);
    CHECK(value_of("\"tab\\t quote\\\" \\u20AC \\U0001F6E9 #\"", &item) && item.value.type == VALUE_TEXT);
    CHECK(strcmp(item.value.text, "tab\t quote\" \xE2\x82\xAC \xF0\x9F\x9B\xA9 #") == 0);
    CHECK(value_of("'C:\\new \"x\"'", &item) && strcmp(item.value.text, "C:\\new \"x\"") == 0);
    CHECK(value_of("''", &item) && item.value.text[0] == '\0');
}

static void arguments_are_what_they_say(void)
{
    static const struct {
        const char *text;
        enum value_type type;
        double number;
    } arguments[] = {
        { "0", VALUE_WHOLE, 0 }, { "007", VALUE_WHOLE, 7 }, { "-7", VALUE_NUMBER, -7 }, { "1e3", VALUE_NUMBER, 1000 },
        { "18446744073709551615", VALUE_WHOLE, 18446744073709551615.0 },
        { "18446744073709551616", VALUE_NUMBER, 18446744073709551616.0 }
    };
    static const char *const texts[] = { "", "x", "1,", "1 2", "nan" };
    char digits[72];
    struct value value;
    size_t i;

    for (i = 0; i < sizeof arguments / sizeof arguments[0]; i++) {
        value_of_argument(&value, arguments[i].text);
        CHECK(value.type == arguments[i].type && value.count == 1 && value.numbers[0] == arguments[i].number);
    }
    for (i = 0; i < sizeof texts / sizeof texts[0]; i++) {
        value_of_argument(&value, texts[i]);
        CHECK(value.type == VALUE_TEXT && strcmp(value.text, texts[i]) == 0);
    }
    value_of_argument(&value, "1,2.5");
    CHECK(value.type == VALUE_ARRAY && value.count == 2 && value.numbers[1] == 2.5);
    /* A number is read up to 63 characters; more digits are none, nor a whole number without a double. */
    for (i = 1; i < sizeof digits; i++) {
        memset(digits, '0', i);
        digits[i] = '\0';
        value_of_argument(&value, digits);
        CHECK(value.type == (i < 64 ? VALUE_WHOLE : VALUE_TEXT));
    }
}

static void distances_count_slips_of_the_pen(void)
{
    CHECK(name_distance("bias", "bias") == 0 && name_distance("bais", "bias") == 1);
    CHECK(name_distance("bia", "bias") == 1 && name_distance("biass", "bias") == 1);
    CHECK(name_distance("beas", "bias") == 1 && name_distance("", "bias") == 4);
    CHECK(name_distance("kitten", "sitting") == 3);
}

int main(void)
{
    every_number_arrives_in_si();
    a_single_number_stands_for_all();
    every_word_is_its_constant();
    manoeuvres_arrive_in_turn();
    failures_arrive_in_turn();
    as_many_manoeuvres_and_keys_as_there_is_room();
    presets_come_first_and_the_command_line_last();
    a_log_lies_beside_its_scene();
    a_path_is_never_cut();
    values_are_what_toml_says();
    arguments_are_what_they_say();
    distances_count_slips_of_the_pen();
    return 0;
}
