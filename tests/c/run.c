/* sins_run gives the same bits and the same records as pushing and stepping, with any split of the flight into calls. */

#include <string.h>

#include "turn.h"

enum { COUNT = 1001, EVERY = 7, RECORDS = (COUNT - 1) / EVERY };

static sins_flight_sample samples[COUNT];
static sins_record expected[RECORDS], found[RECORDS];

static sins_sim *make(void)
{
    sins_options options = {.struct_size = sizeof options, .seed = 3};
    options.error_model = SINS_ERROR_MODEL_RK4;
    options.sample_period_s = 0.01;
    return make_simulator(&options, SINS_GRADE_PAPER_SIMULATION2);
}

/* Flies sample by sample and builds the records from the reads. */
static void by_steps(void)
{
    sins_sim *sim = make();
    size_t k, flown = 0, written = 0;
    for (k = 0; k < COUNT; k++) {
        sins_record *record = &expected[written < RECORDS ? written : 0];
        CHECK(sins_push_sample(sim, &samples[k]) == SINS_OK);
        if (sins_step(sim) == SINS_OK && ++flown % EVERY == 0) {
            sins_navigation truth = {.struct_size = sizeof truth}, navigation = {.struct_size = sizeof navigation};
            sins_errors errors = {.struct_size = sizeof errors}, model = {.struct_size = sizeof model};
            CHECK(sins_get_truth(sim, &truth) == SINS_OK);
            CHECK(sins_get_navigation(sim, &navigation) == SINS_OK);
            CHECK(sins_get_errors(sim, SINS_ERRORS_NAVIGATION, &errors) == SINS_OK);
            CHECK(sins_get_errors(sim, SINS_ERRORS_MODEL, &model) == SINS_OK);
            record->struct_size = sizeof *record;
            record->time_s = truth.time_s;
            memcpy(&record->truth, &truth.latitude_rad, sizeof record->truth);
            memcpy(&record->navigation, &navigation.latitude_rad, sizeof record->navigation);
            memcpy(&record->navigation_errors, &errors.position_enu_m, sizeof record->navigation_errors);
            memcpy(&record->model_errors, &model.position_enu_m, sizeof record->model_errors);
            if (written == 0) {
                sins_record read = {.struct_size = sizeof read};
                CHECK(sins_get_record(sim, &read) == SINS_OK);
                CHECK(memcmp(&read, record, sizeof read) == 0);
            }
            written++;
        }
    }
    CHECK(written == RECORDS);
    CHECK(sins_destroy(sim) == SINS_OK);
}

/* In calls of at most `chunk` samples. */
static void by_chunks(size_t chunk)
{
    sins_sim *sim = make();
    size_t k, total = 0;
    memset(found, 0, sizeof found);
    for (k = 0; k < COUNT; k += chunk) {
        size_t count = COUNT - k < chunk ? COUNT - k : chunk, written = 99;
        if (total < RECORDS) {
            found[total].struct_size = sizeof found[0];
        }
        CHECK(sins_run(sim, &samples[k], count, EVERY, &found[total < RECORDS ? total : 0], RECORDS - total,
                       &written) == SINS_OK);
        total += written;
    }
    CHECK(total == RECORDS);
    CHECK(memcmp(expected, found, sizeof expected) == 0);
    CHECK(sins_destroy(sim) == SINS_OK);
}

static void refusals(void)
{
    sins_sim *sim = make();
    size_t written = 99;
    char text[200], all[100];
    double good = samples[500].height_m;
    sins_navigation navigation = {.struct_size = sizeof navigation};

    found[0].struct_size = sizeof found[0];
    CHECK(sins_run(sim, samples, COUNT, EVERY, found, RECORDS - 1, &written) == SINS_ERROR_BUFFER_TOO_SMALL);
    CHECK(sins_get_navigation(sim, &navigation) == SINS_NEED_SAMPLE); /* nothing was flown */
    CHECK(written == 0);

    /* The largest count is named with every digit. */
    CHECK(sins_run(sim, samples, (size_t)-1, 1, NULL, 0, &written) == SINS_ERROR_BUFFER_TOO_SMALL);
    CHECK(sins_last_error(sim, text, sizeof text, NULL) == SINS_OK);
    snprintf(all, sizeof all, "capacity = 0: is too small; needed: %llu", (unsigned long long)((size_t)-2));
    CHECK(strcmp(text, all) == 0);

    /* A count that overflows when the samples in the queue are added. */
    CHECK(sins_push_sample(sim, &samples[0]) == SINS_OK && sins_push_sample(sim, &samples[1]) == SINS_OK);
    CHECK(sins_run(sim, &samples[2], (size_t)-1, 1, NULL, 0, &written) == SINS_ERROR_BUFFER_TOO_SMALL);
    CHECK(sins_reset(sim) == SINS_OK);

    /* An error stops the run at its sample and names the sample. */
    samples[500].height_m = 1e9;
    CHECK(sins_run(sim, samples, COUNT, EVERY, found, RECORDS, &written) == SINS_ERROR_INVALID_ARGUMENT);
    samples[500].height_m = good;
    CHECK(written == 499 / EVERY && memcmp(expected, found, written * sizeof found[0]) == 0);
    CHECK(sins_last_error(sim, text, sizeof text, NULL) == SINS_OK);
    CHECK(strstr(text, "sample.height_m = 1e9") == text && strstr(text, "(samples[500])") != NULL);
    /* The rest of the samples then gives the same records. */
    memset(&found[written], 0xa5, (RECORDS - written) * sizeof found[0]); /* as from malloc */
    found[written].struct_size = sizeof found[0];
    CHECK(sins_run(sim, &samples[500], COUNT - 500, EVERY, &found[written], RECORDS - written, NULL) == SINS_OK);
    CHECK(memcmp(expected, found, sizeof expected) == 0);

    /* sins_run() is not allowed while navigating from increments. */
    CHECK(sins_get_navigation(sim, &navigation) == SINS_OK && sins_reset(sim) == SINS_OK);
    CHECK(sins_start_navigation(sim, &navigation) == SINS_OK);
    CHECK(sins_run(sim, NULL, 0, 0, NULL, 0, NULL) == SINS_ERROR_BAD_STATE);
    CHECK(sins_destroy(sim) == SINS_OK);
}

int main(void)
{
    make_samples(samples, COUNT);
    by_steps();
    by_chunks(COUNT);
    by_chunks(1);
    by_chunks(2);
    by_chunks(100);
    by_chunks(333);
    refusals();
    printf("run: same bits by any call pattern\n");
    return 0;
}
