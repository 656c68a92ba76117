/* How near a box counts to a camera, itself or by its shadow, in double. */
#include "tests/frame/bisection_seen.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>

/* How far a box is from a point. */
static double box_far(const double at[3], const double low[3], const double high[3])
{
    double square = 0;
    for (int i = 0; i < 3; i++) {
        const double away = fmax(fmax(low[i] - at[i], at[i] - high[i]), 0);
        square += away * away;
    }
    return sqrt(square);
}

/* The same from a line, by thirds, which leave out the worse: the distance has one minimum there. */
static double line_far(const double from[3], const double way[3], double last, const double low[3],
                       const double high[3])
{
    double begin = 0, far[2] = {0};
    for (int step = 0; step < 80; step++) {
        double at[3];
        for (int k = 0; k < 2; k++) {
            const double s = begin + (last - begin) * (k + 1) / 3;
            for (int i = 0; i < 3; i++)
                at[i] = from[i] + s * way[i];
            far[k] = box_far(at, low, high);
        }
        if (far[0] < far[1])
            last -= (last - begin) / 3;
        else
            begin += (last - begin) / 3;
    }
    return fmin(far[0], far[1]);
}

/* How much of a side's room there is for a point: less than 0 is beyond it. */
static double room_at(const SceneCamera *c, int side, const double way[3])
{
    const double depth = -scene_vector_dot(way, c->back);
    const double across = scene_vector_dot(way, side < 3 ? c->right : c->up);
    return !side ? depth : c->half * depth - (side % 2 ? across : -across);
}

/* Three normals look away from all of the box, which is seen by these ways, by more than 37 degrees. */
static bool looks_away(const BisectionBox *box, double (*ways)[3])
{
    double far = 0, least = INFINITY;
    for (int i = 0; i < 8; i++)
        far = fmax(far, scene_vector_dot(ways[i], ways[i]));
    for (int i = 0; i < 24; i++)
        least = fmin(least, scene_vector_dot(box->normal[i % 3], ways[i / 3]));
    return box->closed && least > .6 * sqrt(far) * box->longest;
}

/* No point of the box throws a shadow into view: each of its corners', near and as far as can be told, is beyond one side; or all of it is turned away from the light. */
static bool casts_nothing(const SceneCamera *c, const SceneLight *light, const BisectionBox *box)
{
    int beyond[5] = {0};
    double rays[8][3];
    for (int i = 0; i < 8; i++) {
        double at[3], *ray = rays[i], to[2][3];
        for (int k = 0; k < 3; k++) {
            at[k] = i >> k & 1 ? box->high[k] : box->low[k];
            ray[k] = light->kind == SCENE_Directional ? light->direction[k] : at[k] - light->position[k];
            to[0][k] = at[k] - c->position[k];
            to[1][k] = to[0][k] + 1e6 * ray[k];
        }
        for (int side = 0; side < 5; side++)
            beyond[side] += room_at(c, side, to[0]) < 0 && room_at(c, side, to[1]) < 0;
    }
    bool hidden = looks_away(box, rays);
    for (int i = 0; i < 5; i++)
        hidden |= beyond[i] == 8;
    return hidden;
}

static double shadow_far(const Scene *scene, const SceneLight *light, const BisectionBox *box)
{
    const SceneCamera *c = &scene->camera;
    double way[3];
    if (!scene_light_casts(light) || casts_nothing(c, light, box))
        return INFINITY;
    for (int i = 0; i < 3; i++)
        way[i] = light->kind == SCENE_Directional ? -light->direction[i] : light->position[i] - c->position[i];
    return fmax(line_far(c->position, way, light->kind == SCENE_Directional ? 1e4 : 1, box->low, box->high), c->near);
}

double bisection_seen_far(const Scene *scene, const BisectionBox *box)
{
    const SceneCamera *c = &scene->camera;
    /* all eight corners beyond one side of what is seen, or far behind the horizon */
    int beyond[5] = {0};
    double ways[8][3];
    for (int i = 0; i < 8; i++) {
        double *way = ways[i];
        for (int k = 0; k < 3; k++)
            way[k] = (i >> k & 1 ? box->high[k] : box->low[k]) - c->position[k];
        for (int side = 0; side < 5; side++)
            beyond[side] += room_at(c, side, way) < 0;
    }
    bool hidden = looks_away(box, ways);
    for (int i = 0; i < 5; i++)
        hidden |= beyond[i] == 8;
    double far = fmax(box_far(c->position, box->low, box->high), c->near) * (hidden ? 8 : 1);
    for (int i = 0; i < scene->light_count; i++)
        far = fmin(far, shadow_far(scene, &scene->lights[i], box));
    return far;
}
