/* Adaptive subdivision of a shape where the displaced surface differs from its triangles. */
#ifndef MATC_SCENE_REFINE_H
#define MATC_SCENE_REFINE_H
#include "runtime/gl/shape.h"

/* Moves `count` points, in the shape's space: to[i] is the new position of at[i]. False: failed. */
typedef bool (*SceneMove)(void *user, const ShapeVertex *at, int count, double (*to)[3]);

typedef struct {
    SceneMove move;
    void *user;
    int triangles; /* requested number, slightly exceeded or not reached */
    /* Scale of lengths at a point: the error bound is relative to it; NULL: 1. */
    double (*scale)(void *user, const double at[3]);
    /* Length of a motion: no position moves by more than the longest of those queried; NULL:
     * Euclidean. */
    double (*length)(void *user, const double by[3]);
    double least; /* tolerated product of a triangle's error and `scale`; 0: none */
} SceneRefining;

/* Refines and displaces a shape; the result has its original vertices (Shape.base). False: out
 * of memory, or points could not be moved; *made is empty. */
bool scene_refine(const Shape *shape, const SceneRefining *how, Shape *made);
#endif
