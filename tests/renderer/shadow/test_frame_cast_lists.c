/* Colored shadows by their closed form, and their resources: fragment lists exist only in lights
 * with transparent casters. */
/* ctest: seconds=50 */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* -- a product, by its closed form */

enum { PANES_MAX = 10, TEXT = 8192 };

/* Below panes and an infinite plane of glass: on the ground, which is an infinite plane as well. */
static void write_panes(int panes, double expected[3], char text[TEXT])
{
    int size = snprintf(
        text, TEXT,
        "image: { width: 16, height: 16 }\ncamera: { camera: Perspective, position: [0, 0, .5], "
        "up: [0, "
        "1, 0], angle: 60 }\nshadowMaps: { size: 256 }\nlights: [{ light: Directional, direction: "
        "[3, 0, -4] "
        "}]\nobjects:\n"
        "- { object: Plane, material: { material: Phong, diffuse: [.5, .6, .7] } }\n"
        "- { object: Plane, transform: { translation: [0, 0, 20] }, material: { material: Phong, "
        "transparency: [.75, 1, .625] } }\n");
    for (int i = 0; i < 3; i++)
        expected[i] = (.5 + .1 * i) * .8 * (i == 0 ? .75 : i == 1 ? 1 : .625);
    for (int k = 0; k < panes; k++) {
        double t[3];
        for (int i = 0; i < 3; i++)
            expected[i] *= t[i] = .8 + .02 * ((7 * k + 3 * i) % 11);
        size +=
            snprintf(text + size, (size_t)(TEXT - size),
                     "- { object: Parallelogram, u: [30, 0, 0], v: [0, 30, 0], transform: { "
                     "translation: [-15, -15, "
                     "%d] }, material: { material: Phong, transparency: [%.2f, %.2f, %.2f] } }\n",
                     k + 1, t[0], t[1], t[2]);
    }
}

/* Greatest error of a pixel. */
static double panes_off(GlContext *gl, int panes, const RendererOptions *options)
{
    static char text[TEXT];
    double expected[3], off = 0;
    MatcDocument *document;
    write_panes(panes, expected, text);
    Scene *scene = frame_scene(text, options->compile, &document);
    float *rgba = frame_floats(gl, scene, options);
    for (int i = 0; i < 4 * 16 * 16; i++)
        if (i % 4 < 3)
            off = fmax(off, isnan(rgba[i]) ? INFINITY : fabs(rgba[i] - expected[i % 4]));
    free(rgba);
    frame_forget(scene, document);
    return off;
}

static void products(void **state)
{
    (void)state;
    MatcLayout *layout;
    const MatcOptions options = frame_float_options(&layout);
    GlContext *gl = frame_context();
    for (int panes = 0; panes <= PANES_MAX; panes += 5) {
        const double off =
            panes_off(gl, panes, &(RendererOptions){.compile = &options, .view = "light"});
        print_message("%2d panes and a plane: off by %.2g\n", panes, off);
        assert_true(off <= 1e-6);
    }
    gl_close(gl);
    matc_layout_free(layout);
}

/* Products in parts of rows, some dozens, if memory is too small for all at once; and by the
 * other entry. */
static void products_in_parts(void **state)
{
    (void)state;
    MatcLayout *layout;
    const MatcOptions options = frame_float_options(&layout);
    GlContext *gl = frame_context();
    for (int i = 0; i < 2; i++) {
        const RendererOptions choice = {.compile = &options,
                                        .view = "light",
                                        .list_bytes = 100000 + 100000 * (size_t)i,
                                        .fragment = i == 1};
        const double off = panes_off(gl, PANES_MAX, &choice);
        print_message("in parts of %lu bytes: off by %.2g\n", (unsigned long)choice.list_bytes,
                      off);
        assert_true(off <= 1e-6);
    }
    gl_close(gl);
    matc_layout_free(layout);
}

/* -- what is there for it */

/* Memory of a pane as wide as the map, except three texels of 16 on each side: 144 texels in 12
 * rows see it, or only some of them. 32 bytes, 4 a texel, 16 a fragment: a row of 12 takes 288, and
 * a texel 52. */
