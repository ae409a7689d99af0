/*
 * sins_analysis.h - questions about a flight: which options it needs, and which effects of the sensors matter. The conventions are
 * those of sins.h.
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

/** Sizes of the structs in bytes, as enum sins_sizeof. */
enum sins_analysis_sizeof {
@sizes
};

#ifdef __cplusplus
}
#endif

#endif /* SINS_ANALYSIS_H */
