/* Values that constants settle, whatever the level of -O. From -O1 on the builder folds them as they are made. At -O0 they stay as
 * written: of `%3 = lt 2 1; %4 = select %3 %1 %2` nobody sees that %4 is %2. What goes by how a value was made asks here, so that
 * programs of all levels compute the same. */
#include "compiler/ir/fold.h"
#include "compiler/lower/footprint.h"

enum { OPERANDS = 16 };

/* The constant that a node is by its operands' constants; 0: it is none. */
static Ref fold(Lower *l, Ref ref)
{
    const IrNode node = *ir_at(l->ir, ref);
    Ref args[OPERANDS];
    double numbers[4];
    if (node.op == OP_const)
        return ref;
    if (node.count == 0 || node.count > OPERANDS)
        return 0;
    for (int i = 0; i < node.count; i++)
        if (!(args[i] = l->settled[ir_arg(l->ir, ref, i)]))
            return 0;
    if (!fold_node(l->ir, &node, args, numbers))
        return 0;
    return ir_const(l->ir, (Type)node.type, numbers);
}

/* Operands come before their users, so each node is looked at once. */
static Ref settled(Lower *l, Ref ref)
{
    if (l->cheap)
        return ir_is(l->ir, ref, OP_const) ? ref : 0;
    l->settled = arena_reach(l->session->arena, l->settled, ref, &l->settled_room, sizeof *l->settled);
    for (; l->settled_count <= ref; l->settled_count++)
        l->settled[l->settled_count] = l->settled_count ? fold(l, l->settled_count) : 0;
    return l->settled[ref];
}

Ref settled_operand(Lower *l, Ref ref)
{
    const bool is_select = ir_is(l->ir, ref, OP_select);
    if (!is_select && !ir_is(l->ir, ref, OP_mix))
        return 0;
    Ref by = settled(l, ir_arg(l->ir, ref, is_select ? 0 : 2));
    if (!by)
        return 0;
    if (is_select)
        return ir_arg(l->ir, ref, ir_numbers(l->ir, by)[0] != 0 ? 1 : 2);
    return ir_is_number(l->ir, by, 0) ? ir_arg(l->ir, ref, 0) : ir_is_number(l->ir, by, 1) ? ir_arg(l->ir, ref, 1) : 0;
}
