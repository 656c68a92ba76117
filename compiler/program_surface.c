/* Properties of the surface that a program describes. */
#include "compiler/program.h"

const Node *program_material(const MatcProgram *p)
{
    return p->document->graph->materials[p->material].node;
}

/* Returns the opacity that lowering found, as for most materials; otherwise compiles the
 * transparency alone. */
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
    static const char *const names[] = {[OPACITY_opaque] = "opaque",
                                        [OPACITY_transparent] = "transparent",
                                        [OPACITY_varying] = "varying"};
    if (!p || !p->ir)
        return NULL;
    p->ir->opacity = find_opacity(p);
    return names[p->ir->opacity];
}

double matc_displacement_bound(const MatcProgram *p)
{
    return p && p->ir ? compile_displacement_bound(p->ir) : 0;
}
