/* The GL layer and the preview, in software: contexts, framebuffers, programs, shapes, PNG files, and a whole picture.
 * With TEST_GL_PICTURES=folder in the environment, the pictures are left there to be looked at.
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
#include "runtime/view/resolve.h"
#include "runtime/view/view.h"
#include <math.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifndef SOURCE_FOLDER
#define SOURCE_FOLDER "."
#endif
enum { SKIPPED = 77 };
#define LINES(...) #__VA_ARGS__ "\n"

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

/* Half floats keep these numbers exactly; outside of [0, 1] nothing is clamped; the plane is met at its middle. */
static void draw_constant(GlContext *gl, GLuint program, GLenum format)
{
    const float value[4] = {-3.5f, 0.25f, 1000, 1};
    Framebuffer target;
    Mesh plane;
    float texels[5 * 3 * 4];
    assert_true(framebuffer_make(gl, &(FramebufferSpec){5, 3, 2, format, true}, &target));
    assert_true(mesh_make(gl, SHAPE_plane, &plane));
    assert_true(program_set(gl, program, &(ProgramValue){"value", 4, value}));
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
        assert_false(program_set(gl, program, &(ProgramValue){"absent", 1, &(float){1}}));
        assert_false(program_set(gl, program, &(ProgramValue){"value", 3, (float[3]){1, 2, 3}}));
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
    assert_int_equal(texture_make(gl, &(TextureSpec){2, 2, 3, (uint8_t[12]){0}, NULL, false, false, false}), 0);
    assert_int_equal(texture_make(gl, &(TextureSpec){2, 2, 4, NULL, NULL, false, false, false}), 0);
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
    assert_true(program_set(gl, program, &(ProgramValue){"image", 1, &(float){3}}));
    assert_true(program_set(gl, program, &(ProgramValue){"at", 2, uv}));
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
    look_up(gl, &(TextureSpec){3, 1, 1, NULL, floats, false, false, false}, (float[]){5, 0.5f}, found);
    assert_true(found[0] == 1e6f); /* clamped */
    look_up(gl, &(TextureSpec){3, 1, 1, NULL, floats, false, true, false}, (float[]){4.1f, 0.5f}, found);
    assert_true(found[0] == -2); /* repeated */
    look_up(gl, &(TextureSpec){1, 2, 4, bytes, NULL, false, false, false}, (float[]){0.5f, 0.25f}, found);
    assert_float_equal(found[1], 0.2, 1e-6); /* row 0 is the bottom */
    look_up(gl, &(TextureSpec){1, 2, 4, bytes, NULL, true, false, false}, (float[]){0.5f, 0.5f}, found);
    assert_float_equal(found[0], 0.5, 1e-2); /* the middle between */
    gl_close(gl);
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
        float step = kind == SHAPE_plane ? 1 : 1.f / 192;
        const ShapeVertex *here = vertex_at(&shape, kind == SHAPE_plane ? 0 : 0.25f, kind == SHAPE_plane ? 0 : 0.75f);
        const ShapeVertex *next = vertex_at(&shape, here->uv[0] + step, here->uv[1]);
        for (int k = 0; k < 3; k++)
            assert_float_equal((next->position[k] - here->position[k]) / step, here->tangentU[k], 0.2);
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
    assert_int_equal(resolve_encode(0), 0);
    assert_int_equal(resolve_encode(NAN), 0);
    assert_int_equal(resolve_encode(INFINITY), 255);
    assert_int_equal(resolve_encode(0.2158605), 128);
}

static char *read_text(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        fail_msg("%s is missing", path);
    char *text = calloc(1, 1 << 16);
    assert_non_null(text);
    size_t size = fread(text, 1, (1 << 16) - 1, file);
    assert_true(size > 0);
    fclose(file);
    return text;
}

/* A material by hand: plain floats in the four targets; a checker of two colours, or what the uniforms say. */
static const char vertex_text[] = "#version 330 core\n" LINES(
    layout(location = 0) in vec3 position; layout(location = 1) in vec3 normal; layout(location = 2) in vec2 texcoord;
    uniform mat4 matc_worldFromLocal; uniform mat4 matc_clipFromWorld; uniform mat3 matc_eyeNormalFromLocal;
    out vec3 eyeNormal; out vec2 uv; void main() {
        eyeNormal = matc_eyeNormalFromLocal * normal;
        uv = texcoord;
        gl_Position = matc_clipFromWorld * (matc_worldFromLocal * vec4(position, 1.));
    });
