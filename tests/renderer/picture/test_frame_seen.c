/* Per-draw inputs of formulas, by closed forms: the direction to the viewer, for perspective and
 * parallel rays, on meshes and on planes; time, also when it changes; the object's number, drawn
 * by instances and individually; attributes of the mesh's vertices, and their derivatives. */
#include "runtime/tessellate/scene_scatter.h"
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

enum { EDGE = 24 };

/* A square, or a plane, at z = 0, seen from a height of 3 with 90 degrees, or by parallel rays. */
typedef struct {
    const char *object, *camera;
    bool parallel;
} Case;
static const Case cases[] = {
    {"Box, size: [20, 20, 2], transform: { translation: [0, 0, -1] }", "Perspective, angle: 90",
     false},
    {"Plane", "Perspective, angle: 90", false},
    {"Box, size: [20, 20, 2], transform: { translation: [0, 0, -1] }", "Orthographic, size: 6",
     true},
    {"Plane", "Orthographic, size: 6", true},
};

/* The red is V.x / 2 + 1/2, green |N . V|, blue time / 8. */
static void expect(const float *rgba, const Case *c, double time)
{
    for (int i = 0; i < EDGE * EDGE; i++) {
        const double x = c->parallel ? 0 : (i % EDGE + .5) / EDGE * 2 - 1,
                     y = c->parallel ? 0 : (i / EDGE + .5) / EDGE * 2 - 1;
        const double facing = 1 / sqrt(1 + x * x + y * y),
                     want[3] = {.5 - .5 * x * facing, facing, time / 8};
        for (int component = 0; component < 3; component++)
            if (!(fabs(rgba[4 * i + component] - want[component]) <= 4e-6))
                fail_msg("%s, %s, pixel %d, lane %d: %g, not %g", c->object, c->camera, i,
                         component, (double)rgba[4 * i + component], want[component]);
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
        snprintf(text, sizeof text,
                 "image: { width: %d, height: %d }\n"
                 "materials: { seen: { material: Phong, diffuse: 0, emissive: \"= [V.x / 2 + .5, "
                 "facing, time / 8]\" } }\n"
                 "objects: [{ object: %s, material: seen }]\n"
                 "camera: { camera: %s, position: [0, 0, 3], target: [0, 0, 0], up: [0, 1, 0] }\n",
                 EDGE, EDGE, cases[i].object, cases[i].camera);
        Scene *scene = frame_scene(text, &options, &document);
        GlContext *gl = frame_context();
        Renderer *renderer =
            renderer_open(gl, &(RendererOptions){.compile = &options, .view = "emissive"});
        scene->time = 2.5;
        float *rgba = frame_floats_by(gl, renderer, scene);
        expect(rgba, &cases[i], 2.5);
        scene->time = 4;
        assert_true(renderer_changed(renderer, RENDERER_TIME) && renderer_frame(renderer) &&
                    renderer_read(renderer, rgba));
        expect(rgba, &cases[i], 4);
        free(rgba);
        renderer_close(renderer);
        gl_close(gl);
        frame_forget(scene, document);
        matc_layout_free(layout);
    }
}

/* Nine boxes in rows, each sends out its own number: instances or not, from one frame to the
 * next. */
