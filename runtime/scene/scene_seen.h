/* Size of lengths in the pictures of a scene. */
#ifndef MATC_SCENE_SEEN_H
#define MATC_SCENE_SEEN_H
#include "runtime/scene/scene.h"

enum { SCENE_SEEN_CAMERAS = 32 };

/* Cameras of the scene: its own, or samples of a motion, evenly spaced over its frames. */
typedef struct {
    SceneCamera cameras[SCENE_SEEN_CAMERAS];
    int count;
    double half[2]; /* half width and height of the picture, over half its shorter side */
    double shorter; /* shorter side of the picture, in pixels */
} SceneViewSet;

void scene_seen_find(const Scene *scene, SceneViewSet *seen);
/* Returns the max pixels of a unit of length at a point in world space. Out of view the point
 * counts as eight times as far. */
double scene_seen_pixels(const SceneViewSet *seen, const double at[3]);
#endif
