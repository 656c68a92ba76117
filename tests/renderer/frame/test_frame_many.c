/* Many objects: instances against objects drawn individually and against drawing without
 * culling; the number of draw calls. */
/* ctest: unsanitized seconds=16 */
#include "tests/test.h"
#include "runtime/gpu_scene/cull.h"
#include "runtime/scene/scene_matrix.h"
#include "tests/frame/frame_calls.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/frame_random.h"
#include <math.h>
#include <stdio.h>
#include <unistd.h>
#include <stdlib.h>
#include <string.h>

static bool same(const float *a, const float *b, const Scene *scene)
{
    return !memcmp(a, b, (size_t)scene->width * (size_t)scene->height * 4 * sizeof *a);
}

/* -- what is out of view */

/* A picture with culling equals one without, bit for bit, with instances and without. */
static void nothing_in_view_is_left_out(void **unused)
{
    (void)unused;
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (int round = 0; round < 9; round++) {
        MatcDocument *document;
        char *text = frame_random_text((uint64_t)round + 1, 150, round % 3 == 2);
        Scene *scene = frame_scene(text, &options, &document);
        float *culled =
            frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
        float *whole = frame_floats(
            gl, scene, &(RendererOptions){.compile = &options, .view = "light", .unculled = true});
        assert_true(same(culled, whole, scene));
        free(culled);
        free(whole);
        free(text);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

/* Number of pixels whose normal is opposite to a neighbor's. */
static int count_turned(const float *normals, int width, int height)
{
    int turned = 0;
    for (int i = width; i < width * (height - 1); i++)
        for (int side = 0; side < 4 && normals[4 * i + 3] > 0; side++) {
            const float *n = normals + 4 * i, *beside = n + 4 * (int[]){1, -1, width, -width}[side];
            turned +=
                beside[3] > 0 && n[0] * beside[0] + n[1] * beside[1] + n[2] * beside[2] < -.5f;
        }
    return turned;
}

/* A sphere as a file has it: vertices only, each triangle's corners by number. */
static void write_ball(const char *path)
{
    enum { AROUND = 48, UP = 24 };
    const double pi = acos(-1);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    for (int i = 1; i < UP; i++)
        for (int k = 0; k < AROUND; k++)
            fprintf(file, "v %.9g %.9g %.9g\n", sin(pi * i / UP) * cos(2 * pi * k / AROUND),
                    sin(pi * i / UP) * sin(2 * pi * k / AROUND), -cos(pi * i / UP));
    fprintf(file, "v 0 0 -1\nv 0 0 1\n");
    for (int i = 0; i < UP; i++)
        for (int k = 1; k <= AROUND; k++) {
            const int next = k % AROUND + 1, south = (UP - 1) * AROUND + 1,
                      below = (i - 1) * AROUND, above = i * AROUND;
            const int a = i ? below + k : south, b = i ? below + next : south;
            const int c = i < UP - 1 ? above + next : south + 1,
                      d = i < UP - 1 ? above + k : south + 1;
            if (i)
                fprintf(file, "f %d %d %d\n", a, b, c);
            if (i < UP - 1)
                fprintf(file, "f %d %d %d\n", a, c, d);
        }
    assert_int_equal(fclose(file), 0);
}

/* A sphere, the renderer's and a file's, from four places. A rasterizer, which rounds corners,
 * shows its inside at a pixel of its rim now and then; the first place is one of these, of the mesh
 * the second. */
static void no_inside_at_a_rim(void **unused)
{
    (void)unused;
    enum { WIDTH = 300, HEIGHT = 225 };
    static const double places[][3] = {{2, -5, 3}, {3, 4, 3.3}, {-5, 1, 2}, {-2, -4, -1}};
    char folder[] = "/tmp/matc_ball_XXXXXX", ball[64], mesh[96];
    const char *const solids[] = {"Sphere", mesh};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    assert_non_null(mkdtemp(folder));
    snprintf(ball, sizeof ball, "%s/ball.obj", folder);
    snprintf(mesh, sizeof mesh, "Mesh, file: %s", ball);
    write_ball(ball);
    for (size_t i = 0; i < 2 * sizeof places / sizeof *places; i++) {
        const double *from = places[i / 2];
        MatcDocument *document;
        char text[512];
        snprintf(text, sizeof text,
                 "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [%g, "
                 "%g, %g], target: [0, "
                 "0, .6] }\n"
                 "materials: { m: { material: Phong } }\nobjects:\n"
                 "- { object: %s, material: m, transform: { translation: [0, 0, 1] } }\n",
                 WIDTH, HEIGHT, from[0], from[1], from[2], solids[i % 2]);
        Scene *scene = frame_scene(text, &options, &document);
        float *normals =
            frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "normal"});
        assert_true(normals[4 * (HEIGHT / 2 * WIDTH + WIDTH / 2) + 3] > 0);
        assert_int_equal(count_turned(normals, WIDTH, HEIGHT), 0);
        free(normals);
        frame_forget(scene, document);
    }
    assert_true(!remove(ball) && !rmdir(folder));
    gl_close(gl);
}

