/* Copies on surfaces: uniform by area, by Pearson's chi-squared test over cells of equal area in
 * closed form; along the normal or upright; as many as the density gives; refused values. */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "tests/scene_text.h"
#include "tests/vectors.h"

enum { COPIES = 20000, CELLS = 100 };

/* Checks the sum of (seen - expected)^2 / expected over cells: its mean is cells - 1, its
 * standard deviation sqrt(2 (cells - 1)). Allows five deviations. */
static void assert_even(const int *seen, const double *shares, int cells)
{
    double sum = 0, total = 0;
    for (int i = 0; i < cells; i++)
        total += seen[i];
    assert_int_equal((int)total, COPIES);
    for (int i = 0; i < cells; i++) {
        const double expected = total * (shares ? shares[i] : 1. / cells);
        sum += (seen[i] - expected) * (seen[i] - expected) / expected;
    }
    if (!(fabs(sum - (cells - 1)) <= 5 * sqrt(2. * (cells - 1))))
        fail_msg("chi-squared %g of %d cells", sum, cells);
}

static Scene *copies_on(const char *on, const char *more, MatcDocument **document)
{
    char text[1024];
    snprintf(text, sizeof text,
             RED "objects: [{ object: Scatter, count: %d, seed: 7, on: %s, objects: [{ object: "
                 "Box, material: red }]%s }]\n",
             COPIES, on, more);
    Scene *scene = read_fine(text, document);
    assert_int_equal(scene->object_count, COPIES);
    return scene;
}

static const double *matrix_of(const Scene *scene, int i)
{
    return scene->objects[i].world_from_local.m;
}

static int cell(double s, int steps) { return s < 0 ? 0 : s >= 1 ? steps - 1 : (int)(s * steps); }

/* P = (3 s + t, t, 2 t): ten strips of s and of t; all copies look along (0, -2, 1) / sqrt(5). */
static void parallelogram(void **state)
{
    (void)state;
    int seen[CELLS] = {0};
    MatcDocument *document;
    Scene *scene =
        copies_on("{ object: Parallelogram, u: [3, 0, 0], v: [1, 1, 2] }", "", &document);
    for (int i = 0; i < COPIES; i++) {
        const double *m = matrix_of(scene, i), t = m[13], s = (m[12] - t) / 3;
        const double normal[3] = {0, -2 / sqrt(5), 1 / sqrt(5)};
        assert_true(s >= -1e-6 && s <= 1 + 1e-6 && fabs(m[14] - 2 * t) < 1e-6);
        assert_near(m + 8, normal, 3, 1e-6);
        seen[10 * cell(s, 10) + cell(t, 10)]++;
    }
    assert_even(seen, NULL, CELLS);
    forget(scene, document);
}

/* Archimedes: of a sphere, equal steps of z have equal areas, as have equal steps of longitude; 192
 * x 96 chords are within 2 in 1000 of that. Copies are upright about their own way out, at
 * random. */
static void sphere(void **state)
{
    (void)state;
    int seen[CELLS] = {0};
    MatcDocument *document;
    Scene *scene = copies_on("{ object: Sphere, radius: 2 }",
                             ", rotation: [0, 0, 3.14], least: 0.5, most: 2", &document);
    for (int i = 0; i < COPIES; i++) {
        const double *m = matrix_of(scene, i);
        double out[3] = {m[12], m[13], m[14]}, x[3], y[3], z[3], cross[3];
        memcpy(x, m, sizeof x), memcpy(y, m + 4, sizeof y), memcpy(z, m + 8, sizeof z);
        const double length = sqrt(out[0] * out[0] + out[1] * out[1] + out[2] * out[2]);
        const double scale = sqrt(z[0] * z[0] + z[1] * z[1] + z[2] * z[2]);
        assert_true(fabs(length - 2) < 1e-3 && scale >= .5 - 1e-9 && scale <= 2 + 1e-9);
        for (int k = 0; k < 3; k++)
            cross[k] = (x[(k + 1) % 3] * y[(k + 2) % 3] - x[(k + 2) % 3] * y[(k + 1) % 3]) / scale;
        assert_near(cross, z, 3, 1e-9); /* a turn and a scale, no mirror */
        for (int k = 0; k < 3; k++)
            assert_true(fabs(z[k] / scale - out[k] / length) < .02);
        seen[10 * cell(.5 + out[2] / 4, 10) + cell(.5 + atan2(out[1], out[0]) / (2 * PI), 10)]++;
    }
    assert_even(seen, NULL, CELLS);
    forget(scene, document);
}

/* A box of 1 x 2 x 3, twice as large along x, in a group: faces of 6, 6, 6, 6, 4 and 4 of 32.
 * Copies are upright. */
static void box(void **state)
{
    (void)state;
    static const double shares[6] = {6 / 32., 6 / 32., 6 / 32., 6 / 32., 4 / 32., 4 / 32.};
    static const double half[3] = {1, 1, 1.5};
    int seen[6] = {0};
    MatcDocument *document;
    Scene *scene = copies_on("{ object: Group, transform: { scale: [2, 1, 1] }, objects: [{ "
                             "object: Box, size: [1, 2, 3] }] }",
                             ", aligned: false", &document);
    for (int i = 0; i < COPIES; i++) {
        const double *m = matrix_of(scene, i);
        int face = -1;
        for (int k = 0; k < 6; k++)
            if (fabs(m[12 + k / 2] - (k % 2 ? -half[k / 2] : half[k / 2])) < 1e-6)
                face = k;
        assert_true(face >= 0);
        assert_near(m + 8, (double[]){0, 0, 1}, 3, 0);
        seen[face]++;
    }
    assert_even(seen, shares, 6);
    forget(scene, document);
}

