/* A shape is a list of patches; a patch is a grid over a surface P(u, v). */
#include "runtime/gl/shape.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI           3.14159265358979323846
#define TORUS_RADIUS 0.7 /* radius of the tube's center line */
#define TORUS_TUBE   0.3

/* Computes a vertex except uv, which is set already and may be changed. `patch` counts from 0. */
typedef void Surface(int patch, double u, double v, ShapeVertex *vertex);

static void put(float to[3], double x, double y, double z)
{
    to[0] = (float)x, to[1] = (float)y, to[2] = (float)z;
}

/* Sine of an angle in turns: equal for equal fractions, and exactly 0 at half and whole turns,
 * so that vertices at a seam or a pole coincide. */
static double sine(double turns)
{
    const double part = turns - floor(turns);
    return part == 0 || part == .5 ? 0 : sin(2 * PI * part);
}

static double cosine(double turns)
{
    const double part = turns - floor(turns);
    return part == .25 || part == .75 ? 0 : cos(2 * PI * part);
}

/* P = (cos a cos b, sin a cos b, sin b), a = 2 pi u, b = pi (v - 1/2). */
static void sphere(int patch, double u, double v, ShapeVertex *vertex)
{
    (void)patch;
    double ca = cosine(u), sa = sine(u);
    double sb = -cosine(v / 2), cb = sine(v / 2);
    put(vertex->position, ca * cb, sa * cb, sb);
    put(vertex->normal, ca * cb, sa * cb, sb);
    put(vertex->tangentU, -2 * PI * sa * cb, 2 * PI * ca * cb, 0);
    put(vertex->tangentV, -PI * ca * sb, -PI * sa * sb, PI * cb);
}

/* Computes P = (2u - 1, 2v - 1, 0). */
static void plane(int patch, double u, double v, ShapeVertex *vertex)
{
    (void)patch;
    put(vertex->position, 2 * u - 1, 2 * v - 1, 0);
    put(vertex->normal, 0, 0, 1);
    put(vertex->tangentU, 2, 0, 0);
    put(vertex->tangentV, 0, 2, 0);
}

/* Computes P = n + (2u - 1) a + (2v - 1) b with a x b = n. */
static void cube(int patch, double u, double v, ShapeVertex *vertex)
{
    static const signed char faces[6][3][3] = {
        /* per face: normal n, axes a and b */
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},  {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}},
        {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}},
        {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}},  {{0, 0, -1}, {1, 0, 0}, {0, -1, 0}},
    };
    const signed char *n = faces[patch][0], *a = faces[patch][1], *b = faces[patch][2];
    double s = 2 * u - 1, t = 2 * v - 1;
    put(vertex->position, n[0] + s * a[0] + t * b[0], n[1] + s * a[1] + t * b[1],
        n[2] + s * a[2] + t * b[2]);
    put(vertex->normal, n[0], n[1], n[2]);
    put(vertex->tangentU, 2 * a[0], 2 * a[1], 2 * a[2]);
    put(vertex->tangentV, 2 * b[0], 2 * b[1], 2 * b[2]);
}

/* P = ((R + r cos b) cos a, (R + r cos b) sin a, r sin b), a = 2 pi u, b = 2 pi v. */
static void torus(int patch, double u, double v, ShapeVertex *vertex)
{
    (void)patch;
    double ca = cosine(u), sa = sine(u);
    double cb = cosine(v), sb = sine(v);
    double ring = TORUS_RADIUS + TORUS_TUBE * cb, turn = 2 * PI * TORUS_TUBE;
    put(vertex->position, ring * ca, ring * sa, TORUS_TUBE * sb);
    put(vertex->normal, cb * ca, cb * sa, sb);
    put(vertex->tangentU, -2 * PI * ring * sa, 2 * PI * ring * ca, 0);
    put(vertex->tangentV, -turn * sb * ca, -turn * sb * sa, turn * cb);
}

/* P = (2u - 1, y, 2v - 1), y = A(v) sin(b), A = 0.24 - 0.14 v, b = 5 pi u + v; the normal is dP/du
 * x dP/dv. */
static void cloth(int patch, double u, double v, ShapeVertex *vertex)
{
    (void)patch;
    const double folds = 5 * PI, lean = 1, top = .24, gain = -.14;
    double sb = sin(folds * u + lean * v), cb = cos(folds * u + lean * v), depth = top + gain * v;
    double along = depth * folds * cb, up = gain * sb + depth * lean * cb;
    double length = sqrt(along * along + 4 + up * up);
    put(vertex->position, 2 * u - 1, depth * sb, 2 * v - 1);
    put(vertex->normal, along / length, -2 / length, up / length);
    put(vertex->tangentU, 2, along, 0);
    put(vertex->tangentV, 0, up, 2);
}

/* P = (x, y, 0), x = R (2u - 1)^3, y = R (2v - 1)^3: cells are small near the eye. u and v are
 * replaced by those of the plane. */
static void ground(int patch, double u, double v, ShapeVertex *vertex)
{
    double x = SHAPE_HORIZON * pow(2 * u - 1, 3), y = SHAPE_HORIZON * pow(2 * v - 1, 3);
    plane(patch, (x + 1) / 2, (y + 1) / 2, vertex);
    vertex->uv[0] = (float)((x + 1) / 2);
    vertex->uv[1] = (float)((y + 1) / 2);
}

