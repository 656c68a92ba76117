/* Volumes: a grid over the shape, a column of solid intervals over each of its places, and
 * triangles between these columns (scene_volume_cells.c), with corners where the surface crosses
 * their edges (scene_volume_crossings.c), and its normals there. Corners are on edges, as in
 * marching cubes; dual contouring, with one corner per cell, would need the normals first.
 *
 * Inside is where f = max((z - h0) (h1 - z), (z - h2) (h3 - z)) > 0. A point is X = P + z A,
 * over the place P, where A is the vector of a height of 1 along the normal. Its normal is -grad
 * f, from f's slopes along the triangle's two directions and along z, and the directions of
 * these three. All slopes are differences over 1/128 of a step to either side.
 *
 *     A ball of radius 1 over a square: h1 = -h0 = sqrt(1 - r^2), f = 1 - r^2 - z^2, whose
 *     slopes are a ball's also at its equator, where each height's slope is infinite. */
#include "runtime/scene/scene_places.h"
#include "runtime/tessellate/scene_volume.h"
#include "compiler/base/vec3.h"
#include "runtime/tessellate/scene_divide.h"
#include "runtime/tessellate/scene_volume_crossings.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { LEVELS_OF_THIN = 4, MAX_LEVELS = 1024, OFFSETS = 4, BATCH = 4096 };
static const double offset_part = 1. / 128;

typedef struct {
    const SceneVolume *volume;
    Shape grid;
    int *place;
    SceneColumn *columns;
    SceneLayers layers;
    double width; /* mean length of the grid's edges */
    SceneCells cells;
} Making;

static void point_over(const SceneColumn *c, double z, double point[3])
{
    for (int i = 0; i < 3; i++)
        point[i] = (double)c->at.position[i] + z * c->along[i];
}

static bool make_columns(Making *m)
{
    const int count = m->grid.vertex_count;
    m->place = scene_places(&m->grid);
    m->columns = calloc((size_t)count + 1, sizeof *m->columns);
    ShapeVertex *joined = calloc((size_t)count + 1, sizeof *joined);
    const bool fine = m->place && m->columns && joined;
    if (fine)
        scene_places_join(&m->grid, m->place, joined);
    for (int i = 0; fine && i < count; i++)
        m->columns[i].at = joined[m->place[i]];
    free(joined);
    return fine && m->volume->solid(m->volume->user, m->columns, count);
}

static double distance(const double a[3], const double b[3])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

/* Returns the smallest of three thicknesses, each at its thickest place: both intervals, and the
 * gap between them. */
static double thickness_of(const SceneColumn *columns, int count)
{
    double most[3] = {0}, least = INFINITY;
    for (int i = 0; i < count; i++) {
        const double *h = columns[i].heights;
        most[0] = fmax(most[0], h[1] - h[0]);
        most[1] = fmax(most[1], h[3] - h[2]);
        if (h[0] < h[1] && h[2] < h[3])
            most[2] = fmax(most[2], fmax(h[2] - h[1], h[0] - h[3]));
    }
    for (int k = 0; k < 3; k++)
        least = most[k] > 0 ? fmin(least, most[k]) : least;
    return least;
}

/* Sets the levels: their distance is the mean edge length of the grid, or a quarter of the
 * thinnest part, if less; the first and the last level are half a step outside of the solid. */
static void make_layers(Making *m)
{
    const double none[3] = {0};
    double low = INFINITY, high = -INFINITY, way = 0, along = 0;
    for (int i = 0; i < m->grid.index_count; i++) {
        const SceneColumn *c = &m->columns[m->place[m->grid.indices[i]]],
                          *next = &m->columns[m->place[m->grid.indices[i - i % 3 + (i + 1) % 3]]];
        double from[3], to[3];
        point_over(c, 0, from);
        point_over(next, 0, to);
        way += distance(from, to);
        along += distance(c->along, none);
        for (int k = 0; k < 4; k += 2)
            if (c->heights[k] < c->heights[k + 1]) {
                low = fmin(low, c->heights[k]);
                high = fmax(high, c->heights[k + 1]);
            }
    }
    double step = m->width = way / fmax(along, 1e-30);
    if (!(low < high))
        low = 0, high = 0;
    step = fmin(step, thickness_of(m->columns, m->grid.vertex_count) / LEVELS_OF_THIN);
    step = fmax(step, (high - low) / (MAX_LEVELS - 2));
    m->layers = (SceneLayers){&m->grid, m->place, m->columns, low - step / 2, step, 0};
    m->layers.levels = step > 0 ? (int)ceil((high - low) / step) + 1 : 0;
}

static void forget(Making *m)
{
    shape_free(&m->grid);
    free(m->place);
    free(m->columns);
    scene_cells_free(&m->cells);
    m->place = NULL;
    m->columns = NULL;
}

static bool march(Making *m, const Shape *from, int parts)
{
    forget(m);
    if (!scene_divide(from, parts, &m->grid) || !make_columns(m))
        return false;
    make_layers(m);
    return scene_volume_cells(&m->layers, &m->cells);
}

