/* Culling of patches outside the view for meshes that the driver displaces, drawn under OSMesa:
 * a patch gets no triangles if only the camera sees it and its shadow cannot come into view, and
 * all of them otherwise; pictures are equal bit for bit. */
/* ctest: seconds=23 */
#include "tests/frame/frame_compare.h"
#include "tests/frame/frame_draw.h"
#include "runtime/frame_graph/frame.h"
#include <limits.h>
#include <stdio.h>
#include <string.h>

enum { EDGE = 64, PIXELS = EDGE * EDGE };
#define WITHOUT "{ light: Directional, direction: [1, 0.6, -1], shadows: none }"
#define GRID    "method: grid, pixels: 4, triangles: 40000"

/* A sheet that extends behind and next to the camera, with a ball on it. */
static Scene *open_scene(const char *how, const char *lights, const MatcOptions *options,
                         MatcDocument **document)
{
    char text[2000];
    snprintf(
        text, sizeof text,
        "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [1, -3, 2], "
        "angle: 40 }\n%s"
        "materials: { rock: { material: Phong, diffuse: 0.6, emissive: 0.2, displacementScale: "
        "0.2, displacement: { map: VolumeTurbulence, size: 2, octaves: 3, "
        "noiseRatio: 0.5 } } }\ndisplacement: { %s }\nlights: [%s]\nobjects:\n"
        "- { object: Parallelogram, u: [24, 0, 0], v: [0, 24, 0], material: rock, transform: { "
        "translation: [-12, -12, 0] } }\n"
        "- { object: Sphere, radius: 0.5, detail: 12, material: rock, transform: { translation: "
        "[-3, -2, 1] } }\n",
        EDGE, EDGE,
        strstr(lights, "Hemisphere")
            ? "indirect: { method: voxels, bounces: 0, rays: 4, filter: none, jitter: false }\n"
            : "",
        how, lights);
    return frame_scene(text, options, document);
}

/* Draws a picture, and returns the number of triangles. */
static int draw(GlContext *gl, const Scene *scene, const RendererOptions *how,
                float light[4 * PIXELS])
{
    Renderer *renderer = renderer_open(gl, how);
    assert_true(renderer && renderer_set_scene(renderer, scene) && renderer_frame(renderer) &&
                renderer_read(renderer, light));
    const int triangles = (int)renderer->gpu_scene.triangles;
    renderer_close(renderer);
    return triangles;
}

/* All triangles are drawn if a light's shadows do not come from maps, or its light passes
 * transparent surfaces, if points may move farther than the height's bound, or if all edges have
 * equally many segments. */
