/* The four most common kinds of Principled in compact's 16 bytes per pixel: slots within the
 * error of their bits, and light against that of full floats. */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 128, PIXELS = SIDE * SIDE, MATERIALS = 4 };
static const char *const materials[MATERIALS][2] = {
#define SURFACE(name, parameters) {#name, parameters},
#include "tests/bench/surfaces.def"
};

/* Bound of a slot by its bits in the case that a material takes, and in `integer`, which it is
 * compared with: half a step; for a root at most a step and the square of half a one; for a normal,
 * whose octahedral coordinates are each half a step off, 4.25 of these, as far as a face of the
 * octahedron rotates. */
#define HALF_STEP(bits) (.5 / ((1 << (bits)) - 1))
#define ROOT(bits)      (2 * HALF_STEP(bits) + HALF_STEP(bits) * HALF_STEP(bits))
static const double normal_bound = 4.25 * 2 * HALF_STEP(12);
static const struct {
    const char *slot;
    double bound[MATERIALS]; /* 0: none has it */
} slots[] = {{"normal", {normal_bound, normal_bound, normal_bound, normal_bound}},
             {"diffuse", {ROOT(8), ROOT(8), ROOT(8), ROOT(8)}},
             {"roughness", {HALF_STEP(9), HALF_STEP(9), HALF_STEP(8), HALF_STEP(8)}},
             {"metalness", {HALF_STEP(6), HALF_STEP(6), HALF_STEP(6), HALF_STEP(6)}},
             {"reflectance", {ROOT(7), ROOT(7), ROOT(7), ROOT(7)}},
             {"specular", {ROOT(7), ROOT(7)}},
             {"coat", {0, 0, HALF_STEP(6)}},
             {"coatRoughness", {0, 0, HALF_STEP(6)}},
             {"coatReflectance", {0, 0, ROOT(5)}},
             {"coatTint", {0, 0, ROOT(5)}},
             {"fuzz", {0, 0, 0, HALF_STEP(5)}},
             {"fuzzColor", {0, 0, 0, ROOT(5)}},
             {"fuzzRoughness", {0, 0, 0, HALF_STEP(5)}}};
enum { SLOTS = sizeof slots / sizeof *slots };

typedef struct {
    GlContext *gl;
    MatcOptions compact, whole;
} Rig;

static float *draw(const Rig *rig, const MatcOptions *options, const char *material,
                   const char *view)
{
    char text[1024];
    MatcDocument *document;
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [0, -40, "
             "0], target: [0, 0, 0], "
             "angle: 3 }\nlights: [{ light: Directional, direction: [.5, .7, -.4], intensity: 3 }, "
             "{ light: Ambient, "
             "intensity: .3 }]\n"
             "objects: [{ object: Sphere, material: { material: Principled, %s } }]\n",
             SIDE, SIDE, material);
    Scene *scene = frame_scene(text, options, &document);
    float *rgba =
        frame_floats(rig->gl, scene, &(RendererOptions){.compile = options, .view = view});
    frame_forget(scene, document);
    return rgba;
}

/* The ball's rim is left out. */
static bool on_ball(int pixel)
{
    const double half = tan(1.5 * 3.14159265358979 / 180),
                 x = (2 * (pixel % SIDE) + 1. - SIDE) / SIDE * half,
                 y = (2 * (pixel / SIDE) + 1. - SIDE) / SIDE * half;
    return 40 * sqrt(1 - 1 / (x * x + y * y + 1)) < .97;
}

/* The greatest and the mean difference on the ball, and the greatest value. Both pictures go. */
static void differ(float *a, float *b, double found[3])
{
    int count = 0;
    found[0] = found[1] = found[2] = 0;
    for (int i = 0; i < 4 * PIXELS; i++) {
        if (i % 4 == 3 || !on_ball(i / 4))
            continue;
        const double off = fabs((double)a[i] - (double)b[i]);
        found[0] = fmax(found[0], off);
        found[1] += off;
        found[2] = fmax(found[2], (double)b[i]);
        count++;
    }
    found[1] /= count;
    assert_true(count > PIXELS);
    free(a);
    free(b);
}

static void slots_are_within_their_bits(void **state)
{
    const Rig *rig = *state;
    int faults = 0;
    for (int i = 0; i < MATERIALS; i++)
        for (int k = 0; k < SLOTS; k++) {
            if (slots[k].bound[i] <= 0)
                continue;
            double found[3];
            const int bits = i < 2 ? 16 : 10;
            const double may = slots[k].bound[i] + (k ? HALF_STEP(bits) : 4.25 * 2 * HALF_STEP(16));
            differ(draw(rig, &rig->compact, materials[i][1], slots[k].slot),
                   draw(rig, &rig->whole, materials[i][1], slots[k].slot), found);
            print_message("%-8s %-15s off by %.5f, may be %.5f\n", materials[i][0], slots[k].slot,
                          found[0], may);
            faults += !(found[0] <= may + 1e-6);
        }
    assert_int_equal(faults, 0);
}

static void light_is_near(void **state)
{
    const Rig *rig = *state;
    static const double most[MATERIALS] = {.007, .007, .042, .018}; /* what is seen and a fifth */
    int faults = 0;
    for (int i = 0; i < MATERIALS; i++) {
        double found[3];
        differ(draw(rig, &rig->compact, materials[i][1], "light"),
               draw(rig, &rig->whole, materials[i][1], "light"), found);
        print_message(
            "%-8s light off by %.2f %% at most, %.3f %% in the mean, of the greatest, %.2f\n",
            materials[i][0], 100 * found[0] / found[2], 100 * found[1] / found[2], found[2]);
        faults += !(found[0] <= most[i] * found[2]);
    }
    assert_int_equal(faults, 0);
}

int main(void)
{
    Rig rig = {
        .gl = frame_context(), .compact = frame_exact_options(), .whole = frame_exact_options()};
    rig.compact.layout = "compact";
    rig.compact.pixels = rig.whole.pixels = true;
    const struct CMUnitTest tests[] = {cmocka_unit_test_prestate(slots_are_within_their_bits, &rig),
                                       cmocka_unit_test_prestate(light_is_near, &rig)};
    const int result = cmocka_run_group_tests(tests, NULL, NULL);
    gl_close(rig.gl);
    return result;
}
