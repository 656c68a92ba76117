/* First hit of a pixel's ray, in double, for tests: Embree finds the triangle, and the hit point
 * on it is computed in double. Shares the triangles with the renderer, but no matrix and no
 * shader. */
#ifndef MATC_REFERENCE_RAY_H
#define MATC_REFERENCE_RAY_H
#include "tests/frame_reference/reference_space.h"
#include <embree3/rtcore.h>

typedef struct {
    double at[3], way[3]; /* at + t way */
} Ray;

/* The first hit of a ray. */
typedef struct {
    double distance; /* infinite: nothing */
    int object;
    double world[3], local[3], uv[2], normal[3], tangents[2][3];
    /* where maps read: in the world where it was before it was displaced, as `local` is */
    double base[3], local_tangents[2][3];
    /* how the normal changes by u and by v, as the triangle has it; 0 where its texture coordinates
     * lie on a line */
    double normal_slopes[2][3];
    double tangent_slopes[2][2][3]; /* the same of dP/du (0) and dP/dv (1), by u (0) and by v (1) */
    double microfacet[3];           /* the normal of the triangle, or of the plane */
    bool front;
} Hit;

typedef struct Tracer Tracer;
/* The share of a light that arrives where a ray met a surface. */
typedef void (*ReferenceShares)(const Tracer *tracer, const SceneLight *light, const Hit *hit,
                                double shares[3]);

/* Scene for rays; geometry i is object i, except for planes, which have none. */
struct Tracer {
    const Scene *scene;
    Shape *shapes; /* of each object */
    RTCDevice device;
    RTCScene traced;
    ReferenceShares shares; /* for reference_light.h; NULL: all of every light */
};

/* The scene stays the caller's, and goes later. */
Tracer reference_open(const Scene *scene);
void reference_close(Tracer *tracer);
/* Through a place of the picture; a pixel's middle is at x + .5, y + .5, y up. */
Ray reference_ray(const Scene *scene, double x, double y);
/* First hit behind a distance, in multiples of the ray's direction. */
Hit reference_hit(const Tracer *tracer, const Ray *ray, double behind);
/* Something but a plane is met before a distance, in multiples of the direction. */
bool reference_is_blocked(const Tracer *tracer, const double from[3], const double way[3],
                          double far);
/* *hit becomes the plane z = 0 of the object's space, if that is met behind a distance and before
 * *hit. */
void reference_plane(const SceneObject *object, const Ray *world, double behind, Hit *hit);
/* Whether a pixel's neighbours meet something else, in any of the layers that its own ray met:
 * other objects, or another face. */
bool reference_is_edge(const Tracer *tracer, int x, int y, const Hit *hits, int count);
#endif
