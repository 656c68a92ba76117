/* Finds edges by adjacency: each triangle adds its sides; a side that two triangles share is an
 * edge between them. */
#include "runtime/gpu_scene/edge_mesh.h"
#include "compiler/base/hash.h"
#include "compiler/base/hash_index.h"
#include "compiler/base/vec3.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Unit normals with a larger cosine are equal: 2.6 degrees. */
static const float alike = 0.999f;

typedef struct {
    const Shape *shape;
    HashIndex positions, sides;
    double scale; /* cells per unit of length */
    int *place;   /* indexed by vertex: the first vertex at the same position */
    /* indexed by edge: the two end vertices, as ordered in the edge's first face */
    uint32_t (*of)[2];
    uint8_t *faces; /* indexed by edge: number of faces */
    EdgeMesh *made;
} EdgeMaker;

/* Cells along the mesh's size. Vertices in the same cell are welded: the last vertices of a
 * closed surface may differ from the first by rounding. */
static const double cells = 1 << 18;

static const float *position(const EdgeMaker *m, int vertex)
{
    return m->shape->vertices[vertex].position;
}

static double greatest(const EdgeMaker *m)
{
    double most = 1e-30;
    for (int i = 0; i < 3 * m->shape->vertex_count; i++)
        most = fmax(most, fabs((double)position(m, i / 3)[i % 3]));
    return most;
}

static void cell_of(const EdgeMaker *m, int vertex, int32_t cell[3])
{
    for (int component = 0; component < 3; component++)
        cell[component] = (int32_t)lrint(position(m, vertex)[component] * m->scale);
}

static void find_places(EdgeMaker *m)
{
    m->scale = cells / greatest(m);
    for (int i = 0; i < m->shape->vertex_count; i++) {
        int32_t at[3], other[3];
        cell_of(m, i, at);
        const uint32_t hash = (uint32_t)key_of_bytes(at, sizeof at).low;
        HashProbe probe = hash_probe(&m->positions, hash);
        m->place[i] = i;
        while (m->place[i] == i && hash_probe_next(&probe)) {
            cell_of(m, (int)probe.number, other);
            if (!memcmp(at, other, sizeof at))
                m->place[i] = (int)probe.number;
        }
        if (m->place[i] == i)
            hash_index_add(NULL, &m->positions, hash, (uint32_t)i);
    }
}

/* Computes the unit normal; returns false if the face has no area. */
static bool face_normal(const EdgeMaker *m, const uint32_t *corner, float normal[3])
{
    double side[2][3], cross[3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 2; k++)
            side[k][i] =
                (double)position(m, (int)corner[k + 1])[i] - position(m, (int)corner[0])[i];
    vec3_cross(side[0], side[1], cross);
    const double length = vec3_length(cross);
    for (int i = 0; i < 3; i++)
        normal[i] = (float)(cross[i] / length);
    return length > 0;
}

static bool shade_jumps(const EdgeMaker *m, uint32_t a, uint32_t b)
{
    const float *x = m->shape->vertices[a].normal, *y = m->shape->vertices[b].normal;
    return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] < alike;
}

/* Returns the number of the edge between two positions; -1 if new. */
static int find_side(const EdgeMaker *m, const int ends[2], uint32_t hash)
{
    HashProbe probe = hash_probe(&m->sides, hash);
    while (hash_probe_next(&probe)) {
        const uint32_t *of = m->of[probe.number];
        if (m->place[of[0]] == ends[0] && m->place[of[1]] == ends[1])
            return (int)probe.number;
    }
    return -1;
}

/* A face and one of its sides: the face's normal, and the vertex opposite the side. */
typedef struct {
    const float *normal, *apex;
} EdgeFace;

static void set_face(const EdgeFace *face, int number, MeshEdge *edge)
{
    memcpy(edge->normals[number], face->normal, sizeof edge->normals[number]);
    memcpy(edge->apexes[number], face->apex, sizeof edge->apexes[number]);
}

