/*
 * sins_flight.h - embedded flights: the library computes the samples from manoeuvres; and a judge of samples, which finds what is wrong
 * with them. The conventions are those of sins.h.
 *
 * build/ writes this file; do not edit it.
 */

#ifndef SINS_FLIGHT_H
#define SINS_FLIGHT_H

#include "sins.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Embedded flights. */

@manoeuvre flight

/* Judges of samples. */

@judge

/** Sizes of the structs in bytes, as enum sins_sizeof. */
enum sins_flight_sizeof {
@sizes
};

#ifdef __cplusplus
}
#endif

#endif /* SINS_FLIGHT_H */
