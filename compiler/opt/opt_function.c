/* Inlines functions that do not depend on their arguments; drops unused arguments and unread
 * components of results.
 *
 *     f(p, st) = noise(p)    the calls f(a, b) become g(a), g(p) = noise(p)
 *     f(p).x, f(q).x         of a vec3 f without reads of other components: become h(p), h(q)
 *                            with h(p) = f(p).x
 *     f(p, st) = 0.5         the calls become 0.5, and a kernel's sum 27 times that */
#include "compiler/opt/opt.h"

/* Max arguments of a program that are tracked; every function is assumed to read any further
 * ones. */
enum { MAX_DISTINGUISHED = 64 };

/* Returns the arguments that every node depends on, a bit each. One sweep serves all functions. */
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
        if (number[ref] < MAX_DISTINGUISHED)
            read[ref] = (uint64_t)1 << number[ref];
    }
    return read;
}

/* Returns the arguments that each function's result depends on, a bit each. */
static uint32_t *arguments_read(const Ir *ir, Arena *scratch)
{
    uint32_t *read = ARENA_ARRAY(scratch, uint32_t, ir->function_count + 1),
             *number = ARENA_ARRAY(scratch, uint32_t, ir->count);
    const uint64_t *values = values_read(ir, number, scratch);
    for (uint32_t f = 0; f < ir->function_count; f++) {
        const IrFunction *function = &ir->functions[f];
        for (int i = 0; i < function->count; i++) {
            uint32_t bit = number[function->arguments[i]];
            bool reads = bit >= MAX_DISTINGUISHED || values[function->result] >> bit & 1;
            read[f] |= (uint32_t)reads << i;
        }
    }
    return read;
}

/* Creates a function with only the arguments that are read. */
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
    ARENA_PUSH(ir->arena, ir->functions, ir->function_count, ir->function_capacity, function);
    return (int)ir->function_count - 1;
}

enum { ALL_COMPONENTS = 15 };

/* Returns the components of a call that a user reads, a bit each. A component that is read twice
 * counts as a read of all. */
static uint32_t components_of_use(const Ir *ir, Ref user)
{
    uint32_t components = 0;
    if (!ir_is(ir, user, OP_swizzle))
        return ALL_COMPONENTS;
    for (int i = 0; i < ir_components(ir, user); i++) {
        const uint32_t bit = 1u << (ir_at(ir, user)->payload >> 2 * i & 3);
        components |= components & bit ? ALL_COMPONENTS : bit;
    }
    return components;
}

static void read_components(const Ir *ir, Ref value, uint32_t components, uint32_t *read)
{
    if (ir_applies(ir, value))
        read[ir_at(ir, value)->payload] |= components;
}

/* Returns the components of each function's result that any call reads. */
static uint32_t *components_read(Ir *ir, Arena *scratch)
{
    const uint8_t *live = ir_live_kept(ir);
    uint32_t *read = ARENA_ARRAY(scratch, uint32_t, ir->function_count + 1);
    for (Ref ref = 1; ref < ir->count; ref++)
        for (int i = 0; live[ref] && i < ir_at(ir, ref)->count; i++)
            read_components(ir, ir_arg(ir, ref, i), components_of_use(ir, ref), read);
    for (int i = 0; i < ir->output_count; i++)
        read_components(ir, ir->outputs[i].value, ALL_COMPONENTS, read);
    for (size_t f = 0; f < ir->function_count; f++)
        if (live[ir->functions[f].result])
            read_components(ir, ir->functions[f].result, ALL_COMPONENTS, read);
    return read;
}

typedef struct {
    const uint32_t *read, *components;
    int *trimmed, *narrowed; /* replacement of each function, from 1; 0: none */
    size_t count;
} Plan;

/* Converts a bit mask of components to a swizzle. */
static uint32_t swizzle_of(uint32_t mask, int *count)
{
    uint32_t components = 0;
    *count = 0;
    for (uint32_t component = 0; component < 4; component++)
        if (mask >> component & 1)
            components |= component << 2 * (*count)++;
    return components;
}

/* Creates a function with only the components of the result that are read. */
static int narrowed(Ir *ir, int f, uint32_t mask)
{
    int count;
    const uint32_t components = swizzle_of(mask, &count);
    IrFunction function = ir->functions[f];
    function.result = build_components(ir, function.result, components, count);
    ARENA_PUSH(ir->arena, ir->functions, ir->function_count, ir->function_capacity, function);
    return (int)ir->function_count - 1;
}

/* Rewrites f(p).z to h(p).y if only y and z of f are read. */
static Ref simplify_components(Ir *ir, Ref swizzle, const Plan *plan)
{
    const Ref call = ir_arg(ir, swizzle, 0);
    IrNode node = *ir_at(ir, call);
    if (!ir_applies(ir, call) || node.payload >= plan->count)
        return swizzle;
    const uint32_t f = node.payload, mask = plan->components[f], own = ir_at(ir, swizzle)->payload;
    int count, position[4] = {0};
    swizzle_of(mask, &count);
    if (!count || count >= ir_components(ir, call))
        return swizzle;
    if (!plan->narrowed[f])
        plan->narrowed[f] = narrowed(ir, (int)f, mask) + 1;
    for (int component = 0, next = 0; component < 4; component++)
        position[component] = mask >> component & 1 ? next++ : 0;
    Ref args[32];
    for (int i = 0; i < node.count; i++)
        args[i] = ir_arg(ir, call, i);
    node.payload = (uint32_t)plan->narrowed[f] - 1;
    node.type = (uint8_t)build_components_type(count);
    const Ref made = ir_make(ir, node, args);
    uint32_t components = 0;
    for (int i = 0; i < ir_components(ir, swizzle); i++)
        components |= (uint32_t)position[own >> 2 * i & 3] << 2 * i;
    return count == 1 ? made : build_components(ir, made, components, ir_components(ir, swizzle));
}

static Ref simplify(Ir *ir, Ref ref, const void *user)
{
    const Plan *plan = user;
    IrNode node = *ir_at(ir, ref);
    if (node.op == OP_swizzle)
        return simplify_components(ir, ref, plan);
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
        /* also keeps the last operand of a kernel, its size */
        if (plan->read[f] >> i & 1 || i == ir->functions[f].count)
            args[node.count++] = ir_arg(ir, ref, i);
    node.payload = (uint32_t)plan->trimmed[f] - 1;
    return ir_make(ir, node, args);
}

bool opt_function(Ir *ir)
{
    if (!ir->function_count)
        return false;
    Arena *scratch = &ir->scratch;
    Plan plan = {arguments_read(ir, scratch), components_read(ir, scratch),
                 ARENA_ARRAY(scratch, int, ir->function_count + 1),
                 ARENA_ARRAY(scratch, int, ir->function_count + 1), ir->function_count};
    bool changed = ir_sweep(ir, simplify, &plan);
    return changed;
}
