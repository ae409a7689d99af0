/* sins_identify through the interface: errors that were set on a simulator come back from its increments, what a record cannot show is
 * said, and no bad value, order or record changes what was pushed or found. */

#include <math.h>
#include <string.h>

#include "failure_is.h"
#include "scene.h"

static sins_identify *identify;
static sins_identified_parameter parameter = {.struct_size = sizeof parameter};

static const sins_identified_parameter *read_parameter(size_t index)
{
    CHECK(sins_identify_get_parameter(identify, index, &parameter) == SINS_OK);
    CHECK(parameter.low <= parameter.value && parameter.value <= parameter.high);
    CHECK((parameter.reason[0] == '\0') == (parameter.flags == SINS_IDENTIFIED_SEEN));
    return &parameter;
}

/* Four standard deviations: one parameter in 16000 is beyond them. */
static void is_within(size_t index, const char *name, double truth)
{
    const sins_identified_parameter *one = read_parameter(index);
    if (strcmp(one->name, name) != 0 || fabs(one->value - truth) > 4.0 * one->sigma) {
        fprintf(stderr, "%s: %g, sigma %g, true %g\n", one->name, one->value, one->sigma, truth);
    }
    CHECK(strcmp(one->name, name) == 0 && fabs(one->value - truth) <= 4.0 * one->sigma);
    CHECK(one->flags == SINS_IDENTIFIED_SEEN && one->sigma < 0.5 * one->prior);
}

