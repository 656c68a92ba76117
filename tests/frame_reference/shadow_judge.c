#include "tests/frame_reference/shadow_judge.h"
#include <math.h>
#include <string.h>

enum { DIRECTIONS = 10 };

static const double tie = 1e-6; /* as a share of the reach */

/* Hit of an eye ray: a triangle's corners in the world, or a plane. */
typedef struct {
    int object;
    unsigned triangle;
    double point[3], microfacet[3];
} Seen;

static void corners_of(const Tracer *tracer, int object, unsigned triangle, double corners[3][3])
{
    const Shape *shape = &tracer->shapes[object];
    for (unsigned i = 0; i < 3; i++) {
        const float *p = shape->vertices[shape->indices[3 * triangle + i]].position;
        reference_image(&tracer->scene->objects[object].world_from_local,
                        (double[]){p[0], p[1], p[2]}, 1, corners[i]);
    }
}

ShadowJudge shadow_judge(const Tracer *tracer)
{
    ShadowJudge judge = {.tracer = tracer};
    double low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY},
           corners[3][3];
    for (int i = 0; i < tracer->scene->object_count; i++)
        for (int t = 0; t < tracer->shapes[i].index_count / 3; t++) {
            corners_of(tracer, i, (unsigned)t, corners);
            for (int k = 0; k < 9; k++) {
                low[k % 3] = fmin(low[k % 3], corners[k / 3][k % 3]);
                high[k % 3] = fmax(high[k % 3], corners[k / 3][k % 3]);
            }
        }
    for (int i = 0; i < 3; i++) {
        judge.middle[i] = (low[i] + high[i]) / 2;
        judge.reach = fmax(judge.reach, (high[i] - low[i]) / 2);
    }
    return judge;
}

static struct RTCRay ray_of(const double at[3], const double way[3], double distance)
{
    return (struct RTCRay){.org_x = (float)at[0],
                           .org_y = (float)at[1],
                           .org_z = (float)at[2],
                           .dir_x = (float)way[0],
                           .dir_y = (float)way[1],
                           .dir_z = (float)way[2],
                           .tfar = (float)distance,
                           .mask = ~0u};
}

/* Distance to the plane of three corners, as a multiple of the ray's direction. */
static double plane_at(const double corners[3][3], const double at[3], const double way[3])
{
    double u[3], v[3], normal[3], from[3];
    for (int i = 0; i < 3; i++) {
        u[i] = corners[1][i] - corners[0][i];
        v[i] = corners[2][i] - corners[0][i];
        from[i] = corners[0][i] - at[i];
    }
    reference_cross(u, v, normal);
    return reference_dot(normal, from) / reference_dot(normal, way);
}

static bool see(const Tracer *tracer, const Ray *ray, Seen *seen)
{
    struct RTCIntersectContext context;
    struct RTCRayHit found = {.ray = ray_of(ray->at, ray->way, INFINITY),
                              .hit = {.geomID = RTC_INVALID_GEOMETRY_ID}};
    const Hit hit = reference_hit(tracer, ray, 0);
    if (hit.object < 0)
        return false;
    seen->object = hit.object;
    memcpy(seen->point, hit.world, sizeof hit.world);
    memcpy(seen->microfacet, hit.microfacet, sizeof hit.microfacet);
    if (tracer->scene->objects[hit.object].kind == SCENE_Plane)
        return true;
    rtcInitIntersectContext(&context);
    rtcIntersect1(tracer->traced, &context, &found);
    seen->triangle = found.hit.primID;
    return true;
}

/* -- all triangles, in double */

/* Six times the volume of the tetrahedron of a point, a direction and two corners: the sign
 * gives the side on which the ray passes the edge. */
static double side_of(const double at[3], const double way[3], const double a[3], const double b[3])
{
    double from[2][3], normal[3];
    for (int i = 0; i < 3; i++) {
        from[0][i] = a[i] - at[i];
        from[1][i] = b[i] - at[i];
    }
    reference_cross(from[0], from[1], normal);
    return reference_dot(normal, way);
}

static bool stands_between(const double corners[3][3], const double at[3], const double way[3],
                           double distance)
{
    const double sides[3] = {side_of(at, way, corners[0], corners[1]),
                             side_of(at, way, corners[1], corners[2]),
                             side_of(at, way, corners[2], corners[0])};
    const bool left = sides[0] > 0 && sides[1] > 0 && sides[2] > 0,
               right = sides[0] < 0 && sides[1] < 0 && sides[2] < 0;
    if (!left && !right)
        return false;
    const double along = plane_at(corners, at, way);
    return along > 0 && along < distance;
}

