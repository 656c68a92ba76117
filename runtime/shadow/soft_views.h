/* Views of the points of an area light, for soft shadows with a penumbra: a view for each point,
 * which is a map of its own. No GL.
 *
 * A view is all that is in front of the light, half of a cube around the point, unfolded into its
 * map: in the middle, half as wide as the map, what is seen along the normal; beside it, a quarter
 * wide, the near halves of the cube's sides. The map's corners are empty.
 *
 *        . .+--+. .      The light's axes: x along u, z along the normal, y = z cross x. A point's
 *        . .|+y|. .      place (x, y, z) with z the greatest is at (x, y) / z, which goes from -1
 *        +--+--+--+      to 1 across the middle. With x the greatest, it is at (2 - z / x, y / x):
 *        |-x| z|+x|      from 1, where the middle ends, to 2, in the light's plane.
 *        +--+--+--+
 *        . .|-y|. .      Worked example: a map of 16 texels, a place (4, 2, 2). x is the greatest:
 *        . .+--+. .      it is at (1.5, 0.5), a texel is 0.25 wide, and the middle of the map is
 *                        at 8: texel (14, 10). Depth there is near / 4. */
#ifndef MATC_RENDER_SOFT_VIEWS_H
#define MATC_RENDER_SOFT_VIEWS_H
#include "runtime/shadow/shadow_views.h"

enum { SOFT_VIEWS_FACES = 5 /* z, x, -x, y, -y */ };

/* It is an area light that casts shadows. */
bool soft_views_wanted(const SceneLight *light);
/* How many views it has: one for each point; of a light that shines to both sides, as many once
 * more for its back. */
int soft_views_count(const Scene *scene, const SceneLight *light);
/* Where the point of a view is, in the world. Points are spread evenly, row by row along u, from
 * edge to edge but for 1/256 of it. */
void soft_views_place(const Scene *scene, const SceneLight *light, int number, double position[3]);
/* A view whose depth is `near` over the distance along its face. */
void soft_views_make(const Scene *scene, const SceneLight *light, int number, double near,
                     ShadowView *view);
/* One face of such a view, as a view of its own; rect: its lower left texel in the map, and its
 * size. */
void soft_views_face(const ShadowView *view, int size, int face, ShadowView *made, int rect[4]);
#endif
