/* All local rules at once: what one of them makes, another may simplify further. The builder applies them to every node that
 * it makes, so that lowering leaves little behind; the sweep applies them again when more is known. */
#include "compiler/opt/opt.h"

enum { MOST_REWRITES = 16 };

static Ref apply_rules(Ir *ir, Ref ref, const void *user)
{
    static IrRewrite *const rules[] = {opt_rewrite_fold, opt_rewrite_algebra, opt_rewrite_swizzle, opt_rewrite_select,
                                       opt_rewrite_power};
    enum { RULE_COUNT = sizeof rules / sizeof *rules };
    int idle = 0;
    for (int run = 0; idle < RULE_COUNT && run < MOST_REWRITES * RULE_COUNT; run++) {
        Ref better = rules[run % RULE_COUNT](ir, ref, user);
        idle = better == ref ? idle + 1 : 0;
        ref = better;
    }
    ir->nodes[ref].simple = idle == RULE_COUNT;
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
    const bool simple = ir_at(ir, ref)->simple || !ir_at(ir, ref)->count;
    if (simple && (!ir_is(ir, ref, OP_swizzle) || opt_rewrite_swizzle(ir, ref, user) == ref))
        return ref;
    return apply_rules(ir, ref, user);
}

bool opt_polish(Ir *ir)
{
    const Uses uses = opt_uses(ir, &ir->scratch);
    return ir_sweep_live(ir, uses.live, polish, &uses);
}
