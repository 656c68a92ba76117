/* Triangles whose corners lie on a bent surface all miss it on one side. Corners that leave it a
 * little halve that.
 *
 *     y = x^2 by a chord from -1 to 1: y = 1 misses by 2/3 in the mean, 0.73 in the root of the
 *     mean square; moved by that mean, y = 1/3, by 0.30
 *
 * A place goes by the mean of what its triangles miss, by their areas: one step of Jacobi's method
 * towards the least squares. Where one of its triangles misses next to nothing the place stays:
 * what is flat beside a cliff stays flat. */
#ifndef MATC_SCENE_REFINE_FIT_H
#define MATC_SCENE_REFINE_FIT_H
#include "runtime/tessellate/scene_bisection.h"

/* From a triangle to where its points are moved to, over its samples. */
typedef struct {
    double mean[3], square, area; /* square: the mean of the squared distance */
} SceneMiss;

/* Moves places: misses by triangle, to by place; least: a mean square that is nothing. False:
 * memory ran out, and none was moved. */
bool scene_refine_fit(const SceneBisection *b, const SceneMiss *misses, double least,
                      double (*to)[3]);
#endif
