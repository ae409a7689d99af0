#include "report.h"

#include <stdarg.h>
#include <stdio.h>

void report(const char *format, ...)
{
    va_list arguments;

    fputs("sins_harness: ", stderr);
    va_start(arguments, format);
    vfprintf(stderr, format, arguments);
    va_end(arguments);
    fputc('\n', stderr);
}

void library_sentence(const sins_sim *sim, char *sentence, size_t capacity)
{
    sins_status status = sins_last_error(sim, sentence, capacity, NULL);

    if (status != SINS_OK && status != SINS_ERROR_BUFFER_TOO_SMALL) {
        snprintf(sentence, capacity, "%s", sins_status_string(status));
    }
}

int refused(const sins_sim *sim, sins_status status)
{
    char sentence[512];

    if (status >= 0) {
        return 0;
    }
    library_sentence(sim, sentence, sizeof sentence);
    report("%s", sentence);
    return 1;
}
