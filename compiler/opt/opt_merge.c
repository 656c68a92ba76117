/* A value whose gradient is computed too comes out of that: the gradient's function has it in its
 * fourth lane.
 *
 *     turbulence(p, 4, 2, 0.5) beside turbulenceGradient(p, none, 4, 2, 0.5, 0), as slopes.def says
 *         by "0r123w"
 *     becomes .w of the latter: one loop over the octaves where there were two */
#include "compiler/base/hash_index.h"
#include "compiler/opt/opt.h"

/* Whether a call of a gradient has the arguments that slopes.def makes of the value's. */
static bool is_gradient_of(const Ir *ir, Ref gradient, Ref value)
{
    const SlopeRow *row = slope_row((int)ir_at(ir, value)->payload);
    int i = 0;
    if (row->kind != SLOPE_gradient || (int)ir_at(ir, gradient)->payload != row->by)
        return false;
    for (const char *from = row->arguments; *from; from++, i++) {
        Ref arg = ir_arg(ir, gradient, i);
        bool same = *from >= '0' && *from <= '9' ? arg == ir_arg(ir, value, *from - '0')
                                                 : ir_is_number(ir, arg, 0);
        if (!same)
            return false;
    }
    return true;
}

/* Hash of the parts that value and gradient share: the row, and the arguments that it names by
 * digits. They come in that order in a call of the gradient (`shared` of it), and at the digits'
 * places in a call of the value. */
static uint32_t hash_of(const Ir *ir, const SlopeRow *row, Ref call, bool of_value)
{
    uint32_t hash = (uint32_t)row->by;
    for (int i = 0; row->arguments[i]; i++) {
        const char from = row->arguments[i];
        if (from >= '0' && from <= '9')
            hash = (hash ^ ir_arg(ir, call, of_value ? from - '0' : i)) * 0x9E3779B1u;
        hash ^= hash >> 15;
    }
    return hash;
}

/* `user` has the gradients that the outputs reach, by the arguments that they share with their
 * value. */
static Ref merge(Ir *ir, Ref ref, const void *user)
{
    const SlopeRow *row = ir_is(ir, ref, OP_call) ? slope_row((int)ir_at(ir, ref)->payload) : NULL;
    if (!row || row->kind != SLOPE_gradient)
        return ref;
    for (HashProbe probe = hash_probe(user, hash_of(ir, row, ref, true)); hash_probe_next(&probe);)
        if (is_gradient_of(ir, probe.number, ref))
            return build_swizzle(ir, probe.number, "w");
    return ref;
}

/* Under every row that it may be a gradient by. */
static void keep(Ir *ir, HashIndex *gradients, Ref ref)
{
    for (int function = 0; function < FUNCTION_COUNT; function++) {
        const SlopeRow *row = slope_row(function);
        if (row->kind == SLOPE_gradient && row->by == (int)ir_at(ir, ref)->payload)
            hash_index_add(&ir->scratch, gradients, hash_of(ir, row, ref, false), ref);
    }
}

bool opt_merge(Ir *ir)
{
    HashIndex gradients = {0};
    const uint8_t *live = NULL;
    for (Ref ref = 1; ref < ir->count; ref++) {
        if (!ir_is(ir, ref, OP_call) || ir_type(ir, ref) != TYPE_vec4)
            continue;
        live = live ? live : ir_live_kept(ir);
        if (live[ref])
            keep(ir, &gradients, ref);
    }
    return gradients.count && ir_sweep(ir, merge, &gradients);
}
