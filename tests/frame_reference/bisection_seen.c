/* Visibility of a box for a camera, directly or by its shadow, in double. */
#include "tests/frame_reference/bisection_seen.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>

/* Distance of a box from a point. */
static double box_far(const double at[3], const double low[3], const double high[3])
{
    double square = 0;
    for (int i = 0; i < 3; i++) {
        const double away = fmax(fmax(low[i] - at[i], at[i] - high[i]), 0);
        square += away * away;
    }
    return sqrt(square);
}

/* A segment from the eye to the center of a light; `grows` is the half size of the light's
 * bounding box. */
typedef struct {
    double from[3], way[3], last, grows[3];
} Line;

/* Distance of a box from the segment between the eye and a light, by ternary search: the
 * distance has a single minimum along it. */
static double line_far(const Line *line, const BisectionBox *box)
{
    double begin = 0, last = line->last, far[2] = {0};
    for (int step = 0; step < 80; step++) {
        double at[3], low[3], high[3];
        for (int k = 0; k < 2; k++) {
            const double s = begin + (last - begin) * (k + 1) / 3;
            for (int i = 0; i < 3; i++) {
                at[i] = line->from[i] + s * line->way[i];
                low[i] = box->low[i] - s * line->grows[i];
                high[i] = box->high[i] + s * line->grows[i];
            }
            far[k] = box_far(at, low, high);
        }
        if (far[0] < far[1])
            last -= (last - begin) / 3;
        else
            begin += (last - begin) / 3;
    }
    return fmin(far[0], far[1]);
}

/* Signed distance of a point from a side of the frustum, unnormalized: below 0 outside. */
static double capacity_at(const SceneCamera *c, int side, const double way[3])
{
    const double depth = -vec3_dot(way, c->back);
    const double across = vec3_dot(way, side < 3 ? c->right : c->up);
    return !side ? depth : c->half * depth - (side % 2 ? across : -across);
}

/* True if all three normals face away from every point of the box, given the view vectors to its
 * corners, by more than 37 degrees. */
static bool looks_away(const BisectionBox *box, double (*ways)[3], int count)
{
    double far = 0, least = INFINITY;
    for (int i = 0; i < count; i++) {
        far = fmax(far, vec3_dot(ways[i], ways[i]));
        for (int k = 0; k < 3; k++)
            least = fmin(least, vec3_dot(box->normal[k], ways[i]));
    }
    return box->closed && least > .6 * sqrt(far) * box->longest;
}

/* Bounding box of a light's emitting surface. */
static void light_box(const SceneLight *light, double low[3], double high[3])
{
    for (int k = 0; k < 3; k++) {
        low[k] = high[k] = light->position[k];
        for (int i = 0; i < 2 && light->kind == SCENE_Area; i++) {
            low[k] += fmin(light->edges[i][k], 0);
            high[k] += fmax(light->edges[i][k], 0);
        }
    }
}

/* True if no point of the box casts a shadow into view: for each corner of the light, the
 * shadows of all corners of the box, from the box to the farthest relevant distance, are outside
 * of one frustum side; or the whole box faces away from the light. */
static bool casts_nothing(const SceneCamera *c, const SceneLight *light, const BisectionBox *box)
{
    int beyond[5] = {0};
    double rays[64][3], shines[2][3];
    light_box(light, shines[0], shines[1]);
    for (int i = 0; i < 64; i++) {
        double *ray = rays[i], to[2][3];
        for (int k = 0; k < 3; k++) {
            const double at = i >> k & 1 ? box->high[k] : box->low[k];
            ray[k] = light->kind == SCENE_Directional ? light->direction[k]
                                                      : at - shines[i >> (k + 3) & 1][k];
            to[0][k] = at - c->position[k];
            to[1][k] = to[0][k] + 1e6 * ray[k];
        }
        for (int side = 0; side < 5; side++)
            beyond[side] += capacity_at(c, side, to[0]) < 0 && capacity_at(c, side, to[1]) < 0;
    }
    bool hidden = looks_away(box, rays, 64);
    for (int i = 0; i < 5; i++)
        hidden |= beyond[i] == 64;
    return hidden;
}

static double shadow_far(const Scene *scene, const SceneLight *light, const BisectionBox *box)
{
    const SceneCamera *c = &scene->camera;
    const bool far = light->kind == SCENE_Directional;
    double shines[2][3];
    Line line = {.last = far ? 1e4 : 1};
    if (!scene_light_casts(light) || casts_nothing(c, light, box))
        return INFINITY;
    light_box(light, shines[0], shines[1]);
    for (int i = 0; i < 3; i++) {
        line.from[i] = c->position[i];
        line.way[i] =
            far ? -light->direction[i] : (shines[0][i] + shines[1][i]) / 2 - c->position[i];
        line.grows[i] = far ? 0 : (shines[1][i] - shines[0][i]) / 2;
    }
    return fmax(line_far(&line, box), c->near);
}

double bisection_seen_far(const Scene *scene, const BisectionBox *box)
{
    const SceneCamera *c = &scene->camera;
    /* number of corners outside of each frustum side; 8: invisible, or far behind the horizon */
    int beyond[5] = {0};
    double ways[8][3];
    for (int i = 0; i < 8; i++) {
        double *way = ways[i];
        for (int k = 0; k < 3; k++)
            way[k] = (i >> k & 1 ? box->high[k] : box->low[k]) - c->position[k];
        for (int side = 0; side < 5; side++)
            beyond[side] += capacity_at(c, side, way) < 0;
    }
    bool hidden = looks_away(box, ways, 8);
    for (int i = 0; i < 5; i++)
        hidden |= beyond[i] == 8;
    double far = fmax(box_far(c->position, box->low, box->high), c->near) * (hidden ? 8 : 1);
    for (int i = 0; i < scene->light_count; i++)
        far = fmin(far, shadow_far(scene, &scene->lights[i], box));
    return far;
}
