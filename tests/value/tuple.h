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
    double low, high; /* of a position: size, far; of a texture: its number */
} Argument;

/* Number of components of an argument, by its letter. */
int argument_components(char letter);
/* Fills a tuple with random numbers from `state`. */
void tuple_draw(const Argument *arguments, const char *letters, uint64_t *state, Tuple tuple);
/* Concatenates the arguments' components, as a reference expects them. */
void tuple_flatten(Tuple tuple, const char *letters, double *args);
/* Moves every number of a flat tuple that may be rounded by up to `reach` ULP: positions and
 * ranges by ULP of at least 1, directions by ULP of 1. */
void tuple_move(double *args, const Argument *arguments, const char *letters, double reach,
                uint64_t *state);
#endif
