/* A line on a terminal that says how far a long run is. Where standard error is none, nothing is
 * written. */
#ifndef MATC_PROGRESS_H
#define MATC_PROGRESS_H
#include "compiler/base/text.h"

/* What is to be written for it at `now`, in seconds: "" where the last one is younger than a tenth
 * of a second; *last is its time, 0 before the first. */
const char *progress_line(Text *out, const char *what, double now, double *last);
/* What takes the line away; "" where none was written. */
const char *progress_erase(double *last);
#endif
