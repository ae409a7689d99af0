#include "option_table.h"

#include <stdio.h>
#include <string.h>

/* What stands behind an option on the command line. */
static const char *operand_of(const struct option *option)
{
    switch (option->kind) {
    case OPTION_NUMBER:
        return "N";
    case OPTION_VECTOR:
        return "E,N,U";
    case OPTION_AXES:
        return "N|X,Y,Z";
    case OPTION_CROSS:
    case OPTION_DIAGONAL:
    case OPTION_MATRIX:
        return "N|XX,XY,..,ZZ";
    default:
        return option->operand;
    }
}

void options_print_help(void)
{
    int group;
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
         "                     as well, if there, rate_x_rad_s, .._y_.., .._z_.. and force_x_m_s2, ..,\n"
         "                     temperature_c of the sensors\n"
         "  embedded NAME      a built-in flight; \"embedded list\" names them\n"
         "  SCENE.toml         a scene from a file, flight, sensors, options and output; --keys lists what it\n"
         "                     may hold, more than the options here. Options override what the file says.");
    for (group = 0; group < OPTION_GROUPS; group++) {
        int begun = 0;

        for (i = 0; i < option_table_length; i++) {
            const struct option *option = &option_table[i];
            char usage[100];

            if ((int)option->group != group || option->name == NULL) {
                continue;
            }
            if (!begun++) {
                printf("\n%s\n", group == GROUP_FLIGHT ? "flight" : option_sections[group].heading);
            }
            snprintf(usage, sizeof usage, "%s %s", option->name, operand_of(option));
            printf("  %-42s", usage);
            printf(strlen(usage) > 42 ? "\n%45s%s" : "%1s%s", "", option->noun);
            printf(option->unit_text[0] != '\0' ? " [%s]\n" : "\n", option->unit_text);
        }
    }
    puts("\nexit code: 0 done, 1 failed, 2 bad option or file, 130 interrupted (files are whole)");
}

/* What a key takes, in a file. */
static const char *shape_of(const struct option *option)
{
    switch (option->kind) {
    case OPTION_FLAG:
        return "true|false";
    case OPTION_TEXT:
        return "\"text\"";
    case OPTION_COUNT:
    case OPTION_SEED:
        return "whole number";
    case OPTION_NUMBER:
        return "number";
    case OPTION_VECTOR:
        return "3 numbers";
    case OPTION_AXES:
        return "1 or 3 numbers";
    case OPTION_CROSS:
    case OPTION_DIAGONAL:
        return "1 or 9 numbers";
    case OPTION_MATRIX:
        return "9 numbers";
    default:
        return "one of";
    }
}

static void print_key(const struct option *option)
{
    int is_librarys = strchr(option->field, '.') != NULL && option->group != GROUP_SINUSOID
                   && strncmp(option->field, "failing.", 8) != 0;

    printf("  %-40s %-15s %s", option->key, shape_of(option), option->noun);
    if (option->unit_text[0] != '\0') {
        printf(" [%s]", option->unit_text);
    }
    if (is_librarys) {
        printf("; %s", option->field);
    }
    if (option->name != NULL) {
        printf("; %s", option->name);
    }
    putchar('\n');
    if (option->kind == OPTION_CHOICE) {
        printf("%58s %s\n", "", option->operand);
    }
}

void options_print_keys(void)
{
    int group;
    size_t i;

    puts("A scene file is TOML: [section]s of key = value, # begins a comment. \"Strings\" and 'strings' on one\n"
         "line, decimal numbers, true, false, arrays of numbers. Each key: what it takes; what it is, and its unit;\n"
         "the field of sins.h that it sets, which is described there; the option that overrides it. The single\n"
         "number of a misalignment stands for all elements off the diagonal, of g-sensitivity for those on it;\n"
         "nine numbers are a matrix, row by row, a row for each sensor.");
    for (group = 0; group < OPTION_GROUPS; group++) {
        const struct option_section *section = &option_sections[group];

        printf(section->is_array ? "\n[[%s]]  %s\n" : "\n[%s]  %s\n", section->name, section->heading);
        for (i = 0; i < option_table_length; i++) {
            if ((int)option_table[i].group == group && option_table[i].key != NULL) {
                print_key(&option_table[i]);
            }
        }
    }
}
