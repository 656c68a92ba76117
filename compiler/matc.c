/* The library's surface: documents, programs, their outputs. */
#include "choice.h"
#include "evaluate.h"
#include "fold.h"
#include "layout.h"
#include "matc.h"
#include "opt.h"
#include "oracle.h"
#include "pipeline.h"
#include "texture.h"
#include "validate.h"
#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct MatcDocument {
    Arena arena;
    MatcOptions options;
    Compile c;
    Tree *tree;
    Graph *graph; /* NULL: faults */
};

struct MatcProgram {
    Arena arena;
    MatcOptions options;
    Compile c;
    bool ok;
    Ir *ir;
    Products products;
    const char *outputs[8]; /* by bit of MatcOutput */
    size_t sizes[8];
    MatcTexture *textures;
    int *texture_made_by;
    int texture_count;
    const LayoutRow *layout; /* NULL: the pass writes none */
    MatcUniform *uniforms;   /* those in use */
    int uniform_count;
};

/* Numbers are read and written the same in every locale; the caller's is put back. */
typedef struct {
    locale_t ours, before;
} Locale;

static Locale enter_c_locale(void)
{
    Locale l = {newlocale(LC_ALL_MASK, "C", (locale_t)0), (locale_t)0};
    if (l.ours)
        l.before = uselocale(l.ours);
    return l;
}

static void leave_c_locale(Locale l)
{
    if (!l.ours)
        return;
    uselocale(l.before);
    freelocale(l.ours);
}

static Compile compile_with(const MatcOptions *options, Arena *arena)
{
    return (Compile){.options = options, .arena = arena, .optimize = options->optimize, .check = options->check};
}

const char *matc_version(void) { return MATC_VERSION; }

MatcDocument *matc_read(const char *name, const char *text, size_t size, const MatcOptions *options)
{
    MatcDocument *d = calloc(1, sizeof *d);
    if (!d)
        abort();
    Locale locale = enter_c_locale();
    d->options = options_whole(options);
    d->c = compile_with(&d->options, &d->arena);
    d->c.measure = d->options.measure;
    d->c.stage_start = stage_now();
    Source source = {arena_string(&d->arena, name, strlen(name)), arena_string(&d->arena, text, size), size};
    ARENA_PUSH(&d->arena, d->c.sources, d->c.source_count, d->c.source_room, source);
    depend_on(&d->c, source.name);
    d->graph = compile_front(&d->c, 0, &d->tree);
    leave_c_locale(locale);
    return d;
}

void matc_document_free(MatcDocument *d)
{
    if (!d)
        return;
    arena_free(&d->arena);
    free(d);
}

int matc_material_count(const MatcDocument *d) { return d->graph ? d->graph->material_count : 0; }
const char *matc_material_name(const MatcDocument *d, int material) { return d->graph->materials[material].name; }

int matc_material_find(const MatcDocument *d, const char *name)
{
    for (int i = 0; i < matc_material_count(d); i++)
        if (!strcmp(matc_material_name(d, i), name))
            return i;
    return -1;
}

int matc_depend_count(const MatcDocument *d) { return (int)d->c.depend_count; }
const char *matc_depend(const MatcDocument *d, int index) { return d->c.depends[index]; }
int matc_error_count(const MatcDocument *d) { return d->c.diags.errors; }

const char *matc_tree_text(MatcDocument *d)
{
    Text out = text_new(&d->arena);
    if (!d->tree)
        return "";
    tree_print(&out, d->tree);
    return out.at;
}

static const char *all_diagnostics(Compile *c, MatcForm form)
{
    Text out = text_new(c->arena);
    if (form == MATC_JSON)
        text_put(&out, "[");
    for (size_t i = 0; i < c->diags.count; i++) {
        if (form == MATC_TEXT) {
            diag_print(&out, &c->diags.at[i], c->sources);
        } else {
            text_put(&out, i ? ",\n " : "\n ");
            diag_print_json(&out, &c->diags.at[i], c->sources);
        }
    }
    if (form == MATC_JSON)
        text_put(&out, c->diags.count ? "\n]\n" : "]\n");
    return out.at ? out.at : "";
}

const char *matc_diagnostics(MatcDocument *d, MatcForm form) { return all_diagnostics(&d->c, form); }
const char *matc_program_diagnostics(MatcProgram *p, MatcForm form) { return all_diagnostics(&p->c, form); }

static void keep(MatcProgram *p, MatcOutput output, const char *text, size_t size)
{
    int bit = __builtin_ctz(output);
    p->outputs[bit] = text;
    p->sizes[bit] = size;
}

