/* A value as the command line or a scene file gives it, before an option takes it. */

#ifndef VALUE_H
#define VALUE_H

#include <stddef.h>
#include <stdint.h>

enum { VALUE_TEXT_SIZE = 1024, VALUE_NUMBERS = 9 };

enum value_type {
    VALUE_TEXT,
    VALUE_TRUTH,  /* whole: 1 true, 0 false */
    VALUE_WHOLE,  /* from 0 on: also as numbers[0], where a double may not hold it */
    VALUE_NUMBER, /* any other number: numbers[0] */
    VALUE_ARRAY   /* `count` numbers */
};

struct value {
    enum value_type type;
    uint64_t whole;
    size_t count;
    double numbers[VALUE_NUMBERS];
    char text[VALUE_TEXT_SIZE]; /* never with a zero byte inside */
};

/* An argument of the command line: numbers with commas between them, or text, which is empty if it was too long. */
void value_of_argument(struct value *value, const char *argument);

/* A value for a sentence: "text", true, 3, an array of 4. */
void value_print(const struct value *value, char *text, size_t capacity);

#endif
