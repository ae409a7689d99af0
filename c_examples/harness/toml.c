#include "toml.h"

#include <string.h>

#include "toml_parts.h"

int toml_peek(const struct toml_reader *reader, size_t ahead)
{
    return ahead < (size_t)(reader->end - reader->at) ? (unsigned char)reader->at[ahead] : -1;
}

void toml_skip_blanks(struct toml_reader *reader)
{
    while (toml_peek(reader, 0) == ' ' || toml_peek(reader, 0) == '\t') {
        reader->at++;
    }
}

void toml_skip_comment(struct toml_reader *reader)
{
    if (toml_peek(reader, 0) == '#') {
        while (toml_peek(reader, 0) != '\n' && toml_peek(reader, 0) != '\r' && reader->at < reader->end) {
            reader->at++;
        }
    }
}

int toml_skip_line_end(struct toml_reader *reader)
{
    int first = toml_peek(reader, 0);
    size_t length = first == '\n' ? 1 : first == '\r' && toml_peek(reader, 1) == '\n' ? 2 : 0;

    reader->at += length;
    reader->line += length > 0;
    return length > 0;
}

int toml_refuse(struct toml_reader *reader, const char *problem)
{
    reader->problem = problem;
    return -1;
}

void toml_begin(struct toml_reader *reader, const char *bytes, size_t length)
{
    static const char byte_order_mark[] = "\xEF\xBB\xBF";
    struct toml_reader text;

    memset(reader, 0, sizeof *reader);
    reader->at = bytes;
    reader->end = bytes + length;
    reader->line = 1;
    if (length >= 3 && memcmp(bytes, byte_order_mark, 3) == 0) {
        reader->at += 3;
    }
    text = *reader;
    if (toml_check_text(&text) != 0) {
        *reader = text;
    }
}

static int is_bare(int letter)
{
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9')
        || letter == '_' || letter == '-';
}

/* A bare word behind what name has already. */
static int read_word(struct toml_reader *reader, char *name)
{
    size_t length = strlen(name), before = length;

    if (toml_peek(reader, 0) == '"' || toml_peek(reader, 0) == '\'') {
        return toml_refuse(reader, "names in quotes are not accepted; write them without");
    }
    while (is_bare(toml_peek(reader, 0))) {
        if (length + 1 == TOML_NAME) {
            return toml_refuse(reader, "a name of more than 63 characters");
        }
        name[length++] = *reader->at++;
    }
    name[length] = '\0';
    return length > before ? 0 : toml_refuse(reader, "expected a [section] or a name = value");
}

/* Words with dots between them. */
static int read_table_name(struct toml_reader *reader, char *name)
{
    for (;;) {
        size_t length;

        toml_skip_blanks(reader);
        if (read_word(reader, name) != 0) {
            return -1;
        }
        toml_skip_blanks(reader);
        if (toml_peek(reader, 0) != '.') {
            return 0;
        }
        reader->at++;
        length = strlen(name);
        if (length + 1 == TOML_NAME) {
            return toml_refuse(reader, "a name of more than 63 characters");
        }
        memcpy(name + length, ".", 2);
    }
}

static int read_header(struct toml_reader *reader, struct toml_item *item)
{
    size_t brackets = toml_peek(reader, 1) == '[' ? 2 : 1, i;

    item->kind = brackets == 2 ? TOML_ARRAY_OF_TABLES : TOML_TABLE;
    reader->at += brackets;
    if (read_table_name(reader, item->name) != 0) {
        return -1;
    }
    for (i = 0; i < brackets; i++) {
        if (toml_peek(reader, i) != ']') {
            return toml_refuse(reader, brackets == 2 ? "expected ]] behind the name" : "expected ] behind the name");
        }
    }
    reader->at += brackets;
    return 0;
}

static int read_key(struct toml_reader *reader, struct toml_item *item)
{
    item->kind = TOML_KEY;
    if (read_word(reader, item->name) != 0) {
        return -1;
    }
    toml_skip_blanks(reader);
    if (toml_peek(reader, 0) == '.') {
        return toml_refuse(reader, "names with dots are not accepted before =; begin a [section]");
    }
    if (toml_peek(reader, 0) != '=') {
        return toml_refuse(reader, "expected = behind the name");
    }
    reader->at++;
    toml_skip_blanks(reader);
    return toml_read_value(reader, &item->value);
}

int toml_next(struct toml_reader *reader, struct toml_item *item)
{
    if (reader->problem != NULL) {
        return -1;
    }
    do {
        toml_skip_blanks(reader);
        toml_skip_comment(reader);
    } while (toml_skip_line_end(reader));
    if (reader->at == reader->end) {
        return 0;
    }
    memset(item, 0, sizeof *item);
    item->line = reader->line;
    if ((toml_peek(reader, 0) == '[' ? read_header(reader, item) : read_key(reader, item)) != 0) {
        return -1;
    }
    toml_skip_blanks(reader);
    toml_skip_comment(reader);
    if (reader->at < reader->end && !toml_skip_line_end(reader)) {
        return toml_refuse(reader, "expected the end of the line");
    }
    return 1;
}
