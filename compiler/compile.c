/* The pipeline, as a list of stages, and what every stage shares: diagnostics, files, statistics. */
#include "compiler/base/compile.h"
#include "compiler/emit/emit.h"
#include "compiler/base/file.h"
#include "compiler/ir/key.h"
#include "compiler/lower/lower.h"
#include "compiler/opt/opt.h"
#include "compiler/pipeline.h"
#include "compiler/front/resolve.h"
#include "compiler/emit/validate.h"
#include <string.h>

bool diag_full(const Compile *c) { return c->diags.count >= MOST_DIAGS; }

void *diag_add(Compile *c, Span span, DiagKind kind, ...)
{
    if (diag_full(c)) {
        c->diags.errors += diag_table[kind].severity == SEVERITY_error;
        return NULL;
    }
    va_list args;
    c->message.arena = c->arena;
    c->message.size = 0;
    va_start(args, kind);
    diag_message(&c->message, kind, args);
    va_end(args);
    for (size_t i = 0; i < c->diags.count; i++) { /* what is asked for several slots is said once */
        const Diag *said = &c->diags.at[i];
        if (said->kind == kind && !memcmp(&said->span, &span, sizeof span) && !strcmp(said->message, c->message.at))
            return NULL;
    }
    const char *message = arena_string(c->arena, c->message.at, c->message.size);
    Diag diag = {kind, diag_table[kind].severity, span, message};
    ARENA_PUSH(c->arena, c->diags.at, c->diags.count, c->diags.room, diag);
    c->diags.errors += diag.severity == SEVERITY_error;
    return NULL;
}

const char *diag_all(Compile *c, MatcForm form)
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

double stage_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

void stage_done(Compile *c, const char *name, int nodes, int cost)
{
    if (!c->measure)
        return;
    double now = stage_now();
    StageStats stats = {name, now - c->stage_start, nodes, cost};
    ARENA_PUSH(c->arena, c->stats, c->stat_count, c->stat_room, stats);
    c->stage_start = stage_now(); /* what statistics cost does not count */
}

char *read_file(Compile *c, const char *path, size_t *size, const char **why)
{
    if (c->options->read_file)
        return c->options->read_file(c->options->user, path, size, why);
    return file_read(path, size, why);
}

void depend_on(Compile *c, const char *path) { names_add(c->arena, &c->depends, path); }

/* Drops `.` and `//` and takes `a/..` together, so that a file has one name. In place. */
static void normalise(char *path)
{
    char *to = path, *start = path + (path[0] == '/');
    to = start;
    for (char *part = start; *part;) {
        size_t size = strcspn(part, "/");
        char *next = part + size + (part[size] == '/');
        bool up = size == 2 && part[0] == '.' && part[1] == '.', slash = part[size] == '/';
        bool can_pop =
            to > start && !(to - start >= 3 && !memcmp(to - 3, "../", 3) && (to - 3 == start || to[-4] == '/'));
        if (size == 0 || (size == 1 && part[0] == '.')) {
            part = next;
            continue;
        }
        if (up && can_pop) {
            for (to--; to > start && to[-1] != '/';)
                to--;
        } else {
            memmove(to, part, size);
            to += size;
            if (slash)
                *to++ = '/';
        }
        part = next;
    }
    *to = 0;
}

const char *path_beside(Compile *c, const char *from, const char *path)
{
    const char *slash = strrchr(from, '/');
    Text joined = text_new(c->arena);
    if (path[0] != '/' && slash)
        text_add(&joined, from, (size_t)(slash - from) + 1);
    text_put(&joined, path);
    normalise(joined.at);
    if (joined.at[0] != '<')
        return joined.at;
    Text here = text_new(c->arena); /* what is read from standard input is called <stdin>, and no file is */
    text_format(&here, "./%s", joined.at);
    return here.at;
}

Graph *compile_front(Compile *c, uint32_t source, Tree **tree)
{
    *tree = read_document(c, source);
    stage_done(c, "read", 0, 0);
    Graph *graph = *tree ? resolve(c, *tree) : NULL;
    stage_done(c, "resolve", 0, 0);
    return graph;
}

/* A discard that is known to be none needs no code. */
static void drop_moot(Ir *ir)
{
    int kept = 0;
    for (int i = 0; i < ir->output_count; i++)
        if (ir->outputs[i].kind != OUT_discard || !ir_is_number(ir, ir->outputs[i].value, 0))
            ir->outputs[kept++] = ir->outputs[i];
    ir->output_count = kept;
}

/* Takes the numbers that the options name out of the program, and lays the buffer out. */
static Ir *place_members(Compile *c, Ir *ir, const Job *job)
{
    if (c->options->member_count) {
        IrKey key = ir_key(c, ir, job);
        if (key.place_count != c->options->member_count) {
            ir_done(ir);
            return diag_add(c, NO_SPAN, DIAG_wrong_members, c->options->member_count, key.place_count);
        }
        constants_place(ir, key.places, c->options->members, key.place_count);
        opt_dead(ir);
    }
    if (ir->constant_count) {
        const IrKey key = ir_key(c, ir, job);
        constants_finish(c, ir, key.members, (size_t)key.member_count);
    }
    ir_done(ir);
    const char *fault = c->check ? ir_check(ir) : NULL;
    return fault ? diag_add(c, NO_SPAN, DIAG_broken_ir, "constants", fault) : ir;
}

/* Lowered and optimised; NULL: see the diagnostics. */
Ir *compile_ir(Compile *c, const Graph *graph, const Node *material, const Job *job)
{
    Ir *ir = lower(c, graph, material, job);
    if (!ir)
        return NULL;
    if (c->measure) {
        int nodes, cost;
        ir_measure(ir, &nodes, &cost);
        stage_done(c, "lower", nodes, cost);
    }
    const char *fault = c->check ? ir_check(ir) : NULL;
    if (fault)
        return diag_add(c, NO_SPAN, DIAG_broken_ir, "lower", fault);
    if (c->optimize > 0 && !optimize(c, ir))
        return NULL;
    if (job->choice[AXIS_trigonometry] == CHOICE_trigonometry_bounded)
        opt_trigonometry(ir);
    drop_moot(ir);
    constants_hoist(ir);
    opt_dead(ir);
    if (ir->function_count && ir_written(ir, LIMIT_IR_NODES) > LIMIT_IR_NODES) {
        ir_done(ir);
        return diag_add(c, material ? material->span : NO_SPAN, DIAG_graph_too_large, LIMIT_IR_NODES);
    }
    return place_members(c, ir, job);
}

bool compile_back(Compile *c, const Ir *ir, const Job *job, Products *products)
{
    const char *log = "";
    products->fragment = emit_fragment(c, ir, job, &products->interface, &products->fragment_size);
    stage_done(c, "emit", 0, 0);
    products->vertex = c->options->validate ? emit_vertex(c, job, &products->interface) : NULL;
    if (c->options->validate &&
        !validate(c, job->target, products->vertex, products->fragment, products->interface.declarations, &log)) {
        diag_add(c, NO_SPAN, DIAG_not_valid, target_table[job->target].name, log);
        return false;
    }
    stage_done(c, "validate", 0, 0);
    return true;
}
