/* Shapes and matrices of the GL layer: orientation of rotations, tangents equal the derivatives
 * of the position, and closed shapes are reported as closed. */
#include "tests/test.h"
#include "runtime/gl/matrix.h"
#include "runtime/gl/mesh.h"
#include <math.h>
#include <stdlib.h>

/* The vertex of a shape that is nearest to (u, v) in a patch. */
static const ShapeVertex *vertex_at(const Shape *shape, float u, float v)
{
    const ShapeVertex *best = shape->vertices;
    for (int i = 0; i < shape->vertex_count; i++) {
        const ShapeVertex *w = &shape->vertices[i];
        if (hypotf(w->uv[0] - u, w->uv[1] - v) < hypotf(best->uv[0] - u, best->uv[1] - v))
            best = w;
    }
    return best;
}

/* dP/du x dP/dv is along the normal wherever it does not vanish, and triangles turn
 * counterclockwise around it. */
static void shapes_are_oriented(void **state)
{
    (void)state;
    for (int kind = 0; kind < SHAPE_count; kind++) {
        Shape shape;
        ShapeKind found;
        assert_true(shape_make((ShapeKind)kind, &shape));
        assert_true(shape_find(shape_name((ShapeKind)kind), &found) && (int)found == kind);
        for (int i = 0; i < shape.vertex_count; i++) {
            const ShapeVertex *w = &shape.vertices[i];
            const float *a = w->tangentU, *b = w->tangentV, *n = w->normal;
            float c[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                          a[0] * b[1] - a[1] * b[0]};
            float length = sqrtf(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
            assert_float_equal(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-5);
            assert_float_equal(c[0] * n[0] + c[1] * n[1] + c[2] * n[2], length, 1e-4);
        }
        for (int i = 0; i < shape.index_count; i += 3) {
            const ShapeVertex *t[3];
            float a[3], b[3], turn = 0;
            for (int k = 0; k < 3; k++)
                t[k] = &shape.vertices[shape.indices[i + k]];
            for (int k = 0; k < 3; k++) {
                a[k] = t[1]->position[k] - t[0]->position[k];
                b[k] = t[2]->position[k] - t[0]->position[k];
            }
            for (int k = 0; k < 3; k++)
                turn += (a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]) *
                        t[0]->normal[k];
            assert_true(turn > -1e-7f);
        }
        shape_free(&shape);
    }
    assert_false(shape_find("teapot", &(ShapeKind){0}));
}

static void derivatives_are_those_of_the_position(void **state)
{
    (void)state;
    for (int kind = 0; kind < SHAPE_count; kind++) {
        if (kind == SHAPE_cube)
            continue; /* six patches share their uv */
        Shape shape;
        assert_true(shape_make((ShapeKind)kind, &shape));
        const bool flat = kind == SHAPE_plane || kind == SHAPE_ground;
        const ShapeVertex *here = vertex_at(&shape, flat ? 0 : 0.25f, flat ? 0 : 0.75f);
        const ShapeVertex *next =
            vertex_at(&shape, here->uv[0] + (flat ? 1 : 1.f / 192), here->uv[1]);
        assert_true(next != here && next->uv[1] == here->uv[1]);
        for (int k = 0; k < 3; k++)
            assert_float_equal((next->position[k] - here->position[k]) /
                                   (next->uv[0] - here->uv[0]),
                               here->tangentU[k], 0.2);
        shape_free(&shape);
    }
}

