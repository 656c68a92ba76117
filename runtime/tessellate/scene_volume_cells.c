/* Marching cubes (Lorensen and Cline 1987) for prisms over triangles. Instead of using a table
 * of cases, the surface's border is traced on each face of a prism: walking around the face as
 * seen from outside, each run of solid corners is cut off, from the edge where the walk enters
 * it to the edge where it leaves. A run's exit on one face is an entry on the adjacent face, so
 * these segments close into loops. The neighboring prism walks around the shared face in the
 * opposite direction, cuts off the same runs, and has the same segments reversed. So no case is
 * ambiguous, and the surface is watertight.
 *
 *     Corners 0, 1, 2 below are solid, 3, 4, 5 above are not. Face 0 1 4 3: solid 0 1, entered
 *     on edge 3 0, left on edge 1 4. The other sides: 1 4 to 2 5, 2 5 to 3 0. One loop,
 *     counterclockwise as seen from above.
 *
 * Over an edge with a single triangle the solid ends: there the runs themselves become
 * triangles, corners included. */
#include "runtime/tessellate/scene_volume_cells.h"
#include "compiler/base/hash_index.h"
#include "runtime/tessellate/scene_growing.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CORNERS = 6, EDGES = 9, FACES = 5, SIDES = 3, MAX_CORNERS = 4 };

/* Corners of faces as seen from outside, sides first; -1: a triangle has no fourth. */
static const int faces[FACES][MAX_CORNERS] = {
    {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}, {0, 2, 1, -1}, {3, 4, 5, -1}};
/* Corners of a cell's edges: around the bottom, around the top, vertical. */
static const int edges[EDGES][2] = {{0, 1}, {1, 2}, {2, 0}, {3, 4}, {4, 5},
                                    {5, 3}, {0, 3}, {1, 4}, {2, 5}};

typedef struct {
    const SceneLayers *layers;
    SceneCells *made;
    HashIndex nodes, rims;
    uint8_t *rim; /* indexed by triangle: a bit for each boundary edge */
    bool fine;
} Walk;

bool scene_column_solid(const SceneColumn *c, double z)
{
    for (int i = 0; i < 4; i += 2)
        if (c->heights[i] < c->heights[i + 1] && c->heights[i] <= z && z <= c->heights[i + 1])
            return true;
    return false;
}

static uint32_t hash_of(uint32_t a, uint32_t b, uint32_t c)
{
    const uint32_t mixed = (a * 0x9E3779B1u ^ b) * 0x85EBCA77u ^ c * 0xC2B2AE3Du;
    return (mixed ^ mixed >> 15) * 0x27D4EB2Fu;
}

static uint32_t add_node(Walk *w, SceneNode node)
{
    SceneCells *made = w->made;
    if (!scene_growing(&made->nodes, made->node_count + 1, &made->node_capacity,
                       sizeof *made->nodes)) {
        w->fine = false;
        return 0;
    }
    made->nodes[made->node_count] = node;
    return (uint32_t)made->node_count++;
}

/* Returns the node of a prism's edge, shared by all prisms with that edge. */
static uint32_t shared_node(Walk *w, SceneNode node)
{
    const uint32_t low = node.a < node.b ? node.a : node.b,
                   high = node.a < node.b ? node.b : node.a;
    const uint32_t hash = hash_of(low, high, (uint32_t)node.level);
    HashProbe probe = hash_probe(&w->nodes, hash);
    node.a = low;
    node.b = high;
    while (hash_probe_next(&probe)) {
        const SceneNode *other = &w->made->nodes[probe.number];
        if (other->a == node.a && other->b == node.b && other->level == node.level)
            return probe.number;
    }
    const uint32_t made = add_node(w, node);
    if (w->fine)
        hash_index_add(NULL, &w->nodes, hash, made);
    return made;
}

static void add_triangle(Walk *w, uint32_t a, uint32_t b, uint32_t c)
{
    SceneCells *made = w->made;
    if (!w->fine || !scene_growing(&made->indices, made->index_count + 3, &made->index_capacity,
                                   sizeof *made->indices)) {
        w->fine = false;
        return;
    }
    made->indices[made->index_count++] = a;
    made->indices[made->index_count++] = b;
    made->indices[made->index_count++] = c;
}

/* A prism: its triangle, the level of its bottom, and the solid corners. */
typedef struct {
    int triangle, level;
    bool solid[CORNERS];
} Cell;

