/* Sentences for the user, on standard error. */

#ifndef REPORT_H
#define REPORT_H

#include "sins.h"

/* What the program ends with. */
enum { DONE = 0, FAILED = 1, BAD_INPUT = 2, INTERRUPTED = 130 };

/* As printf, behind the program's name and with a line end. */
void report(const char *format, ...);

/* The sentence of the last failed call on sim; NULL: of the last one on this thread without a simulator. */
void library_sentence(const sins_sim *sim, char *sentence, size_t capacity);

/* Whether a call failed; then its sentence is reported. */
int refused(const sins_sim *sim, sins_status status);

#endif
