/*
 * sins_unit.h - the unit: an INS as the rest of an aircraft knows it, with a mode selector, an alignment that takes its time, and a
 * status. The conventions are those of sins.h.
 *
 * build/ writes this file; do not edit it.
 *
 * In each frame of a host:
 *
 *     sins_push_sample(sim, &sample);
 *     sins_step(sim);
 *     sins_unit_update(unit, sim);
 *     sins_unit_get_status(unit, &status);                state, annunciators, reasons, minutes to go
 *     sins_unit_get_navigation(unit, sim, &navigation);   what the box shows: an output that is not valid is 0
 *
 * States: OFF - test - coarse alignment - fine alignment - ready - navigation; ATT: erection - attitude. docs/unit.md shows them,
 * with a day's use.
 */

#ifndef SINS_UNIT_H
#define SINS_UNIT_H

#include "sins.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Units. */

@unit_params unit unit_status

/* Words of ARINC 429. */

@bus

/** Sizes of the structs in bytes, as enum sins_sizeof. */
enum sins_unit_sizeof {
@sizes
};

#ifdef __cplusplus
}
#endif

#endif /* SINS_UNIT_H */
