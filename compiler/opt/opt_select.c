/* Selects with a known condition or equal arms, and operations on selects between constants,
 * which are folded in both arms. */
#include "compiler/opt/opt.h"

static Ref simplify_select(Ir *ir, Ref ref)
{
    Ref condition = ir_arg(ir, ref, 0), a = ir_arg(ir, ref, 1), b = ir_arg(ir, ref, 2);
    if (a == b)
        return a;
    if (ir_is(ir, condition, OP_const))
        return ir_numbers(ir, condition)[0] != 0 ? a : b;
    if (ir_is(ir, condition, OP_not))
        return build_select(ir, ir_arg(ir, condition, 0), b, a);
    if (ir_is(ir, a, OP_select) && ir_arg(ir, a, 0) == condition)
        return build_select(ir, condition, ir_arg(ir, a, 1), b);
    if (ir_is(ir, b, OP_select) && ir_arg(ir, b, 0) == condition)
        return build_select(ir, condition, a, ir_arg(ir, b, 2));
    return ref;
}

static bool between_constants(const Ir *ir, Ref ref)
{
    return ir_is(ir, ref, OP_select) && ir_is(ir, ir_arg(ir, ref, 1), OP_const) &&
           ir_is(ir, ir_arg(ir, ref, 2), OP_const);
}

static bool folds_through(Op op)
{
    return op_table[op].rule != RULE_given || op == OP_swizzle || op == OP_vec || op == OP_call;
}

/* op(select(c, 1, 2), 3) -> select(c, op(1, 3), op(2, 3)), if all operands are constants or
 * selects on one condition. */
static Ref through_select(Ir *ir, Ref ref)
{
    const IrNode node = *ir_at(ir, ref);
    Ref condition = 0, arms[2][16];
    if (!folds_through((Op)node.op) || node.count > 16)
        return ref;
    for (int i = 0; i < node.count; i++) {
        Ref arg = ir_arg(ir, ref, i);
        bool chooses = between_constants(ir, arg);
        if (!chooses && !ir_is(ir, arg, OP_const))
            return ref;
        if (chooses && condition && ir_arg(ir, arg, 0) != condition)
            return ref;
        if (chooses)
            condition = ir_arg(ir, arg, 0);
        arms[0][i] = chooses ? ir_arg(ir, arg, 1) : arg;
        arms[1][i] = chooses ? ir_arg(ir, arg, 2) : arg;
    }
    if (!condition)
        return ref;
    double result[2][4];
    for (int side = 0; side < 2; side++)
        if (!fold_node(ir, &node, arms[side], result[side]))
            return ref;
    Ref a = ir_const(ir, (Type)node.type, result[0]), b = ir_const(ir, (Type)node.type, result[1]);
    return a == b ? a : build_select(ir, condition, a, b);
}

Ref opt_rewrite_select(Ir *ir, Ref ref, const void *user)
{
    (void)user;
    return ir_is(ir, ref, OP_select) ? simplify_select(ir, ref) : through_select(ir, ref);
}

bool opt_select(Ir *ir) { return ir_sweep(ir, opt_rewrite_select, NULL); }
