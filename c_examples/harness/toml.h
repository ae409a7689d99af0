/* Reader of a subset of TOML 1.0. Every text that it takes is TOML, but for keys and tables that stand twice: those are
 * for the caller to refuse. A pure function of the bytes, which need no terminator; nothing is allocated.
 *
 * Taken: comments; [table] and [[array of tables]], their names bare words with dots between; key = value, the key one
 * bare word; "basic" and 'literal' strings on one line; decimal numbers, true, false; arrays of numbers, on several
 * lines too. A byte order mark before it all is passed over. Whatever else TOML has is refused by name. */

#ifndef TOML_H
#define TOML_H

#include "value.h"

enum { TOML_BYTES = 1 << 20, TOML_LINE = 4096, TOML_NAME = 64 };

enum toml_kind { TOML_TABLE, TOML_ARRAY_OF_TABLES, TOML_KEY };

struct toml_item {
    enum toml_kind kind;
    long line;
    char name[TOML_NAME];
    struct value value; /* TOML_KEY */
};

struct toml_reader {
    const char *at;
    const char *end;
    long line;           /* from 1; after a refusal the one at fault */
    const char *problem; /* after a refusal what is wrong; else NULL */
};

void toml_begin(struct toml_reader *reader, const char *bytes, size_t length);

/* 1: an item; 0: the end; -1: refused, and so is every further call. */
int toml_next(struct toml_reader *reader, struct toml_item *item);

#endif
