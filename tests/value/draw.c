/* Contexts, vertex programs that pass the points through, uniforms with and without blocks, textures. */
#include "draw.h"
#include "runtime/gl/backend.h"
#include "runtime/gl/block.h"
#include "runtime/gl/program.h"
#include "runtime/gl/texture.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FLOATS = 2 + 3 * POINT_VARYINGS, CORNERS = 3, ATTRIBUTES = 1 + POINT_VARYINGS, SOURCE_ROOM = 8192 };

static bool fail(Drawer *d, const char *text)
{
    snprintf(d->error, sizeof d->error, "%s", text);
    return false;
}

static int height_of(const Drawer *d) { return d->width == GRID_WIDTH ? GRID_HEIGHT : d->width; }

/* Middle of the pixel of point i in clip space, moved by (x, y) pixels. */
static void put_vertex(float *out, const Drawer *d, int i, double x, double y, const Point *point)
{
    out[0] = (float)(2 * (i % d->width + 0.5 + x) / d->width - 1);
    out[1] = (float)(2 * (i / d->width + 0.5 + y) / height_of(d) - 1);
    memcpy(out + 2, point->input, sizeof point->input);
}

/* Points, then triangles around the middles of the same pixels, turning clockwise: their back is seen. */
static float *make_vertices(const Drawer *d, const Point *points)
{
    int count = d->count;
    static const double corner[CORNERS][2] = {{-0.3, -0.3}, {0, 0.4}, {0.3, -0.3}};
    float *vertices = calloc((size_t)count * (1 + CORNERS) * FLOATS, sizeof *vertices), *at = vertices;
    if (!vertices)
        abort();
    for (int i = 0; i < count; i++, at += FLOATS)
        put_vertex(at, d, i, 0, 0, &points[i]);
    for (int i = 0; i < count; i++)
        for (int k = 0; k < CORNERS; k++, at += FLOATS)
            put_vertex(at, d, i, corner[k][0], corner[k][1], &points[i]);
    return vertices;
}

static void set_attributes(const GlContext *gl)
{
    for (int i = 0; i < ATTRIBUTES; i++) {
        size_t offset = i ? (2 + 3 * (size_t)(i - 1)) * sizeof(float) : 0;
        gl->VertexAttribPointer((GLuint)i, i ? 3 : 2, GL_FLOAT, GL_FALSE, FLOATS * sizeof(float), (void *)offset);
        gl->EnableVertexAttribArray((GLuint)i);
    }
}

static void upload(Drawer *d, const Point *points)
{
    const GlContext *gl = d->gl;
    float *vertices = make_vertices(d, points);
    gl->GenVertexArrays(1, &d->array);
    gl->BindVertexArray(d->array);
    gl->GenBuffers(1, &d->buffer);
    gl->BindBuffer(GL_ARRAY_BUFFER, d->buffer);
    gl->BufferData(GL_ARRAY_BUFFER, (GLsizeiptr)((size_t)d->count * (1 + CORNERS) * FLOATS * sizeof(float)), vertices,
                   GL_STATIC_DRAW);
    set_attributes(gl);
    free(vertices);
}

/* A function that the GL layer does not list. */
static void load(Drawer *d, const char *name, void *function)
{
    GlProc found = gl_backend_osmesa.load(d->gl->state, name);
    memcpy(function, &found, sizeof found);
}

bool drawer_open(Drawer *d, bool core, const Point *points, int count, int targets, GLenum format)
{
    *d = (Drawer){.core = core, .count = count, .width = GRID_WIDTH};
    while (d->width * height_of(d) < count)
        d->width++;
    d->gl = gl_open(GL_KIND_osmesa, core, d->error, sizeof d->error);
    if (!d->gl)
        return false;
    load(d, "glBindBufferBase", &d->bind_buffer_base);
    load(d, "glGetUniformBlockIndex", &d->block_index);
    load(d, "glGetUniformIndices", &d->uniform_indices);
    load(d, "glGetActiveUniformsiv", &d->uniform_values);
    upload(d, points);
    FramebufferSpec spec = {d->width, height_of(d), targets, format, false};
    return framebuffer_make(d->gl, &spec, &d->target) || fail(d, d->gl->error);
}

void drawer_close(Drawer *d)
{
    if (!d->gl)
        return;
    gl_use(d->gl);
    framebuffer_delete(d->gl, &d->target);
    gl_close(d->gl);
    *d = (Drawer){0};
}

/* The fragment program declares it: "... worldNormal;" */
static bool declares(const char *fragment, Input input)
{
    char text[64];
    snprintf(text, sizeof text, "%s %s;", type_table[input_table[input].type].name, input_table[input].glsl);
    return strstr(fragment, text) != NULL;
}

static int location(Input input)
{
    int count = 0;
    for (int i = 0; i < (int)input; i++)
        count += input_table[i].source == SOURCE_varying;
    return count;
}

