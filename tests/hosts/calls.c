/* Calls with arrays, matrices, texts and bytes, which every host makes. Prints the results: a name and a number in each line. */

#include <stdio.h>
#include <stdlib.h>

#include "sins_scene.h"

#define SAMPLES 121
#define EVERY 30
#define RECORDS 5

static void show(const char *label, double value)
{
    printf("%s %.17g\n", label, value);
}

static void check(sins_status status)
{
    if (status < 0) {
        fprintf(stderr, "calls: %s\n", sins_status_string(status));
        exit(1);
    }
}

int main(void)
{
    static sins_flight_sample samples[SAMPLES];
    static unsigned char bytes[SINS_SNAPSHOT_MAX_SIZE];
    sins_sim *sim = NULL, *second = NULL;
    sins_flight *flight = NULL;
    sins_options options;
    sins_gyro_params gyro;
    sins_flight_start start;
    sins_manoeuvre manoeuvres[2];
    sins_record records[RECORDS];
    sins_navigation navigation;
    sins_error_info info;
    char name[64];
    size_t k, written, size;

    check(sins_scene_builtin_name(1, name, sizeof name, &size));
    show(name, (double)size);

    SINS_INIT(start);
    start.latitude_rad = 0.7;
    start.speed_m_s = 100.0;
    SINS_INIT(manoeuvres[0]);
    SINS_INIT(manoeuvres[1]);
    manoeuvres[0].kind = SINS_MANOEUVRE_STRAIGHT;
    manoeuvres[0].duration_s = 5.0;
    manoeuvres[1].kind = SINS_MANOEUVRE_ROLL;
    manoeuvres[1].duration_s = 10.0;
    manoeuvres[1].turns = 1.0;
    check(sins_flight_create(&start, manoeuvres, 2, &flight));
    for (k = 0; k < SAMPLES; k++) {
        SINS_INIT(samples[k]);
        check(sins_flight_sample_at(flight, (double)k / 8.0, &samples[k]));
    }

    SINS_INIT(options);
    options.scheme = SINS_SCHEME_POLYNOMIAL;
    options.subsamples = 3;
    check(sins_create(&options, &sim));
    SINS_INIT(gyro);
    gyro.misalignment_rad[1] = 1e-3; /* row 0, column 1 */
    gyro.misalignment_rad[6] = 2e-3; /* row 2, column 0 */
    check(sins_set_gyro(sim, &gyro));
    for (k = 0; k < RECORDS; k++) {
        SINS_INIT(records[k]);
    }
    check(sins_run(sim, samples, SAMPLES, EVERY, records, RECORDS, &written));
    show("written", (double)written);
    for (k = 0; k < written; k++) {
        show("time", records[k].time_s);
        show("velocity", records[k].navigation_errors.velocity_enu_m_s[1]);
        show("misalignment", records[k].navigation_errors.misalignment_enu_rad[2]);
    }

    check(sins_snapshot_save(sim, bytes, sizeof bytes, &size));
    show("snapshot", (double)size);
    check(sins_create(&options, &second));
    check(sins_snapshot_load(second, bytes, size));
    SINS_INIT(navigation);
    check(sins_get_navigation(second, &navigation));
    show("quaternion", navigation.quaternion_nb[3]);

    gyro.misalignment_rad[7] = 2.0; /* row 2, column 1 */
    show("refused", sins_set_gyro(sim, &gyro));
    SINS_INIT(info);
    check(sins_last_error_info(sim, &info));
    show(info.field, (double)info.index);

    check(sins_destroy(sim));
    check(sins_destroy(second));
    check(sins_flight_destroy(flight));
    return 0;
}