static void meet(EdgeMaker *m, int number, const uint32_t vertices[2], const EdgeFace *face)
{
    MeshEdge *edge = &m->made->edges[number];
    set_face(face, 1, edge);
    edge->crease = shade_jumps(m, m->of[number][0], vertices[0]) &&
                   shade_jumps(m, m->of[number][1], vertices[1]);
    edge->open = m->faces[number] > 1;
    m->faces[number] = 2;
}

static void add_side(EdgeMaker *m, uint32_t a, uint32_t b, const EdgeFace *face)
{
    const bool ordered = m->place[a] < m->place[b];
    const uint32_t vertices[2] = {ordered ? a : b, ordered ? b : a};
    const int ends[2] = {m->place[vertices[0]], m->place[vertices[1]]};
    const uint32_t hash = (uint32_t)key_of_bytes(ends, sizeof ends).low;
    const int found = find_side(m, ends, hash);
    if (found >= 0) {
        meet(m, found, vertices, face);
        return;
    }
    const int number = m->made->count++;
    MeshEdge *edge = &m->made->edges[number];
    for (int k = 0; k < 2; k++) {
        memcpy(edge->ends[k], position(m, (int)vertices[k]), sizeof edge->ends[k]);
        set_face(face, k, edge);
    }
    edge->open = true; /* the edge is open until a second face shares it */
    memcpy(m->of[number], vertices, sizeof vertices);
    m->faces[number] = 1;
    hash_index_add(NULL, &m->sides, hash, (uint32_t)number);
}

static void add_sides(EdgeMaker *m)
{
    for (int i = 0; i + 2 < m->shape->index_count; i += 3) {
        const uint32_t *corner = m->shape->indices + i;
        float normal[3];
        for (int k = 0; face_normal(m, corner, normal) && k < 3; k++)
            add_side(m, corner[k], corner[(k + 1) % 3],
                     &(EdgeFace){normal, position(m, (int)corner[(k + 2) % 3])});
    }
}

/* Computes the bounding box, and by the sign of the volume whether front faces are outside. Six
 * times the volume is the sum over triangles of their determinants with the origin. */
static void set_extent(EdgeMaker *m)
{
    EdgeMesh *made = m->made;
    double volume = 0;
    for (int i = 0; i < 3; i++)
        made->low[i] = INFINITY, made->high[i] = -INFINITY;
    for (int i = 0; i < 3 * m->shape->vertex_count; i++) {
        made->low[i % 3] = fmin(made->low[i % 3], (double)position(m, i / 3)[i % 3]);
        made->high[i % 3] = fmax(made->high[i % 3], (double)position(m, i / 3)[i % 3]);
    }
    for (int i = 0; i + 2 < m->shape->index_count; i += 3) {
        const float *a = position(m, (int)m->shape->indices[i]),
                    *b = position(m, (int)m->shape->indices[i + 1]),
                    *c = position(m, (int)m->shape->indices[i + 2]);
        for (int k = 0; k < 3; k++)
            volume += (double)a[k] * ((double)b[(k + 1) % 3] * (double)c[(k + 2) % 3] -
                                      (double)b[(k + 2) % 3] * (double)c[(k + 1) % 3]);
    }
    made->solid = volume > 0 && shape_body(m->shape) != SHAPE_BODY_none;
}

bool edge_mesh_make(const Shape *shape, EdgeMesh *made)
{
    const size_t vertices = (size_t)shape->vertex_count + 1, sides = (size_t)shape->index_count + 1;
    *made = (EdgeMesh){.edges = calloc(sides, sizeof *made->edges)};
    EdgeMaker m = {.shape = shape,
                   .place = calloc(vertices, sizeof *m.place),
                   .of = calloc(sides, sizeof *m.of),
                   .faces = calloc(sides, 1),
                   .made = made};
    const bool done = made->edges && m.place && m.of && m.faces;
    if (done) {
        find_places(&m);
        add_sides(&m);
        set_extent(&m);
    } else
        edge_mesh_free(made);
    hash_index_free(&m.positions);
    hash_index_free(&m.sides);
    free(m.place);
    free(m.of);
    free(m.faces);
    return done;
}

void edge_mesh_free(EdgeMesh *mesh)
{
    free(mesh->edges);
    *mesh = (EdgeMesh){0};
}
