/* Every struct of the interface with sizes from 0 to twice its own. Each struct is on the heap and has exactly the bytes that
 * it states, so that AddressSanitizer detects an access beyond them. */

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "scene.h"

/* A struct of `size` bytes of `filling` that states its size. The statement itself needs four bytes. */
static void *stating(size_t size, int filling)
{
    uint32_t stated = (uint32_t)size;
    unsigned char *bytes = malloc(size < sizeof stated ? sizeof stated : size);
    CHECK(bytes != NULL);
    memset(bytes, filling, size);
    memcpy(bytes, &stated, sizeof stated);
    return bytes;
}

/* A struct shorter than in the first release is an error. A longer one than this release knows is valid if the tail is zero. */
#define INPUT_SIZES(type, call)                                                              \
    do {                                                                                     \
        uint32_t garbage = 0xffffffffu;                                                      \
        size_t tried;                                                                        \
        for (tried = 0; tried <= 2 * sizeof(struct type); tried++) {                         \
            struct type *pointer = stating(tried, 0);                                        \
            int fits = tried >= sizeof(struct type) && tried % 8 == 0;                       \
            sins_status status = (call);                                                     \
            CHECK((status == SINS_ERROR_STRUCT_SIZE) == !fits);                              \
            if (fits && tried > sizeof(struct type)) {                                       \
                ((unsigned char *)pointer)[tried - 1] = 1;                                   \
                CHECK((call) == SINS_ERROR_STRUCT_SIZE);                                     \
            }                                                                                \
            free(pointer);                                                                   \
        }                                                                                    \
        {                                                                                    \
            struct type *pointer = (struct type *)(void *)&garbage;                          \
            CHECK((call) == SINS_ERROR_STRUCT_SIZE);                                         \
        }                                                                                    \
    } while (0)

/* Fields that fit into the host's struct are written. struct_size and the bytes unknown to this release are not changed. */
#define OUTPUT_SIZES(type, call)                                                             \
    do {                                                                                     \
        size_t tried, i;                                                                     \
        for (tried = 0; tried <= 2 * sizeof(struct type); tried++) {                         \
            struct type *pointer = stating(tried, 0xa5);                                     \
            int fits = tried >= sizeof(struct type) && tried % 8 == 0;                       \
            size_t known = tried < sizeof(struct type) ? tried : sizeof(struct type);        \
            CHECK((call) == (fits ? SINS_OK : SINS_ERROR_STRUCT_SIZE));                      \
            CHECK(pointer->struct_size == tried);                                            \
            for (i = fits ? known : 4; i < tried; i++) {                                     \
                CHECK(((unsigned char *)pointer)[i] == 0xa5);                                \
            }                                                                                \
            free(pointer);                                                                   \
        }                                                                                    \
    } while (0)

/* A call that makes something, which is destroyed. */
#define ENDED(handle, destroy, call) \
    (status_of_call = (call), handle == NULL ? SINS_OK : destroy(handle), handle = NULL, status_of_call)

static sins_status status_of_call;

#include "every_struct.h"

/* A recommendation for `piece`, which has two samples. */
static sins_status recommend_for(const sins_flight_sample *piece)
{
    sins_requirement requirement = {.struct_size = sizeof requirement, .position_m = 1.0};
    sins_options options = {.struct_size = sizeof options};
    sins_cost cost = {.struct_size = sizeof cost};
    return sins_recommend(NULL, piece, 2, &requirement, &options, &cost);
}

static sins_status push_first(sins_sim *sim, const sins_flight_sample *sample)
{
    CHECK(sins_reset(sim) == SINS_OK);
    return sins_push_sample(sim, sample);
}

/* A record from an interval at rest. */
static sins_status run_for_record(sins_sim *sim, sins_record *record)
{
    sins_flight_sample rest[2] = {{.struct_size = sizeof rest[0]}};
    rest[1].time_s = 0.01;
    CHECK(sins_reset(sim) == SINS_OK);
    return sins_run(sim, rest, 2, 1, record, 1, NULL);
}

/* Arrays of every stride: samples in and records out. The library must not access bytes after the last record. */
static void strides(sins_sim *sim)
{
    enum { COUNT = 3 };
    size_t in, out, k;
    for (in = sizeof(sins_flight_sample); in <= 2 * sizeof(sins_flight_sample); in += 8) {
        for (out = sizeof(sins_record); out <= 2 * sizeof(sins_record); out += 8) {
            unsigned char *samples = calloc(COUNT, in), *records = malloc((COUNT - 1) * out);
            sins_log *log = NULL;
            size_t written = 0;
            CHECK(samples != NULL && records != NULL);
            memset(records, 0xa5, (COUNT - 1) * out);
            ((sins_record *)(void *)records)->struct_size = (uint32_t)out;
            for (k = 0; k < COUNT; k++) {
                sins_flight_sample sample = {.struct_size = (uint32_t)in};
                sample.time_s = 0.01 * (double)k;
                memcpy(samples + k * in, &sample, sizeof sample);
            }
            CHECK(sins_reset(sim) == SINS_OK);
            CHECK(sins_run(sim, (sins_flight_sample *)(void *)samples, COUNT, 1, (sins_record *)(void *)records, COUNT - 2,
                           &written) == SINS_ERROR_BUFFER_TOO_SMALL);
            CHECK(sins_run(sim, (sins_flight_sample *)(void *)samples, COUNT, 1, (sins_record *)(void *)records, COUNT - 1,
                           &written) == SINS_OK);
            CHECK(written == COUNT - 1);
            CHECK(sins_log_create((sins_flight_sample *)(void *)samples, COUNT, &log) == SINS_OK && sins_log_destroy(log) == SINS_OK);
            CHECK(out > sizeof(sins_record) || in % sizeof(sins_flight_sample) != 0 ||
                  recommend_for((sins_flight_sample *)(void *)(samples + in)) == SINS_OK);
            for (k = 0; k < (COUNT - 1) * out; k++) {
                CHECK(k % out < sizeof(sins_record) || records[k] == 0xa5);
            }
            free(samples);
            free(records);
        }
    }
}

