#include "manoeuvres.h"

#include <math.h>
#include <string.h>

static sins_manoeuvre manoeuvre_of(int32_t kind, double duration_s, double ramp_s)
{
    sins_manoeuvre manoeuvre;

    memset(&manoeuvre, 0, sizeof manoeuvre);
    manoeuvre.struct_size = sizeof manoeuvre;
    manoeuvre.kind = kind;
    manoeuvre.duration_s = duration_s;
    manoeuvre.ramp_s = ramp_s;
    return manoeuvre;
}

sins_manoeuvre rest(double duration_s)
{
    return manoeuvre_of(SINS_MANOEUVRE_REST, duration_s, 0);
}

sins_manoeuvre straight(double duration_s)
{
    return manoeuvre_of(SINS_MANOEUVRE_STRAIGHT, duration_s, 0);
}

sins_manoeuvre accelerate(double speed_change_m_s, double duration_s)
{
    sins_manoeuvre manoeuvre = manoeuvre_of(SINS_MANOEUVRE_ACCELERATE, duration_s, 0);

    manoeuvre.speed_change_m_s = speed_change_m_s;
    return manoeuvre;
}

sins_manoeuvre climb(double height_change_m, double duration_s, double ramp_s)
{
    sins_manoeuvre manoeuvre = manoeuvre_of(SINS_MANOEUVRE_CLIMB, duration_s, ramp_s);

    manoeuvre.height_change_m = height_change_m;
    return manoeuvre;
}

sins_manoeuvre turn(double heading_change_deg, double bank_deg, double ramp_s)
{
    sins_manoeuvre manoeuvre = manoeuvre_of(SINS_MANOEUVRE_TURN, 0, ramp_s);

    manoeuvre.heading_change_rad = heading_change_deg * SINS_DEG;
    manoeuvre.bank_rad = bank_deg * SINS_DEG;
    return manoeuvre;
}

sins_manoeuvre roll(double turns, double duration_s)
{
    sins_manoeuvre manoeuvre = manoeuvre_of(SINS_MANOEUVRE_ROLL, duration_s, 0);

    manoeuvre.turns = turns;
    return manoeuvre;
}

sins_manoeuvre loop(double turns, double duration_s, double ramp_s)
{
    sins_manoeuvre manoeuvre = manoeuvre_of(SINS_MANOEUVRE_LOOP, duration_s, ramp_s);

    manoeuvre.turns = turns;
    return manoeuvre;
}

sins_manoeuvre s_turn(double heading_deg, double swings, double duration_s, double ramp_s)
{
    sins_manoeuvre manoeuvre = manoeuvre_of(SINS_MANOEUVRE_S_TURN, duration_s, ramp_s);

    manoeuvre.heading_change_rad = heading_deg * SINS_DEG;
    manoeuvre.turns = swings;
    return manoeuvre;
}

sins_manoeuvre sinusoids(double duration_s, double ramp_s)
{
    return manoeuvre_of(SINS_MANOEUVRE_SINUSOIDS, duration_s, ramp_s);
}

void add_sinusoid(sins_manoeuvre *manoeuvre, int32_t channel, double amplitude, double period_s)
{
    int32_t i = manoeuvre->sinusoid_count++;

    manoeuvre->channel[i] = channel;
    manoeuvre->amplitude[i] = amplitude;
    manoeuvre->frequency_hz[i] = 1 / period_s;
}

double turn_duration(double heading_change_deg, double speed_m_s, double bank_deg)
{
    return fabs(heading_change_deg) * SINS_DEG * speed_m_s / (SINS_STANDARD_GRAVITY * tan(bank_deg * SINS_DEG));
}
