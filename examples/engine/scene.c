/* One frame: the G-buffer pass with each material's own program, then one light pass over the
 * screen. */
#include "scene.h"
#include <math.h>
#include <png.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    COLUMNS = 8,
    SAMPLES = 2 /* each way, of a pixel of the picture */,
    ACROSS = 96,
    UP = 48,
    BLOCK = 0
};
static const float SPACING = 2.3f; /* between the middles of spheres of radius 1 */

typedef struct {
    const Manifest *manifest;
    GLuint *programs;                 /* of GL, by program of the manifest */
    GLintptr *ranges;                 /* of the uniform buffer, by material */
    GLuint (*textures)[MAX_TEXTURES]; /* by material */
    GLuint (*samplers)[MAX_TEXTURES];
    GLuint constants, sphere; /* a buffer, a vertex array */
    GLuint targets[MAX_TARGETS], depth;
    int width, height; /* of the frame, with its samples */
} Scene;

static int block_bytes(const Scene *s, int material)
{
    return s->manifest->programs[s->manifest->materials[material].program].block_bytes;
}

/* A material's members of `Constants` become a range of one buffer, which is filled once. */
static void fill_constants(Scene *s)
{
    GLint align = 256;
    glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &align);
    int size = 1; /* never empty */
    for (int i = 0; i < s->manifest->material_count; i++) {
        size = (size + align - 1) / align * align;
        s->ranges[i] = size;
        size += block_bytes(s, i);
    }
    unsigned char *bytes = calloc(1, (size_t)size);
    for (int i = 0; i < s->manifest->material_count; i++)
        if (s->manifest->materials[i].block)
            memcpy(bytes + s->ranges[i], s->manifest->materials[i].block,
                   (size_t)block_bytes(s, i));
    gl.GenBuffers(1, &s->constants);
    gl.BindBuffer(GL_UNIFORM_BUFFER, s->constants);
    gl.BufferData(GL_UNIFORM_BUFFER, size, bytes, GL_STATIC_DRAW);
    free(bytes);
}

/* Materials that name one file share its texture, unless one decodes its colours and the other does
 * not. */
static GLuint load_texture(const Scene *s, int upto, const Setting *wanted)
{
    const char *file = wanted->file;
    for (int i = 0; i < upto; i++)
        for (int k = 0; k < s->manifest->materials[i].texture_count; k++) {
            const Setting *other = &s->manifest->materials[i].textures[k];
            if (!strcmp(other->file, file) && other->sampling.srgb == wanted->sampling.srgb)
                return s->textures[i][k];
        }
    png_image image = {.version = PNG_IMAGE_VERSION};
    if (!png_image_begin_read_from_file(&image, file))
        fail(file, image.message);
    image.format = PNG_FORMAT_RGBA;
    unsigned char *pixels = malloc(PNG_IMAGE_SIZE(image));
    /* bottom row first */
    if (!png_image_finish_read(&image, NULL, pixels, -(int)PNG_IMAGE_ROW_STRIDE(image), NULL))
        fail(file, image.message);
    GLuint texture = gl_texture(wanted->sampling.srgb ? GL_SRGB8_ALPHA8 : GL_RGBA8, GL_RGBA,
                                GL_UNSIGNED_BYTE, (int)image.width, (int)image.height, pixels);
    gl.GenerateMipmap(GL_TEXTURE_2D); /* whether they are read is the sampler's */
    free(pixels);
    return texture;
}

static void load_materials(Scene *s)
{
    const Manifest *m = s->manifest;
    s->programs = calloc((size_t)m->program_count, sizeof *s->programs);
    s->ranges = calloc((size_t)m->material_count, sizeof *s->ranges);
    s->textures = calloc((size_t)m->material_count, sizeof *s->textures);
    s->samplers = calloc((size_t)m->material_count, sizeof *s->samplers);
    for (int i = 0; i < m->program_count; i++) {
        s->programs[i] =
            gl_program(m->programs[i].file, m->programs[i].vertex, m->programs[i].fragment);
        if (m->programs[i].block_bytes)
            gl.UniformBlockBinding(s->programs[i],
                                   gl.GetUniformBlockIndex(s->programs[i], "Constants"), BLOCK);
    }
    fill_constants(s);
    for (int i = 0; i < m->material_count; i++)
        for (int k = 0; k < m->materials[i].texture_count; k++) {
            const Setting *setting = &m->materials[i].textures[k];
            s->textures[i][k] = load_texture(s, i, setting);
            s->samplers[i][k] = gl_sampler(setting->sampling.mipmaps, setting->sampling.anisotropy,
                                           setting->sampling.wrap);
        }
}

/* Position, normal, u and v, the tangents along u and v: the attributes 0 to 4 of every program of
 * matc. */
