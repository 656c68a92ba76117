/* Triangles of objects. Shapes shared with previews are scaled, positions and derivatives alike;
 * the others are made here. */
#include "runtime/scene/scene.h"
#include "runtime/scene/scene_matrix.h"
#include "runtime/tessellate/scene_solid.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI       3.14159265358979323846
#define SHORTEST 1e-6 /* length of the normal at a cone's tip */

static void put(float to[3], double x, double y, double z)
{
    to[0] = (float)x, to[1] = (float)y, to[2] = (float)z;
}

/* Builds a preview shape with half extents 1, scaled. Its normals stay valid: a sphere is scaled
 * uniformly, a box and a parallelogram are flat. */
static bool scaled(ShapeKind kind, const int steps[2], const double by[3], Shape *made)
{
    if (!shape_make_detailed(kind, steps, made))
        return false;
    for (int i = 0; i < made->vertex_count; i++)
        for (int k = 0; k < 3; k++) {
            ShapeVertex *vertex = &made->vertices[i];
            vertex->position[k] = (float)(vertex->position[k] * by[k]);
            vertex->tangentU[k] = (float)(vertex->tangentU[k] * by[k]);
            vertex->tangentV[k] = (float)(vertex->tangentV[k] * by[k]);
        }
    return true;
}

/* Builds a parallelogram: P = s u + t v, (s, t) in the unit square. */
static bool parallelogram(const double u[3], const double v[3], Shape *made)
{
    /* a product of unnormalized lengths may overflow */
    double a[3] = {u[0], u[1], u[2]}, b[3] = {v[0], v[1], v[2]}, normal[3];
    vec3_normalize(a);
    vec3_normalize(b);
    vec3_cross(a, b, normal);
    vec3_normalize(normal);
    if (!shape_make(SHAPE_plane, made))
        return false;
    for (int i = 0; i < made->vertex_count; i++) {
        ShapeVertex *vertex = &made->vertices[i];
        const double s = vertex->uv[0], t = vertex->uv[1];
        put(vertex->position, s * u[0] + t * v[0], s * u[1] + t * v[1], s * u[2] + t * v[2]);
        put(vertex->normal, normal[0], normal[1], normal[2]);
        put(vertex->tangentU, u[0], u[1], u[2]);
        put(vertex->tangentV, v[0], v[1], v[2]);
    }
    return true;
}

/* A side between two circles, and a lid on each circle with a radius above 0: vertices in rows
 * of `steps` + 1. */
typedef struct {
    double foot, top, height; /* radii of the circles, and the height */
    int steps;                /* segments of a circle */
} Round;

/* Writes a row of vertices of the side: P = (r cos a, r sin a, h t), a = 2 pi s, r from foot to
 * top; the normal tilts by the slope of the side. Its length is r / foot: then it is linear in
 * P, and right also within a triangle that ends in a tip. With normals of length 1 each triangle
 * of a cone would have at its tip the normal of one of its edges, half a step off: 0.9 degrees.
 * At the tip itself the normal is short, but not 0. */
static ShapeVertex *side_row(const Round *o, double t, ShapeVertex *next)
{
    const double r = o->foot + (o->top - o->foot) * t, fall = o->foot - o->top;
    const double long_as = fmax(r / o->foot, SHORTEST) / hypot(o->height, fall);
    for (int i = 0; i <= o->steps; i++, next++) {
        const double s = (double)i / o->steps, a = 2 * PI * (i % o->steps) / o->steps, c = cos(a),
                     d = sin(a);
        put(next->position, r * c, r * d, o->height * t);
        put(next->normal, o->height * long_as * c, o->height * long_as * d, fall * long_as);
        put(next->tangentU, -2 * PI * r * d, 2 * PI * r * c, 0);
        put(next->tangentV, -fall * c, -fall * d, o->height);
        next->uv[0] = (float)s, next->uv[1] = (float)t;
    }
    return next;
}

/* Writes the vertices of a disc: its center, then its rim; u and v are those of the square
 * around it, flipped at the foot. */