/* Appends like snprintf. */
#define PUT(...) (size += snprintf(text + size, size < SOURCE_ROOM ? (size_t)(SOURCE_ROOM - size) : 0, __VA_ARGS__))

static void vertex_text(char *text, const char *fragment, Target target)
{
    bool old = !target_table[target].in_out, located = target_table[target].locations;
    int size = 0;
    PUT("#version %s\n%s vec2 at;\n", target_table[target].version, old ? "attribute" : "in");
    for (int i = 0; i < POINT_VARYINGS; i++)
        if (declares(fragment, (Input)i)) {
            const char *type = type_table[input_table[i].type].name, *name = input_table[i].glsl;
            PUT("%s %s in_%s;\n", old ? "attribute" : "in", type, name);
            if (located)
                PUT("layout(location = %d) ", location((Input)i));
            PUT("%s %s %s;\n", old ? "varying" : "out", type, name);
        }
    PUT("void main() {\n");
    for (int i = 0; i < POINT_VARYINGS; i++)
        if (declares(fragment, (Input)i))
            PUT("    %s = in_%s;\n", input_table[i].glsl, input_table[i].glsl);
    PUT("    gl_Position = vec4(at, 0.0, 1.0);\n}\n");
}
#undef PUT

GLuint drawer_program(Drawer *d, const Shading *shading)
{
    char vertex[SOURCE_ROOM], names[POINT_VARYINGS][64];
    const char *attributes[ATTRIBUTES] = {"at"};
    for (int i = 0; i < POINT_VARYINGS; i++) {
        snprintf(names[i], sizeof names[i], "in_%s", input_table[i].glsl);
        attributes[1 + i] = names[i];
    }
    vertex_text(vertex, shading->fragment, shading->target);
    ProgramText text = {.vertex = {vertex},
                        .fragment = {shading->fragment, shading->library},
                        .attributes = attributes,
                        .attribute_count = ATTRIBUTES};
    gl_use(d->gl);
    GLuint program = program_make(d->gl, &text);
    if (!program)
        fail(d, d->gl->error);
    return program;
}

/* The block "Material" of one program, as bytes. */
typedef struct {
    Drawer *d;
    GLuint program;
    unsigned char bytes[4096];
} Block;

static void put_in_block(Block *block, const char *name, const void *number, size_t size)
{
    GLuint index = GL_INVALID_INDEX;
    GLint offset = -1;
    block->d->uniform_indices(block->program, 1, &name, &index);
    if (index == GL_INVALID_INDEX)
        return;
    block->d->uniform_values(block->program, 1, &index, GL_UNIFORM_OFFSET, &offset);
    if (offset >= 0 && (size_t)offset + size <= sizeof block->bytes)
        memcpy(block->bytes + offset, number, size);
}

static void set_number(Block *block, const char *name, int lanes, bool whole, const double *numbers)
{
    float floats[4];
    GLint integers[4];
    for (int i = 0; i < lanes; i++) {
        floats[i] = (float)numbers[i];
        integers[i] = (GLint)numbers[i];
    }
    program_set(block->d->gl, block->program, &(ProgramValue){name, lanes, floats});
    put_in_block(block, name, whole ? (void *)integers : (void *)floats, (size_t)lanes * 4);
}

static const double *value_of(const Graph *graph, const MatcUniform *uniform)
{
    for (int i = 0; graph && i < graph->uniform_count; i++)
        if (!strcmp(graph->uniforms[i]->name, uniform->param))
            return graph->uniforms[i]->initial;
    return uniform->initial;
}

enum { CONSTANTS_BINDING = 2 };

/* The block "Constants"; in GLSL 1.10 its members are plain uniforms. */
static GLuint set_constants(Drawer *d, GLuint program, const Shading *shading)
{
    int count = shading->program ? matc_constant_count(shading->program) : 0;
    size_t size = count ? (size_t)matc_constant_bytes(shading->program) : 0;
    void *bytes = count ? malloc(size) : NULL;
    if (!bytes)
        return 0;
    matc_constant_block(shading->program, bytes);
    for (int i = 0; i < count && !target_table[shading->target].blocks; i++) {
        const MatcConstant *member = matc_constant(shading->program, i);
        program_set(d->gl, program,
                    &(ProgramValue){member->name, member->lanes, (float *)((char *)bytes + member->offset)});
    }
    GLuint buffer = block_make(d->gl, program, "Constants", CONSTANTS_BINDING, bytes, size);
    free(bytes);
    return buffer;
}

