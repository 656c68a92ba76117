/* Converts triangles of a mesh to bases of bisection: the edge that is bisected first,
 * adjacency, and positions in world space.
 *
 * The longest edge is first, among equally long ones that of the earlier places, as in
 * scene_bisection.c. So a triangle only waits for a larger neighbor, and there are no cycles of
 * waiting. */
#include "gen/bisection_layout.h"
#include "compiler/base/hash_index.h"
#include "runtime/displace/bisection/displaced_bisection.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/scene/scene_places.h"
#include <stdlib.h>
#include <string.h>

/* An edge by the places of its ends, the earlier first; and the number of bases that share it. */
typedef struct {
    int place[2];
    uint32_t count;
} Edge;

typedef struct {
    const ScenePatches *patches;
    SceneMatrix local_from_world;
    const int *first; /* indexed by row: the first row at the same position */
    Edge *edges;
    uint32_t edge_count;
    HashIndex index;
    /* bases, starts of edges, members; next free position of each edge's members */
    uint32_t *words, *starts;
    uint32_t base_words;
} Maker;

static double square_length(const ScenePatches *patches, const uint32_t ends[2])
{
    double sum = 0;
    for (int i = 0; i < 3; i++) {
        const double way =
            (double)patches->rows[ends[0]].position[i] - (double)patches->rows[ends[1]].position[i];
        sum += way * way;
    }
    return sum;
}

static bool is_longer(const Maker *m, const uint32_t x[2], const uint32_t y[2])
{
    const double by_x = square_length(m->patches, x), by_y = square_length(m->patches, y);
    if (by_x != by_y)
        return by_x > by_y;
    return m->first[x[0]] != m->first[y[0]] ? m->first[x[0]] < m->first[y[0]]
                                            : m->first[x[1]] < m->first[y[1]];
}

/* Returns the corner at which the longest edge begins. */
static uint32_t first_corner(const Maker *m, int patch)
{
    const ScenePatch *at = &m->patches->at[patch];
    int first = 0;
    uint32_t best[2], next[2];
    scene_patch_ends(at, m->first, 2, best); /* the edge between corners 0 and 1 */
    for (int corner = 1; corner < 3; corner++) {
        scene_patch_ends(at, m->first, (corner + 2) % 3, next);
        if (is_longer(m, next, best)) {
            first = corner;
            memcpy(best, next, sizeof best);
        }
    }
    return (uint32_t)first;
}

static uint32_t edge_of(Maker *m, const uint32_t ends[2])
{
    const int place[2] = {m->first[ends[0]], m->first[ends[1]]};
    const uint32_t hash = ((uint32_t)place[0] * 0x9E3779B1u ^ (uint32_t)place[1]) * 0x85EBCA77u;
    HashProbe probe = hash_probe(&m->index, hash);
    while (hash_probe_next(&probe))
        if (!memcmp(m->edges[probe.number].place, place, sizeof place))
            return probe.number;
    hash_index_add(NULL, &m->index, hash, m->edge_count);
    m->edges[m->edge_count] = (Edge){{place[0], place[1]}, 0};
    return m->edge_count++;
}

static void put_float(double value, uint32_t *word)
{
    const float narrow = (float)value;
    memcpy(word, &narrow, sizeof narrow);
}

static void put_base(Maker *m, int patch, uint32_t *words)
{
    const double *world = m->patches->world_from_local.m, *local = m->local_from_world.m;
    words[0] = first_corner(m, patch);
    for (int k = 0; k < 3; k++) {
        uint32_t ends[2];
        words[0] |= (uint32_t)scene_patch_ends(&m->patches->at[patch], m->first, k, ends)
                    << (2 + k);
        words[1 + k] = edge_of(m, ends);
        m->edges[words[1 + k]].count++;
        const ShapeVertex *row = &m->patches->rows[m->patches->at[patch].own[k]];
        for (int i = 0; i < 3; i++) {
            double at = world[12 + i], normal = 0;
            for (int component = 0; component < 3; component++) {
                at += world[4 * component + i] * (double)row->position[component];
                normal += local[4 * i + component] * (double)row->normal[component];
            }
            put_float(at, &words[4 + 3 * k + i]);
            put_float(normal, &words[13 + 3 * k + i]);
        }
    }
}

/* Stores the beginnings of the edges' members, followed by the members. Edge numbers in bases
 * become offsets of the words with these beginnings. */
static void put_edges(Maker *m)
{
    uint32_t at = m->base_words + m->edge_count + 1;
    for (uint32_t edge = 0; edge < m->edge_count; edge++) {
        m->starts[edge] = m->words[m->base_words + edge] = at;
        at += m->edges[edge].count;
    }
    m->words[m->base_words + m->edge_count] = at;
    for (int patch = 0; patch < m->patches->count; patch++)
        for (int k = 0; k < 3; k++) {
            uint32_t *word = &m->words[(size_t)patch * BISECTION_BASE + 1 + (size_t)k];
            m->words[m->starts[*word]++] = 4 * (uint32_t)patch + (uint32_t)k;
            *word += m->base_words;
        }
}

uint32_t *displaced_bisection_bases(const ScenePatches *patches, size_t *count)
{
    const size_t bases = (size_t)patches->count;
    const Shape shape = {.vertices = patches->rows, .vertex_count = patches->row_count};
    int *first = scene_places(&shape);
    Maker m = {.patches = patches,
               .first = first,
               .edges = calloc(3 * bases + 1, sizeof *m.edges),
               .starts = calloc(3 * bases + 1, sizeof *m.starts),
               .words = calloc(bases * (BISECTION_BASE + 6) + 1, sizeof *m.words),
               .base_words = (uint32_t)(bases * BISECTION_BASE)};
    const bool fine = first && m.edges && m.starts && m.words &&
                      scene_matrix_invert(&patches->world_from_local, &m.local_from_world);
    for (int i = 0; fine && i < patches->count; i++)
        put_base(&m, i, &m.words[(size_t)i * BISECTION_BASE]);
    if (fine)
        put_edges(&m);
    *count = m.base_words + m.edge_count + 1 + 3 * bases;
    hash_index_free(&m.index);
    free(m.edges);
    free(m.starts);
    free(first);
    if (!fine)
        free(m.words);
    return fine ? m.words : NULL;
}
