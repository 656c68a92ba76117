/* A progress line, overwritten in place on the terminal. */
#include "compiler/base/progress.h"

static const double step = 0.1; /* min seconds between two lines */

const char *progress_line(Text *out, const char *what, double now, double *last)
{
    if (*last != 0 && now - *last < step)
        return "";
    *last = now;
    text_format(out, "\r\033[K%s\r", what);
    return out->at;
}

const char *progress_erase(double *last)
{
    const bool written = *last != 0;
    *last = 0;
    return written ? "\r\033[K" : "";
}
