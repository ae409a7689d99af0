/*
 * An independent master in C: declares the functions of FMI 2.0 itself and loads the unit at run time.
 *
 *     host LIBRARY MODEL_DESCRIPTION URI_OF_RESOURCES
 *
 * Two instances fly at once. One returns to an earlier state of its own, then the other takes the same state. Prints a digest
 * of all outputs after every step, which is the same on all systems, processors and word sizes.
 */

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../c/fnv.h"

#if defined(_WIN32)
#include <windows.h>
typedef FARPROC function_address;
#define SYMBOL(library, name) GetProcAddress((HMODULE)(library), name)
#else
#include <dlfcn.h>
typedef void *function_address;
#define SYMBOL(library, name) dlsym(library, name)
#endif

/* Types of the standard. */
typedef void *component;
typedef void *state;
typedef struct callbacks {
    void (*logger)(void *environment, const char *name, int status, const char *category, const char *message, ...);
    void *(*allocate_memory)(size_t count, size_t size);
    void (*free_memory)(void *memory);
    void (*step_finished)(void *environment, int status);
    void *environment;
} callbacks;

#define FUNCTIONS(X)                                                                                                         \
    X(const char *, GetVersion, (void))                                                                                      \
    X(component, Instantiate, (const char *, int, const char *, const char *, const callbacks *, int, int))                  \
    X(int, SetupExperiment, (component, int, double, double, int, double))                                                   \
    X(int, EnterInitializationMode, (component))                                                                             \
    X(int, ExitInitializationMode, (component))                                                                              \
    X(int, SetReal, (component, const unsigned *, size_t, const double *))                                                   \
    X(int, SetInteger, (component, const unsigned *, size_t, const int *))                                                   \
    X(int, SetString, (component, const unsigned *, size_t, const char *const *))                                            \
    X(int, GetReal, (component, const unsigned *, size_t, double *))                                                         \
    X(int, GetBoolean, (component, const unsigned *, size_t, int *))                                                         \
    X(int, DoStep, (component, double, double, int))                                                                         \
    X(int, GetFMUstate, (component, state *))                                                                                \
    X(int, SetFMUstate, (component, state))                                                                                  \
    X(int, FreeFMUstate, (component, state *))                                                                               \
    X(int, SerializedFMUstateSize, (component, state, size_t *))                                                             \
    X(int, SerializeFMUstate, (component, state, char *, size_t))                                                            \
    X(int, DeSerializeFMUstate, (component, const char *, size_t, state *))                                                  \
    X(int, Terminate, (component))                                                                                           \
    X(void, FreeInstance, (component))

#define MEMBER(result, name, parameters) result(*name) parameters;
static struct { FUNCTIONS(MEMBER) } fmi;

#define CHECK(good) ((good) ? (void)0 : stop(__LINE__, #good))

static void stop(int line, const char *what)
{
    fprintf(stderr, "host.c:%d: %s\n", line, what);
    exit(1);
}

static void logger(void *environment, const char *name, int status, const char *category, const char *message, ...)
{
    (void)environment;
    fprintf(stderr, "%s: %s (%d): %s\n", name, category, status, message);
}