/* Chooses the parts that make about that many triangles, by a coarse trial, since a volume may
 * have any number of surfaces. */
static bool march_to(Making *m, const Shape *from, double triangles)
{
    enum { TRY_PART = 16, MIN_TRY = 4, MAX_PARTS = 4096 };
    const double few = fmax(from->index_count / 3., 1);
    int parts = (int)ceil(fmax(sqrt(triangles / TRY_PART / few), 1));
    parts = parts < MIN_TRY ? MIN_TRY : parts;
    if (!march(m, from, parts))
        return false;
    const double got = (double)m->cells.index_count / 3;
    const double wanted = got > 0 ? parts * sqrt(triangles / got) : sqrt(triangles / few);
    const int finer = (int)ceil(fmax(fmin(wanted, MAX_PARTS), 1));
    return finer == parts || march(m, from, finer);
}

static bool put_unit(const double v[3], double side, float to[3])
{
    const double size = vec3_length(v);
    for (int i = 0; i < 3 && size > 0; i++)
        to[i] = (float)(side * v[i] / size);
    return size > 0;
}

/* Returns the grid's vertex at a node's place, with the attributes of the node's triangle. */
static ShapeVertex base_of(const Making *m, const SceneNode *node, const SceneSpot *s)
{
    const ShapeVertex *v = m->grid.vertices;
    const bool turned = m->place[node->a] > m->place[node->b];
    return node->kind == SCENE_NODE_along
               ? scene_volume_mixed(&v[node->a], &v[node->b], turned ? 1 - s->t : s->t)
               : v[node->a];
}

/* Sets the columns around a node: forward and backward along two sides of its triangle, 1/128 of
 * each. */
static void set_around(const Making *m, const SceneNode *node, const ShapeVertex *base,
                       SceneColumn around[OFFSETS])
{
    const uint32_t *index = &m->grid.indices[3 * (size_t)node->triangle];
    const ShapeVertex *v = m->grid.vertices;
    for (int i = 0; i < OFFSETS; i++) {
        ShapeVertex way = scene_volume_mixed(&v[index[0]], &v[index[1 + i / 2]], 0),
                    end = v[index[1 + i / 2]];
        const double by = i % 2 ? -offset_part : offset_part;
        float *to[] = {around[i].at.position, around[i].at.normal, around[i].at.uv,
                       around[i].at.tangentU, around[i].at.tangentV};
        const float *at[] = {base->position, base->normal, base->uv, base->tangentU,
                             base->tangentV},
                    *from[] = {way.position, way.normal, way.uv, way.tangentU, way.tangentV},
                    *until[] = {end.position, end.normal, end.uv, end.tangentU, end.tangentV};
        for (int part = 0; part < 5; part++)
            for (int component = 0; component < (part == 2 ? 2 : 3); component++)
                to[part][component] = at[part][component] +
                                      (float)by * (until[part][component] - from[part][component]);
    }
}

/* Returns the slope of f from behind to ahead. If one of the ends is outside the rim of the
 * solid, where heights meet and f is flat, it is twice the slope of the inner half; but not at a
 * cliff, where f is not 0. */
static double slope_of(const SceneColumn ends[2], const SceneSpot *s, unsigned pairs)
{
    const double ahead = scene_volume_field(&ends[0], pairs, s->height),
                 behind = scene_volume_field(&ends[1], pairs, s->height);
    if (scene_volume_pairs(&ends[0], 1) == scene_volume_pairs(&ends[1], 1) ||
        fabs(s->field) > fmax(ahead, behind) / 4)
        return ahead - behind;
    return ahead > behind ? 2 * (ahead - s->field) : 2 * (s->field - behind);
}

/* Writes the normal -grad f, from columns around a point and over it. */
static void put_normal(const SceneColumn around[OFFSETS], const SceneSpot *s, double step,
                       float normal[3])
{
    const SceneColumn *over = &s->there;
    const double z = s->height;
    const unsigned pairs = scene_volume_pairs(around, OFFSETS) | scene_volume_pairs(over, 1);
    double slope[3], way[2][3], sum[3], part[3], whole;
    for (int k = 0; k < 2; k++) {
        double ahead[3], behind[3];
        point_over(&around[2 * k], z, ahead);
        point_over(&around[2 * k + 1], z, behind);
        slope[k] = slope_of(&around[2 * k], s, pairs);
        for (int i = 0; i < 3; i++)
            way[k][i] = ahead[i] - behind[i];
    }
    slope[2] = (scene_volume_field(over, pairs, z + offset_part * step) -
                scene_volume_field(over, pairs, z - offset_part * step)) /
               (2 * offset_part * step);
    vec3_cross(way[0], way[1], sum);
    whole = vec3_dot(sum, over->along);
    for (int i = 0; i < 3; i++)
        sum[i] *= slope[2];
    vec3_cross(way[1], over->along, part);
    for (int i = 0; i < 3; i++)
        sum[i] += slope[0] * part[i];
    vec3_cross(over->along, way[0], part);
    for (int i = 0; i < 3; i++)
        sum[i] += slope[1] * part[i];
    put_unit(sum, whole > 0 ? -1 : 1, normal);
}

