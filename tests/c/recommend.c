/* sins_recommend through the interface: what is kept and what is replaced, the same answer twice, and that a refused call has
 * written nothing. */

#include <limits.h>
#include <math.h>
#include <string.h>

#include "check.h"
#include "sins.h"
#include "small_stack.h"

enum { COUNT = 501 };

static sins_flight_sample piece[COUNT];

/* Ten seconds of a turn at 50 Hz; only the first sample states its size. */
static void make_piece(void)
{
    sins_flight_start start = {.struct_size = sizeof start};
    sins_manoeuvre turn = {.struct_size = sizeof turn};
    sins_flight *flight = NULL;
    int k;
    start.latitude_rad = 0.7;
    start.speed_m_s = 200.0;
    turn.kind = SINS_MANOEUVRE_TURN;
    turn.heading_change_rad = 1.5;
    turn.bank_rad = 1.0;
    turn.ramp_s = 1.0;
    CHECK(sins_flight_create(&start, &turn, 1, &flight) == SINS_OK);
    for (k = 0; k < COUNT; k++) {
        piece[k].struct_size = sizeof piece[k];
        CHECK(sins_flight_sample_at(flight, k / 50.0, &piece[k]) == SINS_OK);
        piece[k].struct_size = k == 0 ? sizeof piece[k] : 0;
    }
    CHECK(sins_flight_destroy(flight) == SINS_OK);
}

static void answers(void)
{
    sins_requirement requirement = {.struct_size = sizeof requirement, .position_m = 1e-4, .duration_s = 10.0};
    sins_options options = {.struct_size = sizeof options}, again, given;
    sins_cost cost = {.struct_size = sizeof cost}, other = {.struct_size = sizeof other};

    /* What the host flies with is kept, 0 as 0; what the three were does not matter. */
    options.vertical = SINS_VERTICAL_FOLLOW_TRUTH;
    options.axes = SINS_AXES_FORWARD_RIGHT_DOWN;
    options.seed = 77;
    given = again = options;
    again.scheme = SINS_SCHEME_PAPER;
    again.subsamples = 5;
    again.updates_per_sample = 16;
    CHECK(sins_recommend(piece, COUNT, &requirement, &options, &cost) == SINS_OK);
    CHECK(sins_recommend(piece, COUNT, &requirement, &again, &other) == SINS_OK);
    CHECK(memcmp(&options, &again, sizeof options) == 0);
    given.scheme = options.scheme;
    given.subsamples = options.subsamples;
    given.updates_per_sample = options.updates_per_sample;
    CHECK(memcmp(&options, &given, sizeof options) == 0);
    CHECK(options.subsamples >= 1 && options.updates_per_sample >= 1);

    CHECK(cost.struct_size == sizeof cost && cost.reserved == 0 && cost.duration_s == 10.0);
    CHECK(cost.position_m > 0.0 && 2.0 * cost.position_m <= 1e-4);
    CHECK(fabs(cost.share - 2.0 * cost.position_m / 1e-4) < 1e-12);
    CHECK(cost.velocity_m_s > 0.0 && cost.attitude_rad > 0.0);
    CHECK(cost.reference_position_m > 0.0 && cost.reference_position_m < cost.position_m);
    CHECK(cost.ns_per_step > 0.0 && cost.instructions_per_step > 0.0 && cost.tried > 1);
    other.ns_per_step = cost.ns_per_step;
    CHECK(memcmp(&cost, &other, sizeof cost) == 0);

    /* The margin of 0 is 2. */
    requirement.margin = 2.0;
    CHECK(sins_recommend(piece, COUNT, &requirement, &again, &other) == SINS_OK);
    CHECK(other.share == cost.share && other.tried == cost.tried);

    /* None meets it: no error, the best is written, and nothing cheaper was as good. */
    requirement.position_m = 1e-12;
    CHECK(sins_recommend(piece, COUNT, &requirement, &again, &other) == SINS_REQUIREMENT_NOT_MET);
    CHECK(other.share > 1.0 && other.position_m < cost.position_m && other.tried > cost.tried);
}

static sins_status refused(const sins_flight_sample *samples, size_t count, sins_requirement requirement,
                           sins_options options, const char *sentence)
{
    sins_options before = options;
    sins_cost cost, cost_before;
    char text[512];
    sins_status status;
    memset(&cost, 0x5a, sizeof cost);
    cost.struct_size = sizeof cost;
    cost_before = cost;
    status = sins_recommend(samples, count, &requirement, &options, &cost);
    CHECK(memcmp(&options, &before, sizeof options) == 0);
    CHECK(memcmp(&cost, &cost_before, sizeof cost) == 0);
    CHECK(sins_last_error(NULL, text, sizeof text, NULL) == SINS_OK);
    if (strstr(text, sentence) == NULL) {
        fprintf(stderr, "\"%s\" is not in \"%s\"\n", sentence, text);
        exit(1);
    }
    return status;
}

