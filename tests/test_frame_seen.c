/* What a draw tells formulas, by closed forms: the direction to the viewer, of rays that meet in an eye and of parallel ones, on meshes and on planes;
 * time, when it changes, too. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { EDGE = 24 };

/* A square, or a plane, at z = 0, seen from a height of 3 with 90 degrees, or by parallel rays. */
typedef struct {
    const char *object, *camera;
    bool parallel;
} Case;
static const Case cases[] = {
    {"Box, size: [20, 20, 2], transform: { translation: [0, 0, -1] }", "Perspective, angle: 90", false},
    {"Plane", "Perspective, angle: 90", false},
    {"Box, size: [20, 20, 2], transform: { translation: [0, 0, -1] }", "Orthographic, size: 6", true},
    {"Plane", "Orthographic, size: 6", true},
};

/* The red is V.x / 2 + 1/2, green |N . V|, blue time / 8. */
static void expect(const float *rgba, const Case *c, double time)
{
    for (int i = 0; i < EDGE * EDGE; i++) {
        const double x = c->parallel ? 0 : (i % EDGE + .5) / EDGE * 2 - 1,
                     y = c->parallel ? 0 : (i / EDGE + .5) / EDGE * 2 - 1;
        const double facing = 1 / sqrt(1 + x * x + y * y), want[3] = {.5 - .5 * x * facing, facing, time / 8};
        for (int lane = 0; lane < 3; lane++)
            if (!(fabs(rgba[4 * i + lane] - want[lane]) <= 4e-6))
                fail_msg("%s, %s, pixel %d, lane %d: %g, not %g", c->object, c->camera, i, lane,
                         (double)rgba[4 * i + lane], want[lane]);
    }
}

static void drawn_as_said(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[1024];
        MatcLayout *layout;
        MatcDocument *document;
        const MatcOptions options = frame_float_options(&layout);
        snprintf(
            text, sizeof text,
            "image: { width: %d, height: %d }\n"
            "materials: { seen: { material: Phong, diffuse: 0, emissive: \"= [V.x / 2 + .5, facing, time / 8]\" } }\n"
            "objects: [{ object: %s, material: seen }]\n"
            "camera: { camera: %s, position: [0, 0, 3], target: [0, 0, 0], up: [0, 1, 0] }\n",
            EDGE, EDGE, cases[i].object, cases[i].camera);
        Scene *scene = frame_scene(text, &options, &document);
        GlContext *gl = frame_context();
        Render *render = render_open(gl, &(RenderOptions){.compile = &options, .view = "emissive"});
        scene->time = 2.5;
        float *rgba = frame_floats_by(gl, render, scene);
        expect(rgba, &cases[i], 2.5);
        scene->time = 4;
        assert_true(render_changed(render, RENDER_TIME) && render_frame(render) && render_read(render, rgba));
        expect(rgba, &cases[i], 4);
        free(rgba);
        render_close(render);
        gl_close(gl);
        frame_forget(scene, document);
        matc_layout_free(layout);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(drawn_as_said)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
