#include "flight_csv.h"

#include <errno.h>
#include <stddef.h>
#include <string.h>

#include "number.h"
#include "report.h"

struct quantity {
    const char *name;
    const char *name_in_degrees; /* NULL: none */
    size_t at;                   /* in sins_flight_sample */
};

#define SAMPLE(member) offsetof(sins_flight_sample, member)

static const struct quantity quantities[FLIGHT_CSV_QUANTITIES] = {
    { "time_s", NULL, SAMPLE(time_s) },
    { "latitude_rad", "latitude_deg", SAMPLE(latitude_rad) },
    { "longitude_rad", "longitude_deg", SAMPLE(longitude_rad) },
    { "height_m", NULL, SAMPLE(height_m) },
    { "velocity_east_m_s", NULL, SAMPLE(velocity_enu_m_s) },
    { "velocity_north_m_s", NULL, SAMPLE(velocity_enu_m_s) + sizeof(double) },
    { "velocity_up_m_s", NULL, SAMPLE(velocity_enu_m_s) + 2 * sizeof(double) },
    { "roll_rad", "roll_deg", SAMPLE(roll_rad) },
    { "pitch_rad", "pitch_deg", SAMPLE(pitch_rad) },
    { "heading_rad", "heading_deg", SAMPLE(heading_rad) },
    { "rate_x_rad_s", NULL, SAMPLE(angular_rate_rad_s) },
    { "rate_y_rad_s", NULL, SAMPLE(angular_rate_rad_s) + sizeof(double) },
    { "rate_z_rad_s", NULL, SAMPLE(angular_rate_rad_s) + 2 * sizeof(double) },
    { "force_x_m_s2", NULL, SAMPLE(specific_force_m_s2) },
    { "force_y_m_s2", NULL, SAMPLE(specific_force_m_s2) + sizeof(double) },
    { "force_z_m_s2", NULL, SAMPLE(specific_force_m_s2) + 2 * sizeof(double) },
    { "temperature_c", NULL, SAMPLE(temperature_c) }
};

/* First index of the triples that a log may leave out, and the one that it may leave out by itself. */
enum { VELOCITY = 4, RATE = 10, FORCE = 13, TEMPERATURE = 16 };

static int bad(const struct flight_csv *csv, int column, const char *found, const char *expected, const char *name)
{
    char excerpt[44];
    char *letter;

    snprintf(excerpt, sizeof excerpt, "%.40s%s", found, strlen(found) > 40 ? "..." : "");
    for (letter = excerpt; *letter != '\0'; letter++) {
        *letter = (unsigned char)*letter < ' ' || *letter == 0x7F ? '?' : *letter;
    }
    fprintf(stderr, "%s:%ld:%d: \"%s\" %s", csv->path, csv->line, column, excerpt, expected);
    fprintf(stderr, name == NULL ? "\n" : " (%s)\n", name);
    return -1;
}

/* The comment that a log may begin with, in plain letters. */
static void keep_title(struct flight_csv *csv)
{
    const char *text = csv->text + strspn(csv->text, "# \t");
    size_t i;

    for (i = 0; i + 1 < sizeof csv->title && text[i] != '\0'; i++) {
        csv->title[i] = text[i] >= ' ' && text[i] <= '~' ? text[i] : '?';
    }
}

/* A byte that no line has inside: text would end there, or go on as a line of its own. */
static int refuse_byte(struct flight_csv *csv, size_t at)
{
    const char *expected = csv->text[at] == '\0' ? "is followed by a zero byte; expected text"
                                                : "is followed by a carriage return without a line feed";
    char *field = csv->text, *comma;
    int column = 1;

    for (csv->text[at] = '\0'; (comma = strchr(field, ',')) != NULL; field = comma + 1) {
        column++;
    }
    return bad(csv, column, field, expected, NULL);
}

/* Reads a line, without its \n or \r\n. 1, 0 at the end, -1 reported. */
static int read_line(struct flight_csv *csv)
{
    size_t length = 0, i;
    int letter;

    while ((letter = getc(csv->stream)) != EOF && letter != '\n' && length < sizeof csv->text - 1) {
        csv->text[length++] = (char)letter;
    }
    if (letter == EOF && ferror(csv->stream)) {
        report("%s: %s", csv->path, strerror(errno));
        return -1;
    }
    if (letter == EOF && length == 0) {
        return 0;
    }
    csv->line++;
    if (letter == '\n' && length > 0 && csv->text[length - 1] == '\r') {
        length--;
    }
    csv->text[length] = '\0';
    for (i = 0; i < length; i++) {
        if (csv->text[i] == '\0' || csv->text[i] == '\r') {
            return refuse_byte(csv, i);
        }
    }
    return letter == EOF || letter == '\n' ? 1 : bad(csv, 1, csv->text, "begins a line too long", NULL);
}

/* Reads the next line that is neither empty nor a comment. 1, 0 at the end, -1 reported. */
static int next_line(struct flight_csv *csv)
{
    int found;

    while ((found = read_line(csv)) == 1) {
        if (csv->line == 1 && csv->text[0] == '#') {
            keep_title(csv);
        }
        if (csv->text[0] != '#' && csv->text[strspn(csv->text, " \t")] != '\0') {
            break;
        }
    }
    return found;
}

