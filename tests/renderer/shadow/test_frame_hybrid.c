/* Hybrid shadows against Embree's rays for each kind of light and volume, outside of a stated
 * band around shadow boundaries; a boundary by its closed form; data paths against each other,
 * bit for bit; flipped diagonals against distances from planes. */
/* ctest: unsanitized */
#include "tests/test.h"
#include "gen/render_text.h"
#include "runtime/gpu_material/screen_pass.h"
#include "runtime/renderer/renderer.h"
#include "tests/frame/frame_calls.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/shadow_band.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static GlKind kind; /* of the driver that draws: `test_frame_hybrid egl` has a GPU judged */

enum { WIDTH = 120, HEIGHT = 90, PIXELS = WIDTH * HEIGHT, SIZE = 256 };

#define SEEN_BY(camera)                                                                            \
    "image: { width: 120, height: 90 }\ncamera: { camera: " camera                                 \
    " }\nmaterials: { m: { material: Phong, diffuse: .5 } }\n"
#define ORTHOGRAPHIC                                                                               \
    SEEN_BY("Orthographic, position: [-1, -6, 5], target: [0, 0, .5], size: 5.5, depth: 12.5")
#define LEVEL SEEN_BY("Perspective, position: [0, -7, 1.5], target: [0, 0, 1.5], angle: 42")
#define VIEW  SEEN_BY("Perspective, position: [1.5, -7, 4], target: [0, 0, .5], angle: 42")
/* Closed meshes, as hybrid shadows require; one is mirrored, one above the light of a lamp at
 * the origin's height. */
#define OBJECTS                                                                                    \
    "objects:\n- { object: Plane, material: m }\n"                                                 \
    "- { object: Sphere, radius: .8, material: m, transform: { translation: [-.6, -.4, 1.2] } }\n" \
    "- { object: Box, material: m, transform: { translation: [1, .5, .5], rotation: [0, 0, .3], "  \
    "scale: [-1, 1, 1] } "                                                                         \
    "}\n"                                                                                          \
    "- { object: Cylinder, radius: .3, height: .8, material: m, transform: { translation: [.6, "   \
    "-1.4, 0] } }\n"                                                                               \
    "- { object: Cone, radius: .3, height: .6, material: m, transform: { translation: [.6, -1.4, " \
    "1] } }\n"                                                                                     \
    "- { object: Box, size: [.3, 1.5, .3], material: m, transform: { translation: [-1.9, -.8, "    \
    ".9], rotation: [.4, 0, "                                                                      \
    ".3] } }\n"

/* Share of the light that arrives at each pixel; -1 where none would without shadows. From
 * malloc. */
static float *shares_of(GlContext *gl, Scene *scene, const MatcOptions *options)
{
    float *with = frame_floats(gl, scene, &(RendererOptions){.compile = options, .view = "light"});
    float *without = frame_floats(
        gl, scene, &(RendererOptions){.compile = options, .view = "light", .no_shadows = true});
    for (int i = 0; i < PIXELS; i++)
        with[i] = without[4 * i] > 1e-7f ? with[4 * i] / without[4 * i] : -1;
    free(without);
    return with;
}

/* -- against rays */

typedef struct {
    const char *light;
    double reach; /* directional: of the map, about; else of a map's edge at distance 1 */
    const char *volume;
    double band; /* texels */
    const char *view;
} Case;

typedef struct {
    int lit, dark, band, wrong;
} Count;

static int expected(const Tracer *tracer, const Hit *hit, const Case *c)
{
    const SceneLight *light = &tracer->scene->lights[0];
    double way[3];
    const double distance = shadow_way_to(light, hit->world, way);
    return shadow_band_expected(
        tracer, hit, c->band * c->reach * (light->kind == SCENE_Directional ? 1 : distance) / SIZE);
}