static void matrices_invert(void **state)
{
    (void)state;
    Mat4 camera = mat4_look_at((float[]){3, -4, 2}, (float[]){0, 0, 0.5f}, (float[]){0, 0, 1});
    Mat4 lens = mat4_perspective(0.3f, 1.5f, 1, 10), all = mat4_multiply(&lens, &camera), back, one;
    assert_true(mat4_inverse(&all, &back));
    one = mat4_multiply(&back, &all);
    for (int i = 0; i < 16; i++)
        assert_float_equal(one.m[i], (i % 5 == 0), 1e-4);
    assert_false(mat4_inverse(&(Mat4){{0}}, &back));
    Mat4 stretched = {{2, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}; /* a mirror, too */
    Mat3 normal = mat3_normal(&stretched);
    assert_float_equal(normal.m[0] / normal.m[8], 0.5, 1e-6);
    assert_true(normal.m[8] > 0 && normal.m[4] < 0);
}

static bool same_place(const float a[3], const float b[3])
{
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/* Which shapes enclose something is plain to see, and that a torus' inner side shows its front to
 * its middle; without any one of its triangles none does, and with one turned round none has an
 * outside. */
static void bodies_are_known(void **state)
{
    (void)state;
    static const bool closed[SHAPE_count] = {
        [SHAPE_sphere] = true, [SHAPE_cube] = true, [SHAPE_torus] = true};
    for (int kind = 0; kind < SHAPE_count; kind++) {
        Shape shape;
        const int steps[2] = {/* faces of a cube meet; a pole has an odd number of triangles */
                              7, kind == SHAPE_cube ? 7 : 5};
        const ShapeBody body = !closed[kind]         ? SHAPE_BODY_none
                               : kind == SHAPE_torus ? SHAPE_BODY_closed
                                                     : SHAPE_BODY_solid;
        assert_true(shape_make_detailed((ShapeKind)kind, steps, &shape));
        assert_int_equal(shape_body(&shape), body);
        for (int i = 0; i < shape.index_count; i += 3) {
            uint32_t *corner = shape.indices + i;
            const uint32_t kept[3] = {corner[0], corner[1], corner[2]};
            const float *a = shape.vertices[corner[0]].position,
                        *b = shape.vertices[corner[2]].position;
            const float *c = shape.vertices[corner[1]].position;
            /* at a pole */
            const bool flat = same_place(a, b) || same_place(a, c) || same_place(b, c);
            corner[2] = corner[1];
            assert_int_equal(shape_body(&shape), flat ? body : SHAPE_BODY_none);
            corner[1] = kept[2];
            corner[2] = kept[1];
            assert_int_equal(shape_body(&shape), !closed[kind] ? SHAPE_BODY_none
                                                 : flat        ? body
                                                               : SHAPE_BODY_closed);
            corner[1] = kept[1];
            corner[2] = kept[2];
        }
        shape_free(&shape);
    }
}

/* Appends a copy of a shape at 4 on an axis, scaled, with its winding optionally flipped. */
static void add_copy(Shape *shape, double size, bool turned)
{
    const int vertices = shape->vertex_count, indices = shape->index_count;
    shape->vertices = realloc(shape->vertices, 2 * (size_t)vertices * sizeof *shape->vertices);
    shape->indices = realloc(shape->indices, 2 * (size_t)indices * sizeof *shape->indices);
    assert_true(shape->vertices && shape->indices);
    for (int i = 0; i < vertices; i++) {
        shape->vertices[vertices + i] = shape->vertices[i];
        for (int k = 0; k < 3; k++)
            shape->vertices[vertices + i].position[k] =
                (float)(size * shape->vertices[i].position[k] + (k == 0 ? 4 : 0));
    }
    for (int i = 0; i < indices; i++) {
        const int corner = turned ? 2 - i % 3 : i % 3;
        shape->indices[indices + i] = shape->indices[i - i % 3 + corner] + (uint32_t)vertices;
    }
    shape->vertex_count *= 2;
    shape->index_count *= 2;
}

/* Each part has its own outside: a small inside-out part is found next to a large one, far from
 * the origin, and inside it. */
static void each_part_is_looked_at(void **state)
{
    (void)state;
    static const struct {
        double size;
        bool turned;
        ShapeBody body;
    } cases[] = {{1, false, SHAPE_BODY_solid},   {.1, true, SHAPE_BODY_closed},
                 {8, false, SHAPE_BODY_solid},   {8, true, SHAPE_BODY_closed},
                 {-1, false, SHAPE_BODY_closed}, {-1, true, SHAPE_BODY_solid}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Shape shape;
        assert_true(shape_make_detailed(SHAPE_sphere, (int[]){9, 7}, &shape));
        add_copy(&shape, cases[i].size, cases[i].turned);
        assert_int_equal(shape_body(&shape), cases[i].body);
        for (int k = 0; k < shape.vertex_count; k++)
            shape.vertices[k].position[1] =
                /* rounded, what is in one place alike */
                shape.vertices[k].position[1] * 64 + 65536;
        for (int k = 0; k < shape.index_count; k += 3) { /* and all of it turned round */
            const uint32_t kept = shape.indices[k];
            shape.indices[k] = shape.indices[k + 1];
            shape.indices[k + 1] = kept;
        }
        assert_int_equal(shape_body(&shape), SHAPE_BODY_closed);
        shape_free(&shape);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shapes_are_oriented),
        cmocka_unit_test(derivatives_are_those_of_the_position),
        cmocka_unit_test(bodies_are_known),
        cmocka_unit_test(each_part_is_looked_at),
        cmocka_unit_test(matrices_invert),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
