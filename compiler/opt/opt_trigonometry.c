/* Trigonometric functions -> library functions with a bounded error, for --trigonometry=bounded. GLSL promises none of its own. */
#include "compiler/opt/opt.h"

static int bounded_function(Op op)
{
    switch (op) {
#define BOUNDED(name, function)                                                                                        \
    case OP_##name:                                                                                                    \
        return FN_##function;
#include "grammar/ops.def"
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
    return build_call_of(ir, function, args, node.count);
}

bool opt_trigonometry(Ir *ir) { return ir_sweep(ir, bound, NULL); }
