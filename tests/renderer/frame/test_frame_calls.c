/* GL calls of frames: a second frame only draws, materials share programs, views omit unused
 * passes. */
/* ctest: seconds=41 */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CAMERA                                                                                     \
    "image: { width: 480, height: 320 }\ncamera: { camera: Perspective, position: [.5, -6, 2.5], " \
    "target: [0, 0, .5], "                                                                         \
    "angle: 40 }\n"
#define POINT                                                                                      \
    "lights: [{ light: Point, position: [1, -4, 4], color: [1, .8, .6], intensity: 12 }]\n"

/* -- calls */

static int calls, draws;
#define COUNTED(kind, result, name, parameters, arguments)                                         \
    static result(*original_##name) parameters;                                                    \
    static result count_##name parameters                                                          \
    {                                                                                              \
        kind++;                                                                                    \
        original_##name arguments;                                                                 \
    }
COUNTED(calls, void, BufferData, (GLenum a, GLsizeiptr b, const void *c, GLenum d), (a, b, c, d))
COUNTED(calls, void, BufferSubData, (GLenum a, GLintptr b, GLsizeiptr c, const void *d),
        (a, b, c, d))
COUNTED(calls, void, GetBufferSubData, (GLenum a, GLintptr b, GLsizeiptr c, void *d), (a, b, c, d))
COUNTED(calls, void, GetQueryObjectuiv, (GLuint a, GLenum b, GLuint *c), (a, b, c))
COUNTED(calls, void, GenBuffers, (GLsizei a, GLuint *b), (a, b))
COUNTED(calls, void, GenTextures, (GLsizei a, GLuint *b), (a, b))
COUNTED(calls, void, GenFramebuffers, (GLsizei a, GLuint *b), (a, b))
COUNTED(calls, void, GenVertexArrays, (GLsizei a, GLuint *b), (a, b))
COUNTED(calls, void, LinkProgram, (GLuint a), (a))
COUNTED(calls, void, GetIntegerv, (GLenum a, GLint *b), (a, b))
COUNTED(calls, void, GetProgramiv, (GLuint a, GLenum b, GLint *c), (a, b, c))
COUNTED(calls, void, TexParameteri, (GLenum a, GLenum b, GLint c), (a, b, c))
COUNTED(calls, void, FramebufferTexture2D, (GLenum a, GLenum b, GLenum c, GLuint d, GLint e),
        (a, b, c, d, e))
COUNTED(calls, void, FramebufferTextureLayer, (GLenum a, GLenum b, GLuint c, GLint d, GLint e),
        (a, b, c, d, e))
COUNTED(calls, void, Uniform1fv, (GLint a, GLsizei b, const GLfloat *c), (a, b, c))
COUNTED(calls, void, Uniform2fv, (GLint a, GLsizei b, const GLfloat *c), (a, b, c))
COUNTED(calls, void, Uniform3fv, (GLint a, GLsizei b, const GLfloat *c), (a, b, c))
COUNTED(calls, void, Uniform4fv, (GLint a, GLsizei b, const GLfloat *c), (a, b, c))
COUNTED(calls, void, Uniform1iv, (GLint a, GLsizei b, const GLint *c), (a, b, c))
COUNTED(calls, void, UniformMatrix3fv, (GLint a, GLsizei b, GLboolean c, const GLfloat *d),
        (a, b, c, d))
COUNTED(calls, void, UniformMatrix4fv, (GLint a, GLsizei b, GLboolean c, const GLfloat *d),
        (a, b, c, d))
COUNTED(draws, void, DrawElements, (GLenum a, GLsizei b, GLenum c, const void *d), (a, b, c, d))
COUNTED(draws, void, DrawElementsInstancedBaseInstance,
        (GLenum a, GLsizei b, GLenum c, const void *d, GLsizei e, GLuint f), (a, b, c, d, e, f))
COUNTED(draws, void, DrawArrays, (GLenum a, GLint b, GLsizei c), (a, b, c))
COUNTED(draws, void, DispatchCompute, (GLuint a, GLuint b, GLuint c), (a, b, c))

static void count_calls(GlContext *gl)
{
#define COUNT(name) original_##name = gl->name, gl->name = count_##name;
    COUNT(DrawElementsInstancedBaseInstance)
    COUNT(BufferData)
    COUNT(BufferSubData)
    COUNT(GetBufferSubData)
    COUNT(GetQueryObjectuiv)
    COUNT(GenBuffers)
    COUNT(GenTextures)
    COUNT(GenFramebuffers)
    COUNT(GenVertexArrays)
    COUNT(FramebufferTextureLayer)
    COUNT(LinkProgram)
    COUNT(GetIntegerv)
    COUNT(GetProgramiv)
    COUNT(TexParameteri)
    COUNT(FramebufferTexture2D)
    COUNT(Uniform1fv)
    COUNT(Uniform2fv)
    COUNT(Uniform3fv)
    COUNT(Uniform4fv)
    COUNT(Uniform1iv)
    COUNT(UniformMatrix3fv)
    COUNT(UniformMatrix4fv)
    COUNT(DrawElements) COUNT(DrawArrays) COUNT(DispatchCompute) calls = draws = 0;
}

/* Spheres and boxes of three materials, one of them another program; a plane, a sky; a box and a
 * plane of glass. */
static const char busy[] = CAMERA POINT
    "materials: { a: { material: Phong, diffuse: .2 }, b: { material: Phong, diffuse: .4 }, "
    "c: { material: Phong, diffuse: { map: Wood } }, glass: { material: RGBA, a: .5 } }\n"
    "objects:\n- { object: Sphere, material: a }\n"
    "- { object: Sphere, material: b, transform: { translation: [1, 0, 0] } }\n"
    "- { object: Box, material: c }\n- { object: Box, material: a, transform: { scale: -2 } }\n"
    "- { object: Plane, material: b }\n"
    "- { object: Box, material: glass, transform: { translation: [0, 0, 1.5] } }\n"
    "- { object: Plane, material: glass, transform: { translation: [0, 0, .1] } }\n"
    "sky: { material: RGBA, b: .5 }\n";

/* Draws a second frame with exactly `expected` draw calls, and no other GL call. */
static void draw_again(Renderer *renderer, int expected)
{
    calls = draws = 0;
    assert_true(renderer_frame(renderer));
    assert_int_equal(calls, 0);
    assert_int_equal(draws, expected);
}

/* Frames but the first, of a scene drawn with such options, take so many draws each, 0: the
 * second's; and nothing else. */
static void expect_draws_only(const Scene *scene, RendererOptions options, int expected)
{
    GlContext *gl = frame_context();
    count_calls(gl);
    Renderer *renderer = renderer_open(gl, &options);
    assert_non_null(renderer);
    assert_true(renderer_set_scene(renderer, scene));
    assert_true(renderer_frame(renderer));
    assert_true(calls > 0);
    calls = draws = 0;
    assert_true(renderer_frame(renderer));
    assert_int_equal(calls, 0);
    draw_again(renderer, expected ? expected : draws);
    draw_again(renderer, expected ? expected : draws);
    assert_true(gl_check(gl, "four frames"));
    renderer_close(renderer);
    gl_close(gl);
}

static void a_second_frame_only_draws(void **state)
{
    (void)state;
    enum {
        OPAQUE =
            3 + 1 + 1 + 2 /* surfaces, the spheres at once; the plane, the sky, light and tone */,
        LAYERS = 3
    };
    static const struct {
        const char *transparency, *lights;
        int draws;
    } cases[] = {{"lists", "all", OPAQUE + 2 + 1},
                 {"peeling", "all", OPAQUE + LAYERS * (2 + 1)},
                 {"lists", "bounded",
                  OPAQUE + 2 + 1 + 3 /* groups of pixels, what is near them, and the rest */}};
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(busy, &options, &document);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++)
        expect_draws_only(scene,
                          (RendererOptions){.compile = &options,
                                            .transparency = cases[i].transparency,
                                            .lights = cases[i].lights},
                          cases[i].draws);
    frame_forget(scene, document);
}

