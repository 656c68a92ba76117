/* Implements matc's --pareto and --max-error: measures, and writes the results as words and
 * pictures. Prints nothing. */
#ifndef MATC_MEASURE_PARETO_H
#define MATC_MEASURE_PARETO_H
#include "runtime/measure/measure.h"

typedef struct {
    const MatcDocument *document; /* read with `pixels` */
    int material;
    GlKind gl;
    double range;         /* coordinates that count are in [-range, range] */
    const char *basename; /* of the files to be written, or NULL */
    /* programs that errors were measured of; NULL: nobody asks */
    void (*progress)(void *user, int done, int total);
    void *user;
} ParetoSubject;

typedef struct {
    char *text;       /* to be printed, from malloc */
    char error[4096]; /* what went wrong; there is no text then */
} ParetoAnswer;

/* Measures every combination of what `options` leave open, for some 40 seconds, and writes
 * BASENAME.csv, .svg and .png. The noise is open too: each has itself as its reference. The text is
 * a table, and says what could not be done. False: see the error. */
bool pareto_measure(const ParetoSubject *subject, const MatcOptions *options, ParetoAnswer *answer);

/* Sets, in *options, the fastest choices whose greatest packed error at any slot and point is at
 * most `most`. Noise, aa and derivatives say what is computed: they are as the options name them,
 * or their defaults. All else that the options do not name is chosen. The text tells what was
 * chosen and why. False: no choice is that exact, or nothing can be measured; see the error. */
bool pareto_choose(const ParetoSubject *subject, double most, MatcOptions *options,
                   ParetoAnswer *answer);

/* Error and aliasing against time: two panels, as SVG. From malloc. */
char *pareto_svg(const MeasuredList *list, const char *title, const GlContext *gl);
#endif
