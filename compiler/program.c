/* Programs: a material's IR, what is written of it, and what it needs. */
#include "compiler/choice.h"
#include "compiler/document.h"
#include "compiler/pipeline.h"
#include "compiler/ir/key.h"
#include "compiler/layout/layout.h"
#include "compiler/layout/layout_read.h"
#include "compiler/emit/attribute.h"
#include "compiler/emit/texture.h"
#include "compiler/emit/stages.h"
#include "compiler/emit/validate.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { OUTPUT_COUNT = 16 }; /* bits of MatcOutput */

struct MatcProgram {
    Arena arena;
    MatcOptions options;
    Session session;
    const MatcDocument *document;
    int material;
    Job job;
    bool ok, written; /* the GLSL is there */
    Ir *ir;
    Products products;
    const char *outputs[OUTPUT_COUNT]; /* by bit of MatcOutput */
    size_t sizes[OUTPUT_COUNT];
    MatcTexture *textures;
    int *texture_made_by;
    int texture_count;
    const LayoutRow *layout; /* NULL: the pass writes none */
    MatcAttribute attributes[LIMIT_ATTRIBUTES]; /* those in use */
    int attribute_count;
    MatcUniform *uniforms;   /* those in use */
    int uniform_count;
    MatcConstant *constants;
    bool keyed; /* the next four are there */
    IrKey key;
    MatcConstant *places;
    char key_digits[KEY_TEXT], shape_digits[KEY_TEXT];
};

static void keep(MatcProgram *p, MatcOutput output, const char *text, size_t size)
{
    int bit = __builtin_ctz(output);
    p->outputs[bit] = text ? text : ""; /* the IR of a depth program has no lines */
    p->sizes[bit] = size;
}

/* For most materials lowering knows; else the transparency is compiled by itself. */
static Opacity find_opacity(const MatcProgram *p)
{
    const Graph *graph = p->document->graph;
    Arena arena = {0};
    Job transparency = p->job;
    MatcOptions options = p->options;
    Opacity opacity = OPACITY_varying;
    if (p->ir->opacity != OPACITY_unknown)
        return p->ir->opacity;
    transparency.pass = PASS_value;
    transparency.slot = SLOT_transparency;
    transparency.from_buffer = false;
    options.member_count = 0;
    options.optimize = 2;
    Session quiet = session_open(&options, &arena);
    const Ir *ir = compile_ir(&quiet, graph, graph->materials[p->material].node, &transparency);
    if (ir && ir_is(ir, ir->outputs[0].value, OP_const)) {
        const double *t = ir_numbers(ir, ir->outputs[0].value);
        opacity = t[0] <= 0 && t[1] <= 0 && t[2] <= 0 ? OPACITY_opaque : OPACITY_transparent;
    }
    arena_free(&arena);
    return opacity;
}

const char *matc_opacity(MatcProgram *p)
{
    static const char *const names[] = {
        [OPACITY_opaque] = "opaque", [OPACITY_transparent] = "transparent", [OPACITY_varying] = "varying"};
    if (!p->ir)
        return NULL;
    p->ir->opacity = find_opacity(p);
    return names[p->ir->opacity];
}

/* In microseconds. */
static void put_time(Text *out, const char *name, double seconds)
{
    const long tenths = lround(seconds * 1e7);
    text_format(out, "%-10s %10ld.%ld", name, tenths / 10, tenths % 10);
}

static void print_stats(Text *out, const Session *session, const char *heading)
{
    double total = 0;
    text_format(out, "%-10s %12s %8s %13s\n", heading, "microseconds", "nodes", "instructions");
    for (size_t i = 0; i < session->stat_count; i++) {
        const StageStats *s = &session->stats[i];
        total += s->seconds;
        put_time(out, s->name, s->seconds);
        text_format(out, s->nodes ? " %8d %13d\n" : "\n", s->nodes, s->cost);
    }
    put_time(out, "total", total);
    text_format(out, "   memory %zu KiB\n", session->arena->used / 1024);
}

