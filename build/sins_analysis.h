/*
 * sins_analysis.h - questions about a flight: which options it needs, which effects of the sensors matter, and which errors
 * real sensors have. The conventions are those of sins.h.
 *
 * A library that was built without the feature "identify" lacks all functions sins_identify_....
 *
 * build/ writes this file; do not edit it.
 */

#ifndef SINS_ANALYSIS_H
#define SINS_ANALYSIS_H

#include "sins.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Which options, which effects matter. */

@recommend budget_answer budget

/* The errors of real sensors. */

@identify identify/check

/** Sizes of the structs in bytes, as enum sins_sizeof. */
enum sins_analysis_sizeof {
@sizes
};

#ifdef __cplusplus
}
#endif

#endif /* SINS_ANALYSIS_H */