/* Cuts the field that begins at text out of the line; gives where the next one begins, NULL after the last. */
static char *cut_field(char *text, char **field)
{
    char *comma = strchr(text, ',');
    char *end = comma != NULL ? comma : text + strlen(text);

    while (*text == ' ' || *text == '\t') {
        text++;
    }
    while (end > text && (end[-1] == ' ' || end[-1] == '\t')) {
        end--;
    }
    *end = '\0';
    *field = text;
    return comma != NULL ? comma + 1 : NULL;
}

static int take_column(struct flight_csv *csv, const char *name, int column)
{
    int i;

    for (i = 0; i < FLIGHT_CSV_QUANTITIES; i++) {
        int in_degrees = quantities[i].name_in_degrees != NULL && strcmp(name, quantities[i].name_in_degrees) == 0;

        if (!in_degrees && strcmp(name, quantities[i].name) != 0) {
            continue;
        }
        if (csv->column[i] != 0) {
            return bad(csv, column, name, "gives a quantity that an earlier column has", quantities[i].name);
        }
        csv->column[i] = column;
        csv->unit[i] = in_degrees ? SINS_DEG : 1.0;
    }
    return 0;
}

/* Whether the three columns from first on are there: all or none of them. */
static int has_triple(const struct flight_csv *csv, int first)
{
    return csv->column[first] || csv->column[first + 1] || csv->column[first + 2];
}

static int report_missing_columns(const struct flight_csv *csv)
{
    int missing = 0, i;

    for (i = 0; i < TEMPERATURE; i++) {
        int is_in_triple = (i >= VELOCITY && i < VELOCITY + 3) || i >= RATE;
        int first = i < RATE ? VELOCITY : i < FORCE ? RATE : FORCE;

        if (csv->column[i] == 0 && (!is_in_triple || has_triple(csv, first))) {
            if (missing++ == 0) {
                fprintf(stderr, "%s:%ld:1: missing columns:", csv->path, csv->line);
            }
            fprintf(stderr, " %s", quantities[i].name);
            if (quantities[i].name_in_degrees != NULL) {
                fprintf(stderr, " (or %s)", quantities[i].name_in_degrees);
            }
        }
    }
    if (missing > 0) {
        fputc('\n', stderr);
    }
    return missing > 0 ? -1 : 0;
}

static int read_header(struct flight_csv *csv)
{
    static const char byte_order_mark[] = "\xEF\xBB\xBF";
    int found = next_line(csv);
    int column = 0;
    char *text = csv->text;

    if (found <= 0) {
        if (found == 0) {
            report("%s: no header line; expected the names of the columns, as time_s,latitude_rad,...", csv->path);
        }
        return -1;
    }
    if (strncmp(text, byte_order_mark, 3) == 0) {
        text += 3;
    }
    while (text != NULL) {
        char *name;

        text = cut_field(text, &name);
        if (take_column(csv, name, ++column) != 0) {
            return -1;
        }
    }
    csv->flags = (has_triple(csv, VELOCITY) ? 0U : (uint32_t)SINS_SAMPLE_NO_VELOCITY)
               | (has_triple(csv, RATE) ? (uint32_t)SINS_SAMPLE_ANGULAR_RATE : 0U)
               | (has_triple(csv, FORCE) ? (uint32_t)SINS_SAMPLE_SPECIFIC_FORCE : 0U)
               | (csv->column[TEMPERATURE] ? (uint32_t)SINS_SAMPLE_TEMPERATURE : 0U);
    return report_missing_columns(csv);
}

int flight_csv_open(struct flight_csv *csv, const char *path)
{
    memset(csv, 0, sizeof *csv);
    csv->path = path;
    csv->stream = fopen(path, "rb");
    if (csv->stream == NULL) {
        report("%s: %s", path, strerror(errno));
        return -1;
    }
    if (read_header(csv) != 0) {
        flight_csv_close(csv);
        return -1;
    }
    return 0;
}

/* Which quantity a column has; -1 for one that is ignored. */
static int quantity_in(const struct flight_csv *csv, int column)
{
    int i;

    for (i = 0; i < FLIGHT_CSV_QUANTITIES; i++) {
        if (csv->column[i] == column) {
            return i;
        }
    }
    return -1;
}

static int report_short_line(const struct flight_csv *csv, int columns)
{
    int column = columns + 1, i;

    while ((i = quantity_in(csv, column)) < 0) {
        column++;
    }
    fprintf(stderr, "%s:%ld:%d: the line ends before %s\n", csv->path, csv->line, column, quantities[i].name);
    return -1;
}

int flight_csv_next(struct flight_csv *csv, sins_flight_sample *sample)
{
    char *text = csv->text;
    int found = next_line(csv);
    int column = 0, wanted = 0, i;

    if (found <= 0) {
        return found;
    }
    memset(sample, 0, sizeof *sample);
    sample->struct_size = sizeof *sample;
    sample->flags = csv->flags;
    for (i = 0; i < FLIGHT_CSV_QUANTITIES; i++) {
        wanted += csv->column[i] != 0;
    }
    while (text != NULL) {
        char *field;
        double value;

        text = cut_field(text, &field);
        i = quantity_in(csv, ++column);
        if (i < 0) {
            continue;
        }
        if (!number_read(field, &value)) {
            return bad(csv, column, field, "is not a number", quantities[i].name);
        }
        *(double *)(void *)((char *)sample + quantities[i].at) = value * csv->unit[i];
        wanted--;
    }
    return wanted > 0 ? report_short_line(csv, column) : 1;
}

void flight_csv_close(struct flight_csv *csv)
{
    if (csv->stream != NULL) {
        fclose(csv->stream);
        csv->stream = NULL;
    }
}
