/* Meshes that the driver displaces, drawn under OSMesa: their points against the C reference for
 * displaced meshes; closed meshes have no hole where tessellation levels meet, edges are hard or
 * texture coordinates have a seam; pictures, shadows and changes against those of displaced
 * meshes. */
/* ctest: unsanitized */
#include "runtime/tessellate/scene_displace.h"
#include "tests/frame/frame_compare.h"
#include "tests/frame/frame_draw.h"
#include "runtime/scene/scene_patches.h"
#include <stdio.h>
#include <string.h>

enum { EDGE = 64, PIXELS = EDGE * EDGE, VIEWS = 8, LEVEL = 6 };

#define MATERIALS                                                                                  \
    "materials:\n"                                                                                 \
    "  rock: { material: Phong, diffuse: 0.6, emissive: 0.2, displacementScale: { param: height, " \
    "default: 0.2 },\n"                                                                            \
    "    displacementBound: 0.3, displacement: { map: VolumeTurbulence, size: 2, octaves: 3, "     \
    "noiseRatio: 0.5 } }\n"                                                                        \
    "  tiles: { material: Phong, diffuse: [0.7, 0.4, 0.2], emissive: 0.2, displacementScale: "     \
    "0.1,\n"                                                                                       \
    "    displacement: { map: Checker, input: { map: UVTransform, scaleU: 5.3, scaleV: 4.1 } } "   \
    "}\n"                                                                                          \
    "  leaning: { material: Phong, diffuse: 0.8, emissive: 0.2, displacementVector: { map: "       \
    "Blend, input: { map: "                                                                        \
    "Gradient, direction: "                                                                        \
    "[2, 3, 1], waveForm: Sin }, blend: [{ value: -1, input: [0.1, 0, -0.1] }, { value: 1, "       \
    "input: [-0.1, 0.1, 0.2] "                                                                     \
    "}] } }\n"                                                                                     \
    "  pane: { material: Phong, diffuse: 0.3, emissive: 0.2, transparency: 0.5, "                  \
    "displacementScale: 0.25,\n"                                                                   \
    "    displacement: { map: Gradient, direction: [3, 5, 2], waveForm: Sin } }\n"                 \
    "  floor: { material: Phong, diffuse: 0.6, emissive: 0.2 }\n"
static const char *const bodies[] = {
    "- { object: Box, size: [1.4, 1.4, 1.4], material: rock, transform: { rotation: [0.3, 0.5, "
    "0.1] } }\n",
    "- { object: Sphere, radius: 0.9, material: tiles, detail: 12 }\n",
    "- { object: Cylinder, radius: 0.6, height: 1.2, detail: 12, material: leaning, transform: { "
    "translation: [0, 0, "
    "-0.6] } }\n",
    "- { object: Cone, radius: 0.8, height: 1.5, detail: 12, material: rock, transform: { "
    "translation: [0, 0, -0.5], "
    "rotation: [2, 0, 0], scale: [1, 1.2, 0.8] } }\n",
};
static const char *const methods[] = {"grid", "tessellation"};
enum { BODIES = sizeof bodies / sizeof *bodies, METHODS = sizeof methods / sizeof *methods };

typedef struct {
    const char *how, *lights, *objects;
} SceneText;

static Scene *open_scene(const SceneText *of, const MatcOptions *options, MatcDocument **document)
{
    char text[4000];
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [1, -3, "
             "2], angle: 40 }\n" MATERIALS "displacement: { %s }\nlights:\n%s\nobjects:\n%s",
             EDGE, EDGE, of->how, of->lights, of->objects);
    return frame_scene(text, options, document);
}

/* Enables edge coverage, which captures the triangles. */
static RendererOptions with_triangles(const MatcOptions *options)
{
    return (RendererOptions){.compile = options, .view = "light", .edges = RENDERER_EDGES_coverage};
}

static const Shape *shape_of(const Scene *scene)
{
    return &scene->meshes[scene->objects[0].mesh].shape;
}

static double apart(const float a[3], const float b[3])
{
    double sum = 0;
    for (int i = 0; i < 3; i++)
        sum += ((double)a[i] - (double)b[i]) * ((double)a[i] - (double)b[i]);
    return sqrt(sum);
}

