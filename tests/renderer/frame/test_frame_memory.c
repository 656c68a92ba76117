/* Render targets that alias each other's memory: bytes per pixel, counted by hand, and pictures
 * equal bit for bit to those with separate targets. */
/* ctest: seconds=25 */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 96, HEIGHT = 64, COMPONENTS = WIDTH * HEIGHT * 4 };

/* Diffuse and glossy solids, a pane in front, a plane to the horizon. */
static const char scene_text[] =
    "image: { width: 96, height: 64 }\ncamera: { camera: Perspective, position: [.5, -6, 2.5], "
    "target: [0, 0, .5], "
    "angle: 40 }\n"
    "sky: { material: RGBA, r: .1, g: .2, b: .5 }\n"
    "lights: [{ light: Point, position: [1, -4, 4], intensity: 40 }]\n"
    "objects:\n- { object: Plane, material: { material: Phong, diffuse: [.8, .6, .4] } }\n"
    "- { object: Sphere, material: { material: Phong, diffuse: [.2, .4, .6], specular: 1, "
    "shininess: .8 } }\n";
static const char pane_text[] = "- { object: Parallelogram, u: [1, 0, 0], v: [0, 0, 1], material: "
                                "{ material: Phong, transparency: [.5, .7, .9] }, "
                                "transform: { translation: [-.5, -2, .5] } }\n";

/* Bytes a pixel where targets share memory; where those of one format alone do, as there are no
 * views of one as another; and where nothing is computed, so that no pixel is replaced where it is
 * read; 0: there are no edges then. The layout's, of depth, of light, of edges, of what is
 * shown. */
static const struct {
    const char *layout;
    bool pane, edges, linear, peeled;
    int bytes[3];
} cases[] = {
    {"compact", true, true, false, false, {16 + 4 + 8 + 4, 16 + 4 + 8 + 4 + 4, 0}},
    {"compact", false, false, false, false, {16 + 4 + 8 + 4, 16 + 4 + 8 + 4, 16 + 4 + 8 + 4}},
    {"integer", false, true, false, false, {48 + 4 + 4, 48 + 4 + 16 + 4 + 4, 0}},
    /* four targets of halves, as light is, and the picture */
    {"thesis", false, false, true, false, {32 + 4, 32 + 4, 32 + 4 + 8}},
    /* a layer's textures are the G-buffer's; it has a depth and two keys */
    {"compact",
     true,
     false,
     false,
     true,
     {16 + 4 + 8 + 4 + 20, 16 + 4 + 8 + 4 + 20, 16 + 4 + 8 + 4 + 20}},
};
enum { CASES = sizeof cases / sizeof *cases, SHARED = 0, SEPARATE, FRAGMENTS };

/* Draws a second frame, whose memory contains leftovers of the first. */
static void draw(const Scene *scene, const MatcOptions *options, int number, int way, float *rgba)
{
    GlContext *gl = frame_context();
    if (way == SEPARATE)
        gl->TextureView = NULL;
    Renderer *renderer = renderer_open(
        gl, &(RendererOptions){.compile = options,
                               .edges = cases[number].edges ? RENDERER_EDGES_coverage
                                                            : RENDERER_EDGES_none,
                               .linear = cases[number].linear,
                               .transparency = cases[number].peeled ? "peeling" : NULL,
                               .fragment = way == FRAGMENTS});
    assert_non_null(renderer);
    if (!renderer_set_scene(renderer, scene) || !renderer_frame(renderer) ||
        !renderer_frame(renderer) || !renderer_read(renderer, rgba))
        fail_msg("%s", gl->error);
    if (renderer_pixel_bytes(renderer) != cases[number].bytes[way])
        fail_msg("case %d, way %d: %d bytes a pixel", number, way, renderer_pixel_bytes(renderer));
    renderer_close(renderer);
    gl_close(gl);
}

static void pictures_are_the_same(void **state)
{
    (void)state;
    static float shared[COMPONENTS], separate[COMPONENTS], fragments[COMPONENTS];
    for (int i = 0; i < CASES; i++) {
        char text[sizeof scene_text + sizeof pane_text];
        MatcDocument *document;
        MatcOptions options;
        matc_options_init(&options);
        options.layout = cases[i].layout;
        strcpy(text, scene_text);
        strcat(text, cases[i].pane ? pane_text : "");
        Scene *scene = frame_scene(text, &options, &document);
        draw(scene, &options, i, SHARED, shared);
        draw(scene, &options, i, SEPARATE, separate);
        assert_memory_equal(shared, separate, sizeof shared);
        if (cases[i].bytes[FRAGMENTS]) {
            draw(scene, &options, i, FRAGMENTS, fragments);
            assert_memory_equal(shared, fragments, sizeof shared);
        }
        frame_forget(scene, document);
    }
}

/* Targets that are read after the frame still exist. */
static void views_stay(void **state)
{
    (void)state;
    static const char *const views[] = {"light", "depth", "diffuse"};
    static float shared[COMPONENTS];
    for (size_t i = 0; i < sizeof views / sizeof *views; i++) {
        MatcDocument *document;
        MatcOptions options;
        matc_options_init(&options);
        options.layout = "integer";
        Scene *scene = frame_scene(scene_text, &options, &document);
        float *pictures[2];
        for (int way = 0; way < 2; way++) {
            GlContext *gl = frame_context();
            gl->TextureView = way ? NULL : gl->TextureView;
            pictures[way] =
                frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = views[i]});
            gl_close(gl);
        }
        assert_memory_equal(pictures[0], pictures[1], sizeof shared);
        free(pictures[0]);
        free(pictures[1]);
        frame_forget(scene, document);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(pictures_are_the_same),
                                       cmocka_unit_test(views_stay)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