/* From inside a mesh, and where the near plane cuts into one, backfaces are visible; from
 * outside the picture equals that without culling. */
static void insides_are_seen_from_within(void **unused)
{
    (void)unused;
    static const struct {
        const char *camera;
        bool all; /* pixels show something */
    } cases[] = {
        {"camera: Perspective, position: [.2, .1, .3], target: [1, 0, 0], near: .01", true},
        {"camera: Perspective, position: [0, -1.2, 0], target: [0, 0, 0], near: .5, angle: 30",
         true},
        {"camera: Orthographic, position: [0, -.2, 0], target: [0, 1, 0], size: 1, depth: 9", true},
        {"camera: Perspective, position: [0, -5, 1], target: [0, 0, 0]", false}};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        MatcDocument *document;
        char text[512];
        snprintf(text, sizeof text,
                 "image: { width: 48, height: 36 }\ncamera: { %s }\nmaterials: { m: { material: "
                 "Phong } }\nobjects:\n"
                 "- { object: Sphere, material: m, transform: { scale: [-1, 1, 1] } }\n",
                 cases[i].camera);
        Scene *scene = frame_scene(text, &options, &document);
        float *depth =
            frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "depth"});
        int seen = 0;
        for (int k = 0; k < 48 * 36; k++)
            seen += depth[4 * k + 3] > 0;
        assert_true(cases[i].all ? seen == 48 * 36 : seen > 100 && seen < 48 * 36 / 2);
        free(depth);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

/* Unit boxes at the frustum's sides, slightly outside and slightly inside; angles by closed
 * forms. */
static void boxes_at_the_planes(void **unused)
{
    (void)unused;
    const SceneCamera camera = {.kind = SCENE_Perspective,
                                .position = {10, 20, 30},
                                .right = {1, 0, 0},
                                .up = {0, 0, 1},
                                .back = {0, -1, 0},
                                .half = 1,
                                .near = 2};
    const CullBox box = {{-1, -1, -1}, {1, 1, 1}};
    static const struct {
        double x, y, z; /* of the center, from the eye: to the right, ahead, up */
        bool seen;
    } cases[] = {{0, 10, 0, true},       {0, -10, 0, false},     {0, .99, 0, false},
                 {0, 1.01, 0, true},     {23.01, 10, 0, false},  {22.99, 10, 0, true},
                 {-23.01, 10, 0, false}, {-22.99, 10, 0, true},  {0, 10, 12.01, false},
                 {0, 10, 11.99, true},   {0, 10, -12.01, false}, {0, 10, -11.99, true}};
    CullVolume volume;
    /* twice as wide as high: tangents 2 and 1 */
    cull_volume(&camera, (const int[]){200, 100}, &volume);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        SceneMatrix matrix = scene_matrix_identity();
        matrix.m[12] = 10 + cases[i].x;
        matrix.m[13] = 20 + cases[i].y;
        matrix.m[14] = 30 + cases[i].z;
        assert_int_equal(cull_sees(&volume, &box, &matrix), cases[i].seen);
    }
}

/* Each vertex counts, also the last, along each axis. */
static void boxes_around_meshes(void **unused)
{
    (void)unused;
    ShapeVertex vertices[] = {
        {.position = {-1, 2, 3}}, {.position = {4, -5, 3}}, {.position = {0, 0, 7}}};
    const CullBox box = cull_box(&(Shape){.vertices = vertices, .vertex_count = 3});
    const CullBox wanted = {{-1, -5, 3}, {4, 2, 7}};
    assert_memory_equal(&box, &wanted, sizeof box);
}

/* -- instances */

/* Drawing objects individually by uniforms gives the same: depth bit for bit, light except for
 * one step of a normal's code. */
