/* Volumes: a grid over the shape, a column of what is solid over each of its places, triangles between these columns (scene_volume_cells.c). Along a column the ends are known; across,
 * the surface is found by halving, and at last by a line.
 *
 * Inside is where f = max((z - h0) (h1 - z), (z - h2) (h3 - z)) > 0. A point is X = P + z A, over the place P, whose normal leads by A for a height of 1. Its normal is -grad f: with f's
 * slopes by the triangle's two directions and by z, across the way these three lead. All of them are differences over 1/128 of a step to either side.
 *
 *     A ball of radius 1 over a square: h1 = -h0 = sqrt(1 - r^2), f = 1 - r^2 - z^2, whose slopes are those of a ball at its equator too, where each height's has no end. */
#include "runtime/scene/scene_volume.h"
#include "runtime/scene/scene_divide.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { HALVINGS = 10, LEVELS_OF_THIN = 4, MOST_LEVELS = 1024, OFFSETS = 4, BATCH = 4096 };
static const double offset_part = 1. / 128;

typedef struct {
    const SceneVolume *volume;
    Shape grid;
    int *place;
    SceneColumn *columns;
    SceneLayers layers;
    SceneCells cells;
} Making;

/* a (1 - t) + b t, of all that a vertex has. */
static ShapeVertex mixed(const ShapeVertex *a, const ShapeVertex *b, double t)
{
    enum { LANES = sizeof(ShapeVertex) / sizeof(float) };
    float from[LANES], to[LANES];
    ShapeVertex made;
    memcpy(from, a, sizeof from);
    memcpy(to, b, sizeof to);
    for (int i = 0; i < LANES; i++)
        from[i] = (float)((double)from[i] * (1 - t) + (double)to[i] * t);
    memcpy(&made, from, sizeof made);
    return made;
}

/* Of which of the two pairs some of these columns have something. */
static unsigned pairs_of(const SceneColumn *columns, int count)
{
    unsigned pairs = 0;
    for (int i = 0; i < count; i++)
        for (unsigned pair = 0; pair < 2; pair++)
            pairs |= (unsigned)(columns[i].heights[2 * pair] < columns[i].heights[2 * pair + 1]) << pair;
    return pairs;
}

/* Above 0 between both heights, and nowhere if they are the other way round. */
static double between(double from, double to, double z)
{
    const double above = z - from, below = to - z;
    return above < 0 && below < 0 ? -above * below : above * below;
}

/* f of the pairs that count: one that is nowhere near has heights as well. */
static double field(const SceneColumn *c, unsigned pairs, double z)
{
    const double *h = c->heights;
    return fmax(pairs & 1 ? between(h[0], h[1], z) : -INFINITY, pairs & 2 ? between(h[2], h[3], z) : -INFINITY);
}

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
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) + (a[2] - b[2]) * (a[2] - b[2]));
}

/* So thick are a pair and the gap between both where they are thickest: the thinnest of these three. */
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

/* Levels as far apart as edges of the grid are long in the mean, or a quarter of what is thin, if that is less; the first and the last half a step beyond what is solid. */
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
    double step = way / fmax(along, 1e-30);
    if (!(low < high))
        low = 0, high = 0;
    step = fmin(step, thickness_of(m->columns, m->grid.vertex_count) / LEVELS_OF_THIN);
    step = fmax(step, (high - low) / (MOST_LEVELS - 2));
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

/* As many parts as make about so many triangles: by a coarse try, since what is solid over a shape has any number of surfaces. */
static bool march_to(Making *m, const Shape *from, double triangles)
{
    enum { TRY_PART = 16, LEAST_TRY = 4, MOST_PARTS = 4096 };
    const double few = fmax(from->index_count / 3., 1);
    int parts = (int)ceil(fmax(sqrt(triangles / TRY_PART / few), 1));
    parts = parts < LEAST_TRY ? LEAST_TRY : parts;
    if (!march(m, from, parts))
        return false;
    const double got = (double)m->cells.index_count / 3;
    const double wanted = got > 0 ? parts * sqrt(triangles / got) : sqrt(triangles / few);
    const int finer = (int)ceil(fmax(fmin(wanted, MOST_PARTS), 1));
    return finer == parts || march(m, from, finer);
}

/* Where a vertex stands: over an edge of two places, from the lower number to the higher, so that all of one edge have the same; and how high. */
typedef struct {
    int from, to;
    double t, height, low, high, f_low, f_high;
    unsigned pairs; /* that either place has */
} Spot;

/* The end of what is solid about one end of a step, which is not at the other. */
static double end_within(const SceneColumn *c, double solid, bool above)
{
    double end = solid;
    for (int again = 0; again < 2; again++)
        for (int i = 0; i < 4; i += 2)
            if (c->heights[i] < c->heights[i + 1] && c->heights[i] <= end && end <= c->heights[i + 1])
                end = c->heights[above ? i + 1 : i];
    return end;
}

