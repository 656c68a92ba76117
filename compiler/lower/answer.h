/* Answers of maps under the operations that make others of them: the value, and beside it what it
 * leaves out of the pixel.
 *   granite: value %7, variance %9; twice of it: value mul %7 2, variance mul %9 mul 2 2 */
#ifndef MATC_ANSWER_H
#define MATC_ANSWER_H
#include "compiler/lower/lower.h"

/* A value of which no more is known. */
static inline Answer answer_of(Ref value) { return (Answer){value, 0, NULL}; }
/* Lanes, by letters of "xyz". */
Answer answer_swizzle(Lower *l, Answer a, const char *lanes);
/* The type that holds colours of both types lane by lane. A float stands for all lanes and a vec2
 * for two, hence a vec3. */
Type answer_common_type(Type a, Type b);
/* As a type of as many lanes or more, by the conversion table. */
Answer answer_widened(Lower *l, Answer a, Type type);
/* A float or three lanes as another group's value, as lower_as_group. */
Answer answer_as_group(Lower *l, Answer a, Group group);
/* Sum and product, by lane, with what is the same all over the pixel. */
Answer answer_moved(Lower *l, Answer a, Ref by);
Answer answer_scaled(Lower *l, Answer a, Ref factor);
/* Products by lane, added up. */
Answer answer_dot(Lower *l, Answer a, Ref factors);
/* The alpha that a colour has wherever it is asked, a number; 0: it varies, or the colour has none,
 * or -O0 leaves it as written. */
Ref answer_alpha(Lower *l, Ref color);
/* Sum of two values that vary independently. */
Answer answer_sum(Lower *l, Answer a, Answer b);
/* As much of the pixel as `by` says has a's value, the rest b's; or `by` is a bool, and all of it
 * has a's or all b's. Both are widened to the type that holds both. */
Answer answer_either(Lower *l, Ref by, Answer a, Answer b);
/* Mean of values computed from both sides of a split, by its share. */
Ref answer_mean(Lower *l, Ref by, Ref a, Ref b);
#endif
