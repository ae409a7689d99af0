/* What differs between operating systems. */

#ifndef HOST_H
#define HOST_H

/* Monotonic wall clock [s]. */
double host_seconds(void);

int host_has_terminal(void);

/* From now on Ctrl-C only sets a flag; a second one ends the program. */
void host_catch_interrupt(void);
int host_interrupted(void);

/* Makes a directory and those above it. 0, or -1 with errno set. */
int host_make_directory(const char *path);

/* Renames a file, over an older one of that name. 0, or -1 with errno set. */
int host_replace_file(const char *from, const char *to);

#endif
