/* Clips area lights that are too large for floats: with an edge of 1e9 the corner's position has
 * steps of 64. */
#ifndef MATC_SCENE_AREA_H
#define MATC_SCENE_AREA_H
#include "runtime/scene/scene.h"

/* Computes the part of an area light that matters for what a camera sees: all of it, unless it
 * extends farther than SCENE_AREA_REACH times the camera's distance from its target, or from the
 * light's plane. Returns true if it was clipped. A surface within ten of these distances loses
 * less than 1e-3 of the light: the lost part lies below an elevation of 11 / SCENE_AREA_REACH,
 * which is at most 0.7e-3 of the cosine's integral. */
enum { SCENE_AREA_REACH = 10000 };
bool scene_area_cut(const SceneCamera *camera, const SceneLight *light, SceneLight *cut);
/* Reports whether some light of the scene is clipped. */
bool scene_area_cuts(const Scene *scene);
#endif
