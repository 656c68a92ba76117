/* A progress line of a long run. Callers print nothing unless standard error is a terminal. */
#ifndef MATC_PROGRESS_H
#define MATC_PROGRESS_H
#include "compiler/base/text.h"

/* Returns the text to print at time `now` in seconds, or "" if the last line is less than 0.1 s
 * old. `last` is the time of the last line, 0 before the first. */
const char *progress_line(Text *out, const char *what, double now, double *last);
/* Returns the text that erases the line; "" if no line was printed. */
const char *progress_erase(double *last);
#endif