static int edge_between(int a, int b)
{
    int found = 0;
    for (int e = 0; e < EDGES; e++)
        if ((edges[e][0] == a && edges[e][1] == b) || (edges[e][0] == b && edges[e][1] == a))
            found = e;
    return found;
}

static uint32_t vertex_of(const Walk *w, const Cell *cell, int corner)
{
    return w->layers->grid->indices[3 * (size_t)cell->triangle + (size_t)(corner % 3)];
}

static SceneNode crossing(const Walk *w, const Cell *cell, int edge)
{
    const int a = edges[edge][0], b = edges[edge][1];
    return (SceneNode){a % 3 == b % 3 ? SCENE_NODE_up : SCENE_NODE_along,
                       vertex_of(w, cell, a),
                       vertex_of(w, cell, b),
                       cell->level + (a >= 3),
                       cell->triangle,
                       -1};
}

static int corners_of(const int face[MAX_CORNERS])
{
    return face[MAX_CORNERS - 1] < 0 ? MAX_CORNERS - 1 : MAX_CORNERS;
}

/* Traces the border on each face, from the edge where a run is entered to the edge where it is
 * left: by edge, -1 for none. */
static void trace(const Cell *cell, int next[EDGES])
{
    for (int e = 0; e < EDGES; e++)
        next[e] = -1;
    for (int f = 0; f < FACES; f++) {
        const int *face = faces[f], count = corners_of(face);
        for (int i = 0; i < count; i++) {
            int last = i + 1;
            if (cell->solid[face[i]] || !cell->solid[face[last % count]])
                continue;
            while (cell->solid[face[(last + 1) % count]])
                last++;
            next[edge_between(face[i], face[(i + 1) % count])] =
                edge_between(face[last % count], face[(last + 1) % count]);
        }
    }
}

static void put_loops(Walk *w, const Cell *cell)
{
    int next[EDGES];
    trace(cell, next);
    for (int e = 0; e < EDGES; e++) {
        uint32_t loop[EDGES];
        int count = 0;
        for (int at = e; next[at] >= 0;) {
            const int to = next[at];
            loop[count++] = shared_node(w, crossing(w, cell, at));
            next[at] = -1;
            at = to;
        }
        for (int i = 2; i < count; i++)
            add_triangle(w, loop[0], loop[i - 1], loop[i]);
    }
}

/* Nodes of a wall are not shared, since they have the wall's normal. */
static uint32_t rim_crossing(Walk *w, const Cell *cell, int side, int from, int to)
{
    SceneNode node = crossing(w, cell, edge_between(from, to));
    node.rim = side;
    return add_node(w, node);
}

static uint32_t rim_corner(Walk *w, const Cell *cell, int side, int corner)
{
    const uint32_t a = vertex_of(w, cell, corner);
    return add_node(
        w, (SceneNode){SCENE_NODE_corner, a, a, cell->level + (corner >= 3), cell->triangle, side});
}

/* Puts the solid part of a side: each run from its entry to its exit; or the whole side. */
static void put_wall(Walk *w, const Cell *cell, int side)
{
    const int *face = faces[side];
    const bool *s = cell->solid;
    uint32_t ring[MAX_CORNERS + 2];
    for (int i = 0; i < MAX_CORNERS; i++) {
        int count = 0, at = i + 1;
        if (s[face[i]] || !s[face[at % MAX_CORNERS]])
            continue;
        ring[count++] = rim_crossing(w, cell, side, face[i], face[at % MAX_CORNERS]);
        for (; s[face[at % MAX_CORNERS]]; at++)
            ring[count++] = rim_corner(w, cell, side, face[at % MAX_CORNERS]);
        ring[count++] =
            rim_crossing(w, cell, side, face[(at - 1) % MAX_CORNERS], face[at % MAX_CORNERS]);
        for (int k = 2; k < count; k++)
            add_triangle(w, ring[0], ring[k - 1], ring[k]);
    }
    if (s[face[0]] && s[face[1]] && s[face[2]] && s[face[3]]) {
        for (int k = 0; k < MAX_CORNERS; k++)
            ring[k] = rim_corner(w, cell, side, face[k]);
        add_triangle(w, ring[0], ring[1], ring[2]);
        add_triangle(w, ring[0], ring[2], ring[3]);
    }
}