/* True if a triangle other than the visible one blocks the light. */
static bool is_dark(const Tracer *tracer, const SceneLight *light, const double at[3],
                    const Seen *seen)
{
    double way[3], corners[3][3];
    const double distance = shadow_way_to(light, at, way);
    for (int i = 0; i < tracer->scene->object_count; i++)
        for (unsigned t = 0; t < (unsigned)tracer->shapes[i].index_count / 3; t++) {
            corners_of(tracer, i, t, corners);
            if ((i != seen->object || t != seen->triangle) &&
                stands_between((const double(*)[3])corners, at, way, distance))
                return true;
        }
    return false;
}

/* -- verdicts */

/* Offsets a point slightly from the surface, to the light's side. */
static void lift(const ShadowJudge *judge, const double way[3], const Seen *seen, double lifted[3])
{
    const double off = (reference_dot(seen->microfacet, way) < 0 ? -1 : 1) * 3 * tie * judge->reach;
    for (int i = 0; i < 3; i++)
        lifted[i] = seen->point[i] + off * seen->microfacet[i];
}

/* Embree's result. */
static bool embree_lit(const ShadowJudge *judge, const SceneLight *light, const Seen *seen)
{
    struct RTCIntersectContext context;
    double way[3], from[3];
    const double distance = shadow_way_to(light, seen->point, way);
    lift(judge, way, seen, from);
    struct RTCRay ray = ray_of(from, way, distance);
    rtcInitIntersectContext(&context);
    rtcOccluded1(judge->tracer->traced, &context, &ray);
    return ray.tfar > 0;
}

/* Moves a point by the tie's width, along an axis, or on the same triangle as seen from the eye. */
static void move(const ShadowJudge *judge, const Ray *ray, const Seen *seen, int direction,
                 double at[3])
{
    const double width = tie * judge->reach;
    double corners[3][3], moved[3], way[3];
    memcpy(at, seen->point, 3 * sizeof *at);
    if (direction < 6) {
        at[direction / 2] += direction % 2 ? width : -width;
        return;
    }
    const bool plane = judge->tracer->scene->objects[seen->object].kind == SCENE_Plane;
    if (plane)
        return;
    corners_of(judge->tracer, seen->object, seen->triangle, corners);
    for (int i = 0; i < 3; i++) {
        way[i] = seen->point[i] - ray->at[i];
        moved[i] = seen->point[i];
    }
    const SceneCamera *camera = &judge->tracer->scene->camera;
    for (int i = 0; i < 3; i++)
        moved[i] +=
            (direction % 2 ? width : -width) * (direction < 8 ? camera->right : camera->up)[i];
    const double along = plane_at((const double(*)[3])corners, moved, way);
    for (int i = 0; i < 3; i++)
        at[i] = moved[i] + along * way[i];
}

static ShadowVerdict verdict_of(const ShadowJudge *judge, const SceneLight *light, const Ray *ray,
                                bool lit)
{
    Seen seen = {.object = -1};
    double at[3], way[3];
    if (!see(judge->tracer, ray, &seen))
        return SHADOW_nothing;
    const double distance = shadow_way_to(light, seen.point, way);
    lift(judge, way, &seen, at);
    if (shadow_is_behind_plane(judge->tracer->scene, at, way, distance))
        return lit ? SHADOW_wrong : SHADOW_right;
    if (embree_lit(judge, light, &seen) == lit ||
        is_dark(judge->tracer, light, seen.point, &seen) != lit)
        return SHADOW_right;
    for (int i = 0; i < DIRECTIONS; i++) {
        move(judge, ray, &seen, i, at);
        if (is_dark(judge->tracer, light, at, &seen) != lit)
            return SHADOW_tie;
    }
    return SHADOW_wrong;
}

ShadowVerdict shadow_verdict(const ShadowJudge *judge, const SceneLight *light, const double at[2],
                             bool lit)
{
    const double step = 1.0 / 128; /* in pixels */
    const Scene *scene = judge->tracer->scene;
    const Ray ray = reference_ray(scene, at[0], at[1]);
    const ShadowVerdict verdict = verdict_of(judge, light, &ray, lit);
    for (int i = 0; verdict == SHADOW_wrong && i < 9; i++) {
        const Ray beside =
            reference_ray(scene, at[0] + step * (i % 3 - 1), at[1] + step * (i / 3 - 1));
        Seen here = {.object = -1}, there = {.object = -1};
        if (see(judge->tracer, &ray, &here) && see(judge->tracer, &beside, &there) &&
            (here.object != there.object || here.triangle != there.triangle) &&
            verdict_of(judge, light, &beside, lit) != SHADOW_wrong)
            return SHADOW_seen_tie;
    }
    return verdict;
}