/* Nor with edges, nor where tone mapping asks the whole picture. */
static void tones_and_edges_only_draw(void **state)
{
    (void)state;
    static const char *const tones[] = {"Linear", "ReinhardDevlin", "Drago"};
    const MatcOptions options = frame_exact_options();
    char text[sizeof busy + 64];
    for (size_t i = 0; i < sizeof tones / sizeof *tones; i++) {
        MatcDocument *document;
        snprintf(text, sizeof text, "%stoneMapping: { toneMapping: %s }\n", busy, tones[i]);
        Scene *scene = frame_scene(text, &options, &document);
        expect_draws_only(
            scene,
            (RendererOptions){
                .compile = &options, .width = 96, .height = 64, .edges = RENDERER_EDGES_coverage},
            0);
        frame_forget(scene, document);
    }
}

/* -- what there is */

/* Materials that differ only in constants share a program; each keeps its constants. */
static void programs_are_shared(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene =
        frame_scene("image: { width: 90, height: 30 }\ncamera: { camera: Orthographic, position: "
                    "[0, -5, 0], size: 1 }\n"
                    "lights: [{ light: Ambient }]\nobjects:\n"
                    "- { object: Box, material: { material: Phong, ambient: [.1, .2, .3] }, "
                    "transform: { translation: "
                    "[-1, 0, 0] } }\n"
                    "- { object: Box, material: { material: Phong, ambient: [.4, .5, .6] } }\n"
                    "- { object: Box, material: { material: Phong, ambient: [.7, .8, .9] }, "
                    "transform: { translation: "
                    "[1, 0, 0] } }\n",
                    &options, &document);
    GlContext *gl = frame_context();
    Renderer *renderer =
        renderer_open(gl, &(RendererOptions){.compile = &options, .view = "light"});
    float *rgba = calloc(90 * 30, 4 * sizeof *rgba);
    assert_non_null(rgba);
    assert_true(renderer && renderer_set_scene(renderer, scene) && renderer_frame(renderer) &&
                renderer_read(renderer, rgba));
    for (int i = 0; i < 9; i++)
        /* 10 bits */
        assert_true(fabs(rgba[4 * (15 * 90 + 15 + 30 * (i / 3)) + i % 3] - .1 * (i + 1)) < 5e-4);
    char *stats = renderer_stats(renderer);
    assert_non_null(strstr(stats, "3 materials, 3 programs of 1 distinct sources"));
    assert_non_null(strstr(stats, "in 1 meshes"));
    free(stats);
    free(rgba);
    renderer_close(renderer);
    gl_close(gl);
    frame_forget(scene, document);
}

