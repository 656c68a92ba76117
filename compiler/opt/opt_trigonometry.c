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
    const int components = type_table[node.type].components;
    Ref component[4];
    if (function < 0)
        return ref;
    for (int k = 0; k < components; k++) {
        Ref args[2];
        for (int i = 0; i < node.count; i++)
            args[i] = ir_components(ir, ir_arg(ir, ref, i)) == 1
                          ? ir_arg(ir, ref, i)
                          : build_component(ir, ir_arg(ir, ref, i), k);
        component[k] = build_call_of(ir, function, args, node.count);
    }
    return components == 1 ? component[0]
                           : build_vec_of(ir, (Type)node.type, component, components);
}

bool opt_trigonometry(Ir *ir) { return ir_sweep(ir, bound, NULL); }
