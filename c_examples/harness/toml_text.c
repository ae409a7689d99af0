#include "toml_parts.h"

/* The bytes of the UTF-8 character that begins here (Unicode 15, table 3-7); 0 if it is none. */
static size_t character(const struct toml_reader *reader)
{
    int first = toml_peek(reader, 0), second = toml_peek(reader, 1);
    int low = first == 0xE0 ? 0xA0 : first == 0xF0 ? 0x90 : 0x80;
    int high = first == 0xED ? 0x9F : first == 0xF4 ? 0x8F : 0xBF;
    size_t length = first < 0x80 ? 1 : first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
    size_t i;

    if (length > 1 && (second < low || second > high)) {
        return 0;
    }
    for (i = 2; i < length; i++) {
        if ((toml_peek(reader, i) & ~0x3F) != 0x80) {
            return 0;
        }
    }
    return length;
}

int toml_check_text(struct toml_reader *reader)
{
    const char *line_begin = reader->at;

    if ((size_t)(reader->end - reader->at) > TOML_BYTES) {
        return toml_refuse(reader, "the text is longer than 1 MiB");
    }
    while (reader->at < reader->end) {
        int byte = toml_peek(reader, 0);
        size_t length = character(reader);

        if (toml_skip_line_end(reader)) {
            line_begin = reader->at;
            continue;
        }
        if (byte == 0) {
            return toml_refuse(reader, "a zero byte; expected text");
        }
        if (byte == '\r') {
            return toml_refuse(reader, "a carriage return without a line feed");
        }
        if ((byte < ' ' && byte != '\t') || byte == 0x7F) {
            return toml_refuse(reader, "a control character; expected text");
        }
        if (length == 0) {
            return toml_refuse(reader, "a byte that is no UTF-8; save the file as UTF-8");
        }
        reader->at += length;
        if (reader->at - line_begin > TOML_LINE) {
            return toml_refuse(reader, "a line of more than 4096 bytes");
        }
    }
    return 0;
}