/* Passes and targets that a view does not need do not run or exist. */
static void views_need_less(void **state)
{
    (void)state;
    static const struct {
        const char *view, *rests, *lights;
    } cases[] = {
        {"depth", "light depth, gbuffer, shadow light not run: nobody needs it", "auto"},
        {"normal", "final RGBA8 not allocated", "auto"},
        {"light", "tone light final not run: nobody needs it", "auto"},
        {NULL, "plane depth, gbuffer depth, gbuffer not run: nothing to do", "auto"},
        {NULL, "light_cluster depth, gbuffer far not run: lights are few", "auto"},
        {"depth", "far two buffers not allocated", "auto"},
        {NULL, "light_cluster depth, gbuffer far not run: all lights are asked for", "all"},
        {NULL, "light_cluster depth, gbuffer far lights are many, and far ones are taken together",
         "bounded"},
        {NULL, "light depth, gbuffer, shadow, far light always", "bounded"},
        {"light", "far two buffers 4: 3536 bytes for blocks of 32 x 32", "bounded"}};
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene =
        frame_scene(CAMERA POINT "objects: [{ object: Sphere, material: { material: Phong } }]\n",
                    &options, &document);
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        const RendererOptions drawn = {.compile = &options,
                                       .view = cases[i].view,
                                       .lights = cases[i].lights,
                                       .width = 30,
                                       .height = 20};
        Renderer *renderer = renderer_open(gl, &drawn);
        assert_true(renderer && renderer_set_scene(renderer, scene));
        char *graph = frame_graph(renderer);
        if (!strstr(graph, cases[i].rests))
            fail_msg("%s", graph);
        free(graph);
        renderer_close(renderer);
    }
    assert_null(renderer_open(gl, &(RendererOptions){.compile = &options, .view = "deep"}));
    assert_string_equal(gl->error,
                        "unknown view 'deep'; expected final, wireframe, volume, light, depth, "
                        "shadow, positions, voxels, ao, indirect, bent, visibility, or a slot");
    gl_close(gl);
    frame_forget(scene, document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_second_frame_only_draws),
        cmocka_unit_test(tones_and_edges_only_draw),
        cmocka_unit_test(programs_are_shared),
        cmocka_unit_test(views_need_less),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
