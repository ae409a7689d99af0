/* The command line: a scene, and options that override it. */

#ifndef COMMAND_LINE_H
#define COMMAND_LINE_H

#include "settings.h"

/* 0, or -1 reported. With help or keys set nothing else is wanted. */
int command_line_read(struct settings *set, int count, char **arguments);

#endif
