/* Needed targets are found backwards from the wanted ones; lifetimes and memory are assigned
 * forwards. */
#include "runtime/frame_graph/frame_plan.h"
#include <string.h>

/* Walks from the last pass to the first. A pass that writes a needed target runs, and its inputs
 * become needed. A target that the pass fills is no longer needed before it. */
static unsigned find_runs(const FramePlanRequest *r)
{
    unsigned needed = r->wanted, runs = 0;
    for (int i = r->pass_count - 1; i >= 0; i--) {
        const FramePlanPass *pass = &r->passes[i];
        if (!(r->allowed >> i & 1) || !((pass->fills | pass->changes) & needed))
            continue;
        runs |= 1u << i;
        needed = (needed & ~pass->fills) | pass->reads | pass->changes;
    }
    return runs;
}

static unsigned touched(const FramePlanPass *pass)
{
    return pass->reads | pass->fills | pass->changes;
}

/* Finds the first and the last running pass that touches a target. A wanted target lives past
 * the last pass. Returns false for an unused target. */
static bool find_life(const FramePlanRequest *r, unsigned runs, int target, int life[2])
{
    life[0] = r->pass_count;
    life[1] = -1;
    for (int i = 0; i < r->pass_count; i++)
        if (runs >> i & 1 && touched(&r->passes[i]) >> target & 1) {
            life[0] = i < life[0] ? i : life[0];
            life[1] = i;
        }
    if (life[1] >= 0 && r->wanted >> target & 1)
        life[1] = r->pass_count;
    return life[1] >= 0;
}

/* The target that occupies a piece of memory, and the last pass that uses the target there. */
typedef struct {
    int target, last;
} Holder;

/* Reports whether a piece of memory is free for a target first written by pass `number`: its
 * holder is dead by then, or the pass reads the holder only at the pixel that it fills. */
static bool is_free(const FramePlanPass *pass, int number, int target, const Holder *holder)
{
    return holder->last < number ||
           (holder->last == number &&
            (pass->own & ~pass->changes) >> holder->target & pass->fills >> target & 1);
}

/* Puts each texture into the first free piece of its class, or into a new piece. */
static void place(const FramePlanRequest *r, FramePlan *plan, int target, const int life[2],
                  Holder *holders)
{
    const FramePlanTarget *row = &r->targets[target];
    plan->there |= 1u << target;
    for (int i = 0, piece; i < row->count; i++) {
        for (piece = 0; piece < plan->memory_count; piece++)
            if (plan->memory_class[piece] == row->classes[i] &&
                is_free(&r->passes[life[0]], life[0], target, &holders[piece]))
                break;
        if (piece == plan->memory_count)
            plan->memory_class[plan->memory_count++] = row->classes[i];
        plan->memory[target][i] = piece;
        holders[piece] = (Holder){target, life[1]};
    }
}

void frame_plan(const FramePlanRequest *r, FramePlan *plan)
{
    int lives[FRAME_PLAN_MAX][2];
    Holder holders[FRAME_PLAN_PIECES];
    *plan = (FramePlan){.runs = find_runs(r)};
    memset(plan->memory, -1, sizeof plan->memory);
    for (int target = 0; target < r->target_count; target++)
        find_life(r, plan->runs, target, lives[target]);
    for (int first = 0; first < r->pass_count; first++)
        for (int target = 0; target < r->target_count; target++)
            if (lives[target][0] == first && lives[target][1] >= 0)
                place(r, plan, target, lives[target], holders);
}

const char *frame_plan_reason(const FramePlanRequest *request, const FramePlan *plan, int pass)
{
    if (plan->runs >> pass & 1)
        return 0;
    return request->allowed >> pass & 1 ? "nobody needs it" : "nothing to do";
}
