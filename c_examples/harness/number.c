#include "number.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

int number_read(const char *text, double *value)
{
    char *end;
    double number;

    /* strtod alone would also take nan, inf, hexadecimal numbers and leading blanks. */
    if (*text == '\0' || text[strspn(text, "+-.0123456789eE")] != '\0') {
        return 0;
    }
    number = strtod(text, &end);
    if (*end != '\0' || fabs(number) > 1e300) {
        return 0;
    }
    *value = number;
    return 1;
}

size_t numbers_read(const char *text, double *values, size_t capacity)
{
    size_t count = 0;

    for (;;) {
        char one[64];
        size_t length = strcspn(text, ",");

        if (length >= sizeof one || count == capacity) {
            return 0;
        }
        memcpy(one, text, length);
        one[length] = '\0';
        if (!number_read(one, &values[count])) {
            return 0;
        }
        count++;
        if (text[length] == '\0') {
            return count;
        }
        text += length + 1;
    }
}
