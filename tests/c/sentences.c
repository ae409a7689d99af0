/* Every rejection names field, value and limit, in a buffer of any size. */

#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "check.h"
#include "sins_unit.h"

/* Parameters that are 0 except for element `index` of the field at `offset`, which is `value`. */
static const sins_gyro_params *gyro_with(size_t offset, int index, double value)
{
    static sins_gyro_params gyro;
    memset(&gyro, 0, sizeof gyro);
    gyro.struct_size = sizeof gyro;
    memcpy((char *)&gyro + offset + (size_t)index * sizeof value, &value, sizeof value);
    return &gyro;
}

static const sins_accel_params *accel_with(size_t offset, int index, double value)
{
    static sins_accel_params accel;
    memset(&accel, 0, sizeof accel);
    accel.struct_size = sizeof accel;
    memcpy((char *)&accel + offset + (size_t)index * sizeof value, &value, sizeof value);
    return &accel;
}

/* Asserts that the call was rejected with SINS_ERROR_INVALID_ARGUMENT and this sentence. */
static void refused(sins_sim *sim, sins_status status, const char *sentence)
{
    char text[200];
    CHECK(status == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sins_last_error(sim, text, sizeof text, NULL) == SINS_OK);
    if (strcmp(text, sentence) != 0) {
        fprintf(stderr, "expected %s\nfound    %s\n", sentence, text);
    }
    CHECK(strcmp(text, sentence) == 0);
}

static void out_of_range(sins_sim *sim, const sins_gyro_params *gyro, const sins_accel_params *accel,
                         const char *sentence)
{
    refused(sim, gyro ? sins_set_gyro(sim, gyro) : sins_set_accel(sim, accel), sentence);
}

/* Asserts that a failure is rejected with this sentence. The sensor must stay without a failure. */
static void bad_failure(sins_sim *sim, int32_t sensor, int32_t axis, const sins_failure *failure, const char *sentence)
{
    refused(sim, sins_set_failure(sim, sensor, axis, failure), sentence);
}

