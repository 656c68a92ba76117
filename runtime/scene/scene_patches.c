/* Rows by which the points of patches are displaced. Inside a patch the rows of its corners are
 * interpolated; on a hard edge, the sums of both sides' normals, interpolated between its ends;
 * along a seam, the rows of the first patch; at a corner, the same row for all patches around
 * it.
 *
 *     Two faces of a box: their edge moves along the sum of their normals, adjacent points along
 *         their own face's normal. */
#include "runtime/scene/scene_patches.h"
#include "compiler/base/hash_index.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/scene/scene_places.h"
#include "runtime/scene/scene_seen.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* An edge, identified by the position indices of its ends, smaller first. */
typedef struct {
    int place[2];
    uint32_t owner[2]; /* end vertices of the edge in its first patch */
    /* rows of the ends: the owner vertices, or, if normals differ, rows with the summed normals */
    uint32_t row[2];
} Edge;

typedef struct {
    const Shape *shape;
    const int *first; /* indexed by vertex: the first vertex at its position */
    ScenePatches *made;
    Edge *edges;
    int edge_count;
    HashIndex index;
} Maker;

static bool differ(const ShapeVertex *a, const ShapeVertex *b)
{
    return memcmp(a->normal, b->normal, sizeof a->normal) != 0;
}

static void add_normal(const ShapeVertex *from, ShapeVertex *to)
{
    for (int i = 0; i < 3; i++)
        to->normal[i] += from->normal[i];
}

static uint32_t copy_row(ScenePatches *made, uint32_t row)
{
    made->rows[made->row_count] = made->rows[row];
    return (uint32_t)made->row_count++;
}

static Edge *edge_of(Maker *m, const uint32_t ends[2])
{
    const int places[2] = {m->first[ends[0]], m->first[ends[1]]};
    const uint32_t hash = ((uint32_t)places[0] * 0x9E3779B1u ^ (uint32_t)places[1]) * 0x85EBCA77u;
    HashProbe probe = hash_probe(&m->index, hash);
    while (hash_probe_next(&probe))
        if (!memcmp(m->edges[probe.number].place, places, sizeof places))
            return &m->edges[probe.number];
    hash_index_add(NULL, &m->index, hash, (uint32_t)m->edge_count);
    Edge *edge = &m->edges[m->edge_count++];
    *edge = (Edge){{places[0], places[1]}, {ends[0], ends[1]}, {ends[0], ends[1]}};
    return edge;
}

bool scene_patch_ends(const ScenePatch *patch, const int *first, int k, uint32_t ends[2])
{
    const uint32_t a = patch->own[(k + 1) % 3], b = patch->own[(k + 2) % 3];
    const bool turned = first[b] < first[a];
    ends[0] = turned ? b : a;
    ends[1] = turned ? a : b;
    return turned;
}

/* Adds the normals of another patch to an edge. */
static void join(Maker *m, Edge *edge, const uint32_t ends[2])
{
    ShapeVertex *rows = m->made->rows;
    const Edge was = *edge;
    if (!differ(&rows[ends[0]], &rows[was.owner[0]]) &&
        !differ(&rows[ends[1]], &rows[was.owner[1]]))
        return;
    for (int i = 0; i < 2; i++) {
        if (was.row[i] == was.owner[i])
            edge->row[i] = copy_row(m->made, was.owner[i]);
        add_normal(&rows[ends[i]], &rows[edge->row[i]]);
    }
}

/* Lists all triangles except degenerate ones with two corners at one position, at a pole: their
 * points lie on an edge that adjacent triangles share. */
static void find_patches(Maker *m)
{
    for (int i = 0; i + 2 < m->shape->index_count; i += 3) {
        const uint32_t *index = &m->shape->indices[i];
        const int places[3] = {m->first[index[0]], m->first[index[1]], m->first[index[2]]};
        if (places[0] != places[1] && places[1] != places[2] && places[2] != places[0])
            memcpy(m->made->at[m->made->count++].own, index, sizeof m->made->at->own);
    }
}

static void find_edges(Maker *m)
{
    for (int t = 0; t < m->made->count; t++)
        for (int k = 0; k < 3; k++) {
            uint32_t ends[2];
            scene_patch_ends(&m->made->at[t], m->first, k, ends);
            join(m, edge_of(m, ends), ends);
        }
    for (int t = 0; t < m->made->count; t++)
        for (int k = 0; k < 3; k++) {
            uint32_t ends[2];
            const bool turned = scene_patch_ends(&m->made->at[t], m->first, k, ends);
            const Edge *edge = edge_of(m, ends);
            for (int i = 0; i < 2; i++)
                m->made->at[t].edge[k][i] = edge->row[turned ? 1 - i : i];
        }
}

/* Finds the rows of all corners. False if memory runs out. */
static bool find_corners(Maker *m)
{
    const int count = m->shape->vertex_count;
    uint32_t *row = calloc((size_t)count + 1, sizeof *row);
    for (int i = 0; row && i < count; i++) {
        const int first = m->first[i];
        if (first == i)
            row[i] = (uint32_t)i;
        if (first == i || !differ(&m->made->rows[i], &m->made->rows[first]))
            continue;
        if (row[first] == (uint32_t)first)
            row[first] = copy_row(m->made, (uint32_t)first);
        add_normal(&m->made->rows[i], &m->made->rows[row[first]]);
    }
    for (int t = 0; row && t < m->made->count; t++)
        for (int k = 0; k < 3; k++)
            m->made->at[t].corner[k] = row[m->first[m->made->at[t].own[k]]];
    free(row);
    return row != NULL;
}