static const char fragment_text[] = "#version 330 core\n" LINES(
    in vec3 eyeNormal; in vec2 uv; uniform vec3 dark; uniform vec3 specular; uniform vec3 transparency;
    uniform float shininess; uniform sampler2D image; layout(location = 0) out vec4 a; layout(location = 1) out vec4 b;
    layout(location = 2) out vec4 c; layout(location = 3) out vec4 d; void main() {
        vec3 n = normalize(eyeNormal);
        a = vec4(gl_FrontFacing ? n : -n, shininess);
        b = vec4(mix(dark, texture(image, uv).rgb, mod(floor(uv.x * 16.) + floor(uv.y * 8.), 2.)), 0.);
        c = vec4(specular, 0.);
        d = vec4(transparency, 0.);
    });
static const char unpack_text[] = LINES(
    struct Surface {
        vec3 normal;
        vec3 diffuse;
        vec3 specular;
        float shininess;
        vec3 transparency;
        float transparencyShininess;
        vec3 diffuseTransparency;
        vec3 emissive;
    };
    uniform sampler2D matc_gbuffer0; uniform sampler2D matc_gbuffer1; uniform sampler2D matc_gbuffer2;
    uniform sampler2D matc_gbuffer3; Surface unpackSurface(ivec2 pixel) {
        vec4 a = texelFetch(matc_gbuffer0, pixel, 0);
        return Surface(a.xyz, texelFetch(matc_gbuffer1, pixel, 0).rgb, texelFetch(matc_gbuffer2, pixel, 0).rgb, a.w,
                       texelFetch(matc_gbuffer3, pixel, 0).rgb, 0., vec3(0.), vec3(0.));
    });

typedef struct {
    const char *name;
    ShapeKind shape;
    uint8_t light[4]; /* of the checker */
    float dark[3], specular[3], transparency[3], shininess;
} Case;

static const Case cases[] = {
    {"clay", SHAPE_sphere, {190, 190, 190, 255}, {0.5f, 0.5f, 0.5f}, {0, 0, 0}, {0, 0, 0}, 4},
    {"paint", SHAPE_sphere, {150, 14, 6, 255}, {0.6f, 0.55f, 0.45f}, {0.5f, 0.5f, 0.5f}, {0, 0, 0}, 60},
    {"metal", SHAPE_torus, {20, 16, 10, 255}, {0.08f, 0.06f, 0.04f}, {1, 0.78f, 0.4f}, {0, 0, 0}, 30},
    {"glass", SHAPE_sphere, {30, 90, 160, 255}, {0.1f, 0.3f, 0.6f}, {0.8f, 0.8f, 0.8f}, {0.7f, 0.8f, 0.9f}, 500},
    {"cube", SHAPE_cube, {60, 140, 90, 255}, {0.7f, 0.7f, 0.6f}, {0.2f, 0.2f, 0.2f}, {0, 0, 0}, 20},
    {"tiles", SHAPE_plane, {40, 60, 120, 255}, {0.7f, 0.7f, 0.7f}, {0.4f, 0.4f, 0.4f}, {0, 0, 0}, 40},
};

typedef struct {
    char *screen, *light;
    int size;
} Texts;

