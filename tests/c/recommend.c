/* sins_recommend through the interface: which options come from the configured simulator and which are replaced, that the
 * simulator does not change, that the answer is the same twice, and that a rejected call writes nothing. */

#include <math.h>
#include <string.h>

#include "check.h"
#include "sins_analysis.h"
#include "sins_flight.h"
#include "small_stack.h"

enum { COUNT = 501 };

static sins_flight_sample piece[COUNT], sized[COUNT];

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
        sized[k] = piece[k];
        piece[k].struct_size = k == 0 ? sizeof piece[k] : 0;
    }
    CHECK(sins_flight_destroy(flight) == SINS_OK);
}

static void same_simulator(sins_sim *sim, const unsigned char *before, size_t size)
{
    static unsigned char after[SINS_SNAPSHOT_MAX_SIZE];
    size_t written = 0;
    CHECK(sins_snapshot_save(sim, after, sizeof after, &written) == SINS_OK);
    CHECK(written == size && memcmp(before, after, size) == 0);
}

static void answers(void)
{
    static unsigned char before[SINS_SNAPSHOT_MAX_SIZE];
    sins_requirement requirement = {.struct_size = sizeof requirement, .time_steps = 1, .position_m = 1e-4, .duration_s = 10.0};
    sins_options options = {.struct_size = sizeof options}, again = {.struct_size = sizeof again}, given;
    sins_cost cost = {.struct_size = sizeof cost}, other = {.struct_size = sizeof other};
    sins_mounting mounting = {.struct_size = sizeof mounting, .lever_arm_m = {20.0, 90.0, -50.0}};
    sins_sim *sim = NULL, *twin = NULL;
    size_t size = 0;
    int k;

    /* The options of the simulator are returned. The old values of the three recommended options do not matter, and neither
     * does the old content of the struct. */
    options.vertical = SINS_VERTICAL_FOLLOW_TRUTH;
    options.axes = SINS_AXES_FORWARD_RIGHT_DOWN;
    options.seed = 77;
    CHECK(sins_create(&options, &sim) == SINS_OK);
    SINS_INIT(given);
    CHECK(sins_get_options(sim, &given) == SINS_OK);
    options.scheme = SINS_SCHEME_PAPER;
    options.subsamples = 5;
    options.updates_per_sample = 16;
    CHECK(sins_create(&options, &twin) == SINS_OK);
    memset(&again.frame, 0x5a, sizeof again - 8);
    CHECK(sins_recommend(sim, piece, COUNT, &requirement, &options, &cost) == SINS_OK);
    CHECK(sins_recommend(twin, piece, COUNT, &requirement, &again, &other) == SINS_OK);
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

    /* A bank of 1 rad turns at g tan(1)/v = 0.076 rad/s, and has 1/cos(1) = 1.85 g. */
    CHECK(cost.rate_max_rad_s > 0.07 && cost.rate_max_at_s > 0.0 && cost.rate_max_at_s <= 10.0);
    CHECK(cost.force_max_m_s2 > 18.0 && cost.force_max_m_s2 < 18.3 && cost.vibration_max_rad_s2 > 0.0);

    /* Only time_steps measures the time; it changes nothing else. */
    requirement.time_steps = 0;
    CHECK(sins_recommend(sim, piece, COUNT, &requirement, &again, &other) == SINS_OK);
    CHECK(other.ns_per_step == 0.0);
    other.ns_per_step = cost.ns_per_step;
    CHECK(memcmp(&cost, &other, sizeof cost) == 0);

    /* A margin of 0 means 2. */
    requirement.margin = 2.0;
    CHECK(sins_recommend(sim, piece, COUNT, &requirement, &again, &other) == SINS_OK);
    CHECK(other.share == cost.share && other.tried == cost.tried);

    /* Away from the reference point there is more to integrate. The call also works in flight and does not change the flight. */
    CHECK(sins_set_mounting(sim, &mounting) == SINS_OK);
    for (k = 0; k < 3; k++) {
        CHECK(sins_push_sample(sim, &sized[k]) == SINS_OK);
    }
    CHECK(sins_step(sim) == SINS_OK);
    CHECK(sins_snapshot_save(sim, before, sizeof before, &size) == SINS_OK);
    CHECK(sins_recommend(sim, piece, COUNT, &requirement, &again, &other) == SINS_OK);
    CHECK(other.tried > cost.tried);
    same_simulator(sim, before, size);

    /* No algorithm meets the requirement: this is no error, and the best one is written; no cheaper one was as good. */
    requirement.position_m = 1e-12;
    CHECK(sins_recommend(sim, piece, COUNT, &requirement, &again, &other) == SINS_REQUIREMENT_NOT_MET);
    CHECK(other.share > 1.0 && other.tried > cost.tried);
    same_simulator(sim, before, size);
    CHECK(sins_destroy(sim) == SINS_OK && sins_destroy(twin) == SINS_OK);

    /* Without a simulator, the answer is that for the default options. */
    requirement.position_m = 1e-4;
    CHECK(sins_create(NULL, &sim) == SINS_OK);
    CHECK(sins_recommend(sim, piece, COUNT, &requirement, &options, &cost) == SINS_OK);
    CHECK(sins_recommend(NULL, piece, COUNT, &requirement, &again, &other) == SINS_OK);
    other.ns_per_step = cost.ns_per_step;
    CHECK(memcmp(&options, &again, sizeof options) == 0 && memcmp(&cost, &other, sizeof cost) == 0);
    CHECK(sins_destroy(sim) == SINS_OK);
}