static void capacity(void **state)
{
    (void)state;
    static const struct {
        const char *colored, *clear, *reported; /* by the graph, or of the fault */
        size_t most;
        bool old, buffer;
    } cases[] = {
        {"true", ".5", "lists of transparent fragments: 3360 bytes for 144 fragments\n", 3360,
         false, true},
        {"true", ".5", "for 144 fragments, in 2 tiles", 3359, false, true},
        {"true", ".5", "288 bytes for 144 fragments, in ", 288, false, true},
        {"true", ".5", "52 bytes for 144 fragments, in ", 52, false, true},
        {"true", ".5", "need 52 bytes for 1 fragments, but the limit is 51", 51, false, false},
        {"true", "1", "lists of transparent fragments: 1056 bytes for 0 fragments\n", 0, false,
         true},
        {"true", "0", "shadow 1 maps of 16 x 16, DEPTH32F, 1024 bytes", 0, false, false},
        {"false", ".5", "shadow 1 maps of 16 x 16, DEPTH32F, 1024 bytes", 0, false, false},
        {"true", ".5", "shadow 1 maps of 16 x 16, DEPTH32F, 1024 bytes", 0, true, false},
    };
    const MatcOptions options = frame_exact_options();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[1024];
        MatcDocument *document;
        snprintf(text, sizeof text,
                 "image: { width: 8, height: 8 }\nshadowMaps: { size: 16, colored: %s }\nlights: "
                 "[{ light: Directional "
                 "}]\nobjects:\n- { object: Parallelogram, material: { material: Phong, "
                 "transparency: %s } }\n",
                 cases[i].colored, cases[i].clear);
        Scene *scene = frame_scene(text, &options, &document);
        GlContext *gl = frame_context();
        if (cases[i].old) {
            gl->major = gl->minor = 3;
            gl->ClipControl = NULL;
        }
        char *reported = frame_graph_or_fault(gl, scene,
                                              &(RendererOptions){.compile = &options,
                                                                 .list_bytes = cases[i].most,
                                                                 .transparency = "peeling"});
        if (!strstr(reported, cases[i].reported) ||
            cases[i].buffer != (strstr(reported, "lists of transparent") != NULL))
            fail_msg("case %d: %s", (int)i, reported);
        free(reported);
        gl_close(gl);
        frame_forget(scene, document);
    }
}

/* Features that a scene or an older driver lacks are reported. */
static void lacks_are_reported(void **state)
{
    (void)state;
    static const char text[] =
        "image: { width: 8, height: 8 }\nlights: [{ light: Directional }, { light: Area, u: [1, 0, "
        "0], v: [0, 1, 0], "
        "shadows: none }]\n"
        "objects:\n- { object: Box, material: &glass { material: Phong, transparency: .5 } }\n"
        "- { object: Plane, transform: { translation: [0, 0, -3] }, material: { material: Phong, "
        "transparency: { map: "
        "Checker } } }\n";
    static const char *const reported[] = {
        "shadow no shadows from 1 area lights and 0 skies",
        "shadow no shadows of planes with varying transparency: needs OpenGL 4.3",
        "shadow transparent surfaces cast opaque shadows or none: colored shadows need OpenGL 4.3"};
    const MatcOptions options = frame_exact_options();
    for (int old = 0; old < 2; old++) {
        MatcDocument *document;
        Scene *scene = frame_scene(text, &options, &document);
        GlContext *gl = frame_context();
        if (old) {
            gl->major = gl->minor = 3;
            gl->ClipControl = NULL;
        }
        Renderer *renderer = renderer_open(gl, &(RendererOptions){.compile = &options});
        assert_true(renderer && renderer_set_scene(renderer, scene));
        char *graph = frame_graph(renderer);
        for (int i = 0; i < 3; i++)
            assert_int_equal(strstr(graph, reported[i]) != NULL, i == 0 || old);
        free(graph);
        renderer_close(renderer);
        gl_close(gl);
        frame_forget(scene, document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(products),
        cmocka_unit_test(products_in_parts),
        cmocka_unit_test(capacity),
        cmocka_unit_test(lacks_are_reported),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
