/* Frustum culling: a view as half spaces of the world, and whether any part of a box can be in all
 * of them. In double and conservative: a culled object covers no pixel, whatever rounding in floats
 * does to its vertices. */
#ifndef MATC_CACHE_CULL_H
#define MATC_CACHE_CULL_H
#include "runtime/scene/scene.h"

enum { CULL_PLANES = 6 };

typedef struct {
    double planes[CULL_PLANES][4]; /* n x + d >= 0 inside, n of unit length */
    double terms[CULL_PLANES];     /* what d is a sum of, without signs */
    int count;
} CullVolume;

typedef struct {
    double low[3], high[3];
} CullBox;

/* `size`: of the picture, in pixels. */
void cull_volume(const SceneCamera *camera, const int size[2], CullVolume *made);
/* Around a shape's vertices; of a shape without any: a point, the origin. */
CullBox cull_box(const Shape *shape);
/* False: nothing of the box, which stands where the matrix says, is seen. */
bool cull_sees(const CullVolume *volume, const CullBox *box, const SceneMatrix *world_from_local);
/* All of it is beyond the nearest that a camera sees: it looks at it from outside. */
bool cull_is_beyond(const CullVolume *volume, const CullBox *box,
                    const SceneMatrix *world_from_local);
#endif
