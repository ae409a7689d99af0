/* Reader of a flight log: comma separated, columns by the names in its first line; '#' begins a comment line. */

#ifndef FLIGHT_CSV_H
#define FLIGHT_CSV_H

#include <stdio.h>

#include "sins.h"

/* time, latitude, longitude, height, 3 of velocity, roll, pitch, heading, 3 of angular rate, 3 of specific force,
 * temperature */
enum { FLIGHT_CSV_QUANTITIES = 17, FLIGHT_CSV_LINE = 65536, FLIGHT_CSV_TITLE = 160 };

struct flight_csv {
    FILE *stream;
    const char *path;
    long line;                          /* of the sample read last */
    int column[FLIGHT_CSV_QUANTITIES];  /* from 1; 0: not in this log */
    double unit[FLIGHT_CSV_QUANTITIES]; /* SI per unit of the column */
    uint32_t flags;                     /* SINS_SAMPLE_... of every sample */
    char title[FLIGHT_CSV_TITLE];       /* a comment in the first line; empty */
    char text[FLIGHT_CSV_LINE];
};

/* Opens a log and reads its header. 0, or -1 with FILE:LINE:COLUMN reported. */
int flight_csv_open(struct flight_csv *csv, const char *path);

/* 1: a sample; 0: the end; -1 reported as above. */
int flight_csv_next(struct flight_csv *csv, sins_flight_sample *sample);

void flight_csv_close(struct flight_csv *csv);

#endif
