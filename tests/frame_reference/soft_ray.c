#include "tests/frame_reference/soft_ray.h"
#include "tests/frame_reference/glass_ray.h"
#include "tests/frame_reference/shadow_ray.h"
#include <math.h>

/* Random number in [0, 1]: SplitMix64 of a counter. */
static double chance(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

/* True if no object is between a position on the light and a point offset slightly from a
 * surface. */
static bool reaches(const Tracer *tracer, const Hit *hit, const double way[3])
{
    struct RTCIntersectContext context;
    double from[3];
    const double off = (reference_dot(hit->microfacet, way) < 0 ? -1 : 1) * 3e-5;
    for (int i = 0; i < 3; i++)
        from[i] = hit->world[i] + off * hit->microfacet[i];
    struct RTCRay ray = {.org_x = (float)from[0],
                         .org_y = (float)from[1],
                         .org_z = (float)from[2],
                         .dir_x = (float)way[0],
                         .dir_y = (float)way[1],
                         .dir_z = (float)way[2],
                         .tfar = 1,
                         .mask = ~0u};
    rtcInitIntersectContext(&context);
    rtcOccluded1(tracer->traced, &context, &ray);
    return ray.tfar > 0 && !shadow_is_behind_plane(tracer->scene, from, way, 1);
}

/* Transmitted share of one ray. */
static void trace(const Tracer *tracer, const Hit *hit, const double way[3], bool glass,
                  double shares[3])
{
    SceneLight place = {.kind = SCENE_Point};
    if (!glass) {
        shares[0] = shares[1] = shares[2] = reaches(tracer, hit, way);
        return;
    }
    for (int i = 0; i < 3; i++)
        place.position[i] = hit->world[i] + way[i];
    glass_shares(tracer, &place, hit->world, hit->microfacet, shares);
}

/* Direction to a position on the light; returns the weight of its ray. */
static double way_to(const SceneLight *light, const Hit *hit, const double part[2], double way[3])
{
    double face[3];
    reference_cross(light->edges[0], light->edges[1], face);
    for (int i = 0; i < 3; i++)
        way[i] = light->position[i] + part[0] * light->edges[0][i] + part[1] * light->edges[1][i] -
                 hit->world[i];
    const double square = reference_dot(way, way), front = -reference_dot(way, face);
    return fmax(reference_dot(way, hit->normal), 0) *
           (light->both_sides ? fabs(front) : fmax(front, 0)) / (square * square);
}

void soft_shares(const Tracer *tracer, const SceneLight *light, const Hit *hit,
                 const SoftRays *rays, double shares[3])
{
    uint64_t state = rays->seed;
    double way[3], arrives[3], sum[3] = {0}, all = 0;
    for (int i = 0; i < rays->edge * rays->edge; i++) {
        const double across = chance(&state), up = chance(&state);
        const double part[2] = {(i % rays->edge + across) / rays->edge,
                                (i / rays->edge + up) / rays->edge};
        const double weight = way_to(light, hit, part, way);
        if (weight <= 0)
            continue;
        trace(tracer, hit, way, rays->glass, arrives);
        all += weight;
        for (int k = 0; k < 3; k++)
            sum[k] += weight * arrives[k];
    }
    for (int k = 0; k < 3; k++)
        shares[k] = all > 0 ? sum[k] / all : 1;
}
