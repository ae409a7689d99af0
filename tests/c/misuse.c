/* Everything that a host does wrong: null pointers, stale, made-up and wrong-kind handles, wrong struct sizes, small
 * buffers - through every function. Nothing crashes, every answer is the right status, and nothing is changed. */

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include "check.h"
#include "sins.h"

/* A handle for every way to be wrong. */
enum { NULL_HANDLE, STALE, MADE_UP, OTHER_KIND, WRONG_HANDLES };

static sins_sim *wrong_sims[WRONG_HANDLES];
static sins_flight *wrong_flights[WRONG_HANDLES];

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
}

static void handles(void)
{
    int i;
    for (i = 0; i < WRONG_HANDLES; i++) {
        sins_sim *sim = wrong_sims[i];
        sins_flight *flight = wrong_flights[i];
        sins_gyro_params gyro = {.struct_size = sizeof gyro};
        sins_accel_params accel = {.struct_size = sizeof accel};
        sins_altimeter_params altimeter = {.struct_size = sizeof altimeter};
        sins_failure failure = {.struct_size = sizeof failure};
        sins_initial_errors initial = {.struct_size = sizeof initial};
        sins_mounting mounting = {.struct_size = sizeof mounting};
        sins_gravity_params gravity = {.struct_size = sizeof gravity};
        sins_flight_sample sample = {.struct_size = sizeof sample};
        sins_navigation navigation = {.struct_size = sizeof navigation};
        sins_imu imu = {.struct_size = sizeof imu};
        sins_errors errors = {.struct_size = sizeof errors};
        sins_accuracy accuracy = {.struct_size = sizeof accuracy};
        sins_imu_increment increment = {.struct_size = sizeof increment};
        sins_record record = {.struct_size = sizeof record};
        sins_options options = {.struct_size = sizeof options};
        double duration = -1.0;
        size_t written = 77, needed = 77;
        char text[8] = "before";

        CHECK(sins_destroy(sim) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_set_gyro(sim, &gyro) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_set_accel(sim, &accel) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_set_altimeter(sim, &altimeter) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_set_failure(sim, SINS_SENSOR_GYRO, 0, &failure) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_set_initial_errors(sim, &initial) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_set_mounting(sim, &mounting) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_set_gravity_disturbance(sim, &gravity) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_push_sample(sim, &sample) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_step(sim) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_run(sim, &sample, 1, 0, NULL, 0, &written) == SINS_ERROR_BAD_HANDLE && written == 77);
        CHECK(sins_get_truth(sim, &navigation) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_get_navigation(sim, &navigation) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_get_imu(sim, &imu) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &errors) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_get_accuracy(sim, &accuracy) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_get_record(sim, &record) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_get_options(sim, &options) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_start_navigation(sim, &navigation) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_push_imu(sim, &increment) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_reposition(sim, &sample) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_reset(sim) == SINS_ERROR_BAD_HANDLE);
        if (i != NULL_HANDLE) {
            CHECK(sins_last_error(sim, text, sizeof text, &needed) == SINS_ERROR_BAD_HANDLE);
            CHECK(needed == 77 && strcmp(text, "before") == 0);
        }
        CHECK(sins_flight_destroy(flight) == SINS_ERROR_BAD_HANDLE);
        CHECK(sins_flight_duration(flight, &duration) == SINS_ERROR_BAD_HANDLE && duration == -1.0);
        CHECK(sins_flight_sample_at(flight, 0.0, &sample) == SINS_ERROR_BAD_HANDLE);
    }
}

