/* Triangles of a primitive at a place of the scene. */
#include "compiler/base/memory.h"
#include "runtime/gl/message.h"
#include "runtime/mesh_import/gltf_primitive.h"
#include "runtime/mesh_import/model_join.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { FIRST_CAPACITY = 1024 };

/* A transform with the matrix for normals: the inverse transpose of its linear part, times the
 * determinant's absolute value. */
typedef struct {
    GltfTransform at;
    double normal[3][3];
    bool mirrored; /* negative determinant */
} Placement;

static Placement placement_of(const GltfTransform *at)
{
    Placement made = {.at = *at};
    const double(*m)[4] = at->m;
    double determinant = 0;
    for (int r = 0; r < 3; r++)
        for (int c = 0; c < 3; c++) {
            const int r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
            made.normal[r][c] = m[r1][c1] * m[r2][c2] - m[r1][c2] * m[r2][c1];
        }
    for (int c = 0; c < 3; c++)
        determinant += m[0][c] * made.normal[0][c];
    made.mirrored = determinant < 0;
    for (int i = 0; made.mirrored && i < 9; i++)
        made.normal[i / 3][i % 3] = -made.normal[i / 3][i % 3];
    return made;
}

/* Converts to float within its range. Positions out of range are errors later. Adding 0 turns -0
 * into 0, since vertices are compared by their bytes. */
static float to_float(double value) { return (float)fmin(fmax(value, -1e30), 1e30) + 0.f; }

static void turn(const double m[3][4], const float v[3], float to[3])
{
    for (int r = 0; r < 3; r++)
        to[r] = to_float(m[r][0] * (double)v[0] + m[r][1] * (double)v[1] + m[r][2] * (double)v[2]);
}

/* Both tangents are turned as directions on the surface: a mirrored node mirrors their frame. */
static void put_tangents(const GltfPrimitive *p, size_t i, const Placement *at, ShapeVertex *to)
{
    const float *n = p->normals[i], *t = p->tangents[i], side = t[3] < 0 ? -1 : 1;
    float v[3];
    for (int k = 0; k < 3; k++) {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        v[k] = side * (n[a] * t[b] - n[b] * t[a]);
    }
    turn(at->at.m, t, to->tangentU);
    turn(at->at.m, v, to->tangentV);
}

static void put_vertex(const GltfPrimitive *p, size_t i, const Placement *at, ShapeVertex *to)
{
    const float *n = p->normals ? p->normals[i] : NULL;
    *to = (ShapeVertex){0};
    turn(at->at.m, p->positions[i], to->position);
    for (int r = 0; r < 3; r++)
        to->position[r] = to_float((double)to->position[r] + at->at.m[r][3]);
    for (int r = 0; n && r < 3; r++)
        to->normal[r] = to_float(at->normal[r][0] * (double)n[0] + at->normal[r][1] * (double)n[1] +
                                 at->normal[r][2] * (double)n[2]);
    if (p->uv)
        to->uv[0] = p->uv[i][0] + 0.f, to->uv[1] = p->uv[i][1] + 0.f;
    if (p->tangents)
        put_tangents(p, i, at, to);
}

/* Writes the extras of a vertex; those of primitives without them are white, or 0. */
static void put_extras(const GltfPrimitive *p, size_t i, Shape *shape, int vertex)
{
    static const float missing[2][4] = {{0, 0, 0, 0}, {1, 1, 1, 1}};
    for (int k = 0; k < SHAPE_EXTRAS; k++) {
        if (!shape->extra[k])
            continue;
        float *to = shape->extra[k][vertex];
        memcpy(to, p->extra[k] ? p->extra[k][i] : missing[k == SHAPE_EXTRA_color],
               sizeof *shape->extra[k]);
        for (int c = 0; c < 4; c++)
            to[c] = isfinite(to[c]) ? to[c] + 0.f : 0;
    }
}

/* -- growing arrays */

static int capacity_for(int capacity, size_t wanted)
{
    size_t made = capacity ? (size_t)capacity : FIRST_CAPACITY;
    while (made < wanted)
        made *= 2;
    return (int)made;
}

static void *grown(void *array, size_t count, size_t size)
{
    return memory_checked(realloc(array, count * size));
}

/* Allocates the extras that this primitive is the first to have. */
static void add_extras(GltfMesh *mesh, const GltfPrimitive *p)
{
    Shape *shape = &mesh->parts->shape;
    for (int k = 0; k < SHAPE_EXTRAS; k++) {
        if (!p->extra[k] || shape->extra[k])
            continue;
        shape->extra[k] =
            memory_checked(calloc((size_t)mesh->vertex_capacity, sizeof *shape->extra[k]));
        for (int i = 0; k == SHAPE_EXTRA_color && i < 4 * shape->vertex_count; i++)
            shape->extra[k][i / 4][i % 4] = 1;
    }
}

static bool reserve(GltfMesh *mesh, size_t vertices, size_t indices)
{
    ModelParts *parts = mesh->parts;
    Shape *shape = &parts->shape;
    vertices += (size_t)shape->vertex_count;
    indices += (size_t)shape->index_count;
    if (vertices > MODEL_VERTICES || indices > MODEL_INDICES || parts->run_count >= MODEL_RUNS)
        return message_fail(mesh->error, mesh->capacity,
                            "it has more than %d vertices or %d triangles, the most that are drawn",
                            MODEL_VERTICES, MODEL_INDICES / 3);
    mesh->run_capacity = capacity_for(mesh->run_capacity, (size_t)parts->run_count + 1);
    parts->runs = grown(parts->runs, (size_t)mesh->run_capacity, sizeof *parts->runs);
    mesh->index_capacity = capacity_for(mesh->index_capacity, indices);
    shape->indices = grown(shape->indices, (size_t)mesh->index_capacity, sizeof *shape->indices);
    if (vertices < (size_t)mesh->vertex_capacity) /* one more, for the candidate that is welded */
        return true;
    mesh->vertex_capacity = capacity_for(mesh->vertex_capacity, vertices + 1);
    shape->vertices =
        grown(shape->vertices, (size_t)mesh->vertex_capacity, sizeof *shape->vertices);
    return shape_grow_extras(shape, mesh->vertex_capacity) ||
           message_fail(mesh->error, mesh->capacity, "out of memory");
}

