/*
 * Flies a scene: reads it and its log, creates the simulator, runs to the end, prints the final errors.
 *
 *     scene SCENE.toml [LOG.csv]        the log that the scene names, as seen from here
 */
#include <stdio.h>
#include <stdlib.h>

#include "sins.h"

static void check(sins_status status, const char *what)
{
    char sentence[512] = "";
    if (status < 0) {
        sins_last_error(NULL, sentence, sizeof sentence, NULL);
        fprintf(stderr, "%s: %s (%d)\n", what, sentence, (int)status);
        exit(1);
    }
}

/* The whole file; the caller frees it. */
static char *read_file(const char *path, size_t *size)
{
    FILE *stream = fopen(path, "rb");
    char *text = NULL;
    *size = 0;
    if (stream != NULL && fseek(stream, 0, SEEK_END) == 0) {
        long length = ftell(stream);
        text = length > 0 ? (char *)malloc((size_t)length) : NULL;
        rewind(stream);
        *size = text != NULL ? fread(text, 1, (size_t)length, stream) : 0;
        fclose(stream);
    }
    if (*size == 0) {
        fprintf(stderr, "%s: cannot be read\n", path);
        exit(1);
    }
    return text;
}

static sins_scene *read_scene(const char *path)
{
    sins_scene *scene = NULL;
    sins_fault fault;
    size_t size, i;
    char *text = read_file(path, &size);
    sins_status status = sins_scene_parse(text, size, &scene);

    free(text);
    check(status, path);
    SINS_INIT(fault);
    for (i = 0; status == SINS_SCENE_HAS_FAULTS && sins_scene_get_fault(scene, i, &fault) == SINS_OK; i++) {
        fprintf(stderr, "%s:%d:%d: %s\n", path, (int)fault.line, (int)fault.column, fault.sentence);
    }
    if (status == SINS_SCENE_HAS_FAULTS) {
        exit(1);
    }
    return scene;
}

static sins_log *read_log(const char *path)
{
    sins_log *log = NULL;
    sins_fault fault;
    size_t size;
    char *text = read_file(path, &size);

    SINS_INIT(fault);
    if (sins_log_parse(text, size, &log, &fault) != SINS_OK) {
        fprintf(stderr, "%s:%d:%d: %s\n", path, (int)fault.line, (int)fault.column, fault.sentence);
        exit(1);
    }
    free(text);
    return log;
}

int main(int argc, char **argv)
{
    sins_scene *scene = argc > 1 ? read_scene(argv[1]) : NULL;
    sins_log *log = argc > 2 ? read_log(argv[2]) : NULL;
    sins_flight *flight = NULL;
    sins_sim *sim = NULL;
    sins_scene_setup setup;
    sins_flight_sample sample;
    sins_log_info info;
    sins_record record;
    double start_s = 0;
    size_t count, i;

    if (scene == NULL) {
        fprintf(stderr, "scene SCENE.toml [LOG.csv]\n");
        return 1;
    }
    SINS_INIT(setup);
    SINS_INIT(sample);
    SINS_INIT(info);
    SINS_INIT(record);
    check(sins_scene_get_setup(scene, &setup), "setup");
    check(sins_scene_create_simulator(scene, &sim), "simulator");
    if (log != NULL) {
        check(sins_log_get_info(log, &info), "log");
        count = (size_t)info.samples;
    } else {
        check(sins_scene_create_flight(scene, &flight), "flight");
        count = (size_t)(setup.flown_s * setup.rate_hz + 1e-9) + 1;
    }
    for (i = 0; i < count; i++) {
        double time_s = (double)i * (1 / setup.rate_hz);
        check(log != NULL ? sins_log_get_sample(log, i, &sample, NULL)
                          : sins_flight_sample_at(flight, time_s < setup.flown_s ? time_s : setup.flown_s, &sample),
              "sample");
        start_s = i == 0 ? sample.time_s : start_s;
        /* Temperature and failures of the scene; then as without one. */
        check(sins_scene_prepare(scene, sim, start_s, &sample), "prepare");
        if (sins_push_sample(sim, &sample) < 0 || sins_step(sim) < 0) {
            char sentence[512];
            sins_last_error(sim, sentence, sizeof sentence, NULL);
            fprintf(stderr, "at %g s: %s\n", sample.time_s, sentence);
            return 1;
        }
    }
    check(sins_get_record(sim, &record), "record");
    printf("after %g s: position error east %.17g m, north %.17g m, up %.17g m\n", record.time_s - start_s,
           record.navigation_errors.position_enu_m[0], record.navigation_errors.position_enu_m[1],
           record.navigation_errors.position_enu_m[2]);
    printf("by the error equations: east %.17g m, north %.17g m, up %.17g m\n", record.model_errors.position_enu_m[0],
           record.model_errors.position_enu_m[1], record.model_errors.position_enu_m[2]);
    sins_destroy(sim);
    sins_flight_destroy(flight);
    sins_log_destroy(log);
    sins_scene_destroy(scene);
    return 0;
}
