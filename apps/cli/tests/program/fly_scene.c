/*
 * A host of scenes in C: flies the text of a scene, with its log if it has one, and prints the columns of sins fly.
 *
 *     fly_scene SCENE.toml SAMPLES INTERVALS_A_RECORD [LOG.csv]
 */

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sins_scene.h"

static void check(sins_status status, const char *what)
{
    if (status < 0) {
        char sentence[512] = "";
        sins_last_error(NULL, sentence, sizeof sentence, NULL);
        fprintf(stderr, "%s: %d %s\n", what, (int)status, sentence);
        exit(1);
    }
}

static char *read_file(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    char *text;

    if (file == NULL || fseek(file, 0, SEEK_END) != 0) {
        perror(path);
        exit(1);
    }
    *size = (size_t)ftell(file);
    rewind(file);
    text = (char *)malloc(*size + 1);
    if (text == NULL || fread(text, 1, *size, file) != *size) {
        perror(path);
        exit(1);
    }
    fclose(file);
    return text;
}

static void numbers(const double *values, int count)
{
    int i;

    for (i = 0; i < count; i++) {
        printf(",%.17g", values[i]);
    }
}

static void print_solution(const sins_record_solution *solution)
{
    printf(",%.17g,%.17g,%.17g", solution->latitude_rad, solution->longitude_rad, solution->height_m);
    numbers(solution->velocity_enu_m_s, 3);
    printf(",%.17g,%.17g,%.17g", solution->roll_rad, solution->pitch_rad, solution->heading_rad);
}

static void print_errors(const sins_record_errors *errors)
{
    numbers(errors->position_enu_m, 3);
    numbers(errors->velocity_enu_m_s, 3);
    numbers(errors->misalignment_enu_rad, 3);
    printf(",%.17g,%.17g,%.17g,%d", errors->roll_rad, errors->pitch_rad, errors->heading_rad, (int)errors->flags);
}

/* Errors of the sensors since the last record: integrals [rad], [m/s], and the time of integration [s]. */
static double angle_rad[3], velocity_m_s[3], sum_s;

static void add_sensors(sins_sim *sim)
{
    sins_imu imu;
    int axis;

    SINS_INIT(imu);
    check(sins_get_imu(sim, &imu), "imu");
    for (axis = 0; axis < 3; axis++) {
        angle_rad[axis] += imu.measured_angle_rad[axis] - imu.ideal_angle_rad[axis];
        velocity_m_s[axis] += imu.measured_velocity_m_s[axis] - imu.ideal_velocity_m_s[axis];
    }
    sum_s += imu.interval_s;
}

static void print_record(sins_sim *sim)
{
    double means[6] = { 0 };
    sins_record record;
    int axis;

    SINS_INIT(record);
    check(sins_get_record(sim, &record), "record");
    for (axis = 0; axis < 3 && sum_s > 0; axis++) {
        means[axis] = angle_rad[axis] / sum_s;
        means[3 + axis] = velocity_m_s[axis] / sum_s;
        angle_rad[axis] = velocity_m_s[axis] = 0;
    }
    sum_s = 0;
    printf("%.17g", record.time_s);
    print_solution(&record.truth);
    print_solution(&record.navigation);
    print_errors(&record.navigation_errors);
    print_errors(&record.model_errors);
    numbers(means, 6);
    putchar('\n');
}

int main(int argc, char **argv)
{
    sins_scene *scene = NULL;
    sins_sim *sim = NULL;
    sins_flight *flight = NULL;
    sins_log *log = NULL;
    sins_scene_setup setup;
    sins_flight_sample sample;
    double start_s = 0, flight_s = 0;
    size_t size, count, every, k;
    char *text;

    if (argc < 4) {
        return 2;
    }
    count = (size_t)atol(argv[2]);
    every = (size_t)atol(argv[3]);
    text = read_file(argv[1], &size);
    check(sins_scene_parse(text, size, &scene), "scene");
    free(text);
    SINS_INIT(setup);
    SINS_INIT(sample);
    check(sins_scene_get_setup(scene, &setup), "setup");
    check(sins_scene_create_simulator(scene, &sim), "simulator");
    if (argc > 4) {
        text = read_file(argv[4], &size);
        check(sins_log_parse(text, size, scene, &log, NULL), "log");
        free(text);
        check(sins_log_get_sample(log, 0, &sample, NULL), "sample");
        start_s = sample.time_s;
    } else {
        check(sins_scene_create_flight(scene, &flight), "flight");
        check(sins_flight_duration(flight, &flight_s), "duration");
    }
    for (k = 0; k < count; k++) {
        if (log != NULL) {
            check(sins_log_get_sample(log, k, &sample, NULL), "sample");
        } else {
            check(sins_flight_sample_at(flight, fmin((double)k / setup.rate_hz, flight_s), &sample), "sample");
        }
        check(sins_scene_prepare(scene, sim, start_s, &sample), "prepare");
        check(sins_push_sample(sim, &sample), "push");
        check(sins_step(sim), "step");
        if (k > 0) {
            add_sensors(sim);
        }
        if (k % every == 0 || k + 1 == count) {
            print_record(sim);
        }
    }
    return 0;
}