static Spot spot_of(const Making *m, const SceneNode *node)
{
    const int a = m->place[node->a], b = m->place[node->b];
    Spot s = {
        .from = a < b ? a : b, .to = a < b ? b : a, .height = m->layers.low + node->level * m->layers.step, .high = 1};
    const SceneColumn *from = &m->columns[s.from], *to = &m->columns[s.to];
    s.pairs = pairs_of(from, 1) | pairs_of(to, 1);
    s.f_low = field(from, s.pairs, s.height);
    s.f_high = field(to, s.pairs, s.height);
    if (node->kind == SCENE_NODE_up) {
        const bool above = scene_column_solid(from, s.height);
        const double next = m->layers.low + (node->level + 1) * m->layers.step;
        s.height = end_within(from, above ? s.height : next, above);
    }
    return s;
}

/* One halving of all spots that are along an edge, as many columns at a time as `room` has. */
static bool halve(const Making *m, const SceneCells *cells, Spot *spots, SceneColumn *room)
{
    size_t batch[BATCH];
    for (size_t i = 0; i < cells->node_count;) {
        int count = 0;
        for (; i < cells->node_count && count < BATCH; i++)
            if (cells->nodes[i].kind == SCENE_NODE_along) {
                const Spot *s = &spots[i];
                room[count].at = mixed(&m->columns[s->from].at, &m->columns[s->to].at, (s->low + s->high) / 2);
                batch[count++] = i;
            }
        if (!m->volume->solid(m->volume->user, room, count))
            return false;
        for (int k = 0; k < count; k++) {
            Spot *s = &spots[batch[k]];
            const double f = field(&room[k], s->pairs, s->height), middle = (s->low + s->high) / 2;
            const bool like_low =
                scene_column_solid(&room[k], s->height) == scene_column_solid(&m->columns[s->from], s->height);
            *(like_low ? &s->low : &s->high) = middle;
            *(like_low ? &s->f_low : &s->f_high) = f;
        }
    }
    return true;
}

static bool settle(const Making *m, Spot *spots, SceneColumn *room)
{
    const SceneCells *cells = &m->cells;
    for (size_t i = 0; i < cells->node_count; i++)
        spots[i] = spot_of(m, &cells->nodes[i]);
    for (int k = 0; k < HALVINGS; k++)
        if (!halve(m, cells, spots, room))
            return false;
    for (size_t i = 0; i < cells->node_count; i++) {
        Spot *s = &spots[i];
        const double rise = s->f_high - s->f_low, part = rise != 0 ? -s->f_low / rise : .5;
        if (cells->nodes[i].kind == SCENE_NODE_along)
            s->t = s->low + (s->high - s->low) * fmin(fmax(part, 0), 1);
    }
    return true;
}