static void render_case(const Case *c, const Texts *texts, GlContext *gl, unsigned char *rgb)
{
    char error[4096] = "";
    const ViewTexture texture = {"image", {1, 1, 4, c->light, NULL, true, true, false}};
    const ProgramValue values[] = {{"dark", 3, c->dark},
                                   {"specular", 3, c->specular},
                                   {"transparency", 3, c->transparency},
                                   {"shininess", 1, &c->shininess},
                                   {"absent", 1, &c->shininess}};
    const ViewProgram program = {.vertex_text = vertex_text,
                                 .fragment_text = fragment_text,
                                 .unpack_text = unpack_text,
                                 .textures = &texture,
                                 .texture_count = 1,
                                 .uniforms = values,
                                 .uniform_count = 5};
    const ViewOptions options = {.shape = c->shape,
                                 .width = texts->size,
                                 .height = texts->size,
                                 .supersampling = 4,
                                 .screen_text = texts->screen,
                                 .light_text = texts->light,
                                 .gl = gl};
    if (!view_render(&options, &program, rgb, error, sizeof error))
        fail_msg("%s", error);
    const char *folder = getenv("TEST_GL_PICTURES");
    if (!folder)
        return;
    char path[512];
    snprintf(path, sizeof path, "%s/%s.png", folder, c->name);
    size_t size;
    const char *why;
    uint8_t *file = png_write(&(PngPicture){texts->size, texts->size, 3, rgb}, &size, &why);
    if (!file || (why = output_write(path, file, size)))
        fail_msg("%s: %s", path, why);
    free(file);
}

static void assert_shows_something(const unsigned char *rgb, int size)
{
    const unsigned char *middle = rgb + 3 * (size / 2 * size + size / 2), *corner = rgb;
    int least = 255, most = 0, differing = 0;
    for (int i = 0; i < size * size * 3; i++) {
        least = rgb[i] < least ? rgb[i] : least;
        most = rgb[i] > most ? rgb[i] : most;
    }
    for (int k = 0; k < 3; k++)
        differing |= middle[k] != corner[k];
    assert_true(differing);
    assert_true(most - least > 60);
}

static void materials_are_seen(void **state)
{
    (void)state;
    Texts texts = {read_text(SOURCE_FOLDER "/runtime/view/screen.glsl"),
                   read_text(SOURCE_FOLDER "/runtime/view/light.glsl"), getenv("TEST_GL_PICTURES") ? 384 : 96};
    unsigned char *rgb = malloc((size_t)texts.size * (size_t)texts.size * 3);
    assert_non_null(rgb);
    GlContext *gl = open_context(true);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        render_case(&cases[i], &texts, i % 2 ? NULL : gl, rgb); /* in a context of ours and in its own */
        assert_shows_something(rgb, texts.size);
        assert_true(gl_use(gl)); /* its own took ours away */
    }
    gl_close(gl);
    free(rgb);
    free(texts.screen);
    free(texts.light);
}

static void view_refuses(void **state)
{
    (void)state;
    char error[512] = "";
    unsigned char rgb[3];
    ViewProgram program = {
        .vertex_text = vertex_text, .fragment_text = "#version 330 core\nwrong", .unpack_text = unpack_text};
    ViewOptions options = {.width = 1, .height = 1, .screen_text = "void main() { }", .light_text = "void main() { }"};
    assert_false(view_render(&options, &program, rgb, error, sizeof error));
    assert_int_equal(strncmp(error, "fragment: ", 10), 0);
    options.width = 100000;
    assert_false(view_render(&options, &program, rgb, error, sizeof error));
    options.width = 1, options.supersampling = 9;
    assert_false(view_render(&options, &program, rgb, error, sizeof error));
    assert_string_equal(error, "supersampling is 1 to 8");
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
    const struct CMUnitTest egl[] = {cmocka_unit_test(egl_draws), cmocka_unit_test(egl_contexts_take_turns)};
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(context_opens),
        cmocka_unit_test(two_contexts_take_turns),
        cmocka_unit_test(every_language_draws),
        cmocka_unit_test(kinds_have_names),
        cmocka_unit_test(faults_are_said),
        cmocka_unit_test(depth_only_is_complete),
        cmocka_unit_test(textures_keep_their_numbers),
        cmocka_unit_test(shapes_are_oriented),
        cmocka_unit_test(derivatives_are_those_of_the_position),
        cmocka_unit_test(matrices_invert),
        cmocka_unit_test(png_comes_back),
        cmocka_unit_test(no_picture_is_refused),
        cmocka_unit_test(encoding_is_srgb),
        cmocka_unit_test(materials_are_seen),
        cmocka_unit_test(view_refuses),
    };
    if (count < 2 || strcmp(arguments[1], "egl") != 0)
        return cmocka_run_group_tests(tests, NULL, NULL);
    return has_egl() ? cmocka_run_group_tests(egl, NULL, NULL) : SKIPPED;
}
