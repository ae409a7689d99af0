/* Numbers in text. */

#ifndef NUMBER_H
#define NUMBER_H

#include <stddef.h>

/* A finite decimal number that is the whole of text. 1 if it is one. */
int number_read(const char *text, double *value);

/* Numbers with commas between them. How many; 0 if one is bad or there are more than capacity. */
size_t numbers_read(const char *text, double *values, size_t capacity);

#endif
