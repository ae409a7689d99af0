/* Memory runs out at every allocation in turn: the call returns SINS_ERROR_OUT_OF_MEMORY and changes nothing, and other
 * handles continue to the same bits. */

#define _GNU_SOURCE
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "allocator.h"
#include "scene.h"

static sins_flight_sample samples[SCENE_COUNT];
static sins_record expected[SCENE_COUNT - 1], found[SCENE_COUNT - 1];

static sins_status create(void)
{
    sins_sim *sim = NULL;
    sins_status status = sins_create(NULL, &sim);
    CHECK((status == SINS_OK) == (sim != NULL));
    CHECK(status != SINS_OK || sins_destroy(sim) == SINS_OK);
    return status;
}

/* Prints the heap memory of a simulator after its creation. Of the later calls on it, only loading a snapshot allocates. */
static void print_size(const char *name, int32_t error_model, int32_t covariance)
{
    sins_options options = {.struct_size = sizeof options};
    sins_sim *sim = NULL;
    long before = allocator_bytes, taken;
    options.error_model = error_model;
    options.covariance = covariance;
    CHECK(sins_create(&options, &sim) == SINS_OK);
    taken = allocator_bytes - before;
    CHECK(sins_destroy(sim) == SINS_OK);
    CHECK(taken > 0 && allocator_bytes == before);
    printf("out_of_memory: a simulator %s takes %ld bytes\n", name, taken);
}

static sins_status create_flight(void)
{
    sins_flight_start start = {.struct_size = sizeof start};
    sins_manoeuvre rests[3] = {{.struct_size = sizeof rests[0]}};
    sins_flight *flight = NULL;
    sins_status status;
    rests[0].duration_s = rests[1].duration_s = rests[2].duration_s = 60.0;
    status = sins_flight_create(&start, rests, 3, &flight);
    CHECK((status == SINS_OK) == (flight != NULL));
    CHECK(status != SINS_OK || sins_flight_destroy(flight) == SINS_OK);
    return status;
}

static sins_status recommend(void)
{
    sins_requirement requirement = {.struct_size = sizeof requirement, .position_m = 10.0};
    sins_options options = {.struct_size = sizeof options};
    sins_cost cost = {.struct_size = sizeof cost};
    sins_status status = sins_recommend(NULL, samples, 129, &requirement, &options, &cost);
    CHECK((status == SINS_OK) == (cost.tried != 0));
    return status;
}

static sins_status budget(void)
{
    sins_budget_row rows[SCENE_BUDGET_ROWS];
    sins_budget budget;
    sins_status status;
    memset(rows, 0, sizeof rows);
    memset(&budget, 0, sizeof budget);
    status = scene_budget(samples, 17, rows, &budget);
    CHECK((status == SINS_OK) == (budget.flights != 0) && (status == SINS_OK) == (rows[0].effect[0] != '\0'));
    return status;
}

static sins_ensemble *pair; /* the ensemble whose snapshot is loaded */

static sins_status create_ensemble(void)
{
    static sins_sim *sim;
    sins_ensemble *ensemble = NULL;
    sins_status status;
    if (sim == NULL) {
        sim = scene_simulator(NULL, 1);
    }
    status = sins_ensemble_create(sim, 0, 2, &ensemble);
    CHECK((status == SINS_OK) == (ensemble != NULL));
    CHECK(status != SINS_OK || sins_ensemble_destroy(ensemble) == SINS_OK);
    return status;
}

static sins_status load_ensemble(void)
{
    static unsigned char before[2 * SINS_SNAPSHOT_MAX_SIZE], after[sizeof before];
    size_t size, again;
    sins_status status;
    CHECK(sins_ensemble_snapshot_save(pair, before, sizeof before, &size) == SINS_OK);
    status = sins_ensemble_snapshot_load(pair, before, size);
    CHECK(sins_ensemble_snapshot_save(pair, after, sizeof after, &again) == SINS_OK);
    CHECK(size == again && memcmp(before, after, size) == 0);
    return status;
}

