/* What matc's --pareto and --max-error do: measure, and put what was found into words and pictures. Prints nothing. */
#ifndef MATC_MEASURE_PARETO_H
#define MATC_MEASURE_PARETO_H
#include "runtime/measure/measure.h"

typedef struct {
    const MatcDocument *document; /* read with `pixels` */
    int material;
    GlKind gl;
    double range; /* coordinates that count are in [-range, range] */
} ParetoSubject;

/* Measures every combination of what `options` leave open, for some 40 seconds, and writes BASENAME.csv, .svg and .png (no
 * files without a basename). The noise is open too: each has itself as its reference. *table is to be printed, from malloc;
 * it also says what could not be done. False: see `error`. */
bool pareto_measure(const ParetoSubject *subject, const MatcOptions *options, const char *basename, char **table,
                    char *error, size_t room);

/* Sets, in *options, the fastest choices whose greatest packed error at any slot and point is at most `most`. Noise, aa and
 * derivatives say what is computed: they are as the options name them, or their defaults. All else that the options do not name
 * is chosen. *why, from malloc, tells what was chosen and why. False: no choice is that exact, or nothing can be measured; see
 * `error`. */
bool pareto_choose(const ParetoSubject *subject, double most, MatcOptions *options, char **why, char *error,
                   size_t room);

/* Error and aliasing against time: two panels, as SVG. From malloc. */
char *pareto_svg(const MeasuredList *list, const char *title, const GlContext *gl);
#endif
