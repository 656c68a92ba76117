/* Replaces a value whose gradient is also computed by the fourth component of the gradient's
 * function.
 *
 *     turbulence(p, 4, 2, 0.5) and turbulenceGradient(p, none, 4, 2, 0.5, 0), related by
 *         "0r123w" of slopes.def
 *     the value becomes .w of the gradient: one loop over the octaves instead of two */
#include "compiler/base/hash_index.h"
#include "compiler/opt/opt.h"

/* Returns true if a gradient call has the arguments that slopes.def derives from the value's. */
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

/* Hashes the parts that value and gradient share: the row, and the arguments that the row names
 * by digits. In a gradient call they are at the positions of the digits; in a value call at the
 * positions that the digits name. */
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

/* `user` indexes the live gradients by the arguments that they share with their value. */
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

/* Adds a gradient under every row that may refer to it. */
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
