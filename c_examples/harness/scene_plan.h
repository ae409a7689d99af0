/* The manoeuvres and failures of a scene file, one after the other into the plans of the flight. */

#ifndef SCENE_PLAN_H
#define SCENE_PLAN_H

#include "settings.h"

/* A [[manoeuvre]] begins: nothing of it is set. */
void manoeuvre_begin(struct settings *set);

/* It is complete. 0, or -1 reported. */
int manoeuvre_take(struct settings *set);

/* Likewise a [[manoeuvre.sinusoid]]. */
void sinusoid_begin(struct settings *set);
int sinusoid_take(struct settings *set);

/* Likewise a [[failure]]. */
void failure_begin(struct settings *set);
int failure_take(struct settings *set);

#endif