/* Aerobatics, with sensors whose clock is 0.25 s behind. */
static void errors_come_back(void)
{
    const double behind_s = 0.25, rate_hz = 20.0;
    sins_gyro_params gyro = {.struct_size = sizeof gyro}, of_scene = {.struct_size = sizeof of_scene};
    sins_accel_params accel = {.struct_size = sizeof accel};
    sins_flight_sample sample = {.struct_size = sizeof sample};
    sins_recorded_increment measured;
    sins_identified found = {.struct_size = sizeof found};
    sins_scene *scene = NULL, *identified_scene = NULL;
    sins_flight *flight = NULL;
    sins_sim *sim = NULL;
    static char text[16384];
    size_t needed = 0, whole = 0;
    int k;
    for (k = 0; k < 3; k++) {
        gyro.random_walk_rad_sqrt_s[k] = 0.05 * SINS_DEG_PER_SQRT_HOUR;
        accel.velocity_random_walk_m_s_sqrt_s[k] = 50.0 * SINS_MICRO_G_PER_SQRT_HZ;
    }
    gyro.bias_rad_s[1] = 30.0 * SINS_DEG_PER_HOUR;
    gyro.scale_factor[0] = 2e-3;
    accel.bias_m_s2[2] = 2000.0 * SINS_MICRO_G;
    CHECK(sins_create(NULL, &sim) == SINS_OK && sins_set_gyro(sim, &gyro) == SINS_OK && sins_set_accel(sim, &accel) == SINS_OK);
    CHECK(sins_scene_create_builtin("aerobatics", &scene) == SINS_OK && sins_scene_create_flight(scene, &flight) == SINS_OK);
    CHECK(sins_identify_create(NULL, NULL, &identify) == SINS_OK);
    for (k = 0; k < 6000; k++) {
        CHECK(sins_flight_sample_at(flight, k / rate_hz, &sample) == SINS_OK);
        CHECK(sins_identify_push_samples(identify, &sample, 1) == SINS_OK);
        CHECK(sins_push_sample(sim, &sample) == SINS_OK);
        if (sins_step(sim) == SINS_OK) {
            measured = scene_increment(sim, behind_s);
            CHECK(sins_identify_push_increments(identify, &measured, 1) == SINS_OK);
        }
    }
    CHECK(sins_identify_solve(identify, &found) == SINS_OK);
    CHECK(found.flags == SINS_IDENTIFIED_SEEN && found.increments == 5999 && fabs(found.used_s - 300.0) < 10.0);
    CHECK(fabs(found.rotation[0] - 1.0) < 1e-3 && fabs(found.boresight_rad[2]) < 1e-2);
    is_within(0, "clock shift", behind_s);
    is_within(6, "gyro bias y", gyro.bias_rad_s[1]);
    is_within(8, "gyro scale factor x", gyro.scale_factor[0]);
    is_within(28, "accelerometer bias z", accel.bias_m_s2[2]);
    read_parameter(17);
    CHECK(strcmp(parameter.name, "gyro white noise x") == 0 && strcmp(parameter.unit, "rad/sqrt(s)") == 0);
    CHECK(parameter.low < gyro.random_walk_rad_sqrt_s[0] && gyro.random_walk_rad_sqrt_s[0] < parameter.high);
    for (k = 0; k < SINS_IDENTIFIED_PARAMETERS; k++) {
        read_parameter((size_t)k);
    }
    CHECK(strcmp(parameter.name, "accelerometer bias/temperature z") == 0 && strcmp(parameter.reason, "not asked for") == 0);
    CHECK(strcmp(read_parameter(46)->name, "accelerometer random walk z") == 0 && parameter.prior == 0.0);

    /* The scene has the same numbers, with six digits. */
    CHECK(sins_identify_get_scene(identify, NULL, 0, &whole) == SINS_OK && whole < sizeof text);
    CHECK(sins_identify_get_scene(identify, text, 10, &needed) == SINS_ERROR_BUFFER_TOO_SMALL && needed == whole);
    CHECK(sins_identify_get_scene(identify, text, sizeof text, &needed) == SINS_OK && strlen(text) + 1 == whole);
    CHECK(sins_scene_parse(text, whole - 1, &identified_scene) == SINS_OK);
    CHECK(sins_destroy(sim) == SINS_OK && sins_scene_create_simulator(identified_scene, &sim) == SINS_OK);
    CHECK(sins_get_gyro(sim, &of_scene) == SINS_OK);
    read_parameter(6);
    CHECK(fabs(of_scene.bias_rad_s[1] / parameter.value - 1.0) < 1e-5);

    /* A sample that jumps and an increment that goes back are rejected; what was found stays, and is found again. */
    sample.time_s += 0.1;
    sample.height_m += 1e5;
    CHECK(sins_identify_push_samples(identify, &sample, 1) == SINS_ERROR_DISCONTINUITY);
    CHECK(sins_identify_push_increments(identify, &measured, 1) == SINS_ERROR_TIME_ORDER);
    CHECK(sins_identify_solve(identify, NULL) == SINS_OK);
    CHECK(read_parameter(6)->value / (30.0 * SINS_DEG_PER_HOUR) > 0.5);
    CHECK(sins_identify_destroy(identify) == SINS_OK && sins_identify_destroy(identify) == SINS_ERROR_BAD_HANDLE);
    CHECK(sins_destroy(sim) == SINS_OK && sins_flight_destroy(flight) == SINS_OK);
    CHECK(sins_scene_destroy(scene) == SINS_OK && sins_scene_destroy(identified_scene) == SINS_OK);
}

/* A unit at rest shows its biases and its noise, and no clock, which is said. */
static void rest_shows_little(void)
{
    identify = scene_identify();
    read_parameter(0);
    CHECK(parameter.flags == 0 && strstr(parameter.reason, "not seen in this motion") == parameter.reason);
    CHECK(read_parameter(5)->flags == SINS_IDENTIFIED_SEEN);
    CHECK(sins_identify_destroy(identify) == SINS_OK);
}

/* The failure of the last call. */
static void begins_with(const char *sentence)
{
    char text[256];
    CHECK(sins_last_error(NULL, text, sizeof text, NULL) == SINS_OK);
    if (strncmp(text, sentence, strlen(sentence)) != 0) {
        fprintf(stderr, "%s\n", text);
    }
    CHECK(strncmp(text, sentence, strlen(sentence)) == 0);
}