static void failures(void)
{
    sins_sim *sim = NULL;
    sins_failure failure = {.struct_size = sizeof failure};
    sins_flight_sample sample = {.struct_size = sizeof sample};
    sins_imu imu = {.struct_size = sizeof imu};
    sins_navigation navigation = {.struct_size = sizeof navigation};
    int32_t axis;
    char text[400], rest;
    int last = 0, kind, is_unknown;

    CHECK(sins_create(NULL, &sim) == SINS_OK);
    bad_failure(sim, 3, 0, &failure, "sensor = 3: must be of enum sins_sensor, 0 to 2");
    bad_failure(sim, -1, 0, &failure, "sensor = -1: must be of enum sins_sensor, 0 to 2");
    bad_failure(sim, SINS_SENSOR_GYRO, 3, &failure, "axis = 3: must be from 0 to 2");
    bad_failure(sim, SINS_SENSOR_ACCEL, -1, &failure, "axis = -1: must be from 0 to 2");
    bad_failure(sim, SINS_SENSOR_ALTIMETER, 1, &failure, "axis = 1: must be 0: the altimeter has one output");
    failure.kind = 1000;
    CHECK(sins_set_failure(sim, SINS_SENSOR_GYRO, 0, &failure) == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sins_last_error(sim, text, sizeof text, NULL) == SINS_OK);
    CHECK(sscanf(text, "failure.kind = 1000: must be of enum sins_failure_kind, 0 to %d%c", &last, &rest) == 1);
    /* The limit is that of the kinds: the last one is no unknown kind, and the number behind it is. */
    for (kind = last; kind <= last + 1; kind++) {
        failure.kind = kind;
        is_unknown = 0;
        if (sins_set_failure(sim, SINS_SENSOR_GYRO, 0, &failure) != SINS_OK) {
            CHECK(sins_last_error(sim, text, sizeof text, NULL) == SINS_OK);
            is_unknown = strstr(text, "must be of enum sins_failure_kind") != NULL;
        }
        CHECK(is_unknown == (kind > last));
    }
    CHECK(last >= SINS_FAILURE_DROP_OUTS);
    failure.kind = SINS_FAILURE_DEAD;
    failure.reserved2 = 1;
    bad_failure(sim, SINS_SENSOR_GYRO, 0, &failure, "failure.reserved2 = 1: must be 0");
    failure.reserved2 = 0;
    failure.size = 1.0;
    bad_failure(sim, SINS_SENSOR_GYRO, 0, &failure, "failure.size = 1: must be 0: this failure does not use it");
    failure.kind = SINS_FAILURE_BIAS_STEP;
    failure.duration_s = 2.0;
    bad_failure(sim, SINS_SENSOR_GYRO, 0, &failure, "failure.duration_s = 2: must be 0: this failure does not use it");
    failure.kind = SINS_FAILURE_SPIKES;
    failure.interval_s = 1.0;
    bad_failure(sim, SINS_SENSOR_GYRO, 0, &failure, "failure.duration_s = 2: must be at most failure.interval_s = 1");
    failure.size = failure.duration_s = 0.0;
    failure.kind = SINS_FAILURE_DROP_OUTS;
    failure.probability = 0.5;
    bad_failure(sim, SINS_SENSOR_GYRO, 0, &failure, "failure.probability = 0.5: must be 0: drop-outs with failure.interval_s do not use it");
    failure.interval_s = failure.probability = 0.0;
    failure.density = -1.0;
    failure.kind = SINS_FAILURE_NOISE;
    bad_failure(sim, SINS_SENSOR_ALTIMETER, 0, &failure, "failure.density = -1: must be from 0 to 100000");

    /* None of these failures is set. Now all outputs are made dead, and one is restored. */
    CHECK(sins_push_sample(sim, &sample) == SINS_OK);
    sample.time_s = 60.0;
    CHECK(sins_push_sample(sim, &sample) == SINS_ERROR_DISCONTINUITY && sins_last_error(sim, text, sizeof text, NULL) == SINS_OK);
    CHECK(strcmp(text, "sample.time_s = 60: the gap after the last accepted sample must be at most options.max_gap_s = 2.5; after a pause call "
                       "sins_move_time(); samples that were rejected in the gap said why") == 0);
    sample.latitude_rad = 0.1; /* a jump that the host does not notice */
    for (sample.time_s = 0.5; sample.time_s < 1e4; sample.time_s += 0.5) {
        const char *reason = sample.time_s > 2.5 ? "sample.time_s = " : "sample position: displacement that the velocity";
        CHECK(sins_push_sample(sim, &sample) == SINS_ERROR_DISCONTINUITY && sins_last_error(sim, text, sizeof text, NULL) == SINS_OK);
        CHECK(strstr(text, reason) == text && strstr(text, "pause") == NULL);
    }
    CHECK(strstr(text, "options.max_gap_s = 2.5; in the gap the position jumped by 633") != NULL);
    CHECK(strstr(text, " m; after a jump call sins_move_truth()") != NULL);
    sample.time_s = 0.01;
    sample.latitude_rad = 47.5;
    CHECK(sins_push_sample(sim, &sample) == SINS_ERROR_INVALID_ARGUMENT && sins_last_error(sim, text, sizeof text, NULL) == SINS_OK);
    CHECK(strstr(text, "sample.latitude_rad = 47.5: must be") == text && strstr(text, "in degrees?") != NULL);
    sample.latitude_rad = 0.0;
    CHECK(sins_push_sample(sim, &sample) == SINS_OK);
    CHECK(sins_step(sim) == SINS_OK && sins_get_imu(sim, &imu) == SINS_OK);
    CHECK(imu.flags == 0 && memcmp(imu.measured_angle_rad, imu.ideal_angle_rad, sizeof imu.ideal_angle_rad) == 0);
    failure.density = 0.0;
    failure.kind = SINS_FAILURE_DEAD;
    for (axis = 0; axis < 3; axis++) {
        CHECK(sins_set_failure(sim, SINS_SENSOR_GYRO, axis, &failure) == SINS_OK);
        CHECK(sins_set_failure(sim, SINS_SENSOR_ACCEL, axis, &failure) == SINS_OK);
    }
    CHECK(sins_set_failure(sim, SINS_SENSOR_ALTIMETER, 0, &failure) == SINS_OK);
    failure.kind = SINS_FAILURE_NONE;
    CHECK(sins_set_failure(sim, SINS_SENSOR_ACCEL, 2, &failure) == SINS_OK);
    sample.time_s = 0.02;
    CHECK(sins_push_sample(sim, &sample) == SINS_OK && sins_step(sim) == SINS_OK);
    CHECK(sins_get_imu(sim, &imu) == SINS_OK && imu.flags == (SINS_IMU_GYRO_INVALID | SINS_IMU_ACCEL_INVALID));
    CHECK(imu.measured_angle_rad[2] == 0.0 && imu.measured_velocity_m_s[2] == imu.ideal_velocity_m_s[2]);
    CHECK(sins_get_navigation(sim, &navigation) == SINS_OK);
    CHECK(navigation.flags == SINS_NAVIGATION_VERTICAL_UNAIDED);
    CHECK(sins_destroy(sim) == SINS_OK);
}