static void instances_or_not(void **unused)
{
    (void)unused;
    const MatcOptions options = frame_exact_options();
    for (int round = 0; round < 2; round++) {
        MatcDocument *document;
        char *text = frame_random_text((uint64_t)round + 100, 100, round == 1);
        Scene *scene = frame_scene(text, &options, &document);
        float *pictures[2][2];
        for (int way = 0; way < 2; way++) {
            GlContext *gl = frame_context();
            gl->VertexAttribDivisor = way ? NULL : gl->VertexAttribDivisor;
            pictures[0][way] =
                frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "depth"});
            pictures[1][way] =
                frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
            gl_close(gl);
        }
        assert_true(same(pictures[0][0], pictures[0][1], scene));
        for (int i = 0; i < scene->width * scene->height * 4; i++)
            assert_true(fabsf(pictures[1][0][i] - pictures[1][1][i]) <=
                        1e-3f * (1 + pictures[1][0][i]));
        for (int i = 0; i < 4; i++)
            free(pictures[i / 2][i % 2]);
        free(text);
        frame_forget(scene, document);
    }
}

/* The text is valid GLSL, whatever the material reads of its surface; glslang links both texts. */
static void instances_are_valid(void **unused)
{
    (void)unused;
    static const char *const materials[] = {
        "material: Phong\ndiffuse: { map: Blend, input: { map: Wood }, blend: [{ value: 0, input: "
        ".2 }, { value: 2, "
        "input: .3 }] }\n",
        "material: Phong\ndiffuse: { map: Checker, color1: .3, input: { map: BumpMap, "
        "displacement: { map: Wood } } "
        "}\n",
        "material: RGBA\nr: .4\na: { param: alpha, default: .5 }\n",
    };
    static const char *const passes[] = {"gbuffer", "shadow", "depth", "value", "plane", "sky"};
    for (size_t i = 0; i < sizeof materials / sizeof *materials * 6; i++) {
        MatcOptions options;
        matc_options_init(&options);
        options.target = "glsl450";
        options.constants = "uniform";
        options.instances = true;
        options.pass = passes[i % 6];
        MatcDocument *document =
            matc_read("m.yaml", materials[i / 6], strlen(materials[i / 6]), &options);
        MatcProgram *program =
            matc_compile(document, 0, MATC_FRAGMENT | MATC_VERTEX | MATC_REFLECT, &options);
        if (!matc_ok(program))
            fail_msg("%s", matc_program_diagnostics(program, MATC_TEXT));
        const bool drawn = i % 6 < 4;
        assert_int_equal(drawn,
                         strstr(matc_output(program, MATC_VERTEX, NULL), "matc_instance;") != NULL);
        assert_int_equal(drawn, matc_output(program, MATC_REFLECT, NULL) == NULL);
        matc_program_free(program);
        matc_document_free(document);
    }
}

/* -- calls */

enum { TEXT = 1 << 17 };

/* n materials that differ in numbers, on n boxes. */
static char *rows_text(int count)
{
    char *text = malloc(TEXT);
    size_t size = (size_t)snprintf(
        text, TEXT, "image: { width: 16, height: 16 }\nlights: [{ light: Ambient }]\nobjects:\n");
    for (int i = 0; i < count; i++)
        size += (size_t)snprintf(text + size, TEXT - size,
                                 "- { object: Box, transform: { translation: [%g, 0, 0] }, "
                                 "material: { material: Phong, ambient: "
                                 "[%g, .5, .2] } }\n",
                                 i * .01, (i + 1.) / (count + 1));
    return text;
}

/* Eight times as many objects and materials need equally many calls of every kind, and eight
 * times the bytes. */
static void calls_do_not_grow(void **unused)
{
    (void)unused;
    const MatcOptions options = frame_exact_options();
    int drawn[2], made[2], programs[2];
    for (int i = 0; i < 2; i++) {
        MatcDocument *document;
        char *text = rows_text(i ? 400 : 50);
        Scene *scene = frame_scene(text, &options, &document);
        GlContext *gl = frame_context();
        Renderer *renderer = renderer_open(gl, &(RendererOptions){.compile = &options});
        frame_count_calls(gl);
        assert_true(renderer && renderer_set_scene(renderer, scene));
        made[i] = frame_calls.made;
        frame_calls = (FrameCalls){0};
        assert_true(renderer_frame(renderer));
        drawn[i] = frame_calls.drawn;
        programs[i] = frame_calls.programs;
        renderer_close(renderer);
        gl_close(gl);
        free(text);
        frame_forget(scene, document);
    }
    assert_int_equal(drawn[0], 1);
    assert_int_equal(drawn[1], 1);
    assert_int_equal(programs[0], programs[1]);
    assert_int_equal(made[0], made[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_in_view_is_left_out),  cmocka_unit_test(no_inside_at_a_rim),
        cmocka_unit_test(insides_are_seen_from_within), cmocka_unit_test(boxes_at_the_planes),
        cmocka_unit_test(boxes_around_meshes),          cmocka_unit_test(instances_or_not),
        cmocka_unit_test(instances_are_valid),          cmocka_unit_test(calls_do_not_grow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
