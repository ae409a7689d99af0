/* Sentences about a setting, which begin with where it was set: "scene.toml:12: gyro.bias_deg_h: ", or
 * "sins_harness: --gyro-bias: ". */

#ifndef COMPLAIN_H
#define COMPLAIN_H

#include "option_table.h"

/* About an option, by its place in struct settings. */
void complain(const struct settings *set, const char *field, const char *format, ...);

/* About the scene file: a line, 0 for the whole of it. */
void complain_at(const struct settings *set, long line, const char *format, ...);

/* Whether a call failed; then its sentence is reported, at the setting that it names. sim NULL: as in report.h. */
int refused_setting(const struct settings *set, const sins_sim *sim, sins_status status);

#endif