static void cross(const double a[3], const double b[3], double result[3])
{
    for (int i = 0; i < 3; i++)
        result[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static bool put_unit(const double v[3], double side, float to[3])
{
    const double size = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3 && size > 0; i++)
        to[i] = (float)(side * v[i] / size);
    return size > 0;
}

/* The vertex of the grid that stands over a node's place, with what its own triangle shades by. */
static ShapeVertex base_of(const Making *m, const SceneNode *node, const Spot *s)
{
    const ShapeVertex *v = m->grid.vertices;
    const bool turned = m->place[node->a] > m->place[node->b];
    return node->kind == SCENE_NODE_along ? mixed(&v[node->a], &v[node->b], turned ? 1 - s->t : s->t) : v[node->a];
}

/* Around it: ahead and behind along two sides of its triangle, 1/128 of each. */
static void set_around(const Making *m, const SceneNode *node, const ShapeVertex *base, SceneColumn around[OFFSETS])
{
    const uint32_t *index = &m->grid.indices[3 * (size_t)node->triangle];
    const ShapeVertex *v = m->grid.vertices;
    for (int i = 0; i < OFFSETS; i++) {
        ShapeVertex way = mixed(&v[index[0]], &v[index[1 + i / 2]], 0), end = v[index[1 + i / 2]];
        const double by = i % 2 ? -offset_part : offset_part;
        float *to[] = {around[i].at.position, around[i].at.normal, around[i].at.uv, around[i].at.tangentU,
                       around[i].at.tangentV};
        const float *at[] = {base->position, base->normal, base->uv, base->tangentU, base->tangentV},
                    *from[] = {way.position, way.normal, way.uv, way.tangentU, way.tangentV},
                    *until[] = {end.position, end.normal, end.uv, end.tangentU, end.tangentV};
        for (int part = 0; part < 5; part++)
            for (int lane = 0; lane < (part == 2 ? 2 : 3); lane++)
                to[part][lane] = at[part][lane] + (float)by * (until[part][lane] - from[part][lane]);
    }
}

/* How f rises from behind to ahead. Where one of them is beyond the rim of what is solid, where heights meet and f rises no more, it is twice the half within; but not at a cliff, where f is not 0. */
static double slope_of(const SceneColumn ends[2], const SceneColumn *over, unsigned pairs, double z)
{
    const double ahead = field(&ends[0], pairs, z), behind = field(&ends[1], pairs, z), here = field(over, pairs, z);
    if (pairs_of(&ends[0], 1) == pairs_of(&ends[1], 1) || fabs(here) > fmax(ahead, behind) / 4)
        return ahead - behind;
    return ahead > behind ? 2 * (ahead - here) : 2 * (here - behind);
}

/* -grad f, of columns around a point and over it. */
static void put_normal(const SceneColumn around[OFFSETS], const SceneColumn *over, double z, double step,
                       float normal[3])
{
    const unsigned pairs = pairs_of(around, OFFSETS) | pairs_of(over, 1);
    double slope[3], way[2][3], sum[3], part[3], whole;
    for (int k = 0; k < 2; k++) {
        double ahead[3], behind[3];
        point_over(&around[2 * k], z, ahead);
        point_over(&around[2 * k + 1], z, behind);
        slope[k] = slope_of(&around[2 * k], over, pairs, z);
        for (int i = 0; i < 3; i++)
            way[k][i] = ahead[i] - behind[i];
    }
    slope[2] = (field(over, pairs, z + offset_part * step) - field(over, pairs, z - offset_part * step)) /
               (2 * offset_part * step);
    cross(way[0], way[1], sum);
    whole = sum[0] * over->along[0] + sum[1] * over->along[1] + sum[2] * over->along[2];
    for (int i = 0; i < 3; i++)
        sum[i] *= slope[2];
    cross(way[1], over->along, part);
    for (int i = 0; i < 3; i++)
        sum[i] += slope[0] * part[i];
    cross(over->along, way[0], part);
    for (int i = 0; i < 3; i++)
        sum[i] += slope[1] * part[i];
    put_unit(sum, whole > 0 ? -1 : 1, normal);
}

/* Across the wall over an edge, as the edge and its normal lead. */
static void put_wall_normal(const Making *m, const SceneNode *node, const SceneColumn *over, float normal[3])
{
    const uint32_t *index = &m->grid.indices[3 * (size_t)node->triangle];
    const float *a = m->grid.vertices[index[node->rim]].position,
                *b = m->grid.vertices[index[(node->rim + 1) % 3]].position;
    const double way[3] = {(double)b[0] - (double)a[0], (double)b[1] - (double)a[1], (double)b[2] - (double)a[2]};
    double across[3];
    cross(way, over->along, across);
    put_unit(across, 1, normal);
}

static bool put_vertices(const Making *m, const Spot *spots, SceneColumn *room, Shape *made)
{
    enum { EACH = OFFSETS + 1 };
    const SceneCells *cells = &m->cells;
    for (size_t first = 0; first < cells->node_count; first += BATCH / EACH) {
        const size_t left = cells->node_count - first, count = left < BATCH / EACH ? left : BATCH / EACH;
        for (size_t i = 0; i < count; i++) {
            const SceneNode *node = &cells->nodes[first + i];
            const Spot *s = &spots[first + i];
            made->vertices[first + i] = base_of(m, node, s);
            set_around(m, node, &made->vertices[first + i], &room[EACH * i]);
            room[EACH * i + OFFSETS].at = mixed(&m->columns[s->from].at, &m->columns[s->to].at, s->t);
        }
        if (!m->volume->solid(m->volume->user, room, (int)count * EACH))
            return false;
        for (size_t i = 0; i < count; i++) {
            const SceneNode *node = &cells->nodes[first + i];
            const SceneColumn *over = &room[EACH * i + OFFSETS];
            ShapeVertex *vertex = &made->vertices[first + i];
            double point[3];
            memcpy(made->base[first + i], over->at.position, sizeof made->base[first + i]);
            point_over(over, spots[first + i].height, point);
            for (int lane = 0; lane < 3; lane++)
                vertex->position[lane] = (float)point[lane];
            if (node->rim < 0)
                put_normal(&room[EACH * i], over, spots[first + i].height, m->layers.step, vertex->normal);
            else
                put_wall_normal(m, node, over, vertex->normal);
        }
    }
    return true;
}

static bool put_shape(Making *m, Shape *made)
{
    const size_t count = m->cells.node_count;
    Spot *spots = calloc(count + 1, sizeof *spots);
    SceneColumn *room = calloc(BATCH, sizeof *room);
    *made = (Shape){.vertices = calloc(count + 1, sizeof *made->vertices),
                    .base = calloc(count + 1, sizeof *made->base),
                    .indices = m->cells.indices,
                    .vertex_count = (int)count,
                    .index_count = (int)m->cells.index_count};
    m->cells.indices = NULL;
    const bool fine =
        spots && room && made->vertices && made->base && settle(m, spots, room) && put_vertices(m, spots, room, made);
    free(spots);
    free(room);
    if (!fine)
        shape_free(made);
    return fine;
}

bool scene_volume(const Shape *from, const SceneVolume *volume, Shape *made)
{
    Making m = {.volume = volume};
    *made = (Shape){0};
    const bool fine =
        (volume->parts ? march(&m, from, volume->parts) : march_to(&m, from, volume->triangles)) && put_shape(&m, made);
    forget(&m);
    return fine;
}
