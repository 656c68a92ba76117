/* Errors of a driver, or of a set of materials: the message names the material and its place,
 * the format of a target, or a mesh that is too large. */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* One white pixel. */
static char *read_picture(void *user, const char *path, size_t *size, const char **why)
{
    static const unsigned char picture[] = {
        0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A, 0x1A, 0x0A, 0x00, 0x00, 0x00, 0x0D, 0x49, 0x48,
        0x44, 0x52, 0x00, 0x00, 0x00, 0x01, 0x00, 0x00, 0x00, 0x01, 0x08, 0x00, 0x00, 0x00,
        0x00, 0x3A, 0x7E, 0x9B, 0x55, 0x00, 0x00, 0x00, 0x0A, 0x49, 0x44, 0x41, 0x54, 0x78,
        0xDA, 0x63, 0xF8, 0x0F, 0x00, 0x01, 0x01, 0x01, 0x00, 0x1C, 0xB0, 0x8C, 0x99, 0x00,
        0x00, 0x00, 0x00, 0x49, 0x45, 0x4E, 0x44, 0xAE, 0x42, 0x60, 0x82};
    (void)user, (void)path, (void)why;
    char *bytes = malloc(sizeof picture);
    *size = sizeof picture;
    return bytes ? memcpy(bytes, picture, sizeof picture) : NULL;
}

static const char text[] =
    "materials:\n"
    "  plain: { material: Phong }\n"
    "  busy: { material: Phong, diffuse: { map: ImageMap, image: a.png }, specular: { map: "
    "ImageMap, image: b.png, bilinearFiltering: false } }\n"
    "objects: [{ object: Box, material: plain }, { object: Sphere, material: busy }]\n";

/* Message if `units` textures have room, with that layout. */
static void assert_refused(int units, const char *layout, const char *reported)
{
    MatcDocument *document;
    MatcOptions options;
    GlContext *gl = frame_context();
    matc_options_init(&options);
    options.read_file = read_picture;
    Scene *scene = frame_scene(text, &options, &document);
    options.layout = layout;
    gl->max_texture_units = units;
    Renderer *renderer = renderer_open(gl, &(RendererOptions){.compile = &options});
    assert_non_null(renderer);
    assert_false(renderer_set_scene(renderer, scene));
    if (strncmp(gl->error, reported, strlen(reported)) != 0)
        fail_msg("%s", gl->error);
    renderer_close(renderer);
    gl_close(gl);
    frame_forget(scene, document);
}

static void materials_are_named(void **state)
{
    (void)state;
    assert_refused(
        1, NULL,
        "scene.yaml:3:21: the material 'busy': it has 2 textures, and the driver room for 1");
    assert_refused(32, "none", "scene.yaml:2:22: the material 'plain': ");
}

/* -- a driver that cannot draw to halves */

enum { TEXTURES = 256, HALVES = GL_RGBA16F };

/* Formats of textures by their names, and that of the framebuffer's first. */
static struct {
    GlContext driver;
    GLenum formats[TEXTURES], drawn;
    GLuint bound;
} fake;

static void bind_texture(GLenum target, GLuint name)
{
    fake.bound = name;
    fake.driver.BindTexture(target, name);
}

static void store_texture(GLenum target, GLsizei levels, GLenum format, GLsizei width,
                          GLsizei height)
{
    assert_true(fake.bound < TEXTURES);
    fake.formats[fake.bound] = format;
    fake.driver.TexStorage2D(target, levels, format, width, height);
}

static void attach_texture(GLenum target, GLenum attachment, GLenum kind, GLuint texture,
                           GLint level)
{
    if (attachment == GL_COLOR_ATTACHMENT0)
        fake.drawn = fake.formats[texture];
    fake.driver.FramebufferTexture2D(target, attachment, kind, texture, level);
}

static GLenum refuse_halves(GLenum target)
{
    return fake.drawn == HALVES ? GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT
                                : fake.driver.CheckFramebufferStatus(target);
}

/* The message names the format, and no state remains: the next renderer, on a capable driver,
 * draws. */
