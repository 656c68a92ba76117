/* The list of optimiser passes. */
#include "compiler/opt/opt.h"

enum { MOST_ROUNDS = 8 };

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

/* Until nothing changes: where all passes of a round left everything as it is, another round would,
 * too. */
static bool run_rounds(Session *session, Ir *ir)
{
    static const OptPass polish = {"polish", opt_polish}, range = {"range", opt_range},
                         function = {"function", opt_function};
    bool found = true; /* by ranges and functions */
    for (int round = 0; round < MOST_ROUNDS; round++) {
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

/* The builder has applied the local rules to every node as it was made; what they gain from knowing
 * uses and ranges is left, and each gain may make room for another. What is needed once more than a
 * guard's branch is known when all else is done, and so are values beside gradients whose arguments
 * came to be the same only then. */
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
