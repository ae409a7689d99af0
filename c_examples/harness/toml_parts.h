/* What the files of the TOML reader share. */

#ifndef TOML_PARTS_H
#define TOML_PARTS_H

#include "toml.h"

/* The byte `ahead` of the reader, -1 behind the end. */
int toml_peek(const struct toml_reader *reader, size_t ahead);

void toml_skip_blanks(struct toml_reader *reader);

/* Passes over a comment, if there is one, up to the end of its line. */
void toml_skip_comment(struct toml_reader *reader);

/* Passes over the end of a line. Whether there was one. */
int toml_skip_line_end(struct toml_reader *reader);

/* Keeps what is wrong. Gives -1. */
int toml_refuse(struct toml_reader *reader, const char *problem);

/* Whether bytes are lines of UTF-8 without control characters; else -1, refused. */
int toml_check_text(struct toml_reader *reader);

/* Reads the value that begins here. 0, or -1 refused. */
int toml_read_value(struct toml_reader *reader, struct value *value);

#endif
