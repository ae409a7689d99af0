/*
 * A host without an import library: it loads libsins.so or sins.dll at run time. If it cannot use the file, it prints the reason.
 *
 *     loadlibrary [PATH]
 *
 * It flies a minute of a steep turn as a flight simulator does, frame by frame, and prints a digest of every navigation
 * solution. The digest is the same on all systems, processors and word sizes, and with x87 arithmetic in the host.
 */

#include "sins_loader.h"

/* Times in seconds that are exact in binary, so that the results of all compilers are equal. */
#define RATE_HZ 128.0
#define FRAMES (60 * 128)

/* Fowler, Noll and Vo's 64-bit hash. */
static uint64_t digest(uint64_t hash, const void *object, size_t size)
{
    const unsigned char *bytes = (const unsigned char *)object;
    size_t i;

    for (i = 0; i < size; i++) {
        hash = (hash ^ bytes[i]) * (((uint64_t)1 << 40) + 0x1b3);
    }
    return hash;
}

/* The flight. A flight simulator uses its own flight instead. */
static sins_status create_flight(const sins_loader *sins, sins_flight **flight)
{
    sins_flight_start start;
    sins_manoeuvre turn;

    SINS_INIT(start);
    SINS_INIT(turn);
    start.latitude_rad = 0.7;
    start.height_m = 3000.0;
    start.speed_m_s = 150.0;
    turn.kind = SINS_MANOEUVRE_TURN;
    turn.heading_change_rad = 6.0;
    turn.bank_rad = 1.0;
    return sins->sins_flight_create(&start, &turn, 1, flight);
}

static sins_status create_simulator(const sins_loader *sins, sins_sim **sim)
{
    sins_gyro_params gyro;
    sins_accel_params accel;
    sins_status status;

    SINS_INIT(gyro);
    SINS_INIT(accel);
    status = sins->sins_create(NULL, sim);
    if (status >= 0) {
        status = sins->sins_gyro_preset(SINS_GRADE_TACTICAL, &gyro);
    }
    if (status >= 0) {
        status = sins->sins_accel_preset(SINS_GRADE_TACTICAL, &accel);
    }
    if (status >= 0) {
        status = sins->sins_set_gyro(*sim, &gyro);
    }
    return status < 0 ? status : sins->sins_set_accel(*sim, &accel);
}

/* One frame: the truth goes in, the navigation comes out. */
static sins_status fly_frame(const sins_loader *sins, sins_flight *flight, sins_sim *sim, int frame, uint64_t *hash)
{
    sins_flight_sample sample;
    sins_navigation navigation;
    sins_status status;

    SINS_INIT(sample);
    SINS_INIT(navigation);
    status = sins->sins_flight_sample_at(flight, frame / RATE_HZ, &sample);
    if (status >= 0) {
        status = sins->sins_push_sample(sim, &sample);
    }
    if (status >= 0) {
        status = sins->sins_step(sim);
    }
    if (status == SINS_OK) { /* SINS_NEED_SAMPLE at the first frame */
        status = sins->sins_get_navigation(sim, &navigation);
        *hash = digest(*hash, &navigation, sizeof navigation);
    }
    return status;
}

static int fly(const sins_loader *sins)
{
    sins_flight *flight = NULL;
    sins_sim *sim = NULL;
    char sentence[512] = "";
    uint64_t hash = ((uint64_t)0xcbf29ce4u << 32) + 0x84222325u;
    int frame;
    sins_status status = create_flight(sins, &flight);

    if (status >= 0) {
        status = create_simulator(sins, &sim);
    }
    for (frame = 0; status >= 0 && frame <= FRAMES; frame++) {
        status = fly_frame(sins, flight, sim, frame, &hash);
    }
    if (status < 0) {
        sins->sins_last_error(sim, sentence, sizeof sentence, NULL);
        fprintf(stderr, "loadlibrary: %s: %s\n", sins->sins_status_string(status), sentence);
    } else {
        printf("60 s of a turn, digest %08lx%08lx\n", (unsigned long)(hash >> 32), (unsigned long)(hash & 0xffffffffu));
    }
    sins->sins_destroy(sim); /* a handle that is NULL is harmless: the library returns an error */
    sins->sins_flight_destroy(flight);
    return status >= 0;
}

/* Returns the exit code. */
static int fly_with(const char *path)
{
    sins_loader sins;
    char message[1024];
    int flown;

    if (!sins_loader_open(&sins, path, message, sizeof message)) {
        fprintf(stderr, "loadlibrary: %s\n", message);
        return 1;
    }
    printf("sins %s, %s scenes, in a program of %d bits\n", sins.sins_version_string(), sins.has_scenes ? "with" : "without",
           (int)sizeof(void *) * 8);
    flown = fly(&sins);
    return sins_loader_close(&sins) && flown ? 0 : 1;
}

#if defined(_WIN32)

/* The arguments of main() are in a code page, which lacks most letters. Compilers of mingw need -municode for this function. */
#if defined(__cplusplus)
extern "C"
#endif
int wmain(int count, wchar_t **arguments)
{
    char path[4096];

    if (count < 2) {
        return fly_with("sins.dll");
    }
    if (WideCharToMultiByte(CP_UTF8, 0, arguments[1], -1, path, sizeof path, NULL, NULL) == 0) {
        fprintf(stderr, "loadlibrary: the path is longer than 4095 bytes\n");
        return 1;
    }
    return fly_with(path);
}

#else

int main(int count, char **arguments)
{
    return fly_with(count < 2 ? "libsins.so.1" : arguments[1]);
}

#endif
