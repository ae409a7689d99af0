/*
 * Flies a scene and prints the navigation of its INS, with the errors:
 *
 *     harness SCENE.toml [LOG.csv]     a file, as in c_examples/scenes; LOG.csv replaces the log that the scene names
 *     harness NAME                     a built-in scene: patrol, aerobatics, commuter, ...
 *
 * The calls have the order of every host: read the scene, open its log, make it ready, fly, destroy the handles. A flight simulator
 * calls sins_play_push() with samples of its own instead of sins_play_run().
 */

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "sins_scene.h"

struct host {
    sins_scene *scene;
    sins_log *log;   /* if the flight is a log; else NULL */
    sins_play *play; /* the scene in flight */
    sins_sim *sim;   /* its simulator, which ends with it */
};

/*
 * Whether a call succeeded; if not, prints which call failed and why. Errors are negative. The library keeps the sentence of
 * the last error with its simulator. For functions without a simulator and those of scenes, sim is NULL: the library keeps their
 * sentence with the thread.
 */
#define DONE(sim, call) done(sim, call, #call)

static int done(const sins_sim *sim, sins_status status, const char *call)
{
    char sentence[512] = "";

    if (status < 0) {
        sins_last_error(sim, sentence, sizeof sentence, NULL);
        fprintf(stderr, "harness: %.*s: %s (%s)\n", (int)strcspn(call, "("), call, sentence, sins_status_string(status));
    }
    return status >= 0;
}

/* Destroys all handles, in any order. A NULL handle is harmless: the library returns an error. */
static void close_all(struct host *host)
{
    sins_play_destroy(host->play);
    sins_log_destroy(host->log);
    sins_scene_destroy(host->scene);
}

/* The library opens no file: the host gives it bytes. The caller frees them. Returns NULL, after a message, if the file cannot be
 * read. */
static char *read_file(const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    long length = file != NULL && fseek(file, 0, SEEK_END) == 0 ? ftell(file) : -1;
    char *text = length >= 0 ? (char *)malloc((size_t)length + 1) : NULL; /* C++ needs the cast */

    *size = (size_t)length;
    if (text == NULL || fseek(file, 0, SEEK_SET) != 0 || fread(text, 1, *size, file) != *size) {
        fprintf(stderr, "harness: %s: %s\n", path, strerror(errno));
        free(text);
        text = NULL;
    }
    if (file != NULL) {
        fclose(file);
    }
    return text;
}

static void print_fault(const char *path, const sins_fault *fault)
{
    fprintf(stderr, "%s:%llu:%llu: %s\n", path, (unsigned long long)fault->line, (unsigned long long)fault->column,
            fault->sentence);
}

/* A scene with faults has a handle too, from which the faults can be read. */
static int read_scene(struct host *host, const char *name)
{
    sins_fault fault;
    sins_status status;
    size_t size, k;
    char *text;

    if (strstr(name, ".toml") == NULL) {
        return DONE(NULL, sins_scene_create_builtin(name, &host->scene));
    }
    text = read_file(name, &size);
    if (text == NULL) {
        return 0;
    }
    status = sins_scene_parse(text, size, &host->scene);
    free(text);
    SINS_INIT(fault); /* struct_size states which release of the struct this program knows */
    for (k = 0; status == SINS_SCENE_HAS_FAULTS && sins_scene_get_fault(host->scene, k, &fault) == SINS_OK; k++) {
        print_fault(name, &fault);
    }
    return done(NULL, status, "sins_scene_parse") && status == SINS_OK;
}

/* Path of the log that the scene names. A relative path starts from the folder of the scene's file. */
static int log_path(const struct host *host, const char *scene_path, char *path, size_t capacity)
{
    char log[4097]; /* no text of a scene is longer */
    size_t folder = strlen(scene_path);

    if (!DONE(NULL, sins_scene_get_text(host->scene, SINS_SCENE_TEXT_LOG, log, sizeof log, NULL))) {
        return 0;
    }
    while (folder > 0 && strchr("/\\", scene_path[folder - 1]) == NULL) {
        folder--;
    }
    folder = strchr("/\\", log[0]) != NULL || log[1] == ':' ? 0 : folder; /* 0: an absolute path */
    return snprintf(path, capacity, "%.*s%s", (int)folder, scene_path, log) < (int)capacity;
}

static int open_log(struct host *host, const char *path)
{
    sins_fault fault;
    sins_status status;
    size_t size;
    char *text = read_file(path, &size);

    if (text == NULL) {
        return 0;
    }
    SINS_INIT(fault);
    status = sins_log_parse(text, size, host->scene, &host->log, &fault);
    free(text);
    if (status == SINS_ERROR_INVALID_ARGUMENT) {
        print_fault(path, &fault);
        return 0;
    }
    return done(NULL, status, "sins_log_parse");
}

