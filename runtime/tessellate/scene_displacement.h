/* A mesh that is displaced, as plain triangles. */
#ifndef MATC_SCENE_DISPLACEMENT_H
#define MATC_SCENE_DISPLACEMENT_H
#include "runtime/scene/scene_patches.h"
#include "runtime/scene/scene_seen.h"

/* By which material, with whose options, where in the world, how it is divided, and to how many
 * triangles at least. */
typedef struct {
    const MatcDocument *document;
    int material;
    const MatcOptions *options;
    SceneMatrix world_from_local;
    const double *origin; /* of the matrix' coordinates, in the world */
    Word method;          /* WORD_Displacing_mesh, ... */
    int triangles;
    SceneDividing dividing;
    int level;             /* parts of an edge of `from`, whatever `triangles` are; 0: by these */
    const SceneSeen *seen; /* by whom, where triangles go by what is seen; or NULL */
    double pixels;         /* that an error may have then */
    bool processor;        /* whoever draws cannot displace */
} SceneDisplacing;

/* A vertex as matc_move takes it, of an object in the world, by its matrix and the inverse of that,
 * and the origin of the matrix' coordinates. */
MatcPoint scene_displaced_point(const ShapeVertex *vertex, const SceneMatrix *m,
                                const SceneMatrix *inverse, const double origin[3]);
/* How far a material moves points of the world at most; infinite: that is not known. */
double scene_displaced_bound(const MatcDocument *document, int material,
                             const MatcOptions *options);
/* Moved triangles; or, by a method of the driver's, patches: where the height has a bound, since
 * nobody knew else where points are. False: memory ran out, or a value takes too many operations;
 * *made is empty. */
bool scene_displaced_mesh(const SceneDisplacing *how, const Shape *from, SceneMesh *made);
/* The renderer displaces by that method, with an error of at most that many pixels, or, 0, without
 * a criterion. */
bool scene_displaced_by_driver(Word method, double pixels);
/* Pictures are traced, over triangles that are divided evenly. */
bool scene_displaced_traced(Word method);
/* That it has, or is made into, at most. */
int64_t scene_displaced_triangles(const SceneMesh *mesh);
#endif
