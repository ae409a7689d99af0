#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "number.h"
#include "toml_parts.h"

static int is_digit(int letter)
{
    return letter >= '0' && letter <= '9';
}

/* Adds a Unicode character as UTF-8. 0, or -1 if there is no room. */
static int append_character(struct value *value, uint32_t code)
{
    static const unsigned char lead[] = { 0, 0x00, 0xC0, 0xE0, 0xF0 };
    size_t length = code < 0x80 ? 1 : code < 0x800 ? 2 : code < 0x10000 ? 3 : 4, i;

    if (value->count + length >= VALUE_TEXT_SIZE) {
        return -1;
    }
    for (i = length; i > 1; i--, code >>= 6) {
        value->text[value->count + i - 1] = (char)(0x80 | (code & 0x3F));
    }
    value->text[value->count] = (char)(lead[length] | code);
    value->count += length;
    return 0;
}

/* The character behind \u or \U; 0 if there is none. */
static uint32_t read_hexadecimal(struct toml_reader *reader, int digits)
{
    uint32_t code = 0;

    for (; digits > 0; digits--, reader->at++) {
        static const char alphabet[] = "0123456789abcdef0123456789ABCDEF";
        int letter = toml_peek(reader, 0);
        const char *found = letter > 0 ? strchr(alphabet, letter) : NULL;

        if (found == NULL) {
            return 0;
        }
        code = code << 4 | (uint32_t)((found - alphabet) & 15);
    }
    return code > 0x10FFFF || (code >= 0xD800 && code < 0xE000) ? 0 : code;
}

/* What stands behind a backslash; 0 if it is no character. */
static uint32_t read_escape(struct toml_reader *reader)
{
    static const char letters[] = "btnfr\"\\", meant[] = "\b\t\n\f\r\"\\";
    int letter = toml_peek(reader, 0);
    const char *found = letter > 0 ? strchr(letters, letter) : NULL;

    reader->at += letter >= 0;
    if (found != NULL) {
        return (uint32_t)meant[found - letters];
    }
    return letter == 'u' ? read_hexadecimal(reader, 4) : letter == 'U' ? read_hexadecimal(reader, 8) : 0;
}

static int read_string(struct toml_reader *reader, struct value *value)
{
    int quote = *reader->at++;

    if (toml_peek(reader, 0) == quote && toml_peek(reader, 1) == quote) {
        return toml_refuse(reader, "strings over several lines are not accepted");
    }
    value->type = VALUE_TEXT;
    value->count = 0;
    while (toml_peek(reader, 0) != quote) {
        int letter = toml_peek(reader, 0);
        int has_room;

        if (letter < 0 || letter == '\n' || letter == '\r') {
            return toml_refuse(reader, "a string without its closing quote");
        }
        reader->at++;
        if (letter == '\\' && quote == '"') {
            uint32_t code = read_escape(reader);

            if (code == 0) {
                return toml_refuse(reader, "\\ with no escape that is accepted; 'single quotes' take it as it is");
            }
            has_room = append_character(value, code) == 0;
        } else {
            has_room = value->count + 1 < VALUE_TEXT_SIZE;
            if (has_room) {
                value->text[value->count++] = (char)letter;
            }
        }
        if (!has_room) {
            return toml_refuse(reader, "a string of more than 1023 bytes");
        }
    }
    reader->at++;
    value->text[value->count] = '\0';
    return 0;
}

/* Digits with single _ between them: how many characters; 0 if it is not so. */
static size_t digits_at(const char *text)
{
    size_t length = 0;

    while (is_digit(text[length]) || (text[length] == '_' && length > 0 && is_digit(text[length - 1]))) {
        length++;
    }
    return length > 0 && text[length - 1] == '_' ? 0 : length;
}

/* Whether text is a number by TOML's grammar, and whether a whole one. */
static int is_number(const char *text, int *is_whole)
{
    size_t digits;

    text += *text == '+' || *text == '-';
    digits = digits_at(text);
    if (digits == 0 || (*text == '0' && digits > 1)) {
        return 0;
    }
    text += digits;
    *is_whole = *text == '\0';
    if (*text == '.') {
        digits = digits_at(text + 1);
        text += digits > 0 ? 1 + digits : 0;
    }
    if (*text == 'e' || *text == 'E') {
        text += text[1] == '+' || text[1] == '-' ? 2 : 1;
        digits = digits_at(text);
        text += digits;
        return digits > 0 && *text == '\0';
    }
    return *text == '\0';
}