/* Distance of a point from the nearest point of a mesh with the same base point. */
static double nearest(const Shape *shape, const float position[3], const float base[3])
{
    double least = INFINITY;
    for (int i = 0; i < shape->vertex_count; i++)
        if (apart(shape->base[i], base) < 1e-5)
            least = fmin(least, apart(shape->vertices[i].position, position));
    return least;
}

/* The grid has the points of a mesh of equal level; displacement directions along an edge are
 * mixed before normalization. */
static void points_are_those_of_the_reference(void **state)
{
    (void)state;
    static const double bounds[BODIES] = {1e-6, 1e-6, 5e-3, 1.2e-2};
    const MatcOptions options = frame_exact_options();
    const RendererOptions draw = with_triangles(&options);
    GlContext *gl = frame_context();
    for (int body = 0; body < BODIES; body++) {
        char how[80];
        MatcDocument *documents[2];
        Scene *scenes[2];
        double worst = 0;
        for (int i = 0; i < 2; i++) {
            snprintf(how, sizeof how, "method: %s, level: %d", i ? "grid" : "mesh", LEVEL);
            scenes[i] = open_scene(&(SceneText){how, " []", bodies[body]}, &options, &documents[i]);
            free(frame_floats(gl, scenes[i], &draw));
        }
        const Shape *shape = shape_of(scenes[1]);
        assert_true(shape->base &&
                    /* without those at poles */
                    shape->index_count > shape_of(scenes[0])->index_count / 2);
        for (int i = 0; i < shape->vertex_count; i++)
            worst = fmax(worst,
                         nearest(shape_of(scenes[0]), shape->vertices[i].position, shape->base[i]));
        print_message("body %d: %d points, off by %.2g\n", body, shape->vertex_count, worst);
        assert_true(worst < bounds[body]);
        for (int i = 0; i < 2; i++)
            frame_forget(scenes[i], documents[i]);
    }
    gl_close(gl);
}

static void look_from(Scene *scene, int view, double distance)
{
    const double z = 1 - (2 * view + 1.) / VIEWS, turn = 2.399963229728653 * view,
                 r = sqrt(1 - z * z), way[3] = {r * cos(turn), r * sin(turn), z};
    for (int i = 0; i < 3; i++)
        scene->camera.position[i] = distance * way[i];
    assert_true(scene_camera_aim(&scene->camera) == SCENE_AIM_fine);
}

/* Number of background pixels all of whose neighbors show the mesh. */
static int holes(const float *light, long *within)
{
    int count = 0;
    for (int y = 1; y < EDGE - 1; y++)
        for (int x = 1; x < EDGE - 1; x++) {
            int around = 0;
            for (int i = 0; i < 9; i++)
                around += i != 4 && light[4 * ((y + i / 3 - 1) * EDGE + x + i % 3 - 1)] > .1f;
            const bool shown = light[4 * (y * EDGE + x)] > .1f;
            *within += shown;
            count += around == 8 && !shown;
        }
    return count;
}

/* Marks the pairs of segment counts, as powers of two, that occur in one patch. */
static void mark_pairs(const Scene *scene, bool met[7][7])
{
    const ScenePatches *patches = scene->meshes[scene->objects[0].mesh].patches;
    uint8_t(*parts)[3] = calloc((size_t)patches->count, sizeof *parts);
    scene_patches_levels(patches, &scene->camera, (int[]){EDGE, EDGE}, NULL, parts);
    for (int t = 0; t < patches->count; t++)
        for (int k = 0; k < 9; k++)
            met[__builtin_ctz(parts[t][k / 3])][__builtin_ctz(parts[t][k % 3])] = true;
    free(parts);
}

/* 64 views of four meshes: near ones, in which an edge has many times its neighbor's segments,
 * and far ones. Shared edges are equal bit for bit. */