static void what_nobody_sees_has_no_triangles(void **state)
{
    (void)state;
    static const struct {
        const char *how, *lights;
        double most; /* max share of all triangles; 1: all */
    } cases[] = {
        {GRID, WITHOUT, 0.95},
        {"method: tessellation, pixels: 4, triangles: 40000", WITHOUT, 0.95},
        {"method: geometry, pixels: 4, triangles: 40000", WITHOUT, 0.95},
        {"method: geometry, skirts: outline, pixels: 4, triangles: 40000", WITHOUT, 0.95},
        {"method: points, pixels: 8, triangles: 10000", WITHOUT, 1},
        {GRID ", push: 0.1", WITHOUT, 1},
        {"method: grid, level: 2", WITHOUT, 1},
        {GRID, "{ light: Directional, direction: [1, 0.6, -1], shadows: map }", 0.99},
        {GRID, "{ light: Directional, direction: [0.2, 1, -0.05], shadows: map }", 0.99},
        {GRID, "{ light: Point, position: [-4, -4, 4], intensity: 20, shadows: map }", 0.99},
        {GRID,
         "{ light: Spot, position: [-3, -9, 1.5], direction: [0.6, 1, -0.15], intensity: 90, "
         "shadows: map }",
         0.99},
        {GRID,
         "{ light: Directional, direction: [1, 0.6, -1], shadows: map }, { light: Point, position: "
         "[-4, -4, 4], intensity: 20, shadows: exact }",
         1},
        {GRID, "{ light: Area, position: [-4, -4, 4], u: [0, 1, 0], v: [1, 0, 0], intensity: 20 }",
         1},
        {GRID, "{ light: Point, position: [-4, -4, 4], intensity: 20, shadows: exact }", 1},
        {GRID, "{ light: Hemisphere }", 1}};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        static float light[2][4 * PIXELS];
        MatcDocument *document;
        Scene *scene = open_scene(cases[i].how, cases[i].lights, &options, &document);
        int triangles[2];
        for (int whole = 0; whole < 2; whole++)
            triangles[whole] =
                draw(gl, scene,
                     &(RendererOptions){.compile = &options, .view = "light", .unculled = whole},
                     light[whole]);
        print_message("%s, %s: %d of %d triangles\n", cases[i].how, cases[i].lights, triangles[0],
                      triangles[1]);
        assert_memory_equal(light[0], light[1], sizeof light[0]);
        assert_true(cases[i].most < 1
                        ? triangles[0] > 1000 && triangles[0] < cases[i].most * triangles[1]
                        : triangles[0] == triangles[1]);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

/* The camera rotates in place, slightly at first: each picture equals that of a new renderer,
 * with a part of the triangles. */
static void turn_under(const char *lights)
{
    enum { TURNS = 12 };
    const MatcOptions options = frame_exact_options();
    const RendererOptions how = {.compile = &options, .view = "light"};
    static float light[2][4 * PIXELS];
    MatcDocument *document;
    GlContext *gl = frame_context();
    Scene *scene =
        open_scene("method: grid, pixels: 8, triangles: 40000", lights, &options, &document);
    Renderer *renderer = renderer_open(gl, &how);
    const int all =
        draw(gl, scene, &(RendererOptions){.compile = &options, .view = "light", .unculled = true},
             light[0]);
    int anew = 0;
    assert_true(renderer && renderer_set_scene(renderer, scene));
    for (int turn = 0; turn < TURNS; turn++) {
        const double angle = turn * (turn < TURNS / 2 ? 0.004 : 0.5);
        scene->camera.target[0] = scene->camera.position[0] + 3 * sin(angle);
        scene->camera.target[1] = scene->camera.position[1] + 3 * cos(angle);
        assert_true(scene_camera_aim(&scene->camera) == SCENE_AIM_fine &&
                    renderer_changed(renderer, RENDERER_CAMERA));
        assert_true(renderer_frame(renderer) && renderer_read(renderer, light[0]));
        const int fresh = draw(gl, scene, &how, light[1]);
        assert_memory_equal(light[0], light[1], sizeof light[0]);
        assert_true(fresh < all);
        anew += (int)renderer->gpu_scene.triangles == fresh;
    }
    renderer_close(renderer);
    frame_forget(scene, document);
    gl_close(gl);
    print_message("%d of %d turns have no triangle more than a new renderer\n", anew, TURNS);
    assert_true(anew >= 2 && anew < TURNS);
}

static void what_comes_into_view_is_there(void **state)
{
    (void)state;
    turn_under(WITHOUT);
    turn_under("{ light: Directional, direction: [1, 0.6, -1], shadows: map }");
}

/* A lamp circles around the objects, so that shadows come from different sides. */
static void what_a_light_shows_is_there(void **state)
{
    (void)state;
    enum { STEPS = 8 };
    const MatcOptions options = frame_exact_options();
    const RendererOptions how = {.compile = &options, .view = "light"};
    static float light[2][4 * PIXELS];
    MatcDocument *document;
    GlContext *gl = frame_context();
    Scene *scene =
        open_scene(GRID, "{ light: Point, position: [-9, -9, 1.2], intensity: 50, shadows: map }",
                   &options, &document);
    Renderer *renderer = renderer_open(gl, &how);
    int anew = 0, least = INT_MAX, most = 0;
    assert_true(renderer && renderer_set_scene(renderer, scene));
    for (int step = 0; step < STEPS; step++) {
        const double angle = step * 6.283 / STEPS;
        scene->lights[0].position[0] = 9 * cos(angle);
        scene->lights[0].position[1] = 9 * sin(angle);
        assert_true(renderer_changed(renderer, RENDERER_LIGHTS) && renderer_frame(renderer) &&
                    renderer_read(renderer, light[0]));
        const int fresh = draw(gl, scene, &how, light[1]);
        assert_memory_equal(light[0], light[1], sizeof light[0]);
        anew += (int)renderer->gpu_scene.triangles == fresh;
        least = fresh < least ? fresh : least;
        most = fresh > most ? fresh : most;
    }
    renderer_close(renderer);
    frame_forget(scene, document);
    gl_close(gl);
    print_message("%d of %d lamps have no triangle more than a new renderer, which has %d to %d\n",
                  anew, STEPS, least, most);
    assert_true(anew >= 2 && least < most);
}

/* Balls float over a plane: the camera sees only the plane and the shadows on it. Exactly the
 * triangles that a light's shadows need are drawn. */
static void what_falls_on_a_plane_is_there(void **state)
{
    (void)state;
    static const struct {
        const char *light, *plane;
        int kept; /* triangles, of 960 of two balls */
    } cases[] = {
        {"{ light: Directional, direction: [0.6, 0, -1], shadows: map }", "", 480},
        {"{ light: Directional, direction: [-0.6, 0.1, 1], shadows: map }", "", 0},
        {"{ light: Point, position: [-2.5, 0, 9], intensity: 300, shadows: map }", "", 480},
        {"{ light: Spot, position: [-2.5, 0, 9], direction: [0.5, 0, -1], outerAngle: 40, "
         "intensity: 300, shadows: map }",
         "rotation: [0.05, -0.1, 0], ", 480},
        {"{ light: Point, position: [-2.5, 0, -9], intensity: 300, shadows: map }", "", 0},
        {"{ light: Directional, direction: [1, 0, 0], shadows: map }", "", 960},
        {"{ light: Point, position: [-2.5, 0, 1], intensity: 300, shadows: map }", "", 0}};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        static float light[2][4 * PIXELS];
        MatcDocument *document;
        char text[2000];
        int triangles[2], dark = 0;
        snprintf(text, sizeof text,
                 "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [3, "
                 "-4, -1.5], target: [3, 0, -4], angle: 50 }\n"
                 "materials: { rock: { material: Phong, diffuse: 0.6, displacementScale: 0.1, "
                 "displacement: { map: VolumeTurbulence, size: 1 } }, floor: { material: Phong, "
                 "diffuse: 0.8 } }\n"
                 "displacement: { " GRID " }\nlights: [%s]\nobjects:\n- { object: Plane, material: "
                 "floor, transform: { %stranslation: [0, 0, -4] } }\n"
                 "- { object: Sphere, radius: 0.7, detail: 12, material: rock, transform: { "
                 "translation: [0, 0, 4] } }\n"
                 "- { object: Sphere, radius: 0.7, detail: 12, material: rock, transform: { "
                 "translation: [-9, 3, 4] } }\n",
                 EDGE, EDGE, cases[i].light, cases[i].plane);
        Scene *scene = frame_scene(text, &options, &document);
        for (int whole = 0; whole < 2; whole++)
            triangles[whole] =
                draw(gl, scene,
                     &(RendererOptions){.compile = &options, .view = "light", .unculled = whole},
                     light[whole]);
        for (int k = 0; k < PIXELS; k++)
            dark += light[1][4 * k] == 0;
        print_message("%s: %d of %d triangles, %d pixels of the plane are dark\n", cases[i].light,
                      triangles[0], triangles[1], dark);
        assert_memory_equal(light[0], light[1], sizeof light[0]);
        assert_int_equal(triangles[0], cases[i].kept);
        /* a shadow is there */
        assert_true(triangles[1] == 960 &&
                    (cases[i].kept != 480 || (dark > 100 && dark < PIXELS / 2)));
        frame_forget(scene, document);
    }
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_nobody_sees_has_no_triangles),
        cmocka_unit_test(what_falls_on_a_plane_is_there),
        cmocka_unit_test(what_comes_into_view_is_there),
        cmocka_unit_test(what_a_light_shows_is_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
