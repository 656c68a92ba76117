/* The optimiser: each pass is one file and one function that says whether it changed anything. */
#ifndef MATC_OPT_H
#define MATC_OPT_H
#include "compiler/ir/build.h"

/* All passes until none changes anything. False: the IR is broken after a pass (a fault of matc;
 * reported). */
bool opt_run(Session *session, Ir *ir);

bool opt_fold(Ir *ir);    /* constant operands -> constant */
bool opt_algebra(Ir *ir); /* grammar/rules.def */
bool opt_swizzle(Ir *ir); /* lanes of lanes, lanes of vectors; narrow early */
bool opt_select(Ir *ir);  /* decided conditions, equal arms, work on constant arms */
bool opt_power(Ir *ir);   /* whole exponents -> products */
bool opt_range(Ir *ir);   /* bounds that cannot be reached, comparisons that are decided */
/* functions that do not use their arguments, or not all; unread lanes of results */
bool opt_function(Ir *ir);
bool opt_merge(Ir *ir);        /* a value whose gradient is computed anyhow -> a lane of that */
bool opt_centre(Ir *ir);       /* half a texel that is taken and added -> neither */
bool opt_group(Ir *ir);        /* constants of a sum, or of a product, together */
bool opt_trigonometry(Ir *ir); /* sines and arcs -> functions of a bounded error */
/* guards that spare nothing -> the value; the others are selects from then on */
bool opt_guard(Ir *ir);
bool opt_polish(Ir *ir); /* the local rules together, with what is known of uses */
/* The local rules of fold, algebra, swizzle, select and power, until none applies: for nodes as
 * they are made. */
Ref opt_simplify(Ir *ir, Ref ref);
bool opt_dead(Ir *ir); /* drops what the outputs do not reach */

/* The local rules: what stands for a node, or the node itself. `user` of swizzle and group is a
 * Uses. */
Ref opt_rewrite_fold(Ir *ir, Ref ref, const void *user);
Ref opt_rewrite_algebra(Ir *ir, Ref ref, const void *user);
Ref opt_rewrite_swizzle(Ir *ir, Ref ref, const void *user);
Ref opt_rewrite_select(Ir *ir, Ref ref, const void *user);
Ref opt_rewrite_power(Ir *ir, Ref ref, const void *user);
Ref opt_rewrite_group(Ir *ir, Ref ref, const void *user);
/* Which nodes they may change, as far as a glance tells: most nodes most rules have nothing to say
 * of. */
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
    Ref count; /* of nodes when the uses were counted */
    /* the last that opt_group made since, which one node uses, as what it stands for; NULL: nobody
     * asks */
    Ref *grouped;
} Uses;
/* How often each node is used by live nodes, outputs and functions; from then on ir_live_kept knows
 * which are live. */
Uses opt_uses(Ir *ir, Arena *arena);
#endif
