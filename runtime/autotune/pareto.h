/* Implements matc's --pareto and --max-error: measures, and formats the results as text and
 * plots. Prints nothing. */
#ifndef MATC_AUTOTUNE_PARETO_H
#define MATC_AUTOTUNE_PARETO_H
#include "runtime/autotune/autotune.h"

typedef struct {
    const MatcDocument *document; /* document read with the option `pixels` */
    int material;
    GlKind gl;
    double range;         /* relevant coordinates are in [-range, range] */
    const char *basename; /* base name of the output files; NULL: no files */
    /* called per measured program; NULL: no calls */
    void (*progress)(void *user, int done, int total);
    void *user;
} ParetoSubject;

typedef struct {
    char *text;       /* output text, from malloc */
    char error[4096]; /* error message; `text` is then unset */
} ParetoChoice;

/* Measures every combination of the choices that `options` leave open, within about 40 seconds,
 * and writes BASENAME.csv, .svg and .png. Noise varies too: each noise has its own reference.
 * The text is a table that also lists failures. Returns false with the reason in answer->error. */
bool pareto_measure(const ParetoSubject *subject, const MatcOptions *options, ParetoChoice *answer);

/* Sets the fastest choices in *options whose packed error is at most `most` at every slot and
 * point. Noise, aa and derivatives define what is computed and are never varied. All other
 * choices that the options leave open are chosen. The text explains the choice. Returns false
 * with the reason in answer->error if no choice is precise enough or measurement fails. */
bool pareto_choose(const ParetoSubject *subject, double most, MatcOptions *options,
                   ParetoChoice *answer);

/* Plots error and aliasing against time as SVG in two panels. Returns a string from malloc. */
char *pareto_svg(const MeasuredList *list, const char *title, const GlContext *gl);
#endif
