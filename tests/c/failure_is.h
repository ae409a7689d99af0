/* Checks that a failed call left its own failure, and that its sentence and its struct agree. */

#ifndef FAILURE_IS_H
#define FAILURE_IS_H

#include <math.h>
#include <string.h>

#include "check.h"
#include "sins.h"

/* The last sentence of a simulator, or with NULL that of this thread. */
static inline const char *sentence_of(const sins_sim *sim)
{
    static char text[2][512];
    char *place = text[sim != NULL];
    CHECK(sins_last_error(sim, place, sizeof text[0], NULL) == SINS_OK);
    return place;
}

/* Whether a number of the text is `expected`. */
static inline int has_number(const char *text, double expected)
{
    while (*text != '\0') {
        char *end = NULL;
        double number = strtod(text, &end);
        if (end == text || !strchr("-0123456789", *text)) {
            text++;
        } else if (number == expected) {
            return 1;
        } else {
            text = end;
        }
    }
    return 0;
}

/* The text after `expected`, with which it must begin. */
static inline const char *behind(const char *text, const char *expected)
{
    CHECK(strncmp(text, expected, strlen(expected)) == 0);
    return text + strlen(expected);
}

/* Asserts that the last failure had this status and that its struct agrees with its sentence. */
static inline void failure_is(const sins_sim *sim, sins_status status)
{
    sins_error_info info = {.struct_size = sizeof info};
    const char *text = sentence_of(sim), *sample = strstr(text, " (samples[");
    char part[32];
    CHECK(sins_last_error_info(sim, &info) == SINS_OK && info.status == status);
    text = behind(text, info.field);
    CHECK(info.field[0] != '\0' || (info.index == -1 && !(info.flags & SINS_ERROR_INFO_VALUE)));
    if (info.index >= 0) {
        snprintf(part, sizeof part, "[%d]", (int)info.index);
        text = behind(text, part);
    }
    if (info.flags & SINS_ERROR_INFO_VALUE) {
        char *end = NULL;
        double value = strtod(behind(text, " = "), &end);
        CHECK(value == info.value || (isnan(value) && isnan(info.value)));
        CHECK(!(info.flags & SINS_ERROR_INFO_INTEGER) || !memchr(text, 'e', (size_t)(end - text)));
        text = end;
    }
    text = info.field[0] != '\0' ? behind(text, ": ") : text;
    CHECK(!(info.flags & SINS_ERROR_INFO_MINIMUM) || has_number(text, info.minimum));
    CHECK(!(info.flags & SINS_ERROR_INFO_MAXIMUM) || has_number(text, info.maximum));
    CHECK(info.flags & SINS_ERROR_INFO_VALUE || info.value == 0.0);
    CHECK(info.flags & SINS_ERROR_INFO_MINIMUM || info.minimum == 0.0);
    CHECK(info.flags & SINS_ERROR_INFO_MAXIMUM || info.maximum == 0.0);
    /* A range that the sentence states is in the struct. */
    CHECK(!strstr(text, "must be from") || (info.flags & SINS_ERROR_INFO_MINIMUM && info.flags & SINS_ERROR_INFO_MAXIMUM));
    CHECK((sample != NULL) == (info.sample >= 0));
    if (sample != NULL) {
        snprintf(part, sizeof part, " (samples[%d])", (int)info.sample);
        CHECK(strcmp(sample, part) == 0);
    }
}

/* Leaves recognisable failures: one on this thread, and one on `sim` unless it is NULL. */
static inline void plant(sins_sim *sim)
{
    sins_options options = {.struct_size = sizeof options, .reserved = 4711};
    sins_failure failure = {.struct_size = sizeof failure};
    sins_sim *none = NULL;
    CHECK(sins_create(&options, &none) == SINS_ERROR_INVALID_ARGUMENT);
    CHECK(sim == NULL || sins_set_failure(sim, 4711, 0, &failure) == SINS_ERROR_INVALID_ARGUMENT);
}

/* Asserts that a call that returned `status` left its own failure either on the thread or on the simulator. */
static inline void left(sins_sim *sim, const char *call, sins_status status)
{
    int on_thread = strstr(sentence_of(NULL), "4711") == NULL;
    int on_simulator = sim != NULL && strstr(sentence_of(sim), "4711") == NULL;
    if (on_thread + on_simulator != 1) {
        fprintf(stderr, "%s left %s\n", call, on_thread ? "two failures" : "no failure of its own");
    }
    CHECK(on_thread + on_simulator == 1);
    failure_is(on_thread ? NULL : sim, status);
}

#endif
