/* sins_error_budget through the interface: which effects have a row, how many rows are needed, and that a rejected call
 * writes nothing. */

#include <math.h>
#include <string.h>

#include "check.h"
#include "sins_analysis.h"
#include "small_stack.h"

enum { COUNT = 201, ROWS = 10 };

static sins_flight_sample piece[COUNT];
static sins_sim *sim;
static sins_gyro_params gyro = {.struct_size = sizeof gyro};
static sins_accel_params accel = {.struct_size = sizeof accel};
static sins_altimeter_params altimeter = {.struct_size = sizeof altimeter};
static sins_initial_errors initial = {.struct_size = sizeof initial};
static sins_mounting mounting = {.struct_size = sizeof mounting};
static sins_gravity_params gravity = {.struct_size = sizeof gravity};

static void make_scene(void)
{
    int k;
    for (k = 0; k < COUNT; k++) {
        piece[k].struct_size = k == 0 ? sizeof piece[k] : 0;
        piece[k].time_s = 0.1 * k;
        piece[k].latitude_rad = 0.7;
    }
    gyro.bias_rad_s[0] = 1.0 * SINS_DEG_PER_HOUR;
    gyro.markov_time_s[0] = 100.0; /* without a process: no row */
    accel.velocity_random_walk_m_s_sqrt_s[1] = 1e-3;
    altimeter.noise_m = 1.0;
    initial.position_enu_m[1] = 7.0;
    mounting.lever_arm_m[0] = 3.0; /* the true lever arm, not an error: no row */
    mounting.boresight_rad[2] = 1.0;
    mounting.boresight_error_rad[2] = 1.0 * SINS_ARCMIN;
    gravity.deflection_north_rad = 10.0 * SINS_ARCSEC;
    gravity.anomaly_distance_m = 1e4; /* without a field: no row */
    CHECK(sins_create(NULL, &sim) == SINS_OK);
    CHECK(sins_set_gyro(sim, &gyro) == SINS_OK && sins_set_accel(sim, &accel) == SINS_OK);
    CHECK(sins_set_altimeter(sim, &altimeter) == SINS_OK && sins_set_initial_errors(sim, &initial) == SINS_OK);
    CHECK(sins_set_mounting(sim, &mounting) == SINS_OK && sins_set_gravity_disturbance(sim, &gravity) == SINS_OK);
}

static sins_status ask(const sins_budget_request *request, sins_budget_row *rows, size_t capacity, size_t *written,
                       sins_budget *budget)
{
    return sins_error_budget(sim, piece, COUNT, request, rows, capacity, written, budget);
}

static const sins_budget_row *row_of(const sins_budget_row *rows, const char *field)
{
    int k;
    for (k = 0; k < ROWS; k++) {
        if (strcmp(rows[k].field, field) == 0) {
            return &rows[k];
        }
    }
    fprintf(stderr, "no row of %s\n", field);
    exit(1);
}

static void answers(void)
{
    sins_budget_row rows[ROWS];
    sins_budget budget = {.struct_size = sizeof budget}, again = {.struct_size = sizeof again};
    sins_budget_request request = {.struct_size = sizeof request, .time_steps = 1, .position_m = 1.0, .runs = 8};
    const sins_budget_row *row;
    size_t written = 0;

    memset(rows, 0, sizeof rows);
    CHECK(ask(NULL, NULL, 0, &written, NULL) == SINS_ERROR_BUFFER_TOO_SMALL && written == 7);
    rows[0].struct_size = sizeof rows[0];
    CHECK(ask(&request, rows, ROWS, &written, &budget) == SINS_OK && written == 7);
    CHECK(strcmp(rows[0].effect, "mechanization") == 0 && rows[0].flags == 0 && rows[0].position_m < 1e-6);
    CHECK(strcmp(rows[1].effect, "initial position") == 0 && fabs(rows[1].position_m - 7.0) < 0.01);
    CHECK(!(rows[1].flags & SINS_BUDGET_CAN_BE_LEFT_OUT) && fabs(rows[1].share - rows[1].position_m) < 1e-12);
    row = row_of(rows, "gyro.bias_rad_s");
    CHECK(fabs(row->end_attitude_rad / (gyro.bias_rad_s[0] * 20.0) - 1.0) < 0.01 && !(row->flags & SINS_BUDGET_RANDOM));
    CHECK(row->flags & SINS_BUDGET_CAN_BE_LEFT_OUT);
    row = row_of(rows, "altimeter.noise_m");
    CHECK(row->flags & SINS_BUDGET_RANDOM && row->position_m > 0.0);
    row = row_of(rows, "mounting.boresight_error_rad"); /* only a wrong heading */
    CHECK(fabs(row->attitude_rad / mounting.boresight_error_rad[2] - 1.0) < 1e-3);
    CHECK(strcmp(row->effect, "boresight error") == 0 && !(row->flags & SINS_BUDGET_RANDOM));
    row = row_of(rows, "gravity.deflection_north_rad"); /* g xi t^2/2 */
    CHECK(fabs(row->end_position_m / (9.8 * gravity.deflection_north_rad * 200.0) - 1.0) < 0.01);
    CHECK(rows[7].struct_size == 0);
    CHECK(budget.runs == 8 && budget.flights == 1 + 6 + 8 * 2 + 8 && budget.ns_per_step > 0.0);
    CHECK(fabs(budget.duration_s - 20.0) < 1e-9 && budget.position_m > 6.9);
    CHECK(budget.left_out_position_m > 0.0 && budget.left_out_position_m <= 1.0);
    CHECK(budget.sigma_low < 1.0 && budget.sigma_high > 1.0);

    /* The same samples give the same answer, also with NULL for `written`. */
    CHECK(ask(&request, rows, ROWS, NULL, &again) == SINS_OK);
    again.ns_per_step = budget.ns_per_step;
    CHECK(memcmp(&budget, &again, sizeof budget) == 0);
}

