/*
 * Flies the scenes of a folder by the C interface: door FOLDER NAME... It prints for each how it ends, as ends.txt of tests/support/scenes.
 */

#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sins_scene.h"

static void check(sins_status status, const char *name, const char *what)
{
    if (status < 0) {
        char sentence[512] = "";
        sins_last_error(NULL, sentence, sizeof sentence, NULL);
        fprintf(stderr, "%s: %s: %d %s\n", name, what, (int)status, sentence);
        exit(1);
    }
}

/* The bytes of a file, or NULL. */
static char *read_file(const char *folder, const char *name, const char *ending, size_t *size)
{
    char path[4096];
    FILE *file;
    char *text;

    snprintf(path, sizeof path, "%s/%s%s", folder, name, ending);
    file = fopen(path, "rb");
    if (file == NULL || fseek(file, 0, SEEK_END) != 0) {
        return NULL;
    }
    *size = (size_t)ftell(file);
    rewind(file);
    text = (char *)malloc(*size + 1);
    if (text == NULL || fread(text, 1, *size, file) != *size) {
        exit(1);
    }
    fclose(file);
    return text;
}

static void print(const double *values, int count)
{
    uint64_t word;

    for (; count > 0; count--) {
        memcpy(&word, values++, sizeof word);
        printf(" %016" PRIx64, word);
    }
}

static void fly(const char *folder, const char *name)
{
    sins_scene *scene = NULL;
    sins_log *log = NULL;
    sins_play *play = NULL;
    sins_sim *sim = NULL;
    sins_errors errors;
    sins_unit_status status;
    sins_unit_navigation shown;
    size_t size;
    char *text = read_file(folder, name, ".toml", &size);
    sins_status ended;

    check(sins_scene_parse(text, size, &scene), name, "scene");
    free(text);
    text = read_file(folder, name, ".csv", &size);
    if (text != NULL) {
        check(sins_log_parse(text, size, scene, &log, NULL), name, "log");
        free(text);
    }
    check(sins_play_create(scene, log, &play), name, "play");
    ended = sins_play_run(play, NULL, 0, NULL);
    printf("%s", name);
    if (ended == SINS_ERROR_BAD_STATE) {
        printf(" stopped\n");
    } else {
        check(ended, name, "run");
        SINS_INIT(errors);
        SINS_INIT(status);
        SINS_INIT(shown);
        check(sins_play_get_simulator(play, &sim), name, "simulator");
        check(sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &errors), name, "errors");
        check(sins_play_get_shown(play, &status, &shown), name, "shown");
        print(errors.position_enu_m, 3);
        print(errors.velocity_enu_m_s, 3);
        print(errors.misalignment_enu_rad, 3);
        print(&shown.latitude_rad, 1);
        print(&shown.longitude_rad, 1);
        print(&shown.height_m, 1);
        print(shown.velocity_enu_m_s, 3);
        print(&shown.roll_rad, 1);
        print(&shown.pitch_rad, 1);
        print(&shown.heading_rad, 1);
        printf(" %" PRIu32 " %" PRId32 "\n", status.validity, status.state);
    }
    sins_play_destroy(play);
    sins_log_destroy(log);
    sins_scene_destroy(scene);
}

int main(int count, char **arguments)
{
    int k;

    for (k = 2; k < count; k++) {
        fly(arguments[1], arguments[k]);
    }
    return 0;
}
