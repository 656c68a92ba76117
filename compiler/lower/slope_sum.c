/* Derivatives that are defined as weighted sums, before their first query: for values whose own
 * form should not be differentiated. */
#include "compiler/lower/slope.h"

struct LateSum {
    SlopeSum sum; /* terms are NULL until the first query */
    SlopeTerms *terms;
    const void *what;
};

const void *slope_set_sum(Lower *l, Ref value, SlopeTerms *terms, const void *what, int count)
{
    l->sums = arena_reach(l->session->arena, l->sums, value, &l->sum_capacity, sizeof *l->sums);
    if (l->sums[value])
        return l->sums[value]->what;
    l->sums[value] = ARENA_NEW(l->session->arena, struct LateSum);
    *l->sums[value] = (struct LateSum){{NULL, count}, terms, what};
    return NULL;
}

/* Returns the recorded sum of a value. The terms' nodes get the value's origin. */
const SlopeSum *slope_sum_of(Lower *l, Ref value)
{
    struct LateSum *late = value < l->sum_capacity ? l->sums[value] : NULL;
    if (late && !late->sum.terms) {
        const uint32_t origin = l->ir->origin;
        l->ir->origin = ir_at(l->ir, value)->origin;
        late->sum.terms = late->terms(l, late->what);
        l->ir->origin = origin;
    }
    return late ? &late->sum : NULL;
}