/* Decodes a word, which is rejected with `sentence`; the output stays as it was. */
static void bad_word(uint32_t word, uint32_t flags, const char *sentence)
{
    sins_bus_label label = {.struct_size = sizeof label, .value = 7.0};
    char text[200];

    CHECK(sins_bus_decode(word, flags, &label) == SINS_ERROR_INVALID_ARGUMENT && label.value == 7.0);
    CHECK(sins_last_error(NULL, text, sizeof text, NULL) == SINS_OK);
    CHECK(strcmp(text, sentence) == 0);
}

/* Words that are rejected, and words that are decoded but say what they cannot mean. */
static void words(void)
{
    static const uint32_t illegal[] = {0x04f30021u, 0x00bc000au, 0x84575021u};
    sins_bus_label label = {.struct_size = sizeof label};
    sins_error_info info = {.struct_size = sizeof info};
    size_t k;

    bad_word(0xe40000c9u, 0, "word = e40000c9: has an even parity; words of ARINC 429 have an odd one");
    CHECK(sins_last_error_info(NULL, &info) == SINS_OK && info.value == 0xe40000c9u && (info.flags & SINS_ERROR_INFO_INTEGER) != 0);
    bad_word(0x00000001u, 0, "word = 00000001: label 001 is not in the table");
    bad_word(0xe4000013u, 0, "word = e4000013: label 023 is not in the table; label bits reversed? 310 would be latitude");
    bad_word(0xe40000c8u, SINS_BUS_REVERSED_LABEL,
             "word = e40000c8: label 023 is not in the table; label bits not reversed? 310 would be latitude");
    CHECK(sins_bus_decode(0xe4000013u, SINS_BUS_REVERSED_LABEL, &label) == SINS_OK && label.label == 0310 && label.value == 45.0);
    CHECK(label.minimum == -90.0 && label.maximum == 90.0 && label.status == SINS_BUS_NORMAL);
    for (k = 0; k < sizeof illegal / sizeof *illegal; k++) {
        CHECK(sins_bus_decode(illegal[k], 0, &label) == SINS_OK && label.status == SINS_BUS_ILLEGAL_VALUE);
        CHECK(label.value != label.value);
    }
}

