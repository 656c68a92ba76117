/* A shape that is divided where what moves its points is not what its triangles have. */
#ifndef MATC_SCENE_REFINE_H
#define MATC_SCENE_REFINE_H
#include "runtime/gl/shape.h"

/* Moves so many points, in the shape's space: to[i] is where at[i] goes. False: it cannot. */
typedef bool (*SceneMove)(void *user, const ShapeVertex *at, int count, double (*to)[3]);

typedef struct {
    SceneMove move;
    void *user;
    int triangles; /* to as many, or a few more, or as many as there are */
    /* Scale of lengths at a point: the error bound is relative to it; NULL: 1. */
    double (*scale)(void *user, const double at[3]);
    /* Length of a motion: no position moves by more than the longest of those queried; NULL:
     * Euclidean. */
    double (*length)(void *user, const double by[3]);
    double least; /* error of a triangle, times the scale, that is small enough; 0: none is */
} SceneRefining;

/* The refined shape, moved, with where its vertices were (Shape.base). False: memory ran out, or
 * points could not be moved; *made is empty. */
bool scene_refine(const Shape *shape, const SceneRefining *how, Shape *made);
#endif
