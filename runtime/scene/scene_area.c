/* The foot of the camera on the light's plane is a u + b v from the light's corner. Lines of
 * constant a have a distance of sqrt(det / v.v) per unit of a, det = u.u v.v - (u.v)^2, so that
 * a strip of given width around the foot is a range of a; the same holds for b.
 *
 *     u = [1e9, 0, 0], v = [0, 1e9, 0] from [-5e8, -5e8, 10], a camera at [0, -6, 2] that looks
 *         6 away: the plane is 8 away, the foot at a = 0.5, b = 0.499999994, and the part 80,000
 *         to each side, a from 0.49992 to 0.50008 */
#include "runtime/scene/scene_area.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>

typedef struct {
    /* position of the foot along an edge, and half width of the part: in edge lengths */
    double at, width;
} Along;

static double reach_of(const SceneCamera *camera, double height)
{
    double way[3];
    for (int i = 0; i < 3; i++)
        way[i] = camera->position[i] - camera->target[i];
    const double away = sqrt(vec3_dot(way, way));
    const double scale =
        fmax(fabs(height), camera->kind == SCENE_Orthographic ? fmax(away, camera->half) : away);
    return SCENE_AREA_REACH * scale;
}

static void find_foot(const SceneCamera *camera, const SceneLight *light, Along along[2])
{
    const double *u = light->edges[0], *v = light->edges[1];
    const double uu = vec3_dot(u, u), uv = vec3_dot(u, v), vv = vec3_dot(v, v);
    const double det = uu * vv - uv * uv;
    double from[3], normal[3];
    for (int i = 0; i < 3; i++)
        from[i] = camera->position[i] - light->position[i];
    vec3_cross(u, v, normal);
    vec3_normalize(normal);
    const double x = vec3_dot(from, u), y = vec3_dot(from, v);
    const double reach = reach_of(camera, vec3_dot(from, normal));
    along[0] = (Along){(x * vv - y * uv) / det, reach / sqrt(det / vv)};
    along[1] = (Along){(y * uu - x * uv) / det, reach / sqrt(det / uu)};
}

bool scene_area_cut(const SceneCamera *camera, const SceneLight *light, SceneLight *cut)
{
    Along along[2];
    bool is_part = false;
    *cut = *light;
    if (!vec3_span(light->edges[0], light->edges[1]))
        return false; /* the parallelogram degenerates to a line */
    find_foot(camera, light, along);
    for (int edge = 0; edge < 2; edge++) {
        const double middle = fmin(fmax(along[edge].at, 0), 1);
        const double low = fmax(middle - along[edge].width, 0),
                     high = fmin(middle + along[edge].width, 1);
        if (!(low > 0 || high < 1))
            continue;
        is_part = true;
        for (int i = 0; i < 3; i++) {
            cut->position[i] += low * light->edges[edge][i];
            cut->edges[edge][i] *= high - low;
        }
    }
    return is_part;
}

bool scene_area_cuts(const Scene *scene)
{
    SceneLight cut;
    bool cuts = false;
    for (int i = 0; !cuts && i < scene->light_count; i++)
        cuts = light_from(&scene->lights[i]) == LIGHT_FROM_extent &&
               scene_area_cut(&scene->camera, &scene->lights[i], &cut);
    return cuts;
}