/* A sample without the temperature flag, although a sensor needs the temperature. */
static void temperatures(void)
{
    sins_sim *sim = NULL;
    sins_flight_sample sample = {.struct_size = sizeof sample};
    sins_imu imu = {.struct_size = sizeof imu};
    char text[200];

    CHECK(sins_create(NULL, &sim) == SINS_OK);
    CHECK(sins_set_accel(sim, accel_with(offsetof(sins_accel_params, bias_temperature_m_s2_per_k), 1, 0.125)) == SINS_OK);
    sample.temperature_c = 8.0;
    CHECK(sins_push_sample(sim, &sample) == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sins_last_error(sim, text, sizeof text, NULL) == SINS_OK);
    CHECK(strstr(text, "sample.temperature_c") == text && strstr(text, "SINS_SAMPLE_TEMPERATURE") != NULL);
    sample.flags = SINS_SAMPLE_TEMPERATURE;
    CHECK(sins_push_sample(sim, &sample) == SINS_OK);
    sample.time_s = 1.0;
    CHECK(sins_push_sample(sim, &sample) == SINS_OK);
    CHECK(sins_step(sim) == SINS_OK && sins_get_imu(sim, &imu) == SINS_OK);
    /* Level and at rest, y is north: it senses only the bias, 8 K times 0.125 m/s2 per K, and gravity's north component at
     * latitude 0 and height 0. */
    CHECK(imu.measured_force_m_s2[1] - imu.ideal_force_m_s2[1] > 0.999 && imu.measured_force_m_s2[1] < 1.001);
    CHECK(sins_destroy(sim) == SINS_OK);
}

/* Settings that are allowed only before the first step, on a simulator that has made a step and on a new one. */
static void before_the_first_step(void)
{
    sins_sim *stepped = NULL;
    sins_flight_sample sample = {.struct_size = sizeof sample};
    sins_sim *fresh = NULL;
    sins_mounting mounting = {.struct_size = sizeof mounting};
    sins_gravity_params gravity = {.struct_size = sizeof gravity};
    char text[200];

    CHECK(sins_create(NULL, &stepped) == SINS_OK && sins_push_sample(stepped, &sample) == SINS_OK);
    sample.time_s = 0.01;
    CHECK(sins_push_sample(stepped, &sample) == SINS_OK && sins_step(stepped) == SINS_OK);
    CHECK(sins_set_mounting(stepped, &mounting) == SINS_ERROR_BAD_STATE);
    CHECK(sins_set_gravity_disturbance(stepped, &gravity) == SINS_ERROR_BAD_STATE);
    CHECK(sins_destroy(stepped) == SINS_OK);

    CHECK(sins_create(NULL, &fresh) == SINS_OK);
    mounting.boresight_error_rad[1] = 4.0;
    CHECK(sins_set_mounting(fresh, &mounting) == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sins_last_error(fresh, text, sizeof text, NULL) == SINS_OK);
    CHECK(strstr(text, "mounting.boresight_error_rad[1] = 4: must be from -3.14159") == text);
    mounting.boresight_error_rad[1] = 0.001;
    CHECK(sins_set_mounting(fresh, &mounting) == SINS_OK);
    mounting.lever_arm_m[2] = -101.0;
    CHECK(sins_set_mounting(fresh, &mounting) == SINS_ERROR_INVALID_ARGUMENT);
    mounting.lever_arm_m[2] = 0.0;
    mounting.reserved = 1;
    CHECK(sins_set_mounting(fresh, &mounting) == SINS_ERROR_INVALID_ARGUMENT);

    gravity.anomaly_sigma_m_s2 = 30.0 * 1e-5;
    CHECK(sins_set_gravity_disturbance(fresh, &gravity) == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sins_last_error(fresh, text, sizeof text, NULL) == SINS_OK);
    CHECK(strcmp(text, "gravity.anomaly_distance_m = 0: must be from 1 to 1e9") == 0);
    gravity.anomaly_distance_m = 30e3;
    CHECK(sins_set_gravity_disturbance(fresh, &gravity) == SINS_OK);
    gravity.reserved = 1;
    CHECK(sins_set_gravity_disturbance(fresh, &gravity) == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sins_destroy(fresh) == SINS_OK);
}

