#include "tests/frame_reference/open_ray.h"
#include "tests/vectors.h"
#include <math.h>
#include <string.h>

/* Random number in [0, 1]: SplitMix64 of a counter. */
static double chance(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* Direction around a unit vector for a point of the unit square, uniform or cosine-weighted. */
static void direction(const double n[3], const double place[2], bool uniform, double way[3])
{
    const double z = uniform ? 1 - place[0] : sqrt(1 - place[0]), r = sqrt(fmax(1 - z * z, 0)),
                 turn = 2 * PI * place[1];
    double u[3], v[3], aside[3] = {0};
    aside[fabs(n[0]) < .6 ? 0 : fabs(n[1]) < .6 ? 1 : 2] = 1;
    reference_cross(n, aside, u);
    reference_normalize(u);
    reference_cross(n, u, v);
    for (int i = 0; i < 3; i++)
        way[i] = z * n[i] + r * (cos(turn) * u[i] + sin(turn) * v[i]);
}

/* Distance to a ray's hit. */
static double distance_along(const Tracer *tracer, const Ray *ray)
{
    struct RTCIntersectContext context;
    struct RTCRayHit found = {.ray = {.org_x = (float)ray->at[0],
                                      .org_y = (float)ray->at[1],
                                      .org_z = (float)ray->at[2],
                                      .dir_x = (float)ray->way[0],
                                      .dir_y = (float)ray->way[1],
                                      .dir_z = (float)ray->way[2],
                                      .tfar = INFINITY,
                                      .mask = ~0u},
                              .hit = {.geomID = RTC_INVALID_GEOMETRY_ID}};
    Hit hit = {.distance = INFINITY};
    rtcInitIntersectContext(&context);
    rtcIntersect1(tracer->traced, &context, &found);
    if (found.hit.geomID != RTC_INVALID_GEOMETRY_ID)
        hit.distance = found.ray.tfar;
    for (int i = 0; i < tracer->scene->object_count; i++)
        if (tracer->scene->objects[i].kind == SCENE_Plane)
            reference_plane(&tracer->scene->objects[i], ray, 0, &hit);
    return hit.distance;
}

/* Adds the light that a surface within the radius reflects back along the ray. */
static void add_light(const Tracer *tracer, const Ray *ray, OpenRays *rays,
                      const MatcOptions *options, double sum[3])
{
    const Hit met = reference_hit(tracer, ray, 0);
    double light[3];
    if (!(met.distance <= rays->radius) || met.object < 0)
        return;
    reference_surface_light(tracer, &met, ray, options, light);
    for (int i = 0; i < 3; i++)
        sum[i] += light[i];
    if (rays->bounces > 1) {
        OpenRays further = *rays;
        further.bounces--;
        /* rays per side of a secondary hit; the many primary rays average out their noise */
        further.across = 2;
        const Open open = open_ray(tracer, &met, &further, options);
        double diffuse[3];
        reference_surface_diffuse(tracer, &met, options, diffuse);
        rays->state = further.state;
        for (int i = 0; i < 3; i++)
            sum[i] += diffuse[i] * open.light[i];
    }
}

Open open_ray(const Tracer *tracer, const Hit *hit, OpenRays *rays, const MatcOptions *options)
{
    const double off = 3e-5; /* offset from the surface, to the viewed side */
    const double side = hit->front ? 1 : -1, count = (double)rays->across * rays->across;
    Open open = {.open = 0};
    double n[3];
    Ray ray;
    for (int i = 0; i < 3; i++) {
        n[i] = side * hit->normal[i];
        ray.at[i] =
            hit->world[i] + (reference_dot(hit->microfacet, hit->normal) < 0 ? -side : side) * off *
                                hit->microfacet[i];
    }
    for (int k = 0; k < rays->across * rays->across; k++) {
        const double place[2] = {(k % rays->across + chance(&rays->state)) / rays->across,
                                 (k / rays->across + chance(&rays->state)) / rays->across};
        direction(n, place, rays->uniform, ray.way);
        const double t = distance_along(tracer, &ray) / (isinf(rays->radius) ? 1 : rays->radius);
        const bool met = isinf(rays->radius) ? isfinite(t) : t <= 1;
        open.open += (!met                                    ? 1
                      : rays->power && isfinite(rays->radius) ? pow(t, rays->power)
                                                              : 0) /
                     count;
        for (int i = 0; i < 3; i++)
            open.way[i] += met ? 0 : ray.way[i];
        if (met && options)
            add_light(tracer, &ray, rays, options, open.light);
    }
    for (int i = 0; i < 3; i++)
        open.light[i] /= count;
    if (reference_dot(open.way, open.way) > 0)
        reference_normalize(open.way);
    return open;
}