static sins_status refused(const sins_budget_request *request, size_t count, size_t capacity, const char *sentence)
{
    sins_budget_row rows[ROWS], rows_before[ROWS];
    sins_budget budget, budget_before;
    char text[512];
    sins_status status;
    memset(rows, 0x5a, sizeof rows);
    rows[0].struct_size = sizeof rows[0];
    memset(&budget, 0x5a, sizeof budget);
    budget.struct_size = sizeof budget;
    memcpy(rows_before, rows, sizeof rows);
    budget_before = budget;
    status = sins_error_budget(sim, piece, count, request, rows, capacity, NULL, &budget);
    CHECK(memcmp(rows, rows_before, sizeof rows) == 0 && memcmp(&budget, &budget_before, sizeof budget) == 0);
    CHECK(sins_last_error(NULL, text, sizeof text, NULL) == SINS_OK);
    if (strstr(text, sentence) == NULL) {
        fprintf(stderr, "\"%s\" is not in \"%s\"\n", sentence, text);
        exit(1);
    }
    return status;
}

static void refusals(void)
{
    const sins_budget_request good = {.struct_size = sizeof good};
    sins_budget_request bad;

#define BAD_REQUEST(member, value, sentence)                                                             \
    do {                                                                                                 \
        bad = good;                                                                                      \
        bad.member = value;                                                                              \
        CHECK(refused(&bad, COUNT, ROWS, sentence) == SINS_ERROR_INVALID_ARGUMENT);                      \
    } while (0)
    BAD_REQUEST(time_steps, 2, "request.time_steps = 2: must be from 0 to 1");
    BAD_REQUEST(runs, 7, "request.runs = 7: must be from 8 to 1000");
    BAD_REQUEST(runs, UINT64_MAX, "request.runs = 18446744073709551615: must be from 8 to 1000");
    BAD_REQUEST(position_m, -1.0, "request.position_m = -1");
    BAD_REQUEST(velocity_m_s, NAN, "request.velocity_m_s = NaN: must be a finite number");
    BAD_REQUEST(attitude_rad, INFINITY, "request.attitude_rad = inf");
    CHECK(refused(&good, 0, ROWS, "count = 0") == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(refused(&good, 1, ROWS, "count = 1") == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(refused(&good, (size_t)-1, ROWS, "count = ") == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(refused(&good, COUNT, 4, "capacity = 4: is too small; needed: 7") == SINS_ERROR_BUFFER_TOO_SMALL);

    piece[9].flags = 0x80;
    CHECK(refused(&good, COUNT, ROWS, "(samples[9])") == SINS_ERROR_INVALID_ARGUMENT);
    piece[9].flags = 0;
    piece[9].struct_size = 12;
    CHECK(refused(&good, COUNT, ROWS, "(samples[9])") == SINS_ERROR_STRUCT_SIZE);
    piece[9].struct_size = 0;
    piece[9].height_m = 9000.0;
    CHECK(refused(&good, COUNT, ROWS, "(samples[9])") == SINS_ERROR_DISCONTINUITY);
    piece[9].height_m = 0.0;
    piece[9].time_s = 0.8;
    CHECK(refused(&good, COUNT, ROWS, "(samples[9])") == SINS_ERROR_TIME_ORDER);
    piece[9].time_s = 0.9;
}

/* The answer is the same in flight and with a failure, because a failure is not an effect. */
static void fly(void)
{
    sins_failure dead = {.struct_size = sizeof dead, .kind = SINS_FAILURE_DEAD};
    size_t size = 0, again = 0;
    CHECK(sins_run(sim, piece, 20, 0, NULL, 0, NULL) == SINS_OK);
    CHECK(sins_set_failure(sim, SINS_SENSOR_GYRO, 2, &dead) == SINS_OK && sins_step(sim) == SINS_NEED_SAMPLE);
    CHECK(sins_snapshot_size(sim, &size) == SINS_OK);
    answers();
    CHECK(sins_snapshot_size(sim, &again) == SINS_OK && again == size);
}

int main(void)
{
    make_scene();
    answers();
    refusals();
    answers();
    fly();
    on_a_small_stack(answers);
    CHECK(sins_destroy(sim) == SINS_OK);
    CHECK(ask(NULL, NULL, 0, NULL, NULL) == SINS_ERROR_BAD_HANDLE);
    printf("budget: rows, refusals and limits as they should be\n");
    return 0;
}