/* "opaque" or "transparent" everywhere, or "varying". */
static const char *opacity_of(MatcProgram *p, const Graph *graph, const Node *material, const Job *job)
{
    Job transparency = *job;
    transparency.pass = PASS_value;
    transparency.slot = SLOT_transparency;
    Compile quiet = p->c;
    quiet.measure = false;
    quiet.optimize = 2;
    Ir *ir = compile_ir(&quiet, graph, material, &transparency);
    if (!ir || !ir_is(ir, ir->outputs[0].value, OP_const))
        return "varying";
    const double *t = ir_numbers(ir, ir->outputs[0].value);
    return t[0] <= 0 && t[1] <= 0 && t[2] <= 0 ? "opaque" : "transparent";
}

static void print_stats(Text *out, const Compile *c, const char *heading)
{
    double total = 0;
    text_format(out, "%-10s %12s %8s %13s\n", heading, "microseconds", "nodes", "instructions");
    for (size_t i = 0; i < c->stat_count; i++) {
        const StageStats *s = &c->stats[i];
        total += s->seconds;
        text_format(out, "%-10s %12.1f", s->name, s->seconds * 1e6);
        text_format(out, s->nodes ? " %8d %13d\n" : "\n", s->nodes, s->cost);
    }
    text_format(out, "%-10s %12.1f   memory %zu KiB\n", "total", total * 1e6, c->arena->used / 1024);
}

static const char *stats_text(MatcProgram *p, const MatcDocument *d, const Job *job)
{
    Text out = text_new(&p->arena);
    print_stats(&out, &d->c, "document");
    print_stats(&out, &p->c, "program");
    choices_explain(&out, &p->options, job);
    size_t lines = 0;
    for (const char *c = p->products.fragment; *c; c++)
        lines += *c == '\n';
    text_format(&out, "fragment   %zu bytes, %zu lines, %zu library functions\n", p->products.fragment_size, lines,
                p->products.interface.chunks.count);
    return out.at;
}

static void fill_outputs(MatcProgram *p, const MatcDocument *d, int material, unsigned outputs, const Job *job)
{
    Compile *c = &p->c;
    const NamedMaterial *named = &d->graph->materials[material];
    Text ir = text_new(&p->arena), dot = text_new(&p->arena);
    const Products *made = &p->products;
    keep(p, MATC_FRAGMENT, made->fragment, made->fragment_size);
    keep(p, MATC_VERTEX, made->vertex, strlen(made->vertex));
    if (outputs & MATC_UNPACK) {
        const char *unpack = emit_unpack(c, job);
        keep(p, MATC_UNPACK, unpack, strlen(unpack));
    }
    if (outputs & MATC_REFLECT) {
        const char *opacity = opacity_of(p, d->graph, named->node, job);
        const char *json = emit_reflection(c, p->ir, job, &made->interface, named->name, opacity, made->fragment);
        keep(p, MATC_REFLECT, json, strlen(json));
    }
    if (outputs & MATC_IR) {
        ir_print(&ir, p->ir);
        keep(p, MATC_IR, ir.at, ir.size);
    }
    if (outputs & MATC_DOT) {
        ir_dot(&dot, p->ir);
        keep(p, MATC_DOT, dot.at, dot.size);
    }
    if (outputs & MATC_STATS) {
        const char *stats = stats_text(p, d, job);
        keep(p, MATC_STATS, stats, strlen(stats));
    }
}

/* SPIR-V comes from Vulkan's GLSL: for another target the material is compiled once more. */
static bool fill_spirv(MatcProgram *p, const MatcDocument *d, int material, const Job *job)
{
    const char *log = "", *fragment = p->products.fragment;
    size_t size = 0;
    Job vulkan = *job;
    vulkan.target = TARGET_spirv;
    if (job->target != TARGET_spirv) {
        Interface interface;
        Ir *ir = compile_ir(&p->c, d->graph, d->graph->materials[material].node, &vulkan);
        fragment = ir ? emit_fragment(&p->c, ir, &vulkan, &interface, &size) : NULL;
    }
    const char *words = fragment ? make_spirv(&p->c, fragment, &size, &log) : NULL;
    if (!words)
        diag_add(&p->c, NO_SPAN, DIAG_not_valid, target_table[vulkan.target].name, log);
    keep(p, MATC_SPIRV, words, size);
    return words != NULL;
}

static MatcUniform uniform_of(const Ir *ir, const Uniform *u)
{
    MatcUniform result = {.name = u->name, .param = u->name, .lanes = type_table[u->type].lanes};
    memcpy(result.initial, u->initial, sizeof result.initial);
    for (Ref ref = 1; ref < ir->count; ref++)
        if (ir_is(ir, ref, OP_uniform) && ir_at(ir, ref)->payload == (uint32_t)u->index)
            result.whole |= ir_type(ir, ref) == TYPE_int;
    return result;
}

static void list_uniforms(MatcProgram *p, const Graph *graph)
{
    p->uniforms = ARENA_ARRAY(&p->arena, MatcUniform, graph->uniform_count);
    for (int i = 0; i < graph->uniform_count; i++)
        if (p->products.interface.uniforms[i])
            p->uniforms[p->uniform_count++] = uniform_of(p->ir, graph->uniforms[i]);
}

