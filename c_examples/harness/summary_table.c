#include "summary.h"

#include <math.h>
#include <stdio.h>

#include "progress.h"

/* Scientific where a fixed point would not show the digits. */
static void print_number(double value)
{
    double size = fabs(value);
    const char *format = value == 0 ? "  %14.0f" : size >= 0.01 && size < 1e7 ? "  %14.3f" : "  %14.3e";

    printf(format, value);
}

static void print_axes(const char *what, const double *values, int count)
{
    int axis;

    printf("  %-30s", what);
    for (axis = 0; axis < count; axis++) {
        print_number(values[axis]);
    }
    putchar('\n');
}

static void print_figure(const char *what, double value, const char *unit)
{
    printf("  %-72s", what);
    print_number(value);
    printf(" %s\n", unit);
}

static void print_setting(const struct summary *sum, const char *records_path)
{
    const sins_options *options = &sum->set->options;
    const struct flown *flown = sum->flown;
    char duration[32];

    duration_text(sum->accuracy.duration_s, duration, sizeof duration);
    printf("%s, %s (library %s)\n", sum->set->scene, sum->set->motion_name, sum->version);
    printf("  gyros           %s\n", sum->gyro);
    printf("  accelerometers  %s\n", sum->accel);
    printf("  altimeter       %s\n", sum->altimeter);
    printf("  start errors    %s\n", sum->start);
    printf("  mounting        %s\n", sum->mounting);
    printf("  disturbance     %s\n", sum->gravity_disturbance);
    printf("  failures        %s\n", sum->failures);
    printf("  mechanization   %s scheme, %s frame, vertical %s, subsamples %d, updates %d\n", sum->scheme, sum->frame,
           sum->vertical, sum->subsamples, sum->updates);
    printf("  world           earth %s, gravity %s, sensor axes %s, seed %llu, run %llu\n", sum->earth, sum->gravity,
           sum->axes, (unsigned long long)options->seed, (unsigned long long)options->run);
    printf("  flown           %.6g s (%s) at %.6g Hz, %llu steps of %.0f ns%s\n", sum->accuracy.duration_s, duration,
           sum->rate_hz, (unsigned long long)flown->steps, sum->ns_per_step, flown->interrupted ? ", interrupted" : "");
    printf("  records         %llu, one each %.6g s, in %s\n", (unsigned long long)flown->records, sum->every_s,
           records_path);
}

static void print_closure(const struct summary *sum)
{
    const sins_accuracy *figures = &sum->accuracy;
    double sensors_position_m[2], sensors_velocity_m_s[2];
    int axis;

    for (axis = 0; axis < 2; axis++) {
        sensors_position_m[axis] = figures->closure_position_enu_m[axis] - figures->host_position_enu_m[axis];
        sensors_velocity_m_s[axis] = figures->closure_velocity_enu_m_s[axis] - figures->host_velocity_enu_m_s[axis];
    }
    printf("\n%-32s  %14s  %14s  %14s\n", "closure: navigation - truth", "east", "north", "up");
    print_axes("position [m]", figures->closure_position_enu_m, 3);
    print_axes("  of it the truth's own", figures->host_position_enu_m, 2);
    print_axes("  sensors and simulator", sensors_position_m, 2);
    print_axes("velocity [m/s]", figures->closure_velocity_enu_m_s, 3);
    print_axes("  of it the truth's own", figures->host_velocity_enu_m_s, 2);
    print_axes("  sensors and simulator", sensors_velocity_m_s, 2);
    print_axes("rms velocity error [m/s]", figures->velocity_rms_enu_m_s, 3);
    if (sum->set->options.signal == SINS_SIGNAL_CLOSED_LOOP) {
        printf("  largest trim of the closed loop: %.3g rad/s, %.3g m/s2\n", figures->trim_rate_max_rad_s,
               figures->trim_force_max_m_s2);
    }
    if (figures->inconsistent_samples > 0) {
        printf("  %llu samples contradict their velocity, by up to %.3g m\n",
               (unsigned long long)figures->inconsistent_samples, figures->inconsistency_max_m);
    }
}

static void print_accuracy(const struct summary *sum)
{
    const sins_accuracy *figures = &sum->accuracy;
    const struct flown *flown = sum->flown;

    puts("\naccuracy of this run, which is no ensemble");
    if (figures->window_samples > 0) {
        print_figure("rms of RER = sqrt(mean RER^2), RER = horizontal error / time",
                     figures->radial_error_rate_rms_m_s / SINS_NMI_PER_HOUR, "nmi/h");
        print_figure("R50 = 0.8326 sqrt(mean RER^2)", figures->cep_rate_m_s / SINS_NMI_PER_HOUR, "nmi/h");
        print_figure("R95 = 1.7308 sqrt(mean RER^2)", figures->radial_95_rate_m_s / SINS_NMI_PER_HOUR, "nmi/h");
        print_figure("slope of the least-squares line through the horizontal error",
                     figures->radial_error_slope_m_s / SINS_NMI_PER_HOUR, "nmi/h");
    } else {
        printf("  radial error rates: none, they count from %.0f s on\n", figures->window_start_s);
    }
    print_figure("largest |position error| of the records", flown->max_position_m, "m");
    print_figure("largest |velocity error| of the records", flown->max_velocity_m_s, "m/s");
    print_figure("largest |misalignment| of the records", flown->max_misalignment_rad / SINS_ARCMIN, "arcmin");
    if (sum->set->options.error_model != SINS_ERROR_MODEL_OFF) {
        print_figure("largest |error data 1 - error data 2| of the records, position", flown->max_model_position_m,
                     "m");
        print_figure("largest |error data 1 - error data 2| of the records, velocity", flown->max_model_velocity_m_s,
                     "m/s");
    }
}

void summary_print(const struct summary *sum, const char *records_path)
{
    print_setting(sum, records_path);
    print_closure(sum);
    print_accuracy(sum);
}