/* Functions of scenes and the parser of logs allocate their memory first. Without memory they report it and change nothing. */
static void starve_scenes(void)
{
    sins_scene *scene = scene_of_text(), *made = NULL;
    sins_log *log = NULL;
    sins_sim *sim = NULL;
    sins_flight *flight = NULL;
    sins_flight_start start = {.struct_size = sizeof start};
    sins_manoeuvre manoeuvres[2] = {{.struct_size = sizeof manoeuvres[0]}};
    static char before[8192], after[8192];
    const sins_record record = {.struct_size = sizeof record};
    const sins_covariance covariance = {.struct_size = sizeof covariance};
    const double errors[6] = {-1.2345678901234567e-300};
    size_t count;
    long living;
    CHECK(sins_scene_get_manoeuvres(scene, &start, manoeuvres, 2, &count, NULL) == SINS_OK);
    CHECK(sins_scene_write(scene, before, sizeof before, NULL) == SINS_OK);
    living = allocator_living;
    allocator_good = 0;
    CHECK(sins_scene_create(&made) == SINS_ERROR_OUT_OF_MEMORY);
    CHECK(sins_scene_create_builtin("patrol", &made) == SINS_ERROR_OUT_OF_MEMORY);
    CHECK(sins_scene_parse(scene_text, sizeof scene_text - 1, &made) == SINS_ERROR_OUT_OF_MEMORY);
    CHECK(sins_scene_write(scene, after, sizeof after, NULL) == SINS_ERROR_OUT_OF_MEMORY);
    CHECK(sins_scene_write_keys(after, sizeof after, NULL) == SINS_ERROR_OUT_OF_MEMORY);
    CHECK(sins_scene_create_simulator(scene, &sim) == SINS_ERROR_OUT_OF_MEMORY);
    CHECK(sins_scene_create_flight(scene, &flight) == SINS_ERROR_OUT_OF_MEMORY);
    CHECK(sins_scene_set_values(scene, "gyro.bias_deg_h = 1") == SINS_ERROR_OUT_OF_MEMORY);
    CHECK(sins_scene_set_items(scene, "failure", "") == SINS_ERROR_OUT_OF_MEMORY);
    CHECK(sins_scene_set_manoeuvres(scene, &start, manoeuvres, count, 2) == SINS_ERROR_OUT_OF_MEMORY);
    CHECK(sins_scene_set_text(scene, SINS_SCENE_TEXT_TITLE, "another") == SINS_ERROR_OUT_OF_MEMORY);
    CHECK(sins_log_parse(scene_log_text, sizeof scene_log_text - 1, NULL, &log, NULL) == SINS_ERROR_OUT_OF_MEMORY);
    /* A line of a record takes no memory. */
    CHECK(sins_record_line(NULL, NULL, 0, NULL, after, sizeof after, NULL) == SINS_OK);
    CHECK(sins_record_line(&record, errors, 6, &covariance, after, sizeof after, NULL) == SINS_OK);
    allocator_good = -1;
    CHECK(allocator_living == living && made == NULL && log == NULL && sim == NULL && flight == NULL);
    CHECK(sins_scene_write(scene, after, sizeof after, NULL) == SINS_OK && strcmp(before, after) == 0);
    CHECK(sins_scene_destroy(scene) == SINS_OK);
}

/* Lets each allocation of the parser fail alone. The parser of TOML ends the process if memory runs out behind the check, so each runs in
   a process of its own. Where it does not, a good text has no faults. */
static void starve_parser(void)
{
    int before, reported = 0;
    for (before = 0;; before++) {
        int state;
        pid_t child = fork();
        CHECK(child >= 0);
        if (child == 0) {
            sins_scene *scene = NULL;
            sins_status status;
            fclose(stderr);
            allocator_before = before;
            status = sins_scene_parse(scene_text, sizeof scene_text - 1, &scene);
            if (allocator_before >= 0) {
                _exit(status == SINS_OK ? 3 : 1); /* no allocation failed */
            }
            _exit(status == SINS_ERROR_OUT_OF_MEMORY && scene == NULL ? 2 : status == SINS_OK ? 0 : 1);
        }
        CHECK(waitpid(child, &state, 0) == child);
        CHECK(!WIFEXITED(state) || WEXITSTATUS(state) != 1);
        reported += WIFEXITED(state) && WEXITSTATUS(state) == 2;
        if (WIFEXITED(state) && WEXITSTATUS(state) == 3) {
            break;
        }
    }
    CHECK(reported > 1);
    printf("out_of_memory: %d allocations of a scene's parser fail alone, %d are reported\n", before, reported);
}

/* What a parser needs of any text is less than what it asked for before: else a lack of memory ends the process. The texts are the worst
   of 40 s of random ones: faults of one to six bytes, and tables of one key. */
static void measure_parser(void)
{
    static const char *const heads[] = {"", "", "", "", "a=[", "a=[", "a=[", "a=[", "a={"};
    static const char *const parts[] = {"=\n", "a=1\n", "[[update]]\n", "a.a=1\n", "{a=1},", "_}}}", "=.", "{ . }:", "."};
    static const size_t sizes[] = {60, 300, 1000, 20000, 300000};
    static char text[300000];
    size_t k, i, size;
    for (k = 0; k < sizeof parts / sizeof parts[0]; k++) {
        for (i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
            sins_scene *scene = NULL;
            long before = allocator_bytes;
            for (size = strlen(heads[k]), memcpy(text, heads[k], size); size + strlen(parts[k]) <= sizes[i];) {
                memcpy(text + size, parts[k], strlen(parts[k]));
                size += strlen(parts[k]);
            }
            allocator_peak = allocator_largest = 0;
            CHECK(sins_scene_parse(text, size, &scene) == SINS_SCENE_HAS_FAULTS);
            CHECK(allocator_peak - before <= allocator_largest);
            CHECK(sins_scene_destroy(scene) == SINS_OK);
        }
    }
}

