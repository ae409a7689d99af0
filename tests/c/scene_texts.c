/* Reads texts from standard input, each behind its length in four bytes, the lowest first, and says of each whether it
 * is a scene: 1 or 0. */

#include <stdlib.h>

#include "../../c_examples/harness/scene_file.h"
#include "check.h"

int main(void)
{
    static struct settings set;
    const int32_t ideal[2] = { 0, 0 };
    unsigned char size[4];

    while (fread(size, 1, 4, stdin) == 4) {
        size_t length = size[0] | (size_t)size[1] << 8 | (size_t)size[2] << 16 | (size_t)size[3] << 24;
        char *text = (char *)malloc(length + (length == 0)); /* exact: reading beyond shows */

        CHECK(text != NULL && fread(text, 1, length, stdin) == length);
        CHECK(settings_begin(&set, ideal) == 0);
        putchar(scene_file_apply(&set, text, length) == 0 ? '1' : '0');
        free(text);
    }
    return 0;
}