static GLuint set_uniforms(Drawer *d, GLuint program, const Shading *shading)
{
    Block block = {.d = d, .program = program};
    GLuint buffer = 0;
    set_number(&block, "matc_ior", 1, false, &point_ior);
    program_set(d->gl, program, &(ProgramValue){"matc_eyeFromWorld", 9, (float[9]){1, 0, 0, 0, 1, 0, 0, 0, 1}});
    for (int i = 0; shading->program && i < matc_uniform_count(shading->program); i++) {
        MatcUniform uniform = *matc_uniform(shading->program, i);
        set_number(&block, uniform.name, uniform.lanes, uniform.whole, value_of(shading->graph, &uniform));
    }
    if (d->block_index(program, "Material") == GL_INVALID_INDEX)
        return 0;
    d->gl->GenBuffers(1, &buffer);
    d->gl->BindBuffer(GL_UNIFORM_BUFFER, buffer);
    d->gl->BufferData(GL_UNIFORM_BUFFER, sizeof block.bytes, block.bytes, GL_STATIC_DRAW);
    d->bind_buffer_base(GL_UNIFORM_BUFFER, 0, buffer);
    return buffer;
}

enum { UNITS = 16 };

static bool set_textures(Drawer *d, GLuint program, const Shading *shading, GLuint names[UNITS])
{
    int count = shading->program ? matc_texture_count(shading->program) : 0;
    for (int i = 0; i < count && i < UNITS; i++) {
        MatcTexture t = *matc_texture(shading->program, i);
        TextureSpec spec = {t.width, t.height, t.lanes, t.bytes, t.floats, false, true, t.mipmaps};
        d->gl->ActiveTexture(GL_TEXTURE0 + (GLenum)i); /* making a texture binds it */
        names[i] = texture_make(d->gl, &spec);
        if (!names[i])
            return fail(d, d->gl->error);
        program_set(d->gl, program, &(ProgramValue){t.name, 1, &(float){(float)i}});
    }
    return count <= UNITS || fail(d, "too many textures");
}

/* Vertices of the bound array. */
typedef struct {
    GLenum kind;
    int first, count;
} Part;

/* Framebuffer rows are those of the grid. */
static bool draw(Drawer *d, GLuint program, const Part *part, const Framebuffer *target)
{
    const GlContext *gl = d->gl;
    framebuffer_clear(gl, target, (float[4]){-12345, -12345, -12345, -12345});
    gl->UseProgram(program);
    gl->DrawArrays(part->kind, part->first, part->count);
    return gl_check(d->gl, "drawing points") || fail(d, d->gl->error);
}

/* The array of vertices that are to be drawn is bound. */
static bool draw_with(Drawer *d, GLuint program, const Shading *shading, const Part *part, const Framebuffer *target)
{
    GLuint names[UNITS] = {0};
    GLuint buffers[] = {set_uniforms(d, program, shading), set_constants(d, program, shading)};
    bool drawn = set_textures(d, program, shading, names) && draw(d, program, part, target);
    d->gl->DeleteTextures(UNITS, names);
    d->gl->DeleteBuffers(2, buffers);
    return drawn;
}

bool drawer_draw_to(Drawer *d, GLuint program, const Shading *shading, bool front, const Framebuffer *target)
{
    const Part points = {GL_POINTS, 0, d->count}, triangles = {GL_TRIANGLES, d->count, CORNERS * d->count};
    gl_use(d->gl);
    d->gl->BindVertexArray(d->array);
    return draw_with(d, program, shading, front ? &points : &triangles, target);
}

bool drawer_fill(Drawer *d, GLuint program, const Shading *shading, const Point corners[3], float *rgba)
{
    static const float places[CORNERS][2] = {{-1, -1}, {3, -1}, {-1, 3}};
    const GlContext *gl = d->gl;
    float vertices[CORNERS][FLOATS];
    GLuint array, buffer;
    for (int i = 0; i < CORNERS; i++) {
        memcpy(vertices[i], places[i], sizeof places[i]);
        memcpy(vertices[i] + 2, corners[i].input, sizeof corners[i].input);
    }
    gl_use(d->gl);
    gl->GenVertexArrays(1, &array);
    gl->BindVertexArray(array);
    gl->GenBuffers(1, &buffer);
    gl->BindBuffer(GL_ARRAY_BUFFER, buffer);
    gl->BufferData(GL_ARRAY_BUFFER, sizeof vertices, vertices, GL_STATIC_DRAW);
    set_attributes(gl);
    bool drawn = draw_with(d, program, shading, &(Part){GL_TRIANGLES, 0, CORNERS}, &d->target);
    gl->DeleteBuffers(1, &buffer);
    gl->DeleteVertexArrays(1, &array);
    return drawn && (framebuffer_read(d->gl, &d->target, 0, rgba) || fail(d, d->gl->error));
}

bool drawer_draw(Drawer *d, GLuint program, const Shading *shading, bool front, float *const *rgba, int targets)
{
    bool drawn = drawer_draw_to(d, program, shading, front, &d->target);
    for (int i = 0; drawn && i < targets; i++)
        if (!framebuffer_read(d->gl, &d->target, i, rgba[i]))
            return fail(d, d->gl->error);
    return drawn;
}