static void add(const Tracer *tracer, const Case *c, int pixel, double share, Count *count)
{
    const Ray ray = reference_ray(tracer->scene, pixel % WIDTH + .5, pixel / WIDTH + .5);
    const Hit hit = reference_hit(tracer, &ray, 0);
    double way[3];
    if (hit.object < 0 || reference_is_edge(tracer, pixel % WIDTH, pixel / WIDTH, &hit, 1))
        return;
    shadow_way_to(&tracer->scene->lights[0], hit.world, way);
    if (reference_dot(way, hit.microfacet) <= .05 * sqrt(reference_dot(way, way)) ||
        reference_dot(way, hit.normal) <= 0)
        return; /* at the terminator of what is not smooth */
    const int lit = expected(tracer, &hit, c);
    count->band += lit < 0;
    count->lit += lit == 1;
    count->dark += lit == 0;
    count->wrong += lit >= 0 && fabs(share - lit) > 1e-3;
}

static Count compare(GlContext *gl, const Case *c)
{
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    char text[4096];
    Count count = {0};
    snprintf(text, sizeof text,
             "%sshadowMaps: { size: %d, volume: %s }\nlights: [{ light: %s, shadows: hybrid "
             "}]\n" OBJECTS,
             c->view, SIZE, c->volume, c->light);
    Scene *scene = frame_scene(text, &options, &document);
    float *shares = shares_of(gl, scene, &options);
    Tracer tracer = reference_open(scene);
    for (int i = 0; i < PIXELS; i++)
        if (shares[i] >= 0)
            add(&tracer, c, i, shares[i], &count);
    reference_close(&tracer);
    free(shares);
    frame_forget(scene, document);
    return count;
}

#define LIGHTS(volume, band)                                                                       \
    {"Directional, direction: [1, .2, -.15]", 5, volume, band, VIEW},                              \
        {"Spot, position: [-2, -4, 5], direction: [2, 4, -5], innerAngle: 25, outerAngle: 30",     \
         1.2, volume, band, VIEW},                                                                 \
    {                                                                                              \
        "Point, position: [0, .6, 1.1]", 2, volume, band, VIEW                                     \
    }

/* The volume's walls are up to a texel off, and a texel's depth holds within half a texel of its
 * center; means reach two texels further. */
static void rays(void **state)
{
    (void)state;
    static const Case cases[] = {
        LIGHTS("plain", 2.5),
        LIGHTS("perfect", 2.5),
        LIGHTS("blurred", 5),
        LIGHTS("silhouette", 1),
        {"Directional, direction: [.5, .6, -1]", 4.5, "perfect", 2.5, VIEW},
        {"Spot, position: [-.2, -1.3, 2.6], innerAngle: 80, outerAngle: 100", 2, "perfect", 2.5,
         VIEW},
        /* the camera looks as some of their rays go, or across them; walls go on beyond its
         * farthest */
        {"Directional, direction: [1, .2, -.15]", 5, "perfect", 2.5, ORTHOGRAPHIC},
        {"Spot, position: [-2, -4, 5], direction: [2, 4, -5], innerAngle: 25, outerAngle: 30", 1.2,
         "perfect", 2.5, ORTHOGRAPHIC},
        {"Point, position: [0, .6, 1.1]", 2, "plain", 2.5, ORTHOGRAPHIC},
        {"Directional", 4.5, "perfect", 2.5, LEVEL},
        {"Spot, position: [-.2, -1.3, 2.6], innerAngle: 80, outerAngle: 100", 2, "silhouette", 1,
         VIEW}};
    GlContext *gl = frame_context_of(kind);
    int wrong = 0, lit = 0, dark = 0;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const Count count = compare(gl, &cases[i]);
        print_message("%-8s %-40.40s %5d lit, %4d dark, %4d in bands: %d wrong\n", cases[i].volume,
                      cases[i].light, count.lit, count.dark, count.band, count.wrong);
        wrong += count.wrong, lit += count.lit, dark += count.dark;
    }
    gl_close(gl);
    assert_true(lit > 40000 && dark > 10000);
    assert_int_equal(wrong, 0);
}

/* -- a shadow's end */

/* Light from above onto a box whose edge is 1: the map is fitted to it, 2 (filter + 2) texels
 * wider. The shadow ends at the outermost center of a texel that the box covers, or, stretched,
 * where that center is taken to be. */
