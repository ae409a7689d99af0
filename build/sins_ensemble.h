/*
 * sins_ensemble.h - ensembles: many runs of one simulator over the same samples, and the statistics of their errors. The
 * conventions are those of sins.h.
 *
 * build/ writes this file; do not edit it.
 */

#ifndef SINS_ENSEMBLE_H
#define SINS_ENSEMBLE_H

#include "sins.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Ensembles. */

@ensemble ../ensemble/statistics/layout ensemble_read statistics ensemble_snapshot

/** Sizes of the structs in bytes, as enum sins_sizeof. */
enum sins_ensemble_sizeof {
@sizes
};

#ifdef __cplusplus
}
#endif

#endif /* SINS_ENSEMBLE_H */