static sins_status refused(const sins_sim *configured, const sins_flight_sample *samples, size_t count,
                           sins_requirement requirement, const char *sentence)
{
    sins_options options, options_before;
    sins_cost cost, cost_before;
    char text[512];
    sins_status status;
    memset(&options, 0x5a, sizeof options);
    memset(&cost, 0x5a, sizeof cost);
    options.struct_size = sizeof options;
    cost.struct_size = sizeof cost;
    options_before = options;
    cost_before = cost;
    status = sins_recommend(configured, samples, count, &requirement, &options, &cost);
    CHECK(memcmp(&options, &options_before, sizeof options) == 0);
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
    sins_requirement bad;
    sins_options options = {.struct_size = sizeof options};
    sins_sim *sim = NULL;
    sins_flight_sample samples[4];

#define BAD_REQUIREMENT(field, value, sentence)                                                          \
    do {                                                                                                 \
        bad = good;                                                                                      \
        bad.field = value;                                                                               \
        CHECK(refused(NULL, piece, COUNT, bad, sentence) == SINS_ERROR_INVALID_ARGUMENT);                \
    } while (0)
    BAD_REQUIREMENT(time_steps, 2, "requirement.time_steps = 2: must be from 0 to 1");
    BAD_REQUIREMENT(duration_s, -1.0, "requirement.duration_s = -1: must be from 0 to 1000000");
    BAD_REQUIREMENT(duration_s, 1e300, "requirement.duration_s = 1e300");
    BAD_REQUIREMENT(position_m, -1.0, "requirement.position_m = -1");
    BAD_REQUIREMENT(position_m, 0.0, "velocity_m_s or attitude_rad must be greater than 0");
    BAD_REQUIREMENT(velocity_m_s, NAN, "requirement.velocity_m_s = NaN: must be a finite number");
    BAD_REQUIREMENT(attitude_rad, INFINITY, "requirement.attitude_rad = inf: must be a finite number");
    BAD_REQUIREMENT(margin, 0.5, "requirement.margin = 0.5: must be from 1 to");
    BAD_REQUIREMENT(margin, -0.0 - 2.0, "requirement.margin = -2");

    CHECK(refused(NULL, piece, 0, good, "count = 0: must be from 2 to 360000") == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(refused(NULL, piece, 1, good, "count = 1") == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(refused(NULL, piece, 360001, good, "count = 360001") == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(refused(NULL, piece, (size_t)-1, good, "count = ") == SINS_ERROR_INVALID_ARGUMENT);

#define BAD_SAMPLE(index, field, value, status, sentence)                                                \
    do {                                                                                                 \
        memcpy(samples, piece, sizeof samples);                                                          \
        samples[index].field = value;                                                                    \
        CHECK(refused(NULL, samples, 4, good, sentence) == status);                                      \
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
    options.frame = SINS_FRAME_GEOGRAPHIC;
    CHECK(sins_create(&options, &sim) == SINS_OK);
    CHECK(refused(sim, samples, 2, good, "cosine of") == SINS_ERROR_SINGULAR);
    CHECK(sins_destroy(sim) == SINS_OK);
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
