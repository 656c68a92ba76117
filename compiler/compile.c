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

bool diag_full(const Session *session) { return session->diags.count >= MOST_DIAGS; }

void *diag_add(Session *session, Span span, DiagKind kind, ...)
{
    if (diag_full(session)) {
        session->diags.errors += diag_table[kind].severity == SEVERITY_error;
        return NULL;
    }
    va_list args;
    session->message.arena = session->arena;
    session->message.size = 0;
    va_start(args, kind);
    diag_message(&session->message, kind, args);
    va_end(args);
    for (size_t i = 0; i < session->diags.count; i++) { /* what is asked for several slots is said once */
        const Diag *said = &session->diags.at[i];
        if (said->kind == kind && !memcmp(&said->span, &span, sizeof span) &&
            !strcmp(said->message, session->message.at))
            return NULL;
    }
    const char *message = arena_string(session->arena, session->message.at, session->message.size);
    Diag diag = {kind, diag_table[kind].severity, span, message};
    ARENA_PUSH(session->arena, session->diags.at, session->diags.count, session->diags.room, diag);
    session->diags.errors += diag.severity == SEVERITY_error;
    return NULL;
}

const char *diag_all(Session *session, MatcForm form)
{
    Text out = text_new(session->arena);
    if (form == MATC_JSON)
        text_put(&out, "[");
    for (size_t i = 0; i < session->diags.count; i++) {
        if (form == MATC_TEXT) {
            diag_print(&out, &session->diags.at[i], session->sources);
        } else {
            text_put(&out, i ? ",\n " : "\n ");
            diag_print_json(&out, &session->diags.at[i], session->sources);
        }
    }
    if (form == MATC_JSON)
        text_put(&out, session->diags.count ? "\n]\n" : "]\n");
    return out.at ? out.at : "";
}

double stage_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + (double)now.tv_nsec * 1e-9;
}

void stage_done(Session *session, const char *name, int nodes, int cost)
{
    if (!session->measure)
        return;
    double now = stage_now();
    StageStats stats = {name, now - session->stage_start, nodes, cost};
    ARENA_PUSH(session->arena, session->stats, session->stat_count, session->stat_room, stats);
    session->stage_start = stage_now(); /* what statistics cost does not count */
}

char *read_file(Session *session, const char *path, size_t *size, const char **why)
{
    if (session->options->read_file)
        return session->options->read_file(session->options->user, path, size, why);
    return file_read(path, size, why);
}

void depend_on(Session *session, const char *path) { names_add(session->arena, &session->depends, path); }

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

const char *path_beside(Session *session, const char *from, const char *path)
{
    const char *slash = strrchr(from, '/');
    Text joined = text_new(session->arena);
    if (path[0] != '/' && slash)
        text_add(&joined, from, (size_t)(slash - from) + 1);
    text_put(&joined, path);
    normalise(joined.at);
    if (joined.at[0] != '<')
        return joined.at;
    Text here = text_new(session->arena); /* what is read from standard input is called <stdin>, and no file is */
    text_format(&here, "./%s", joined.at);
    return here.at;
}

Graph *compile_front(Session *session, uint32_t source, Tree **tree)
{
    *tree = read_document(session, source);
    stage_done(session, "read", 0, 0);
    Graph *graph = *tree ? resolve(session, *tree) : NULL;
    stage_done(session, "resolve", 0, 0);
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
static Ir *place_members(Session *session, Ir *ir, const Job *job)
{
    if (session->options->member_count) {
        IrKey key = ir_key(session, ir, job);
        if (key.place_count != session->options->member_count) {
            ir_done(ir);
            return diag_add(session, NO_SPAN, DIAG_wrong_members, session->options->member_count, key.place_count);
        }
        constants_place(ir, key.places, session->options->members, key.place_count);
        opt_dead(ir);
    }
    if (ir->constant_count) {
        const IrKey key = ir_key(session, ir, job);
        constants_finish(session, ir, key.members, (size_t)key.member_count);
    }
    ir_done(ir);
    const char *fault = session->check ? ir_check(ir) : NULL;
    return fault ? diag_add(session, NO_SPAN, DIAG_broken_ir, "constants", fault) : ir;
}

/* Lowered and optimised; NULL: see the diagnostics. */
Ir *compile_ir(Session *session, const Graph *graph, const Node *material, const Job *job)
{
    Ir *ir = lower(session, graph, material, job);
    if (!ir)
        return NULL;
    if (session->measure) {
        int nodes, cost;
        ir_measure(ir, &nodes, &cost);
        stage_done(session, "lower", nodes, cost);
    }
    const char *fault = session->check ? ir_check(ir) : NULL;
    if (fault)
        return diag_add(session, NO_SPAN, DIAG_broken_ir, "lower", fault);
    if (session->optimize > 0 && !optimize(session, ir))
        return NULL;
    if (job->choice[AXIS_trigonometry] == CHOICE_trigonometry_bounded)
        opt_trigonometry(ir);
    drop_moot(ir);
    constants_hoist(ir);
    opt_dead(ir);
    if (ir->function_count && ir_written(ir, LIMIT_IR_NODES) > LIMIT_IR_NODES) {
        ir_done(ir);
        return diag_add(session, material ? material->span : NO_SPAN, DIAG_graph_too_large, LIMIT_IR_NODES);
    }
    return place_members(session, ir, job);
}

bool compile_back(Session *session, const Ir *ir, const Job *job, Products *products)
{
    const char *log = "";
    products->fragment = emit_fragment(session, ir, job, &products->interface, &products->fragment_size);
    stage_done(session, "emit", 0, 0);
    products->vertex = session->options->validate ? emit_vertex(session, job, &products->interface) : NULL;
    if (session->options->validate &&
        !validate(session, job->target, products->vertex, products->fragment, products->interface.declarations, &log)) {
        diag_add(session, NO_SPAN, DIAG_not_valid, target_table[job->target].name, log);
        return false;
    }
    stage_done(session, "validate", 0, 0);
    return true;
}
