/* Swizzles of swizzles, of vectors, and vectors of swizzles; narrows operations of which few
 * components are used. */
#include "compiler/opt/opt.h"
#include <string.h>

enum {
    KNOWN_DEPTH = 4, /* max operations to search for a known component */
    PUSH_DEPTH = 64  /* max nested operations through which a swizzle is moved at once */
};

static uint32_t component_at(uint32_t components, int i) { return components >> 2 * i & 3; }

/* Returns the operand of a vec that holds a component, and the component's index in it. */
static Ref part_of(const Ir *ir, Ref vec, uint32_t component, uint32_t *inner)
{
    for (int i = 0; i < ir_at(ir, vec)->count; i++) {
        Ref part = ir_arg(ir, vec, i);
        uint32_t components = (uint32_t)ir_components(ir, part);
        if (component < components) {
            *inner = component;
            return part;
        }
        component -= components;
    }
    return 0;
}

static Ref components_of_vec(Ir *ir, Ref vec, uint32_t components, int count)
{
    Ref parts[4] = {0};
    uint32_t inner[4] = {0}, together = 0;
    bool one_part = true;
    for (int i = 0; i < count; i++) {
        parts[i] = part_of(ir, vec, component_at(components, i), &inner[i]);
        one_part &= parts[i] == parts[0];
        together |= inner[i] << 2 * i;
    }
    if (one_part && ir_components(ir, parts[0]) > 1)
        return build_components(ir, parts[0], together, count);
    for (int i = 0; i < count; i++)
        parts[i] = build_components(ir, parts[i], inner[i], 1);
    return count == 1 ? parts[0] : build_vec_of(ir, build_components_type(count), parts, count);
}

static bool by_component(Op op) { return op_table[op].rule == RULE_widest || op == OP_select; }

static Ref push_down(Ir *ir, Ref swizzle, const Uses *uses, int depth);

/* Swizzles an operation's operand, and continues below it. */
static Ref components_below(Ir *ir, Ref operand, Ref swizzle, const Uses *uses, int depth)
{
    const IrNode *node = ir_at(ir, swizzle);
    if (ir_components(ir, operand) == 1)
        return operand;
    const Ref components = build_components(ir, operand, node->payload, ir_components(ir, swizzle));
    return ir_is(ir, components, OP_swizzle) ? push_down(ir, components, uses, depth - 1)
                                             : components;
}

/* Moves a swizzle below a per-component operation whose other components are unused, and further
 * down: (a + (b + c)).x becomes a.x + (b.x + c.x). */
static Ref push_down(Ir *ir, Ref swizzle, const Uses *uses, int depth)
{
    const Ref operation = ir_arg(ir, swizzle, 0);
    const int count = ir_components(ir, swizzle);
    IrNode node = *ir_at(ir, operation);
    Ref args[3];
    if (!depth || operation >= uses->count || uses->uses[operation] != 1 ||
        count >= ir_components(ir, operation) || !by_component((Op)node.op))
        return swizzle;
    for (int i = 0; i < node.count; i++)
        args[i] = components_below(ir, ir_arg(ir, operation, i), swizzle, uses, depth);
    node.type = (uint8_t)build_components_type(count);
    bool narrow = node.op != OP_select && count > 1;
    Ref made = ir_make(ir, node, args);
    return narrow && ir_at(ir, made)->type != node.type ? swizzle : made;
}

static bool known_component(const Ir *ir, Ref ref, uint32_t component, int depth, double *value);

/* Two values are mixed or selected: the component is known if it is the same number in both. */
static bool known_alike(const Ir *ir, Ref ref, uint32_t component, int depth, double *value)
{
    const Op op = (Op)ir_at(ir, ref)->op;
    const int first = op == OP_select;
    double other;
    return (op == OP_select || op == OP_mix) &&
           known_component(ir, ir_arg(ir, ref, first), component, depth, value) &&
           known_component(ir, ir_arg(ir, ref, first + 1), component, depth, &other) &&
           *value == other;
}

/* Returns true if a component of a vector is a known number whatever the other components are, for
 * instance a product with 0. */
