/* The figures of a flight: as NAME_summary.csv and as a table. */

#ifndef SUMMARY_H
#define SUMMARY_H

#include "fly.h"

struct summary {
    const struct settings *set;
    const struct scene *scene;
    const struct flown *flown;
    sins_accuracy accuracy;
    const char *version;
    char scheme[16], frame[16], signal[16], vertical[16], earth[16], gravity[16], axes[16];
    int subsamples, updates;
    double rate_hz, every_s, ns_per_step;
    char scene_text[VALUE_TEXT_SIZE];
    char gyro[2048], accel[2048], altimeter[512], start[512], mounting[512], gravity_disturbance[512];
    char failures[FAILURE_PLAN_FAILURES * 80];
};

/* Gathers the figures. DONE, or FAILED reported. */
int summary_gather(struct summary *sum, sins_sim *sim, const struct settings *set, const struct scene *scene,
                   const struct flown *flown);

void summary_write(const struct summary *sum, struct whole_file *file);
void summary_print(const struct summary *sum, const char *records_path);

#endif
