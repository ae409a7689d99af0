/* The same bits on every operating system, processor and word size, in debug and release builds: digests of all records of five
 * flights. A change of the algorithms may change them, and its commit says so. The machine must not change them. */

#include <inttypes.h>
#include <string.h>

#include "fnv.h"
#include "scene.h"

enum { MOST = 128 * 60 + 1, EVERY = 8 };

static sins_flight_sample samples[MOST];
static sins_record records[MOST];

/* Flies `count` samples from number `first` on and digests the records. */
static uint64_t run(uint64_t hash, sins_sim *sim, int first, int count)
{
    size_t written = 0;
    records[0].struct_size = sizeof records[0];
    CHECK(sins_run(sim, samples + first, (size_t)count, EVERY, records, MOST, &written) == SINS_OK);
    CHECK(written == (size_t)(count - (first == 0)) / EVERY);
    return fnv(hash, records, written * sizeof records[0]);
}

/* Runs the samples and also digests the figures at the end; destroys the simulator. The times are exact in binary, because a
 * host's compiler may round differently. */
static uint64_t fly_on(uint64_t hash, sins_sim *sim, int first, int count)
{
    sins_accuracy accuracy = {.struct_size = sizeof accuracy};
    sins_imu imu = {.struct_size = sizeof imu};
    hash = run(hash, sim, first, count);
    CHECK(sins_get_accuracy(sim, &accuracy) == SINS_OK && sins_get_imu(sim, &imu) == SINS_OK);
    CHECK(sins_destroy(sim) == SINS_OK);
    hash = fnv(hash, &accuracy, sizeof accuracy);
    return fnv(hash, &imu, sizeof imu);
}

static uint64_t fly(uint64_t hash, sins_sim *sim, int count)
{
    return fly_on(hash, sim, 0, count);
}

static void take_samples(sins_flight *flight, int count, double (*time_s)(int k))
{
    int k;
    memset(samples, 0, sizeof samples);
    for (k = 0; k < count; k++) {
        samples[k].struct_size = sizeof samples[k];
        CHECK(sins_flight_sample_at(flight, time_s(k), &samples[k]) == SINS_OK);
    }
    CHECK(sins_flight_destroy(flight) == SINS_OK);
}

/* One minute of the paper's simulation 2: its patrol, its sensors, both error data. */
static sins_sim *simulation2_simulator(void)
{
    static const double amplitudes[6] = {2.404825557695773, 0.02, 5.0, 0.004, 0.002, 0.002};
    static const double frequencies[6] = {0.0018, 0.0046, 0.007, 0.32, 0.43, 0.21};
    sins_flight_start start = {.struct_size = sizeof start};
    sins_manoeuvre patrol = {.struct_size = sizeof patrol};
    sins_options options = {.struct_size = sizeof options};
    sins_gyro_params gyro = {.struct_size = sizeof gyro};
    sins_accel_params accel = {.struct_size = sizeof accel};
    sins_flight *flight = NULL;
    sins_sim *sim = NULL;
    int i;
    start.latitude_rad = 0.7;
    start.longitude_rad = 2.0;
    start.height_m = 8000.0;
    start.speed_m_s = 200.0;
    patrol.kind = SINS_MANOEUVRE_SINUSOIDS;
    patrol.duration_s = 60.0;
    patrol.sinusoid_count = 6;
    for (i = 0; i < 6; i++) {
        patrol.channel[i] = i;
        patrol.amplitude[i] = amplitudes[i];
        patrol.frequency_hz[i] = frequencies[i];
    }
    CHECK(sins_flight_create(&start, &patrol, 1, &flight) == SINS_OK);
    take_samples(flight, MOST, scene_time);
    options.error_model = SINS_ERROR_MODEL_RK4;
    options.seed = 20140601;
    CHECK(sins_create(&options, &sim) == SINS_OK);
    CHECK(sins_gyro_preset(SINS_GRADE_PAPER_SIMULATION2, &gyro) == SINS_OK && sins_set_gyro(sim, &gyro) == SINS_OK);
    CHECK(sins_accel_preset(SINS_GRADE_PAPER_SIMULATION2, &accel) == SINS_OK && sins_set_accel(sim, &accel) == SINS_OK);
    return sim;
}

static uint64_t simulation2(uint64_t hash)
{
    return fly(hash, simulation2_simulator(), MOST);
}

