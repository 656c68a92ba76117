/* Views of lights on a scene, from which shadow maps are drawn, in double. No GL.
 *
 * A view has three rows of four numbers; each, times (point, 1), is a component of the point's
 * position in the view. Perspective: x / z and y / z go from -1 to 1 over the map, z is the
 * distance along the view, and depth is near / z, as a camera's. Directional: x and y go from -1
 * to 1, and the third component is depth itself: 1 at the nearest object, 0.5 at the farthest.
 * Greater is nearer to the light. */
#ifndef MATC_RENDER_SHADOW_VIEWS_H
#define MATC_RENDER_SHADOW_VIEWS_H
#include "runtime/gpu_scene/gpu_scene.h"

enum { SHADOW_VIEWS_CUBE = 6 };

typedef struct ShadowMethod ShadowMethod; /* declared in shadow_method.h */

typedef struct {
    double rows[3][4]; /* matrix rows, from world space to the view */
    double near;       /* near distance; 0: the view of a directional light */
    double texel;      /* longer edge of a texel: at z = 1; for directional lights everywhere */
    const ShadowMethod *method;
    bool crossed;  /* silhouette crossings are also found in the view */
    bool mirrored; /* the view is left-handed: the winding is flipped */
    bool soft;     /* view from a point of an area light: soft_views.h */
} ShadowView;

/* Views of a light: none; one; for a directional light the number of cascades, from the finest
 * on, of which the last contains all objects; or SHADOW_VIEWS_CUBE: face 2 k looks along axis k
 * of the world, 2 k + 1 against it, with the axes k + 1 and k + 2 (modulo 3) as x and y. Some
 * techniques' faces are wider than 90 degrees, by a border of two texels. An area light has one
 * view per point, and two if it emits to both sides. */
typedef struct {
    int first, count;
} ShadowLight;

typedef struct {
    ShadowView *views;
    int count;
    ShadowLight *lights; /* ranges of views, indexed by light of the scene */
} ShadowViews;

/* Makes views for a picture of that size, to which cascades are fitted; `methods` are the rows
 * of techniques, up to NULL. False: out of memory; made is empty then. */
bool shadow_views_make(const ShadowMethod *const *methods, const Scene *scene,
                       const GpuScene *gpu_scene, const int size[2], ShadowViews *made);
/* Returns the number of casters with varying transparency. */
int shadow_views_varying(const GpuScene *gpu_scene);
/* Returns the half spaces that bound a view's map. */
CullVolume shadow_views_volume(const ShadowView *view);
/* Frees all memory and zeroes the struct; also valid for a zeroed struct. */
void shadow_views_free(ShadowViews *views);
#endif