static void put_vertex(float *out, float u, float v)
{
    const float turn = 6.2831853f, a = u * turn, b = (v - .5f) * turn / 2;
    const float p[3] = {cosf(a) * cosf(b), sinf(a) * cosf(b), sinf(b)};
    const float vertex[14] = {p[0],
                              p[1],
                              p[2],
                              p[0],
                              p[1],
                              p[2],
                              u,
                              v, /* tangents: */
                              -turn * p[1],
                              turn * p[0],
                              0,
                              -turn / 2 * cosf(a) * sinf(b),
                              -turn / 2 * sinf(a) * sinf(b),
                              turn / 2 * cosf(b)};
    memcpy(out, vertex, sizeof vertex);
}

static void make_sphere(Scene *s)
{
    static const int components[] = {3, 3, 2, 3, 3},
                     corners[6][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}};
    enum { STRIDE = 14 * sizeof(float) };
    float *vertices = malloc((size_t)ACROSS * UP * 6 * STRIDE), *out = vertices;
    for (int i = 0; i < ACROSS * UP * 6; i++, out += 14)
        put_vertex(out, (float)(i / 6 % ACROSS + corners[i % 6][0]) / ACROSS,
                   (float)(i / 6 / ACROSS + corners[i % 6][1]) / UP);
    GLuint buffer;
    gl.GenVertexArrays(1, &s->sphere);
    gl.BindVertexArray(s->sphere);
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl.BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)ACROSS * UP * 6 * STRIDE, vertices, GL_STATIC_DRAW);
    size_t at = 0;
    for (GLuint i = 0; i < 5; at += (size_t)components[i++] * sizeof(float)) {
        gl.EnableVertexAttribArray(i);
        gl.VertexAttribPointer(i, components[i], GL_FLOAT, GL_FALSE, STRIDE, (const void *)at);
    }
    free(vertices);
}

static void use_framebuffer(const GLuint *textures, int count, GLuint depth)
{
    GLuint name;
    GLenum buffers[MAX_TARGETS];
    gl.GenFramebuffers(1, &name);
    gl.BindFramebuffer(GL_FRAMEBUFFER, name);
    for (int i = 0; i < count; i++) {
        buffers[i] = GL_COLOR_ATTACHMENT0 + (GLenum)i;
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, buffers[i], GL_TEXTURE_2D, textures[i], 0);
    }
    if (depth)
        gl.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    gl.DrawBuffers(count, buffers);
    if (gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        fail("framebuffer", "this OpenGL cannot draw to it");
}

