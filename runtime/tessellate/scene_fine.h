/* How fine the meshes of a large scene are: scene_detail.h says for whom. */
#ifndef MATC_SCENE_FINE_H
#define MATC_SCENE_FINE_H
#include "compiler/base/arena.h"
#include "runtime/scene/scene_detail.h"

enum { SCENE_FINE_LEAST = 128 /* triangles of a displaced mesh that is hardly seen */ };

/* For a displaced object. */
typedef struct {
    int triangles; /* to about how many it is divided */
    int steps;     /* of the body that is displaced; 0: it says that itself */
    double
        /* copies share a mesh if the logarithms of their sizes are in one interval of that length;
         * 0: if they are equal */
        share;
    double number; /* of the interval */
    /* the mesh is made for the object's size times this: the middle of the interval */
    double scale;
} SceneFineness;

/* Decides by all triangles whether detail goes by the picture; then bodies that are not displaced
 * have their steps. `by` has its bases. */
void scene_fine_choose(Scene *scene, Arena *arena);
/* Repeats this for a picture of another size, where detail follows the picture. */
void scene_fine_look(Scene *scene, int width, int height);
/* `before` is the object before it was displaced. */
SceneFineness scene_fine_of(const Scene *scene, const SceneObject *before);
#endif
