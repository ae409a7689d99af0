#include "value.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"

void value_of_argument(struct value *value, const char *argument)
{
    value->count = numbers_read(argument, value->numbers, VALUE_NUMBERS);
    value->type = value->count == 0 ? VALUE_TEXT : value->count == 1 ? VALUE_NUMBER : VALUE_ARRAY;
    snprintf(value->text, sizeof value->text, "%s", strlen(argument) < sizeof value->text ? argument : "");
    if (value->count == 1 && argument[strspn(argument, "0123456789")] == '\0') {
        errno = 0;
        value->whole = strtoull(argument, NULL, 10);
        value->type = errno == 0 ? VALUE_WHOLE : value->type;
    }
}

/* Where to cut text to at most `most` bytes: never inside a character. */
static int cut(const char *text, int most)
{
    int length = (int)strlen(text);

    if (length <= most) {
        return length;
    }
    for (length = most; length > 0 && ((unsigned char)text[length] & 0xC0) == 0x80; length--) {
    }
    return length;
}

void value_print(const struct value *value, char *text, size_t capacity)
{
    int length;
    char *letter;

    switch (value->type) {
    case VALUE_TEXT:
        length = cut(value->text, 40);
        snprintf(text, capacity, "\"%.*s%s\"", length, value->text, value->text[length] == '\0' ? "" : "...");
        break;
    case VALUE_TRUTH:
        snprintf(text, capacity, value->whole ? "true" : "false");
        break;
    case VALUE_WHOLE:
        snprintf(text, capacity, "%llu", (unsigned long long)value->whole);
        break;
    case VALUE_NUMBER:
        snprintf(text, capacity, "%.10g", value->numbers[0]);
        break;
    default:
        snprintf(text, capacity, "an array of %d", (int)value->count);
    }
    for (letter = text; *letter != '\0'; letter++) {
        *letter = (unsigned char)*letter < ' ' || *letter == 0x7F ? '?' : *letter;
    }
}