static void load(const char *path)
{
#if defined(_WIN32)
    void *library = (void *)LoadLibraryA(path);
#else
    void *library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (library == NULL) {
        stop(__LINE__, dlerror());
    }
#endif
    CHECK(library != NULL);
#define LOAD(result, name, parameters)                                                                                       \
    {                                                                                                                        \
        function_address address = SYMBOL(library, "fmi2" #name);                                                            \
        CHECK(address != NULL);                                                                                              \
        memcpy(&fmi.name, &address, sizeof address);                                                                         \
    }
    FUNCTIONS(LOAD)
}

/* The model description as pack-fmu writes it: attributes have fixed places, and each element has its own line. This is no
 * reader of general XML. */

static char *description;

static void read_description(const char *path)
{
    const size_t room = (size_t)1 << 22;
    FILE *file = fopen(path, "rb");

    CHECK(file != NULL);
    description = calloc(room, 1);
    CHECK(description != NULL);
    CHECK(fread(description, 1, room - 1, file) < room - 1);
    CHECK(fclose(file) == 0);
}

static unsigned reference(const char *name)
{
    char text[128];
    const char *place;

    snprintf(text, sizeof text, "name=\"%s\" valueReference=\"", name);
    place = strstr(description, text);
    if (place == NULL) {
        stop(__LINE__, name);
    }
    return (unsigned)strtoul(place + strlen(text), NULL, 10);
}

/* References of all outputs of a type. */
static size_t outputs(const char *type, unsigned *references, size_t room)
{
    const char *variable = description, *attribute = " valueReference=\"";
    size_t count = 0;

    while ((variable = strstr(variable, "<ScalarVariable")) != NULL) {
        const char *end = strstr(variable, "</ScalarVariable>");
        const char *output = strstr(variable, "causality=\"output\"");
        const char *element = strstr(variable, type);
        CHECK(end != NULL);
        if (output != NULL && output < end && element != NULL && element < end) {
            CHECK(count < room);
            references[count++] = (unsigned)strtoul(strstr(variable, attribute) + strlen(attribute), NULL, 10);
        }
        variable = end;
    }
    return count;
}

#define RATE_HZ 128
#define ROOM 512
static const char *const INPUTS[] = {"truth.latitude_rad", "truth.longitude_rad", "truth.height_m",
    "truth.velocity_east_m_s", "truth.velocity_north_m_s", "truth.velocity_up_m_s",
    "truth.roll_rad", "truth.pitch_rad", "truth.heading_rad"};
#define INPUT_COUNT (sizeof INPUTS / sizeof *INPUTS)

/* Along the equator with 2^-15 rad/s of longitude, rolling to and fro: every number is exact in binary, with any arithmetic. */
static void truth(int frame, double *inputs)
{
    const double p = (frame % 256) / 256.0;

    memset(inputs, 0, INPUT_COUNT * sizeof *inputs);
    inputs[1] = frame / (32768.0 * RATE_HZ);
    inputs[2] = 1000.0;
    inputs[3] = (6378137.0 + 1000.0) / 32768.0;
    inputs[6] = (frame % 512 < 256 ? p : -p) * (1.0 - p);
    inputs[8] = 1.5;
}

/* Flies frames of an instance and returns a digest of all outputs. */
static uint64_t fly(component unit, int from, int to)
{
    static unsigned input_references[INPUT_COUNT], reals[ROOM], booleans[ROOM];
    static size_t real_count, boolean_count;
    uint64_t hash = FNV_NONE;
    int frame;

    if (real_count == 0) {
        size_t i;
        for (i = 0; i < INPUT_COUNT; i++) {
            input_references[i] = reference(INPUTS[i]);
        }
        real_count = outputs("<Real", reals, ROOM);
        boolean_count = outputs("<Boolean", booleans, ROOM);
        CHECK(real_count > 40 && boolean_count > 10);
    }
    for (frame = from; frame < to; frame++) {
        double inputs[INPUT_COUNT], numbers[ROOM];
        int flags[ROOM];
        truth(frame, inputs);
        CHECK(fmi.SetReal(unit, input_references, INPUT_COUNT, inputs) == 0);
        CHECK(fmi.DoStep(unit, frame / (double)RATE_HZ, 1.0 / RATE_HZ, 0) == 0);
        CHECK(fmi.GetReal(unit, reals, real_count, numbers) == 0);
        CHECK(fmi.GetBoolean(unit, booleans, boolean_count, flags) == 0);
        CHECK(numbers[0] == frame / (double)RATE_HZ);
        hash = fnv(hash, numbers, real_count * sizeof *numbers);
        hash = fnv(hash, flags, boolean_count * sizeof *flags);
    }
    return hash;
}

static component instance(const char *name, const callbacks *functions, const char *uri, const char *scene_file, int seed)
{
    const char *guid = strstr(description, "guid=\"");
    const unsigned scene = reference("scene_file"), seed_reference = reference("options.seed");
    char own_guid[39] = "";
    component unit;

    CHECK(guid != NULL);
    memcpy(own_guid, guid + strlen("guid=\""), sizeof own_guid - 1);
    unit = fmi.Instantiate(name, 1, own_guid, uri, functions, 0, 1);
    CHECK(unit != NULL);
    CHECK(fmi.SetupExperiment(unit, 0, 0.0, 0.0, 0, 0.0) == 0);
    CHECK(fmi.EnterInitializationMode(unit) == 0);
    CHECK(fmi.SetString(unit, &scene, 1, &scene_file) == 0);
    CHECK(fmi.SetInteger(unit, &seed_reference, 1, &seed) == 0);
    CHECK(fmi.ExitInitializationMode(unit) == 0);
    return unit;
}

int main(int argc, char **argv)
{
    const callbacks functions = {logger, calloc, free, NULL, NULL};
    component one, other;
    state frozen = NULL, thawed = NULL;
    uint64_t hash, first, again, elsewhere;
    size_t size = 0;
    char *bytes;

    CHECK(argc == 4);
    load(argv[1]);
    read_description(argv[2]);
    CHECK(strcmp(fmi.GetVersion(), "2.0") == 0);

    one = instance("one", &functions, argv[3], "fighter.toml", 3);
    other = instance("other", &functions, argv[3], "drone.toml", 4);
    hash = fly(one, 0, 1000);
    hash ^= fly(other, 0, 700);

    CHECK(fmi.GetFMUstate(one, &frozen) == 0);
    CHECK(fmi.SerializedFMUstateSize(one, frozen, &size) == 0 && size > 0);
    bytes = malloc(size);
    CHECK(bytes != NULL);
    CHECK(fmi.SerializeFMUstate(one, frozen, bytes, size) == 0);
    first = fly(one, 1000, 3000);
    hash ^= fly(other, 700, 3000);
    CHECK(fmi.SetFMUstate(one, frozen) == 0);
    again = fly(one, 1000, 3000);
    CHECK(fmi.DeSerializeFMUstate(other, bytes, size, &thawed) == 0);
    CHECK(fmi.SetFMUstate(other, thawed) == 0);
    elsewhere = fly(other, 1000, 3000);
    CHECK(again == first && elsewhere == first && first != 0);

    CHECK(fmi.FreeFMUstate(one, &frozen) == 0 && frozen == NULL);
    CHECK(fmi.FreeFMUstate(other, &thawed) == 0 && thawed == NULL);
    free(bytes);
    CHECK(fmi.Terminate(one) == 0 && fmi.Terminate(other) == 0);
    fmi.FreeInstance(one);
    fmi.FreeInstance(other);
    free(description);
    hash ^= first;
    printf("digest %08lx%08lx\n", (unsigned long)(hash >> 32), (unsigned long)(hash & 0xffffffffu));
    return 0;
}
