/* Removes guards of values that are computed in any case. Guards on one condition form one
 * branch (emit/schedule.c), which pays if costly operands have no users outside the guards:
 *
 *     a = granite(p); g = guard(c, a); h = guard(d, a)    a is needed by two conditions, so the
 *                                                         branches would be empty: g and h
 *                                                         become a
 *     a = granite(p); s = sqrt(a); g = guard(c, s)        only g needs s and a: g stays, and
 *                                                         is written as a branch
 *     a = granite(p); g = guard(c, a); h = guard(c, 2 a)  only g and h need a: both stay, as
 *                                                         one branch
 *
 * Exclusive nodes are found from the guarded values downward: an operand is exclusive once all
 * of its users are. Nodes with screen-space derivatives are never exclusive, since no branch may
 * contain them. */
#include "compiler/opt/opt.h"

enum {
    WORTH_A_BRANCH = 40, /* min cost of a branch in scalar operations */
    /* Payload of a dead guard; its hash is not updated, since no more guards are created. */
    DEAD = 2,
};

typedef struct {
    const uint32_t *uses; /* per Ref: number of uses */
    Ref *first;           /* per condition: the first of its guards, which `next` links */
    Ref *next;            /* per guard: the next guard of its condition */
    /* Per Ref: number of uses by exclusive nodes; zeroed between conditions. */
    uint32_t *own;
    Ref *met; /* nodes with nonzero `own` */
    size_t met_count, met_capacity;
    Ref *alone; /* exclusive nodes of the guards */
    size_t alone_count, alone_capacity;
} Guards;

static void note_use(Ir *ir, Guards *g, Ref value)
{
    if (ir_needs_neighbours(ir, value))
        return;
    if (!g->own[value])
        ARENA_PUSH(&ir->scratch, g->met, g->met_count, g->met_capacity, value);
    if (++g->own[value] == g->uses[value])
        ARENA_PUSH(&ir->scratch, g->alone, g->alone_count, g->alone_capacity, value);
}

/* max nodes examined per condition, in addition to the guarded values */
enum { CAPACITY = 256 };

/* Collects exclusive nodes until they are worth a branch or none is left. Returns false if they
 * are not worth one. Swizzles and vectors cost nothing. */
static bool pays(Ir *ir, Guards *g, Ref first)
{
    size_t i = 0, values = 0;
    int cost = 0;
    g->alone_count = 0;
    for (Ref guard = first; guard; guard = g->next[guard], values++)
        note_use(ir, g, ir_arg(ir, guard, 1));
    const bool all = g->alone_count == values;
    for (; i < g->alone_count && i < values + CAPACITY && (cost < WORTH_A_BRANCH || !all); i++) {
        const Ref ref = g->alone[i];
        cost += ir_applies(ir, ref) ? WORTH_A_BRANCH : ir_cost(ir, ref);
        for (int k = 0; k < ir_at(ir, ref)->count; k++)
            note_use(ir, g, ir_arg(ir, ref, k));
    }
    return cost >= WORTH_A_BRANCH;
}

/* Marks as dead the guards of a condition that save nothing: all, or those whose value has other
 * users. */
static void judge(Ir *ir, Guards *g, Ref first)
{
    const bool paid = pays(ir, g, first);
    for (Ref guard = first; guard; guard = g->next[guard]) {
        const Ref value = ir_arg(ir, guard, 1);
        if (!paid || g->own[value] < g->uses[value])
            ir->nodes[guard].payload = DEAD;
    }
    while (g->met_count)
        g->own[g->met[--g->met_count]] = 0;
}

static Ref settle(Ir *ir, Ref ref, const void *user)
{
    (void)user;
    if (!build_is_guard(ir, ref))
        return ref;
    if (ir_at(ir, ref)->payload == DEAD)
        return ir_arg(ir, ref, 1);
    return build_select(ir, ir_arg(ir, ref, 0), ir_arg(ir, ref, 1), ir_arg(ir, ref, 2));
}

static bool has_guard(const Ir *ir)
{
    for (Ref ref = 1; ref < ir->count; ref++)
        if (build_is_guard(ir, ref))
            return true;
    return false;
}

bool opt_guard(Ir *ir)
{
    if (!has_guard(ir))
        return false;
    Guards g = {.uses = opt_uses(ir, &ir->scratch).uses,
                .first = ARENA_ARRAY(&ir->scratch, Ref, ir->count),
                .next = ARENA_ARRAY(&ir->scratch, Ref, ir->count),
                .own = ARENA_ARRAY(&ir->scratch, uint32_t, ir->count)};
    bool any = false;
    for (Ref ref = 1; ref < ir->count; ref++) {
        if (!g.uses[ref] || !build_is_guard(ir, ref))
            continue;
        Ref *first = &g.first[ir_arg(ir, ref, 0)];
        any = true;
        g.next[ref] = *first;
        *first = ref;
    }
    for (Ref ref = 1; any && ref < ir->count; ref++)
        if (g.first[ref])
            judge(ir, &g, g.first[ref]);
    return any && ir_sweep(ir, settle, NULL);
}
