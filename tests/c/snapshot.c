/* A simulator that is saved at every moment of a flight continues to the same bits in another handle and in its own. Bytes
 * that are not a complete snapshot are rejected and change nothing. */

#include <string.h>

#include "small_stack.h"
#include "turn.h"

enum { COUNT = 40 };

static sins_flight_sample samples[COUNT];
static sins_record expected[COUNT];

static sins_sim *make(void)
{
    sins_options options = {.struct_size = sizeof options, .seed = 3};
    options.error_model = SINS_ERROR_MODEL_RK4;
    options.sample_period_s = 0.01;
    options.signal = SINS_SIGNAL_CLOSED_LOOP;
    return make_simulator(&options, SINS_GRADE_TACTICAL);
}

/* Flies the samples from `first` on. Compares the records with the expected ones if `check`, otherwise stores them as expected. */
static void fly(sins_sim *sim, int first, int check)
{
    int k;
    for (k = first; k < COUNT; k++) {
        sins_record record = {.struct_size = sizeof record};
        CHECK(sins_push_sample(sim, &samples[k]) == SINS_OK);
        CHECK(sins_step(sim) == (k == 0 ? SINS_NEED_SAMPLE : SINS_OK));
        CHECK(sins_get_record(sim, &record) == SINS_OK);
        if (check) {
            CHECK(memcmp(&record, &expected[k], sizeof record) == 0);
        } else {
            expected[k] = record;
        }
    }
}

static void every_moment(void)
{
    sins_sim *straight = make(), *own = make();
    int k;
    fly(straight, 0, 0);
    for (k = 0; k < COUNT; k++) {
        static unsigned char bytes[SINS_SNAPSHOT_MAX_SIZE];
        size_t size = 0, written = 0;
        sins_sim *fresh = NULL;
        sins_options options = {.struct_size = sizeof options};
        CHECK(sins_snapshot_size(own, &size) == SINS_OK && size <= sizeof bytes);
        CHECK(sins_snapshot_save(own, bytes, sizeof bytes, &written) == SINS_OK && written == size);
        CHECK(sins_create(NULL, &fresh) == SINS_OK);
        CHECK(sins_snapshot_load(fresh, bytes, written) == SINS_OK);
        CHECK(sins_get_options(fresh, &options) == SINS_OK && options.seed == 3);
        fly(fresh, k, 1);
        CHECK(sins_destroy(fresh) == SINS_OK);
        fly(own, k, 1);
        CHECK(sins_snapshot_load(own, bytes, written) == SINS_OK);
        CHECK(sins_push_sample(own, &samples[k]) == SINS_OK);
        CHECK(sins_step(own) == (k == 0 ? SINS_NEED_SAMPLE : SINS_OK));
    }
    CHECK(sins_destroy(own) == SINS_OK);
    CHECK(sins_destroy(straight) == SINS_OK);
}

static void refusals(void)
{
    unsigned char bytes[SINS_SNAPSHOT_MAX_SIZE], small[64], again[SINS_SNAPSHOT_MAX_SIZE];
    size_t size = 0, written = 77, k;
    char text[200];
    sins_sim *sim = make();
    fly(sim, 0, 1);
    CHECK(sins_snapshot_save(sim, bytes, sizeof bytes, &size) == SINS_OK);

    memset(small, 0x5a, sizeof small);
    CHECK(sins_snapshot_save(sim, small, sizeof small, &written) == SINS_ERROR_BUFFER_TOO_SMALL && written == 77);
    for (k = 0; k < sizeof small; k++) {
        CHECK(small[k] == 0x5a);
    }
    CHECK(sins_last_error(sim, text, sizeof text, NULL) == SINS_OK);
    CHECK(strstr(text, "capacity = 64: is too small; needed: ") == text);
    CHECK(sins_snapshot_save(sim, again, size, NULL) == SINS_OK && memcmp(bytes, again, size) == 0);

    CHECK(sins_snapshot_load(sim, small, sizeof small) == SINS_ERROR_SNAPSHOT);
    CHECK(sins_last_error(sim, text, sizeof text, NULL) == SINS_OK);
    CHECK(strcmp(text, "snapshot: these bytes are not a snapshot") == 0);
    CHECK(sins_snapshot_load(sim, bytes, size - 1) == SINS_ERROR_SNAPSHOT);
    CHECK(sins_snapshot_load(sim, bytes, 0) == SINS_ERROR_SNAPSHOT);
    memcpy(again, bytes, size);
    again[8]++; /* the version of the format */
    CHECK(sins_snapshot_load(sim, again, size) == SINS_ERROR_SNAPSHOT);
    CHECK(sins_last_error(sim, text, sizeof text, NULL) == SINS_OK);
    CHECK(strstr(text, "snapshot format version = 2: ") == text);
    again[8]--;
    again[size / 2] ^= 1;
    CHECK(sins_snapshot_load(sim, again, size) == SINS_ERROR_SNAPSHOT);
    CHECK(sins_snapshot_save(sim, again, sizeof again, &written) == SINS_OK && written == size);
    CHECK(memcmp(bytes, again, size) == 0); /* nothing has changed */
    CHECK(sins_destroy(sim) == SINS_OK);
}

int main(void)
{
    make_samples(samples, COUNT);
    every_moment();
    refusals();
    on_a_small_stack(every_moment);
    printf("snapshot: the same bits from any moment\n");
    return 0;
}
