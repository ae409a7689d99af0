#include "summary.h"

#include <string.h>

#include "option_table.h"
#include "report.h"

int summary_gather(struct summary *sum, sins_sim *sim, const struct settings *set, const struct scene *scene,
                   const struct flown *flown)
{
    memset(sum, 0, sizeof *sum);
    sum->set = set;
    sum->scene = scene;
    sum->flown = flown;
    sum->accuracy.struct_size = sizeof sum->accuracy;
    if (refused(sim, sins_get_accuracy(sim, &sum->accuracy)) || refused(NULL, sins_version_string(&sum->version))) {
        return FAILED;
    }
    sum->subsamples = set->options.subsamples > 0 ? set->options.subsamples : 2;
    sum->updates = set->options.updates_per_sample > 0 ? set->options.updates_per_sample : 1;
    sum->rate_hz = scene->period_s > 0 ? 1 / scene->period_s : 0;
    sum->every_s = (double)flown->every * scene->period_s;
    sum->ns_per_step = flown->steps > 0 ? 1e9 * flown->library_s / (double)flown->steps : 0;
    option_word(set, "--scheme", sum->scheme, sizeof sum->scheme);
    option_word(set, "--frame", sum->frame, sizeof sum->frame);
    option_word(set, "--vertical", sum->vertical, sizeof sum->vertical);
    option_word(set, "--earth", sum->earth, sizeof sum->earth);
    option_word(set, "--gravity", sum->gravity, sizeof sum->gravity);
    option_word(set, "--axes", sum->axes, sizeof sum->axes);
    options_describe(set, GROUP_GYRO, sum->gyro, sizeof sum->gyro);
    options_describe(set, GROUP_ACCEL, sum->accel, sizeof sum->accel);
    options_describe(set, GROUP_ALTIMETER, sum->altimeter, sizeof sum->altimeter);
    options_describe(set, GROUP_START, sum->start, sizeof sum->start);
    return DONE;
}

/* Quoted where a comma or a quote would break the row. */
static void field(FILE *stream, const char *text)
{
    if (strpbrk(text, ",\"\r\n") == NULL) {
        fputs(text, stream);
        return;
    }
    fputc('"', stream);
    for (; *text != '\0'; text++) {
        if (*text == '"') {
            fputc('"', stream);
        }
        fputc(*text, stream);
    }
    fputc('"', stream);
}

static void text_row(struct whole_file *file, const char *key, const char *value, const char *label)
{
    fprintf(file->stream, "%s,", key);
    field(file->stream, value);
    fputs(",,", file->stream);
    field(file->stream, label);
    fputc('\n', file->stream);
}

static void row(struct whole_file *file, const char *key, double value, const char *unit, const char *label)
{
    fprintf(file->stream, "%s,%.17g,%s,", key, value, unit);
    field(file->stream, label);
    fputc('\n', file->stream);
}

/* A number that a double may not hold. */
static void whole_row(struct whole_file *file, const char *key, uint64_t value, const char *label)
{
    fprintf(file->stream, "%s,%llu,,", key, (unsigned long long)value);
    field(file->stream, label);
    fputc('\n', file->stream);
}

static void rows_of_setting(const struct summary *sum, struct whole_file *file)
{
    const struct settings *set = sum->set;

    text_row(file, "name", set->name, "name");
    text_row(file, "scene", set->scene, "scene");
    text_row(file, "motion", set->motion_name, "motion");
    text_row(file, "scheme", sum->scheme, "mechanization scheme");
    text_row(file, "frame", sum->frame, "navigation frame");
    text_row(file, "earth", sum->earth, "ellipsoid");
    text_row(file, "gravity", sum->gravity, "gravity");
    text_row(file, "axes", sum->axes, "sensor axes");
    text_row(file, "vertical", sum->vertical, "vertical channel");
    whole_row(file, "subsamples", (uint64_t)sum->subsamples, "sub-increments of an update");
    whole_row(file, "updates", (uint64_t)sum->updates, "updates in a sample interval");
    row(file, "rate_hz", sum->rate_hz, "Hz", "sample rate, of a log the mean");
    whole_row(file, "seed", set->options.seed, "seed of all random streams");
    whole_row(file, "run", set->options.run, "number of the run in an ensemble");
    text_row(file, "gyro_text", sum->gyro, "gyro errors");
    text_row(file, "accel_text", sum->accel, "accelerometer errors");
    text_row(file, "altimeter_text", sum->altimeter, "altimeter errors");
    text_row(file, "start_text", sum->start, "errors at the start");
}