static const char *stats_text(MatcProgram *p, const MatcDocument *d, const Job *job)
{
    Text out = text_new(&p->arena);
    print_stats(&out, &d->session, "document");
    print_stats(&out, &p->session, "program");
    choice_explain(&out, &p->options, job);
    size_t lines = 0;
    for (const char *c = p->products.fragment; *c; c++)
        lines += *c == '\n';
    text_format(&out, "fragment   %zu bytes, %zu lines, %zu library functions\n", p->products.fragment_size, lines,
                p->products.interface.chunks.count);
    return out.at;
}

static void keep_text(MatcProgram *p, MatcOutput output, const char *text)
{
    keep(p, output, text, text ? strlen(text) : 0);
}

static void keep_written(MatcProgram *p, MatcOutput output, const Text *text) { keep(p, output, text->at, text->size); }

static void keep_reflection(MatcProgram *p)
{
    const NamedMaterial *named = &p->document->graph->materials[p->material];
    GraphSky sky;
    const bool lights = p->job.pass == PASS_sky && graph_sky(named->node, &sky);
    const Reflected reflected = {&p->products.interface, named->name, matc_opacity(p), p->products.fragment,
                                 lights ? &sky : NULL, matc_displacement_bound(p)};
    keep_text(p, MATC_REFLECT, emit_reflection(&p->session, p->ir, &p->job, &reflected));
}

static bool fill_stages(MatcProgram *p, unsigned outputs)
{
    const unsigned tessellation = MATC_TESSVERTEX | MATC_TESSCONTROL | MATC_TESSEVAL,
                   geometry = MATC_GEOMETRYVERTEX | MATC_GEOMETRY;
    EmitStages made = {.fragment = p->products.fragment};
    if (outputs & tessellation) {
        if (!emit_tessellation_stages(&p->session, &p->job, &p->products.interface, &made))
            return false;
        keep_text(p, MATC_TESSVERTEX, made.vertex);
        keep_text(p, MATC_TESSCONTROL, made.control);
        keep_text(p, MATC_TESSEVAL, made.evaluation);
    }
    if (outputs & geometry) {
        if (!emit_geometry_stages(&p->session, &p->job, &p->products.interface, &made))
            return false;
        keep_text(p, MATC_GEOMETRYVERTEX, made.vertex);
        keep_text(p, MATC_GEOMETRY, made.geometry);
    }
    return true;
}

static void fill_outputs(MatcProgram *p, unsigned outputs)
{
    Text ir = text_new(&p->arena), dot = text_new(&p->arena), layout = text_new(&p->arena);
    Products *made = &p->products;
    if (!made->vertex && outputs & MATC_VERTEX)
        made->vertex = emit_vertex(&p->session, &p->job, &made->interface);
    keep(p, MATC_FRAGMENT, made->fragment, made->fragment_size);
    keep_text(p, MATC_VERTEX, made->vertex);
    if (outputs & MATC_DISPLACE)
        keep_text(p, MATC_DISPLACE, emit_displace(&p->session, &p->job, &made->interface));
    if (outputs & MATC_UNPACK)
        keep_text(p, MATC_UNPACK, emit_unpack(&p->session, &p->job));
    if (outputs & MATC_REFLECT && !p->job.instances)
        keep_reflection(p);
    if (outputs & MATC_IR) {
        ir_print(&ir, p->ir);
        keep_written(p, MATC_IR, &ir);
    }
    if (outputs & MATC_DOT) {
        ir_dot(&dot, p->ir);
        keep_written(p, MATC_DOT, &dot);
    }
    if (outputs & MATC_LAYOUT) {
        layout_write(&layout, p->job.layout);
        keep_written(p, MATC_LAYOUT, &layout);
    }
    if (outputs & MATC_STATS)
        keep_text(p, MATC_STATS, stats_text(p, p->document, &p->job));
}

static const Node *material_of(const MatcProgram *p) { return p->document->graph->materials[p->material].node; }

/* SPIR-V comes from Vulkan's GLSL: for another target the material is compiled once more. */
static bool fill_spirv(MatcProgram *p)
{
    const char *log = "", *fragment = p->products.fragment;
    size_t size = 0;
    Job vulkan = p->job;
    vulkan.instances = false;
    if (!target_table[vulkan.target].spirv) {
        Interface interface;
        vulkan.target = TARGET_spirv;
        Ir *ir = compile_ir(&p->session, p->document->graph, material_of(p), &vulkan);
        fragment = ir ? emit_fragment(&p->session, ir, &vulkan, &interface, &size) : NULL;
    }
    const char *words = fragment ? validate_to_spirv(&p->session, fragment, &size, &log) : NULL;
    if (!words)
        diag_add(&p->session, NO_SPAN, DIAG_not_valid, target_table[vulkan.target].name, log);
    keep(p, MATC_SPIRV, words, size);
    return words != NULL;
}