static ShapeVertex *lid(const Round *o, bool up, ShapeVertex *next)
{
    const double r = up ? o->top : o->foot, z = up ? o->height : 0, facing = up ? 1 : -1;
    for (int i = -1; i <= o->steps; i++, next++) {
        const double a = 2 * PI * (i % o->steps) / o->steps, c = i < 0 ? 0 : cos(a),
                     d = i < 0 ? 0 : sin(a);
        put(next->position, r * c, r * d, z);
        put(next->normal, 0, 0, facing);
        put(next->tangentU, 2 * r, 0, 0);
        put(next->tangentV, 0, facing * 2 * r, 0);
        next->uv[0] = (float)(.5 + .5 * c), next->uv[1] = (float)(.5 + .5 * facing * d);
    }
    return next;
}

static uint32_t *add_triangle(uint32_t *next, uint32_t a, uint32_t b, uint32_t c)
{
    const uint32_t corners[3] = {a, b, c};
    memcpy(next, corners, sizeof corners);
    return next + 3;
}

static uint32_t *add_lid(uint32_t *next, uint32_t middle, uint32_t steps, bool up)
{
    for (uint32_t i = 0; i < steps; i++)
        next = add_triangle(next, middle, middle + 1 + (up ? i : i + 1),
                            middle + 1 + (up ? i + 1 : i));
    return next;
}

/* Builds a cylinder or cone. A cone has an additional row at its tip, where the side still has a
 * normal in each direction. */
static bool solid_round(const Round *o, Shape *made)
{
    const uint32_t steps = (uint32_t)o->steps;
    const int row = o->steps + 1, lids = 1 + (o->top > 0);
    made->vertex_count = 2 * row + lids * (row + 1);
    made->index_count = (2 + lids) * o->steps * 3;
    made->vertices = calloc((size_t)made->vertex_count, sizeof *made->vertices);
    made->indices = calloc((size_t)made->index_count, sizeof *made->indices);
    if (!made->vertices || !made->indices) {
        shape_free(made);
        return false;
    }
    ShapeVertex *vertex = side_row(o, 1, side_row(o, 0, made->vertices));
    uint32_t *index = made->indices, foot = (uint32_t)(2 * row), top = foot + (uint32_t)row + 1;
    for (uint32_t i = 0; i < steps; i++) {
        index = add_triangle(index, i, i + 1, i + (uint32_t)row + 1);
        index = add_triangle(index, i, i + (uint32_t)row + 1, i + (uint32_t)row);
    }
    vertex = lid(o, false, vertex);
    index = add_lid(index, foot, steps, false);
    if (lids > 1) {
        lid(o, true, vertex);
        add_lid(index, top, steps, true);
    }
    return true;
}

Key scene_solid_key(const SceneObject *object)
{
    double parts[SCENE_NUMBERS + 2] = {object->kind, object->mesh};
    memcpy(parts + 2, object->numbers, sizeof object->numbers);
    return key_of_bytes(parts, sizeof parts);
}

int scene_solid_triangles(const SceneObject *object)
{
    const double *n = object->numbers;
    switch (object->kind) {
    case SCENE_Sphere:
        return (int)n[1] * (((int)n[1] + 1) / 2) * 2;
    case SCENE_Box:
        return 12;
    case SCENE_Parallelogram:
        return 2;
    case SCENE_Cylinder:
        return 4 * (int)n[2]; /* two per step of the side, one of each lid */
    case SCENE_Cone:
        return 3 * (int)n[2];
    default:
        return 0;
    }
}

bool scene_solid(const SceneObject *object, Shape *made)
{
    const double *n = object->numbers;
    *made = (Shape){0};
    switch (object->kind) {
    case SCENE_Sphere:
        return scaled(SHAPE_sphere, (int[]){(int)n[1], ((int)n[1] + 1) / 2},
                      (double[]){n[0], n[0], n[0]}, made);
    case SCENE_Box:
        return scaled(SHAPE_cube, (int[]){1, 1}, (double[]){n[0] / 2, n[1] / 2, n[2] / 2}, made);
    case SCENE_Parallelogram:
        return parallelogram(n, n + 3, made);
    case SCENE_Cylinder:
        return solid_round(&(Round){n[0], n[0], n[1], (int)n[2]}, made);
    case SCENE_Cone:
        return solid_round(&(Round){n[0], 0, n[1], (int)n[2]}, made);
    default:
        return true; /* nothing to build: a Plane has no triangles, a Mesh has its own */
    }
}