static void rows_of_flight(const struct summary *sum, struct whole_file *file)
{
    const sins_accuracy *figures = &sum->accuracy;
    const struct flown *flown = sum->flown;

    row(file, "duration_s", figures->duration_s, "s", "simulated time");
    whole_row(file, "steps", flown->steps, "sample intervals");
    row(file, "ns_per_step", sum->ns_per_step, "ns", "wall time in the library / steps");
    whole_row(file, "interrupted", (uint64_t)flown->interrupted, "1: ended before its time");
    whole_row(file, "records", flown->records, "records");
    row(file, "closure_position_east_m", figures->closure_position_enu_m[0], "m",
        "closure east: navigation - truth at the end");
    row(file, "closure_position_north_m", figures->closure_position_enu_m[1], "m",
        "closure north: navigation - truth at the end");
    row(file, "closure_position_up_m", figures->closure_position_enu_m[2], "m",
        "closure up: navigation - truth at the end");
    row(file, "closure_velocity_east_m_s", figures->closure_velocity_enu_m_s[0], "m/s", "velocity closure east");
    row(file, "closure_velocity_north_m_s", figures->closure_velocity_enu_m_s[1], "m/s", "velocity closure north");
    row(file, "closure_velocity_up_m_s", figures->closure_velocity_enu_m_s[2], "m/s", "velocity closure up");
    row(file, "host_position_east_m", figures->host_position_enu_m[0], "m",
        "share of the truth's own inconsistency, east");
    row(file, "host_position_north_m", figures->host_position_enu_m[1], "m",
        "share of the truth's own inconsistency, north");
    row(file, "host_velocity_east_m_s", figures->host_velocity_enu_m_s[0], "m/s", "the same of the velocity, east");
    row(file, "host_velocity_north_m_s", figures->host_velocity_enu_m_s[1], "m/s", "the same of the velocity, north");
    row(file, "inconsistency_max_m", figures->inconsistency_max_m, "m",
        "largest displacement by velocity - displacement by position in one interval");
    whole_row(file, "inconsistent_samples", figures->inconsistent_samples, "samples that contradict their velocity");
}

static void rows_of_accuracy(const struct summary *sum, struct whole_file *file)
{
    const sins_accuracy *figures = &sum->accuracy;
    const struct flown *flown = sum->flown;

    row(file, "rer_rms_nmi_h", figures->radial_error_rate_rms_m_s / SINS_NMI_PER_HOUR, "nmi/h",
        "rms of RER = sqrt(mean RER^2), RER = horizontal position error / time since the start");
    row(file, "r50_nmi_h", figures->cep_rate_m_s / SINS_NMI_PER_HOUR, "nmi/h", "R50 = 0.8326 sqrt(mean RER^2)");
    row(file, "r95_nmi_h", figures->radial_95_rate_m_s / SINS_NMI_PER_HOUR, "nmi/h", "R95 = 1.7308 sqrt(mean RER^2)");
    row(file, "slope_nmi_h", figures->radial_error_slope_m_s / SINS_NMI_PER_HOUR, "nmi/h",
        "slope of the least-squares line through the horizontal position error");
    row(file, "window_start_s", figures->window_start_s, "s", "these four count from here on");
    row(file, "velocity_rms_east_m_s", figures->velocity_rms_enu_m_s[0], "m/s", "rms velocity error east");
    row(file, "velocity_rms_north_m_s", figures->velocity_rms_enu_m_s[1], "m/s", "rms velocity error north");
    row(file, "velocity_rms_up_m_s", figures->velocity_rms_enu_m_s[2], "m/s", "rms velocity error up");
    row(file, "max_position_m", flown->max_position_m, "m", "largest |position error| of the records");
    row(file, "max_velocity_m_s", flown->max_velocity_m_s, "m/s", "largest |velocity error| of the records");
    row(file, "max_misalignment_rad", flown->max_misalignment_rad, "rad", "largest |misalignment| of the records");
    row(file, "max_model_difference_position_m", flown->max_model_position_m, "m",
        "largest |error data 1 - error data 2| of the records, position; 0 without the model");
    row(file, "max_model_difference_velocity_m_s", flown->max_model_velocity_m_s, "m/s",
        "largest |error data 1 - error data 2| of the records, velocity; 0 without the model");
}

void summary_write(const struct summary *sum, struct whole_file *file)
{
    fputs("key,value,unit,label\n", file->stream);
    rows_of_setting(sum, file);
    rows_of_flight(sum, file);
    rows_of_accuracy(sum, file);
    text_row(file, "library_version", sum->version, "release of the library");
}
