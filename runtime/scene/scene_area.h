/* Area lights that are too large for floats: an edge of 1e9 leaves steps of 64 for the place of its
 * corner. */
#ifndef MATC_SCENE_AREA_H
#define MATC_SCENE_AREA_H
#include "runtime/scene/scene.h"

/* Gives the part of an extent's parallelogram that counts for what a camera sees: all of it, unless
 * it reaches farther than SCENE_AREA_REACH times the camera's distance from its target, or from the
 * light's plane. True: it is a part. A surface within ten of these distances loses less than 1e-3
 * of the light: the lost part lies below an elevation of 11 / SCENE_AREA_REACH, which is 0.7e-3 of
 * the cosine's integral at most. */
enum { SCENE_AREA_REACH = 10000 };
bool scene_area_cut(const SceneCamera *camera, const SceneLight *light, SceneLight *cut);
/* Some light is cut. */
bool scene_area_cuts(const Scene *scene);
#endif
