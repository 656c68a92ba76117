/* The origin of a scene's coordinates. Floats have 24 bits, which is half a meter at the earth's
 * radius. So positions are stored relative to an origin near the camera, in double, before they
 * are rounded to floats. Only a program that reads the world position adds the origin
 * (MatcOptions.origin).
 *
 *     A camera at [6378137, -6, 2] that looks at [6378137, 0, 0], a plane at [6378137, 0, 0], a
 *         box 1.5 to the side:
 *     the origin is [6378137, 0, 0], the camera is at [0, -6, 2], and the box at [1.5, 0, 0] */
#ifndef MATC_SCENE_ORIGIN_H
#define MATC_SCENE_ORIGIN_H
#include "runtime/scene/scene.h"

/* Chooses the origin of a scene that was read in world coordinates, and makes all positions
 * relative to it. The origin remains 0 if the camera is near 0: pictures of such scenes keep
 * every bit. */
void scene_origin_find(Scene *scene);
/* Reports whether the origin differs from the world's. */
bool scene_origin_used(const Scene *scene);
/* Moves the origin if a camera has traveled far from it. Returns true if it moved; positions of
 * the scene and of the camera are then relative to the new origin. The renderer rebuilds the
 * scene at the next reported change. */
bool scene_origin_follow(Scene *scene, SceneCamera *camera);
/* Convert world coordinates to the scene's, and back. */
void scene_origin_to(const Scene *scene, const double world[3], double at[3]);
void scene_origin_from(const Scene *scene, const double at[3], double world[3]);
#endif
