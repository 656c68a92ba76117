/* The light pass of a set of materials: the cost of unpacking `compact`, with code for the cases
 * that the set uses and with code for all cases, next to a layout that is made for the set. The
 * variants are timed alternately in one run. */
#include "matbench.h"
#include "runtime/gpu_material/targets.h"
#include "runtime/gl/screen.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 1024, TURNS = 15, TEXT_CAPACITY = 1 << 15, READERS = 3, MAX_MATERIALS = 4 };

/* All numbers are uniforms, so that no slot is packed at compile time. */
static const struct {
    const char *name, *text;
} sets[] = {
    {"Phongs",
     "materials:\n  a: { material: Phong, diffuse: { param: a, default: [.5, .4, .3] } }\n"
     "  b: { material: Phong, diffuse: { param: a, default: [.5, .4, .3] },"
     " specular: { param: b, default: [.2, .2, .2] } }\n"},
    {"common",
     "materials:\n  plastic: { material: Principled, baseColor: { param: a, default: [.5, .4, .3] "
     "},"
     " roughness: { param: b, default: .4 }, ior: { param: c, default: 1.4 } }\n"
     "  metal: { material: Principled, baseColor: { param: a, default: [.5, .4, .3] },"
     " metalness: { param: d, default: .9 }, specularColor: { param: e, default: [1, .9, .8] } }\n"
     "  painted: { material: Principled, baseColor: { param: a, default: [.5, .4, .3] },"
     " coat: { param: f, default: .7 }, coatRoughness: { param: g, default: .2 },"
     " coatColor: { param: h, default: [1, .9, .8] } }\n"
     "  cloth: { material: Principled, baseColor: { param: a, default: [.5, .4, .3] },"
     " fuzz: { param: i, default: .6 }, fuzzColor: { param: j, default: [.8, .7, 1] },"
     " fuzzRoughness: { param: k, default: .5 } }\n"},
};
enum { SETS = sizeof sets / sizeof *sets };

static const char vertex_text[] =
    "#version 330 core\nout vec3 eyeNormal;\n"
    "void main() { gl_Position = vec4(gl_VertexID == 1 ? 3. : -1., gl_VertexID == 2 ? 3. : -1., "
    "0., 1.);\n"
    "eyeNormal = vec3(gl_Position.xy, 1. - dot(gl_Position.xy, gl_Position.xy)); }";

/* A program that reads a G-buffer, and its inputs. */
typedef struct {
    MatcProgram *programs[MAX_MATERIALS];
    int count;
    Framebuffer gbuffer;
    Material reader;
    double least;
} Reader;

typedef struct {
    GlContext *gl;
    Store *store;
    Screen screen;
    Framebuffer target;
    MatcDocument *document;
} Bench;

/* Writes the sum of all slots that the unpacking code provides. */
static void put_reader(char *text)
{
    static const char *const swizzle[] = {".w", ".xy", ".xyz"};
    int size = snprintf(text, TEXT_CAPACITY,
                        "layout(location = 0) out vec4 color;\nvoid main() {\n"
                        "    Surface s = unpackSurface(ivec2(gl_FragCoord.xy));\n"
                        "    color = vec4(0.0);\n");
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        size += snprintf(
            text + size, (size_t)(TEXT_CAPACITY - size),
            "#ifdef SURFACE_HAS_%s\n    color%s += s.%s;\n#endif\n", slot_table[slot].name,
            swizzle[type_table[slot_table[slot].type].components - 1], slot_table[slot].name);
    snprintf(text + size, (size_t)(TEXT_CAPACITY - size), "}\n");
}

/* Draws stripes of all materials of the set. */
static bool fill(Bench *b, Reader *r)
{
    const FramebufferSpec spec = {.width = SIDE, .height = SIDE};
    if (!targets_make(b->gl, r->programs[0], &spec, &r->gbuffer))
        return false;
    framebuffer_use(b->gl, &r->gbuffer);
    for (int i = 0; i < r->count; i++) {
        Material writer;
        const ProgramText text = {.vertex = {vertex_text}};
        if (!material_make(b->store, r->programs[i], &text, &writer))
            return false;
        b->gl->Viewport(0, i * SIDE / r->count, SIDE, SIDE / r->count);
        material_use(&writer);
        screen_draw(b->gl, &b->screen);
        material_delete(&writer);
    }
    return true;
}

