/* A line of progress on a terminal. */

#ifndef PROGRESS_H
#define PROGRESS_H

#include <stddef.h>

struct progress {
    int shows;
    double duration_s;       /* simulated */
    double began_s, shown_s; /* wall clock */
};

void progress_begin(struct progress *progress, double duration_s, int quiet);

/* How far the simulated time has come. At most five lines a second. */
void progress_show(struct progress *progress, double time_s);

/* Clears the line. */
void progress_end(struct progress *progress);

/* "48 h", "20 h 10 min", "14 s" */
void duration_text(double duration_s, char *text, size_t capacity);

#endif
