/* A scene from a file: sections and keys into settings. */

#ifndef SCENE_FILE_H
#define SCENE_FILE_H

#include "settings.h"
#include "toml.h"

struct scene_text {
    char bytes[TOML_BYTES + 1]; /* one more than is taken shows what is too long */
    size_t length;
};

/* Reads the file. 0, or -1 reported. */
int scene_file_load(struct scene_text *text, const char *path);

/* Sets what the text says in settings that have begun, with the path in scene_file. 0, or -1: up to 20 faults reported,
 * none behind what is no TOML. */
int scene_file_apply(struct settings *set, const char *bytes, size_t length);

#endif