static double end_of_shadow(bool stretched)
{
    const double half = .5 * (1 + 6.0 / SIZE);
    double end = 0;
    for (int i = 0; i < SIZE; i++) {
        const double centre = half * ((2 * i + 1.0) / SIZE - 1);
        if (fabs(centre) < .5)
            end = fmax(end, stretched ? half * (2.0 * i / (SIZE - 1) - 1) : centre);
    }
    return end;
}

/* A picture of one edge: its 120 pixels are 2.4 texels. Means are not 0 for two texels more, so
 * blurred volumes end so much later. */
#define EDGE_VIEW                                                                                  \
    "image: { width: 120, height: 90 }\ncamera: { camera: Perspective, position: [3, 0, 1], "      \
    "target: [.5, 0, 0], "                                                                         \
    "angle: "                                                                                      \
    ".15 }\nmaterials: { m: { material: Phong, diffuse: .5 } }\nlights: [{ light: Directional, "   \
    "shadows: hybrid }]\n"                                                                         \
    "objects:\n- { object: Plane, material: m }\n- { object: Box, material: m, transform: { "      \
    "translation: [0, 0, 3] } "                                                                    \
    "}\n"

static void end_is_at(GlContext *gl, const char *volume, bool stretched, double end)
{
    const MatcOptions options = frame_exact_options();
    char text[2048];
    MatcDocument *document;
    int wrong = 0, dark = 0;
    snprintf(text, sizeof text, EDGE_VIEW "shadowMaps: { size: %d, volume: %s, stretched: %s }\n",
             SIZE, volume, stretched ? "true" : "false");
    Scene *scene = frame_scene(text, &options, &document);
    float *shares = shares_of(gl, scene, &options);
    Tracer tracer = reference_open(scene);
    for (int i = 0; i < PIXELS; i++) {
        const Ray ray = reference_ray(scene, i % WIDTH + .5, i / WIDTH + .5);
        const Hit hit = reference_hit(&tracer, &ray, 0);
        dark += shares[i] < .5f;
        wrong += fabs(hit.world[0] - end) > .01 / SIZE && (shares[i] < .5f) != (hit.world[0] < end);
    }
    print_message("%s%s: %d dark, %d wrong\n", volume, stretched ? ", stretched" : "", dark, wrong);
    assert_true(dark > 1000 && dark < PIXELS - 500);
    assert_int_equal(wrong, 0);
    reference_close(&tracer);
    free(shares);
    frame_forget(scene, document);
}

static void ends(void **state)
{
    (void)state;
    const double texel = (1 + 6.0 / SIZE) / SIZE;
    GlContext *gl = frame_context_of(kind);
    for (int stretched = 0; stretched < 2; stretched++) {
        end_is_at(gl, "plain", stretched, end_of_shadow(stretched));
        end_is_at(gl, "perfect", stretched, end_of_shadow(stretched));
        if (!stretched)
            end_is_at(gl, "silhouette", false, .5);
        end_is_at(gl, "blurred", stretched,
                  end_of_shadow(stretched) + 2 * texel * (stretched ? SIZE / (SIZE - 1.0) : 1));
    }
    gl_close(gl);
}

/* -- diagonals */

/* Distance from the plane of the other three corners, in double; the quad's edges are 1 long. */
static double distance_of(const double z[4], int corner)
{
    static const double x[4] = {0, 1, 1, 0}, y[4] = {0, 0, 1, 1};
    const int a = (corner + 1) % 4, b = (corner + 2) % 4, c = (corner + 3) % 4;
    const double u[3] = {x[a] - x[b], y[a] - y[b], z[a] - z[b]},
                 v[3] = {x[c] - x[b], y[c] - y[b], z[c] - z[b]};
    const double n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                         u[0] * v[1] - u[1] * v[0]};
    const double p[3] = {x[corner] - x[b], y[corner] - y[b], z[corner] - z[b]};
    return fabs(n[0] * p[0] + n[1] * p[1] + n[2] * p[2]) /
           sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
}

static bool is_turned(const double z[4])
{
    double far[4];
    for (int i = 0; i < 4; i++)
        far[i] = distance_of(z, i);
    return (far[1] > far[0] && far[1] > far[2]) || (far[3] > far[0] && far[3] > far[2]);
}

