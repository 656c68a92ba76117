/* Generates the outputs of a program. */
#include "compiler/program.h"
#include "compiler/choice.h"
#include "compiler/layout/layout_read.h"
#include "compiler/emit/stages.h"
#include "compiler/emit/texture.h"
#include "compiler/emit/validate.h"
#include <math.h>
#include <string.h>

enum {
    PROGRAM_TESSELLATION = MATC_TESSVERTEX | MATC_TESSCONTROL | MATC_TESSEVAL,
    PROGRAM_GEOMETRY = MATC_GEOMETRYVERTEX | MATC_GEOMETRY
};

static void keep(MatcProgram *p, MatcOutput output, const char *text, size_t size)
{
    int bit = __builtin_ctz(output);
    p->outputs[bit] = text ? text : ""; /* the IR of a depth program has no lines */
    p->sizes[bit] = size;
}

/* Writes a stage's time in microseconds. */
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
    text_format(&out, "fragment   %zu bytes, %zu lines, %zu library functions\n",
                p->products.fragment_size, lines, p->products.interface.chunks.count);
    return out.at;
}

static void keep_text(MatcProgram *p, MatcOutput output, const char *text)
{
    keep(p, output, text, text ? strlen(text) : 0);
}

static void keep_written(MatcProgram *p, MatcOutput output, const Text *text)
{
    keep(p, output, text->at, text->size);
}

static void keep_reflection(MatcProgram *p)
{
    const NamedMaterial *named = &p->document->graph->materials[p->material];
    GraphSky sky;
    const bool lights = p->job.pass == PASS_sky && graph_sky(named->node, &sky);
    const Reflected reflected = {&p->products.interface, named->name,
                                 matc_opacity(p),        p->products.fragment,
                                 lights ? &sky : NULL,   matc_displacement_bound(p)};
    keep_text(p, MATC_REFLECT, emit_reflection(&p->session, p->ir, &p->job, &reflected));
}