/* The formats that layouts name; another one is a row here. */
static GLuint make_target(const Scene *s, const char *format)
{
    static const struct {
        const char *name;
        GLenum internal, format, type;
    } rows[] = {{"R32UI", GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT},
                {"RG32UI", GL_RG32UI, GL_RG_INTEGER, GL_UNSIGNED_INT},
                {"RGBA32UI", GL_RGBA32UI, GL_RGBA_INTEGER, GL_UNSIGNED_INT},
                {"RGBA16UI", GL_RGBA16UI, GL_RGBA_INTEGER, GL_UNSIGNED_SHORT},
                {"RGBA16F", GL_RGBA16F, GL_RGBA, GL_FLOAT},
                {"RGBA32F", GL_RGBA32F, GL_RGBA, GL_FLOAT}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (!strcmp(rows[i].name, format))
            return gl_texture(rows[i].internal, rows[i].format, rows[i].type, s->width, s->height,
                              NULL);
    fail(format, "this engine has no such render target");
}

static void set_uniform(GLuint program, const Setting *setting)
{
    GLint at = gl.GetUniformLocation(program, setting->name);
    /* of one type */
    const PFNGLUNIFORM1FVPROC set[] = {gl.Uniform1fv, gl.Uniform2fv, gl.Uniform3fv, gl.Uniform4fv};
    set[setting->components - 1](at, 1, setting->numbers);
}

/* Names are those of matc; a program that does not use one has no location for it, which OpenGL
 * passes over. */
static void place(const Scene *s, GLuint program, int cell)
{
    const float c = cosf(.42f), t = sinf(.42f),
                wide = (float)s->width / SCENE_CELL / SAMPLES * SPACING,
                high = (float)s->height / SCENE_CELL / SAMPLES * SPACING;
    const float x = ((float)(cell % COLUMNS) + .5f) * SPACING - wide / 2,
                y = high / 2 - ((float)(cell / COLUMNS) + .5f) * SPACING;
    /* z of a sphere points up and a little to the viewer, who looks along -z of the world.
     * Columns. */
    const float turned[9] = {0, -t, c, 1, 0, 0, 0, c, t}, same[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    const float world[16] = {0, -t, c, 0, 1, 0, 0, 0, 0, c, t, 0, x, y, 0, 1};
    const float clip[16] = {2 / wide, 0, 0, 0, 0, 2 / high, 0, 0, 0, 0, -.5f, 0, 0, 0, 0, 1};
    gl.UniformMatrix4fv(gl.GetUniformLocation(program, "matc_worldFromLocal"), 1, GL_FALSE, world);
    gl.UniformMatrix4fv(gl.GetUniformLocation(program, "matc_clipFromWorld"), 1, GL_FALSE, clip);
    gl.UniformMatrix3fv(gl.GetUniformLocation(program, "matc_worldNormalFromLocal"), 1, GL_FALSE,
                        turned);
    gl.UniformMatrix3fv(gl.GetUniformLocation(program, "matc_eyeNormalFromLocal"), 1, GL_FALSE,
                        turned);
    gl.UniformMatrix3fv(gl.GetUniformLocation(program, "matc_eyeFromWorld"), 1, GL_FALSE, same);
}

static void draw_material(const Scene *s, int i)
{
    const Material *material = &s->manifest->materials[i];
    GLuint program = s->programs[material->program];
    gl.UseProgram(program); /* an engine would sort by program */
    place(s, program, i);
    if (block_bytes(s, i))
        gl.BindBufferRange(GL_UNIFORM_BUFFER, BLOCK, s->constants, s->ranges[i], block_bytes(s, i));
    for (int k = 0; k < material->uniform_count; k++)
        set_uniform(program, &material->uniforms[k]);
    for (int k = 0; k < material->texture_count; k++) {
        gl.ActiveTexture(GL_TEXTURE0 + (GLenum)k);
        glBindTexture(GL_TEXTURE_2D, s->textures[i][k]);
        gl.BindSampler((GLuint)k, s->samplers[i][k]);
        gl.Uniform1i(gl.GetUniformLocation(program, material->textures[k].name), k);
    }
    glDrawArrays(GL_TRIANGLES, 0, ACROSS * UP * 6);
}

static void draw_gbuffer(Scene *s)
{
    for (int i = 0; i < s->manifest->target_count; i++)
        s->targets[i] = make_target(s, s->manifest->targets[i]);
    s->depth =
        gl_texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, s->width, s->height, NULL);
    use_framebuffer(s->targets, s->manifest->target_count, s->depth);
    glViewport(0, 0, s->width, s->height);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glClear(GL_DEPTH_BUFFER_BIT);
    for (int i = 0; i < s->manifest->material_count; i++)
        draw_material(s, i);
    glDisable(GL_DEPTH_TEST);
}

/* The manifest's code declares Surface and unpackSurface(); `light` stands behind it. */
static GLuint light_program(const Manifest *m, const char *light)
{
    static const char screen[] = "#version 330 core\nvoid main() { gl_Position = "
                                 "vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) "
                                 "* 4. - 1., 0., 1.); }\n";
    size_t size = strlen(m->unpack) + strlen(light) + 64;
    char *text = malloc(size);
    snprintf(text, size, "#version 330 core\n%s\n%s", m->unpack, light);
    GLuint program = gl_program("light pass", screen, text);
    free(text);
    return program;
}

/* Draws linear colours, which the target encodes for the screen; its mipmap averages the
 * samples. */
static unsigned char *draw_light(const Scene *s, const char *light)
{
    GLuint program = light_program(s->manifest, light);
    GLuint frame =
        gl_texture(GL_SRGB8_ALPHA8, GL_RGBA, GL_UNSIGNED_BYTE, s->width, s->height, NULL);
    use_framebuffer(&frame, 1, 0);
    glEnable(GL_FRAMEBUFFER_SRGB);
    gl.UseProgram(program);
    for (int i = 0; i <= s->manifest->target_count; i++) {
        char name[32];
        bool depth = i == s->manifest->target_count;
        snprintf(name, sizeof name, depth ? "depthBuffer" : "matc_gbuffer%d", i);
        gl.ActiveTexture(GL_TEXTURE0 + (GLenum)i);
        glBindTexture(GL_TEXTURE_2D, depth ? s->depth : s->targets[i]);
        gl.BindSampler((GLuint)i, 0);
        gl.Uniform1i(gl.GetUniformLocation(program, name), i);
    }
    gl.Uniform1fv(gl.GetUniformLocation(program, "cell"), 1, &(float){SCENE_CELL * SAMPLES});
    glDrawArrays(GL_TRIANGLES, 0, 3);
    unsigned char *pixels = malloc((size_t)s->width * (size_t)s->height);
    gl.ActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, frame);
    gl.GenerateMipmap(GL_TEXTURE_2D);
    glGetTexImage(GL_TEXTURE_2D, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    if (glGetError())
        fail("OpenGL", "an error while drawing");
    return pixels;
}

unsigned char *scene_draw(const Manifest *manifest, const char *light, int *width, int *height)
{
    Scene s = {.manifest = manifest};
    *width = COLUMNS * SCENE_CELL;
    *height = (manifest->material_count + COLUMNS - 1) / COLUMNS * SCENE_CELL;
    s.width = *width * SAMPLES;
    s.height = *height * SAMPLES;
    load_materials(&s);
    make_sphere(&s);
    draw_gbuffer(&s);
    unsigned char *pixels = draw_light(&s, light);
    free(s.programs);
    free(s.ranges);
    free(s.textures);
    free(s.samplers);
    return pixels;
}
