#include "summary.h"

#include <math.h>
#include <string.h>

#include "flight_plan.h"
#include "option_table.h"
#include "report.h"

/* The scene in words. */
static void describe_scene(struct summary *sum)
{
    const struct settings *set = sum->set;
    char *text = sum->scene_text;
    size_t capacity = sizeof sum->scene_text;

    if (set->title[0] != '\0') {
        snprintf(text, capacity, "%s", set->title);
    } else if (set->kind == SCENE_FLIGHT) {
        const char *title = sum->scene->log.title;
        snprintf(text, capacity, "%s", title[0] != '\0' ? title : "recorded flight");
    } else if (set->kind == SCENE_EMBEDDED) {
        snprintf(text, capacity, "Built-in flight: %s", flight_plan_line(set->builtin));
    } else if (set->kind == SCENE_MANOEUVRES) {
        snprintf(text, capacity, "Flight of %d manoeuvres", (int)set->plan.count);
    } else {
        snprintf(text, capacity, "Simulation %d of the paper: %s", set->kind == SCENE_SIMULATION1 ? 1 : 2,
                 flight_plan_line(set->motion_name));
    }
}

/* Each failure with its time, "none" without. */
static void describe_failures(const struct failure_plan *plan, char *text, size_t capacity)
{
    size_t i, length = 0;

    snprintf(text, capacity, "none");
    for (i = 0; i < plan->count; i++) {
        const struct planned_failure *planned = &plan->failures[i];
        char sensor[16], axis[4], kind[16], until[24] = "the end";

        option_word_of("failing.sensor", planned->sensor, sensor, sizeof sensor);
        option_word_of("failing.axis", planned->axis, axis, sizeof axis);
        option_word_of("failure.kind", planned->failure.kind, kind, sizeof kind);
        if (planned->until_s < HUGE_VAL) {
            snprintf(until, sizeof until, "%.6g s", planned->until_s);
        }
        length += (size_t)snprintf(text + length, capacity - length, "%s%s %s%s%s %.6g s to %s", i > 0 ? ", " : "",
                                   sensor, planned->sensor == SINS_SENSOR_ALTIMETER ? "" : axis,
                                   planned->sensor == SINS_SENSOR_ALTIMETER ? "" : " ", kind, planned->from_s, until);
    }
}

int summary_gather(struct summary *sum, sins_sim *sim, const struct settings *set, const struct scene *scene,
                   const struct flown *flown)
{
    memset(sum, 0, sizeof *sum);
    sum->set = set;
    sum->scene = scene;
    sum->flown = flown;
    sum->accuracy.struct_size = sizeof sum->accuracy;
    sum->version = sins_version_string();
    if (refused(sim, sins_get_accuracy(sim, &sum->accuracy))) {
        return FAILED;
    }
    sum->subsamples = set->options.subsamples > 0 ? set->options.subsamples : 2;
    sum->updates = set->options.updates_per_sample > 0 ? set->options.updates_per_sample : 1;
    sum->rate_hz = scene->period_s > 0 ? 1 / scene->period_s : 0;
    sum->every_s = (double)flown->every * scene->period_s;
    sum->ns_per_step = flown->steps > 0 ? 1e9 * flown->library_s / (double)flown->steps : 0;
    describe_scene(sum);
    option_word(set, "options.scheme", sum->scheme, sizeof sum->scheme);
    option_word(set, "options.frame", sum->frame, sizeof sum->frame);
    option_word(set, "options.signal", sum->signal, sizeof sum->signal);
    option_word(set, "options.vertical", sum->vertical, sizeof sum->vertical);
    option_word(set, "options.earth", sum->earth, sizeof sum->earth);
    option_word(set, "options.gravity", sum->gravity, sizeof sum->gravity);
    option_word(set, "options.axes", sum->axes, sizeof sum->axes);
    options_describe(set, GROUP_GYRO, sum->gyro, sizeof sum->gyro);
    options_describe(set, GROUP_ACCEL, sum->accel, sizeof sum->accel);
    options_describe(set, GROUP_ALTIMETER, sum->altimeter, sizeof sum->altimeter);
    options_describe(set, GROUP_START, sum->start, sizeof sum->start);
    options_describe(set, GROUP_MOUNTING, sum->mounting, sizeof sum->mounting);
    options_describe(set, GROUP_GRAVITY, sum->gravity_disturbance, sizeof sum->gravity_disturbance);
    describe_failures(&set->failures, sum->failures, sizeof sum->failures);
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
    if (set->scene_file[0] != '\0') {
        text_row(file, "scene_file", set->scene_file, "scene file");
    }
    text_row(file, "scene_text", sum->scene_text, "scene in words");
    text_row(file, "scheme", sum->scheme, "mechanization scheme");
    text_row(file, "frame", sum->frame, "navigation frame");
    text_row(file, "signal", sum->signal, "ideal signals");
    text_row(file, "earth", sum->earth, "ellipsoid");
    text_row(file, "gravity", sum->gravity, "gravity model");
    text_row(file, "axes", sum->axes, "sensor axes");
    text_row(file, "vertical", sum->vertical, "vertical channel");
    whole_row(file, "subsamples", (uint64_t)sum->subsamples, "subsamples of an update");
    whole_row(file, "updates", (uint64_t)sum->updates, "updates in each sample interval");
    row(file, "rate_hz", sum->rate_hz, "Hz", "sample rate (mean over the flight)");
    whole_row(file, "seed", set->options.seed, "random seed");
    whole_row(file, "run", set->options.run, "Monte Carlo run number");
    text_row(file, "gyro_text", sum->gyro, "gyro errors");
    text_row(file, "accel_text", sum->accel, "accelerometer errors");
    text_row(file, "altimeter_text", sum->altimeter, "altimeter errors");
    text_row(file, "start_text", sum->start, "initial errors");
    text_row(file, "mounting_text", sum->mounting, "mounting of the sensor block");
    text_row(file, "gravity_text", sum->gravity_disturbance, "gravity disturbance");
    text_row(file, "failures_text", sum->failures, "failures");
}

