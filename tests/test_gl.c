/* The GL layer, in software: contexts, framebuffers, programs, uniforms, shapes, PNG files.
 * test_gl egl: by EGL; status 77 where there is none. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "compiler/base/output.h"
#include "runtime/gl/context.h"
#include "runtime/gl/framebuffer.h"
#include "runtime/gl/matrix.h"
#include "runtime/gl/mesh.h"
#include "runtime/gl/png_write.h"
#include "runtime/gl/program.h"
#include "runtime/gl/texture.h"
#include "runtime/gl/uniforms.h"
#include "runtime/view/pixels.h"
#include <math.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef SOURCE_FOLDER
#define SOURCE_FOLDER "."
#endif
enum { SKIPPED = 77 };

static GlContext *open_context(bool core)
{
    char error[512] = "";
    GlContext *gl = gl_open(GL_KIND_osmesa, core, error, sizeof error);
    if (!gl)
        fail_msg("%s", error);
    return gl;
}

static void context_opens(void **state)
{
    (void)state;
    for (int core = 0; core < 2; core++) {
        GlContext *gl = open_context(core);
        print_message("%s: GL %s; GLSL %s; %s; %d texels, %d units, %d targets\n", core ? "core" : "compatibility",
                      gl->version, gl->language, gl->renderer, gl->max_texture_size, gl->max_texture_units,
                      gl->max_draw_buffers);
        assert_true(gl->major > 3 || (gl->major == 3 && gl->minor >= 3) || !core);
        gl_close(gl);
    }
    char error[64] = "";
    assert_null(gl_open(GL_KIND_count, true, error, sizeof error));
    assert_string_equal(error, "unknown kind of GL context");
}

static void two_contexts_take_turns(void **state)
{
    (void)state;
    GlContext *first = open_context(true), *second = open_context(false);
    assert_true(gl_use(first));
    GLuint program = first->CreateProgram();
    assert_true(gl_use(second));
    assert_true(gl_use(first));
    first->DeleteProgram(program);
    assert_true(gl_check(first, "taking turns"));
    gl_close(first);
    gl_close(second);
}

/* A vertex and a fragment text that write two targets: `value` and its double. */
typedef struct {
    bool core;
    const char *vertex, *fragment;
} Language;

static const Language languages[] = {
    {false, "attribute vec3 position; void main() { gl_Position = vec4(position, 1.); }",
     "#version 110\n#extension GL_ARB_draw_buffers : require\n"
     "uniform vec4 value; void main() { gl_FragData[0] = value; gl_FragData[1] = 2. * value; }"},
    {true,
     "#version 330 core\nlayout(location = 0) in vec3 position; void main() { gl_Position = vec4(position, 1.); }",
     "#version 330 core\nuniform vec4 value; layout(location = 0) out vec4 a; layout(location = 1) out vec4 b;"
     "void main() { a = value; b = 2. * value; }"},
    {true, "#version 330 core\nin vec3 position; void main() { gl_Position = vec4(position, 1.); }",
     "#version 330 core\nuniform vec4 value; out vec4 first; out vec4 second;"
     "void main() { first = value; second = 2. * value; }"},
    {true,
     "#version 450 core\nlayout(location = 0) in vec3 position; void main() { gl_Position = vec4(position, 1.); }",
     "#version 450 core\nlayout(location = 0) uniform vec4 value; layout(location = 0) out vec4 a; layout(location = "
     "1) out vec4 b;"
     "void main() { a = value; b = 2. * value; }"},
    {true, "#version 300 es\nlayout(location = 0) in vec3 position; void main() { gl_Position = vec4(position, 1.); }",
     "#version 300 es\nprecision highp float; uniform vec4 value;"
     "layout(location = 0) out vec4 a; layout(location = 1) out vec4 b; void main() { a = value; b = 2. * value; }"},
};

static GLuint make_program(GlContext *gl, const Language *language)
{
    static const char *const outputs[] = {"first", "second"};
    GLuint program = program_make(
        gl, &(ProgramText){
                .vertex = {language->vertex}, .fragment = {language->fragment}, .outputs = outputs, .output_count = 2});
    if (!program)
        fail_msg("%s", gl->error);
    return program;
}