static void bad_request(sins_identify_request request, const char *sentence)
{
    sins_identify *made = NULL;
    request.struct_size = sizeof request;
    CHECK(sins_identify_create(NULL, &request, &made) == SINS_ERROR_INVALID_ARGUMENT && made == NULL);
    begins_with(sentence);
}

static void wrong_use_is_answered(void)
{
    sins_identify_request known = {.struct_size = sizeof known, .flags = SINS_IDENTIFY_SHIFT, .prior = SINS_GRADE_TACTICAL};
    static sins_recorded_increment record[200];
    sins_identified found = {.struct_size = sizeof found, .increments = 77};
    sins_identified_parameter one = {.struct_size = sizeof one, .value = 77.0};
    sins_flight_sample sample = {.struct_size = sizeof sample};
    char text[256] = "before";
    int k;
    bad_request((sins_identify_request){.flags = 64}, "request.flags = 64: must be from 0 to 63");
    bad_request((sins_identify_request){.prior = 99}, "request.prior = 99: ");
    bad_request((sins_identify_request){.axes = {1, 4, 3}}, "request.axes[1] = 4: must be 1, 2 or 3");
    bad_request((sins_identify_request){.axes = {1, 2, 0}}, "request.axes[2] = 0: must be 1, 2 or 3");
    bad_request((sins_identify_request){.axes = {1, 2, INT32_MIN}}, "request.axes[2] = -2147483648: ");
    bad_request((sins_identify_request){.axes = {1, 2, -3}}, "request.axes: must be a signed exchange");
    bad_request((sins_identify_request){.flags = 1, .shift_s = NAN}, "request.shift_s = NaN");
    bad_request((sins_identify_request){.cutoff_hz = 1e-4}, "request.cutoff_hz = 0.0001: must be from 0.001 to 1000000");
    bad_request((sins_identify_request){.cutoff_hz = NAN}, "request.cutoff_hz = NaN");
    known.axes[0] = 2;
    known.axes[1] = 1;
    known.axes[2] = -3;
    CHECK(sins_identify_create(NULL, &known, &identify) == SINS_OK);
    CHECK(sins_identify_get_parameter(identify, 0, &one) == SINS_ERROR_BAD_STATE && one.value == 77.0);
    CHECK(sins_identify_get_scene(identify, text, sizeof text, NULL) == SINS_ERROR_BAD_STATE && strcmp(text, "before") == 0);
    CHECK(sins_identify_solve(identify, &found) < 0 && found.increments == 77);
    CHECK(sins_identify_get_parameter(identify, SINS_IDENTIFIED_PARAMETERS, &one) == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sins_identify_get_parameter(identify, SIZE_MAX, &one) == SINS_ERROR_INVALID_ARGUMENT && one.value == 77.0);
    record[0].struct_size = sizeof record[0];
    for (k = 0; k < 200; k++) {
        record[k].time_s = 0.01 * k;
        record[k].interval_s = 0.01;
    }
    CHECK(sins_identify_push_increments(identify, NULL, 0) == SINS_OK && sins_identify_push_samples(identify, NULL, 0) == SINS_OK);
    CHECK(sins_identify_push_increments(identify, record, 200) == SINS_OK);
    CHECK(sins_identify_push_increments(identify, record + 199, 1) == SINS_ERROR_STRUCT_SIZE);
    CHECK(sins_identify_push_increments(identify, record, 1) == SINS_ERROR_TIME_ORDER);
    /* What stands before a bad increment is taken, and the failure names its place. */
    record[0].time_s = 2.0;
    record[1].time_s = 2.01;
    record[1].angle_rad[2] = INFINITY;
    CHECK(sins_identify_push_increments(identify, record, 3) == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sins_last_error(NULL, text, sizeof text, NULL) == SINS_OK && strcmp(text, "increments.angle_rad[2] = inf: must be a finite number (increments[1])") == 0);
    record[1].angle_rad[2] = 0.0;
    record[1].velocity_m_s[1] = 2e4;
    CHECK(sins_identify_push_increments(identify, record + 1, 1) == SINS_ERROR_STRUCT_SIZE);
    record[1].struct_size = sizeof record[1];
    CHECK(sins_identify_push_increments(identify, record + 1, 1) == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sins_last_error(NULL, text, sizeof text, NULL) == SINS_OK);
    CHECK(strcmp(text, "increments.velocity_m_s[1] = 20000: must be from -10000 to 10000 (increments[0])") == 0);
    record[1].struct_size = 0;
    CHECK(sins_identify_push_increments(identify, record, 1) == SINS_ERROR_TIME_ORDER);
    record[0].time_s = NAN;
    CHECK(sins_identify_push_increments(identify, record, 1) == SINS_ERROR_INVALID_ARGUMENT);
    record[0].time_s = 5.0;
    record[0].interval_s = 0.0;
    CHECK(sins_identify_push_increments(identify, record, 1) == SINS_ERROR_INVALID_ARGUMENT);
    record[0].interval_s = 0.01;
    record[0].reserved = 1;
    CHECK(sins_identify_push_increments(identify, record, 1) == SINS_ERROR_INVALID_ARGUMENT);
    strcpy(text, "before");
    /* A record without a path. */
    CHECK(sins_identify_solve(identify, &found) < 0 && found.increments == 77);
    sample.latitude_rad = NAN;
    CHECK(sins_identify_push_samples(identify, &sample, 1) == SINS_ERROR_INVALID_ARGUMENT);
    /* At a pole, where an INS in geographic axes cannot fly, the path can. */
    for (k = 0; k < 10; k++) {
        sample.latitude_rad = 90.0 * SINS_DEG;
        sample.time_s = 0.5 * k;
        CHECK(sins_identify_push_samples(identify, &sample, 1) == SINS_OK);
    }
    /* A record that is dead: zeros while gravity acts. */
    CHECK(sins_identify_solve(identify, &found) == SINS_ERROR_INVALID_ARGUMENT && found.increments == 77);
    CHECK(sins_identify_get_parameter(identify, 0, &one) == SINS_ERROR_BAD_STATE);
    CHECK(sins_identify_destroy(identify) == SINS_OK);
}

