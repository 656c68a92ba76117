/* How large things are in the pictures of a scene. */
#ifndef MATC_SCENE_SEEN_H
#define MATC_SCENE_SEEN_H
#include "runtime/scene/scene.h"

enum { SCENE_SEEN_CAMERAS = 32 };

/* Cameras of the scene: its own, or of a motion so many, evenly over its frames. */
typedef struct {
    SceneCamera cameras[SCENE_SEEN_CAMERAS];
    int count;
    double half[2]; /* of the picture's width and height, as multiples of half its shorter side */
    double shorter; /* side of the picture, in pixels */
} SceneSeen;

void scene_seen_find(const Scene *scene, SceneSeen *seen);
/* How many pixels one unit of length takes at a point of the world, where it is seen largest. Out
 * of view it counts as eight times as far. */
double scene_seen_pixels(const SceneSeen *seen, const double at[3]);
#endif
