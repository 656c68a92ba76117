/* Frustum culling: a view as half spaces in world space, and a test of boxes against them. In
 * double and conservative: a culled object covers no pixel, whatever the rounding of its
 * vertices in floats. */
#ifndef MATC_GPU_SCENE_CULL_H
#define MATC_GPU_SCENE_CULL_H
#include "runtime/scene/scene.h"

enum { CULL_PLANES = 6 };

typedef struct {
    double planes[CULL_PLANES][4]; /* a point x is inside if n x + d >= 0, with n of unit length */
    double terms[CULL_PLANES];     /* sums of the absolute terms of d, to bound rounding errors */
    int count;
} CullVolume;

typedef struct {
    double low[3], high[3];
} CullBox;

/* Computes the camera's frustum; `size` is that of the picture in pixels. */
void cull_volume(const SceneCamera *camera, const int size[2], CullVolume *made);
/* Returns the bounding box of a shape's vertices; for an empty shape the origin. */
CullBox cull_box(const Shape *shape);
/* Returns false if no part of the transformed box is in view. */
bool cull_sees(const CullVolume *volume, const CullBox *box, const SceneMatrix *world_from_local);
/* Reports whether the whole box is farther than the near plane, so that the camera is not
 * inside. */
bool cull_is_outside(const CullVolume *volume, const CullBox *box,
                     const SceneMatrix *world_from_local);
#endif
