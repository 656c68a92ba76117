/* Many lights: of every kind in any order, more than a block of numbers holds, against the reference in double. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/frame/frame_compare.h"
#include "tests/frame/frame_draw.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint32_t state_of_lights;

/* From 0 to 1. */
static double chance(void)
{
    state_of_lights = state_of_lights * 1664525u + 1013904223u;
    return (state_of_lights >> 8) / 16777216.;
}

enum { TEXT = 1 << 20 };

#define APPEND(...) size += (size_t)snprintf(text + size, TEXT - size, __VA_ARGS__)

/* Behind the `size` characters that are there: a light above a plane, so that it shades nothing from it. Returns the new size. */
static size_t put_light(char *text, size_t size, const char *kind, int count)
{
    const bool directional = !strcmp(kind, "Directional"), area = !strcmp(kind, "Area"), spot = !strcmp(kind, "Spot");
    const double x = 6 * chance() - 3, y = 6 * chance() - 3, z = .3 + 2 * chance();
    const double red = chance(), green = chance(), blue = chance();
    APPEND("- { light: %s, color: [%.3f, %.3f, %.3f], intensity: %.5f", kind, red, green, blue,
           (directional ? 2. : 8.) / count);
    if (!directional)
        APPEND(", position: [%.4f, %.4f, %.4f]", x, y, z);
    if (spot || directional)
        APPEND(", direction: [%.4f, %.4f, -1]", x / 6, y / 6);
    if (spot)
        APPEND(", innerAngle: 25, outerAngle: 55");
    if (area)
        APPEND(", u: [0, .4, 0], v: [.3, 0, .1]");
    else if (z < 1)
        APPEND(", shadows: false");
    APPEND(" }\n");
    return size;
}

/* `kinds` are taken in turns. From malloc. */
static char *text_of(const char *const *kinds, int kind_count, int count)
{
    char *text = malloc(TEXT);
    assert_non_null(text);
    state_of_lights = 1;
    size_t size = 0;
    APPEND(
        "image: { width: 96, height: 64 }\ncamera: { camera: Perspective, position: [.5, -6, 2.5], target: [0, 0, 0] "
        "}\nobjects: [{ object: Plane, material: { material: Phong, diffuse: [.6, .5, .4], specular: .25, "
        "shininess: .5 } }]\nlights:\n");
    for (int i = 0; i < count; i++)
        size = put_light(text, size, kinds[i % kind_count], count);
    assert_true(size < TEXT);
    return text;
}

static const char *const every[] = {"Spot", "Point", "Area", "Directional", "Point", "Point", "Spot"};
static const char *const spots[] = {"Spot"};

/* Every light counts, wherever its numbers stand: in a block, or beyond its room in a texture; in both entries. */
static void every_light_counts(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        const char *const *kinds;
        int kind_count, count;
        bool fragment;
    } cases[] = {{"of every kind", every, 7, 21, false},
                 {"in fragments", every, 7, 21, true},
                 {"more than a block", spots, 1, 1100, false},
                 {"that in fragments", spots, 1, 1100, true}};
    static Spread spread;
    MatcLayout *layout;
    const MatcOptions options = frame_float_options(&layout);
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        MatcDocument *document;
        char *text = text_of(cases[i].kinds, cases[i].kind_count, cases[i].count);
        Scene *scene = frame_scene(text, &options, &document);
        float *rgba = frame_floats(
            gl, scene, &(RenderOptions){.compile = &options, .view = "light", .fragment = cases[i].fragment});
        compare(scene, &options, rgba, &spread);
        assert_true(is_close(cases[i].name, 2e-6, &spread));
        free(rgba);
        free(text);
        frame_forget(scene, document);
    }
    gl_close(gl);
    matc_layout_free(layout);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_light_counts)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
