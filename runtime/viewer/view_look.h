/* Maps the numbers of a view into the range from 0 to 1 that a PNG can show. OpenEXR files keep
 * the unmapped numbers.
 *
 *     view of a scene whose camera is 6 from its target:  a point 6 away has depth 36 / (36 + 36),
 *     one 12 away 36 / (36 + 144), the background 0; radiance 0.5 is 0.735 in sRGB */
#ifndef MATC_VIEWER_VIEW_LOOK_H
#define MATC_VIEWER_VIEW_LOOK_H
#include "runtime/scene/scene.h"

typedef struct ViewLook ViewLook;

/* Returns the mapping of a view. NULL: the view's numbers are in [0, 1] already (`final`,
 * `ao`, `positions`, `voxels`), or the view is a slot, which slot.h maps. */
const ViewLook *view_look_find(const char *view);
/* Returns whether the mapped values are sRGB colors rather than plain numbers. */
bool view_look_is_color(const ViewLook *look);
/* Maps `pixels` pixels of four floats, as renderer_read gives them, in place. */
void view_look_show(const ViewLook *look, const SceneCamera *camera, float *rgba, size_t pixels);
#endif