/* Simulation 2, saved half way and loaded into a handle with other options. The digest is the same. */
static uint64_t snapshot_replay(uint64_t hash)
{
    enum { HALF = (MOST - 1) / 2 };
    static unsigned char frozen[SINS_SNAPSHOT_MAX_SIZE];
    sins_sim *sim = simulation2_simulator(), *thawed = NULL;
    size_t size = 0;
    hash = run(hash, sim, 0, HALF + 1);
    CHECK(sins_snapshot_save(sim, frozen, sizeof frozen, &size) == SINS_OK && sins_destroy(sim) == SINS_OK);
    CHECK(sins_create(NULL, &thawed) == SINS_OK && sins_snapshot_load(thawed, frozen, size) == SINS_OK);
    return fly_on(hash, thawed, HALF + 1, HALF);
}

/* A roll, a steep turn and a loop with every effect on, in every frame, scheme, number of subsamples and vertical channel. */
static uint64_t aerobatics(uint64_t hash)
{
    int i;
    take_samples(scene_flight(), SCENE_COUNT, scene_time);
    for (i = 0; i < 30; i++) {
        sins_options options = {.struct_size = sizeof options};
        options.frame = i % 2;
        options.scheme = i / 2 % 3;
        options.subsamples = 1 + i % 5;
        options.updates_per_sample = 1 + i % 2;
        options.vertical = i / 3 % 3;
        options.signal = i / 15;
        options.axes = i / 7 % 2;
        options.earth = i % 4;
        options.gravity = i / 4 % 2;
        options.error_model = SINS_ERROR_MODEL_RK4;
        options.run = (uint64_t)i;
        hash = fly(hash, scene_simulator(&options, 0), SCENE_COUNT);
    }
    return hash;
}

/* A flight of 16 s that passes the pole after 5 s. */
static uint64_t pole(uint64_t hash)
{
    sins_flight_start start = {.struct_size = sizeof start};
    sins_manoeuvre straight = {.struct_size = sizeof straight};
    sins_flight *flight = NULL;
    start.latitude_rad = 1.5706;
    start.longitude_rad = 0.5;
    start.height_m = 10000.0;
    start.speed_m_s = 250.0;
    straight.kind = SINS_MANOEUVRE_STRAIGHT;
    straight.duration_s = 16.0;
    CHECK(sins_flight_create(&start, &straight, 1, &flight) == SINS_OK);
    take_samples(flight, 2049, scene_time);
    /* Beyond the pole the longitude differs by half a turn: 0.5 and 0.5 - pi. */
    CHECK(samples[0].longitude_rad == 0.5 && samples[2048].longitude_rad < -2.6);
    return fly(hash, scene_simulator(NULL, 3), 2049);
}

/* Intervals of 10 ms with a jitter of up to 6 ms. */
static double jittered_time(int k)
{
    static uint32_t state;
    state = (k == 0 ? 1u : state) * 1664525u + 1013904223u;
    return (10 * k + (k == 0 ? 0 : (int)(state >> 24) % 7)) / 1024.0;
}

static uint64_t jitter(uint64_t hash)
{
    int k;
    take_samples(scene_flight(), 800, jittered_time);
    for (k = 200; k < 800; k++) {
        samples[k].flags = k / 200 % 2 ? SINS_SAMPLE_NO_VELOCITY : 0;
        memset(samples[k].velocity_enu_m_s, 0, samples[k].flags ? sizeof samples[k].velocity_enu_m_s : 0);
    }
    return fly(hash, scene_simulator(NULL, 4), 800);
}

int main(void)
{
    static const struct {
        const char *name;
        uint64_t (*flight)(uint64_t hash);
        uint64_t expected;
    } flights[] = {
        {"simulation 2", simulation2, UINT64_C(0xc308d0ff8c8ca9b4)},
        {"snapshot replay", snapshot_replay, UINT64_C(0xc308d0ff8c8ca9b4)},
        {"aerobatics, every effect", aerobatics, UINT64_C(0xbf7d5882a1297aea)},
        {"pole", pole, UINT64_C(0x5a66ea61598dd052)},
        {"jitter", jitter, UINT64_C(0x579183bd04912d3d)},
    };
    int wrong = 0;
    size_t i;
    for (i = 0; i < sizeof flights / sizeof flights[0]; i++) {
        uint64_t found = flights[i].flight(FNV_NONE);
        printf("digests: %016" PRIx64 " %s\n", found, flights[i].name);
        wrong += found != flights[i].expected;
    }
    fflush(stdout);
    CHECK(wrong == 0);
    return 0;
}
