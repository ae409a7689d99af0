/* An output file that is whole or not there: written under a temporary name, renamed at the end. */

#ifndef WHOLE_FILE_H
#define WHOLE_FILE_H

#include <stdio.h>

struct whole_file {
    FILE *stream;
    char path[1024];
    char temporary[1040];
};

/* DIRECTORY/NAME.ending, or a path. These report what goes wrong and give 0 or -1. */
int whole_file_open(struct whole_file *file, const char *directory, const char *name, const char *ending);
int whole_file_open_path(struct whole_file *file, const char *path);
int whole_file_check(struct whole_file *file);
int whole_file_commit(struct whole_file *file);

/* Leaves nothing; harmless after a commit or a failed open. */
void whole_file_discard(struct whole_file *file);

#endif
