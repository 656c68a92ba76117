#include "tests/frame/shadow_knot.h"
#include "tests/frame_reference/shadow_ray.h"
#include <math.h>
#include <stdlib.h>

/* A tube of radius .3 along x = (2 + cos 3t) cos 2t, y = (2 + cos 3t) sin 2t, z = sin 3t, all over
 * 3: 69,960 triangles. */
enum { ALONG = 795, AROUND = 44 };

static void knot_at(double t, double at[3])
{
    at[0] = (2 + cos(3 * t)) * cos(2 * t) / 3;
    at[1] = (2 + cos(3 * t)) * sin(2 * t) / 3;
    at[2] = sin(3 * t) / 3;
}

static void put_vertex(int ring, int side, ShapeVertex *vertex)
{
    const double t = 2 * PI * ring / ALONG, angle = 2 * PI * side / AROUND;
    double middle[3], next[3], way[3], x[3], y[3];
    knot_at(t, middle);
    knot_at(t + 1e-6, next);
    for (int i = 0; i < 3; i++)
        way[i] = next[i] - middle[i];
    reference_cross(way, (double[]){0, 0, 1}, x);
    reference_normalize(x);
    reference_cross(way, x, y);
    reference_normalize(y);
    for (int i = 0; i < 3; i++) {
        vertex->normal[i] = (float)(cos(angle) * x[i] + sin(angle) * y[i]);
        vertex->position[i] = (float)(middle[i] + .13 * (double)vertex->normal[i]);
    }
}

Shape shadow_knot(void)
{
    Shape shape = {.vertices = calloc((size_t)ALONG * AROUND, sizeof *shape.vertices),
                   .indices = calloc((size_t)ALONG * AROUND * 6, sizeof *shape.indices)};
    if (!shape.vertices || !shape.indices)
        abort();
    for (int i = 0; i < ALONG * AROUND; i++) {
        const int ring = i / AROUND, side = i % AROUND;
        const int corners[4] = {i, (ring + 1) % ALONG * AROUND + side,
                                ring * AROUND + (side + 1) % AROUND,
                                (ring + 1) % ALONG * AROUND + (side + 1) % AROUND};
        put_vertex(ring, side, &shape.vertices[shape.vertex_count++]);
        for (int k = 0; k < 6; k++)
            shape.indices[shape.index_count++] = (uint32_t)corners[(int[]){0, 2, 1, 1, 2, 3}[k]];
    }
    return shape;
}