/* Compiles with these options; `used`: unpacking code for the cases of the set only. */
static bool open_reader(Bench *b, MatcOptions options, bool used, Reader *r)
{
    char text[TEXT_CAPACITY];
    for (r->count = 0; r->count < matc_material_count(b->document); r->count++) {
        r->programs[r->count] = matc_compile(b->document, r->count, MATC_FRAGMENT, &options);
        options.cases |= used ? 1u << matc_case(r->programs[r->count]) : 0;
    }
    MatcProgram *unpacking = matc_compile(b->document, 0, MATC_UNPACK, &options);
    const char *unpack = matc_output(unpacking, MATC_UNPACK, NULL);
    put_reader(text);
    const ProgramText whole = {.vertex = {vertex_text},
                               .fragment = {"#version 330 core\n", unpack, text}};
    const bool fine = unpack && fill(b, r) && material_make(b->store, NULL, &whole, &r->reader);
    matc_program_free(unpacking);
    r->least = 1e9;
    return fine;
}

static void time_reader(Bench *b, Reader *r)
{
    framebuffer_use(b->gl, &b->target);
    targets_read(&r->gbuffer, &r->reader);
    b->gl->Finish();
    const double start = bench_now();
    screen_draw(b->gl, &b->screen);
    b->gl->Finish();
    r->least = fmin(r->least, bench_now() - start);
}

static void close_reader(Bench *b, Reader *r)
{
    material_delete(&r->reader);
    framebuffer_delete(b->gl, &r->gbuffer);
    for (int i = 0; i < r->count; i++)
        matc_program_free(r->programs[i]);
}

/* Makes the layout for all materials of the set. */
static MatcLayout *own_layout(const Bench *b, const MatcOptions *options)
{
    MatcRanges ranges;
    char *fault = NULL;
    matc_ranges_init(&ranges);
    for (int i = 0; i < matc_material_count(b->document); i++)
        matc_ranges_add(&ranges, b->document, i, options, &fault);
    free(fault);
    return matc_layout_for(&ranges, 0, options);
}

static bool time_set(Bench *b, int set, double ns[READERS])
{
    MatcOptions options;
    Reader readers[READERS] = {{.count = 0}};
    matc_options_init(&options);
    b->document = matc_read("set.yaml", sets[set].text, strlen(sets[set].text), &options);
    MatcLayout *layout = own_layout(b, &options);
    bool fine = matc_material_count(b->document) > 0 && matc_layout_ok(layout);
    for (int i = 0; fine && i < READERS; i++) {
        MatcOptions own = options;
        own.custom = i == 2 ? layout : NULL;
        fine = open_reader(b, own, i == 0, &readers[i]);
    }
    for (int turn = 0; fine && turn < TURNS * READERS; turn++)
        time_reader(b, &readers[turn % READERS]);
    for (int i = 0; i < READERS; i++) {
        ns[i] = readers[i].least * 1e9 / SIDE / SIDE;
        close_reader(b, &readers[i]);
    }
    matc_layout_free(layout);
    matc_document_free(b->document);
    return fine;
}

int bench_layout_set(bool timed)
{
    char error[512] = "";
    Bench b = {.gl = timed ? gl_open(GL_KIND_osmesa, true, error, sizeof error) : NULL};
    b.store = b.gl ? store_new(b.gl) : NULL;
    const FramebufferSpec spec = {SIDE, SIDE, 1, GL_RGBA32F, false};
    bool fine = !timed || (b.store && screen_make(b.gl, &b.screen) &&
                           framebuffer_make(b.gl, &spec, &b.target));
    printf("\n%-10s %10s %10s %10s %8s\n", "set", "used ns", "all ns", "own ns", "used/own");
    for (int set = 0; fine && set < SETS; set++) {
        double ns[READERS] = {NAN, NAN, NAN};
        fine = !timed || time_set(&b, set, ns);
        if (fine)
            printf("%-10s %10s %10s %10s %8s\n", sets[set].name, NUMBER(2, ns[0]), NUMBER(2, ns[1]),
                   NUMBER(2, ns[2]), NUMBER(2, ns[0] / ns[2]));
    }
    if (!fine)
        fprintf(stderr, "matbench: %s\n", b.gl ? b.gl->error : error);
    if (b.gl) {
        framebuffer_delete(b.gl, &b.target);
        screen_delete(b.gl, &b.screen);
        store_free(b.store);
        gl_close(b.gl);
    }
    return !fine;
}
