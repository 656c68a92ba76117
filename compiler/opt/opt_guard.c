/* Guards of what is computed anyhow go. A guard pays where nothing but itself needs what is costly below it:
 *
 *     a = granite(p); g = guard(c, a); h = guard(d, a)    a is needed by two, so each branch would hold nothing: g and h become a
 *     a = granite(p); s = sqrt(a); g = guard(c, s)        s and a are g's alone: g stays, and is written as a branch
 *
 * All that is the guard's alone is found from its value downward: an operand is, once as many of its users are as it has. */
#include "compiler/opt/opt.h"

enum {
    WORTH_A_BRANCH = 40, /* scalar operations */
    MOOT = 2,            /* payload of a guard that goes */
};

typedef struct {
    const uint32_t *uses; /* by Ref */
    uint32_t *own;        /* by Ref: of the uses, those by what is the guard's alone; 0 again in between */
    Ref *met;             /* nodes whose `own` is set */
    size_t met_count, met_room;
} Guards;

static void note_use(Ir *ir, Guards *g, Ref value, Ref *alone, int *count)
{
    if (!g->own[value])
        ARENA_PUSH(&ir->scratch, g->met, g->met_count, g->met_room, value);
    if (++g->own[value] == g->uses[value])
        alone[(*count)++] = value;
}

/* Whether what is the guard's alone costs as much as a branch is worth. Looks at no more nodes than ROOM, lanes and vectors of what is
 * looked at cost nothing. */
static bool pays(Ir *ir, Guards *g, Ref guard)
{
    enum { ROOM = 256 };
    Ref alone[ROOM + UINT8_MAX];
    int count = 0, cost = 0;
    note_use(ir, g, ir_arg(ir, guard, 1), alone, &count);
    for (int i = 0; i < count && count < ROOM && cost < WORTH_A_BRANCH; i++) {
        cost += ir_applies(ir, alone[i]) ? WORTH_A_BRANCH : ir_cost(ir, alone[i]);
        for (int k = 0; k < ir_at(ir, alone[i])->count; k++)
            note_use(ir, g, ir_arg(ir, alone[i], k), alone, &count);
    }
    while (g->met_count)
        g->own[g->met[--g->met_count]] = 0;
    return cost >= WORTH_A_BRANCH;
}

static Ref settle(Ir *ir, Ref ref, const void *user)
{
    (void)user;
    if (!build_is_guard(ir, ref))
        return ref;
    if (ir_at(ir, ref)->payload == MOOT)
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
    Guards g = {.uses = opt_uses(ir, &ir->scratch).uses, .own = ARENA_ARRAY(&ir->scratch, uint32_t, ir->count)};
    bool any = false;
    for (Ref ref = 1; ref < ir->count; ref++) {
        if (!g.uses[ref] || !build_is_guard(ir, ref))
            continue;
        any = true;
        if (!pays(ir, &g, ref))
            ir->nodes[ref].payload = MOOT;
    }
    if (!any)
        return false;
    ir_rehash(ir);
    return ir_sweep(ir, settle, NULL);
}
