/* Applies the algebraic rules of grammar/rules.def. */
#include "compiler/opt/opt.h"
#include "compiler/ir/build_words.h"
#include <math.h>

/* Canonical operand order: constants last; otherwise the newer node first, so that a long sum
 * grows to the left, as one writes it. */
static bool ordered_wrongly(const Ir *ir, Ref a, Ref b)
{
    bool a_number = ir_is(ir, a, OP_const), b_number = ir_is(ir, b, OP_const);
    return a_number == b_number ? a < b : a_number;
}

static bool power_of_two(double x)
{
    int exponent;
    return fabs(frexp(x, &exponent)) == 0.5 && exponent > -100 && exponent < 100;
}

static bool has_exact_inverse(const Ir *ir, Ref ref)
{
    if (!ir_is(ir, ref, OP_const))
        return false;
    for (int i = 0; i < ir_components(ir, ref); i++)
        if (!power_of_two(ir_numbers(ir, ref)[i]))
            return false;
    return true;
}

static Ref inverse_of(Ir *ir, Ref ref)
{
    double components[4] = {0};
    for (int i = 0; i < ir_components(ir, ref); i++)
        components[i] = 1 / ir_numbers(ir, ref)[i];
    return ir_const(ir, ir_type(ir, ref), components);
}

/* Returns the only nonzero component of a constant; -1: none, or several. */
static int only_component(const Ir *ir, Ref ref)
{
    int found = -1;
    if (!ir_is(ir, ref, OP_const))
        return -1;
    for (int i = 0; i < ir_components(ir, ref); i++)
        if (ir_numbers(ir, ref)[i] != 0) {
            if (found >= 0)
                return -1;
            found = i;
        }
    return found;
}

static bool repeats_one(const Ir *ir, Ref ref)
{
    if (!ir_is(ir, ref, OP_vec) || ir_at(ir, ref)->count != ir_components(ir, ref))
        return false;
    for (int i = 1; i < ir_components(ir, ref); i++)
        if (ir_arg(ir, ref, i) != ir_arg(ir, ref, 0))
            return false;
    return true;
}

static bool all_negative(const Ir *ir, Ref ref)
{
    if (!ir_is(ir, ref, OP_const))
        return false;
    for (int i = 0; i < ir_components(ir, ref); i++)
        if (ir_numbers(ir, ref)[i] >= 0)
            return false;
    return true;
}

#define zero(x)             ir_is_number(ir, x, 0)
#define one(x)              ir_is_number(ir, x, 1)
#define minus_one(x)        ir_is_number(ir, x, -1)
#define negative(x)         all_negative(ir, x)
#define same(x, y)          ((x) == (y))
#define is(x, op)           ir_is(ir, x, OP_##op)
#define is_bool(x)          (ir_type(ir, x) == TYPE_bool)
#define arg(x, i)           ir_arg(ir, x, i)
#define all(x)              build_all(ir, type, x)
#define spread(x)           build_splat(ir, x, type)
#define truth(x)            build_truth(ir, x)
#define component(x, i)     build_component(ir, x, i)
#define single_component(x) only_component(ir, x)
#define repeats(x)          repeats_one(ir, x)
#define is_mean(x)          ir_is_number(ir, x, 1.0 / ir_components(ir, x))
#define out_of_order(x, y)  ordered_wrongly(ir, x, y)
#define exact_inverse(x)    has_exact_inverse(ir, x)
#define inverse(x)          inverse_of(ir, x)

Ref opt_rewrite_algebra(Ir *ir, Ref ref, const void *user)
{
    (void)user;
    const IrNode *node = ir_at(ir, ref);
    const Type type = (Type)node->type;
    Ref a = node->count > 0 ? ir_arg(ir, ref, 0) : 0, b = node->count > 1 ? ir_arg(ir, ref, 1) : 0;
    Ref c = node->count > 2 ? ir_arg(ir, ref, 2) : 0;
    switch (node->op) {
#define ON(op) case OP_##op:
#define RULE(condition, result, why)                                                               \
    if (condition)                                                                                 \
        return result;
#define END break;
#include "grammar/rules.def"
    default:
        break;
    }
    return ref;
}

bool opt_algebra(Ir *ir) { return ir_sweep(ir, opt_rewrite_algebra, NULL); }
