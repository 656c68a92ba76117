/* All local rules at once: what one of them makes, another may simplify further. The builder applies them to every node that
 * it makes, so that lowering leaves little behind; the sweep applies them again when more is known. */
#include "compiler/opt/opt.h"

enum { MOST_REWRITES = 16 };

enum { FOLD, ALGEBRA, SWIZZLE, SELECT, POWER, RULE_COUNT };
static IrRewrite *const rules[RULE_COUNT] = {opt_rewrite_fold, opt_rewrite_algebra, opt_rewrite_swizzle,
                                             opt_rewrite_select, opt_rewrite_power};

/* A bit for each rule that may change the node. */
static unsigned rules_for(const Ir *ir, Ref ref)
{
    return (unsigned)opt_may_fold(ir, ref) << FOLD | 1u << ALGEBRA | (unsigned)opt_may_swizzle(ir, ref) << SWIZZLE |
           (unsigned)opt_may_select(ir, ref) << SELECT | (unsigned)opt_may_power(ir, ref) << POWER;
}

/* Whatever is known of uses, no rule changes it, but for a swizzle, which goes by them. */
static bool is_simple(const Ir *ir, Ref ref) { return ir_at(ir, ref)->simple || !ir_at(ir, ref)->count; }

/* In turns, until none of them changes what the others left. */
static Ref apply_rules(Ir *ir, Ref ref, const void *user)
{
    unsigned left = rules_for(ir, ref); /* to be asked of the node */
    for (int run = 0; left && run < MOST_REWRITES * RULE_COUNT; run++) {
        const int rule = run % RULE_COUNT;
        const Ref better = left >> rule & 1 ? rules[rule](ir, ref, user) : ref;
        left &= ~(1u << rule);
        if (better == ref)
            continue;
        if (is_simple(ir, better) && !ir_is(ir, better, OP_swizzle))
            return better;
        ref = better;
        left = rules_for(ir, ref);
    }
    ir->nodes[ref].simple = !left;
    return ref;
}

Ref opt_simplify(Ir *ir, Ref ref)
{
    static const Uses unknown = {0};
    return ir_at(ir, ref)->count ? apply_rules(ir, ref, &unknown) : ref; /* a leaf is as simple as can be */
}

/* Uses are told to rules of swizzles alone: any other node is as simple as when it was made. */
static Ref polish(Ir *ir, Ref ref, const void *user)
{
    if (is_simple(ir, ref) && (!ir_is(ir, ref, OP_swizzle) || opt_rewrite_swizzle(ir, ref, user) == ref))
        return ref;
    return apply_rules(ir, ref, user);
}

bool opt_polish(Ir *ir)
{
    const Uses uses = opt_uses(ir, &ir->scratch);
    return ir_sweep_live(ir, uses.live, polish, &uses);
}
