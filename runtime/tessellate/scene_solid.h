/* Triangles of solids: spheres, boxes and the like. */
#ifndef MATC_SCENE_SOLID_H
#define MATC_SCENE_SOLID_H
#include "runtime/scene/scene.h"

/* Makes the triangles of an object, in its own space; none for a Plane, and none for a Mesh,
 * which has its own. False: out of memory. */
bool scene_solid(const SceneObject *object, Shape *made);
/* Returns the key of an object's triangles: equal keys mean equal triangles, also for meshes
 * from files. */
Key scene_solid_key(const SceneObject *object);
/* Returns the number of an object's triangles, without making them. */
int scene_solid_triangles(const SceneObject *object);
#endif