/* Those that are live, in the document's order. */
static void list_uniforms(MatcProgram *p, const Graph *graph)
{
    uint8_t *used = ARENA_ARRAY(&p->arena, uint8_t, graph->uniform_count); /* 1, or 2 as an int */
    p->uniforms = ARENA_ARRAY(&p->arena, MatcUniform, graph->uniform_count);
    for (Ref ref = 1; ref < p->ir->count; ref++)
        if (ir_is(p->ir, ref, OP_uniform))
            used[ir_at(p->ir, ref)->payload] = ir_type(p->ir, ref) == TYPE_int ? 2 : 1;
    for (int i = 0; i < graph->uniform_count; i++) {
        const Uniform *u = graph->uniforms[i];
        MatcUniform uniform = {u->name, u->name, type_table[u->type].lanes, used[i] == 2, {0}};
        memcpy(uniform.initial, u->initial, sizeof uniform.initial);
        if (used[i])
            p->uniforms[p->uniform_count++] = uniform;
    }
}

/* The members of the buffer, with this material's numbers. */
static void list_constants(MatcProgram *p)
{
    p->constants = ARENA_ARRAY(&p->arena, MatcConstant, p->ir->constant_count + 1);
    for (size_t i = 0; i < p->ir->constant_count; i++) {
        const IrConstant *own = &p->ir->constants[i];
        p->constants[i] = (MatcConstant){
            own->name, type_table[own->type].name, type_table[own->type].lanes, own->offset, own->member, {0}};
        memcpy(p->constants[i].values, own->numbers, sizeof own->numbers);
    }
}

/* Discards count, displacement does not. */
static bool writes_pixels(const Ir *ir) { return ir->output_count > (ir->displaced != NULL); }

double matc_displacement_bound(const MatcProgram *p) { return p->ir ? compile_displacement_bound(p->ir) : 0; }

static bool compile_program(MatcProgram *p)
{
    const Graph *graph = p->document->graph;
    p->ir = compile_ir(&p->session, graph, material_of(p), &p->job);
    if (!p->ir)
        return false;
    if (p->job.pass == PASS_shadow && !writes_pixels(p->ir))
        p->job.pass = PASS_depth; /* nothing is discarded */
    if (p->job.pass == PASS_gbuffer || p->job.pass == PASS_plane)
        p->layout = p->job.layout;
    list_uniforms(p, graph);
    p->attribute_count = attribute_list(p->ir, p->attributes);
    list_constants(p);
    p->texture_count = texture_list(&p->session, p->ir, NULL, &p->textures, &p->texture_made_by);
    return true;
}

static bool write_program(MatcProgram *p, unsigned outputs)
{
    if (!p->written && !compile_back(&p->session, p->ir, &p->job, &p->products))
        return false;
    p->written = true;
    fill_outputs(p, outputs);
    p->texture_count = texture_list(&p->session, p->ir, &p->products.interface, &p->textures, &p->texture_made_by);
    return fill_stages(p, outputs) && (!(outputs & MATC_SPIRV) || fill_spirv(p));
}

/* Options that mean nothing are a fault of the program's. */
static bool open_job(MatcProgram *p)
{
    const char *fault = choice_fault(&p->arena, &p->options);
    if (fault)
        return diag_add(&p->session, NO_SPAN, DIAG_unknown_option, fault);
    return !choice_job(&p->options, &p->job);
}

MatcProgram *matc_compile(const MatcDocument *d, int material, unsigned outputs, const MatcOptions *options)
{
    MatcProgram *p = calloc(1, sizeof *p);
    if (!p)
        abort();
    p->options = choice_whole_options(options);
    p->document = d;
    p->material = material;
    p->session = session_open(&p->options, &p->arena);
    p->session.measure = (outputs & MATC_STATS) != 0;
    document_lend(d, &p->session);
    p->session.stage_start = session_now();
    p->ok = d->graph && material >= 0 && material < d->graph->material_count && open_job(p) && compile_program(p) &&
            (outputs == MATC_KEY || write_program(p, outputs)) && !p->session.diags.errors;
    return p;
}

