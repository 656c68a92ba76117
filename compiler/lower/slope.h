/* Forward-mode automatic differentiation of the IR: the derivative of a value along a direction,
 * from the derivatives of the surface point. */
#ifndef MATC_SLOPE_H
#define MATC_SLOPE_H
#include "compiler/lower/lower.h"

/* Returns the derivative of a value; 0 where the value is constant. Discontinuities do not
 * count: a step has derivative 0. */
Ref slope_of(Lower *l, Ref value, Direction direction);
/* Returns the derivative as a footprint, which itself counts as constant along every direction.
 * It is behind an OP_detach that no rule looks through. */
Ref slope_detached(Lower *l, Ref value, Direction direction);
/* Removes the OP_detach marks of footprints from the IR, after all differentiation is done. */
void slope_done(Lower *l);
/* Sets the derivative of a value, 0 for none, before it is first queried: of a surface point, or
 * of a function's argument. */
void slope_set(Lower *l, Ref value, Direction direction, Ref slope);

/* Returns the derivative of a mesh attribute. slope_attribute.c */
Ref slope_attribute(Lower *l, Ref ref, Direction direction);
/* Returns the derivative of the mesh's normal by u or v; 0: constant, as on a plane. Normals
 * that maps compute have none. */
Ref slope_mesh_normal(Lower *l, Ref normal, Direction direction);
/* Returns the derivative of the mesh's tangent by u or v. */
Ref slope_mesh_tangent(Lower *l, Ref tangent, Direction direction);

/* Values whose derivative is a weighted sum of other values' derivatives. slope_sum.c */
typedef struct {
    Ref of, factor;
} SlopeTerm;
typedef struct SlopeSum {
    const SlopeTerm *terms;
    int count;
} SlopeSum;
typedef const SlopeTerm *SlopeTerms(Lower *l, const void *what);
/* Defines the derivative of a value as a weighted sum. Its `count` terms are queried once, on
 * first use. Returns the earlier definition's `what`, which stays valid, or NULL if the value
 * had none. */
const void *slope_set_sum(Lower *l, Ref value, SlopeTerms *terms, const void *what, int count);
/* Returns the sum that was recorded for a value; NULL: the value is not a sum. */
const SlopeSum *slope_sum_of(Lower *l, Ref value);
#endif