static bool compile_program(MatcProgram *p, const MatcDocument *d, int material, unsigned outputs, const Job *job)
{
    Compile *c = &p->c;
    p->ir = compile_ir(c, d->graph, d->graph->materials[material].node, job);
    if (!p->ir || !compile_back(c, p->ir, job, &p->products))
        return false;
    fill_outputs(p, d, material, outputs, job);
    if (job->pass == PASS_gbuffer || job->pass == PASS_plane)
        p->layout = job->layout;
    list_uniforms(p, d->graph);
    p->texture_count = texture_list(c, p->ir, &p->products.interface, &p->textures, &p->texture_made_by);
    return !(outputs & MATC_SPIRV) || fill_spirv(p, d, material, job);
}

MatcProgram *matc_compile(const MatcDocument *d, int material, unsigned outputs, const MatcOptions *options)
{
    Job job;
    MatcProgram *p = calloc(1, sizeof *p);
    if (!p)
        abort();
    Locale locale = enter_c_locale();
    p->options = options_whole(options);
    p->c = compile_with(&p->options, &p->arena);
    p->c.measure = (outputs & MATC_STATS) != 0;
    p->c.sources = d->c.sources;
    p->c.source_count = d->c.source_count;
    p->c.depends = d->c.depends;
    p->c.depend_count = d->c.depend_count;
    p->c.stage_start = stage_now();
    p->ok = d->graph && material >= 0 && material < d->graph->material_count && !job_of(&p->options, &job) &&
            compile_program(p, d, material, outputs, &job) && !p->c.diags.errors;
    leave_c_locale(locale);
    return p;
}

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
    texture_fill(&p->c, p->ir, &p->textures[index], p->texture_made_by[index]);
    return &p->textures[index];
}

int matc_target_count(const MatcProgram *p) { return p->layout ? layout_targets(p->layout) : 0; }

const char *matc_target_format(const MatcProgram *p, int index) { return format_table[p->layout->formats[index]].name; }

int matc_uniform_count(const MatcProgram *p) { return p->uniform_count; }

const MatcUniform *matc_uniform(const MatcProgram *p, int index) { return &p->uniforms[index]; }

/* "u=0.3 v=0.4 front=0" */
static const char *read_point(Surface *surface, const char *point)
{
    for (const char *at = point; *(at += strspn(at, " ,\t\n"));) {
        size_t size = strcspn(at, " ,\t\n"), name = strcspn(at, "=");
        char key[16] = {0};
        double value;
        if (name >= size || name >= sizeof key || !text_number(at + name + 1, size - name - 1, &value) ||
            !isfinite(value))
            return "a point is a list of channel=number";
        memcpy(key, at, name);
        if (!strcmp(key, "front"))
            surface->front = value != 0;
        else if (!oracle_surface_set(surface, key, value))
            return "no such channel; see --list";
        at += size;
    }
    return NULL;
}

void document_evaluate(const MatcDocument *d, int material, const MatcOptions *options, const Surface *points,
                       int count, SlotValues *values)
{
    Job job;
    job_of(options, &job);
    const ReferenceContext context = {.noise = noise_for(job.choice[AXIS_noise], job.target)};
    Oracle *oracle = oracle_open(d->graph, &context);
    oracle_exact_derivatives(oracle, job.choice[AXIS_derivatives] == CHOICE_derivatives_analytic);
    for (int i = 0; i < count; i++)
        oracle_material(oracle, d->graph->materials[material].node, &points[i], &values[i]);
    oracle_close(oracle);
}

char *matc_eval(const MatcDocument *d, int material, const char *point, const MatcOptions *options, const char **fault)
{
    Job job;
    Surface surface;
    SlotValues values;
    Arena arena = {0};
    Text out = text_new(&arena);
    Locale locale = enter_c_locale();
    const MatcOptions whole = options_whole(options);
    oracle_surface_default(&surface);
    *fault = job_of(&whole, &job) ? "no such option" : read_point(&surface, point);
    if (!*fault && (!d->graph || material < 0 || material >= d->graph->material_count))
        *fault = "no such material";
    if (!*fault) {
        document_evaluate(d, material, &whole, &surface, 1, &values);
        for (int slot = 0; slot < SLOT_COUNT; slot++) {
            text_put(&out, slot_table[slot].name);
            for (int i = 0; i < type_table[slot_table[slot].type].lanes; i++) {
                text_char(&out, ' ');
                text_double(&out, values.lane[slot][i]);
            }
            text_char(&out, '\n');
        }
    }
    char *result = *fault ? NULL : strdup(out.at);
    leave_c_locale(locale);
    arena_free(&arena);
    return result;
}
