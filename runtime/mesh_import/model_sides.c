/* Texture coordinates may be mirrored over a part of a mesh, for example if one half of a
 * texture serves both halves of a face. Tangents are left-handed around the normal there and
 * right-handed elsewhere, so their mean is meaningless. A vertex shared by triangles of both
 * orientations is split in two, as at any other seam.
 *     u = |x| on the squares left and right of x = 0: dP/du is (-1, 0, 0) left of it, (1, 0, 0)
 *         right of it, and never their mean */
#include "runtime/mesh_import/model_sides.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TO_RIGHT = 1, TO_LEFT = 2 };

float model_area(const float a[2], const float b[2], const float c[2])
{
    const float area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    return fabsf(area) > 1e-12f ? area : 0;
}

/* Returns the orientation of a triangle's texture coordinates; 0: degenerate. */
static int uv_transform_chain(const Shape *shape, const uint32_t index[3])
{
    const ShapeVertex *vertices = shape->vertices;
    const float area =
        model_area(vertices[index[0]].uv, vertices[index[1]].uv, vertices[index[2]].uv);
    return area > 0 ? TO_RIGHT : area < 0 ? TO_LEFT : 0;
}

/* Collects the orientations of each vertex's triangles. Returns the number of vertices with
 * both. */
static int find_turns(const Shape *shape, unsigned char *turns)
{
    int both = 0;
    for (int i = 0; i < shape->index_count; i++)
        turns[shape->indices[i]] |=
            (unsigned char)uv_transform_chain(shape, &shape->indices[i - i % 3]);
    for (int i = 0; i < shape->vertex_count; i++)
        both += turns[i] == (TO_RIGHT | TO_LEFT);
    return both;
}

/* Appends the duplicates. left[i] is the vertex that left-handed triangles use in place of i.
 * `kept` has a row for every possible vertex. */
static void append_doubles(Shape *shape, const unsigned char *turns, uint32_t *left,
                           float (*kept)[3])
{
    const int count = shape->vertex_count;
    for (int i = 0; i < count; i++) {
        left[i] = (uint32_t)i;
        if (turns[i] != (TO_RIGHT | TO_LEFT))
            continue;
        left[i] = (uint32_t)shape->vertex_count++;
        shape->vertices[left[i]] = shape->vertices[i];
        shape_copy_extras(shape, left[i], shape, (uint32_t)i);
        if (kept)
            memcpy(kept[left[i]], kept[i], sizeof *kept);
    }
}

static bool part(Shape *shape, unsigned char *turns, uint32_t *left, float (*kept)[3])
{
    const int both = find_turns(shape, turns);
    if (!both)
        return true;
    ShapeVertex *vertices =
        realloc(shape->vertices, (size_t)(shape->vertex_count + both) * sizeof *vertices);
    if (!vertices)
        return false;
    shape->vertices = vertices;
    if (!shape_grow_extras(shape, shape->vertex_count + both))
        return false;
    append_doubles(shape, turns, left, kept);
    for (int i = 0; i < shape->index_count; i += 3)
        if (uv_transform_chain(shape, &shape->indices[i]) == TO_LEFT)
            for (int k = 0; k < 3; k++)
                shape->indices[i + k] = left[shape->indices[i + k]];
    return true;
}

bool model_part_sides(Shape *shape, float (*kept)[3])
{
    unsigned char *turns = calloc((size_t)shape->vertex_count, sizeof *turns);
    uint32_t *left = malloc((size_t)shape->vertex_count * sizeof *left);
    const bool done = turns && left && part(shape, turns, left, kept);
    free(turns);
    free(left);
    return done;
}
