/* Patches out of view of meshes that the driver displaces, drawn under OSMesa: they get no triangles where nobody but the camera looks, and all of them elsewhere; pictures are the same, bit for bit. */
#include "tests/frame/frame_compare.h"
#include "tests/frame/frame_draw.h"
#include "runtime/frame/frame.h"
#include <stdio.h>
#include <string.h>

enum { EDGE = 64, PIXELS = EDGE * EDGE };
#define WITHOUT "{ light: Directional, direction: [1, 0.6, -1], shadows: none }"
#define GRID    "method: grid, pixels: 4, triangles: 40000"

/* A sheet that goes on behind the camera and beside it, and on which a ball stands. */
static Scene *open_scene(const char *how, const char *lights, const MatcOptions *options, MatcDocument **document)
{
    char text[2000];
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [1, -3, 2], angle: 40 }\n%s"
             "materials: { rock: { material: Phong, diffuse: 0.6, emissive: 0.2, displacementScale: 0.2, displacement: { map: VolumeTurbulence, size: 2, octaves: 3, "
             "noiseRatio: 0.5 } } }\ndisplacement: { %s }\nlights: [%s]\nobjects:\n"
             "- { object: Parallelogram, u: [24, 0, 0], v: [0, 24, 0], material: rock, transform: { translation: [-12, -12, 0] } }\n"
             "- { object: Sphere, radius: 0.5, detail: 12, material: rock, transform: { translation: [-3, -2, 1] } }\n",
             EDGE, EDGE, strstr(lights, "Hemisphere") ? "indirect: { method: voxels, bounces: 0, rays: 4, filter: none, jitter: false }\n" : "", how, lights);
    return frame_scene(text, options, document);
}

/* How many triangles are drawn, and the picture. */
static int draw(GlContext *gl, const Scene *scene, const RenderOptions *how, float light[4 * PIXELS])
{
    Render *render = render_open(gl, how);
    assert_true(render && render_scene(render, scene) && render_frame(render) && render_read(render, light));
    const int triangles = (int)render->cache.triangles;
    render_close(render);
    return triangles;
}

/* Where a light casts, or is kept off on its way, where points may go farther than the height says, or all edges have as many parts, all triangles are there. */
static void what_nobody_sees_has_no_triangles(void **state)
{
    (void)state;
    static const struct {
        const char *how, *lights;
        bool culled;
    } cases[] = {{GRID, WITHOUT, true},
                 {"method: tessellation, pixels: 4, triangles: 40000", WITHOUT, true},
                 {"method: geometry, pixels: 4, triangles: 40000", WITHOUT, true},
                 {"method: geometry, skirts: outline, pixels: 4, triangles: 40000", WITHOUT, true},
                 {"method: points, pixels: 8, triangles: 10000", WITHOUT, false},
                 {GRID ", push: 0.1", WITHOUT, false},
                 {"method: grid, level: 2", WITHOUT, false},
                 {GRID, "{ light: Directional, direction: [1, 0.6, -1], shadows: map }", false},
                 {GRID, "{ light: Point, position: [-4, -4, 4], intensity: 20, shadows: exact }", false},
                 {GRID, "{ light: Hemisphere }", false}};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        static float light[2][4 * PIXELS];
        MatcDocument *document;
        Scene *scene = open_scene(cases[i].how, cases[i].lights, &options, &document);
        int triangles[2];
        for (int whole = 0; whole < 2; whole++)
            triangles[whole] = draw(gl, scene, &(RenderOptions){.compile = &options, .view = "light", .unculled = whole}, light[whole]);
        print_message("%s: %d of %d triangles\n", cases[i].how, triangles[0], triangles[1]);
        assert_memory_equal(light[0], light[1], sizeof light[0]);
        assert_true(cases[i].culled ? triangles[0] > 1000 && triangles[0] < 0.95 * triangles[1] : triangles[0] == triangles[1]);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

/* The camera turns about itself, a little at first: each picture is that of a new renderer, with a part of the triangles. */
static void what_comes_into_view_is_there(void **state)
{
    (void)state;
    enum { TURNS = 12 };
    const MatcOptions options = frame_exact_options();
    const RenderOptions how = {.compile = &options, .view = "light"};
    static float light[2][4 * PIXELS];
    MatcDocument *document;
    GlContext *gl = frame_context();
    Scene *scene = open_scene("method: grid, pixels: 8, triangles: 40000", WITHOUT, &options, &document);
    Render *render = render_open(gl, &how);
    const int all = draw(gl, scene, &(RenderOptions){.compile = &options, .view = "light", .unculled = true}, light[0]);
    int anew = 0;
    assert_true(render && render_scene(render, scene));
    for (int turn = 0; turn < TURNS; turn++) {
        const double angle = turn * (turn < TURNS / 2 ? 0.004 : 0.5);
        scene->camera.target[0] = scene->camera.position[0] + 3 * sin(angle);
        scene->camera.target[1] = scene->camera.position[1] + 3 * cos(angle);
        assert_true(scene_camera_aim(&scene->camera) == SCENE_AIM_fine && render_changed(render, RENDER_CAMERA));
        assert_true(render_frame(render) && render_read(render, light[0]));
        const int fresh = draw(gl, scene, &how, light[1]);
        assert_memory_equal(light[0], light[1], sizeof light[0]);
        assert_true(fresh < all);
        anew += (int)render->cache.triangles == fresh;
    }
    render_close(render);
    frame_forget(scene, document);
    gl_close(gl);
    print_message("%d of %d turns have no triangle more than a new renderer\n", anew, TURNS);
    assert_true(anew >= 2 && anew < TURNS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_nobody_sees_has_no_triangles),
        cmocka_unit_test(what_comes_into_view_is_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
