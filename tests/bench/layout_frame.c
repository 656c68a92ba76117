/* What a layout costs a frame: the G-buffer pass of a material whose every slot is a uniform, so that nothing is packed
 * beforehand, and a pass that reads all slots back. Both fill a square; the least of several draws counts. */
#include "matbench.h"
#include "compiler/layout/layout.h"
#include "compiler/matc.h"
#include "runtime/gl/framebuffer.h"
#include "runtime/gl/mesh.h"
#include "runtime/gl/program.h"
#include "runtime/gl/texture.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SIDE = 1024, REPEATS = 30, TEXT_ROOM = 1 << 15 };

static const char document_text[] =
    "material: Phong\n"
    "diffuse: { param: a, default: [0.5, 0.5, 0.5] }\nspecular: { param: b, default: [0.5, 0.5, 0.5] }\n"
    "shininess: { param: c, default: 0.5 }\ntransparency: { param: d, default: [0.5, 0.5, 0.5] }\n"
    "diffuseTransparency: { param: e, default: [0.5, 0.5, 0.5] }\nambient: { param: f, default: [0.5, 0.5, 0.5] }\n"
    "emissive: { param: g, default: [0.5, 0.5, 0.5] }\ntransparencyShininess: { param: h, default: 0.5 }\n";

static const char vertex_text[] =
    "#version 330 core\nout vec3 eyeNormal;\n"
    "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., 0., 1.);\n"
    "eyeNormal = vec3(gl_Position.xy, 1. - dot(gl_Position.xy, gl_Position.xy)); }";

static double least_draw(GlContext *gl, const Mesh *screen)
{
    double least = 1e9;
    for (int i = 0; i <= REPEATS; i++) {
        gl->Finish();
        double start = bench_now();
        mesh_draw_screen(gl, screen);
        gl->Finish();
        double took = bench_now() - start;
        least = i && took < least ? took : least;
    }
    return least * 1e3;
}

/* The sum of all slots. */
static void reader_text(const LayoutRow *layout, char *text)
{
    int size = snprintf(text, TEXT_ROOM,
                        "layout(location = 0) out vec4 color;\nvoid main() {\n"
                        "    Surface s = unpackSurface(ivec2(gl_FragCoord.xy));\n"
                        "    color = vec4(0.0);\n");
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (layout_has_slot(layout, (Slot)slot))
            size += snprintf(text + size, (size_t)(TEXT_ROOM - size), "    color%s += s.%s;\n",
                             type_table[slot_table[slot].type].lanes == 3 ? ".xyz" : ".w", slot_table[slot].name);
    snprintf(text + size, (size_t)(TEXT_ROOM - size), "}\n");
}

static double read_back(GlContext *gl, const Mesh *screen, const Framebuffer *source, const char *unpack,
                        const LayoutRow *layout, const Framebuffer *target)
{
    static char text[TEXT_ROOM];
    reader_text(layout, text);
    GLuint program =
        program_make(gl, &(ProgramText){.vertex = {vertex_text}, .fragment = {"#version 330 core\n", unpack, text}});
    for (int i = 0; i < source->spec.color_count; i++) {
        char name[32];
        snprintf(name, sizeof name, "matc_gbuffer%d", i);
        texture_bind(gl, source->colors[i], i);
        program_set(gl, program, &(ProgramValue){name, 1, &(float){(float)i}});
    }
    framebuffer_use(gl, target);
    gl->UseProgram(program);
    double ms = least_draw(gl, screen);
    gl->DeleteProgram(program);
    return ms;
}

static bool measure_layout(GlContext *gl, const Mesh *screen, const MatcDocument *document, int layout,
                           const Framebuffer *target, double *write, double *read)
{
    MatcOptions options;
    matc_options_init(&options);
    options.layout = layout_table[layout].name;
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT | MATC_UNPACK, &options);
    FramebufferSpec spec = {SIDE, SIDE, matc_target_count(program), 0, false};
    GLenum formats[FRAMEBUFFER_COLORS] = {0};
    Framebuffer gbuffer = {0};
    for (int i = 0; i < spec.color_count; i++)
        formats[i] = framebuffer_format(matc_target_format(program, i));
    GLuint writer = program_make(
        gl, &(ProgramText){.vertex = {vertex_text}, .fragment = {matc_output(program, MATC_FRAGMENT, NULL)}});
    bool made = writer && framebuffer_make_of(gl, &spec, formats, &gbuffer);
    if (made) {
        framebuffer_use(gl, &gbuffer);
        gl->UseProgram(writer);
        *write = least_draw(gl, screen);
        *read = read_back(gl, screen, &gbuffer, matc_output(program, MATC_UNPACK, NULL), &layout_table[layout], target);
    }
    framebuffer_delete(gl, &gbuffer);
    gl->DeleteProgram(writer);
    matc_program_free(program);
    return made;
}

bool bench_layout_cost(GlContext *gl, int layout, double *write, double *read)
{
    Mesh screen;
    Framebuffer target;
    MatcOptions options;
    matc_options_init(&options);
    MatcDocument *document = matc_read("bench.yaml", document_text, strlen(document_text), &options);
    bool fine = matc_material_count(document) && mesh_make_empty(gl, &screen) &&
                framebuffer_make(gl, &(FramebufferSpec){SIDE, SIDE, 1, GL_RGBA32F, false}, &target) &&
                measure_layout(gl, &screen, document, layout, &target, write, read);
    if (fine) {
        *write *= 1e6 / SIDE / SIDE;
        *read *= 1e6 / SIDE / SIDE;
        framebuffer_delete(gl, &target);
        mesh_delete(gl, &screen);
    }
    matc_document_free(document);
    return fine;
}

int bench_layout_frame(bool timed)
{
    char error[512];
    double write = NAN, read = NAN;
    GlContext *gl = timed ? gl_open(GL_KIND_osmesa, true, error, sizeof error) : NULL;
    bool fine = gl || !timed;
    printf("\n%-10s %6s %10s %10s\n", "layout", "bytes", "write ns", "read ns");
    for (int layout = 0; fine && layout < LAYOUT_COUNT; layout++) {
        fine = !timed || bench_layout_cost(gl, layout, &write, &read);
        if (fine)
            printf("%-10s %6d %10s %10s\n", layout_table[layout].name, layout_bytes(&layout_table[layout]),
                   NUMBER(2, write), NUMBER(2, read));
    }
    if (!fine)
        fprintf(stderr, "matbench: %s\n", gl ? gl->error : error);
    if (gl)
        gl_close(gl);
    return !fine;
}
