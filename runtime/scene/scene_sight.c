/* Tests a triangle, and everything on which its shadow may fall, against the planes of the view
 * frustum. Along a light ray the distance from a plane is linear: if a ray is outside a plane at
 * the triangle and where it leaves the box around all objects, no point between is in view.
 *
 *     The half space x > 0 is visible, the box ends at z = 0. Light from (1, 0, -1), a triangle
 *         that ends at x = -2, at most 1 high: its shadow ends at -2 + 1, out of view. At 3 high
 *         the shadow ends at 1. */
#include "runtime/scene/scene_sight.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>

/* margin for turns of the camera, relative to a triangle's distance */
static const double beside = 0.1;
/* Max offset from the surface, relative to the distance, of points that look up shadows: a part
 * of a pixel. */
static const double lifted = 0.001;
/* max width of a lamp's shadow map at a distance of 1 */
static const double widest = 4;

/* A triangle whose points move by at most `bound`. */
typedef struct {
    const double (*corners)[3];
    /* max displacement, and the bounding box including displacement */
    double bound, low[3], high[3];
} SightTriangle;

static SightTriangle triangle_of(const double corners[3][3], double bound)
{
    SightTriangle moved = {.corners = corners, .bound = bound};
    for (int i = 0; i < 3; i++) {
        moved.low[i] = fmin(fmin(corners[0][i], corners[1][i]), corners[2][i]) - bound;
        moved.high[i] = fmax(fmax(corners[0][i], corners[1][i]), corners[2][i]) + bound;
    }
    return moved;
}

static double inside_by(const double plane[4], const double at[3])
{
    return vec3_dot(plane, at) + plane[3];
}

static double most_inside(const double plane[4], const SightTriangle *moved)
{
    double most = -INFINITY;
    for (int k = 0; k < 3; k++)
        most = fmax(most, inside_by(plane, moved->corners[k]));
    return most + moved->bound;
}

/* Returns how far rays past the triangle continue until they have left the box: a length, or,
 * for a lamp, a multiple of their length so far. Infinite if unknown. */
static double reach_of(const SceneFrustums *sight, const SceneLight *light,
                       const SightTriangle *moved)
{
    double reach = INFINITY;
    for (int k = 0; k < 3; k++) {
        const bool far = light_from(light) == LIGHT_FROM_afar;
        const double from = far ? 0 : light->position[k];
        const double least = far ? light->direction[k] : moved->low[k] - from,
                     most = far ? light->direction[k] : moved->high[k] - from;
        if (least > 0)
            reach = fmin(reach, (sight->high[k] - (far ? moved->low[k] : from)) / least);
        if (most < 0)
            reach = fmin(reach, (sight->low[k] - (far ? moved->high[k] : from)) / most);
    }
    return fmax(reach, light_from(light) == LIGHT_FROM_afar ? 0 : 1);
}

/* Returns the length after which all rays have crossed a ground plane. A ray that never reaches
 * the ground casts no shadow there; infinite if a ray may be parallel to the ground. */
static double ground_reach(const double ground[4], const SceneLight *light,
                           const SightTriangle *moved)
{
    const double along = 1e-9;
    const bool far = light_from(light) == LIGHT_FROM_afar;
    const double from = inside_by(ground, light->position), way = !far && from < 0 ? -1 : 1;
    double least = way * ground[3], most = least;
    for (int k = 0; k < 3; k++) {
        least += fmin(way * ground[k] * moved->low[k], way * ground[k] * moved->high[k]);
        most += fmax(way * ground[k] * moved->low[k], way * ground[k] * moved->high[k]);
    }
    if (far) {
        const double goes = vec3_dot(ground, light->direction);
        return fabs(goes) < along ? INFINITY : goes < 0 ? most / -goes : -least / goes;
    }
    /* Min descent of a ray between the lamp and the triangle. The ray reaches the ground after
     * |from| / capacity times that length. */
    const double headroom = fabs(from) - most;
    return least >= fabs(from)             ? 1
           : headroom > along * fabs(from) ? fabs(from) / headroom
                                           : INFINITY;
}

static double far_from(const double at[3], const double low[3], const double high[3])
{
    double square = 0;
    for (int k = 0; k < 3; k++)
        square += pow(fmax(at[k] - low[k], high[k] - at[k]), 2);
    return sqrt(square);
}

/* Returns the margin of a shadow map: its filter, and the offset of points before the lookup. */
static double spread_of(const SceneFrustums *sight, const SceneLight *light,
                        const SightTriangle *moved, double reach)
{
    enum { TAPS = 2, MORE = 4 /* texels per filter width; texels in addition */ };
    const double size = sight->casts->shadow_size,
                 texels = TAPS * sight->casts->shadow_filter + MORE;
    if (light_from(light) == LIGHT_FROM_afar)
        return texels * 2 * far_from(sight->low, sight->low, sight->high) / size;
    return texels * widest / size * reach * far_from(light->position, moved->low, moved->high);
}

static bool casts_into_view(const SceneFrustums *sight, const double eye[3],
                            const SceneLight *light, const SightTriangle *moved)
{
    const bool far = light_from(light) == LIGHT_FROM_afar;
    double reach = reach_of(sight, light, moved), farthest = far_from(eye, sight->low, sight->high);
    for (int i = 0; i < sight->ground_count; i++)
        reach = fmax(reach, ground_reach(sight->grounds[i], light, moved));
    if (!(reach < INFINITY))
        return true;
    if (sight->ground_count)
        farthest =
            fmax(farthest, far ? far_from(eye, moved->low, moved->high) + reach
                               : far_from(eye, light->position, light->position) +
                                     reach * far_from(light->position, moved->low, moved->high));
    const double margin = spread_of(sight, light, moved, reach) + lifted * farthest;
    bool beyond = false;
    for (int i = 0; i < sight->count && !beyond; i++) {
        const double *plane = sight->planes[i], most = most_inside(plane, moved);
        const double goes = far ? reach * vec3_dot(plane, light->direction)
                                : (reach - 1) * (most - inside_by(plane, light->position));
        beyond = most + fmax(goes, 0) < -margin;
    }
    return !beyond;
}

bool scene_sight_misses(const SceneFrustums *sight, const double eye[3], const double corners[3][3],
                        double bound)
{
    const SightTriangle moved = triangle_of(corners, bound);
    double way[3];
    for (int i = 0; i < 3; i++)
        way[i] = corners[0][i] - eye[i];
    const double margin = beside * sqrt(vec3_dot(way, way));
    bool misses = false;
    for (int i = 0; i < sight->count && !misses; i++)
        misses = most_inside(sight->planes[i], &moved) < -margin;
    const Scene *casts = sight->casts;
    for (int i = 0; misses && casts && i < casts->light_count; i++)
        if (scene_light_casts(&casts->lights[i]))
            misses = sight->low[0] < sight->high[0] &&
                     !casts_into_view(sight, eye, &casts->lights[i], &moved);
    return misses;
}
