/* A value whose gradient is computed too comes out of that: the gradient's function has it in its fourth lane. */
#include "opt.h"

/* The gradients that the outputs reach. */
typedef struct {
    const Ref *at;
    size_t count;
} Gradients;

/* Whether a call of a gradient has the arguments that slopes.def makes of the value's. */
static bool is_gradient_of(const Ir *ir, Ref gradient, Ref value)
{
    const SlopeRow *row = slope_row((int)ir_at(ir, value)->payload);
    int i = 0;
    if (row->kind != SLOPE_gradient || (int)ir_at(ir, gradient)->payload != row->by)
        return false;
    for (const char *from = row->arguments; *from; from++, i++) {
        Ref arg = ir_arg(ir, gradient, i);
        bool same = *from >= '0' && *from <= '9' ? arg == ir_arg(ir, value, *from - '0') : ir_is_number(ir, arg, 0);
        if (!same)
            return false;
    }
    return true;
}

static Ref merge(Ir *ir, Ref ref, const void *user)
{
    const Gradients *gradients = user;
    if (!ir_is(ir, ref, OP_call))
        return ref;
    for (size_t i = 0; i < gradients->count; i++)
        if (is_gradient_of(ir, gradients->at[i], ref))
            return ir_swizzle(ir, gradients->at[i], "w");
    return ref;
}

bool opt_merge(Ir *ir)
{
    uint8_t *live = NULL;
    Ref *found = NULL;
    size_t count = 0, room = 0;
    for (Ref ref = 1; ref < ir->count; ref++) {
        if (!ir_is(ir, ref, OP_call) || ir_type(ir, ref) != TYPE_vec4)
            continue;
        if (!live)
            live = ir_live(ir, &ir->scratch);
        if (live[ref])
            ARENA_PUSH(&ir->scratch, found, count, room, ref);
    }
    return count && opt_sweep(ir, merge, &(Gradients){found, count});
}
