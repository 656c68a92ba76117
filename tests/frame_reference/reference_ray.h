/* First hit of a pixel's ray, in double, for tests: Embree finds the triangle, and the hit point
 * on it is computed in double. Shares the triangles with the renderer, but no matrix and no
 * shader. */
#ifndef MATC_REFERENCE_RAY_H
#define MATC_REFERENCE_RAY_H
#include "tests/frame_reference/reference_space.h"
#include <embree3/rtcore.h>

typedef struct {
    double at[3], way[3]; /* the ray at + t way */
} Ray;

/* The first hit of a ray. */
typedef struct {
    double distance; /* infinite: no hit */
    int object;
    double world[3], local[3], uv[2], normal[3], tangents[2][3];
    /* inputs of maps: the world position before displacement, as `local` is in the object */
    double base[3], local_tangents[2][3];
    /* derivatives of the interpolated normal by u and v; 0 for degenerate texture coordinates */
    double normal_slopes[2][3];
    /* derivatives of dP/du (0) and dP/dv (1), by u (0) and by v (1) */
    double tangent_slopes[2][2][3];
    double microfacet[3]; /* geometric normal of the triangle or plane */
    bool front;
} Hit;

typedef struct Tracer Tracer;
/* Returns the share of a light that arrives at a hit. */
typedef void (*ReferenceShares)(const Tracer *tracer, const SceneLight *light, const Hit *hit,
                                double shares[3]);

/* A scene for ray tracing; geometry i is object i, except for planes, which have no geometry. */
struct Tracer {
    const Scene *scene;
    Shape *shapes; /* one for each object */
    RTCDevice device;
    RTCScene traced;
    ReferenceShares shares; /* for reference_light.h; NULL: lights cast no shadows */
};

/* The caller keeps the scene, which must outlive the tracer. */
Tracer reference_open(const Scene *scene);
void reference_close(Tracer *tracer);
/* Ray through a position of the picture; a pixel's center is at x + .5, y + .5, y up. */
Ray reference_ray(const Scene *scene, double x, double y);
/* First hit farther than `behind`, in multiples of the ray's direction. */
Hit reference_hit(const Tracer *tracer, const Ray *ray, double behind);
/* True if an object other than a plane is hit before a distance, in multiples of the direction. */
bool reference_is_blocked(const Tracer *tracer, const double from[3], const double way[3],
                          double far);
/* Replaces *hit by the hit with the plane z = 0 of the object's space, if that is farther than
 * `behind` and nearer than *hit. */
void reference_plane(const SceneObject *object, const Ray *world, double behind, Hit *hit);
/* True if the pixel's neighbors hit another object or another face, in any of the layers that
 * its own ray hit. */
bool reference_is_edge(const Tracer *tracer, int x, int y, const Hit *hits, int count);
#endif