/* A mirrored object keeps its normals outside: copies on a mirrored sphere point away from it. */
static void mirrored(void **state)
{
    (void)state;
    MatcDocument *document;
    Scene *scene = copies_on("{ object: Sphere, transform: { scale: [-1, 1, 1] } }", "", &document);
    for (int i = 0; i < COPIES; i++) {
        const double *m = matrix_of(scene, i);
        assert_true(m[8] * m[12] + m[9] * m[13] + m[10] * m[14] > .99);
    }
    forget(scene, document);
}

/* A mesh of triangles of 1, 4 and 15: its copies are as many; 25 for each unit are 500 of 20. */
static void mesh(void **state)
{
    (void)state;
    static const double shares[3] = {1 / 20., 4 / 20., 15 / 20.};
    char name[] = "/tmp/matc_scatterXXXXXX", on[256], text[512];
    int seen[3] = {0};
    MatcDocument *document;
    assert_non_null(mkdtemp(name));
    snprintf(on, sizeof on, "%s/three.obj", name);
    FILE *file = fopen(on, "w");
    assert_non_null(file);
    fputs("v 0 0 0\nv 2 0 0\nv 0 1 0\nv 10 0 0\nv 14 0 0\nv 10 2 0\nv 20 0 0\nv 26 0 0\nv 20 5 "
          "0\nf 1 2 3\nf 4 5 6\nf "
          "7 8 9\n",
          file);
    fclose(file);
    snprintf(text, sizeof text, "{ object: Mesh, file: %s }", on);
    Scene *scene = copies_on(text, "", &document);
    for (int i = 0; i < COPIES; i++)
        seen[(int)(matrix_of(scene, i)[12] / 10)]++;
    assert_even(seen, shares, 3);
    forget(scene, document);
    snprintf(text, sizeof text,
             RED "objects: [{ object: Scatter, density: 25, on: { object: Mesh, file: %s }, "
                 "objects: [{ object: Box, "
                 "material: red }] }]\n",
             on);
    scene = read_fine(text, &document);
    assert_int_equal(scene->object_count, 500);
    forget(scene, document);
    remove(on);
    rmdir(name);
}

/* A surface for copies is not drawn, and its material is not the scene's; an instance is a surface,
 * too. */
static void not_drawn(void **state)
{
    (void)state;
    MatcDocument *document;
    Scene *scene =
        read_fine("materials: { red: { material: RGBA, r: 1 }, blue: { material: RGBA, b: 1 } }\n"
                  "defs: { ball: { object: Sphere, material: blue } }\n"
                  "objects: [{ object: Scatter, count: 3, on: { object: Instance, of: ball }, "
                  "objects: [{ object: "
                  "Cone, material: red }] }]\n",
                  &document);
    assert_int_equal(scene->object_count, 3);
    assert_int_equal(scene->material_count, 1);
    for (int i = 0; i < 3; i++)
        assert_int_equal(scene->objects[i].kind, SCENE_Cone);
    forget(scene, document);
}

#define BOX ", objects: [{ object: Box, material: red }] }]\n"
static void faults(void **state)
{
    (void)state;
    static const struct {
        const char *text, *reported;
    } cases[] = {
        {RED "objects: [{ object: Scatter, on: { object: Plane }" BOX,
         "2:34: error: copies cannot be distributed evenly on an infinite plane"},
        {RED "objects: [{ object: Scatter, on: { object: Group }" BOX,
         "2:34: error: the surface has no area"},
        {RED "objects: [{ object: Scatter, on: { object: Sphere }, size: [1, 1, 1]" BOX,
         "2:60: error: `on` and `size` are mutually exclusive: copies are either on a surface or "
         "in a box"},
        {RED "objects: [{ object: Scatter, on: { object: Sphere }, count: 2, density: 3" BOX,
         "2:73: error: there are as many copies as one says: `density` or `count`"},
        {RED "objects: [{ object: Scatter, density: 3" BOX,
         "2:39: error: `density` needs a surface: set `on`"},
        {RED "objects: [{ object: Scatter, aligned: true" BOX,
         "2:39: error: alignment needs a surface: set `on`"},
        {RED "objects: [{ object: Scatter, on: { object: Sphere, radios: 2 }" BOX,
         "2:52: error: Sphere has no parameter 'radios'; did you mean 'radius'?"},
        {RED "objects: [{ object: Scatter, on: { object: Sphere }, density: 1e9" BOX,
         "2:11: error: more than 1048576 objects and groups"},
        {RED "objects: [{ object: Scatter, count: 1e5, objects: [{ object: Scatter, count: 1, on: "
             "{ object: Sphere, "
             "detail: "
             "1024 }" BOX "}]\n",
         NULL},
        {RED "defs: { a: { object: Scatter, on: { object: Instance, of: a }, objects: [] } "
             "}\nobjects: [{ object: "
             "Instance, "
             "of: a }]\n",
         "2:59: error: the definition 'a' contains itself"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        MatcDocument *document;
        char line[512];
        assert_null(read_text(cases[i].text, &document));
        const char *reported = matc_diagnostics(document, MATC_TEXT);
        snprintf(line, sizeof line, "%.*s", (int)strcspn(reported, "\n"), reported);
        if (cases[i].reported)
            assert_string_equal(line + strlen("scene.yaml:"), cases[i].reported);
        matc_document_free(document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parallelogram), cmocka_unit_test(sphere), cmocka_unit_test(box),
        cmocka_unit_test(mirrored),      cmocka_unit_test(mesh),   cmocka_unit_test(not_drawn),
        cmocka_unit_test(faults),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
