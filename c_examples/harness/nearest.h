/* The nearest name to a misspelt one. */

#ifndef NEAREST_H
#define NEAREST_H

#include <stddef.h>

/* Letters to insert, drop, replace or swap with their neighbours to make one name of the other. Of longer names the
 * first 63 letters count. */
size_t name_distance(const char *a, const char *b);

#endif
