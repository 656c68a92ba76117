/* Tuples of arguments for a library function: the range of each argument, ordinary values and
 * hostile ones. */
#ifndef MATC_VALUE_TUPLE_H
#define MATC_VALUE_TUPLE_H
#include "tests/draw/call.h"

typedef enum {
    FORM_position,
    FORM_range,
    FORM_width,
    FORM_wide,
    FORM_whole,
    FORM_ratio,
    FORM_unit,
    FORM_rest,
    FORM_texture,
    FORM_size,
    FORM_affine,
    FORM_sky
} Form;

typedef struct {
    Form form;
    double low, high; /* place: size, far; texture: its number */
} Argument;

/* The components of an argument, by its letter. */
int argument_components(char letter);
/* Fills a tuple; `state` is that of the random numbers. */
void tuple_draw(const Argument *arguments, const char *letters, uint64_t *state, Tuple tuple);
/* One after the other, as a reference wants them. */
void tuple_flatten(Tuple tuple, const char *letters, double *args);
/* Moves every number of a flat tuple that may be rounded by up to `reach` ULP, a place's and a
 * range's ULP of 1 at least, a direction's those of 1. */
void tuple_move(double *args, const Argument *arguments, const char *letters, double reach,
                uint64_t *state);
#endif