static void null_pointers(sins_sim *sim, sins_flight *flight)
{
    sins_flight_start start = {.struct_size = sizeof start};
    sins_manoeuvre rest = {.struct_size = sizeof rest};
    sins_flight *made = NULL;
    sins_flight_sample piece[2] = {{.struct_size = sizeof piece[0]}};
    sins_requirement requirement = {.struct_size = sizeof requirement, .position_m = 1.0};
    sins_options options = {.struct_size = sizeof options};
    sins_cost cost = {.struct_size = sizeof cost};
    sins_budget_row row = {.struct_size = sizeof row};
    uint32_t number;
    rest.duration_s = 1.0;
    piece[1].time_s = 0.01;

    CHECK(sins_abi_version(NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_version(NULL, &number, &number) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_version(&number, NULL, &number) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_version(&number, &number, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_version_string(NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_status_string(SINS_OK, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_create(NULL, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_last_error(sim, NULL, 0, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_set_gyro(sim, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_set_accel(sim, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_set_altimeter(sim, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_set_failure(sim, SINS_SENSOR_GYRO, 0, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_set_initial_errors(sim, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_set_mounting(sim, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_set_gravity_disturbance(sim, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_push_sample(sim, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_run(sim, NULL, 1, 0, NULL, 0, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_get_truth(sim, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_get_navigation(sim, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_get_imu(sim, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_get_errors(sim, SINS_ERRORS_NAVIGATION, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_get_accuracy(sim, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_get_record(sim, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_get_options(sim, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_start_navigation(sim, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_push_imu(sim, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_reposition(sim, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_gyro_preset(SINS_GRADE_PAPER_SIMULATION2, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_accel_preset(SINS_GRADE_PAPER_SIMULATION2, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_flight_create(NULL, &rest, 1, &made) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_flight_create(&start, NULL, 1, &made) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_flight_create(&start, &rest, 1, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_flight_duration(flight, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_flight_sample_at(flight, 0.0, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(made == NULL);
    CHECK(sins_recommend(NULL, 2, &requirement, &options, &cost) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_recommend(piece, 2, NULL, &options, &cost) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_recommend(piece, 2, &requirement, NULL, &cost) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_recommend(piece, 2, &requirement, &options, NULL) == SINS_ERROR_NULL_POINTER);
    CHECK(sins_error_budget(NULL, 2, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, &row, 1, NULL, NULL) ==
          SINS_ERROR_NULL_POINTER);
    CHECK(sins_error_budget(piece, 2, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, 1, NULL, NULL) ==
          SINS_ERROR_NULL_POINTER);
    CHECK(sins_error_budget(piece, 2, NULL, NULL, NULL, NULL, NULL, NULL, NULL, NULL, &row, 1, NULL, NULL) == SINS_OK);
}

/* A struct with room behind it, to play a newer release's. */
#define ROOMY(type)             \
    union {                     \
        struct type value;      \
        unsigned char bytes[2 * sizeof(struct type)]; \
    }

/* Input: every size from 0 to twice the struct's, zero tail. Shorter than in the struct's first release is an error; longer
 * than in this one is fine while the tail is zero. */
#define INPUT_SIZES_SINCE(first, type, call)                                         \
    do {                                                                             \
        ROOMY(type) in;                                                              \
        size_t size;                                                                 \
        for (size = 0; size <= sizeof in; size++) {                                  \
            struct type *pointer = &in.value;                                        \
            int fits = size >= (first) && size % 8 == 0;                             \
            sins_status status;                                                      \
            memset(&in, 0, sizeof in);                                               \
            in.value.struct_size = (uint32_t)size;                                   \
            status = (call);                                                         \
            CHECK((status == SINS_ERROR_STRUCT_SIZE) == !fits);                      \
            if (fits && size > sizeof(struct type)) {                                \
                in.bytes[size - 1] = 1;                                              \
                CHECK((call) == SINS_ERROR_STRUCT_SIZE);                             \
            }                                                                        \
        }                                                                            \
        in.value.struct_size = 0xffffffffu;                                          \
        {                                                                            \
            struct type *pointer = &in.value;                                        \
            CHECK((call) == SINS_ERROR_STRUCT_SIZE);                                 \
        }                                                                            \
    } while (0)
#define INPUT_SIZES(type, call) INPUT_SIZES_SINCE(sizeof(struct type), type, call)

/* Output: what the host's struct has room for is written, struct_size stays, nothing behind is touched. */
#define OUTPUT_SIZES_SINCE(first, type, call)                                        \
    do {                                                                             \
        ROOMY(type) out;                                                             \
        size_t size, i;                                                              \
        for (size = 0; size <= sizeof out; size++) {                                 \
            struct type *pointer = &out.value;                                       \
            int fits = size >= (first) && size % 8 == 0;                             \
            size_t written = size < sizeof(struct type) ? size : sizeof(struct type);\
            sins_status status;                                                      \
            memset(&out, 0xa5, sizeof out);                                          \
            out.value.struct_size = (uint32_t)size;                                  \
            status = (call);                                                         \
            CHECK(status == (fits ? SINS_OK : SINS_ERROR_STRUCT_SIZE));              \
            CHECK(out.value.struct_size == size);                                    \
            for (i = fits ? written : 4; i < sizeof out; i++) {                      \
                CHECK(out.bytes[i] == 0xa5);                                         \
            }                                                                        \
        }                                                                            \
    } while (0)
#define OUTPUT_SIZES(type, call) OUTPUT_SIZES_SINCE(sizeof(struct type), type, call)

/* Of structs that have grown: their sizes in the first release. */
enum { FIRST_GYRO_PARAMS = 512, FIRST_ACCEL_PARAMS = 536, FIRST_FLIGHT_SAMPLE = 136 };

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

/* A second at rest, 1 m required; what is NULL is a good one. */
static sins_status recommend(const sins_requirement *requirement, sins_options *options, sins_cost *cost)
{
    sins_flight_sample piece[2] = {{.struct_size = sizeof piece[0]}};
    sins_requirement good_requirement = {.struct_size = sizeof good_requirement, .position_m = 1.0};
    sins_options good_options = {.struct_size = sizeof good_options};
    sins_cost good_cost = {.struct_size = sizeof good_cost};
    piece[1].time_s = 1.0;
    return sins_recommend(piece, 2, requirement ? requirement : &good_requirement, options ? options : &good_options,
                          cost ? cost : &good_cost);
}

/* The budget of that second; what is NULL is a good one, or none. */
struct question {
    const sins_options *options;
    const sins_gyro_params *gyro;
    const sins_accel_params *accel;
    const sins_altimeter_params *altimeter;
    const sins_initial_errors *initial;
    const sins_mounting *mounting;
    const sins_gravity_params *gravity;
    const sins_budget_request *request;
    sins_budget_row *row;
    sins_budget *budget;
};

static sins_status budget_of(struct question of)
{
    sins_flight_sample piece[2] = {{.struct_size = sizeof piece[0]}};
    sins_budget_row good_row = {.struct_size = sizeof good_row};
    piece[1].time_s = 1.0;
    return sins_error_budget(piece, 2, of.options, of.gyro, of.accel, of.altimeter, of.initial, of.mounting, of.gravity,
                             of.request, of.row ? of.row : &good_row, 1, NULL, of.budget);
}
#define BUDGET_OF(member) budget_of((struct question){.member = pointer})

static void struct_sizes(sins_sim *sim, sins_flight *flight)
{
    sins_sim *fresh = NULL;
    CHECK(sins_create(NULL, &fresh) == SINS_OK);
    INPUT_SIZES(sins_options, create_and_destroy(pointer));
    INPUT_SIZES_SINCE(FIRST_GYRO_PARAMS, sins_gyro_params, sins_set_gyro(fresh, pointer));
    INPUT_SIZES_SINCE(FIRST_ACCEL_PARAMS, sins_accel_params, sins_set_accel(fresh, pointer));
    INPUT_SIZES(sins_altimeter_params, sins_set_altimeter(fresh, pointer));
    INPUT_SIZES(sins_failure, sins_set_failure(fresh, SINS_SENSOR_ACCEL, 2, pointer));
    INPUT_SIZES(sins_initial_errors, sins_set_initial_errors(fresh, pointer));
    INPUT_SIZES(sins_mounting, sins_set_mounting(fresh, pointer));
    INPUT_SIZES(sins_gravity_params, sins_set_gravity_disturbance(fresh, pointer));
    INPUT_SIZES_SINCE(FIRST_FLIGHT_SAMPLE, sins_flight_sample, sins_reposition(fresh, pointer));
    CHECK(sins_reset(fresh) == SINS_OK);
    INPUT_SIZES(sins_navigation, sins_start_navigation(fresh, pointer));
    INPUT_SIZES(sins_imu_increment, sins_push_imu(fresh, pointer));
    CHECK(sins_destroy(fresh) == SINS_OK);
    INPUT_SIZES(sins_requirement, recommend(pointer, NULL, NULL));
    INPUT_SIZES(sins_options, recommend(NULL, pointer, NULL));

    INPUT_SIZES(sins_options, BUDGET_OF(options));
    INPUT_SIZES_SINCE(FIRST_GYRO_PARAMS, sins_gyro_params, BUDGET_OF(gyro));
    INPUT_SIZES_SINCE(FIRST_ACCEL_PARAMS, sins_accel_params, BUDGET_OF(accel));
    INPUT_SIZES(sins_altimeter_params, BUDGET_OF(altimeter));
    INPUT_SIZES(sins_initial_errors, BUDGET_OF(initial));
    INPUT_SIZES(sins_mounting, BUDGET_OF(mounting));
    INPUT_SIZES(sins_gravity_params, BUDGET_OF(gravity));
    INPUT_SIZES(sins_budget_request, BUDGET_OF(request));

    OUTPUT_SIZES(sins_cost, recommend(NULL, NULL, pointer));
    OUTPUT_SIZES(sins_budget_row, BUDGET_OF(row));
    OUTPUT_SIZES(sins_budget, BUDGET_OF(budget));
    OUTPUT_SIZES(sins_navigation, sins_get_truth(sim, pointer));
    OUTPUT_SIZES(sins_navigation, sins_get_navigation(sim, pointer));
    OUTPUT_SIZES(sins_imu, sins_get_imu(sim, pointer));
    OUTPUT_SIZES(sins_errors, sins_get_errors(sim, SINS_ERRORS_NAVIGATION, pointer));
    OUTPUT_SIZES(sins_errors, sins_get_errors(sim, SINS_ERRORS_MODEL, pointer));
    OUTPUT_SIZES(sins_accuracy, sins_get_accuracy(sim, pointer));
    OUTPUT_SIZES(sins_record, sins_get_record(sim, pointer));
    OUTPUT_SIZES(sins_options, sins_get_options(sim, pointer));
    OUTPUT_SIZES_SINCE(FIRST_GYRO_PARAMS, sins_gyro_params, sins_gyro_preset(SINS_GRADE_PAPER_SIMULATION2, pointer));
    OUTPUT_SIZES_SINCE(FIRST_ACCEL_PARAMS, sins_accel_params, sins_accel_preset(SINS_GRADE_PAPER_SIMULATION2, pointer));
    OUTPUT_SIZES_SINCE(FIRST_FLIGHT_SAMPLE, sins_flight_sample, sins_flight_sample_at(flight, 0.0, pointer));
}

/* Parameters of which element `index` of the field at `offset` is `value`. */
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

static void out_of_range(sins_sim *sim, const sins_gyro_params *gyro, const sins_accel_params *accel,
                         const char *sentence)
{
    char text[200];
    CHECK((gyro ? sins_set_gyro(sim, gyro) : sins_set_accel(sim, accel)) == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sins_last_error(sim, text, sizeof text, NULL) == SINS_OK);
    if (strcmp(text, sentence) != 0) {
        fprintf(stderr, "expected %s\nfound    %s\n", sentence, text);
    }
    CHECK(strcmp(text, sentence) == 0);
}

/* A failure that is refused leaves the sensor sound. */
static void bad_failure(sins_sim *sim, int32_t sensor, int32_t axis, const sins_failure *failure, const char *sentence)
{
    char text[200];
    CHECK(sins_set_failure(sim, sensor, axis, failure) == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sins_last_error(sim, text, sizeof text, NULL) == SINS_OK);
    if (strcmp(text, sentence) != 0) {
        fprintf(stderr, "expected %s\nfound    %s\n", sentence, text);
    }
    CHECK(strcmp(text, sentence) == 0);
}

static void failures(void)
{
    sins_sim *sim = NULL;
    sins_failure failure = {.struct_size = sizeof failure};
    sins_flight_sample sample = {.struct_size = sizeof sample};
    sins_imu imu = {.struct_size = sizeof imu};
    sins_navigation navigation = {.struct_size = sizeof navigation};
    int32_t axis;

    CHECK(sins_create(NULL, &sim) == SINS_OK);
    bad_failure(sim, 3, 0, &failure, "sensor = 3: must be a SINS_SENSOR_ constant, 0 to 2");
    bad_failure(sim, -1, 0, &failure, "sensor = -1: must be a SINS_SENSOR_ constant, 0 to 2");
    bad_failure(sim, SINS_SENSOR_GYRO, 3, &failure, "axis = 3: must be 0, 1 or 2: x, y or z");
    bad_failure(sim, SINS_SENSOR_ACCEL, -1, &failure, "axis = -1: must be 0, 1 or 2: x, y or z");
    bad_failure(sim, SINS_SENSOR_ALTIMETER, 1, &failure, "axis = 1: must be 0: the altimeter has one output");
    failure.kind = 7;
    bad_failure(sim, SINS_SENSOR_GYRO, 0, &failure, "failure.kind = 7: must be a SINS_FAILURE_ constant, 0 to 6");
    failure.kind = SINS_FAILURE_DEAD;
    failure.reserved2 = 1;
    bad_failure(sim, SINS_SENSOR_GYRO, 0, &failure, "failure.reserved2 = 1: must be 0");
    failure.reserved2 = 0;
    failure.size = 1.0;
    bad_failure(sim, SINS_SENSOR_GYRO, 0, &failure, "failure.size = 1: must be 0: not of this kind of failure");
    failure.kind = SINS_FAILURE_BIAS_STEP;
    failure.duration_s = 2.0;
    bad_failure(sim, SINS_SENSOR_GYRO, 0, &failure, "failure.duration_s = 2: must be 0: not of this kind of failure");
    failure.kind = SINS_FAILURE_SPIKES;
    failure.interval_s = 1.0;
    bad_failure(sim, SINS_SENSOR_GYRO, 0, &failure, "failure.duration_s = 2: must be at most failure.interval_s = 1");
    failure.size = failure.duration_s = 0.0;
    failure.kind = SINS_FAILURE_DROP_OUTS;
    failure.probability = 0.5;
    bad_failure(sim, SINS_SENSOR_GYRO, 0, &failure, "failure.probability = 0.5: must be 0: not of this kind of failure");
    failure.interval_s = failure.probability = 0.0;
    failure.density = -1.0;
    failure.kind = SINS_FAILURE_NOISE;
    bad_failure(sim, SINS_SENSOR_ALTIMETER, 0, &failure, "failure.density = -1: must be from 0 to 100000");

    /* None of those has been set; now all outputs are dead, and one sound again. */
    CHECK(sins_push_sample(sim, &sample) == SINS_OK);
    sample.time_s = 0.01;
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

/* A sample whose flag is forgotten while a sensor needs the temperature. */
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
    /* Level at rest, y north: nothing but the bias, 8 K of 0.125 m/s2 each, and gravity's north component at height 0, 0. */
    CHECK(imu.measured_force_m_s2[1] - imu.ideal_force_m_s2[1] > 0.999 && imu.measured_force_m_s2[1] < 1.001);
    CHECK(sins_destroy(sim) == SINS_OK);
}

/* What can be set before the first step alone, on a simulator that has made one and on a fresh one. */
static void mountings_and_gravity(sins_sim *stepped)
{
    sins_sim *fresh = NULL;
    sins_mounting mounting = {.struct_size = sizeof mounting};
    sins_gravity_params gravity = {.struct_size = sizeof gravity};
    char text[200];

    CHECK(sins_set_mounting(stepped, &mounting) == SINS_ERROR_BAD_STATE);
    CHECK(sins_set_gravity_disturbance(stepped, &gravity) == SINS_ERROR_BAD_STATE);

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
    CHECK(sins_last_error(sim, text, needed, NULL) == SINS_OK);
    CHECK(sins_last_error(sim, text, needed - 1, NULL) == SINS_ERROR_BUFFER_TOO_SMALL);

    /* Every field of the sensors has a range; a bandwidth of 0 is none, one of less than it can be is refused. */
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, rate_random_walk_rad_s_sqrt_s), 1, -1.0), NULL,
                 "gyro.rate_random_walk_rad_s_sqrt_s[1] = -1: must be from 0 to 100");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, rate_ramp_rad_s2), 0, 101.0), NULL,
                 "gyro.rate_ramp_rad_s2[0] = 101: must be from -100 to 100");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, flicker_rad_s), 2, -1e-9), NULL,
                 "gyro.flicker_rad_s[2] = -1e-9: must be from 0 to 100");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, quantization_rad), 2, 1e-16), NULL,
                 "gyro.quantization_rad[2] = 1e-16: must be from 1e-15 to 1");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, scale_factor_asymmetry), 0, 2.0), NULL,
                 "gyro.scale_factor_asymmetry[0] = 2: must be from -1 to 1");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, scale_factor_nonlinearity_s_rad), 1, -2.0), NULL,
                 "gyro.scale_factor_nonlinearity_s_rad[1] = -2: must be from -1 to 1");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, g_sensitivity_rad_s_per_m_s2), 5, 2.0), NULL,
                 "gyro.g_sensitivity_rad_s_per_m_s2[5] = 2: must be from -1 to 1");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, range_rad_s), 0, -1.0), NULL,
                 "gyro.range_rad_s[0] = -1: must be from 1e-9 to 1000000");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, bandwidth_hz), 1, 1e-4), NULL,
                 "gyro.bandwidth_hz[1] = 0.0001: must be from 0.001 to 1000000");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, dead_zone_rad_s), 2, -1.0), NULL,
                 "gyro.dead_zone_rad_s[2] = -1: must be from 0 to 100");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, acceleration_random_walk_m_s2_sqrt_s), 0, -1.0),
                 "accel.acceleration_random_walk_m_s2_sqrt_s[0] = -1: must be from 0 to 10000");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, ramp_m_s3), 1, 1e5),
                 "accel.ramp_m_s3[1] = 100000: must be from -10000 to 10000");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, flicker_m_s2), 0, -1.0),
                 "accel.flicker_m_s2[0] = -1: must be from 0 to 10000");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, quantization_m_s), 0, 2.0),
                 "accel.quantization_m_s[0] = 2: must be from 1e-15 to 1");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, scale_factor_asymmetry), 2, 2.0),
                 "accel.scale_factor_asymmetry[2] = 2: must be from -1 to 1");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, scale_factor_nonlinearity_s2_m), 0, 2.0),
                 "accel.scale_factor_nonlinearity_s2_m[0] = 2: must be from -1 to 1");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, range_m_s2), 0, 1e7),
                 "accel.range_m_s2[0] = 1e7: must be from 1e-9 to 1000000");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, bandwidth_hz), 0, 1e7),
                 "accel.bandwidth_hz[0] = 1e7: must be from 0.001 to 1000000");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, dead_zone_m_s2), 0, -1.0),
                 "accel.dead_zone_m_s2[0] = -1: must be from 0 to 10000");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, lever_arm_m), 7, 101.0),
                 "accel.lever_arm_m[7] = 101: must be from -100 to 100");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, reference_temperature_c), 0, -274.0), NULL,
                 "gyro.reference_temperature_c = -274: must be from -273.15 to 1000");
    out_of_range(sim, gyro_with(offsetof(sins_gyro_params, scale_factor_temperature2_per_k2), 2, 2.0), NULL,
                 "gyro.scale_factor_temperature2_per_k2[2] = 2: must be from -1 to 1");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, bias_temperature2_m_s2_per_k2), 1, 1e5),
                 "accel.bias_temperature2_m_s2_per_k2[1] = 100000: must be from -10000 to 10000");
    out_of_range(sim, NULL, accel_with(offsetof(sins_accel_params, vibration_rectification_s2_m), 2, 0.0 / zero),
                 "accel.vibration_rectification_s2_m[2] = NaN: must be a finite number");

    /* Every grade is one that can be set; there are no others. */
    {
        int32_t grade;
        for (grade = -1; grade <= 7; grade++) {
            sins_gyro_params gyros = {.struct_size = sizeof gyros};
            sins_accel_params accels = {.struct_size = sizeof accels};
            sins_status expected = grade >= SINS_GRADE_STRATEGIC && grade <= SINS_GRADE_PAPER_SIMULATION2
                                       ? SINS_OK
                                       : SINS_ERROR_INVALID_ARGUMENT;
            sins_sim *graded = NULL;
            CHECK(sins_gyro_preset(grade, &gyros) == expected && sins_accel_preset(grade, &accels) == expected);
            CHECK(sins_create(NULL, &graded) == SINS_OK);
            CHECK(sins_set_gyro(graded, &gyros) == SINS_OK && sins_set_accel(graded, &accels) == SINS_OK);
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
    handles();
    null_pointers(sim, flight);
    struct_sizes(sim, flight);
    sentences(sim);
    failures();
    temperatures();
    mountings_and_gravity(sim);

    CHECK(sins_get_navigation(sim, &after) == SINS_OK);
    CHECK(memcmp(&before, &after, sizeof before) == 0);
    CHECK(sins_destroy(sim) == SINS_OK);
    CHECK(sins_flight_destroy(flight) == SINS_OK);
    printf("misuse: every answer is the right one\n");
    return 0;
}
