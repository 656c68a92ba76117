/* Copies on displaced surfaces: at the height of the closed form, along its normal, in rotated
 * and scaled groups, and on surfaces that are part of copies. */
#include <stdio.h>
#include <stdlib.h>
#include "tests/scene_text.h"
#include "tests/vectors.h"

/* The height of a place of the object's space, in units of the world. */
#define HEIGHT "'= .5 * sin(x) * cos(.7 * y)'"
static double height(const double p[3], double slope[2])
{
    slope[0] = .5 * cos(p[0]) * cos(.7 * p[1]);
    slope[1] = -.35 * sin(p[0]) * sin(.7 * p[1]);
    return .5 * sin(p[0]) * cos(.7 * p[1]);
}

static void unit(double v[3])
{
    const double size = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= size;
}

/* A place of the world in the space of a matrix whose columns are at right angles and of one
 * length, and that length. */
static double local_of(const double *m, const double world[3], double local[3])
{
    const double size = sqrt(dot(m, m)),
                 from[3] = {world[0] - m[12], world[1] - m[13], world[2] - m[14]};
    for (int i = 0; i < 3; i++)
        local[i] = dot(from, m + 4 * i) / (size * size);
    return size;
}

typedef struct {
    double height, angle; /* the world's units; the sine of an angle */
} Off;

/* How far a copy is off the surface over the plane z = 0 of a matrix. */
static Off off(const double *base, const double *copy)
{
    double local[3], slope[2], normal[3], up[3] = {copy[8], copy[9], copy[10]}, cross = 0;
    const double size = local_of(base, copy + 12, local), risen = height(local, slope) / size;
    const double n[3] = {-slope[0] / size, -slope[1] / size, 1};
    for (int i = 0; i < 3; i++)
        normal[i] = base[i] * n[0] + base[4 + i] * n[1] + base[8 + i] * n[2];
    unit(normal);
    unit(up);
    for (int i = 0; i < 3; i++)
        cross += pow(normal[i] - up[i], 2);
    return (Off){fabs(local[2] - risen) * size, sqrt(cross)};
}

#define MATERIALS                                                                                  \
    "materials: { hilly: { material: Phong, displacementBound: 1, displacement: " HEIGHT           \
    " }, red: { material: Phong } }\n"
static const char hill[] = "{ object: Parallelogram, u: [8, 0, 0], v: [0, 6, 0], material: hilly }";
enum { COPIES = 3000 };

static Scene *scene_of(const char *form, MatcDocument **document)
{
    char text[2000];
    snprintf(text, sizeof text, form, hill, hill);
    return read_fine(text, document);
}

/* A height is in units of the world, whatever the group is scaled by. */
static void copies_stand_on_what_is_displaced(void **state)
{
    (void)state;
    static const char form[] =
        MATERIALS "defs: { hill: %s }\nobjects:\n- { object: Group, transform: { scale: 2, "
                  "rotation: [0.4, 0.3, 1], translation: [5, 6, 7] }, objects: [\n"
                  "  { object: Instance, of: hill }, { object: Scatter, on: %s, count: 3000, "
                  "objects: [{ object: Box, material: red }] }] }\n";
    MatcDocument *document;
    Scene *scene = scene_of(form, &document);
    Off most = {0, 0};
    double rises = 0;
    assert_int_equal(scene->object_count, COPIES + 1);
    const double *base = scene->objects[0].world_from_local.m;
    for (int i = 1; i <= COPIES; i++) {
        double local[3];
        const Off own = off(base, scene->objects[i].world_from_local.m);
        local_of(base, scene->objects[i].world_from_local.m + 12, local);
        rises = fmax(rises, fabs(local[2]));
        most.height = fmax(most.height, own.height);
        most.angle = fmax(most.angle, own.angle);
    }
    print_message("copies are %.1e off the surface and %.1e off its normal\n", most.height,
                  most.angle);
    assert_true(rises > 0.2 && most.height < 2e-5 && most.angle < 3e-4);
    forget(scene, document);
}