/* Opens the log if the flight is one, and makes the scene ready. A scene that does not say how far apart its records are gets 20. */
static int open_flight(struct host *host, const char *scene_path, const char *log)
{
    char path[8192], every[64];
    sins_scene_setup setup;
    sins_scene_samples samples;

    SINS_INIT(setup);
    SINS_INIT(samples);
    if ((log != NULL && !DONE(NULL, sins_scene_set_text(host->scene, SINS_SCENE_TEXT_LOG, log)))
        || !DONE(NULL, sins_scene_get_setup(host->scene, &setup))) {
        return 0;
    }
    if (setup.flight == SINS_SCENE_FLIGHT_LOG
        && !(log != NULL ? open_log(host, log)
                         : log_path(host, scene_path, path, sizeof path) && open_log(host, path))) {
        return 0;
    }
    if (!DONE(NULL, sins_scene_get_samples(host->scene, host->log, &samples))) {
        return 0;
    }
    if (setup.every_s == 0) {
        sprintf(every, "output.every_s = %.17g", fmax(samples.duration_s / 20, samples.period_s));
        if (!DONE(NULL, sins_scene_set_values(host->scene, every))) {
            return 0;
        }
    }
    return DONE(NULL, sins_play_create(host->scene, host->log, &host->play))
           && DONE(NULL, sins_play_get_simulator(host->play, &host->sim));
}

/* Prints the navigation and its errors: navigation minus truth, and by the error equations if the scene turns them on. */
static void print_row(const sins_record *record)
{
    const double *errors = record->navigation_errors.position_enu_m, *model = record->model_errors.position_enu_m;

    printf("%10.2f %11.6f %11.6f %9.1f %11.3f %11.3f %11.3f", record->time_s,
           record->navigation.latitude_rad / SINS_DEG, record->navigation.longitude_rad / SINS_DEG,
           record->navigation.height_m, errors[0], errors[1], errors[2]);
    if ((record->model_errors.flags & SINS_ERRORS_NOT_COMPUTED) == 0) {
        printf(" %11.3f %11.3f %11.3f", model[0], model[1], model[2]);
    }
    printf("\n");
}

/* Flies to the end, from record to record: with the temperature, the failures, the updates and the unit of the scene. */
static int fly(struct host *host)
{
    sins_status status = SINS_OK;
    sins_record record;
    size_t written;

    printf("%10s %11s %11s %9s %35s %35s\n", "time s", "lat deg", "long deg", "height m", "navigation - truth, ENU m",
           "by the error equations, ENU m");
    SINS_INIT(record);
    while (status == SINS_OK) {
        status = sins_play_run(host->play, &record, 1, &written);
        if (written == 1) {
            print_row(&record);
        }
    }
    return done(NULL, status, "sins_play_run");
}

/* Prints the errors at the end with all their digits, and the figures that the library collects during the flight. */
static int print_figures(const struct host *host)
{
    static const char *const axes[] = {"east", "north", "up"};
    const sins_record_errors *errors, *model;
    sins_record record;
    sins_accuracy accuracy;
    int k;

    SINS_INIT(record);
    SINS_INIT(accuracy);
    if (!DONE(host->sim, sins_get_record(host->sim, &record))
        || !DONE(host->sim, sins_get_accuracy(host->sim, &accuracy))) {
        return 0;
    }
    errors = &record.navigation_errors;
    model = &record.model_errors;
    printf("\n%-24s %24s %24s\n", "errors at the end", "navigation - truth", "error equations");
    for (k = 0; k < 3; k++) {
        printf("position m       %-7s %24.17g %24.17g\n", axes[k], errors->position_enu_m[k], model->position_enu_m[k]);
    }
    for (k = 0; k < 3; k++) {
        printf("velocity m/s     %-7s %24.17g %24.17g\n", axes[k], errors->velocity_enu_m_s[k],
               model->velocity_enu_m_s[k]);
    }
    for (k = 0; k < 3; k++) {
        printf("misalignment rad %-7s %24.17g %24.17g\n", axes[k], errors->misalignment_enu_rad[k],
               model->misalignment_enu_rad[k]);
    }
    printf("\nclosure, navigation - truth: %.4g m, %.4g m/s; caused by inconsistent samples: %.4g m, %.4g m/s\n",
           hypot(accuracy.closure_position_enu_m[0], accuracy.closure_position_enu_m[1]),
           hypot(accuracy.closure_velocity_enu_m_s[0], accuracy.closure_velocity_enu_m_s[1]),
           hypot(accuracy.host_position_enu_m[0], accuracy.host_position_enu_m[1]),
           hypot(accuracy.host_velocity_enu_m_s[0], accuracy.host_velocity_enu_m_s[1]));
    printf("%llu intervals, ", (unsigned long long)accuracy.intervals);
    if (accuracy.has_rates) {
        printf("R50 %.4g nmi/h, R95 %.4g nmi/h\n", accuracy.cep_rate_m_s / SINS_NMI_PER_HOUR,
               accuracy.radial_95_rate_m_s / SINS_NMI_PER_HOUR);
    } else {
        printf("R50 and R95: not before 84.4 min, a Schuler period\n");
    }
    return 1;
}

static int run(struct host *host, const char *scene, const char *log)
{
    return read_scene(host, scene) && open_flight(host, scene, log) && fly(host) && print_figures(host);
}

int main(int count, char **arguments)
{
    struct host host;
    int flown;

    if (count < 2 || count > 3) {
        fprintf(stderr, "usage: harness SCENE.toml [LOG.csv], or harness NAME of a built-in scene\n");
        return 2;
    }
    if (sins_abi_version() != SINS_HEADER_ABI) {
        fprintf(stderr, "harness: the library has interface version %u, this program needs %u\n",
                (unsigned)sins_abi_version(), (unsigned)SINS_HEADER_ABI);
        return 1;
    }
    memset(&host, 0, sizeof host);
    flown = run(&host, arguments[1], count == 3 ? arguments[2] : NULL);
    close_all(&host);
    return flown && fflush(stdout) == 0 ? 0 : 1;
}
