/* Trigonometric functions -> library functions with a bounded error, for --trigonometry=bounded.
 * GLSL gives no error bounds for its own. */
#include "compiler/opt/opt.h"

static int bounded_function(Op op)
{
    switch (op) {
#define BOUNDED(name, function)                                                                    \
    case OP_##name:                                                                                \
        return FN_##function;
#include "grammar/ops.def"
    default:
        return -1;
    }
}

/* The functions are scalar: vectors are processed per component, and a scalar operand is used
 * for each component. */
static Ref bound(Ir *ir, Ref ref, const void *user)
{
    (void)user;
    const IrNode node = *ir_at(ir, ref);
    int function = bounded_function((Op)node.op);
    const int lanes = type_table[node.type].lanes;
    Ref lane[4];
    if (function < 0)
        return ref;
    for (int k = 0; k < lanes; k++) {
        Ref args[2];
        for (int i = 0; i < node.count; i++)
            args[i] = ir_lanes(ir, ir_arg(ir, ref, i)) == 1 ? ir_arg(ir, ref, i)
                                                            : build_lane(ir, ir_arg(ir, ref, i), k);
        lane[k] = build_call_of(ir, function, args, node.count);
    }
    return lanes == 1 ? lane[0] : build_vec_of(ir, (Type)node.type, lane, lanes);
}

bool opt_trigonometry(Ir *ir) { return ir_sweep(ir, bound, NULL); }
