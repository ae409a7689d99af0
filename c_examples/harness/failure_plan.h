/* Failures of sensors over the time of a flight. */

#ifndef FAILURE_PLAN_H
#define FAILURE_PLAN_H

#include <stddef.h>

#include "sins.h"

enum { FAILURE_PLAN_FAILURES = 64 };

struct planned_failure {
    int32_t sensor; /* SINS_SENSOR_... */
    int32_t axis;
    double from_s, until_s; /* since the begin of the flight */
    long line;              /* of the scene file */
    sins_failure failure;
};

/* Those of one output never overlap. */
struct failure_plan {
    struct planned_failure failures[FAILURE_PLAN_FAILURES];
    size_t count;
};

/* The planned failure of the same output that overlaps in time; NULL: none. */
const struct planned_failure *failure_plan_overlap(const struct failure_plan *plan,
                                                   const struct planned_failure *failure);

enum failure_state { FAILURE_WAITS, FAILURE_LASTS, FAILURE_IS_OVER };

/* How far the plan has been carried out. */
struct failure_progress {
    enum failure_state state[FAILURE_PLAN_FAILURES];
};

/* Before the step that begins at time_s: clears what ends by then, sets what begins. slack_s: what rounding may leave
 * of a time. */
sins_status failure_plan_advance(const struct failure_plan *plan, struct failure_progress *progress, sins_sim *sim,
                                 double time_s, double slack_s);

#endif