/* Of the current program; false: it has none such. */
static bool set(GlContext *gl, GLuint program, const char *name, const float *values)
{
    GlUniforms uniforms;
    assert_true(uniforms_read(gl, program, &uniforms));
    int found = uniforms_find(&uniforms, name);
    gl->UseProgram(program);
    if (found >= 0)
        uniform_set(gl, &uniforms.at[found], values);
    uniforms_free(&uniforms);
    return found >= 0;
}

/* Half floats keep these numbers exactly; outside of [0, 1] nothing is clamped; the plane is met at its middle. */
static void draw_constant(GlContext *gl, GLuint program, GLenum format)
{
    const float value[4] = {-3.5f, 0.25f, 1000, 1};
    Framebuffer target;
    Mesh plane;
    float texels[5 * 3 * 4];
    assert_true(framebuffer_make(gl, &(FramebufferSpec){5, 3, 2, format, true}, &target));
    assert_true(mesh_make(gl, SHAPE_plane, &plane));
    assert_true(set(gl, program, "value", value));
    gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    mesh_draw(gl, &plane);
    for (int color = 0; color < 2; color++) {
        assert_true(framebuffer_read(gl, &target, color, texels));
        for (int i = 0; i < 5 * 3 * 4; i++)
            assert_true(texels[i] == (float)(color + 1) * value[i % 4]);
    }
    assert_false(framebuffer_read(gl, &target, 2, texels));
    mesh_delete(gl, &plane);
    framebuffer_delete(gl, &target);
}

static void every_language_draws(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof languages / sizeof *languages; i++) {
        GlContext *gl = open_context(languages[i].core);
        GLuint program = make_program(gl, &languages[i]);
        draw_constant(gl, program, GL_RGBA32F);
        draw_constant(gl, program, GL_RGBA16F);
        assert_false(set(gl, program, "absent", &(float){1}));
        assert_true(gl_check(gl, "drawing"));
        gl->DeleteProgram(program);
        gl_close(gl);
    }
}

/* EGL does the same; it and OSMesa get on in one process. */
static void egl_draws(void **state)
{
    (void)state;
    char error[512] = "";
    GlContext *first = open_context(true);
    for (size_t i = 0; i < sizeof languages / sizeof *languages; i++) {
        GlContext *gl = gl_open(GL_KIND_egl, languages[i].core, error, sizeof error);
        if (!gl)
            fail_msg("%s", error);
        GLuint program = make_program(gl, &languages[i]);
        draw_constant(gl, program, GL_RGBA32F);
        gl_close(gl);
    }
    assert_true(gl_use(first));
    GLuint program = make_program(first, &languages[1]);
    draw_constant(first, program, GL_RGBA32F);
    gl_close(first);
}

static void egl_contexts_take_turns(void **state)
{
    (void)state;
    char error[512] = "";
    GlContext *first = gl_open(GL_KIND_egl, true, error, sizeof error);
    GlContext *second = gl_open(GL_KIND_egl, false, error, sizeof error);
    if (!first || !second)
        fail_msg("%s", error);
    print_message("EGL: %s; %s; %s\n", first->version, first->renderer, first->hardware ? "hardware" : "software");
    assert_true(gl_use(first));
    GLuint program = first->CreateProgram();
    gl_close(second); /* not the current one, and on the same display */
    first->DeleteProgram(program);
    assert_true(gl_check(first, "outliving another"));
    gl_close(first);
}

static void kinds_have_names(void **state)
{
    (void)state;
    GlKind kind = GL_KIND_count;
    for (int i = 0; i < GL_KIND_count; i++)
        assert_true(gl_kind_find(gl_kind_name((GlKind)i), &kind) && (int)kind == i);
    assert_false(gl_kind_find("glx", &kind));
}