static void objects_have_numbers(void **state)
{
    (void)state;
    char text[2048];
    MatcLayout *layout;
    MatcDocument *document;
    const MatcOptions options = frame_float_options(&layout);
    int size = snprintf(
        text, sizeof text,
        "image: { width: %d, height: %d }\n"
        "materials: { seen: { material: Phong, diffuse: 0, emissive: \"= objectRandom\" } }\n"
        "camera: { camera: Orthographic, size: 6, position: [0, 0, 3], target: [0, 0, 0], up: [0, "
        "1, 0] }\nobjects:\n",
        EDGE, EDGE);
    for (int i = 0; i < 9; i++)
        size += snprintf(text + size, sizeof text - (size_t)size,
                         "- { object: Box, size: [2, 2, 1], material: seen, transform: { "
                         "translation: [%d, %d, 0] } }\n",
                         2 * (i % 3) - 2, 2 * (i / 3) - 2);
    Scene *scene = frame_scene(text, &options, &document);
    for (int way = 0; way < 2; way++) {
        GlContext *gl = frame_context();
        gl->VertexAttribDivisor = way ? NULL : gl->VertexAttribDivisor;
        float *rgba =
            frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "emissive"});
        for (int i = 0; i < 9; i++) {
            const int third = EDGE / 3, x = third * (i % 3) + third / 2,
                      y = third * (i / 3) + third / 2;
            const float seen = rgba[4 * (y * EDGE + x)], own = scene_object_random(i);
            if (seen != own)
                fail_msg("object %d, drawn %s: %g, not %g", i, way ? "alone" : "as an instance",
                         (double)seen, (double)own);
            for (int k = 0; k < i; k++)
                assert_true(fabsf(own - scene_object_random(k)) > 1e-3f);
        }
        free(rgba);
        gl_close(gl);
    }
    frame_forget(scene, document);
    matc_layout_free(layout);
}

#ifdef MATC_ASSIMP
/* A square in z = 0 from -3 to 3, with colors by its corners if `colors`. */
static void write_mesh(const char *path, bool colors)
{
    static const int rgba[4][4] = {
        {0, 0, 0, 255}, {255, 0, 0, 255}, {255, 255, 0, 255}, {0, 255, 0, 255}};
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fprintf(file,
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty "
            "float z\nproperty float nx\nproperty float ny\n"
            "property float nz\nproperty float s\nproperty float t\n%selement face 1\nproperty "
            "list uchar int vertex_index\nend_header\n",
            colors ? "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty "
                     "uchar alpha\n"
                   : "");
    for (int i = 0; i < 4; i++) {
        const int x = i == 1 || i == 2, y = i > 1;
        fprintf(file, "%d %d 0 0 0 1 %d %d", 6 * x - 3, 6 * y - 3, x, y);
        for (int k = 0; colors && k < 4; k++)
            fprintf(file, " %d", rgba[i][k]);
        fputs("\n", file);
    }
    fputs("4 0 1 2 3\n", file);
    assert_int_equal(fclose(file), 0);
}

static float *draw_mesh(GlContext *gl, const char *path, const char *material, const char *view)
{
    char text[1024];
    MatcLayout *layout;
    MatcDocument *document;
    const MatcOptions options = frame_float_options(&layout);
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\nmaterials: { seen: { material: Phong, %s } }\n"
             "camera: { camera: Orthographic, size: 6, position: [0, 0, 3], target: [0, 0, 0], up: "
             "[0, 1, 0] }\n"
             "objects: [{ object: Mesh, file: %s, material: seen }]\n",
             EDGE, EDGE, material, path);
    Scene *scene = frame_scene(text, &options, &document);
    float *rgba = frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = view});
    frame_forget(scene, document);
    matc_layout_free(layout);
    return rgba;
}

/* Red is u and green is v, and a mesh without colors is white; a bump by red has the normals of
 * a bump by u. */
static void meshes_have_attributes(void **state)
{
    (void)state;
    static const char seen[] =
        "diffuse: 0, emissive: '= vertexColor.rgb + attribute(\"lacking\", vec3, [0, 0, .25])'";
    static const char bump[] = "input: { map: BumpMap, strength: 20, displacement: '= %s ^ 2' }";
    char path[] = "/tmp/matc_meshXXXXXX.ply", by_red[128], by_u[128];
    const int file = mkstemps(path, 4);
    assert_true(file >= 0 && !close(file));
    for (int colors = 0; colors < 2; colors++) {
        write_mesh(path, colors);
        GlContext *gl = frame_context();
        float *rgba = draw_mesh(gl, path, seen, "emissive");
        for (int i = 0; i < EDGE * EDGE; i++) {
            const double u = colors ? (i % EDGE + .5) / EDGE : 1,
                         v = colors ? (i / EDGE + .5) / EDGE : 1;
            const double want[3] = {u, v, colors ? .25 : 1.25};
            assert_true(fabs(rgba[4 * i] - want[0]) <= 1e-5 &&
                        fabs(rgba[4 * i + 1] - want[1]) <= 1e-5 &&
                        fabs(rgba[4 * i + 2] - want[2]) <= 1e-5);
        }
        free(rgba);
        gl_close(gl);
    }
    snprintf(by_red, sizeof by_red, bump, "vertexColor.r");
    snprintf(by_u, sizeof by_u, bump, "u");
    GlContext *gl = frame_context();
    float *red = draw_mesh(gl, path, by_red, "normal"), *u = draw_mesh(gl, path, by_u, "normal"),
          most = 0;
    for (int i = 0; i < 4 * EDGE * EDGE; i++) {
        most = fmaxf(most, fabsf(u[i] - u[0]));
        assert_true(fabsf(red[i] - u[i]) <= 2e-4f);
    }
    assert_true(most > .05f);
    free(red);
    free(u);
    gl_close(gl);
    assert_int_equal(unlink(path), 0);
}