static void rows_of_flight(const struct summary *sum, struct whole_file *file)
{
    const sins_accuracy *figures = &sum->accuracy;
    const struct flown *flown = sum->flown;

    row(file, "duration_s", figures->duration_s, "s", "simulated time");
    whole_row(file, "steps", flown->steps, "navigation steps (sample intervals)");
    row(file, "ns_per_step", sum->ns_per_step, "ns", "computing time of a step (wall clock)");
    whole_row(file, "interrupted", (uint64_t)flown->interrupted,
        "stopped before the end of the flight (0: no, 1: yes)");
    whole_row(file, "records", flown->records, "records written");
    row(file, "closure_position_east_m", figures->closure_position_enu_m[0], "m",
        "final position error east (closure)");
    row(file, "closure_position_north_m", figures->closure_position_enu_m[1], "m",
        "final position error north (closure)");
    row(file, "closure_position_up_m", figures->closure_position_enu_m[2], "m", "final position error up (closure)");
    row(file, "closure_velocity_east_m_s", figures->closure_velocity_enu_m_s[0], "m/s",
        "final velocity error east (closure)");
    row(file, "closure_velocity_north_m_s", figures->closure_velocity_enu_m_s[1], "m/s",
        "final velocity error north (closure)");
    row(file, "closure_velocity_up_m_s", figures->closure_velocity_enu_m_s[2], "m/s",
        "final velocity error up (closure)");
    row(file, "host_position_east_m", figures->host_position_enu_m[0], "m",
        "part of the final position error due to inconsistent flight data, east");
    row(file, "host_position_north_m", figures->host_position_enu_m[1], "m",
        "part of the final position error due to inconsistent flight data, north");
    row(file, "host_velocity_east_m_s", figures->host_velocity_enu_m_s[0], "m/s",
        "part of the final velocity error due to inconsistent flight data, east");
    row(file, "host_velocity_north_m_s", figures->host_velocity_enu_m_s[1], "m/s",
        "part of the final velocity error due to inconsistent flight data, north");
    row(file, "inconsistency_max_m", figures->inconsistency_max_m, "m",
        "inconsistency of the flight data: largest displacement by velocity - by position in a step");
    row(file, "trim_rate_max_rad_s", figures->trim_rate_max_rad_s, "rad/s", "largest trim of the closed loop, gyros");
    row(file, "trim_force_max_m_s2", figures->trim_force_max_m_s2, "m/s2",
        "largest trim of the closed loop, accelerometers");
    whole_row(file, "inconsistent_samples", figures->inconsistent_samples,
        "flight samples whose position contradicts their velocity");
}

static void rows_of_accuracy(const struct summary *sum, struct whole_file *file)
{
    const sins_accuracy *figures = &sum->accuracy;
    const struct flown *flown = sum->flown;

    row(file, "rer_rms_nmi_h", figures->radial_error_rate_rms_m_s / SINS_NMI_PER_HOUR, "nmi/h",
        "rms radial error rate RER (horizontal position error / time)");
    row(file, "r50_nmi_h", figures->cep_rate_m_s / SINS_NMI_PER_HOUR, "nmi/h", "R50 = 0.8326 rms(RER), the CEP rate");
    row(file, "r95_nmi_h", figures->radial_95_rate_m_s / SINS_NMI_PER_HOUR, "nmi/h", "R95 = 1.7308 rms(RER)");
    row(file, "slope_nmi_h", figures->radial_error_slope_m_s / SINS_NMI_PER_HOUR, "nmi/h",
        "growth of the horizontal position error (slope of the least-squares line)");
    row(file, "window_start_s", figures->window_start_s, "s",
        "error rates and growth are evaluated from this time on");
    row(file, "velocity_rms_east_m_s", figures->velocity_rms_enu_m_s[0], "m/s", "rms velocity error east");
    row(file, "velocity_rms_north_m_s", figures->velocity_rms_enu_m_s[1], "m/s", "rms velocity error north");
    row(file, "velocity_rms_up_m_s", figures->velocity_rms_enu_m_s[2], "m/s", "rms velocity error up");
    row(file, "max_position_m", flown->max_position_m, "m", "largest position error");
    row(file, "max_velocity_m_s", flown->max_velocity_m_s, "m/s", "largest velocity error");
    row(file, "max_misalignment_rad", flown->max_misalignment_rad, "rad", "largest misalignment");
    row(file, "max_model_difference_position_m", flown->max_model_position_m, "m",
        "largest position difference of error data 1 and 2 (0: no error model)");
    row(file, "max_model_difference_velocity_m_s", flown->max_model_velocity_m_s, "m/s",
        "largest velocity difference of error data 1 and 2 (0: no error model)");
}

void summary_write(const struct summary *sum, struct whole_file *file)
{
    fputs("key,value,unit,label\n", file->stream);
    rows_of_setting(sum, file);
    rows_of_flight(sum, file);
    rows_of_accuracy(sum, file);
    text_row(file, "library_version", sum->version, "library version");
}
