/* All local rules at once: what one of them makes, another may simplify further. The builder applies them to every node that
 * it makes, so that lowering leaves little behind; the sweep applies them again when more is known. */
#include "compiler/opt/opt.h"

enum { MOST_REWRITES = 16 };

static Ref polish(Ir *ir, Ref ref, const void *user)
{
    static IrRewrite *const rules[] = {opt_rewrite_fold, opt_rewrite_algebra, opt_rewrite_swizzle, opt_rewrite_select,
                                       opt_rewrite_power};
    enum { RULE_COUNT = sizeof rules / sizeof *rules };
    if (!ir_at(ir, ref)->count)
        return ref; /* a leaf is as simple as can be */
    for (int run = 0, idle = 0; idle < RULE_COUNT && run < MOST_REWRITES * RULE_COUNT; run++) {
        Ref better = rules[run % RULE_COUNT](ir, ref, user);
        idle = better == ref ? idle + 1 : 0;
        ref = better;
    }
    return ref;
}

Ref opt_simplify(Ir *ir, Ref ref)
{
    static const Uses unknown = {0};
    return polish(ir, ref, &unknown);
}

bool opt_polish(Ir *ir)
{
    Uses uses = {opt_uses(ir, &ir->scratch), (Ref)ir->count};
    return ir_sweep(ir, polish, &uses);
}