/* All quads of four depths from 0 to 7, which are exact: 4096, one pixel each. */
static void diagonals(void **state)
{
    (void)state;
    enum { EDGE = 64 };
    static const char body[] =
        "vec4 passPixel(ivec2 pixel)\n{\n    int number = pixel.y * 64 + pixel.x;\n"
        "    return vec4(volumeTurned(vec4(number & 7, number >> 3 & 7, number >> 6 & 7, number >> "
        "9)));\n}\n";
    GlContext *gl = frame_context_of(kind);
    Store *store = store_new(gl);
    ScreenPass pass;
    Screen screen;
    Framebuffer target;
    int turned = 0;
    const ScreenPassText text = {.body = {render_text_shadow_volume, body}, .format = "RGBA32F"};
    assert_true(store && screen_make(gl, &screen) && screen_pass_make(store, &text, &pass));
    assert_true(
        framebuffer_make(gl, &(FramebufferSpec){EDGE, EDGE, 1, GL_RGBA32F, false}, &target));
    float *pixels = malloc(4 * sizeof *pixels * EDGE * EDGE);
    screen_pass_run(&pass, &target, &screen);
    assert_true(framebuffer_read(gl, &target, 0, pixels));
    for (int i = 0; i < EDGE * EDGE; i++) {
        const double z[4] = {i & 7, i >> 3 & 7, i >> 6 & 7, i >> 9};
        const double a = distance_of(z, 0), b = distance_of(z, 1), c = distance_of(z, 2),
                     d = distance_of(z, 3);
        if (fmin(fmin(fabs(b - a), fabs(b - c)), fmin(fabs(d - a), fabs(d - c))) < 1e-12 &&
            a + b + c + d > 0)
            continue; /* equal but for rounding */
        assert_int_equal(pixels[4 * i] > .5f, is_turned(z));
        turned += is_turned(z);
    }
    print_message("%d of 4096 turned\n", turned);
    assert_true(turned > 400);
    free(pixels);
    framebuffer_delete(gl, &target);
    screen_pass_delete(&pass);
    screen_delete(gl, &screen);
    store_free(store);
    gl_close(gl);
}

/* A moved box changes the fit of the map: a frame then equals that of a new renderer, bit for
 * bit. */
