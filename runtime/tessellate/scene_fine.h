/* Level of detail of meshes in a large scene: scene_detail.h defines the viewers. */
#ifndef MATC_SCENE_FINE_H
#define MATC_SCENE_FINE_H
#include "compiler/base/arena.h"
#include "runtime/scene/scene_detail.h"

enum { SCENE_FINE_MIN = 128 /* min triangles of a displaced mesh, for hardly visible objects */ };

/* Level of detail of a displaced object. */
typedef struct {
    int triangles; /* approximate number of triangles after division */
    int steps;     /* steps of the solid that is displaced; 0: its own steps */
    /* Length of the intervals of the logarithm of size in which copies share a mesh; 0: only
     * equal sizes do. */
    double share;
    double number; /* number of the interval of sizes */
    /* factor from the object's size to the middle of the interval, for which the mesh is made */
    double scale;
} SceneFineness;

/* Decides by the total number of triangles whether detail is view-dependent; then sets the steps
 * of solids that are not displaced. Called when the displacer has its bases. */
void scene_fine_choose(Scene *scene, Arena *arena);
/* Updates view-dependent detail for another picture size. */
void scene_fine_look(Scene *scene, int width, int height);
/* Returns the level of detail of an object; `before` is the object before displacement. */
SceneFineness scene_fine_of(const Scene *scene, const SceneObject *before);
#endif
