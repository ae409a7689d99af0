#include "option_table.h"

#include <stdio.h>
#include <string.h>

static void append(char *text, size_t capacity, const char *piece)
{
    size_t length = strlen(text);

    snprintf(text + length, capacity - length, "%s", piece);
}

static void append_number(char *text, size_t capacity, const char *before, double number)
{
    char piece[40];

    snprintf(piece, sizeof piece, "%s%.6g", before, number);
    append(text, capacity, piece);
}

static void describe(const struct settings *set, const struct option *option, char *text, size_t capacity)
{
    const double *values = (const double *)(const void *)((const char *)set + option->at);
    const size_t *which;
    size_t count = option_elements(option, &which), i;
    int is_set = 0, is_same = 1;

    for (i = 0; i < count; i++) {
        is_set = is_set || values[which[i]] != 0;
        is_same = is_same && values[which[i]] == values[which[0]];
    }
    if (!is_set) {
        return;
    }
    append(text, capacity, text[0] == '\0' ? "" : ", ");
    append(text, capacity, option->noun);
    for (i = 0; i < (is_same ? 1 : count); i++) {
        append_number(text, capacity, i == 0 ? " " : "/", values[which[i]] / option->unit);
    }
    append(text, capacity, " ");
    append(text, capacity, option->unit_text);
    if (option->kind == OPTION_MARKOV) {
        const double *time_s = (const double *)(const void *)((const char *)set + option->time_at);

        append_number(text, capacity, " with time ", *time_s);
        append(text, capacity, " s");
    }
}

void option_word(const struct settings *set, const char *name, char *word, size_t capacity)
{
    const struct option *option = option_table;
    const char *words;
    int32_t index;

    while (strcmp(option->name, name) != 0) {
        option++;
    }
    words = option->operand;
    for (index = *(const int32_t *)(const void *)((const char *)set + option->at); index > 0; index--) {
        words = strchr(words, '|') + 1;
    }
    snprintf(word, capacity, "%.*s", (int)strcspn(words, "|"), words);
}

void options_describe(const struct settings *set, enum option_group group, char *text, size_t capacity)
{
    size_t i;

    text[0] = '\0';
    for (i = 0; i < option_table_length; i++) {
        if (option_table[i].group == group) {
            describe(set, &option_table[i], text, capacity);
        }
    }
    if (group == GROUP_START && set->initial.alignment == SINS_ALIGNMENT_LEVEL_AND_GYROCOMPASS) {
        append(text, capacity, text[0] == '\0' ? "levelling and gyrocompassing" : ", levelling and gyrocompassing");
    }
    if (text[0] == '\0') {
        append(text, capacity, "none");
    }
}

void options_print_help(void)
{
    /* By group. */
    static const char *const headings[] = {
        "run", "simulator", "gyro errors: one number for all axes or X,Y,Z with commas",
        "accelerometer errors: likewise", "altimeter errors, with --vertical damped",
        "errors at the start: computed less true"
    };
    size_t i;

    puts("usage: sins_harness SCENE [options]\n"
         "\n"
         "Flies a strapdown inertial navigation system, writes its records and figures as\n"
         "DIR/NAME.csv and DIR/NAME_summary.csv, and prints a summary.\n"
         "\n"
         "scenes\n"
         "  simulation1        the paper's: no sensor errors, 48 h\n"
         "  simulation2        the paper's: gyro bias 0.01 deg/h, angle random walk 0.005 deg/sqrt(h),\n"
         "                     accelerometer bias 10 micro-g, white noise 5 micro-g/sqrt(Hz), 48 h\n"
         "  flight FILE.csv    a flight log with the columns time_s, latitude_rad, longitude_rad, height_m,\n"
         "                     velocity_east_m_s, velocity_north_m_s, velocity_up_m_s (all three or none),\n"
         "                     roll_rad, pitch_rad, heading_rad; angles also as latitude_deg and so on;\n"
         "                     as well, if there, rate_x_rad_s, .._y_.., .._z_.. and force_x_m_s2, ..\n"
         "  embedded NAME      a built-in flight; \"embedded list\" names them");
    for (i = 0; i < option_table_length; i++) {
        const struct option *option = &option_table[i];
        char usage[80];

        if (i == 0 || option->group != option_table[i - 1].group) {
            printf("\n%s\n", headings[option->group]);
        }
        snprintf(usage, sizeof usage, "%s %s", option->name, option->operand);
        printf("  %-42s %s", usage, option->noun);
        printf(option->unit_text[0] != '\0' ? " [%s]\n" : "\n", option->unit_text);
    }
    puts("\nexit code: 0 done, 1 failed, 2 bad option or file, 130 interrupted (files are whole)");
}
