/* A line on a terminal that says how far a long run is. Where standard error is none, nothing is
 * written. */
#ifndef MATC_PROGRESS_H
#define MATC_PROGRESS_H
#include "compiler/base/text.h"

/* Text to write at `now`, in seconds; "" if the last one is younger than a tenth of a second.
 * `last` is the time of the last one, 0 before the first. */
const char *progress_line(Text *out, const char *what, double now, double *last);
/* Text that erases the line; "" if none was written. */
const char *progress_erase(double *last);
#endif