static void faults_are_said(void **state)
{
    (void)state;
    GlContext *gl = open_context(true);
    const char *good = languages[1].vertex;
    assert_int_equal(
        program_make(gl, &(ProgramText){.vertex = {good}, .fragment = {"#version 330 core\nvoid main() { x = 1.; }"}}),
        0);
    assert_int_equal(strncmp(gl->error, "fragment: ", 10), 0);
    assert_non_null(strstr(gl->error, "x"));
    assert_int_equal(program_make(gl, &(ProgramText){.vertex = {good}}), 0);
    assert_string_equal(gl->error, "fragment: no text");
    const char *undefined = "#version 330 core\nout vec4 c; float f(); void main() { c = vec4(f()); }";
    assert_int_equal(program_make(gl, &(ProgramText){.vertex = {good}, .fragment = {undefined}}), 0);
    assert_int_equal(strncmp(gl->error, "link: ", 6), 0);
    Framebuffer none;
    assert_false(framebuffer_make(gl, &(FramebufferSpec){0, 4, 1, GL_RGBA8, false}, &none));
    assert_false(framebuffer_make(gl, &(FramebufferSpec){1 << 20, 4, 1, GL_RGBA8, false}, &none));
    assert_false(framebuffer_make(gl, &(FramebufferSpec){4, 4, 1, GL_RGB9_E5, false}, &none));
    assert_int_equal(none.name, 0);
    assert_int_equal(texture_make(gl, &(TextureSpec){.width = 2, .height = 2, .lanes = 3, .bytes = (uint8_t[12]){0}}),
                     0);
    assert_int_equal(texture_make(gl, &(TextureSpec){.width = 2, .height = 2, .lanes = 4}), 0);
    assert_true(gl_check(gl, "refusing"));
    gl_close(gl);
}

static void depth_only_is_complete(void **state)
{
    (void)state;
    GlContext *gl = open_context(true);
    Framebuffer depth;
    assert_true(framebuffer_make(gl, &(FramebufferSpec){4, 4, 0, GL_NONE, true}, &depth));
    framebuffer_delete(gl, &depth);
    gl_close(gl);
}

/* Looks a texture up at (u, v). */
static void look_up(GlContext *gl, const TextureSpec *spec, const float uv[2], float rgba[4])
{
    static const char fragment[] = "#version 330 core\nuniform sampler2D image; uniform vec2 at; out vec4 c;"
                                   "void main() { c = texture(image, at); }";
    GLuint program = program_make(gl, &(ProgramText){.vertex = {languages[1].vertex}, .fragment = {fragment}});
    GLuint texture = texture_make(gl, spec);
    Framebuffer target;
    Mesh plane;
    assert_true(program && texture);
    assert_true(mesh_make(gl, SHAPE_plane, &plane));
    assert_true(framebuffer_make(gl, &(FramebufferSpec){1, 1, 1, GL_RGBA32F, false}, &target));
    texture_bind(gl, texture, 3);
    assert_true(set(gl, program, "image", &(float){3}));
    assert_true(set(gl, program, "at", uv));
    mesh_draw(gl, &plane);
    assert_true(framebuffer_read(gl, &target, 0, rgba));
    framebuffer_delete(gl, &target);
    mesh_delete(gl, &plane);
    gl->DeleteTextures(1, &texture);
    gl->DeleteProgram(program);
}

static void textures_keep_their_numbers(void **state)
{
    (void)state;
    GlContext *gl = open_context(true);
    const float floats[3] = {-2, 0.1f, 1e6f};
    const uint8_t bytes[2 * 4] = {0, 51, 102, 255, 255, 204, 153, 0};
    float found[4];
    look_up(gl, &(TextureSpec){.width = 3, .height = 1, .lanes = 1, .floats = floats}, (float[]){5, 0.5f}, found);
    assert_true(found[0] == 1e6f); /* clamped */
    look_up(gl, &(TextureSpec){.width = 3, .height = 1, .lanes = 1, .floats = floats, .wrap = GL_REPEAT},
            (float[]){4.1f, 0.5f}, found);
    assert_true(found[0] == -2); /* repeated */
    look_up(gl, &(TextureSpec){.width = 1, .height = 2, .lanes = 4, .bytes = bytes}, (float[]){0.5f, 0.25f}, found);
    assert_float_equal(found[1], 0.2, 1e-6); /* row 0 is the bottom */
    look_up(gl, &(TextureSpec){.width = 1, .height = 2, .lanes = 4, .bytes = bytes, .linear = true},
            (float[]){0.5f, 0.5f}, found);
    assert_float_equal(found[0], 0.5, 1e-2); /* the middle between */
    gl_close(gl);
}

