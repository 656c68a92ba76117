/* Copies of a Scatter on a surface that is displaced stand where that leads to. */
#ifndef MATC_SCENE_STAND_H
#define MATC_SCENE_STAND_H
#include "runtime/scene_reader/scene_thing.h"

/* A copy: the numbers of its place on the surface (scene_surface.h), and its objects in the scene,
 * from `first` to before `end`. */
typedef struct {
    double numbers[3];
    int first, end;
} SceneStood;

typedef struct SceneStand {
    SceneMatrix world_from_group; /* of the copies */
    /* of the surface, in the space of the copies; their materials are those aside */
    SceneObject *objects;
    int object_count;
    int first; /* object of the scene */
    bool aligned;
    SceneStood *copies;
    size_t copy_count, copy_room;
} SceneStand;

/* One more, of the scene's objects from `objects` on, which lie aside. */
void scene_stand_open(SceneReader *r, const SceneMatrix *world_from_group, int objects,
                      bool aligned);
void scene_stand_add(SceneReader *r, size_t stand, const SceneStood *copy);
/* Moves what stands on surfaces that are displaced to where these are, by the C reference in
 * double, and turns what is aligned to the normal there: that of the points around, a part of a
 * thousand of two edges of the triangle away. After materials are resolved. False: a diagnostic
 * says why. */
bool scene_stand(SceneReader *r, const MatcOptions *options);
#endif