/* What a word that is no number was meant to be. */
static const char *problem_of(const char *word)
{
    const char *number = word + (*word == '+' || *word == '-');

    if (strcmp(number, "inf") == 0 || strcmp(number, "nan") == 0) {
        return "inf and nan are not accepted; expected a finite number";
    }
    if (*number == '0' && number[1] != '\0' && strchr("xob", number[1]) != NULL) {
        return "hexadecimal, octal and binary numbers are not accepted";
    }
    if (is_digit(*number) && (strchr(number, ':') != NULL || (strchr(number, '-') != NULL && strlen(number) >= 8))) {
        return "dates and times are not accepted";
    }
    if (is_digit(*number) || *number == '.' || number != word) {
        return "not a number as TOML writes it: digits on both sides of a point, no zeros in front";
    }
    return "expected a value: a \"string\", a number, true, false or an [array] of numbers";
}

/* Cuts the word that begins here out of the text. 0, or -1 refused. */
static int read_word(struct toml_reader *reader, char *word, size_t capacity)
{
    size_t length = 0;

    for (;;) {
        int letter = toml_peek(reader, 0);

        if (!is_digit(letter) && !(letter >= 'a' && letter <= 'z') && !(letter >= 'A' && letter <= 'Z')
            && (letter <= 0 || strchr("+-._:", letter) == NULL)) {
            word[length] = '\0';
            return 0;
        }
        if (length + 1 == capacity) {
            return toml_refuse(reader, "a value of more than 63 characters");
        }
        word[length++] = *reader->at++;
    }
}

static int read_number(struct toml_reader *reader, const char *word, struct value *value)
{
    char plain[TOML_NAME];
    size_t length = 0;
    int is_whole;

    if (!is_number(word, &is_whole)) {
        return toml_refuse(reader, problem_of(word));
    }
    for (; *word != '\0'; word++) {
        if (*word != '_') {
            plain[length++] = *word;
        }
    }
    plain[length] = '\0';
    value->type = VALUE_NUMBER;
    value->count = 1;
    if (is_whole) {
        long long number;

        errno = 0;
        number = strtoll(plain, NULL, 10);
        if (errno != 0) {
            return toml_refuse(reader, "a whole number beyond 64 bits");
        }
        value->type = number >= 0 ? VALUE_WHOLE : VALUE_NUMBER;
        value->whole = number >= 0 ? (uint64_t)number : 0;
    }
    return number_read(plain, &value->numbers[0]) ? 0 : toml_refuse(reader, "a number too large");
}

static int read_plain(struct toml_reader *reader, struct value *value)
{
    char word[TOML_NAME];

    if (read_word(reader, word, sizeof word) != 0) {
        return -1;
    }
    if (strcmp(word, "true") == 0 || strcmp(word, "false") == 0) {
        value->type = VALUE_TRUTH;
        value->whole = word[0] == 't';
        return 0;
    }
    return read_number(reader, word, value);
}

/* Blanks, comments and line ends. */
static void skip_space(struct toml_reader *reader)
{
    do {
        toml_skip_blanks(reader);
        toml_skip_comment(reader);
    } while (toml_skip_line_end(reader));
}

static int read_array(struct toml_reader *reader, struct value *array)
{
    size_t count = 0;

    reader->at++;
    for (;;) {
        struct value element;

        skip_space(reader);
        if (toml_peek(reader, 0) == ']') {
            break;
        }
        if (toml_peek(reader, 0) == '[') {
            return toml_refuse(reader, "arrays in arrays are not accepted; nine numbers are a matrix, row by row");
        }
        if (count == VALUE_NUMBERS) {
            return toml_refuse(reader, "an array of more than 9 numbers");
        }
        if (read_plain(reader, &element) != 0) {
            return -1;
        }
        if (element.type == VALUE_TRUTH) {
            return toml_refuse(reader, "expected a number in the array");
        }
        array->numbers[count++] = element.numbers[0];
        skip_space(reader);
        if (toml_peek(reader, 0) == ',') {
            reader->at++;
        } else if (toml_peek(reader, 0) != ']') {
            return toml_refuse(reader, "expected , or ] in the array");
        }
    }
    reader->at++;
    array->type = VALUE_ARRAY;
    array->count = count;
    return 0;
}

int toml_read_value(struct toml_reader *reader, struct value *value)
{
    switch (toml_peek(reader, 0)) {
    case '"':
    case '\'':
        return read_string(reader, value);
    case '[':
        return read_array(reader, value);
    case '{':
        return toml_refuse(reader, "tables in braces are not accepted; begin a [section]");
    default:
        return read_plain(reader, value);
    }
}
