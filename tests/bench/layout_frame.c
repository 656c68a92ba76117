/* Cost of a layout in a frame: the G-buffer pass of a material whose slots are all uniforms, so
 * that no slot is packed at compile time, and a pass that reads all slots back. Both fill a
 * square; the minimum of several draws counts. */
#include "matbench.h"
#include "runtime/gpu_material/targets.h"
#include "runtime/gl/screen.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SIDE = 1024, REPEATS = 30, TEXT_CAPACITY = 1 << 15 };

static const char document_text[] =
    "material: Phong\n"
    "diffuse: { param: a, default: [0.5, 0.5, 0.5] }\nspecular: { param: b, default: [0.5, 0.5, "
    "0.5] }\n"
    "shininess: { param: c, default: 0.5 }\ntransparency: { param: d, default: [0.5, 0.5, 0.5] }\n"
    "diffuseTransparency: { param: e, default: [0.5, 0.5, 0.5] }\nambient: { param: f, default: "
    "[0.5, 0.5, 0.5] }\n"
    "emissive: { param: g, default: [0.5, 0.5, 0.5] }\ntransparencyShininess: { param: h, default: "
    "0.5 }\n";

static const char vertex_text[] =
    "#version 330 core\nout vec3 eyeNormal;\n"
    "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., "
    "0., 1.);\n"
    "eyeNormal = vec3(gl_Position.xy, 1. - dot(gl_Position.xy, gl_Position.xy)); }";

static double least_draw(GlContext *gl, const Screen *screen)
{
    double least = 1e9;
    for (int i = 0; i <= REPEATS; i++) {
        gl->Finish();
        double start = bench_now();
        screen_draw(gl, screen);
        gl->Finish();
        double took = bench_now() - start;
        least = i && took < least ? took : least;
    }
    return least * 1e3;
}

/* Writes the sum of all slots. */
static void reader_text(const LayoutRow *layout, char *text)
{
    static const char *const swizzle[] = {".w", ".xy", ".xyz"};
    int size = snprintf(text, TEXT_CAPACITY,
                        "layout(location = 0) out vec4 color;\nvoid main() {\n"
                        "    Surface s = unpackSurface(ivec2(gl_FragCoord.xy));\n"
                        "    color = vec4(0.0);\n");
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (layout_has_slot(layout, (Slot)slot))
            size += snprintf(text + size, (size_t)(TEXT_CAPACITY - size), "    color%s += s.%s;\n",
                             swizzle[type_table[slot_table[slot].type].components - 1],
                             slot_table[slot].name);
    snprintf(text + size, (size_t)(TEXT_CAPACITY - size), "}\n");
}

/* State for drawing a pass. */
typedef struct {
    GlContext *gl;
    Store *store;
    Screen screen;
    Framebuffer target; /* target of the reading pass */
} Bench;

static bool time_write(Bench *b, MatcProgram *program, const Framebuffer *gbuffer, double *ms)
{
    Material writer;
    if (!material_make(b->store, program, &(ProgramText){.vertex = {vertex_text}}, &writer))
        return false;
    framebuffer_use(b->gl, gbuffer);
    material_use(&writer);
    *ms = least_draw(b->gl, &b->screen);
    material_delete(&writer);
    return true;
}

static bool time_read(Bench *b, const LayoutRow *layout, const char *unpack,
                      const Framebuffer *gbuffer, double *ms)
{
    char text[TEXT_CAPACITY];
    Material reader;
    reader_text(layout, text);
    const ProgramText whole = {.vertex = {vertex_text},
                               .fragment = {"#version 330 core\n", unpack, text}};
    if (!material_make(b->store, NULL, &whole, &reader))
        return false;
    framebuffer_use(b->gl, &b->target);
    targets_read(gbuffer, &reader);
    *ms = least_draw(b->gl, &b->screen);
    material_delete(&reader);
    return true;
}

static bool measure_layout(Bench *b, const MatcDocument *document, int layout, double *write,
                           double *read)
{
    MatcOptions options;
    Framebuffer gbuffer;
    const FramebufferSpec spec = {.width = SIDE, .height = SIDE};
    matc_options_init(&options);
    options.layout = layout_table[layout].name;
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT | MATC_UNPACK, &options);
    bool made = targets_make(b->gl, program, &spec, &gbuffer) &&
                time_write(b, program, &gbuffer, write) &&
                time_read(b, &layout_table[layout], matc_output(program, MATC_UNPACK, NULL),
                          &gbuffer, read);
    framebuffer_delete(b->gl, &gbuffer);
    matc_program_free(program);
    return made;
}

bool bench_layout_cost(GlContext *gl, int layout, double *write, double *read)
{
    MatcOptions options;
    Bench b = {.gl = gl, .store = store_new(gl)};
    matc_options_init(&options);
    MatcDocument *document =
        matc_read("bench.yaml", document_text, strlen(document_text), &options);
    bool fine =
        b.store && matc_material_count(document) && screen_make(gl, &b.screen) &&
        framebuffer_make(gl, &(FramebufferSpec){SIDE, SIDE, 1, GL_RGBA32F, false}, &b.target) &&
        measure_layout(&b, document, layout, write, read);
    if (fine) {
        *write *= 1e6 / SIDE / SIDE;
        *read *= 1e6 / SIDE / SIDE;
    }
    framebuffer_delete(gl, &b.target);
    screen_delete(gl, &b.screen);
    store_free(b.store);
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
            printf("%-10s %6d %10s %10s\n", layout_table[layout].name,
                   layout_bytes(&layout_table[layout]), NUMBER(2, write), NUMBER(2, read));
    }
    if (!fine)
        fprintf(stderr, "matbench: %s\n", gl ? gl->error : error);
    if (gl)
        gl_close(gl);
    return !fine;
}