/* All codes of an sRGB texture, by the driver, against IEC 61966-2-1: tests/bounds.def states the worst, and no mix of texels errs by more. */
static void every_code_of_srgb_is_decoded(void **state)
{
    (void)state;
    enum { CODES = 256 };
    const double stated = 1.3e-3;
    static const char fragment[] = "#version 330 core\nuniform sampler2D image; out vec4 c;"
                                   "void main() { c = texelFetch(image, ivec2(gl_FragCoord.xy), 0); }";
    GlContext *gl = open_context(true);
    uint8_t texels[CODES * 4];
    float rgba[CODES * 4];
    Framebuffer target;
    Mesh plane;
    double worst = 0;
    int at = 0;
    for (int i = 0; i < CODES * 4; i++)
        texels[i] = (uint8_t)(i / 4);
    GLuint program = program_make(gl, &(ProgramText){.vertex = {languages[1].vertex}, .fragment = {fragment}});
    GLuint texture = texture_make(
        gl, &(TextureSpec){
                .width = CODES, .height = 1, .lanes = 4, .bytes = texels, .format = texture_format("SRGB8_ALPHA8")});
    assert_true(program && texture);
    assert_true(mesh_make(gl, SHAPE_plane, &plane));
    assert_true(framebuffer_make(gl, &(FramebufferSpec){CODES, 1, 1, GL_RGBA32F, false}, &target));
    texture_bind(gl, texture, 0);
    assert_true(set(gl, program, "image", &(float){0}));
    mesh_draw(gl, &plane);
    assert_true(framebuffer_read(gl, &target, 0, rgba));
    for (int code = 0; code < CODES; code++) {
        const double v = code / 255., linear = v <= 0.04045 ? v / 12.92 : pow((v + 0.055) / 1.055, 2.4);
        for (int lane = 0; lane < 4; lane++) {
            const double off = fabs((double)rgba[4 * code + lane] - (lane == 3 ? v : linear));
            at = off > worst ? code : at;
            worst = fmax(worst, off);
        }
    }
    print_message("%s: sRGB codes err by %.2e, most at %d\n", gl->renderer, worst, at);
    assert_true(worst <= stated);
    framebuffer_delete(gl, &target);
    mesh_delete(gl, &plane);
    gl->DeleteTextures(1, &texture);
    gl->DeleteProgram(program);
    gl_close(gl);
}

/* Stripes of four texels, seen so flat that a pixel covers a quarter of a texel across them and 16 along: greatest less least value of the
 * pixels. */
static double contrast(GlContext *gl, int anisotropy)
{
    enum { SIDE = 64, STRIPE = 4 };
    static const char fragment[] = "#version 330 core\nuniform sampler2D image; out vec4 c;"
                                   "void main() { c = texture(image, gl_FragCoord.xy * vec2(0.25, 16) / 64.); }";
    static uint8_t texels[SIDE * SIDE];
    static float rgba[SIDE * SIDE * 4];
    Framebuffer target;
    Mesh plane;
    for (int i = 0; i < SIDE * SIDE; i++)
        texels[i] = i % SIDE / STRIPE % 2 ? 255 : 0;
    GLuint program = program_make(gl, &(ProgramText){.vertex = {languages[1].vertex}, .fragment = {fragment}});
    GLuint texture = texture_make(gl, &(TextureSpec){.width = SIDE,
                                                     .height = SIDE,
                                                     .lanes = 1,
                                                     .bytes = texels,
                                                     .wrap = GL_REPEAT,
                                                     .mipmaps = true,
                                                     .anisotropy = anisotropy});
    assert_true(program && texture);
    assert_true(mesh_make(gl, SHAPE_plane, &plane));
    assert_true(framebuffer_make(gl, &(FramebufferSpec){SIDE, SIDE, 1, GL_RGBA32F, false}, &target));
    texture_bind(gl, texture, 0);
    assert_true(set(gl, program, "image", &(float){0}));
    mesh_draw(gl, &plane);
    assert_true(framebuffer_read(gl, &target, 0, rgba));
    float low = 1, high = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        low = fminf(low, rgba[4 * i]);
        high = fmaxf(high, rgba[4 * i]);
    }
    framebuffer_delete(gl, &target);
    mesh_delete(gl, &plane);
    gl->DeleteTextures(1, &texture);
    gl->DeleteProgram(program);
    return high - low;
}

