#include "flight_plan.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "manoeuvres.h"

static void begin(struct flight_plan *plan, double latitude_deg, double longitude_deg, double height_m,
                  double speed_m_s, double heading_deg)
{
    memset(plan, 0, sizeof *plan);
    plan->start.struct_size = sizeof plan->start;
    plan->start.latitude_rad = latitude_deg * SINS_DEG;
    plan->start.longitude_rad = longitude_deg * SINS_DEG;
    plan->start.height_m = height_m;
    plan->start.speed_m_s = speed_m_s;
    plan->start.heading_rad = heading_deg * SINS_DEG;
}

static void add(struct flight_plan *plan, sins_manoeuvre manoeuvre)
{
    if (plan->count < FLIGHT_PLAN_MANOEUVRES) {
        plan->manoeuvres[plan->count++] = manoeuvre;
    }
}

void flight_plan_rest(struct flight_plan *plan, double duration_s)
{
    begin(plan, 39.9, 116.4, 50, 0, 0);
    add(plan, rest(duration_s));
}

void flight_plan_patrol(struct flight_plan *plan, double duration_s)
{
    /* The ramp keeps the bank below 30 degrees while the eights set in; a short flight must not shorten it. */
    const double ramp_s = 300;
    sins_manoeuvre eights = sinusoids(fmax(duration_s, 4 * ramp_s), ramp_s);

    begin(plan, 40, 116.4, 8000, 200, 0);
    /* The first zero of J0: the mean of cos(amplitude sin x) vanishes, so the eights close. */
    add_sinusoid(&eights, SINS_CHANNEL_COURSE, 2.404825557695773, 560);
    add_sinusoid(&eights, SINS_CHANNEL_CLIMB, 0.02, 903);
    add_sinusoid(&eights, SINS_CHANNEL_SPEED, 4, 1370);
    add_sinusoid(&eights, SINS_CHANNEL_ROLL, 0.25 * SINS_DEG, 5.3);
    add_sinusoid(&eights, SINS_CHANNEL_PITCH, 0.2 * SINS_DEG, 7.7);
    add(plan, eights);
}

static void racetrack(struct flight_plan *plan, double duration_s)
{
    double lap_s = 2 * (300 + 5 + turn_duration(180, 200, 25));
    int laps = (int)ceil(duration_s / lap_s), i;

    begin(plan, 40, 116.4, 6000, 200, 90);
    for (i = 0; i < 2 * laps && i < FLIGHT_PLAN_MANOEUVRES / 2; i++) {
        add(plan, straight(300));
        add(plan, turn(180, 25, 5));
    }
}

static void aerobatics(struct flight_plan *plan, double duration_s)
{
    (void)duration_s;
    begin(plan, 36.2, -115, 4500, 180, 90);
    add(plan, straight(10));
    add(plan, loop(1, 26, 4));
    add(plan, straight(5));
    add(plan, roll(1, 4));
    add(plan, roll(-2, 6));
    add(plan, turn(180, 70, 1.5));
    add(plan, s_turn(45, 4, 80, 5));
    add(plan, accelerate(40, 20));
    add(plan, climb(1500, 30, 4));
    add(plan, loop(2, 60, 4));
    add(plan, roll(3, 6));
    add(plan, turn(-270, 65, 2));
    add(plan, climb(-1500, 30, 4));
    add(plan, accelerate(-40, 20));
    add(plan, loop(1, 26, 4));
    add(plan, roll(-1, 3));
    add(plan, straight(10));
}

static void over_the_pole(struct flight_plan *plan, double duration_s)
{
    (void)duration_s;
    begin(plan, 89.4, 20, 11000, 250, 0);
    add(plan, straight(600));
    add(plan, turn(180, 25, 5));
    add(plan, s_turn(20, 3, 600, 20));
}

static void coning(struct flight_plan *plan, double duration_s)
{
    sins_manoeuvre cone = sinusoids(duration_s, 10);

    begin(plan, 40, 116.4, 50, 0, 0);
    add_sinusoid(&cone, SINS_CHANNEL_ROLL, 5 * SINS_DEG, 2);
    add_sinusoid(&cone, SINS_CHANNEL_PITCH, 5 * SINS_DEG, 2);
    cone.phase_rad[1] = 90 * SINS_DEG;
    add(plan, cone);
}

static void commuter(struct flight_plan *plan, double duration_s)
{
    (void)duration_s;
    begin(plan, 40.0725, 116.5975, 30, 0, 0);
    add(plan, rest(60));
    add(plan, accelerate(80, 45)); /* take-off roll */
    add(plan, climb(1500, 180, 15));
    add(plan, accelerate(60, 60));
    add(plan, turn(90, 25, 8));
    add(plan, climb(4500, 400, 15));
    add(plan, accelerate(60, 90));
    add(plan, turn(-60, 20, 8));
    add(plan, straight(600)); /* cruise */
    add(plan, turn(120, 25, 8));
    add(plan, straight(300));
    add(plan, climb(-4500, 500, 15)); /* descent */
    add(plan, accelerate(-60, 90));
    add(plan, turn(90, 25, 8));
    add(plan, climb(-1200, 200, 15));
    add(plan, accelerate(-65, 90));
    add(plan, turn(30, 20, 8));
    add(plan, climb(-300, 100, 15)); /* final approach */
    add(plan, straight(5));
    add(plan, accelerate(-75, 45)); /* landing roll */
    add(plan, rest(60));
}

struct named_plan {
    const char *name;
    const char *line;
    void (*fill)(struct flight_plan *plan, double duration_s);
};

static const struct named_plan named_plans[] = {
    { "rest", "at rest, level, heading north", flight_plan_rest },
    { "patrol", "closed figure-eights at 8000 m and 200 m/s, bank below 30 degrees", flight_plan_patrol },
    { "racetrack", "straight legs of 300 s and half turns at 25 degrees of bank", racetrack },
    { "aerobatics", "loops, rolls, S-turns, climbs, turns at 70 degrees of bank", aerobatics },
    { "over_the_pole", "over the north pole at 11 km and 250 m/s, and back to it", over_the_pole },
    { "coning", "5 degrees of roll and pitch a quarter period apart, 0.5 Hz, on the spot", coning },
    { "commuter", "take-off roll, climb, turns, cruise, descent, landing, stop", commuter }
};

enum { NAMED_PLANS = sizeof named_plans / sizeof named_plans[0] };

void flight_plan_print_names(void)
{
    int i;

    for (i = 0; i < NAMED_PLANS; i++) {
        printf("%-14s %s\n", named_plans[i].name, named_plans[i].line);
    }
}

const char *flight_plan_line(const char *name)
{
    int i;

    for (i = 0; i < NAMED_PLANS; i++) {
        if (strcmp(named_plans[i].name, name) == 0) {
            return named_plans[i].line;
        }
    }
    return "";
}

int flight_plan_named(struct flight_plan *plan, const char *name, double duration_s)
{
    int i;

    for (i = 0; i < NAMED_PLANS; i++) {
        if (strcmp(named_plans[i].name, name) == 0) {
            named_plans[i].fill(plan, duration_s > 0 ? duration_s : 3600);
            return 0;
        }
    }
    return -1;
}
