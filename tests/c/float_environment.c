/* The host's floating-point state: whatever it is on entry, the results are the same bits and the state is back on exit.
 * Hosts unmask exceptions, round otherwise, and flush denormals. */

#include <stdint.h>
#include <string.h>

#include "check.h"
#include "sins.h"

#if defined(__x86_64__) || defined(__i386__)
#include <xmmintrin.h>
static unsigned control(void) { return _mm_getcsr(); }
static void set_control(unsigned value) { _mm_setcsr(value); }
/* Every exception unmasked; flush to zero and denormals are zero; round up, down, to zero; all of it at once. */
static const unsigned states[] = {0x0000, 0x9fc0, 0x5f80, 0x3f80, 0x7f80, 0xe040};
#elif defined(__aarch64__)
static unsigned control(void)
{
    uint64_t value;
    __asm__ volatile("mrs %0, fpcr" : "=r"(value));
    return (unsigned)value;
}
static void set_control(unsigned value)
{
    __asm__ volatile("msr fpcr, %0" ::"r"((uint64_t)value));
}
static const unsigned states[] = {1u << 24, 1u << 22, 2u << 22, 3u << 22};
#endif

static sins_flight_sample piece[129];

/* One second of a noisy flight; every function of the frame is called under the state. */
static void fly(unsigned state, sins_navigation *navigation, sins_errors *errors, sins_cost *cost)
{
    sins_sim *sim = NULL;
    sins_options options = {.struct_size = sizeof options};
    sins_gyro_params gyro = {.struct_size = sizeof gyro};
    sins_flight_start start = {.struct_size = sizeof start};
    sins_manoeuvre turn = {.struct_size = sizeof turn};
    sins_flight *flight = NULL;
    sins_requirement requirement = {.struct_size = sizeof requirement, .position_m = 1e-7};
    unsigned normal = control();
    int k;

    options.error_model = SINS_ERROR_MODEL_RK4;
    start.latitude_rad = 0.7;
    start.speed_m_s = 100.0;
    turn.kind = SINS_MANOEUVRE_TURN;
    turn.heading_change_rad = 1.0;
    turn.bank_rad = 0.5;
    CHECK(sins_gyro_preset(SINS_GRADE_PAPER_SIMULATION2, &gyro) == SINS_OK);
    gyro.markov_sigma_rad_s[1] = 1e-300; /* denormal products */
    gyro.markov_time_s[1] = 100.0;

    set_control(state);
    CHECK(sins_create(&options, &sim) == SINS_OK);
    CHECK(sins_set_gyro(sim, &gyro) == SINS_OK);
    CHECK(sins_flight_create(&start, &turn, 1, &flight) == SINS_OK);
    for (k = 0; k <= 128; k++) {
        sins_flight_sample sample = {.struct_size = sizeof sample};
        sins_status status;
        /* Exact in binary: the host's own arithmetic raises nothing and rounds nothing. */
        CHECK(sins_flight_sample_at(flight, k / 128.0, &sample) == SINS_OK);
        piece[k] = sample;
        CHECK(sins_push_sample(sim, &sample) == SINS_OK);
        status = sins_step(sim);
        CHECK(status == (k == 0 ? SINS_NEED_SAMPLE : SINS_OK));
    }
    CHECK(sins_get_navigation(sim, navigation) == SINS_OK);
    CHECK(sins_get_errors(sim, SINS_ERRORS_MODEL, errors) == SINS_OK);
    CHECK(sins_recommend(piece, 129, &requirement, &options, cost) == SINS_OK);
    cost->ns_per_step = 0.0; /* a time */
    CHECK(sins_flight_destroy(flight) == SINS_OK);
    CHECK(sins_destroy(sim) == SINS_OK);
    /* Control bits and noted exceptions alike. */
    CHECK(control() == state);
    set_control(normal);
}

int main(void)
{
    sins_navigation expected = {.struct_size = sizeof expected}, found = {.struct_size = sizeof found};
    sins_errors expected_errors = {.struct_size = sizeof expected_errors}, found_errors = {.struct_size = sizeof found_errors};
    sins_cost expected_cost = {.struct_size = sizeof expected_cost}, found_cost = {.struct_size = sizeof found_cost};
    size_t i;

    fly(control(), &expected, &expected_errors, &expected_cost);
    for (i = 0; i < sizeof states / sizeof states[0]; i++) {
        fly(states[i], &found, &found_errors, &found_cost);
        CHECK(memcmp(&expected, &found, sizeof expected) == 0);
        CHECK(memcmp(&expected_errors, &found_errors, sizeof expected_errors) == 0);
        CHECK(memcmp(&expected_cost, &found_cost, sizeof expected_cost) == 0);
    }
    printf("float_environment: same bits under %d states\n", (int)i);
    return 0;
}