bool matc_emit(MatcProgram *p, unsigned outputs)
{
    p->ok = p->ok && write_program(p, outputs) && !p->session.diags.errors;
    return p->ok;
}

const char *matc_program_diagnostics(MatcProgram *p, MatcForm form) { return diag_all(&p->session, form); }

bool matc_ok(const MatcProgram *p) { return p->ok; }

const char *matc_output(const MatcProgram *p, MatcOutput output, size_t *size)
{
    int bit = __builtin_ctz(output);
    if (size)
        *size = p->ok ? p->sizes[bit] : 0;
    return p->ok ? p->outputs[bit] : NULL;
}

void matc_program_free(MatcProgram *p)
{
    if (!p)
        return;
    arena_free(&p->arena);
    free(p);
}

int matc_texture_count(const MatcProgram *p) { return p->texture_count; }

const MatcTexture *matc_texture(MatcProgram *p, int index)
{
    texture_fill(&p->session, p->ir, &p->textures[index], p->texture_made_by[index]);
    return &p->textures[index];
}

int matc_case(const MatcProgram *p) { return p->layout ? p->ir->layout_case : -1; }

int matc_target_count(const MatcProgram *p) { return p->layout ? layout_targets(p->layout) : 0; }

const char *matc_target_format(const MatcProgram *p, int index) { return format_table[p->layout->formats[index]].name; }

int matc_uniform_count(const MatcProgram *p) { return p->uniform_count; }

int matc_attribute_count(const MatcProgram *p) { return p->attribute_count; }
const MatcAttribute *matc_attribute(const MatcProgram *p, int index) { return &p->attributes[index]; }
const MatcUniform *matc_uniform(const MatcProgram *p, int index) { return &p->uniforms[index]; }

const char *matc_pass(const MatcProgram *p) { return pass_table[p->job.pass].name; }

static void list_places(MatcProgram *p)
{
    p->places = ARENA_ARRAY(&p->arena, MatcConstant, p->key.place_count + 1);
    for (int i = 0; i < p->key.place_count; i++) {
        Ref value = p->key.places[i].value;
        MatcConstant *place = &p->places[i];
        *place = (MatcConstant){NULL, type_table[ir_type(p->ir, value)].name, ir_lanes(p->ir, value), 0, -1, {0}};
        memcpy(place->values, ir_numbers(p->ir, value), sizeof(double) * (size_t)place->lanes);
    }
}

static const IrKey *key_of(MatcProgram *p)
{
    if (!p->keyed) {
        p->key = ir_key(&p->session, p->ir, &p->job);
        key_text(p->key.key, p->key_digits);
        key_text(p->key.shape, p->shape_digits);
        list_places(p);
        p->keyed = true;
    }
    return &p->key;
}

const char *matc_key(MatcProgram *p) { return key_of(p) ? p->key_digits : NULL; }
const char *matc_shape(MatcProgram *p) { return key_of(p) ? p->shape_digits : NULL; }
int matc_place_count(MatcProgram *p) { return key_of(p)->place_count; }
const MatcConstant *matc_place(MatcProgram *p, int index) { return key_of(p) ? &p->places[index] : NULL; }
int matc_constant_count(const MatcProgram *p) { return (int)p->ir->constant_count; }
const MatcConstant *matc_constant(const MatcProgram *p, int index) { return &p->constants[index]; }
int matc_constant_bytes(const MatcProgram *p) { return constants_size(p->ir); }

void matc_constant_block(const MatcProgram *p, void *block)
{
    memset(block, 0, (size_t)matc_constant_bytes(p));
    for (int i = 0; i < matc_constant_count(p); i++) {
        const MatcConstant *member = &p->constants[i];
        char *at = (char *)block + member->offset;
        for (int lane = 0; lane < member->lanes; lane++, at += 4) {
            uint32_t bits = constant_bits(member->values[lane], member->type[0] == 'u');
            memcpy(at, &bits, sizeof bits);
        }
    }
}
