/* Moves the copies of a Scatter onto its surface if that is displaced. */
#ifndef MATC_SCENE_STAND_H
#define MATC_SCENE_STAND_H
#include "runtime/scene_reader/scene_node.h"

/* A copy: the random numbers of its position on the surface (scene_surface.h), and its objects
 * in the scene, from `first` to before `end`. */
typedef struct {
    double numbers[3];
    int first, end;
} SceneStood;

typedef struct SceneStand {
    SceneMatrix world_from_group; /* transform from the space of the copies to world space */
    /* Objects of the surface, in the copies' space; their materials index SceneReader.asides. */
    SceneObject *objects;
    int object_count;
    int first; /* index of the first object among the copies */
    bool aligned;
    SceneStood *copies;
    size_t copy_count, copy_capacity;
} SceneStand;

/* Adds a surface: the scene's objects from `objects` on, which the caller then removes from the
 * scene; and a copy on it. */
void scene_stand_open(SceneReader *r, const SceneMatrix *world_from_group, int objects,
                      bool aligned);
void scene_stand_add(SceneReader *r, size_t stand, const SceneStood *copy);
/* Moves the copies on displaced surfaces to the displaced positions, by the C reference in
 * double, and rotates aligned copies to the normal there. That normal is spanned by four
 * adjacent points, a thousandth of two edges of the triangle away. Call after materials are
 * resolved. Returns false with a diagnostic on failure. */
bool scene_stand(SceneReader *r, const MatcOptions *options);
#endif
