#include "whole_file.h"

#include <errno.h>
#include <string.h>

#include "host.h"
#include "report.h"

static int cannot_write(const struct whole_file *file)
{
    report("cannot write %s: %s", file->path, strerror(errno));
    return -1;
}

static int open_temporary(struct whole_file *file)
{
    snprintf(file->temporary, sizeof file->temporary, "%s.part", file->path);
    file->stream = fopen(file->temporary, "wb");
    return file->stream == NULL ? cannot_write(file) : 0;
}

int whole_file_open(struct whole_file *file, const char *directory, const char *name, const char *ending)
{
    int length = snprintf(file->path, sizeof file->path, "%s/%s%s", directory, name, ending);

    file->stream = NULL;
    if (length < 0 || (size_t)length >= sizeof file->path) {
        report("--out %s, --name %s: the path is longer than %d characters", directory, name,
               (int)sizeof file->path - 1);
        return -1;
    }
    return open_temporary(file);
}

int whole_file_open_path(struct whole_file *file, const char *path)
{
    size_t length = strlen(path);

    file->stream = NULL;
    if (length >= sizeof file->path) {
        report("%s: the path is longer than %d characters", path, (int)sizeof file->path - 1);
        return -1;
    }
    memcpy(file->path, path, length + 1);
    return open_temporary(file);
}

int whole_file_check(struct whole_file *file)
{
    errno = 0;
    if (fflush(file->stream) == 0 && !ferror(file->stream)) {
        return 0;
    }
    errno = errno == 0 ? EIO : errno; /* the error was an earlier write's */
    return cannot_write(file);
}

int whole_file_commit(struct whole_file *file)
{
    int failed = whole_file_check(file);
    int closed = fclose(file->stream);

    file->stream = NULL;
    if (!failed && (closed != 0 || host_replace_file(file->temporary, file->path) != 0)) {
        failed = cannot_write(file);
    }
    if (failed) {
        remove(file->temporary);
    }
    return failed;
}

void whole_file_discard(struct whole_file *file)
{
    if (file->stream != NULL) {
        fclose(file->stream);
        remove(file->temporary);
        file->stream = NULL;
    }
}
