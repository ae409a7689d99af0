/* Flies a scene with its log by the library alone, in few lines. Prints the errors at the end, like c_examples/harness.c. */

#include <stdio.h>

#include "sins_scene.h"

static char text[1 << 23];

static size_t read_file(const char *path)
{
    FILE *file = fopen(path, "rb");
    size_t size = file != NULL ? fread(text, 1, sizeof text, file) : 0;

    return file != NULL && fclose(file) == 0 ? size : 0;
}

int main(int count, char **path)
{
    sins_scene *scene = NULL;
    sins_log *log = NULL;
    sins_sim *sim = NULL;
    sins_flight_sample sample;
    sins_errors errors;
    size_t k;
    int bad = count != 3 || sins_scene_parse(text, read_file(path[1]), &scene) != SINS_OK
              || sins_log_parse(text, read_file(path[2]), scene, &log, NULL) != SINS_OK
              || sins_scene_create_simulator(scene, &sim) != SINS_OK;

    SINS_INIT(sample);
    SINS_INIT(errors);
    for (k = 0; !bad && sins_log_get_sample(log, k, &sample, NULL) == SINS_OK; k++) {
        bad = sins_scene_prepare(scene, sim, 0, &sample) < 0 || sins_push_sample(sim, &sample) < 0 || sins_step(sim) < 0;
    }
    bad = bad || sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &errors) != SINS_OK;
    for (k = 0; k < 3; k++) {
        printf("%.17g %.17g %.17g\n", errors.position_enu_m[k], errors.velocity_enu_m_s[k], errors.misalignment_enu_rad[k]);
    }
    return bad || sins_destroy(sim) < 0 || sins_log_destroy(log) < 0 || sins_scene_destroy(scene) < 0;
}
