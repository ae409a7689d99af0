/* One function for each kind of manoeuvre of the built-in flights. Angles in degrees, right and up positive. */

#ifndef MANOEUVRES_H
#define MANOEUVRES_H

#include "sins.h"

sins_manoeuvre rest(double duration_s);
sins_manoeuvre straight(double duration_s);
sins_manoeuvre accelerate(double speed_change_m_s, double duration_s);
sins_manoeuvre climb(double height_change_m, double duration_s, double ramp_s);
sins_manoeuvre turn(double heading_change_deg, double bank_deg, double ramp_s);
sins_manoeuvre roll(double turns, double duration_s);
sins_manoeuvre loop(double turns, double duration_s, double ramp_s);
sins_manoeuvre s_turn(double heading_deg, double swings, double duration_s, double ramp_s);
sins_manoeuvre sinusoids(double duration_s, double ramp_s);

/* Adds to sinusoids(): amplitude [rad] or [m/s], period [s]; phase 0. */
void add_sinusoid(sins_manoeuvre *manoeuvre, int32_t channel, double amplitude, double period_s);

/* A coordinated turn at steady bank [s]; rolling in and out takes the ramp of turn() more. */
double turn_duration(double heading_change_deg, double speed_m_s, double bank_deg);

#endif
