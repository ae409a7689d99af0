/* The reader of scene files, on any bytes: a scene or a refusal, and the same again. */

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../../../c_examples/harness/scene_file.h"

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count)
{
    static struct settings set;
    const int32_t ideal[2] = {0, 0};
    char *text = malloc(count + (count == 0)); /* exact: reading beyond shows */
    int first, second;

    if (text == NULL) {
        abort();
    }
    memcpy(text, bytes, count);
    if (settings_begin(&set, ideal) != 0) {
        abort();
    }
    first = scene_file_apply(&set, text, count);
    if (settings_begin(&set, ideal) != 0) {
        abort();
    }
    second = scene_file_apply(&set, text, count);
    if (first != second || memcmp(text, bytes, count) != 0) {
        abort();
    }
    free(text);
    return 0;
}