/* More runs than any machine has memory for are rejected by their number, before they take any. */
static void starve_ensembles(void)
{
    static const size_t runs[] = {(size_t)4294967295u, (size_t)1 << 30};
    sins_sim *sim = scene_simulator(NULL, 1);
    size_t k;
#ifndef __SANITIZE_ADDRESS__
    /* Some systems promise any memory: their limit stands for that of the machine. */
    struct rlimit own, low;
    CHECK(getrlimit(RLIMIT_AS, &own) == 0);
    low = own;
    low.rlim_cur = (rlim_t)1 << 30;
    CHECK(setrlimit(RLIMIT_AS, &low) == 0);
#endif
    for (k = 0; k < sizeof runs / sizeof runs[0]; k++) {
        char text[200], start[40];
        sins_ensemble *ensemble = NULL;
        long before = allocator_bytes;
        allocator_peak = 0;
        CHECK(sins_ensemble_create(sim, 0, runs[k], &ensemble) == SINS_ERROR_OUT_OF_MEMORY && ensemble == NULL);
        CHECK(allocator_bytes == before && allocator_peak - before < 16L << 20);
        snprintf(start, sizeof start, "runs = %lu: ", (unsigned long)runs[k]);
        CHECK(sins_last_error(NULL, text, sizeof text, NULL) == SINS_OK);
        CHECK(strncmp(text, start, strlen(start)) == 0 && strstr(text, "bytes") != NULL);
    }
#ifndef __SANITIZE_ADDRESS__
    CHECK(setrlimit(RLIMIT_AS, &own) == 0);
#endif
    CHECK(sins_destroy(sim) == SINS_OK);
}

/* Lets each allocation of `call` fail in turn, with all later ones. Returns the number of allocations. */
static int starve(sins_status (*call)(void))
{
    char text[100];
    int good;
    long living;
    CHECK(call() == SINS_OK);
    living = allocator_living;
    for (good = 0;; good++) {
        sins_status status;
        allocator_good = good;
        status = call();
        if (allocator_good != 0) {
            allocator_good = -1;
            CHECK(status == SINS_OK);
            return good;
        }
        allocator_good = -1;
        if (status == SINS_OK) { /* exactly `good` allocations were needed */
            return good;
        }
        CHECK(status == SINS_ERROR_OUT_OF_MEMORY);
        CHECK(sins_last_error(NULL, text, sizeof text, NULL) == SINS_OK && strstr(text, "memory") != NULL);
        CHECK(allocator_living == living);
    }
}

int main(void)
{
    sins_sim *sim, *fresh = NULL;
    int k, allocations;

    scene_samples(samples);
    CHECK(sins_create(NULL, &fresh) == SINS_OK);
    print_size("with the default options", SINS_ERROR_MODEL_OFF, SINS_COVARIANCE_OFF);
    print_size("with error model and covariance", SINS_ERROR_MODEL_RK4, SINS_COVARIANCE_ON);
    sim = scene_simulator(NULL, 1);
    scene_fly(sim, samples, expected);
    CHECK(sins_reset(sim) == SINS_OK);

    for (k = 0; k < SCENE_COUNT; k++) {
        allocator_good = 0; /* no memory is available, and none is needed */
        CHECK(sins_push_sample(sim, &samples[k]) == SINS_OK);
        CHECK(sins_step(sim) == (k == 0 ? SINS_NEED_SAMPLE : SINS_OK));
        if (k > 0) {
            found[k - 1].struct_size = sizeof found[0];
            CHECK(sins_get_record(sim, &found[k - 1]) == SINS_OK);
        }
        allocator_good = -1;
        if (k == SCENE_COUNT / 2) {
            allocations = starve(create);
            CHECK(allocations > 0);
            printf("out_of_memory: %d allocations of create, ", allocations);
            allocations = starve(create_flight);
            CHECK(allocations > 0);
            printf("%d of a flight, ", allocations);
            allocations = starve(recommend);
            CHECK(allocations > 0);
            printf("%d of a recommendation, ", allocations);
            allocations = starve(budget);
            CHECK(allocations > 0);
            printf("%d of a budget, ", allocations);
            allocations = starve(create_ensemble);
            CHECK(allocations > 0);
            printf("%d of an ensemble, ", allocations);
            CHECK(sins_ensemble_create(fresh, 0, 2, &pair) == SINS_OK);
            allocations = starve(load_ensemble);
            CHECK(allocations > 0);
            printf("%d of loading one fail in turn\n", allocations);
        }
    }
    starve_scenes();
    starve_parser();
    measure_parser();
    starve_ensembles();
    CHECK(memcmp(found, expected, sizeof expected) == 0);
    CHECK(sins_destroy(sim) == SINS_OK);
    return 0;
}