static void sentences(sins_sim *sim)
{
    volatile double zero = 0.0;
    sins_gyro_params gyro = {.struct_size = sizeof gyro};
    char text[200], small[11];
    size_t needed = 0;
    sins_options options = {.struct_size = sizeof options};
    sins_sim *made = NULL;

    gyro.markov_sigma_rad_s[1] = 1.0;
    gyro.markov_time_s[1] = -3.0;
    CHECK(sins_set_gyro(sim, &gyro) == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sins_last_error(sim, NULL, 0, &needed) == SINS_OK);
    CHECK(sins_last_error(sim, text, sizeof text, NULL) == SINS_OK);
    CHECK(strstr(text, "gyro.markov_time_s[1] = -3") == text && needed == strlen(text) + 1);
    memset(small, 'x', sizeof small);
    CHECK(sins_last_error(sim, small, 10, &needed) == SINS_ERROR_BUFFER_TOO_SMALL);
    CHECK(strcmp(small, "gyro.mark") == 0 && small[10] == 'x');
    /* Every capacity, in a heap buffer of exactly this size. */
    {
        size_t capacity;
        for (capacity = 1; capacity <= needed + 1; capacity++) {
            char *buffer = malloc(capacity);
            sins_status expected = capacity < needed ? SINS_ERROR_BUFFER_TOO_SMALL : SINS_OK;
            CHECK(buffer != NULL && sins_last_error(sim, buffer, capacity, NULL) == expected);
            CHECK(strlen(buffer) + 1 == (capacity < needed ? capacity : needed));
            CHECK(strncmp(buffer, text, strlen(buffer)) == 0);
            free(buffer);
        }
    }

    /* Every field of the sensors has a range. A bandwidth of 0 means no limit; a smaller one than the least is rejected. */
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, rate_random_walk_rad_s_sqrt_s), 1, -1.0), NULL,
                 "gyro.rate_random_walk_rad_s_sqrt_s[1] = -1: must be from 0 to 100");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, rate_ramp_rad_s2), 0, 101.0), NULL,
                 "gyro.rate_ramp_rad_s2[0] = 101: must be from -100 to 100");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, flicker_rad_s), 2, -1e-9), NULL,
                 "gyro.flicker_rad_s[2] = -1e-9: must be from 0 to 100");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, quantization_rad), 2, 1e-16), NULL,
                 "gyro.quantization_rad[2] = 1e-16: must be 0 for none, or from 1e-15 to 1");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, scale_factor_asymmetry), 0, 2.0), NULL,
                 "gyro.scale_factor_asymmetry[0] = 2: must be from -1 to 1");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, scale_factor_nonlinearity_s_rad), 1, -2.0), NULL,
                 "gyro.scale_factor_nonlinearity_s_rad[1] = -2: must be from -1 to 1");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, g_sensitivity_rad_s_per_m_s2), 5, 2.0), NULL,
                 "gyro.g_sensitivity_rad_s_per_m_s2[5] = 2: must be from -1 to 1");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, range_rad_s), 0, -1.0), NULL,
                 "gyro.range_rad_s[0] = -1: must be 0 for none, or from 1e-9 to 1000000");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, bandwidth_hz), 1, 1e-4), NULL,
                 "gyro.bandwidth_hz[1] = 0.0001: must be 0 for none, or from 0.001 to 1000000");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, dead_zone_rad_s), 2, -1.0), NULL,
                 "gyro.dead_zone_rad_s[2] = -1: must be from 0 to 100");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, acceleration_random_walk_m_s2_sqrt_s), 0, -1.0),
                 "accel.acceleration_random_walk_m_s2_sqrt_s[0] = -1: must be from 0 to 10000");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, ramp_m_s3), 1, 1e5),
                 "accel.ramp_m_s3[1] = 100000: must be from -10000 to 10000");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, flicker_m_s2), 0, -1.0),
                 "accel.flicker_m_s2[0] = -1: must be from 0 to 10000");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, quantization_m_s), 0, 2.0),
                 "accel.quantization_m_s[0] = 2: must be 0 for none, or from 1e-15 to 1");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, scale_factor_asymmetry), 2, 2.0),
                 "accel.scale_factor_asymmetry[2] = 2: must be from -1 to 1");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, scale_factor_nonlinearity_s2_m), 0, 2.0),
                 "accel.scale_factor_nonlinearity_s2_m[0] = 2: must be from -1 to 1");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, range_m_s2), 0, 1e7),
                 "accel.range_m_s2[0] = 1e7: must be 0 for none, or from 1e-9 to 1000000");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, bandwidth_hz), 0, 1e7),
                 "accel.bandwidth_hz[0] = 1e7: must be 0 for none, or from 0.001 to 1000000");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, dead_zone_m_s2), 0, -1.0),
                 "accel.dead_zone_m_s2[0] = -1: must be from 0 to 10000");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, lever_arm_m), 7, 101.0),
                 "accel.lever_arm_m[7] = 101: must be from -100 to 100");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, reference_temperature_c), 0, -274.0), NULL,
                 "gyro.reference_temperature_c = -274: must be from -273.15 to 1000");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, scale_factor_temperature2_per_k2), 2, 2.0), NULL,
                 "gyro.scale_factor_temperature2_per_k2[2] = 2: must be from -1 to 1");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, misalignment_sigma_rad), 5, -1e-3), NULL,
                 "gyro.misalignment_sigma_rad[5] = -0.001: must be from 0 to 1");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, misalignment_sigma_rad), 4, 1e-3),
                 "accel.misalignment_sigma_rad[4] = 0.001: must be 0 on the diagonal; use scale_factor_sigma");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, bias_temperature2_m_s2_per_k2), 1, 1e5),
                 "accel.bias_temperature2_m_s2_per_k2[1] = 100000: must be from -10000 to 10000");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, vibration_rectification_s2_m), 2, 0.0 / zero),
                 "accel.vibration_rectification_s2_m[2] = NaN: must be a finite number");

    /* Every grade can be set, and there are no other grades. */
    {
        int32_t grade;
        for (grade = -1; grade <= 7; grade++) {
            sins_gyro_params gyros = {.struct_size = sizeof gyros};
            sins_accel_params accels = {.struct_size = sizeof accels};
            sins_initial_errors initial = {.struct_size = sizeof initial};
            sins_status expected = grade >= SINS_GRADE_STRATEGIC && grade <= SINS_GRADE_PAPER_SIMULATION2
                                       ? SINS_OK
                                       : SINS_ERROR_INVALID_ARGUMENT;
            sins_sim *graded = NULL;
            CHECK(sins_gyro_preset(grade, &gyros) == expected && sins_accel_preset(grade, &accels) == expected);
            CHECK(sins_initial_preset(grade, &initial) == expected);
            CHECK(sins_create(NULL, &graded) == SINS_OK);
            CHECK(sins_set_gyro(graded, &gyros) == SINS_OK && sins_set_accel(graded, &accels) == SINS_OK);
            CHECK(sins_set_initial_errors(graded, &initial) == SINS_OK);
            CHECK(sins_destroy(graded) == SINS_OK);
        }
    }

    options.scheme = 9;
    CHECK(sins_create(&options, &made) == SINS_ERROR_INVALID_ARGUMENT && made == NULL);
    CHECK(sins_last_error(NULL, text, sizeof text, NULL) == SINS_OK);
    CHECK(strstr(text, "options.scheme = 9") == text);
}

int main(void)
{
    sins_sim *sim = NULL;
    CHECK(sins_create(NULL, &sim) == SINS_OK);
    sentences(sim);
    failures();
    words();
    temperatures();
    before_the_first_step();
    CHECK(sins_destroy(sim) == SINS_OK);
    printf("sentences: field, value and limit\n");
    return 0;
}