static bool known_component(const Ir *ir, Ref ref, uint32_t component, int depth, double *value)
{
    const IrNode *node = ir_at(ir, ref);
    uint32_t inner = 0;
    double args[3] = {0};
    if (ir_components(ir, ref) == 1)
        component = 0;
    if (node->op == OP_const) {
        *value = ir_numbers(ir, ref)[component];
        return true;
    }
    if (node->op == OP_vec) {
        Ref part = part_of(ir, ref, component, &inner);
        return depth && known_component(ir, part, inner, depth - 1, value);
    }
    if (depth && known_alike(ir, ref, component, depth - 1, value))
        return true;
    if (!depth || op_table[node->op].rule != RULE_widest)
        return false;
    int known = 0;
    for (int i = 0; i < node->count; i++) {
        bool found = known_component(ir, ir_arg(ir, ref, i), component, depth - 1, &args[i]);
        if (found && node->op == OP_mul && args[i] == 0) {
            *value = 0;
            return true;
        }
        if (!found && node->op != OP_mul)
            return false;
        known += found;
    }
    return known == node->count && fold_component((Op)node->op, args, value);
}

static Ref simplify_swizzle(Ir *ir, Ref ref, const Uses *uses)
{
    uint32_t components = ir_at(ir, ref)->payload, composed = 0;
    int count = ir_components(ir, ref);
    Ref a = ir_arg(ir, ref, 0);
    if (ir_at(ir, ref)->flags & NODE_simple)
        return push_down(ir, ref, uses, PUSH_DEPTH);
    bool identity = count == ir_components(ir, a);
    for (int i = 0; i < count; i++)
        identity &= component_at(components, i) == (uint32_t)i;
    if (identity)
        return a;
    double value;
    if (count == 1 && known_component(ir, a, component_at(components, 0), KNOWN_DEPTH, &value))
        return build_float(ir, value);
    if (ir_is(ir, a, OP_swizzle)) {
        for (int i = 0; i < count; i++)
            composed |= component_at(ir_at(ir, a)->payload, (int)component_at(components, i))
                        << 2 * i;
        return build_components(ir, ir_arg(ir, a, 0), composed, count);
    }
    if (ir_is(ir, a, OP_vec))
        return components_of_vec(ir, a, components, count);
    return push_down(ir, ref, uses, PUSH_DEPTH);
}

/* vec(v.x, v.y) -> v.xy; vec(v.xy, v.z) -> v.xyz, which is v itself for a vec3 */
static Ref gather_components(Ir *ir, Ref ref)
{
    int count = 0;
    uint32_t components = 0;
    Ref from = 0;
    for (int i = 0; i < ir_at(ir, ref)->count; i++) {
        Ref part = ir_arg(ir, ref, i);
        if (!ir_is(ir, part, OP_swizzle) || (from && ir_arg(ir, part, 0) != from))
            return ref;
        from = ir_arg(ir, part, 0);
        for (int k = 0; k < ir_components(ir, part); k++)
            components |= component_at(ir_at(ir, part)->payload, k) << 2 * count++;
    }
    return count == ir_components(ir, ref) ? build_components(ir, from, components, count) : ref;
}

/* vec(vec(a, b), c) -> vec(a, b, c) */
static Ref flatten(Ir *ir, Ref ref)
{
    Ref parts[4];
    int count = 0;
    bool nested = false;
    for (int i = 0; i < ir_at(ir, ref)->count; i++) {
        Ref part = ir_arg(ir, ref, i);
        bool vec = ir_is(ir, part, OP_vec);
        nested |= vec;
        for (int k = 0; k < (vec ? ir_at(ir, part)->count : 1); k++)
            parts[count++] = vec ? ir_arg(ir, part, k) : part;
    }
    return nested ? build_vec_of(ir, ir_type(ir, ref), parts, count) : ref;
}

Ref opt_rewrite_swizzle(Ir *ir, Ref ref, const void *user)
{
    if (ir_is(ir, ref, OP_swizzle))
        return simplify_swizzle(ir, ref, user);
    if (!ir_is(ir, ref, OP_vec))
        return ref;
    if (ir_at(ir, ref)->count == 1)
        return ir_arg(ir, ref, 0);
    Ref flat = flatten(ir, ref);
    return ir_is(ir, flat, OP_vec) ? gather_components(ir, flat) : flat;
}

bool opt_swizzle(Ir *ir)
{
    const Uses uses = opt_uses(ir, &ir->scratch);
    return ir_sweep(ir, opt_rewrite_swizzle, &uses);
}