static void no_hole_is_where_levels_meet(void **state)
{
    (void)state;
    static const double distances[] = {1.1, 1.7, 2.2, 40};
    static const char *const how[METHODS] = {"method: grid, pixels: 1, triangles: 100000",
                                             "method: tessellation, pixels: 1, triangles: 30000"};
    const MatcOptions options = frame_exact_options();
    const RendererOptions draw = with_triangles(&options);
    bool met[7][7] = {{false}};
    long within = 0;
    GlContext *gl = frame_context();
    for (int i = 0; i < BODIES * METHODS; i++) {
        MatcDocument *document;
        Scene *scene = open_scene(&(SceneText){how[i % METHODS], " []", bodies[i / METHODS]},
                                  &options, &document);
        Renderer *renderer = renderer_open(gl, &draw);
        float light[4 * PIXELS];
        assert_true(renderer && renderer_set_scene(renderer, scene));
        for (int view = 0; view < VIEWS; view++) {
            look_from(scene, view, distances[view % 4]);
            scene->camera.half = view % 4 == 2 ? .115 : .36; /* a tangent */
            assert_true(renderer_changed(renderer, RENDERER_CAMERA) && renderer_frame(renderer) &&
                        renderer_read(renderer, light));
            const int found = holes(light, &within);
            if (found || shape_body(shape_of(scene)) == SHAPE_BODY_none)
                fail_msg("%s, body %d, view %d: %d holes, or open edges", how[i % METHODS],
                         i / METHODS, view, found);
            mark_pairs(scene, met);
        }
        renderer_close(renderer);
        frame_forget(scene, document);
    }
    gl_close(gl);
    print_message("%ld pixels within\n", within);
    assert_true(within > 60000);
    for (int i = 1; i < 7; i++)
        if (!met[i][i - 1])
            fail_msg("no edges of %d and of %d parts met", 1 << i, 1 << (i - 1));
}

/* Number of pixels that differ by more than a fiftieth. */
static int differing(const float *a, const float *b)
{
    int count = 0;
    for (int i = 0; i < PIXELS; i++)
        count += fabsf(a[4 * i] - b[4 * i]) > .02f;
    return count;
}

static float *picture(GlContext *gl, const SceneText *of, const MatcOptions *options)
{
    MatcDocument *document;
    Scene *scene = open_scene(of, options, &document);
    float *light = frame_floats(gl, scene, &(RendererOptions){.compile = options, .view = "light"});
    frame_forget(scene, document);
    return light;
}

/* Light, shadows of each method, transparency, and ambient light dimmed by voxels equal those of
 * meshes that the C reference displaced. */
static void pictures_are_those_of_meshes(void **state)
{
    (void)state;
    static const char floor[] =
        "- { object: Parallelogram, u: [8, 0, 0], v: [0, 8, 0], material: floor, transform: { "
        "translation: [-4, -4, -1] } }\n";
    static const char *const shadows[] = {"map", "hybrid", "silhouette", "exact", "none"};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (int i = 0; i < 7; i++) {
        char objects[800], lights[200], how[120];
        static const char *const finer[] = {"mesh, level: 12", "grid, level: 12",
                                            "tessellation, level: 12", "mesh, level: 11",
                                            "mesh, level: 1"};
        enum { PICTURES = sizeof finer / sizeof *finer };
        float *light[PICTURES];
        const bool glass = i == 4, around = i == 5, spot = i == 6;
        snprintf(objects, sizeof objects, "%s%s",
                 glass ? "- { object: Sphere, radius: 0.9, material: pane, detail: 12 }\n"
                       : bodies[i % 4],
                 floor);
        if (around)
            snprintf(lights, sizeof lights,
                     "- { light: Hemisphere, intensity: 1 }\nindirect: { method: voxels, bounces: "
                     "0, rays: 4, filter: "
                     "none, jitter: false }");
        else
            snprintf(lights, sizeof lights, "- { light: %s, shadows: %s, intensity: %d }",
                     spot ? "Point, position: [2, -2, 3]" : "Directional, direction: [1, 0.6, -1]",
                     shadows[i % 5], spot ? 12 : 1);
        for (int k = 0; k < PICTURES; k++) {
            snprintf(how, sizeof how, "method: %s", finer[k]);
            light[k] = picture(gl, &(SceneText){how, lights, objects}, &options);
        }
        const int by_grid = differing(light[0], light[1]),
                  by_tessellation = differing(light[0], light[2]),
                  other = differing(light[0], light[3]), coarse = differing(light[0], light[4]);
        print_message("%d: %d and %d of %d pixels differ; %d of a mesh of another level, %d of a "
                      "coarse one\n",
                      i, by_grid, by_tessellation, PIXELS, other, coarse);
        assert_true(by_grid <= PIXELS / 512 + other / 4 && by_tessellation <= 16 + 2 * other &&
                    coarse > 4 * by_grid + PIXELS / 60);
        for (int k = 0; k < PICTURES; k++)
            free(light[k]);
    }
    gl_close(gl);
}

