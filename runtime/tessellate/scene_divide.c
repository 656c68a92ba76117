/* Subdivides triangles of a shape evenly. Two triangles that share an edge make the same points
 * on it, whichever their direction: an edge is always interpolated from the end with the lesser
 * coordinates.
 *
 *     n = 2: corners a, b, c, and ab, ca, bc between them: a ab ca, ab b bc, ca bc c, ab bc ca */
#include "compiler/base/hash.h"
#include "runtime/tessellate/scene_divide.h"
#include "compiler/base/hash_index.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static bool comes_first(const float a[3], const float b[3])
{
    for (int i = 0; i < 3; i++)
        if (a[i] != b[i])
            return a[i] < b[i];
    return false;
}

/* Interpolates three values by integer weights that add up to n, in the order of the corners'
 * coordinates. */
static float mixed(const float *const v[3], const int weight[3], int component, int n)
{
    double sum = 0;
    for (int k = 0; k < 3; k++)
        sum += (double)weight[k] * (double)v[k][component];
    return (float)(sum / n);
}

static void mix_components(const float *const v[3], const int weight[3], int n, int components,
                           float *to)
{
    for (int component = 0; component < components; component++)
        to[component] = mixed(v, weight, component, n);
}

static void unit(float v[3])
{
    const double size = sqrt((double)v[0] * v[0] + (double)v[1] * v[1] + (double)v[2] * v[2]);
    for (int i = 0; i < 3 && size > 0; i++)
        v[i] = (float)(v[i] / size);
}

/* Returns the vertex with these barycentric weights. */
static ShapeVertex between(const ShapeVertex *const corner[3], const int weight[3], int n)
{
    int order[3] = {0, 1, 2}, sorted[3];
    const ShapeVertex *at[3];
    ShapeVertex made;
    for (int i = 0; i < 3; i++)
        if (weight[i] == n)
            return *corner[i];
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 2 - i; k++)
            if (comes_first(corner[order[k + 1]]->position, corner[order[k]]->position)) {
                const int other = order[k];
                order[k] = order[k + 1];
                order[k + 1] = other;
            }
    for (int i = 0; i < 3; i++) {
        at[i] = corner[order[i]];
        sorted[i] = weight[order[i]];
    }
    mix_components((const float *const[]){at[0]->position, at[1]->position, at[2]->position},
                   sorted, n, 3, made.position);
    mix_components((const float *const[]){at[0]->normal, at[1]->normal, at[2]->normal}, sorted, n,
                   3, made.normal);
    mix_components((const float *const[]){at[0]->uv, at[1]->uv, at[2]->uv}, sorted, n, 2, made.uv);
    mix_components((const float *const[]){at[0]->tangentU, at[1]->tangentU, at[2]->tangentU},
                   sorted, n, 3, made.tangentU);
    mix_components((const float *const[]){at[0]->tangentV, at[1]->tangentV, at[2]->tangentV},
                   sorted, n, 3, made.tangentV);
    unit(made.normal);
    return made;
}

/* Distinct vertices found so far. */
typedef struct {
    Shape *shape;
    HashIndex index;
} Found;

static uint32_t number_of(Found *f, const ShapeVertex *vertex)
{
    const uint32_t hash = (uint32_t)key_of_bytes(vertex, sizeof *vertex).low;
    HashProbe probe = hash_probe(&f->index, hash);
    while (hash_probe_next(&probe))
        if (!memcmp(&f->shape->vertices[probe.number], vertex, sizeof *vertex))
            return probe.number;
    f->shape->vertices[f->shape->vertex_count] = *vertex;
    hash_index_add(NULL, &f->index, hash, (uint32_t)f->shape->vertex_count);
    return (uint32_t)f->shape->vertex_count++;
}

/* Returns the index of vertex i in a row of a triangle. Row i has i + 1 vertices, starting at
 * corner 0. */
static int place_in_rows(int row, int i) { return row * (row + 1) / 2 + i; }

uint32_t *scene_divide_rows(const uint32_t *rows, int n, uint32_t *next)
{
    for (int row = 0; row < n; row++)
        for (int i = 0; i <= row; i++) {
            const uint32_t top = rows[place_in_rows(row, i)],
                           left = rows[place_in_rows(row + 1, i)],
                           right = rows[place_in_rows(row + 1, i + 1)];
            *next++ = top, *next++ = left, *next++ = right;
            if (i == row)
                continue;
            *next++ = top, *next++ = right, *next++ = rows[place_in_rows(row, i + 1)];
        }
    return next;
}

ShapeVertex scene_divide_point(const Shape *shape, int triangle, const int weights[3], int n)
{
    const uint32_t *index = &shape->indices[3 * (size_t)triangle];
    const ShapeVertex *corner[3];
    for (int k = 0; k < 3; k++)
        corner[k] = &shape->vertices[index[k]];
    return between(corner, weights, n);
}

bool scene_divide(const Shape *shape, int n, Shape *made)
{
    const size_t triangles = (size_t)shape->index_count / 3,
                 each = (size_t)(n + 1) * (size_t)(n + 2) / 2;
    Found found = {.shape = made};
    uint32_t *rows = calloc(each, sizeof *rows);
    *made = (Shape){.vertices = calloc(triangles * each + 1, sizeof *made->vertices),
                    .indices =
                        calloc(3 * triangles * (size_t)n * (size_t)n + 1, sizeof *made->indices)};
    uint32_t *next = made->indices;
    const bool fine = rows && made->vertices && made->indices;
    for (size_t t = 0; fine && t < triangles; t++) {
        const ShapeVertex *corner[3];
        for (int k = 0; k < 3; k++)
            corner[k] = &shape->vertices[shape->indices[3 * t + (size_t)k]];
        for (int row = 0; row <= n; row++)
            for (int i = 0; i <= row; i++) {
                const ShapeVertex vertex = between(corner, (int[]){n - row, row - i, i}, n);
                rows[place_in_rows(row, i)] = number_of(&found, &vertex);
            }
        next = scene_divide_rows(rows, n, next);
    }
    hash_index_free(&found.index);
    free(rows);
    if (!fine) {
        shape_free(made);
        return false;
    }
    made->index_count = (int)(next - made->indices);
    return true;
}
