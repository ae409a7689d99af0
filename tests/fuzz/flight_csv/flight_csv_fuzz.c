/* The reader of flight logs, on any bytes: it reads a sample from each row until the end, or reports where it could not. */

#define _GNU_SOURCE
#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

#include "../../../c_examples/harness/flight_csv.h"
#include "../../../c_examples/harness/report.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

/* Instead of the harness's, which asks the library too. */
void report(const char *format, ...)
{
    (void)format;
}

/* Lines that are neither empty nor a comment; -1 where a zero byte, or a carriage return without a line feed, stands in one. */
static long rows_of(const uint8_t *bytes, size_t count)
{
    long rows = 0;
    int is_row = 0;
    size_t i, start = 0;

    for (i = 0; i < count; i++) {
        if (bytes[i] == '\n') {
            start = i + 1;
            is_row = 0;
        } else if (bytes[i] == '\0' || (bytes[i] == '\r' && (i + 1 == count || bytes[i + 1] != '\n'))) {
            return -1;
        } else if (bytes[i] != '\r' && !is_row) {
            is_row = bytes[i] != ' ' && bytes[i] != '\t';
            rows += is_row && bytes[start] != '#';
        }
    }
    return rows;
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count)
{
    static struct flight_csv csv;
    sins_flight_sample sample;
    char path[40];
    long line = 0, rows = 1; /* the header */
    int status = 1, file = memfd_create("log", 0);

    if (file < 0 || write(file, bytes, count) != (ssize_t)count) {
        abort();
    }
    snprintf(path, sizeof path, "/proc/self/fd/%d", file);
    if (flight_csv_open(&csv, path) == 0) {
        while ((status = flight_csv_next(&csv, &sample)) == 1) {
            if (sample.struct_size != sizeof sample || csv.line <= line) {
                abort();
            }
            line = csv.line;
            rows++;
        }
        if (status != 0 ? status != -1 : rows != rows_of(bytes, count)) {
            abort();
        }
        flight_csv_close(&csv);
    }
    if (csv.stream != NULL) {
        abort();
    }
    close(file);
    return 0;
}
