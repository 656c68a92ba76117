/* Forward differentiation of the IR: how a value changes along a direction, from how the surface
 * point does. */
#ifndef MATC_SLOPE_H
#define MATC_SLOPE_H
#include "compiler/lower/lower.h"

/* The derivative of a value; 0 where it does not change. Discontinuities do not count: a step has
 * derivative 0. */
Ref slope_of(Lower *l, Ref value, Direction direction);
/* The slope as a footprint, which is itself constant along every direction. No rule looks into it.
 * */
Ref slope_detached(Lower *l, Ref value, Direction direction);
/* Takes the marks of footprints out of the IR, when nothing is differentiated any more. */
void slope_done(Lower *l);
/* Says what the derivative of a value is, 0 for none, before anything asks: of a surface point, of
 * a function's argument. */
void slope_set(Lower *l, Ref value, Direction direction, Ref slope);

/* Slope of an attribute of the mesh. slope_attribute.c */
Ref slope_attribute(Lower *l, Ref ref, Direction direction);
/* Slope by u or v of the mesh's normal; 0: it is constant, as a plane's. Normals made by maps have
 * no such slope. */
Ref slope_mesh_normal(Lower *l, Ref normal, Direction direction);
/* Slope by u or v of the mesh's tangent. */
Ref slope_mesh_tangent(Lower *l, Ref tangent, Direction direction);

/* Values whose derivative is a sum of others', each by a factor. slope_sum.c */
typedef struct {
    Ref of, factor;
} SlopeTerm;
typedef struct SlopeSum {
    const SlopeTerm *terms;
    int count;
} SlopeSum;
typedef const SlopeTerm *SlopeTerms(Lower *l, const void *what);
/* Says that of a value. Its terms, so many, are asked for once, if at all. Returns what was said of
 * it before, which holds; NULL: nothing. */
const void *slope_set_sum(Lower *l, Ref value, SlopeTerms *terms, const void *what, int count);
const SlopeSum *slope_sum_of(Lower *l, Ref value); /* NULL: it is none */
#endif
