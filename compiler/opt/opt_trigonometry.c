/* Trigonometric functions -> library functions with a bounded error, for --trigonometry=bounded. GLSL promises none of its own. */
#include "compiler/opt/opt.h"

static int bounded_function(Op op)
{
    switch (op) {
    case OP_sin:
        return FN_sineBounded;
    case OP_cos:
        return FN_cosineBounded;
    case OP_tan:
        return FN_tangentBounded;
    case OP_asin:
        return FN_arcsineBounded;
    case OP_acos:
        return FN_arccosineBounded;
    case OP_atan:
        return FN_arctangentBounded;
    case OP_atan2:
        return FN_angleBounded;
    default:
        return -1;
    }
}

static Ref bound(Ir *ir, Ref ref, const void *user)
{
    (void)user;
    const IrNode node = *ir_at(ir, ref);
    int function = bounded_function((Op)node.op);
    if (function < 0 || node.type != TYPE_float)
        return ref;
    Ref args[2];
    for (int i = 0; i < node.count; i++)
        args[i] = ir_arg(ir, ref, i);
    return ir_call(ir, function, args, node.count);
}

bool opt_trigonometry(Ir *ir) { return opt_sweep(ir, bound, NULL); }