/* A glTF's own attributes: red is u, as a float, green v, as a byte, blue the default of a name
 * that it lacks. */
static void gltf_has_attributes_of_its_own(void **state)
{
    (void)state;
    static const char seen[] =
        "diffuse: 0, emissive: '= [attribute(\"wetness\", float), attribute(\"Worn_2\", vec2).y, "
        "attribute(\"lacking\", float, .25)]'";
    static const struct {
        float position[4][3], wetness[4];
        unsigned char worn[4][4];
    } rows = {{{-3, 0, 3}, {3, 0, 3}, {3, 0, -3}, {-3, 0, -3}},
              {0, 1, 1, 0},
              {{9, 0}, {9, 0}, {9, 255}, {9, 255}}};
    char text[1024], folder[] = "/tmp/matc_ownXXXXXX", path[64], beside[64];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/own.gltf", folder);
    snprintf(beside, sizeof beside, "%s/own.bin", folder);
    snprintf(text, sizeof text,
             "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}"
             "],\"meshes\":[{"
             "\"primitives\":[{\"mode\":6,\"attributes\":{\"POSITION\":0,\"_WETNESS\":1,\"_WORN_"
             "2\":2}}]}],\"buffers\":[{"
             "\"uri\":\"own.bin\",\"byteLength\":%zu}],\"bufferViews\":[{\"buffer\":0,"
             "\"byteLength\":48},{\"buffer\":0,"
             "\"byteOffset\":48,\"byteLength\":16},{\"buffer\":0,\"byteOffset\":64,\"byteLength\":"
             "16,\"byteStride\":4}],"
             "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":"
             "\"VEC3\",\"min\":[-3,0,-3],"
             "\"max\":[3,0,3]},{\"bufferView\":1,\"componentType\":5126,\"count\":4,\"type\":"
             "\"SCALAR\"},{\"bufferView\":2,"
             "\"componentType\":5121,\"normalized\":true,\"count\":4,\"type\":\"VEC2\"}]}",
             sizeof rows);
    FILE *files[] = {fopen(path, "wb"), fopen(beside, "wb")};
    assert_true(files[0] && files[1] && fputs(text, files[0]) >= 0 &&
                fwrite(&rows, sizeof rows, 1, files[1]) == 1);
    assert_true(!fclose(files[0]) && !fclose(files[1]));
    GlContext *gl = frame_context();
    float *rgba = draw_mesh(gl, path, seen, "emissive");
    for (int i = 0; i < EDGE * EDGE; i++) {
        const double want[3] = {(i % EDGE + .5) / EDGE, (i / EDGE + .5) / EDGE, .25};
        for (int component = 0; component < 3; component++)
            if (!(fabs(rgba[4 * i + component] - want[component]) <= 1e-5))
                fail_msg("pixel %d, lane %d: %g, not %g", i, component,
                         (double)rgba[4 * i + component], want[component]);
    }
    free(rgba);
    gl_close(gl);
    assert_true(!unlink(path) && !unlink(beside) && !rmdir(folder));
}
#endif

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(drawn_as_said),
        cmocka_unit_test(objects_have_numbers),
#ifdef MATC_ASSIMP
        cmocka_unit_test(meshes_have_attributes),
        cmocka_unit_test(gltf_has_attributes_of_its_own),
#endif
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
