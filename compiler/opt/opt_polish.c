/* Applies all local rules together, since the result of one may be simplified by another. The
 * builder applies them to every new node, so lowering leaves little to do; the sweep repeats
 * them when uses are known. */
#include "compiler/opt/opt.h"

enum { MAX_REWRITES = 16 };

enum { FOLD, ALGEBRA, SWIZZLE, SELECT, POWER, RULE_COUNT };
static IrRewrite *const rules[RULE_COUNT] = {opt_rewrite_fold, opt_rewrite_algebra,
                                             opt_rewrite_swizzle, opt_rewrite_select,
                                             opt_rewrite_power};

/* Returns a bit for each rule that may change the node. */
static unsigned rules_for(const Ir *ir, Ref ref)
{
    return (unsigned)opt_may_fold(ir, ref) << FOLD | 1u << ALGEBRA |
           (unsigned)opt_may_swizzle(ir, ref) << SWIZZLE |
           (unsigned)opt_may_select(ir, ref) << SELECT | (unsigned)opt_may_power(ir, ref) << POWER;
}

/* Called when no rule applies to the node. Only swizzle and group rules depend on uses, so every
 * other node stays final. */
static void settle(Ir *ir, Ref ref)
{
    const bool by_uses = ir_is(ir, ref, OP_swizzle) || opt_may_group(ir, ref);
    ir->nodes[ref].flags |= by_uses ? NODE_simple : NODE_simple | NODE_final;
}

/* Applies the rules in turn until none changes the result. */
static Ref apply_rules(Ir *ir, Ref ref, const void *user)
{
    unsigned left = rules_for(ir, ref); /* rules still to be tried */
    int rule = 0;
    for (int run = 0; left && run < MAX_REWRITES * RULE_COUNT;
         run++, rule = rule + 1 < RULE_COUNT ? rule + 1 : 0) {
        if (!(left >> rule & 1))
            continue;
        const Ref better = rules[rule](ir, ref, user);
        left &= ~(1u << rule);
        if (better == ref)
            continue;
        if (ir_at(ir, better)->flags & NODE_final)
            return better;
        ref = better;
        left = rules_for(ir, ref);
    }
    if (!left)
        settle(ir, ref);
    return ref;
}

Ref opt_simplify(Ir *ir, Ref ref)
{
    static const Uses unknown = {0};
    return ir_at(ir, ref)->flags & NODE_final ? ref : apply_rules(ir, ref, &unknown);
}

/* First tries the rule that depends on uses, for a node that is simple but not final. */
static Ref polish(Ir *ir, Ref ref, const void *user)
{
    const Ref grouped = opt_may_group(ir, ref) ? opt_rewrite_group(ir, ref, user) : ref;
    if (grouped != ref)
        return grouped;
    const bool simple = ir_at(ir, ref)->flags & NODE_simple;
    return simple && opt_rewrite_swizzle(ir, ref, user) == ref ? ref : apply_rules(ir, ref, user);
}

bool opt_polish(Ir *ir)
{
    Uses uses = opt_uses(ir, &ir->scratch);
    Ref grouped = 0;
    uses.grouped = &grouped;
    return ir_sweep_unsettled(ir, NODE_final, polish, &uses);
}