static void put_cell(Walk *w, const Cell *cell)
{
    int solid = 0;
    for (int i = 0; i < CORNERS; i++)
        solid += cell->solid[i];
    if (solid && solid < CORNERS)
        put_loops(w, cell);
    for (int side = 0; solid && side < SIDES; side++)
        if (w->rim[cell->triangle] >> side & 1)
            put_wall(w, cell, side);
}

static const SceneColumn *column_of(const Walk *w, int triangle, int corner)
{
    return &w->layers->columns
                [w->layers->place[w->layers->grid->indices[3 * (size_t)triangle + (size_t)corner]]];
}

static void put_stack(Walk *w, int triangle)
{
    const SceneLayers *layers = w->layers;
    const SceneColumn *columns[3];
    double low = INFINITY, high = -INFINITY;
    for (int k = 0; k < 3; k++) {
        columns[k] = column_of(w, triangle, k);
        for (int i = 0; i < 4; i += 2)
            if (columns[k]->heights[i] < columns[k]->heights[i + 1]) {
                low = fmin(low, columns[k]->heights[i]);
                high = fmax(high, columns[k]->heights[i + 1]);
            }
    }
    if (!(low < high) || columns[0] == columns[1] || columns[1] == columns[2] ||
        columns[2] == columns[0])
        return;
    const int first = (int)fmax(floor((low - layers->low) / layers->step) - 1, 0),
              last = (int)fmin(ceil((high - layers->low) / layers->step) + 1, layers->levels);
    for (int level = first; w->fine && level < last; level++) {
        Cell cell = {.triangle = triangle, .level = level};
        for (int i = 0; i < CORNERS; i++)
            cell.solid[i] =
                scene_column_solid(columns[i % 3], layers->low + (level + i / 3) * layers->step);
        put_cell(w, &cell);
    }
}

/* Finds boundary edges: an edge is one until a second triangle with it is found. The index holds
 * the first triangle's edge number. */
static void find_rims(Walk *w, int triangle)
{
    const SceneLayers *layers = w->layers;
    const uint32_t *index = &layers->grid->indices[3 * (size_t)triangle];
    for (int side = 0; side < SIDES; side++) {
        const uint32_t a = (uint32_t)layers->place[index[side]],
                       b = (uint32_t)layers->place[index[(side + 1) % 3]];
        const uint32_t low = a < b ? a : b, high = a < b ? b : a, hash = hash_of(low, high, 0);
        HashProbe probe = hash_probe(&w->rims, hash);
        bool alone = true;
        while (hash_probe_next(&probe)) {
            const uint32_t *other = &layers->grid->indices[probe.number / 3 * 3];
            const uint32_t c = (uint32_t)layers->place[other[probe.number % 3]],
                           d = (uint32_t)layers->place[other[(probe.number % 3 + 1) % 3]];
            if ((c == a && d == b) || (c == b && d == a)) {
                w->rim[probe.number / 3] &= (uint8_t) ~(1u << probe.number % 3);
                alone = false;
            }
        }
        if (!alone || a == b)
            continue;
        w->rim[triangle] |= (uint8_t)(1u << side);
        hash_index_add(NULL, &w->rims, hash, 3 * (uint32_t)triangle + (uint32_t)side);
    }
}

bool scene_volume_cells(const SceneLayers *layers, SceneCells *made)
{
    const int triangles = layers->grid->index_count / 3;
    Walk w = {.layers = layers, .made = made, .rim = calloc((size_t)triangles + 1, 1)};
    *made = (SceneCells){0};
    w.fine = w.rim != NULL;
    for (int t = 0; w.fine && t < triangles; t++)
        if (column_of(&w, t, 0) != column_of(&w, t, 1) &&
            column_of(&w, t, 1) != column_of(&w, t, 2) &&
            column_of(&w, t, 2) != column_of(&w, t, 0))
            find_rims(&w, t);
    for (int t = 0; w.fine && t < triangles; t++)
        put_stack(&w, t);
    hash_index_free(&w.nodes);
    hash_index_free(&w.rims);
    free(w.rim);
    if (!w.fine)
        scene_cells_free(made);
    return w.fine;
}

void scene_cells_free(SceneCells *cells)
{
    free(cells->nodes);
    free(cells->indices);
    *cells = (SceneCells){0};
}
