/* A displaced mesh as plain triangles, or as patches for the GPU. */
#ifndef MATC_SCENE_DISPLACEMENT_H
#define MATC_SCENE_DISPLACEMENT_H
#include "runtime/scene/scene_patches.h"
#include "runtime/scene/scene_seen.h"

/* Settings of displacement: the material and its options, the world matrix, the method of
 * division, and the minimum number of triangles. */
typedef struct {
    const MatcDocument *document;
    int material;
    const MatcOptions *options;
    SceneMatrix world_from_local;
    const double *origin; /* world position of the matrix's origin */
    Keyword method;       /* keyword: KEYWORD_Displacing_mesh, ... */
    int triangles;
    SceneDividing dividing;
    int level; /* parts of an edge of `from`, overriding `triangles`; 0: by triangles */
    const SceneViewSet *seen; /* viewers for view-dependent division; NULL: none */
    double pixels;            /* tolerated error in pixels for view-dependent division */
    bool processor;           /* the renderer cannot displace */
} SceneDisplacing;

/* Returns a vertex as matc_move() takes it, transformed to world space by the object's matrix
 * and its inverse; `origin` is the origin of the matrix's coordinates. */
MatcPoint scene_displaced_point(const ShapeVertex *vertex, const SceneMatrix *m,
                                const SceneMatrix *inverse, const double origin[3]);
/* Returns the maximum displacement by a material, in world units; infinite: unknown. */
double scene_displaced_bound(const MatcDocument *document, int material,
                             const MatcOptions *options);
/* Makes moved triangles; or, for a method on the GPU, patches, provided that the height has a
 * bound, since bounding volumes need one. False: out of memory, or a value takes too many
 * operations; *made is empty. */
bool scene_displaced_mesh(const SceneDisplacing *how, const Shape *from, SceneMesh *made);
/* Returns whether the method runs on the GPU; `pixels` is the tolerated error, 0: none. */
bool scene_displaced_by_driver(Keyword method, double pixels);
/* Returns whether the method ray-marches over evenly divided triangles. */
bool scene_displaced_traced(Keyword method);
/* Returns the max number of triangles that the mesh has or is divided into. */
int64_t scene_displaced_triangles(const SceneMesh *mesh);
#endif