static void refusals(void)
{
    const sins_requirement good = {.struct_size = sizeof good, .position_m = 1.0};
    const sins_options zero = {.struct_size = sizeof zero};
    sins_requirement bad;
    sins_options options;
    sins_flight_sample samples[4];

#define BAD_REQUIREMENT(field, value, sentence)                                                          \
    do {                                                                                                 \
        bad = good;                                                                                      \
        bad.field = value;                                                                               \
        CHECK(refused(piece, COUNT, bad, zero, sentence) == SINS_ERROR_INVALID_ARGUMENT);                \
    } while (0)
    BAD_REQUIREMENT(reserved, 1, "requirement.reserved = 1: must be 0");
    BAD_REQUIREMENT(duration_s, -1.0, "requirement.duration_s = -1: must be from 0 to 1000000");
    BAD_REQUIREMENT(duration_s, 1e300, "requirement.duration_s = 1e300");
    BAD_REQUIREMENT(position_m, -1.0, "requirement.position_m = -1");
    BAD_REQUIREMENT(position_m, 0.0, "velocity_m_s or attitude_rad must be greater than 0");
    BAD_REQUIREMENT(velocity_m_s, NAN, "requirement.velocity_m_s = NaN: must be a finite number");
    BAD_REQUIREMENT(attitude_rad, INFINITY, "requirement.attitude_rad = inf: must be a finite number");
    BAD_REQUIREMENT(margin, 0.5, "requirement.margin = 0.5: must be from 1 to");
    BAD_REQUIREMENT(margin, -0.0 - 2.0, "requirement.margin = -2");

    CHECK(refused(piece, 0, good, zero, "count = 0: must be from 2 to 360000") == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(refused(piece, 1, good, zero, "count = 1") == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(refused(piece, 360001, good, zero, "count = 360001") == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(refused(piece, (size_t)-1, good, zero, "count = ") == SINS_ERROR_INVALID_ARGUMENT);

#define BAD_OPTION(field, value, sentence)                                                               \
    do {                                                                                                 \
        options = zero;                                                                                  \
        options.field = value;                                                                           \
        CHECK(refused(piece, COUNT, good, options, sentence) == SINS_ERROR_INVALID_ARGUMENT);            \
    } while (0)
    BAD_OPTION(frame, 7, "options.frame = 7");
    BAD_OPTION(scheme, -1, "options.scheme = -1");
    BAD_OPTION(subsamples, INT_MAX, "options.subsamples = ");
    BAD_OPTION(max_gap_s, NAN, "options.max_gap_s = NaN");
    BAD_OPTION(reserved, 5, "options.reserved = 5");
    BAD_OPTION(closed_loop_time_s, 5.0, "options.closed_loop_time_s = 5");

#define BAD_SAMPLE(index, field, value, status, sentence)                                                \
    do {                                                                                                 \
        memcpy(samples, piece, sizeof samples);                                                          \
        samples[index].field = value;                                                                    \
        CHECK(refused(samples, 4, good, zero, sentence) == status);                                      \
    } while (0)
    BAD_SAMPLE(2, latitude_rad, NAN, SINS_ERROR_INVALID_ARGUMENT, "(samples[2])");
    BAD_SAMPLE(3, flags, 0x80, SINS_ERROR_INVALID_ARGUMENT, "(samples[3])");
    BAD_SAMPLE(1, time_s, 0.0, SINS_ERROR_TIME_ORDER, "(samples[1])");
    BAD_SAMPLE(1, height_m, 9000.0, SINS_ERROR_DISCONTINUITY, "(samples[1])");
    BAD_SAMPLE(0, struct_size, 12, SINS_ERROR_STRUCT_SIZE, "sample.struct_size = 12");
    BAD_SAMPLE(2, struct_size, 12, SINS_ERROR_STRUCT_SIZE, "(samples[2])");

    /* Within 6.4 km of a pole, in geographic axes. */
    memset(samples, 0, sizeof samples);
    samples[0].struct_size = sizeof samples[0];
    samples[0].latitude_rad = samples[1].latitude_rad = 1.5705;
    samples[1].time_s = 0.1;
    options = zero;
    options.frame = SINS_FRAME_GEOGRAPHIC;
    CHECK(refused(samples, 2, good, options, "cosine of") == SINS_ERROR_SINGULAR);
}

int main(void)
{
    make_piece();
    answers();
    refusals();
    on_a_small_stack(answers);
    printf("recommend: kept, replaced, refused as it should be\n");
    return 0;
}
