/* Combines the constants of a sum or of a product, which saves a rounding and an operation.
 *
 *     (x + 0.45) - 0.5         x + -0.05, which is x - 0.05
 *     0.5 - (0.25 - x)         x + 0.25
 *     x * 20 * 4 * 0.04        x * 3.2
 *     (x * 6) / 0.1            x * 60
 *
 * An inner value with other users is not regrouped: it would still be computed, and values that
 * were equal before might differ. */
#include "compiler/opt/opt.h"
#include <float.h>
#include <math.h>

/* Limits of constants to combine: neither sums nor products of a few constants within them leave
 * a float's range. */
#define LARGEST_GROUPED  1e15
#define SMALLEST_GROUPED 1e-15

typedef struct {
    Ref x, constant;
    /* sum: constant - x, otherwise x + constant; product: constant / x, otherwise x * constant */
    bool inverted;
    bool opposite; /* sum: x - constant, product: x / constant */
} Term;

static bool is_float(Type type)
{
    return type == TYPE_float || type == TYPE_vec2 || type == TYPE_vec3 || type == TYPE_vec4;
}

static bool is_moderate(const Ir *ir, Ref ref, double least)
{
    if (!ir_is(ir, ref, OP_const))
        return false;
    for (int i = 0; i < ir_components(ir, ref); i++)
        if (!(fabs(ir_numbers(ir, ref)[i]) >= least &&
              fabs(ir_numbers(ir, ref)[i]) <= LARGEST_GROUPED))
            return false;
    return true;
}

/* Matches a node of `straight` or `opposite` with one constant: add and sub for a sum, mul and
 * div for a product. */
static bool find_term(const Ir *ir, Ref ref, Op straight, Op opposite, Term *term)
{
    if (!ir_is(ir, ref, straight) && !ir_is(ir, ref, opposite))
        return false;
    const double least = straight == OP_mul ? SMALLEST_GROUPED : 0;
    const Ref a = ir_arg(ir, ref, 0), b = ir_arg(ir, ref, 1);
    term->inverted = ir_is(ir, a, OP_const);
    term->opposite = ir_is(ir, ref, opposite) && !term->inverted;
    term->x = term->inverted ? b : a;
    term->constant = term->inverted ? a : b;
    if (term->inverted && ir_is(ir, ref, straight)) /* keeps the order of operands at -O0 */
        term->inverted = false;
    return is_moderate(ir, term->constant, least) && !ir_is(ir, term->x, OP_const);
}

/* Returns exactly 0 if two constants cancel up to rounding. */
static Ref without_rounding(Ir *ir, Ref sum, Ref a, Ref b)
{
    double components[4] = {0};
    bool cancels = false;
    if (!ir_is(ir, sum, OP_const))
        return sum;
    for (int i = 0; i < ir_components(ir, sum); i++) {
        const double of_a = ir_numbers(ir, a)[ir_components(ir, a) > 1 ? i : 0],
                     of_b = ir_numbers(ir, b)[ir_components(ir, b) > 1 ? i : 0];
        const bool nothing =
            fabs(ir_numbers(ir, sum)[i]) <= 2 * DBL_EPSILON * (fabs(of_a) + fabs(of_b));
        components[i] = nothing ? 0 : ir_numbers(ir, sum)[i];
        cancels |= components[i] != ir_numbers(ir, sum)[i];
    }
    return cancels ? ir_const(ir, ir_type(ir, sum), components) : sum;
}

/* Combines outer(inner(x)) to one sum: the signs of x and of the constants multiply. */
static Ref sum_of(Ir *ir, const Term *outer, const Term *inner)
{
    const bool minus_x = outer->inverted != inner->inverted,
               minus_inner = inner->opposite != outer->inverted;
    const Ref a = outer->constant, b = inner->constant;
    Ref sum; /* sum of the constants */
    if (outer->opposite)
        sum = minus_inner ? build_neg(ir, build_add(ir, a, b)) : build_sub(ir, b, a);
    else
        sum = minus_inner ? build_sub(ir, a, b) : build_add(ir, a, b);
    sum = without_rounding(ir, sum, a, b);
    return minus_x ? build_sub(ir, sum, inner->x) : build_add(ir, inner->x, sum);
}

/* Combines outer(inner(x)) to one product. None of the four forms that divide by x is combined. */
static Ref product_of(Ir *ir, const Term *outer, const Term *inner)
{
    const Ref a = outer->constant, b = inner->constant;
    if (outer->opposite && inner->opposite)
        return build_div(ir, inner->x, build_mul(ir, a, b));
    if (outer->opposite)
        return build_mul(ir, inner->x, build_div(ir, b, a));
    return build_mul(ir, inner->x, inner->opposite ? build_div(ir, a, b) : build_mul(ir, a, b));
}

static bool is_used_once(const Uses *uses, Ref ref)
{
    return ref < uses->count ? uses->uses[ref] == 1 : uses->grouped && *uses->grouped == ref;
}

Ref opt_rewrite_group(Ir *ir, Ref ref, const void *user)
{
    const Uses *uses = user;
    const bool sum = ir_is(ir, ref, OP_add) || ir_is(ir, ref, OP_sub);
    const Op straight = sum ? OP_add : OP_mul, opposite = sum ? OP_sub : OP_div;
    Term outer, inner;
    if (!is_float(ir_type(ir, ref)) || !find_term(ir, ref, straight, opposite, &outer) ||
        !is_used_once(uses, outer.x) || !find_term(ir, outer.x, straight, opposite, &inner))
        return ref;
    if (!sum && (outer.inverted || inner.inverted))
        return ref;
    const Ref grouped = sum ? sum_of(ir, &outer, &inner) : product_of(ir, &outer, &inner);
    if (uses->grouped && grouped >= uses->count)
        *uses->grouped = grouped;
    return grouped;
}

bool opt_group(Ir *ir)
{
    Uses uses = opt_uses(ir, &ir->scratch);
    Ref grouped = 0;
    uses.grouped = &grouped;
    return ir_sweep(ir, opt_rewrite_group, &uses);
}