/* Writes the normal of the wall over an edge, perpendicular to the edge and to its column. */
static void put_wall_normal(const Making *m, const SceneNode *node, const SceneColumn *over,
                            float normal[3])
{
    const uint32_t *index = &m->grid.indices[3 * (size_t)node->triangle];
    const float *a = m->grid.vertices[index[node->rim]].position,
                *b = m->grid.vertices[index[(node->rim + 1) % 3]].position;
    const double way[3] = {(double)b[0] - (double)a[0], (double)b[1] - (double)a[1],
                           (double)b[2] - (double)a[2]};
    double across[3];
    vec3_cross(way, over->along, across);
    put_unit(across, 1, normal);
}

/* Returns whether two nodes have equal neighborhoods. */
static bool same_around(const Making *m, const SceneSpot *spots, uint32_t a, uint32_t b)
{
    return m->cells.nodes[a].triangle == m->cells.nodes[b].triangle &&
           spots[a].from == spots[b].from && spots[a].to == spots[b].to && spots[a].t == spots[b].t;
}

static void put_point(const Making *m, const SceneSpot *s, uint32_t number, Shape *made)
{
    double point[3];
    made->vertices[number] = base_of(m, &m->cells.nodes[number], s);
    memcpy(made->base[number], s->there.at.position, sizeof made->base[number]);
    point_over(&s->there, s->height, point);
    for (int component = 0; component < 3; component++)
        made->vertices[number].position[component] = (float)point[component];
}

typedef struct {
    SceneSpot *spots;
    uint32_t *order;
    SceneColumn *capacity;
} Putting;

/* Puts nodes from `first` on, in their order, as many as fit into a batch with their
 * surroundings. Returns their number. */
static size_t put_some(const Making *m, const Putting *p, size_t first, Shape *made)
{
    int around[BATCH], columns = 0;
    size_t count = 0;
    uint32_t before = 0;
    for (; first + count < m->cells.node_count && count < BATCH && columns + OFFSETS <= BATCH;
         count++) {
        const uint32_t number = p->order[first + count];
        const SceneNode *node = &m->cells.nodes[number];
        put_point(m, &p->spots[number], number, made);
        if (node->rim >= 0)
            continue;
        if (!columns || !same_around(m, p->spots, number, before)) {
            const ShapeVertex base = base_of(m, node, &p->spots[number]);
            set_around(m, node, &base, &p->capacity[columns]);
            columns += OFFSETS;
        }
        around[count] = columns - OFFSETS;
        before = number;
    }
    if (columns && !m->volume->solid(m->volume->user, p->capacity, columns))
        return 0;
    for (size_t i = 0; i < count; i++) {
        const uint32_t number = p->order[first + i];
        const SceneNode *node = &m->cells.nodes[number];
        float *normal = made->vertices[number].normal;
        if (node->rim < 0)
            put_normal(&p->capacity[around[i]], &p->spots[number], m->layers.step, normal);
        else
            put_wall_normal(m, node, &p->spots[number].there, normal);
    }
    return count;
}

static bool put_vertices(const Making *m, const Putting *p, Shape *made)
{
    size_t some = 1;
    for (size_t first = 0; some && first < m->cells.node_count; first += some)
        some = put_some(m, p, first, made);
    return some > 0;
}

static bool put_shape(Making *m, Shape *made)
{
    const size_t count = m->cells.node_count;
    const Putting p = {calloc(count + 1, sizeof *p.spots), calloc(count + 1, sizeof *p.order),
                       calloc(BATCH, sizeof *p.capacity)};
    *made = (Shape){.vertices = calloc(count + 1, sizeof *made->vertices),
                    .base = calloc(count + 1, sizeof *made->base),
                    .indices = m->cells.indices,
                    .vertex_count = (int)count,
                    .index_count = (int)m->cells.index_count};
    m->cells.indices = NULL;
    const bool fine = p.spots && p.order && p.capacity && made->vertices && made->base &&
                      scene_volume_crossings(m->volume, &m->layers, &m->cells, p.spots, p.order) &&
                      put_vertices(m, &p, made);
    free(p.spots);
    free(p.order);
    free(p.capacity);
    if (!fine)
        shape_free(made);
    return fine;
}

bool scene_volume(const Shape *from, const SceneVolume *volume, Shape *made, double steps[2])
{
    Making m = {.volume = volume};
    *made = (Shape){0};
    const bool fine =
        (volume->parts ? march(&m, from, volume->parts) : march_to(&m, from, volume->triangles)) &&
        put_shape(&m, made);
    steps[0] = m.width;
    steps[1] = m.layers.step;
    forget(&m);
    return fine;
}
