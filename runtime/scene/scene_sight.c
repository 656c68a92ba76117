/* A triangle, and all places where its shadow may fall, against the sides of what a camera sees.
 * Along a ray from a light, how far it is inside of a side goes evenly: so it is beyond it where it
 * begins to fall, at the triangle, and where it leaves the box around all objects, or nowhere in
 * between is in view.
 *
 *     The half space x > 0 is seen, the box ends at z = 0. Light from (1, 0, -1), a triangle that
 *         ends at x = -2, at most 1 high: its shadow ends at -2 + 1, out of view. At 3 high it ends
 *         at 1 */
#include "runtime/scene/scene_sight.h"
#include "runtime/scene/scene_matrix.h"
#include <math.h>

/* of how far a triangle is away: what comes into view beside it is kept */
static const double beside = 0.1;
static const double lifted =
    /* of how far away points are, at most, that ask for shadows: they do so a part of a pixel above
     * the surface */
    0.001;
/* of what a map of a lamp shows at a distance of 1, which is no wider */
static const double widest = 4;

/* A triangle whose points move by no more than `bound`. */
typedef struct {
    const double (*corners)[3];
    double bound, low[3], high[3]; /* around all that */
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

/* How far rays by the triangle go on until they have left the box: as a length, or as times what
 * they have gone from a lamp. Infinite: that is not known. */
static double reach_of(const SceneSight *sight, const SceneLight *light, const SightTriangle *moved)
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

/* Length until no ray is before a ground any more. A ray that never reaches it has no shadow there;
 * infinite: a ray may run along it. */
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
    const double room =
        /* a ray that comes nearer to it from the lamp is there when it has come that near */
        fabs(from) - most;
    return least >= fabs(from) ? 1 : room > along * fabs(from) ? fabs(from) / room : INFINITY;
}

static double far_from(const double at[3], const double low[3], const double high[3])
{
    double square = 0;
    for (int k = 0; k < 3; k++)
        square += pow(fmax(at[k] - low[k], high[k] - at[k]), 2);
    return sqrt(square);
}

/* Margin of a map: its filter, and how far a point is lifted before it is looked up. */
static double spread_of(const SceneSight *sight, const SceneLight *light,
                        const SightTriangle *moved, double reach)
{
    enum { TAPS = 2, MORE = 4 /* texels for one of the filter, and beside */ };
    const double size = sight->casts->shadow_size,
                 texels = TAPS * sight->casts->shadow_filter + MORE;
    if (light_from(light) == LIGHT_FROM_afar)
        return texels * 2 * far_from(sight->low, sight->low, sight->high) / size;
    return texels * widest / size * reach * far_from(light->position, moved->low, moved->high);
}

static bool casts_into_view(const SceneSight *sight, const double eye[3], const SceneLight *light,
                            const SightTriangle *moved)
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

bool scene_sight_misses(const SceneSight *sight, const double eye[3], const double corners[3][3],
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