/* Upright copies are moved and not rotated; copies on undisplaced surfaces stay unchanged. */
static void upright_and_flat(void **state)
{
    (void)state;
    static const char upright[] =
        MATERIALS "defs: { hill: %s }\nobjects: [{ object: Instance, of: hill }, { object: "
                  "Scatter, on: %s, aligned: "
                  "false, count: 3000, objects: [{ object: Box, material: red }] }]\n";
    static const char flat[] =
        MATERIALS "defs: { hill: %s, other: %s }\nobjects: [{ object: Instance, of: hill }, { "
                  "object: Scatter, count: "
                  "3000, on: { object: Parallelogram, u: [8, 0, 0], v: [0, 6, 0], material: red }, "
                  "objects: [{ object: Box, material: red }] }]\n";
    for (int way = 0; way < 2; way++) {
        MatcDocument *document;
        Scene *scene = scene_of(way ? flat : upright, &document);
        for (int i = 1; i <= COPIES; i++) {
            const double *m = scene->objects[i].world_from_local.m, z[3] = {0, 0, 1};
            double slope[2];
            assert_near(m + 8, z, 3, 1e-6);
            assert_true(fabs(m[14] - (way ? 0 : height(m + 12, slope))) < 1e-5);
        }
        forget(scene, document);
    }
}

/* Objects on a copy stand on the copy's surface, and the copy on the surface below. */
static void copies_bring_surfaces(void **state)
{
    (void)state;
    static const char form[] = MATERIALS
        "defs:\n  hill: %s\n  tile: { object: Group, transform: { scale: 0.5 }, objects: [{ "
        "object: Instance, of: hill "
        "}, { object: Scatter, on: %s, count: 20, objects: [{ object: Box, material: red }] }] }\n"
        "objects: [{ object: Instance, of: hill }, { object: Scatter, on: { object: Instance, of: "
        "hill }, count: 30, "
        "seed: 3, objects: [{ object: Instance, of: tile }] }]\n";
    MatcDocument *document;
    Scene *scene = scene_of(form, &document);
    Off most = {0, 0};
    assert_int_equal(scene->object_count, 1 + 30 * 21);
    for (int i = 0; i < 30; i++) {
        const double *tile = scene->objects[1 + 21 * i].world_from_local.m;
        for (int k = -1; k < 20; k++) {
            const Off own = k < 0 ? off(scene->objects[0].world_from_local.m, tile)
                                  : off(tile, scene->objects[2 + 21 * i + k].world_from_local.m);
            most.height = fmax(most.height, own.height);
            most.angle = fmax(most.angle, own.angle);
        }
    }
    assert_true(most.height < 2e-5 && most.angle < 3e-4);
    forget(scene, document);
}

/* A cube of edge 2 that is pushed by the square root of 3 is the ball through its corners, of which
 * each copy stands upright; with a bulge of 3/4 the middles of its faces are at 1.5, and those of
 * its edges, at (5/4, 0, 5/4), farthest. The height that displaces it is next to nothing. */
static void copies_stand_on_what_is_rounded(void **state)
{
    (void)state;
    static const char form[] =
        "displacement: { method: grid, %s }\nmaterials: { hard: { material: Phong, "
        "displacementBound: 1, displacement: '= 1e-9 * x' }, "
        "red: { material: Phong } }\nobjects: [{ object: Group, transform: { scale: 2, "
        "rotation: [0.4, 0.3, 1] }, objects: [{ "
        "object: Scatter, on: { object: Box, size: [2, 2, 2], material: hard }, count: 3000, "
        "objects: [{ object: Box, material: red }] }] }]\n";
    static const char *const ways[] = {"push: 1.7320508", "bulge: 0.75"};
    for (int way = 0; way < 2; way++) {
        char text[1000];
        MatcDocument *document;
        double worst = 0, lean = 0, farthest = 0, least = 9;
        snprintf(text, sizeof text, form, ways[way]);
        Scene *scene = read_fine(text, &document);
        for (int i = 0; i < COPIES; i++) {
            const double *m = scene->objects[i].world_from_local.m;
            double out[3] = {m[12] / 2, m[13] / 2, m[14] / 2}, up[3] = {m[8], m[9], m[10]};
            const double r = sqrt(dot(out, out));
            unit(out);
            unit(up);
            worst = fmax(worst, fabs(r - sqrt(3)));
            lean = fmax(lean, 1 - dot(out, up));
            farthest = fmax(farthest, r);
            least = fmin(least, r);
        }
        print_message("%s: copies are %.1e off the ball, at %.3f to %.3f; cosines %.1e below 1\n",
                      ways[way], worst, least, farthest, lean);
        assert_true(way ? least > 1.49 && least < 1.51 && farthest < 1.25 * sqrt(2) + 1e-6 &&
                              farthest > 1.75
                        : worst < 1e-6 && lean < 1e-6);
        forget(scene, document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(copies_stand_on_what_is_displaced), cmocka_unit_test(upright_and_flat),
        cmocka_unit_test(copies_stand_on_what_is_rounded), cmocka_unit_test(copies_bring_surfaces)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
