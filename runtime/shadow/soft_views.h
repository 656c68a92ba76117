/* Views of the points of an area light, for soft shadows with a penumbra: a view for each point,
 * with a map of its own. No GL.
 *
 * A view is half of a cube map around the point, in front of the light, unfolded into one map: in
 * the center, half as wide as the map, the face along the normal; around it, a quarter wide, the
 * front halves of the cube's four sides. The map's corners are empty.
 *
 *        . .+--+. .      The light's axes: x along u, z along the normal, y = z cross x.
 *        . .|+y|. .      A direction (x, y, z) with z the greatest is at (x, y) / z, which goes
 *        +--+--+--+      from -1 to 1 across the middle. With x the greatest, it is at
 *        |-x| z|+x|      (2 - z / x, y / x): from 1, where the middle ends, to 2, in the light's
 *        +--+--+--+      plane.
 *        . .|-y|. .      Worked example: a map of 16 texels, a direction (4, 2, 2). x is greatest:
 *        . .+--+. .      it is at (1.5, 0.5), a texel is 0.25 wide, and the middle of the map is
 *                        at 8: texel (14, 10). Depth there is near / 4. */
#ifndef MATC_RENDER_SOFT_VIEWS_H
#define MATC_RENDER_SOFT_VIEWS_H
#include "runtime/shadow/shadow_views.h"

enum { SOFT_VIEWS_FACES = 5 /* number of faces: toward z, x, -x, y, -y */ };

/* Returns true for an area light that casts shadows. */
bool soft_views_wanted(const SceneLight *light);
/* Returns the number of views: one per point; twice that for a light that emits to both sides. */
int soft_views_count(const Scene *scene, const SceneLight *light);
/* Sets the world position of a view's point. Points are evenly distributed, row by row along u,
 * from edge to edge except for an inset of 1/256. */
void soft_views_place(const Scene *scene, const SceneLight *light, int number, double position[3]);
/* Makes a view whose depth is `near` over the distance along its face. */
void soft_views_make(const Scene *scene, const SceneLight *light, int number, double near,
                     ShadowView *view);
/* Makes a face of a view, as a view of its own; rect: its lower left texel in the map, and its
 * size. */
void soft_views_face(const ShadowView *view, int size, int face, ShadowView *made, int rect[4]);
#endif
