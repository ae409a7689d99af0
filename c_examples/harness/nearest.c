#include "nearest.h"

#include <string.h>

enum { LONGEST = 63 };

static size_t smaller(size_t a, size_t b)
{
    return a < b ? a : b;
}

/* Optimal string alignment. Row i holds the distances of the first i letters of a to each begin of b. */
size_t name_distance(const char *a, const char *b)
{
    size_t rows[3][LONGEST + 1];
    size_t a_length = smaller(strlen(a), LONGEST), b_length = smaller(strlen(b), LONGEST), i, j;

    for (j = 0; j <= b_length; j++) {
        rows[0][j] = j;
    }
    for (i = 1; i <= a_length; i++) {
        const size_t *above = rows[(i - 1) % 3];
        size_t *row = rows[i % 3];

        row[0] = i;
        for (j = 1; j <= b_length; j++) {
            size_t replaced = above[j - 1] + (a[i - 1] != b[j - 1]);

            row[j] = smaller(replaced, 1 + smaller(above[j], row[j - 1]));
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                row[j] = smaller(row[j], rows[(i - 2) % 3][j - 2] + 1);
            }
        }
    }
    return rows[a_length % 3][b_length];
}
