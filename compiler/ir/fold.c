/* The value of an operation on constants, in double precision: from the `fold` column of ops.def for what works lane by
 * lane, from the C references for library functions. Serves the constant folder and ir_eval. */
#include "compiler/ir/fold.h"
#include "runtime/library/references.h"
#include <math.h>
#include <string.h>

enum { MOST_CALL_NUMBERS = 64 };

static double lane_value(Op op, double a, double b, double c)
{
    (void)b, (void)c;
    switch (op) {
#define OP(name, shape, glsl, arity, rule, cost, fold, slope, doc)                                                     \
    case OP_##name:                                                                                                    \
        return fold;
#include "grammar/ops.def"
    default:
        return 0;
    }
}

static double lane_of(const FoldArg *arg, int lane) { return arg->numbers[type_table[arg->type].lanes > 1 ? lane : 0]; }

static bool fold_call(const ReferenceContext *context, int function, const FoldArg *args, int count, double *result)
{
    double numbers[MOST_CALL_NUMBERS];
    int used = 0;
    for (int i = 0; i < count; i++)
        for (int lane = 0; lane < type_table[args[i].type].lanes; lane++)
            numbers[used++] = args[i].numbers[lane];
    reference_of(function)(context, numbers, result);
    return true;
}

static void fold_vec(const FoldArg *args, int count, double *result)
{
    for (int i = 0; i < count; i++)
        for (int lane = 0; lane < type_table[args[i].type].lanes; lane++)
            *result++ = args[i].numbers[lane];
}

static double sum_of_products(const double *a, const double *b, int lanes)
{
    double sum = 0;
    for (int i = 0; i < lanes; i++)
        sum += a[i] * b[i];
    return sum;
}

static bool fold_lanes(Op op, Type type, const FoldArg *args, int count, double *result)
{
    static const FoldArg none = {TYPE_float, {0}};
    const FoldArg *b = count > 1 ? &args[1] : &none, *c = count > 2 ? &args[2] : &none;
    int lanes = type_table[op_table[op].rule == RULE_boolean ? args[0].type : type].lanes;
    if (op_table[op].rule == RULE_boolean && lanes > 1)
        return false;
    for (int i = 0; i < lanes; i++)
        result[i] = lane_value(op, lane_of(&args[0], i), lane_of(b, i), lane_of(c, i));
    return true;
}

bool fold_value(const ReferenceContext *context, Op op, Type type, uint32_t payload, const FoldArg *args, int count,
                double *result)
{
    const double *a = args[0].numbers, *b = args[1].numbers;
    switch (op) {
    case OP_vec:
        fold_vec(args, count, result);
        return true;
    case OP_swizzle:
        for (int i = 0; i < type_table[type].lanes; i++)
            result[i] = a[payload >> 2 * i & 3];
        return true;
    case OP_select:
        memcpy(result, args[a[0] != 0 ? 1 : 2].numbers, sizeof args[1].numbers);
        return true;
    case OP_dot:
        result[0] = sum_of_products(a, b, type_table[args[0].type].lanes);
        return true;
    case OP_length:
        result[0] = sqrt(sum_of_products(a, a, type_table[args[0].type].lanes));
        return true;
    case OP_cross:
        for (int i = 0; i < 3; i++)
            result[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
        return true;
    case OP_linear:
        for (int i = 0; i < type_table[type].lanes; i++) {
            result[i] = 0;
            for (int k = 1; k < count; k++)
                result[i] += args[k].numbers[i] * a[k - 1];
        }
        return true;
    case OP_call:
        return fold_call(context, (int)payload, args, count, result);
    case OP_apply:
    case OP_kernel:
    case OP_const:
    case OP_input:
    case OP_uniform:
    case OP_constant:
    case OP_argument:
    case OP_texture:
        return false;
    default:
        return fold_lanes(op, type, args, count, result);
    }
}

bool fold_lane(Op op, const double *args, double *result)
{
    *result = lane_value(op, args[0], args[1], args[2]);
    return isfinite(*result);
}

bool fold_node(const Ir *ir, Op op, Type type, uint32_t payload, const Ref *args, int count, double *result)
{
    FoldArg values[FOLD_OPERANDS];
    if (count < 1 || count > FOLD_OPERANDS)
        return false;
    for (int i = 0; i < count; i++)
        if (!ir_is(ir, args[i], OP_const))
            return false;
    for (int i = 0; i < count; i++) {
        values[i].type = ir_type(ir, args[i]);
        memcpy(values[i].numbers, ir_numbers(ir, args[i]), sizeof(double) * (size_t)ir_lanes(ir, args[i]));
    }
    ReferenceContext context = {.noise = ir->noise};
    if (!fold_value(&context, op, type, payload, values, count, result))
        return false;
    for (int i = 0; i < type_table[type].lanes; i++)
        if (!isfinite(result[i]))
            return false; /* the shader decides what it makes of it */
    return true;
}
