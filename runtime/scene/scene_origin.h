/* The origin of a scene's coordinates. Floats have 24 bits, which is half a meter at the earth's
 * radius. So positions are kept relative to an origin near the camera, in double, before anything
 * is rounded to floats. Only a program that reads the position in the world adds the origin
 * (MatcOptions.origin).
 *
 *     camera [6378137, -6, 2] that looks at [6378137, 0, 0], a plane at [6378137, 0, 0], a box 1.5
 *         beside it:
 *     the origin is [6378137, 0, 0], the camera stands at [0, -6, 2], and the box at [1.5, 0, 0] */
#ifndef MATC_SCENE_ORIGIN_H
#define MATC_SCENE_ORIGIN_H
#include "runtime/scene/scene.h"

/* Chooses the origin of a scene that was read in the world's coordinates, and makes all positions
 * relative to it. It stays at 0 where the camera stands near 0: pictures of such scenes keep every
 * bit. */
void scene_origin_find(Scene *scene);
/* Whether it is another than the world's. */
bool scene_origin_used(const Scene *scene);
/* Moves the origin to a camera that has gone far from it. True: it was moved, and the camera's own
 * positions are relative to the new one. The renderer makes all again when it is told of a
 * change. */
bool scene_origin_follow(Scene *scene, SceneCamera *camera);
/* From the world's coordinates to the scene's, and back. */
void scene_origin_to(const Scene *scene, const double world[3], double at[3]);
void scene_origin_from(const Scene *scene, const double at[3], double world[3]);
#endif
