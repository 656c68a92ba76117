/* pow with an integer exponent -> products by repeated squaring: cheaper and more accurate than
 * pow (numerics.md 6.2). x^5 = x^4 x: two squares and a product. */
#include "compiler/opt/opt.h"
#include <math.h>

enum { LARGEST_EXPONENT = 64 };

/* 13 is 1101 in binary: x^13 = x x^4 x^8, three squares and two products. */
static Ref power(Ir *ir, Ref x, int n)
{
    Ref result = 0;
    for (; n; n >>= 1, x = n ? build_square(ir, x) : x)
        if (n & 1)
            result = result ? build_mul(ir, result, x) : x;
    return result;
}

/* (x^a)^b -> x^(a b), for compensated powers, and for pow, whose base is not negative. */
static Ref composed(Ir *ir, Ref ref)
{
    Ref inner = ir_arg(ir, ref, 0), b = ir_arg(ir, ref, 1);
    if (ir_is(ir, inner, OP_abs))
        inner = ir_arg(ir, inner, 0); /* a power of an absolute value */
    const IrNode outer = *ir_at(ir, ref), node = *ir_at(ir, inner);
    if (node.op != outer.op || (node.op == OP_call && node.payload != outer.payload) ||
        !ir_is(ir, b, OP_const))
        return ref;
    Ref a = ir_arg(ir, inner, 1);
    if (!ir_is(ir, a, OP_const) || ir_components(ir, a) > 1 || ir_components(ir, b) > 1)
        return ref;
    double product = ir_numbers(ir, a)[0] * ir_numbers(ir, b)[0];
    if (!(product >= 1 && product <= LARGEST_EXPONENT))
        return ref;
    Ref exponent = node.op == OP_call ? build_int(ir, product) : build_float(ir, product);
    return ir_make(ir, node, REFS(ir, ir_arg(ir, inner, 0), exponent));
}

Ref opt_rewrite_power(Ir *ir, Ref ref, const void *user)
{
    (void)user;
    if (ir_is(ir, ref, OP_call) && ir_at(ir, ref)->payload == FN_powerCompensated)
        return composed(ir, ref);
    if (ir->keep_pow && ir_is(ir, ref, OP_pow))
        return composed(ir, ref);
    if (!ir_is(ir, ref, OP_pow) || !ir_is(ir, ir_arg(ir, ref, 1), OP_const) ||
        ir_components(ir, ir_arg(ir, ref, 1)) > 1)
        return ref;
    Ref x = ir_arg(ir, ref, 0), one = build_float(ir, 1);
    double n = ir_numbers(ir, ir_arg(ir, ref, 1))[0];
    if (n == 0.5)
        return build_sqrt(ir, x);
    if (n == 0 && ir_components(ir, x) == 1)
        return one;
    if (n != trunc(n) || n == 0 || fabs(n) > LARGEST_EXPONENT)
        return ref;
    Ref product = power(ir, x, (int)fabs(n));
    return n > 0 ? product : build_div(ir, one, product);
}

bool opt_power(Ir *ir) { return ir_sweep(ir, opt_rewrite_power, NULL); }
