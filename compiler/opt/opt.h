/* The optimizer: each pass is a file with a function that returns whether it changed anything. */
#ifndef MATC_OPT_H
#define MATC_OPT_H
#include "compiler/ir/build.h"

/* Runs all passes until none changes anything. Returns false after reporting that a pass broke
 * the IR, a bug of matc. */
bool opt_run(Session *session, Ir *ir);

bool opt_fold(Ir *ir);    /* folds constants */
bool opt_algebra(Ir *ir); /* applies the rules of grammar/rules.def */
bool opt_swizzle(Ir *ir); /* combines swizzles of swizzles and vectors; narrows operations early */
/* simplifies selects: known conditions, equal arms, operations on constant arms */
bool opt_select(Ir *ir);
bool opt_power(Ir *ir); /* replaces powers with integer exponents by products */
bool opt_range(Ir *ir); /* drops clamps without effect, and comparisons with a known result */
/* Unused arguments of functions, functions without arguments, and unread components of results. */
bool opt_function(Ir *ir);
/* replaces a value whose gradient is also computed by the gradient's fourth component */
bool opt_merge(Ir *ir);
bool opt_centre(Ir *ir); /* cancels half a texel that is subtracted and added again */
bool opt_group(Ir *ir);  /* combines the constants of a sum or of a product */
/* replaces trigonometric functions by functions with bounded error */
bool opt_trigonometry(Ir *ir);
/* Replaces guards that save nothing by their values; other guards become selects. */
bool opt_guard(Ir *ir);
bool opt_polish(Ir *ir); /* applies all local rules together, with the use counts of nodes */
/* Applies the local rules of fold, algebra, swizzle, select and power to a new node, until none
 * applies. */
Ref opt_simplify(Ir *ir, Ref ref);
bool opt_dead(Ir *ir); /* eliminates dead code */

/* The local rules: return the replacement of a node, or the node itself. `user` of swizzle and
 * group is a Uses. */
Ref opt_rewrite_fold(Ir *ir, Ref ref, const void *user);
Ref opt_rewrite_algebra(Ir *ir, Ref ref, const void *user);
Ref opt_rewrite_swizzle(Ir *ir, Ref ref, const void *user);
Ref opt_rewrite_select(Ir *ir, Ref ref, const void *user);
Ref opt_rewrite_power(Ir *ir, Ref ref, const void *user);
Ref opt_rewrite_group(Ir *ir, Ref ref, const void *user);
/* Cheap tests whether a rule may change a node; most rules do not apply to most nodes. */
static inline bool opt_may_fold(const Ir *ir, Ref ref)
{
    return ir_at(ir, ref)->count && ir_is(ir, ir_arg(ir, ref, 0), OP_const);
}
static inline bool opt_may_swizzle(const Ir *ir, Ref ref)
{
    return ir_is(ir, ref, OP_swizzle) || ir_is(ir, ref, OP_vec);
}
static inline bool opt_may_select(const Ir *ir, Ref ref)
{
    return ir_is(ir, ref, OP_select) || opt_may_fold(ir, ref) ||
           (ir_at(ir, ref)->count && ir_is(ir, ir_arg(ir, ref, 0), OP_select));
}
static inline bool opt_may_power(const Ir *ir, Ref ref)
{
    return ir_is(ir, ref, OP_pow) || ir_is(ir, ref, OP_call);
}
static inline bool opt_is_term(const Ir *ir, Ref ref)
{
    const Op op = (Op)ir_at(ir, ref)->op;
    return (op == OP_add || op == OP_sub || op == OP_mul || op == OP_div) &&
           (ir_is(ir, ir_arg(ir, ref, 1), OP_const) || ir_is(ir, ir_arg(ir, ref, 0), OP_const));
}
static inline bool opt_may_group(const Ir *ir, Ref ref)
{
    return opt_is_term(ir, ref) &&
           (opt_is_term(ir, ir_arg(ir, ref, 0)) || opt_is_term(ir, ir_arg(ir, ref, 1)));
}

typedef struct {
    const uint32_t *uses;
    Ref count; /* number of nodes when the uses were counted */
    /* The newest node that opt_group created, which has a single user like the node that it
     * replaced. NULL: not tracked. */
    Ref *grouped;
} Uses;
/* Counts the uses of each node by live nodes, outputs and functions, and updates ir_live_kept(). */
Uses opt_uses(Ir *ir, Arena *arena);
#endif
