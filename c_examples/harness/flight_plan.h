/* The built-in flights. */

#ifndef FLIGHT_PLAN_H
#define FLIGHT_PLAN_H

#include "sins.h"

enum { FLIGHT_PLAN_MANOEUVRES = 1024 };

struct flight_plan {
    sins_flight_start start;
    sins_manoeuvre manoeuvres[FLIGHT_PLAN_MANOEUVRES];
    size_t count;
};

/* Flights that repeat themselves last for duration_s, 0: an hour. 0, or -1: no such name. */
int flight_plan_named(struct flight_plan *plan, const char *name, double duration_s);

/* The simulations' motions. */
void flight_plan_rest(struct flight_plan *plan, double duration_s);
void flight_plan_patrol(struct flight_plan *plan, double duration_s);

/* What a flight is, in a line; empty for a name that is none. */
const char *flight_plan_line(const char *name);

/* The names with a line each, on standard output. */
void flight_plan_print_names(void);

#endif