/* A footprint of 1 : 64. One sample is from mipmap 4, where no stripe is left; 16 of them are from mipmap 0. */
static void footprints_are_sampled_along(void **state)
{
    (void)state;
    char error[512] = "";
    GlContext *gl = gl_open(GL_KIND_egl, true, error, sizeof error);
    if (!gl)
        fail_msg("%s", error);
    const int most = gl->max_anisotropy;
    const double one = contrast(gl, 1), all = contrast(gl, 16);
    print_message("%s: %d samples; contrast of one %.3f, of all %.3f\n", gl->renderer, most, one, all);
    gl_close(gl);
    assert_true(one < 0.1);
    if (most < 16)
        print_message("SKIPPED: this driver takes no 16 samples along a footprint, so none was drawn\n");
    else
        assert_true(all > 0.9);
}

/* The vertex of a shape that is nearest to (u, v) in a patch. */
static const ShapeVertex *vertex_at(const Shape *shape, float u, float v)
{
    const ShapeVertex *best = shape->vertices;
    for (int i = 0; i < shape->vertex_count; i++) {
        const ShapeVertex *w = &shape->vertices[i];
        if (hypotf(w->uv[0] - u, w->uv[1] - v) < hypotf(best->uv[0] - u, best->uv[1] - v))
            best = w;
    }
    return best;
}

