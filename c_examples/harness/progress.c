#include "progress.h"

#include <math.h>
#include <stdio.h>

#include "host.h"

void duration_text(double duration_s, char *text, size_t capacity)
{
    double minutes = (double)(long)(duration_s / 60 + 0.5);
    long hours = (long)(minutes / 60);

    if (duration_s < 99.5) {
        snprintf(text, capacity, "%.3g s", duration_s);
    } else if (minutes < 60) {
        snprintf(text, capacity, "%.0f min", minutes);
    } else if (minutes == 60.0 * (double)hours) {
        snprintf(text, capacity, "%ld h", hours);
    } else {
        snprintf(text, capacity, "%ld h %.0f min", hours, minutes - 60.0 * (double)hours);
    }
}

void progress_begin(struct progress *progress, double duration_s, int quiet)
{
    progress->shows = !quiet && host_has_terminal();
    progress->duration_s = duration_s;
    progress->began_s = progress->shown_s = host_seconds();
}

void progress_show(struct progress *progress, double time_s)
{
    double now_s = host_seconds(), left_s;
    char flown[32], whole[32], left[32];

    if (!progress->shows || now_s - progress->shown_s < 0.2 || time_s <= 0) {
        return;
    }
    progress->shown_s = now_s;
    duration_text(time_s, flown, sizeof flown);
    duration_text(progress->duration_s, whole, sizeof whole);
    left_s = (now_s - progress->began_s) * (progress->duration_s / time_s - 1);
    duration_text(floor(left_s + 0.5), left, sizeof left);
    fprintf(stderr, "\r%3.0f %%  %s of %s, %s left   ", 100 * time_s / progress->duration_s, flown, whole, left);
    fflush(stderr);
}

void progress_end(struct progress *progress)
{
    if (progress->shows) {
        fprintf(stderr, "\r%60s\r", "");
        progress->shows = 0;
    }
}