/* The budget of one second at rest. */
static sins_status budget_row(sins_budget_row *row)
{
    sins_flight_sample piece[2] = {{.struct_size = sizeof piece[0]}};
    piece[1].time_s = 1.0;
    return sins_error_budget(NULL, piece, 2, NULL, row, 1, NULL, NULL);
}

/* The fault of an invalid log. Returns SINS_OK instead of the status that reports the fault. */
static sins_status fault_of_log(sins_fault *fault)
{
    sins_log *log = NULL;
    sins_status status = sins_log_parse("time_s", 6, NULL, &log, fault);
    CHECK(log == NULL);
    return status == SINS_ERROR_INVALID_ARGUMENT ? SINS_OK : status;
}

static sins_status get_manoeuvre(sins_scene *scene, sins_manoeuvre *manoeuvre)
{
    sins_flight_start start = {.struct_size = sizeof start};
    size_t count;
    return sins_scene_get_manoeuvres(scene, &start, manoeuvre, 1, &count, NULL);
}

static sins_status first_word(sins_bus_word *word)
{
    sins_unit_status status = {.struct_size = sizeof status, .state = SINS_UNIT_STATE_NAVIGATION};
    sins_unit_navigation navigation = {.struct_size = sizeof navigation};
    size_t count;
    sins_status answer = sins_bus_words(&status, &navigation, NULL, 0.0, 0.1, word, 1, &count);
    return answer == SINS_ERROR_BUFFER_TOO_SMALL ? SINS_OK : answer;
}

/* The errors of an ensemble of one run. */
static sins_status all_errors(sins_errors *errors)
{
    sins_flight_sample sample = {.struct_size = sizeof sample};
    sins_sim *sim = scene_simulator(NULL, 1);
    sins_ensemble *ensemble = NULL;
    sins_status status;
    CHECK(sins_ensemble_create(sim, 0, 1, &ensemble) == SINS_OK && sins_ensemble_push_sample(ensemble, &sample) == SINS_OK);
    status = sins_ensemble_get_all_errors(ensemble, SINS_ERRORS_NAVIGATION, errors, 1);
    CHECK(sins_ensemble_destroy(ensemble) == SINS_OK && sins_destroy(sim) == SINS_OK);
    return status;
}

/* What every_struct.h leaves out (BY_HAND in build/c_struct_calls.rs), and the first sample, which is taken. */
static void structs_by_hand(void)
{
    sins_scene *scene = NULL, *faulty = NULL;
    sins_sim *sim = NULL;
    CHECK(sins_create(NULL, &sim) == SINS_OK && sins_scene_create(&scene) == SINS_OK);
    CHECK(sins_scene_parse("[", 1, &faulty) == SINS_SCENE_HAS_FAULTS);
    OUTPUT_SIZES(sins_record, run_for_record(sim, pointer));
    OUTPUT_SIZES(sins_budget_row, budget_row(pointer));
    OUTPUT_SIZES(sins_bus_word, first_word(pointer));
    OUTPUT_SIZES(sins_errors, all_errors(pointer));
    OUTPUT_SIZES(sins_fault, sins_scene_get_fault(faulty, 0, pointer));
    OUTPUT_SIZES(sins_fault, fault_of_log(pointer));
    OUTPUT_SIZES(sins_manoeuvre, get_manoeuvre(scene, pointer));
    INPUT_SIZES(sins_flight_sample, push_first(sim, pointer));
    strides(sim);
    CHECK(sins_scene_destroy(scene) == SINS_OK && sins_scene_destroy(faulty) == SINS_OK && sins_destroy(sim) == SINS_OK);
}

int main(void)
{
    sins_flight_sample sample[2] = {{.struct_size = sizeof sample[0]}};
    sins_flight *flight = scene_flight();
    sins_judge *judge = scene_judge();
    sins_identify *identify = scene_identify();
    sins_unit *unit = scene_unit();
    sins_ensemble *ensemble = scene_ensemble();
    sins_scene *scene = scene_of_text();
    sins_log *log = scene_log();
    sins_play *play = scene_play();
    sins_sim *sim = scene_simulator(NULL, 1);
    sample[1].time_s = 0.01;
    CHECK(sins_run(sim, sample, 2, 0, NULL, 0, NULL) == SINS_OK && sins_ensemble_run(ensemble, sample, 2) == SINS_OK);
    CHECK(sins_play_next(play) == SINS_OK && sins_play_next(play) == SINS_OK);
    every_struct(sim, flight, judge, identify, unit, ensemble, scene, log, play);
    structs_by_hand();
    CHECK(sins_destroy(sim) == SINS_OK && sins_flight_destroy(flight) == SINS_OK && sins_judge_destroy(judge) == SINS_OK);
    CHECK(sins_identify_destroy(identify) == SINS_OK);
    CHECK(sins_unit_destroy(unit) == SINS_OK && sins_ensemble_destroy(ensemble) == SINS_OK);
    CHECK(sins_scene_destroy(scene) == SINS_OK && sins_log_destroy(log) == SINS_OK && sins_play_destroy(play) == SINS_OK);
    printf("struct_sizes: every struct, from 0 to twice its size\n");
    return 0;
}
