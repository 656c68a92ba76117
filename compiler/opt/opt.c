/* Runs the optimizer passes in order. */
#include "compiler/opt/opt.h"

enum { MAX_ROUNDS = 8 };

typedef struct {
    const char *name;
    bool (*run)(Ir *ir);
} OptPass;

static bool run(Session *session, Ir *ir, const OptPass *pass, bool *progress)
{
    *progress |= pass->run(ir);
    arena_reset(&ir->scratch);
    const char *fault = session->check ? ir_check(ir) : NULL;
    if (fault)
        diag_add(session, NO_SPAN, DIAG_broken_ir, pass->name, fault);
    if (session->measure) {
        int nodes, cost;
        ir_measure(ir, &nodes, &cost);
        session_stage_done(session, pass->name, nodes, cost);
    }
    return !fault;
}

/* Runs rounds until a fixed point: a round in which no pass changes anything would repeat
 * itself. */
static bool run_rounds(Session *session, Ir *ir)
{
    static const OptPass polish = {"polish", opt_polish}, range = {"range", opt_range},
                         function = {"function", opt_function};
    bool found = true; /* ranges or functions changed something */
    for (int round = 0; round < MAX_ROUNDS; round++) {
        bool polished = false;
        if (!run(session, ir, &polish, &polished))
            return false;
        if (!found && !polished)
            break;
        found = false;
        if (!run(session, ir, &range, &found) || !run(session, ir, &function, &found))
            return false;
        if (!found && !polished)
            break;
    }
    return true;
}

/* The builder has already applied the local rules to every new node. The passes add rules that
 * depend on uses and ranges, where each change may enable another. Two passes run at the end.
 * Guards can be judged only when it is final which nodes have users outside the branch. Values
 * and gradients may get equal arguments only by the other passes. */
bool opt_run(Session *session, Ir *ir)
{
    static const OptPass merge = {"merge", opt_merge}, centre = {"centre", opt_centre},
                         guard = {"guard", opt_guard};
    bool merged = false, settled = false;
    if (!run(session, ir, &merge, &merged) ||
        (ir->texture_count && !run(session, ir, &centre, &merged)) || !run_rounds(session, ir) ||
        !run(session, ir, &merge, &settled) || !run(session, ir, &guard, &settled))
        return false;
    return !settled || run_rounds(session, ir);
}