static void changes(void **state)
{
    (void)state;
    static const char *const lights[] = {"Directional, direction: [1, .2, -.6]",
                                         "Point, position: [0, .6, 1.1]"};
    const MatcOptions options = frame_exact_options();
    const RendererOptions how = {.compile = &options, .view = "light"};
    GlContext *gl = frame_context_of(kind);
    for (int k = 0; k < 2; k++) {
        char text[4096];
        MatcDocument *document;
        snprintf(text, sizeof text,
                 VIEW
                 "shadowMaps: { size: 64 }\nlights: [{ light: %s, shadows: hybrid }]\n" OBJECTS,
                 lights[k]);
        Scene *scene = frame_scene(text, &options, &document);
        Renderer *renderer = renderer_open(gl, &how);
        float *changed = malloc(4 * sizeof *changed * PIXELS);
        assert_true(renderer && renderer_set_scene(renderer, scene) && renderer_frame(renderer));
        scene->objects[scene->object_count - 1].world_from_local.m[12] -= .7;
        assert_true(renderer_changed_objects(renderer, scene->object_count - 1, 1) &&
                    renderer_frame(renderer) && renderer_read(renderer, changed));
        renderer_close(renderer);
        float *anew = frame_floats(gl, scene, &how);
        assert_memory_equal(changed, anew, 4 * sizeof *anew * PIXELS);
        free(anew);
        free(changed);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

/* Two frames of three lights, between which a box moves, into floats; a further frame writes to no
 * buffer and makes none. */
static void draw_path(GlContext *gl, const char *volume, const char *path, float *frames)
{
    const MatcOptions options = frame_exact_options();
    const RendererOptions how = {.compile = &options, .view = "light"};
    MatcDocument *document;
    char text[4096];
    snprintf(text, sizeof text,
             VIEW "shadowMaps: { size: 48, volume: %s, path: %s }\nlights:\n"
                  "- { light: Directional, direction: [1, .2, -.6], shadows: hybrid }\n"
                  "- { light: Point, position: [-3, -2, 3], shadows: map }\n"
                  "- { light: Spot, position: [-2, -4, 5], direction: [2, 4, -5], intensity: 40, "
                  "shadows: hybrid }\n"
                  "- { light: Point, position: [0, .6, 1.1], shadows: hybrid }\n" OBJECTS,
             volume, path);
    Scene *scene = frame_scene(text, &options, &document);
    Renderer *renderer = renderer_open(gl, &how);
    assert_true(renderer && renderer_set_scene(renderer, scene) && renderer_frame(renderer) &&
                renderer_read(renderer, frames));
    scene->objects[scene->object_count - 1].world_from_local.m[12] += 1.1;
    assert_true(renderer_changed_objects(renderer, scene->object_count - 1, 1) &&
                renderer_frame(renderer) && renderer_read(renderer, frames + 4 * PIXELS));
    frame_calls = (FrameCalls){0};
    assert_true(renderer_frame(renderer));
    assert_int_equal(frame_calls.made + frame_calls.written, 0);
    renderer_close(renderer);
    frame_forget(scene, document);
}

/* All data paths draw the same, bit for bit, also after a move. */
static void paths(void **state)
{
    (void)state;
    static const char *const volumes[] = {"plain", "blurred", "perfect"}, *const ways[] = {
                                                                              "copy", "compute",
                                                                              "auto"};
    const size_t floats = 2 * 4 * PIXELS;
    GlContext *gl = frame_context_of(kind);
    frame_count_calls(gl);
    float *fetched = malloc(2 * floats * sizeof *fetched), *others = fetched + floats;
    for (int volume = 0; volume < 3; volume++) {
        draw_path(gl, volumes[volume], "fetch", fetched);
        assert_memory_not_equal(fetched, fetched + floats / 2, floats / 2 * sizeof *fetched);
        for (int way = 0; way < 3; way++) {
            draw_path(gl, volumes[volume], ways[way], others);
            assert_memory_equal(others, fetched, floats * sizeof *fetched);
        }
    }
    free(fetched);
    gl_close(gl);
}

/* Nine lights take a second component of the mask: the last alone keeps its own shadows. 33 are
 * refused. */
static void many_lights(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context_of(kind);
    for (int count = 9; count <= 33; count += 24) {
        char text[8192];
        MatcDocument *document;
        int size = snprintf(text, sizeof text, VIEW "shadowMaps: { size: 64 }\nlights:\n");
        for (int i = 0; i < count; i++)
            size += snprintf(text + size, sizeof text - (size_t)size,
                             "- { light: Directional, direction: [%d, .2, -.6], intensity: %d, "
                             "shadows: hybrid }\n",
                             i < count - 1 ? -1 : 1, i == count - 1);
        snprintf(text + size, sizeof text - (size_t)size, OBJECTS);
        Scene *scene = frame_scene(text, &options, &document);
        if (count == 9) {
            float *nine =
                frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
            scene->lights[0] = scene->lights[count - 1];
            scene->light_count = 1;
            float *one =
                frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
            for (int i = 0; i < 4 * PIXELS; i++)
                assert_true(fabsf(nine[i] - one[i]) <= 1e-6f);
            free(nine);
            free(one);
        } else {
            Renderer *renderer = renderer_open(gl, &(RendererOptions){.compile = &options});
            assert_false(renderer_set_scene(renderer, scene));
            assert_string_equal(gl->error, "33 lights cast hybrid shadows, more than 32");
            renderer_close(renderer);
        }
        frame_forget(scene, document);
    }
    gl_close(gl);
}

int main(int argc, char **argv)
{
    kind = frame_kind(argc, argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(rays),      cmocka_unit_test(ends),
                                       cmocka_unit_test(diagonals), cmocka_unit_test(changes),
                                       cmocka_unit_test(paths),     cmocka_unit_test(many_lights)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
