#include "failure_plan.h"

const struct planned_failure *failure_plan_overlap(const struct failure_plan *plan,
                                                   const struct planned_failure *failure)
{
    size_t i;

    for (i = 0; i < plan->count; i++) {
        const struct planned_failure *other = &plan->failures[i];

        if (other->sensor == failure->sensor && other->axis == failure->axis && other->from_s < failure->until_s
            && failure->from_s < other->until_s) {
            return other;
        }
    }
    return NULL;
}

static sins_status clear(const struct planned_failure *planned, sins_sim *sim)
{
    sins_failure none;

    SINS_INIT(none);
    return sins_set_failure(sim, planned->sensor, planned->axis, &none);
}

sins_status failure_plan_advance(const struct failure_plan *plan, struct failure_progress *progress, sins_sim *sim,
                                 double time_s, double slack_s)
{
    sins_status status = SINS_OK;
    size_t i;

    /* First what ends: the next failure of that output may begin at the same time. */
    for (i = 0; i < plan->count && status >= 0; i++) {
        if (progress->state[i] != FAILURE_IS_OVER && plan->failures[i].until_s <= time_s + slack_s) {
            status = progress->state[i] == FAILURE_LASTS ? clear(&plan->failures[i], sim) : SINS_OK;
            progress->state[i] = FAILURE_IS_OVER;
        }
    }
    for (i = 0; i < plan->count && status >= 0; i++) {
        const struct planned_failure *planned = &plan->failures[i];

        if (progress->state[i] == FAILURE_WAITS && planned->from_s <= time_s + slack_s) {
            status = sins_set_failure(sim, planned->sensor, planned->axis, &planned->failure);
            progress->state[i] = FAILURE_LASTS;
        }
    }
    return status;
}