static void assert_same(Renderer *renderer, GlContext *gl, const Scene *scene,
                        const RendererOptions *draw)
{
    float light[4 * PIXELS];
    assert_true(renderer_frame(renderer) && renderer_read(renderer, light));
    float *fresh = frame_floats(gl, scene, draw);
    assert_memory_equal(light, fresh, sizeof light);
    free(fresh);
}

/* The camera moves away, and back; a param is set: pictures equal those of a new renderer. */
static void changes_are_what_a_new_renderer_draws(void **state)
{
    (void)state;
    static const char *const shadows[] = {
        "- { light: Directional, direction: [1, 0.6, -1] }",
        "- { light: Directional, direction: [1, 0.6, -1], shadows: exact }"};
    const MatcOptions options = frame_exact_options();
    const RendererOptions draw = {.compile = &options, .view = "light"};
    GlContext *gl = frame_context();
    for (int i = 0; i < 4; i++) {
        char how[80];
        MatcDocument *document;
        const double height = .05;
        snprintf(how, sizeof how, "method: %s, pixels: 3", methods[i % 2]);
        Scene *scene =
            open_scene(&(SceneText){how, shadows[i / 2], bodies[0]}, &options, &document);
        Renderer *renderer = renderer_open(gl, &draw);
        assert_true(renderer && renderer_set_scene(renderer, scene));
        for (int view = 0; view < 3; view++) {
            look_from(scene, view, view ? 2 : 6);
            assert_true(renderer_changed(renderer, RENDERER_CAMERA));
            assert_same(renderer, gl, scene, &draw);
        }
        assert_true(scene_displace_param(scene, scene->objects[0].material, "height", &height, 1) ==
                    SCENE_DISPLACED_rebuilt);
        assert_true(renderer_changed_meshes(renderer));
        assert_same(renderer, gl, scene, &draw);
        renderer_close(renderer);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

/* A driver without the features uses meshes of the same level: bit for bit. So does a height
 * without a bound. */
static void others_get_meshes(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    const SceneText mesh = {"method: mesh, level: 8",
                            "- { light: Directional, direction: [1, 0.6, -1], shadows: exact }",
                            bodies[0]};
    SceneText grid = mesh;
    GlContext *gl = frame_context();
    float *wanted = picture(gl, &mesh, &options);
    grid.how = "method: grid, level: 8";
    gl->BeginTransformFeedback = NULL;
    float *found = picture(gl, &grid, &options);
    assert_memory_equal(wanted, found, 4 * PIXELS * sizeof *found);
    free(found);
    free(wanted);
    gl_close(gl);
}

/* A surfaceless EGL context has no default framebuffer, which a draw needs even if it writes
 * only to buffers. */
static void a_context_may_lack_a_framebuffer(void **state)
{
    (void)state;
    static const char *const methods[] = {"method: grid, level: 6",
                                          "method: tessellation, level: 6"};
    const MatcOptions options = frame_exact_options();
    char error[512];
    GlContext *gl = gl_open(GL_KIND_egl, true, error, sizeof error);
    if (!gl)
        skip();
    for (int i = 0; i < 2; i++)
        free(
            picture(gl, &(SceneText){methods[i], "- { light: Directional }", bodies[0]}, &options));
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_those_of_the_reference),
        cmocka_unit_test(no_hole_is_where_levels_meet),
        cmocka_unit_test(pictures_are_those_of_meshes),
        cmocka_unit_test(changes_are_what_a_new_renderer_draws),
        cmocka_unit_test(others_get_meshes),
        cmocka_unit_test(a_context_may_lack_a_framebuffer),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