static bool fill_stages(MatcProgram *p, unsigned outputs)
{
    EmitStages made = {.fragment = p->products.fragment};
    if (outputs & PROGRAM_TESSELLATION) {
        if (!emit_tessellation_stages(&p->session, &p->job, &p->products.interface, &made))
            return false;
        keep_text(p, MATC_TESSVERTEX, made.vertex);
        keep_text(p, MATC_TESSCONTROL, made.control);
        keep_text(p, MATC_TESSEVAL, made.evaluation);
    }
    if (outputs & PROGRAM_GEOMETRY) {
        if (!emit_geometry_stages(&p->session, &p->job, &p->products.interface, &made))
            return false;
        keep_text(p, MATC_GEOMETRYVERTEX, made.vertex);
        keep_text(p, MATC_GEOMETRY, made.geometry);
    }
    if (outputs & MATC_COMPUTE) {
        if (!emit_compute_stage(&p->session, &p->job, &p->products.interface, &made))
            return false;
        keep_text(p, MATC_COMPUTE, made.compute);
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

/* Texts of stages that are linked together, and the output to which each belongs; 0: not
 * requested. */
typedef struct {
    MatcOutput of[VALIDATE_STAGES];
    const char *texts[VALIDATE_STAGES];
} SpirvSet;

static bool keep_words(MatcProgram *p, const SpirvSet *set)
{
    ValidateStages stages;
    ValidateWords words;
    const char *log = "";
    memcpy(stages.text, set->texts, sizeof stages.text);
    if (!validate_to_spirv(&p->session, &stages, &words, &log)) {
        diag_add(&p->session, NO_SPAN, DIAG_not_valid, target_table[TARGET_spirv].name, log);
        return false;
    }
    for (int i = 0; i < VALIDATE_STAGES; i++)
        if (set->of[i]) {
            p->words[__builtin_ctz(set->of[i])] = words.at[i];
            p->word_sizes[__builtin_ctz(set->of[i])] = words.size[i];
        }
    return true;
}

/* Job and interface of the stages in Vulkan's GLSL. */
typedef struct {
    Job job;
    Interface interface;
    const char *fragment;
} Vulkan;

static bool keep_stages(MatcProgram *p, const Vulkan *v, unsigned outputs)
{
    Session *session = &p->session;
    SpirvSet drawn = {{[VALIDATE_fragment] = MATC_FRAGMENT}, {[VALIDATE_fragment] = v->fragment}},
             divided = drawn, multiplied = drawn, computed = {{0}, {0}};
    if (outputs & MATC_VERTEX) {
        drawn.of[VALIDATE_vertex] = MATC_VERTEX;
        drawn.texts[VALIDATE_vertex] = emit_vertex(session, &v->job, &v->interface);
    }
    if (!keep_words(p, &drawn))
        return false;
    for (TessellationStage i = 0; i < TESSELLATION_COUNT && outputs & PROGRAM_TESSELLATION;
         i++) { /* both enums have the same order */
        divided.of[VALIDATE_vertex + (int)i] = (MatcOutput)(MATC_TESSVERTEX << i);
        divided.texts[VALIDATE_vertex + (int)i] =
            emit_tessellation(session, &v->job, &v->interface, i);
    }
    if (outputs & PROGRAM_GEOMETRY) {
        multiplied.of[VALIDATE_vertex] = MATC_GEOMETRYVERTEX;
        multiplied.of[VALIDATE_geometry] = MATC_GEOMETRY;
        multiplied.texts[VALIDATE_vertex] =
            emit_geometry(session, &v->job, &v->interface, GEOMETRY_vertex);
        multiplied.texts[VALIDATE_geometry] =
            emit_geometry(session, &v->job, &v->interface, GEOMETRY_geometry);
    }
    if (outputs & MATC_COMPUTE) {
        computed.of[VALIDATE_compute] = MATC_COMPUTE;
        computed.texts[VALIDATE_compute] = emit_compute(session, &v->job, &v->interface);
    }
    return (!(outputs & PROGRAM_TESSELLATION) || keep_words(p, &divided)) &&
           (!(outputs & PROGRAM_GEOMETRY) || keep_words(p, &multiplied)) &&
           (!(outputs & MATC_COMPUTE) || keep_words(p, &computed));
}

/* Generates SPIR-V from Vulkan's GLSL; for another target the material is compiled again. */
static bool fill_spirv(MatcProgram *p, unsigned outputs)
{
    Vulkan v = {p->job, p->products.interface, p->products.fragment};
    size_t size = 0;
    v.job.instances = false;
    if (!target_table[v.job.target].spirv) {
        v.job.target = TARGET_spirv;
        Ir *ir = compile_ir(&p->session, p->document->graph, program_material(p), &v.job);
        v.fragment = ir ? emit_fragment(&p->session, ir, &v.job, &v.interface, &size) : NULL;
    }
    const bool fine = v.fragment && keep_stages(p, &v, outputs);
    if (fine)
        keep(p, MATC_SPIRV, p->words[__builtin_ctz(MATC_FRAGMENT)],
             p->word_sizes[__builtin_ctz(MATC_FRAGMENT)]);
    return fine;
}

bool program_write(MatcProgram *p, unsigned outputs)
{
    if (outputs >= 1u << OUTPUT_COUNT)
        return diag_add(&p->session, NO_SPAN, DIAG_unknown_output,
                        outputs & ~((1u << OUTPUT_COUNT) - 1));
    if (!p->written && !compile_back(&p->session, p->ir, &p->job, &p->products))
        return false;
    p->written = true;
    p->asked |= outputs;
    fill_outputs(p, outputs);
    p->texture_count =
        texture_list(&p->session, p->ir, &p->products.interface, &p->textures, &p->texture_made_by);
    return fill_stages(p, outputs) && (!(outputs & MATC_SPIRV) || fill_spirv(p, outputs));
}

/* Returns the bit of a single output of a program that is ok; otherwise -1. */
static int bit_of(const MatcProgram *p, unsigned output)
{
    const bool one = output && !(output & (output - 1)) && output < 1u << OUTPUT_COUNT;
    return p && p->ok && one ? __builtin_ctz(output) : -1;
}

const char *matc_output(const MatcProgram *p, MatcOutput output, size_t *size)
{
    const int bit = p && p->asked & output ? bit_of(p, output) : -1;
    if (size)
        *size = bit >= 0 ? p->sizes[bit] : 0;
    return bit >= 0 ? p->outputs[bit] : NULL;
}

const char *matc_spirv(const MatcProgram *p, MatcOutput stage, size_t *size)
{
    const int bit = bit_of(p, stage);
    if (size)
        *size = bit >= 0 ? p->word_sizes[bit] : 0;
    return bit >= 0 ? p->words[bit] : NULL;
}
