/* Functions that do not depend on their arguments become their bodies; arguments that are not read are dropped.
 *
 *     f(p, st) = noise(p)    the calls f(a, b) become g(a), g(p) = noise(p)
 *     f(p, st) = 0.5         the calls become 0.5, and a kernel's sum of it 27 times that */
#include "compiler/opt/opt.h"

enum { MOST_TOLD_APART = 64 }; /* arguments of a program; of any further one every function is taken to read it */

/* Which arguments of the program every value reads: a bit each, by their order. One sweep finds them for all functions. */
static uint64_t *values_read(const Ir *ir, uint32_t *number, Arena *scratch)
{
    uint64_t *read = ARENA_ARRAY(scratch, uint64_t, ir->count);
    uint32_t arguments = 0;
    for (Ref ref = 1; ref < ir->count; ref++) {
        for (int i = 0; i < ir_at(ir, ref)->count; i++)
            read[ref] |= read[ir_arg(ir, ref, i)];
        if (!ir_is(ir, ref, OP_argument))
            continue;
        number[ref] = arguments++;
        if (number[ref] < MOST_TOLD_APART)
            read[ref] = (uint64_t)1 << number[ref];
    }
    return read;
}

/* Which arguments of each function its body reads: a bit each. */
static uint32_t *arguments_read(const Ir *ir, Arena *scratch)
{
    uint32_t *read = ARENA_ARRAY(scratch, uint32_t, ir->function_count + 1),
             *number = ARENA_ARRAY(scratch, uint32_t, ir->count);
    const uint64_t *values = values_read(ir, number, scratch);
    for (uint32_t f = 0; f < ir->function_count; f++) {
        const IrFunction *function = &ir->functions[f];
        for (int i = 0; i < function->count; i++) {
            uint32_t bit = number[function->arguments[i]];
            bool reads = bit >= MOST_TOLD_APART || values[function->result] >> bit & 1;
            read[f] |= (uint32_t)reads << i;
        }
    }
    return read;
}

/* The function with only the arguments it reads. */
static int trimmed(Ir *ir, int f, uint32_t read)
{
    IrFunction function = ir->functions[f];
    Ref *kept = ARENA_ARRAY(ir->arena, Ref, function.count);
    int count = 0;
    for (int i = 0; i < function.count; i++)
        if (read >> i & 1)
            kept[count++] = function.arguments[i];
    function.arguments = kept;
    function.count = count;
    ARENA_PUSH(ir->arena, ir->functions, ir->function_count, ir->function_room, function);
    return (int)ir->function_count - 1;
}

typedef struct {
    const uint32_t *read;
    int *trimmed; /* function that replaces one, from 1; 0 for none */
    size_t count;
} Plan;

static Ref simplify_apply(Ir *ir, Ref ref, const void *user)
{
    const Plan *plan = user;
    IrNode node = *ir_at(ir, ref);
    if (!ir_applies(ir, ref) || node.payload >= plan->count)
        return ref;
    uint32_t f = node.payload, all = (1u << ir->functions[f].count) - 1;
    if (!plan->read[f] && node.op == OP_kernel)
        return build_mul(ir, ir->functions[f].result, build_float(ir, KERNEL_POINTS));
    if (!plan->read[f])
        return ir->functions[f].result;
    if (plan->read[f] == all)
        return ref;
    if (!plan->trimmed[f])
        plan->trimmed[f] = trimmed(ir, (int)f, plan->read[f]) + 1;
    Ref args[32];
    node.count = 0;
    for (int i = 0; i < ir_at(ir, ref)->count; i++)
        if (plan->read[f] >> i & 1 || i == ir->functions[f].count) /* a kernel's size stays */
            args[node.count++] = ir_arg(ir, ref, i);
    node.payload = (uint32_t)plan->trimmed[f] - 1;
    return ir_make(ir, node, args);
}

bool opt_function(Ir *ir)
{
    if (!ir->function_count)
        return false;
    Arena *scratch = &ir->scratch;
    Plan plan = {arguments_read(ir, scratch), ARENA_ARRAY(scratch, int, ir->function_count + 1), ir->function_count};
    bool changed = ir_sweep(ir, simplify_apply, &plan);
    return changed;
}