/* dP/du x dP/dv is along the normal wherever it does not vanish, and triangles turn counterclockwise around it. */
static void shapes_are_oriented(void **state)
{
    (void)state;
    for (int kind = 0; kind < SHAPE_count; kind++) {
        Shape shape;
        ShapeKind found;
        assert_true(shape_make((ShapeKind)kind, &shape));
        assert_true(shape_find(shape_name((ShapeKind)kind), &found) && (int)found == kind);
        for (int i = 0; i < shape.vertex_count; i++) {
            const ShapeVertex *w = &shape.vertices[i];
            const float *a = w->tangentU, *b = w->tangentV, *n = w->normal;
            float c[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
            float length = sqrtf(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
            assert_float_equal(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-5);
            assert_float_equal(c[0] * n[0] + c[1] * n[1] + c[2] * n[2], length, 1e-4);
        }
        for (int i = 0; i < shape.index_count; i += 3) {
            const ShapeVertex *t[3];
            float a[3], b[3], turn = 0;
            for (int k = 0; k < 3; k++)
                t[k] = &shape.vertices[shape.indices[i + k]];
            for (int k = 0; k < 3; k++) {
                a[k] = t[1]->position[k] - t[0]->position[k];
                b[k] = t[2]->position[k] - t[0]->position[k];
            }
            for (int k = 0; k < 3; k++)
                turn += (a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]) * t[0]->normal[k];
            assert_true(turn > -1e-7f);
        }
        shape_free(&shape);
    }
    assert_false(shape_find("teapot", &(ShapeKind){0}));
}

static void derivatives_are_those_of_the_position(void **state)
{
    (void)state;
    for (int kind = 0; kind < SHAPE_count; kind++) {
        if (kind == SHAPE_cube)
            continue; /* six patches share their uv */
        Shape shape;
        assert_true(shape_make((ShapeKind)kind, &shape));
        const bool flat = kind == SHAPE_plane || kind == SHAPE_ground;
        const ShapeVertex *here = vertex_at(&shape, flat ? 0 : 0.25f, flat ? 0 : 0.75f);
        const ShapeVertex *next = vertex_at(&shape, here->uv[0] + (flat ? 1 : 1.f / 192), here->uv[1]);
        assert_true(next != here && next->uv[1] == here->uv[1]);
        for (int k = 0; k < 3; k++)
            assert_float_equal((next->position[k] - here->position[k]) / (next->uv[0] - here->uv[0]), here->tangentU[k],
                               0.2);
        shape_free(&shape);
    }
}

static void matrices_invert(void **state)
{
    (void)state;
    Mat4 camera = mat4_look_at((float[]){3, -4, 2}, (float[]){0, 0, 0.5f}, (float[]){0, 0, 1});
    Mat4 lens = mat4_perspective(0.3f, 1.5f, 1, 10), all = mat4_multiply(&lens, &camera), back, one;
    assert_true(mat4_inverse(&all, &back));
    one = mat4_multiply(&back, &all);
    for (int i = 0; i < 16; i++)
        assert_float_equal(one.m[i], (i % 5 == 0), 1e-4);
    assert_false(mat4_inverse(&(Mat4){{0}}, &back));
    Mat4 stretched = {{2, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}; /* a mirror, too */
    Mat3 normal = mat3_normal(&stretched);
    assert_float_equal(normal.m[0] / normal.m[8], 0.5, 1e-6);
    assert_true(normal.m[8] > 0 && normal.m[4] < 0);
}

/* By libpng's own reader, from the top row down. */
static void check_png(const PngPicture *picture, const uint8_t *file, size_t size)
{
    enum { LANES = 4 };
    png_image image = {.version = PNG_IMAGE_VERSION};
    assert_true(png_image_begin_read_from_memory(&image, file, size));
    assert_int_equal(image.width, picture->width);
    assert_int_equal(image.height, picture->height);
    image.format = PNG_FORMAT_RGBA;
    uint8_t *pixels = malloc(PNG_IMAGE_SIZE(image));
    assert_true(png_image_finish_read(&image, NULL, pixels, 0, NULL));
    for (int i = 0; i < picture->width * picture->height; i++) {
        int row = picture->height - 1 - i / picture->width, column = i % picture->width;
        const uint8_t *wanted = picture->bytes + (row * picture->width + column) * picture->lanes;
        for (int k = 0; k < LANES; k++)
            assert_int_equal(pixels[LANES * i + k], k < picture->lanes ? wanted[k] : 255);
    }
    free(pixels);
}

static void png_comes_back(void **state)
{
    (void)state;
    enum { W = 7, H = 3 };
    for (int lanes = 3; lanes <= 4; lanes++) {
        uint8_t bytes[W * H * 4];
        PngPicture picture = {W, H, lanes, bytes};
        for (int i = 0; i < W * H * lanes; i++)
            bytes[i] = (uint8_t)(i * 37 + lanes);
        size_t size;
        const char *why;
        uint8_t *file = png_write(&picture, &size, &why);
        assert_non_null(file);
        check_png(&picture, file, size);
        free(file);
    }
}

static void no_picture_is_refused(void **state)
{
    (void)state;
    const PngPicture wrong[] = {
        {0, 1, 3, (uint8_t[3]){0}}, {1, PNG_SIZE_LIMIT + 1, 3, NULL}, {1, 1, 2, (uint8_t[2]){0}}};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        size_t size;
        const char *why = NULL;
        assert_null(png_write(&wrong[i], &size, &why));
        assert_non_null(why);
    }
}

static void encoding_is_srgb(void **state)
{
    (void)state;
    assert_int_equal(pixels_encode(0), 0);
    assert_int_equal(pixels_encode(NAN), 0);
    assert_int_equal(pixels_encode(INFINITY), 255);
    assert_int_equal(pixels_encode(0.2158605), 128);
}

static bool has_egl(void)
{
    char error[512] = "";
    GlContext *gl = gl_open(GL_KIND_egl, true, error, sizeof error);
    bool there = gl != NULL;
    if (!there)
        printf("SKIPPED: no EGL, so nothing was drawn by it: %s\n", error);
    gl_close(gl);
    return there;
}

int main(int count, char **arguments)
{
    const struct CMUnitTest egl[] = {cmocka_unit_test(egl_draws), cmocka_unit_test(egl_contexts_take_turns),
                                     cmocka_unit_test(footprints_are_sampled_along)};
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(context_opens),
        cmocka_unit_test(two_contexts_take_turns),
        cmocka_unit_test(every_language_draws),
        cmocka_unit_test(kinds_have_names),
        cmocka_unit_test(faults_are_said),
        cmocka_unit_test(depth_only_is_complete),
        cmocka_unit_test(textures_keep_their_numbers),
        cmocka_unit_test(every_code_of_srgb_is_decoded),
        cmocka_unit_test(shapes_are_oriented),
        cmocka_unit_test(derivatives_are_those_of_the_position),
        cmocka_unit_test(matrices_invert),
        cmocka_unit_test(png_comes_back),
        cmocka_unit_test(no_picture_is_refused),
        cmocka_unit_test(encoding_is_srgb),
    };
    if (count < 2 || strcmp(arguments[1], "egl") != 0)
        return cmocka_run_group_tests(tests, NULL, NULL);
    return has_egl() ? cmocka_run_group_tests(egl, NULL, NULL) : SKIPPED;
}
