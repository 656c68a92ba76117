/* Arithmetic on map values (Answer): computes the value and the variance that its mean leaves
 * out of the pixel.
 *   granite: value %7, variance %9; twice of it: value mul %7 2, variance mul %9 mul 2 2 */
#ifndef MATC_ANSWER_H
#define MATC_ANSWER_H
#include "compiler/lower/lower.h"

/* Returns a value without variance or split. */
static inline Answer answer_of(Ref value) { return (Answer){value, 0, NULL}; }
/* Selects components, by letters of "xyz". */
Answer answer_swizzle(Lower *l, Answer a, const char *components);
/* Returns the type that can hold colors of both types. A float fills all components and a vec2
 * two of them, hence a vec3. */
Type answer_common_type(Type a, Type b);
/* Converts to a type of as many components or more, by the conversion table. */
Answer answer_widened(Lower *l, Answer a, Type type);
/* Converts a float or three components to another group's value, as lower_as_group() does. */
Answer answer_as_group(Lower *l, Answer a, Group group);
/* Return the sum and the product, per component, with a value that is constant over the pixel. */
Answer answer_moved(Lower *l, Answer a, Ref by);
Answer answer_scaled(Lower *l, Answer a, Ref factor);
/* Returns the dot product with constant factors. */
Answer answer_dot(Lower *l, Answer a, Ref factors);
/* Returns the color's alpha if it is a constant; 0: it varies, the color has no alpha, or -O0
 * leaves it as written. */
Ref answer_alpha(Lower *l, Ref color);
/* Returns the sum of two values that vary independently; their variances add. */
Answer answer_sum(Lower *l, Answer a, Answer b);
/* Returns the mean of two values: `by` is the share of the pixel that has a's value, the rest
 * has b's. If `by` is a bool, the whole pixel has one of them. Both are widened to their common
 * type. */
Answer answer_either(Lower *l, Ref by, Answer a, Answer b);
/* Returns the mean, weighted by a split's share, of values computed from both of its sides. */
Ref answer_mean(Lower *l, Ref by, Ref a, Ref b);
#endif
