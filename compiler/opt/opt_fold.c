/* Constant folding in double precision; library functions by their C reference. */
#include "compiler/opt/opt.h"

Ref opt_rewrite_fold(Ir *ir, Ref ref, const void *user)
{
    (void)user;
    const IrNode *node = ir_at(ir, ref);
    double result[4];
    if (!fold_node(ir, node, &ir->args[node->first], result))
        return ref;
    return ir_const(ir, (Type)node->type, result);
}

bool opt_fold(Ir *ir) { return ir_sweep(ir, opt_rewrite_fold, NULL); }
