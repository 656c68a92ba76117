/* Needs go backwards from what is wanted; lives go forwards. */
#include "runtime/render/frame_plan.h"

/* From the last pass to the first: one that writes what is needed behind it runs, and needs what it reads. What it fills nobody needs before. */
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

static unsigned touched(const FramePlanPass *pass) { return pass->reads | pass->fills | pass->changes; }

/* The first and last pass that runs and touches a target; what is wanted lives on behind the last. */
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

/* Targets in the order of their first pass, each into the first piece of its class that is free by then. */
static void place(FramePlan *plan, int target, int class, const int life[2], int *free_from)
{
    int piece = 0;
    while (piece < plan->memory_count && (plan->memory_class[piece] != class || free_from[piece] > life[0]))
        piece++;
    if (piece == plan->memory_count)
        plan->memory_class[plan->memory_count++] = class;
    plan->memory[target] = piece;
    plan->there |= 1u << target;
    free_from[piece] = life[1] + 1;
}

void frame_plan(const FramePlanRequest *r, FramePlan *plan)
{
    int lives[FRAME_PLAN_MOST][2], free_from[FRAME_PLAN_MOST] = {0};
    *plan = (FramePlan){.runs = find_runs(r)};
    for (int target = 0; target < r->target_count; target++) {
        plan->memory[target] = -1;
        find_life(r, plan->runs, target, lives[target]);
    }
    for (int first = 0; first < r->pass_count; first++)
        for (int target = 0; target < r->target_count; target++)
            if (lives[target][0] == first && lives[target][1] >= 0)
                place(plan, target, r->classes[target], lives[target], free_from);
}

const char *frame_plan_reason(const FramePlanRequest *request, const FramePlan *plan, int pass)
{
    if (plan->runs >> pass & 1)
        return 0;
    return request->allowed >> pass & 1 ? "nobody needs it" : "nothing to do";
}