/* -- runs */

static Placement place_of(const GltfPrimitive *p, size_t vertex, const Placement *node)
{
    return p->skin ? placement_of(&p->skin[vertex]) : *node;
}

/* Gives the corners of a triangle its unit normal; 0 without an area. */
static void put_flat_normal(ShapeVertex corner[3])
{
    double a[3], b[3], n[3];
    for (int k = 0; k < 3; k++) {
        a[k] = (double)corner[1].position[k] - (double)corner[0].position[k];
        b[k] = (double)corner[2].position[k] - (double)corner[0].position[k];
    }
    for (int k = 0; k < 3; k++)
        n[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    for (int k = 0; k < 9 && length > 0; k++)
        corner[k / 3].normal[k % 3] = to_float(n[k % 3] / length);
}

/* Writes every corner with the normal of its triangle, and welds those that are equal. The indices
 * have their final order already. */
static bool emit_flat(Shape *shape, const GltfPrimitive *p, const Placement *node)
{
    ModelJoin join;
    uint32_t *indices = shape->indices + shape->index_count;
    bool joined = model_join_open(&join, shape, (unsigned)p->index_count);
    for (size_t i = 0; joined && i < p->index_count; i += 3) {
        ShapeVertex corner[3];
        for (size_t k = 0; k < 3; k++) {
            const Placement at = place_of(p, indices[i + k], node);
            put_vertex(p, indices[i + k], &at, &corner[k]);
        }
        put_flat_normal(corner);
        for (size_t k = 0; joined && k < 3; k++) {
            shape->vertices[shape->vertex_count] = corner[k];
            put_extras(p, indices[i + k], shape, shape->vertex_count);
            joined = model_join_add(&join, (unsigned)(i + k));
        }
    }
    for (size_t i = 0; joined && i < p->index_count; i++)
        indices[i] = join.joined[i];
    model_join_close(&join);
    return joined;
}

/* Writes each vertex once. */
static void emit_shared(Shape *shape, const GltfPrimitive *p, const Placement *node)
{
    const uint32_t first = (uint32_t)shape->vertex_count;
    for (size_t i = 0; i < p->rows.count; i++, shape->vertex_count++) {
        const Placement at = place_of(p, i, node);
        put_vertex(p, i, &at, &shape->vertices[shape->vertex_count]);
        put_extras(p, i, shape, shape->vertex_count);
    }
    for (size_t i = 0; i < p->index_count; i++)
        shape->indices[(size_t)shape->index_count + i] += first;
}

/* Writes vertices of which no triangles share one, and welds those that are equal. */
static bool emit_welded(Shape *shape, const GltfPrimitive *p, const Placement *node)
{
    ModelJoin join;
    bool joined = model_join_open(&join, shape, (unsigned)p->rows.count);
    for (size_t i = 0; joined && i < p->rows.count; i++) {
        const Placement at = place_of(p, i, node);
        put_vertex(p, i, &at, &shape->vertices[shape->vertex_count]);
        put_extras(p, i, shape, shape->vertex_count);
        joined = model_join_add(&join, (unsigned)i);
    }
    uint32_t *indices = shape->indices + shape->index_count;
    for (size_t i = 0; joined && i < p->index_count; i++)
        indices[i] = join.joined[indices[i]];
    model_join_close(&join);
    return joined;
}

/* Copies the indices of vertices. A mirrored transform turns triangles around, so that their front
 * faces stay in front. */
static void put_indices(const GltfPrimitive *p, bool mirrored, uint32_t *to)
{
    memcpy(to, p->indices, p->index_count * sizeof *to);
    for (size_t i = 0; mirrored && i < p->index_count; i += 3) {
        to[i + 1] = p->indices[i + 2];
        to[i + 2] = p->indices[i + 1];
    }
}

bool gltf_emit(GltfMesh *mesh, const GltfPrimitive *p, const GltfTransform *world)
{
    Shape *shape = &mesh->parts->shape;
    const Placement node = placement_of(p->skin ? &p->skin[0] : world);
    const int before = shape->vertex_count;
    bool done = true;
    if (!reserve(mesh, p->normals ? p->rows.count : p->index_count, p->index_count))
        return false;
    add_extras(mesh, p);
    put_indices(p, node.mirrored, shape->indices + shape->index_count);
    if (!p->normals)
        done = emit_flat(shape, p, &node);
    else if (p->rows.count == p->index_count)
        done = emit_welded(shape, p, &node);
    else
        emit_shared(shape, p, &node);
    shape->index_count += (int)p->index_count;
    mesh->parts->runs[mesh->parts->run_count++] =
        (ModelRun){.material = p->material,
                   .index_count = (int)p->index_count,
                   .vertex_count = shape->vertex_count - before,
                   .has_normals = true,
                   .has_coordinates = p->uv != NULL,
                   .has_tangents = p->tangents != NULL};
    return done || message_fail(mesh->error, mesh->capacity, "out of memory");
}