bool scene_patches_make(const Shape *shape, ScenePatches *made)
{
    const size_t triangles = (size_t)shape->index_count / 3, vertices = (size_t)shape->vertex_count;
    int *first = scene_places(shape);
    Maker m = {.shape = shape,
               .first = first,
               .made = made,
               .edges = calloc(3 * triangles + 1, sizeof *m.edges)};
    *made = (ScenePatches){.rows = calloc(2 * vertices + 6 * triangles + 1, sizeof *made->rows),
                           .at = calloc(triangles + 1, sizeof *made->at),
                           .row_count = shape->vertex_count};
    bool fine = first && m.edges && made->rows && made->at;
    if (fine) {
        memcpy(made->rows, shape->vertices, vertices * sizeof *made->rows);
        find_patches(&m);
        find_edges(&m);
        fine = find_corners(&m);
    }
    hash_index_free(&m.index);
    free(m.edges);
    free(first);
    if (!fine)
        scene_patches_free(made);
    return fine;
}

void scene_patches_free(ScenePatches *patches)
{
    free(patches->rows);
    free(patches->at);
    *patches = (ScenePatches){0};
}

void scene_mesh_free(SceneMesh *mesh)
{
    shape_free(&mesh->shape);
    if (mesh->patches)
        scene_patches_free(mesh->patches);
    free(mesh->patches);
    *mesh = (SceneMesh){.path = "", .part = -1};
}

static void to_world(const ScenePatches *patches, const float local[3], double world[3])
{
    const double *m = patches->world_from_local.m;
    for (int i = 0; i < 3; i++)
        world[i] = m[i] * (double)local[0] + m[4 + i] * (double)local[1] +
                   m[8 + i] * (double)local[2] + m[12 + i];
}

/* Returns the parts of an edge; symmetric in its ends, so that both triangles get the same
 * number. */
static uint8_t parts_of(const ScenePatches *patches, const SceneViewSet *seen,
                        const float *const ends[2])
{
    double world[2][3], middle[3], way[3];
    for (int i = 0; i < 2; i++)
        to_world(patches, ends[i], world[i]);
    for (int i = 0; i < 3; i++) {
        middle[i] = (world[0][i] + world[1][i]) / 2;
        way[i] = world[1][i] - world[0][i];
    }
    const double wanted =
        sqrt(vec3_dot(way, way)) * scene_seen_pixels(seen, middle) / patches->pixels;
    int parts = 1;
    while (2 * parts <= patches->level && parts < wanted)
        parts *= 2;
    return (uint8_t)parts;
}

/* Surfaces rounded by push and bulge, or the symbols of points, may exceed `bound`. */
bool scene_patches_hide(const ScenePatches *patches)
{
    return patches->pixels > 0 && patches->dividing.push == 0 && patches->dividing.bulge == 0 &&
           patches->method != KEYWORD_Displacing_points;
}

static bool is_hidden(const ScenePatches *patches, const ScenePatch *patch, const double eye[3],
                      const SceneFrustums *sight)
{
    double corners[3][3];
    for (int k = 0; k < 3; k++)
        to_world(patches, patches->rows[patch->own[k]].position, corners[k]);
    return scene_sight_misses(sight, eye, (const double(*)[3])corners, patches->bound);
}

static int larger(int a, int b) { return a > b ? a : b; }

int scene_patch_parts(const uint8_t parts[3])
{
    return larger(larger(parts[0], parts[1]), parts[2]);
}

/* Returns the number of triangles if no edge has more than `most` parts. */
static int64_t triangles_of(const ScenePatches *patches, uint8_t (*parts)[3], int most)
{
    int64_t sum = 0;
    for (int t = 0; t < patches->count; t++) {
        const int n = scene_patch_parts(parts[t]);
        sum += (int64_t)(n < most ? n : most) * (n < most ? n : most);
    }
    return sum;
}

static void bound_parts(const ScenePatches *patches, uint8_t (*parts)[3])
{
    int most = SCENE_PATCH_PARTS;
    while (most > 1 && triangles_of(patches, parts, most) > patches->triangles)
        most /= 2;
    for (int i = 0; i < 3 * patches->count; i++)
        parts[i / 3][i % 3] = (uint8_t)(parts[i / 3][i % 3] < most ? parts[i / 3][i % 3] : most);
}

void scene_patches_levels(const ScenePatches *patches, const SceneCamera *camera, const int size[2],
                          const SceneFrustums *sight, uint8_t (*parts)[3])
{
    SceneViewSet seen = {.count = 1, .shorter = size[0] < size[1] ? size[0] : size[1]};
    for (int i = 0; i < 2; i++)
        seen.half[i] = size[i] / seen.shorter;
    seen.cameras[0] = *camera;
    for (int t = 0; t < patches->count; t++)
        for (int k = 0; k < 3; k++) {
            const uint32_t *own = patches->at[t].own;
            const float *const ends[2] = {patches->rows[own[(k + 1) % 3]].position,
                                          patches->rows[own[(k + 2) % 3]].position};
            parts[t][k] =
                patches->pixels > 0 ? parts_of(patches, &seen, ends) : (uint8_t)patches->level;
        }
    for (int t = 0; sight && scene_patches_hide(patches) && t < patches->count; t++)
        if (is_hidden(patches, &patches->at[t], camera->position, sight))
            memset(parts[t], 0, sizeof parts[t]);
    if (patches->pixels > 0)
        bound_parts(patches, parts);
    for (int t = 0; patches->apart && t < patches->count; t++)
        memset(parts[t], scene_patch_parts(parts[t]), sizeof parts[t]);
}