static void targets_are_named(void **state)
{
    (void)state;
    static const char box[] = "image: { width: 8, height: 8 }\nobjects: [{ object: Box, material: "
                              "{ material: Phong } }]\n";
    MatcOptions compile;
    MatcDocument *document;
    GlContext *gl = frame_context();
    matc_options_init(&compile);
    Scene *scene = frame_scene(box, &compile, &document);
    fake.driver = *gl;
    gl->BindTexture = bind_texture;
    gl->TexStorage2D = store_texture;
    gl->FramebufferTexture2D = attach_texture;
    gl->CheckFramebufferStatus = refuse_halves;
    Renderer *renderer =
        /* light lies by itself */
        renderer_open(gl, &(RendererOptions){.compile = &compile, .fragment = true});
    assert_non_null(renderer);
    assert_false(renderer_set_scene(renderer, scene));
    assert_string_equal(
        gl->error, "the driver cannot draw to one of these formats: RGBA16F, and depth DEPTH32F");
    assert_false(renderer_frame(renderer));
    gl->CheckFramebufferStatus = fake.driver.CheckFramebufferStatus;
    assert_true(renderer_set_scene(renderer, scene) && renderer_frame(renderer));
    assert_true(gl_check(gl, "all of it"));
    renderer_close(renderer);
    gl_close(gl);
    frame_forget(scene, document);
}

/* A sparse file of 257 MiB, without disk space. */
static void meshes_too_large(void **state)
{
    (void)state;
    static const char large[] =
        "objects:\n- { object: Mesh, file: large.obj, material: { material: Phong } }\n";
    char folder[] = "/tmp/matc_large_XXXXXX", path[64], scene_path[64];
    MatcOptions options;
    Scene *scene = NULL;
    matc_options_init(&options);
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/large.obj", folder);
    snprintf(scene_path, sizeof scene_path, "%s/scene.yaml", folder);
    FILE *file = fopen(path, "wb");
    assert_true(file && !ftruncate(fileno(file), (off_t)257 << 20) && !fclose(file));
    MatcDocument *document = scene_read(scene_path, large, sizeof large - 1, &options, &scene);
    assert_null(scene);
    if (!strstr(matc_diagnostics(document, MATC_TEXT),
                "scene.yaml:2:25: error: cannot read 'large.obj': larger than 256 MiB"))
        fail_msg("%s", matc_diagnostics(document, MATC_TEXT));
    matc_document_free(document);
    assert_true(!remove(path) && !rmdir(folder));
}

/* The memory of shadow maps is checked before the allocation: the driver's layers, and bytes. */
static void shadow_maps(void **state)
{
    (void)state;
    static const struct {
        int lights, size;
        const char *reported; /* NULL: nothing */
    } cases[] = {
        {2, 16, NULL},
        {350, 16,
         "2100 shadow maps of 16 x 16 are asked for, the driver has 2048 of 16384 x 16384"},
        {3, 8192, "18 shadow maps of 8192 x 8192 take 4608 MiB; at most 4096 are made"},
        {171, 1024, "1026 shadow maps of 1024 x 1024 take 4104 MiB; at most 4096 are made"}};
    MatcOptions options;
    matc_options_init(&options);
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        static char scene_text[1 << 14];
        MatcDocument *document;
        size_t size = (size_t)snprintf(
            scene_text, sizeof scene_text,
            "shadowMaps: { size: %d }\nobjects: [{ object: Box, material: { material: Phong } "
            "}]\nlights:\n",
            cases[i].size);
        for (int k = 0; k < cases[i].lights; k++)
            size += (size_t)snprintf(scene_text + size, sizeof scene_text - size,
                                     "- { light: Point }\n");
        Scene *scene = frame_scene(scene_text, &options, &document);
        Renderer *renderer = renderer_open(gl, &(RendererOptions){.compile = &options});
        assert_non_null(renderer);
        assert_int_equal(renderer_set_scene(renderer, scene), !cases[i].reported);
        if (cases[i].reported)
            assert_string_equal(gl->error, cases[i].reported);
        renderer_close(renderer);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

/* A host may start with an empty scene: every method of indirect light must work without
 * materials. */
static void nothing_stands_there(void **state)
{
    (void)state;
    static const char *const ways[] = {"hybrid", "screen, bounces: 3"};
    enum { EDGE = 8, COMPONENTS = 4 };
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++) {
        char scene_text[512];
        MatcDocument *document;
        snprintf(scene_text, sizeof scene_text,
                 "image: { width: %d, height: %d }\nlights: [{ light: Point, position: [0, -2, 3] "
                 "}]\nindirect: { "
                 "method: %s }\n"
                 "objects: []\n",
                 EDGE, EDGE, ways[i]);
        Scene *scene = frame_scene(scene_text, &options, &document);
        float *rgba =
            frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
        for (int k = 0; k < COMPONENTS * EDGE * EDGE; k++)
            assert_true(k % COMPONENTS == 3 || rgba[k] == 0);
        free(rgba);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(materials_are_named), cmocka_unit_test(targets_are_named),
        cmocka_unit_test(meshes_too_large), cmocka_unit_test(shadow_maps),
        cmocka_unit_test(nothing_stands_there)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
