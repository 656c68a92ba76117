#include "tests/frame_reference/shadow_ray.h"
#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

double shadow_way_to(const SceneLight *light, const double point[3], double way[3])
{
    for (int i = 0; i < 3; i++)
        way[i] =
            light->kind == SCENE_Directional ? -light->direction[i] : light->position[i] - point[i];
    const double length = sqrt(reference_dot(way, way));
    reference_normalize(way);
    return light->kind == SCENE_Directional ? INFINITY : length;
}

bool shadow_sides_agree(const SceneLight *light, const Hit *hit)
{
    double way[3];
    shadow_way_to(light, hit->world, way);
    return reference_dot(way, hit->microfacet) * reference_dot(way, hit->normal) > 0;
}

double shadow_texel(const Scene *scene, const SceneLight *light, const double point[3],
                    double reach)
{
    double way[3];
    const double distance = shadow_way_to(light, point, way);
    const double wide =
        light->kind == SCENE_Spot && light->outer_cosine > .5
            ? sqrt(1 - light->outer_cosine * light->outer_cosine) / light->outer_cosine
            : 1;
    return (light->kind == SCENE_Directional ? reach : 2 * wide * distance) / scene->shadow_size;
}

bool shadow_is_behind_plane(const Scene *scene, const double from[3], const double way[3],
                            double distance)
{
    Hit hit = {.distance = distance};
    Ray ray;
    memcpy(ray.at, from, sizeof ray.at);
    memcpy(ray.way, way, sizeof ray.way);
    for (int i = 0; i < scene->object_count; i++)
        if (scene->objects[i].kind == SCENE_Plane)
            reference_plane(&scene->objects[i], &ray, 0, &hit);
    return hit.distance < distance;
}

bool shadow_is_lit(const Tracer *tracer, const SceneLight *light, const double point[3],
                   const double microfacet[3])
{
    double way[3], from[3];
    const double distance = shadow_way_to(light, point, way);
    const double off = (reference_dot(microfacet, way) < 0 ? -1 : 1) * 3e-5;
    for (int i = 0; i < 3; i++)
        from[i] = point[i] + off * microfacet[i];
    return !reference_is_blocked(tracer, from, way, distance) &&
           !shadow_is_behind_plane(tracer->scene, from, way, distance);
}

void shadow_beside(const Hit *hit, const double way[3], double step, double angle, double moved[3])
{
    const int least = fabs(way[0]) < fabs(way[1])   ? fabs(way[0]) < fabs(way[2]) ? 0 : 2
                      : fabs(way[1]) < fabs(way[2]) ? 1
                                                    : 2;
    double helper[3] = {0}, x[3], y[3], across[3];
    helper[least] = 1;
    reference_cross(helper, way, x);
    reference_normalize(x);
    reference_cross(way, x, y);
    for (int i = 0; i < 3; i++)
        across[i] = step * (cos(angle) * x[i] + sin(angle) * y[i]);
    const double along =
        -reference_dot(across, hit->microfacet) / reference_dot(way, hit->microfacet);
    for (int i = 0; i < 3; i++)
        moved[i] = hit->world[i] + across[i] + along * way[i];
}

const double shadow_angles[SHADOW_ANGLES][2] = {{.5, 20}, {3, 100},  {12, 200}, {25, 320},
                                                {45, 60}, {70, 250}, {89.5, 10}};

void shadow_place(const double angle[2], double distance, double at[3])
{
    const double up = angle[0] * pi / 180, around = angle[1] * pi / 180;
    at[0] = distance * cos(up) * cos(around);
    at[1] = distance * cos(up) * sin(around);
    at[2] = distance * sin(up);
}
