/* Views of lights on a scene: the views of which shadow maps are drawn, in double. No GL.
 *
 * A view has three rows of four numbers; each, times (point, 1), is a lane of the point's place.
 * Perspective: x / z and y / z go from -1 to 1 over the map, z is the distance along the view, and
 * depth is near / z, as a camera's. Directional: x and y go from -1 to 1, and the third lane is
 * depth itself: 1 at the nearest object, 0.5 at the farthest. Greater is nearer to the light. */
#ifndef MATC_RENDER_SHADOW_VIEWS_H
#define MATC_RENDER_SHADOW_VIEWS_H
#include "runtime/cache/cache.h"

enum { SHADOW_VIEWS_CUBE = 6 };

typedef struct ShadowMethod ShadowMethod; /* shadow_method.h */

typedef struct {
    double rows[3][4]; /* from the world */
    double near;       /* 0: directional */
    double texel;      /* its longer edge: where z is 1; directional: everywhere */
    const ShadowMethod *method;
    bool crossed;  /* crossings of silhouettes are found in it, too */
    bool mirrored; /* left-handed: triangles turn the other way round */
    bool soft;     /* of an area light's point: soft_views.h */
} ShadowView;

/* Views of a light: none; one; of a directional light as many as cascades, from the finest on, the
 * last of which has all objects; or SHADOW_VIEWS_CUBE: face 2 k looks along axis k of the world, 2
 * k + 1 against it, with the axes k + 1 and k + 2 (modulo 3) as x and y. Those of some
 * methods are wider than 90 degrees, by a border of two texels. An area light has as many as
 * points, twice that where it shines to both sides. */
typedef struct {
    int first, count;
} ShadowLight;

typedef struct {
    ShadowView *views;
    int count;
    ShadowLight *lights; /* of each light of the scene */
} ShadowViews;

/* Makes views for a picture of that size, which cascades are fitted to; `methods` are the rows of
 * techniques, up to NULL. False: memory ran out; made is empty then. */
bool shadow_views_make(const ShadowMethod *const *methods, const Scene *scene, const Cache *cache,
                       const int size[2], ShadowViews *made);
/* How many casters have a transparency that varies. */
int shadow_views_varying(const Cache *cache);
/* Half spaces that a view's map shows. */
CullVolume shadow_views_volume(const ShadowView *view);
/* Safe on an empty one, which it leaves behind. */
void shadow_views_free(ShadowViews *views);
#endif