static void bad_check(sins_identify_check_request request, sins_status status, const char *sentence)
{
    sins_identified_check check = {.struct_size = sizeof check, .spans = 77};
    request.struct_size = sizeof request;
    CHECK(sins_identify_check(identify, &request, &check) == status && check.spans == 77);
    begins_with(sentence);
}

/* Half a minute with white noise alone keeps what was found in the half before; the errors of a bad path are known to the twins. */
static void a_record_is_checked(void)
{
    sins_identify_check_request request = {.struct_size = sizeof request, .twins = 40};
    sins_identified_check check = {.struct_size = sizeof check};
    sins_identified found = {.struct_size = sizeof found};
    sins_identified_span span = {.struct_size = sizeof span}, again;
    sins_identified_parameter whole;
    double predicted_m;
    identify = scene_identify_of(SINS_GRADE_TACTICAL);
    whole = *read_parameter(5);
    CHECK(sins_identify_get_span(identify, 0, &span) == SINS_OK);
    again = span;
    CHECK(sins_identify_check(identify, &request, &check) == SINS_OK);
    CHECK(sins_identify_get_span(identify, 0, &span) == SINS_OK && memcmp(&span, &again, sizeof span) == 0);
    CHECK(check.spans == 1 && check.twins == 40 && check.diverged_s == 0.0 && check.length_s > 30.0 && check.length_s < 31.5);
    CHECK(check.agreement == SINS_AGREEMENT_AGREES && check.factor == 1.0);
    CHECK(span.duration_s == 10.0 && span.flights == 5 && span.apart == 3 && span.agreement == SINS_AGREEMENT_AGREES);
    CHECK(span.real_low_m <= span.real_m && span.real_m <= span.real_high_m && span.real_m < span.real_rms_m * 3.0);
    CHECK(span.predicted_low_m < span.real_m && span.real_m < span.predicted_high_m);
    CHECK(span.predicted_low_m < span.predicted_m && span.predicted_m < span.predicted_high_m);
    /* What was found is that of the half, which knows less. */
    CHECK(read_parameter(5)->sigma > whole.sigma);
    /* NULL is as all zero. */
    CHECK(sins_identify_check(identify, NULL, NULL) == SINS_OK);
    request.twins = 0;
    CHECK(sins_identify_get_span(identify, 0, &again) == SINS_OK);
    CHECK(sins_identify_check(identify, &request, &check) == SINS_OK && check.twins == 100);
    CHECK(sins_identify_get_span(identify, 0, &span) == SINS_OK && memcmp(&span, &again, sizeof span) == 0);
    /* Each flight of a twin begins with an error of 3 m/s in each axis: 10 s later it is some 35 m off, at least 10 m. */
    predicted_m = span.predicted_m;
    request.velocity_m_s = 3.0;
    CHECK(sins_identify_check(identify, &request, &check) == SINS_OK && check.agreement == SINS_AGREEMENT_TOO_BAD);
    CHECK(sins_identify_get_span(identify, 0, &span) == SINS_OK && span.predicted_m > 10.0 && predicted_m < 1.0);
    CHECK(check.factor == span.factor && fabs(span.factor - span.predicted_m / span.real_m) < 1e-9 * span.factor);
    /* What is wrong is named, and what was found and checked stays. */
    bad_check((sins_identify_check_request){.twins = 39}, SINS_ERROR_INVALID_ARGUMENT, "request.twins = 39: must be from 40 to 1000");
    bad_check((sins_identify_check_request){.twins = 1001}, SINS_ERROR_INVALID_ARGUMENT, "request.twins = 1001: ");
    bad_check((sins_identify_check_request){.position_m = 2e4}, SINS_ERROR_INVALID_ARGUMENT, "request.position_m = 20000: ");
    bad_check((sins_identify_check_request){.velocity_m_s = -1.0}, SINS_ERROR_INVALID_ARGUMENT, "request.velocity_m_s = -1: ");
    bad_check((sins_identify_check_request){.tilt_rad = NAN}, SINS_ERROR_INVALID_ARGUMENT, "request.tilt_rad = NaN: ");
    bad_check((sins_identify_check_request){.heading_rad = 2.0}, SINS_ERROR_INVALID_ARGUMENT, "request.heading_rad = 2: ");
    again = span;
    CHECK(sins_identify_get_span(identify, 0, &span) == SINS_OK && memcmp(&span, &again, sizeof span) == 0);
    CHECK(sins_identify_get_span(identify, 1, &span) == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sins_identify_get_span(identify, SIZE_MAX, &span) == SINS_ERROR_INVALID_ARGUMENT);
    /* All of it can be identified again; the check stays. */
    CHECK(sins_identify_solve(identify, &found) == SINS_OK && read_parameter(5)->sigma == whole.sigma);
    CHECK(sins_identify_get_span(identify, 0, &span) == SINS_OK && memcmp(&span, &again, sizeof span) == 0);
    CHECK(sins_identify_destroy(identify) == SINS_OK);
    /* Without the flag. */
    CHECK(sins_identify_create(NULL, NULL, &identify) == SINS_OK);
    bad_check((sins_identify_check_request){.twins = 40}, SINS_ERROR_BAD_STATE, "the states of the path were not kept");
    CHECK(sins_identify_get_span(identify, 0, &span) == SINS_ERROR_BAD_STATE && memcmp(&span, &again, sizeof span) == 0);
    CHECK(sins_identify_destroy(identify) == SINS_OK);
}

int main(void)
{
    errors_come_back();
    rest_shows_little();
    wrong_use_is_answered();
    a_record_is_checked();
    printf("identify: errors come back from increments, a record is checked, and wrong use is answered\n");
    return 0;
}
