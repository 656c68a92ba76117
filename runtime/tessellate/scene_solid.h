/* The triangles of solids: spheres, boxes and the like. */
#ifndef MATC_SCENE_SOLID_H
#define MATC_SCENE_SOLID_H
#include "runtime/scene/scene.h"

/* The triangles of an object, in its own space; of a Plane, none. False: memory ran out. A Mesh has
 * its own. */
bool scene_solid(const SceneObject *object, Shape *made);
/* Objects with one key have the same ones, those of a file too. */
Key scene_solid_key(const SceneObject *object);
/* How many they are, without making them. */
int scene_solid_triangles(const SceneObject *object);
#endif
