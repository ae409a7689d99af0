/* A day of an INS: cold start, taxi, flight, fast realignment, second flight, off. It prints the states of the unit as they change.
 *
 *     unit_day         as fast as possible
 *     unit_day 1       in real time; unit_day 100: a hundred times as fast. The numbers are the same to the bit.
 */

#ifndef _WIN32
#define _POSIX_C_SOURCE 199309L
#include <time.h>
#endif
#include <stdio.h>
#include <stdlib.h>

#include "sins_flight.h"
#include "sins_unit.h"

#define RATE_HZ 20

static const char *const STATES[] = {"off",        "test",        "coarse alignment", "fine alignment", "ready",     "navigation",
                                     "realignment", "erection",    "attitude",         "fault",          "power-down"};

/* The day: manoeuvre, duration [s], change of speed [m/s] or heading [deg]. */
static const struct {
    int32_t kind;
    double duration_s, change;
} DAY[] = {
    {SINS_MANOEUVRE_REST, 400.0, 0.0},        {SINS_MANOEUVRE_ACCELERATE, 10.0, 6.0},    {SINS_MANOEUVRE_STRAIGHT, 120.0, 0.0},
    {SINS_MANOEUVRE_ACCELERATE, 60.0, 94.0},  {SINS_MANOEUVRE_STRAIGHT, 1500.0, 0.0},    {SINS_MANOEUVRE_TURN, 0.0, 180.0},
    {SINS_MANOEUVRE_STRAIGHT, 1500.0, 0.0},   {SINS_MANOEUVRE_ACCELERATE, 60.0, -100.0}, {SINS_MANOEUVRE_REST, 100.0, 0.0},
    {SINS_MANOEUVRE_ACCELERATE, 60.0, 100.0}, {SINS_MANOEUVRE_STRAIGHT, 1500.0, 0.0},    {SINS_MANOEUVRE_ACCELERATE, 60.0, -100.0},
    {SINS_MANOEUVRE_REST, 40.0, 0.0},
};
enum { MANOEUVRES = sizeof DAY / sizeof DAY[0] };

/* What the crew does: time, selector; the position is entered ten seconds after ALIGN. */
static const struct {
    double at_s;
    int32_t mode;
} CREW[] = {{5.0, SINS_UNIT_ALIGN}, {395.0, SINS_UNIT_NAV}, {3750.0, SINS_UNIT_ALIGN}, {3800.0, SINS_UNIT_NAV}, {5480.0, SINS_UNIT_OFF}};
enum { ACTIONS = sizeof CREW / sizeof CREW[0] };

static sins_flight *fly_day(void)
{
    sins_flight *flight = NULL;
    sins_flight_start start;
    sins_manoeuvre manoeuvres[MANOEUVRES];
    int i;
    SINS_INIT(start);
    start.latitude_rad = 10.0 * SINS_DEG;
    start.heading_rad = 30.0 * SINS_DEG;
    for (i = 0; i < MANOEUVRES; i++) {
        SINS_INIT(manoeuvres[i]);
        manoeuvres[i].kind = DAY[i].kind;
        manoeuvres[i].duration_s = DAY[i].duration_s;
        manoeuvres[i].speed_change_m_s = DAY[i].kind == SINS_MANOEUVRE_ACCELERATE ? DAY[i].change : 0.0;
        manoeuvres[i].heading_change_rad = DAY[i].kind == SINS_MANOEUVRE_TURN ? DAY[i].change * SINS_DEG : 0.0;
        manoeuvres[i].bank_rad = DAY[i].kind == SINS_MANOEUVRE_TURN ? 20.0 * SINS_DEG : 0.0;
    }
    sins_flight_create(&start, manoeuvres, MANOEUVRES, &flight);
    return flight;
}

/* Waits for the time of the next frame. */
static void wait_for_frame(double speed)
{
#ifndef _WIN32
    struct timespec frame;
    frame.tv_sec = 0;
    frame.tv_nsec = (long)(1e9 / RATE_HZ / speed);
    nanosleep(&frame, NULL);
#else
    (void)speed;
#endif
}

int main(int argc, char **argv)
{
    double speed = argc > 1 ? atof(argv[1]) : 0.0, duration_s = 0.0;
    sins_flight *flight = fly_day();
    sins_sim *sim = NULL;
    sins_unit *unit = NULL;
    sins_gyro_params gyro;
    sins_accel_params accel;
    sins_flight_sample sample;
    sins_unit_status status;
    sins_errors errors;
    int32_t state = -1;
    int action = 0, k;
    SINS_INIT(gyro), SINS_INIT(accel), SINS_INIT(sample), SINS_INIT(status), SINS_INIT(errors);
    sins_gyro_preset(SINS_GRADE_NAVIGATION, &gyro);
    sins_accel_preset(SINS_GRADE_NAVIGATION, &accel);
    if (sins_create(NULL, &sim) != SINS_OK || sins_unit_create(NULL, SINS_UNIT_OFF, &unit) != SINS_OK) return 1;
    if (sins_set_gyro(sim, &gyro) != SINS_OK || sins_set_accel(sim, &accel) != SINS_OK) return 1;
    if (sins_flight_duration(flight, &duration_s) != SINS_OK) return 1;
    for (k = 0; k <= duration_s * RATE_HZ; k++) {
        if (speed > 0.0) wait_for_frame(speed);
        if (sins_flight_sample_at(flight, (double)k / RATE_HZ, &sample) != SINS_OK) return 1;
        if (sins_push_sample(sim, &sample) < 0 || sins_step(sim) < 0) return 1;
        if (k > 0 && sins_unit_update(unit, sim) != SINS_OK) return 1;
        if (action < ACTIONS && sample.time_s >= CREW[action].at_s) sins_unit_select(unit, CREW[action++].mode);
        if (action > 0 && CREW[action - 1].mode == SINS_UNIT_ALIGN && sample.time_s == CREW[action - 1].at_s + 10.0)
            sins_unit_enter_position(unit, sample.latitude_rad, sample.longitude_rad);
        sins_unit_get_status(unit, &status);
        if (status.state != state) {
            sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &errors);
            printf("%6.0f s  %-17s %2d min  error %.17g m east, %.17g m north\n", sample.time_s, STATES[status.state],
                   (int)status.minutes_to_go, errors.position_enu_m[0], errors.position_enu_m[1]);
            state = status.state;
        }
    }
    return sins_unit_destroy(unit) == SINS_OK && sins_destroy(sim) == SINS_OK && sins_flight_destroy(flight) == SINS_OK ? 0 : 1;
}
