/* Arithmetic on map values (MapValue): computes the value and the variance that its mean leaves
 * out of the pixel.
 *   granite: value %7, variance %9; twice of it: value mul %7 2, variance mul %9 mul 2 2 */
#ifndef MATC_MAP_VALUE_H
#define MATC_MAP_VALUE_H
#include "compiler/lower/lower.h"

/* Returns a value without variance or split. */
static inline MapValue map_value_of(Ref value) { return (MapValue){value, 0, NULL}; }
/* Selects components, by letters of "xyz". */
MapValue map_value_swizzle(Lower *l, MapValue a, const char *components);
/* Returns the type that can hold colors of both types. A float fills all components and a vec2
 * two of them, hence a vec3. */
Type map_value_common_type(Type a, Type b);
/* Converts to a type of as many components or more, by the conversion table. */
MapValue map_value_widened(Lower *l, MapValue a, Type type);
/* Converts a float or three components to another group's value, as lower_as_group() does. */
MapValue map_value_as_group(Lower *l, MapValue a, Group group);
/* Return the sum and the product, per component, with a value that is constant over the pixel. */
MapValue map_value_moved(Lower *l, MapValue a, Ref by);
MapValue map_value_scaled(Lower *l, MapValue a, Ref factor);
/* Returns the dot product with constant factors. */
MapValue map_value_dot(Lower *l, MapValue a, Ref factors);
/* Returns the color's alpha if it is a constant; 0: it varies, the color has no alpha, or -O0
 * leaves it as written. */
Ref map_value_alpha(Lower *l, Ref color);
/* Returns the sum of two values that vary independently; their variances add. */
MapValue map_value_sum(Lower *l, MapValue a, MapValue b);
/* Returns the mean of two values: `by` is the share of the pixel that has a's value, the rest
 * has b's. If `by` is a bool, the whole pixel has one of them. Both are widened to their common
 * type. */
MapValue map_value_either(Lower *l, Ref by, MapValue a, MapValue b);
/* Returns the mean, weighted by a split's share, of values computed from both of its sides. */
Ref map_value_mean(Lower *l, Ref by, Ref a, Ref b);
#endif
