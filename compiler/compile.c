/* The compiler's pipeline as a list of stages. */
#include "compiler/pipeline.h"
#include "compiler/emit/validate.h"
#include "compiler/resolve/resolve.h"
#include "compiler/ir/key.h"
#include "compiler/lower/lower.h"
#include "compiler/opt/opt.h"
#include "compiler/ir/range.h"
#include "grammar/layout_tables.h"
#include <math.h>

/* Relative rounding error of bounds from intervals: range.h. */
#define DISPLACEMENT_SLACK 1e-5

Graph *compile_front(Session *session, uint32_t source, Tree **tree)
{
    *tree = read_document(session, source);
    session_stage_done(session, "read", 0, 0);
    Graph *graph = *tree ? resolve(session, *tree) : NULL;
    session_stage_done(session, "resolve", 0, 0);
    return graph;
}

/* Removes a discard whose condition is known to be false. */
static void drop_constant_discard(Ir *ir)
{
    int kept = 0;
    for (int i = 0; i < ir->output_count; i++)
        if (ir->outputs[i].kind != OUT_discard || !ir_is_number(ir, ir->outputs[i].value, 0))
            ir->outputs[kept++] = ir->outputs[i];
    if (kept < ir->output_count)
        ir->live = NULL;
    ir->output_count = kept;
}

/* Moves the numbers selected by the options to the uniform block, and lays it out. */
static Ir *place_members(Session *session, Ir *ir, const Job *job)
{
    if (session->options->member_count) {
        IrKey key = ir_key(session, ir, job);
        if (key.place_count != session->options->member_count) {
            ir_done(ir);
            return diag_add(session, NO_SPAN, DIAG_wrong_members, session->options->member_count,
                            key.place_count);
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

double compile_displacement_bound(const Ir *ir)
{
    const IrOutput *output = ir_output_of(ir, OUT_displacement);
    Arena arena = {0};
    double given[4], size = 0;
    if (!output)
        return 0;
    const Ranges ranges = range_find(ir, &arena, FIELD_COMPONENTS);
    for (int component = 0; component < ir_components(ir, output->value); component++) {
        const Interval x = range_of(&ranges, ir, output->value, component);
        const double most = fmax(fabs(x.low), fabs(x.high));
        /* tangents and normal need not be orthogonal */
        size = ir_components(ir, output->value) == 4 ? fmax(size, most) : size + most;
    }
    arena_free(&arena);
    const Value *bound = graph_displacement(ir->displaced).bound;
    if (bound->kind == VALUE_number) {
        value_number(bound, TYPE_float, given);
        size = fmin(size, given[0]);
    }
    return size * (1 + DISPLACEMENT_SLACK);
}

/* Warns if the displacement bound, by which the host culls, is infinite. */
static void lint_bound(Session *session, const Ir *ir)
{
    if (!ir->displaced || isfinite(compile_displacement_bound(ir)))
        return;
    const Displacement d = graph_displacement(ir->displaced);
    const Node *map = d.volume->kind == VALUE_node   ? d.volume->node
                      : d.height->kind == VALUE_node ? d.height->node
                                                     : d.vector->node;
    diag_add(session, map->span, DIAG_unbounded_displacement);
}

/* Lowers and optimizes; returns NULL after reporting faults. */
Ir *compile_ir(Session *session, const Graph *graph, const Node *material, const Job *job)
{
    Ir *ir = lower(session, graph, material, job, opt_simplify);
    if (!ir)
        return NULL;
    if (session->measure) {
        int nodes, cost;
        ir_measure(ir, &nodes, &cost);
        session_stage_done(session, "lower", nodes, cost);
    }
    const char *fault = session->check ? ir_check(ir) : NULL;
    if (fault)
        return diag_add(session, NO_SPAN, DIAG_broken_ir, "lower", fault);
    if (session->optimize > 0 && !opt_run(session, ir))
        return NULL;
    if (job->choice[AXIS_trigonometry] == CHOICE_trigonometry_bounded)
        opt_trigonometry(ir);
    drop_constant_discard(ir);
    lint_bound(session, ir);
    constants_hoist(ir);
    opt_dead(ir);
    if (ir->function_count && ir_written(ir, LIMIT_IR_NODES) > LIMIT_IR_NODES) {
        ir_done(ir);
        return diag_add(session, material ? material->span : NO_SPAN, DIAG_graph_too_large,
                        LIMIT_IR_NODES);
    }
    return place_members(session, ir, job);
}

bool compile_back(Session *session, const Ir *ir, const Job *job, Products *products)
{
    const char *log;
    products->fragment =
        emit_fragment(session, ir, job, &products->interface, &products->fragment_size);
    session_stage_done(session, "emit", 0, 0);
    products->vertex =
        session->options->validate ? emit_vertex(session, job, &products->interface) : NULL;
    const ProgramTexts texts = {products->vertex, products->fragment,
                                products->interface.declarations};
    if (session->options->validate && !validate(session, job->target, &texts, &log)) {
        diag_add(session, NO_SPAN, DIAG_not_valid, target_table[job->target].name, log);
        return false;
    }
    session_stage_done(session, "validate", 0, 0);
    return true;
}