/* 192 steps around keep chords within 0.14 pixels of a circle 2000 pixels wide. */
static const struct {
    const char *name;
    Surface *surface;
    int patches;
    int columns, rows; /* number of cells of a patch */
} kinds[SHAPE_count] = {
    [SHAPE_sphere] = {"sphere", sphere, 1, 192, 96}, [SHAPE_plane] = {"plane", plane, 1, 1, 1},
    [SHAPE_cube] = {"cube", cube, 6, 1, 1},          [SHAPE_torus] = {"torus", torus, 1, 192, 96},
    [SHAPE_cloth] = {"cloth", cloth, 1, 192, 16},    [SHAPE_ground] = {"ground", ground, 1, 64, 64},
};

const char *shape_name(ShapeKind kind)
{
    return (unsigned)kind < SHAPE_count ? kinds[kind].name : "?";
}

bool shape_find(const char *name, ShapeKind *kind)
{
    for (int i = 0; i < SHAPE_count; i++) {
        if (strcmp(kinds[i].name, name) != 0)
            continue;
        *kind = (ShapeKind)i;
        return true;
    }
    return false;
}

static ShapeVertex *fill_vertices(ShapeKind kind, int patch, const int steps[2], ShapeVertex *next)
{
    int columns = steps[0], rows = steps[1];
    for (int row = 0; row <= rows; row++) {
        for (int column = 0; column <= columns; column++, next++) {
            double u = (double)column / columns, v = (double)row / rows;
            next->uv[0] = (float)u, next->uv[1] = (float)v;
            kinds[kind].surface(patch, u, v, next);
        }
    }
    return next;
}

static uint32_t *fill_indices(const int steps[2], uint32_t first, uint32_t *next)
{
    uint32_t columns = (uint32_t)steps[0], rows = (uint32_t)steps[1];
    for (uint32_t row = 0; row < rows; row++) {
        for (uint32_t column = 0; column < columns; column++) {
            uint32_t a = first + row * (columns + 1) + column, b = a + 1, c = a + columns + 1,
                     d = c + 1;
            const uint32_t cell[6] = {a, b, d, a, d, c};
            memcpy(next, cell, sizeof cell);
            next += 6;
        }
    }
    return next;
}

bool shape_make(ShapeKind kind, Shape *made)
{
    memset(made, 0, sizeof *made);
    return (unsigned)kind < SHAPE_count &&
           shape_make_detailed(kind, (int[]){kinds[kind].columns, kinds[kind].rows}, made);
}

bool shape_make_detailed(ShapeKind kind, const int steps[2], Shape *made)
{
    memset(made, 0, sizeof *made);
    int corners = (steps[0] + 1) * (steps[1] + 1);
    made->vertex_count = kinds[kind].patches * corners;
    made->index_count = kinds[kind].patches * steps[0] * steps[1] * 6;
    made->vertices = calloc((size_t)made->vertex_count, sizeof *made->vertices);
    made->indices = calloc((size_t)made->index_count, sizeof *made->indices);
    if (!made->vertices || !made->indices)
        return shape_free(made), false;
    ShapeVertex *vertex = made->vertices;
    uint32_t *index = made->indices;
    for (int patch = 0; patch < kinds[kind].patches; patch++) {
        index = fill_indices(steps, (uint32_t)(patch * corners), index);
        vertex = fill_vertices(kind, patch, steps, vertex);
    }
    return true;
}

bool shape_extra_is(const char (*names)[SHAPE_NAME], int extra, const char *name)
{
    static const char *const fixed[SHAPE_EXTRA_named] = {"color", "uv1"};
    if (extra < SHAPE_EXTRA_named)
        return !strcmp(fixed[extra], name);
    const char *own = names[extra - SHAPE_EXTRA_named];
    size_t i = 0;
    while (own[i] && own[i] == (name[i] >= 'A' && name[i] <= 'Z' ? name[i] - 'A' + 'a' : name[i]))
        i++;
    return i && !own[i] && !name[i];
}

void shape_copy_extras(Shape *made, uint32_t to, const Shape *shape, uint32_t from)
{
    for (int i = 0; i < SHAPE_EXTRAS; i++)
        if (made->extra[i] && shape->extra[i])
            memcpy(made->extra[i][to], shape->extra[i][from], sizeof *shape->extra[i]);
}

bool shape_grow_extras(Shape *shape, int vertices)
{
    for (int i = 0; i < SHAPE_EXTRAS; i++) {
        float(*grown)[4] =
            shape->extra[i] ? realloc(shape->extra[i], (size_t)vertices * sizeof *grown + 1) : NULL;
        if (shape->extra[i] && !grown)
            return false;
        shape->extra[i] = grown;
    }
    return true;
}

void shape_free(Shape *shape)
{
    free(shape->vertices);
    free(shape->indices);
    free(shape->base);
    for (int i = 0; i < SHAPE_EXTRAS; i++)
        free(shape->extra[i]);
    memset(shape, 0, sizeof *shape);
}
