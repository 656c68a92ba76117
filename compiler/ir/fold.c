/* Constant folding: the value of an operation on constants, in double precision. Operations use
 * the FOLD lines of ops.def, library functions their C references. Used by the constant folder
 * and ir_eval. */
#include "compiler/ir/fold.h"
#include "compiler/library/references.h"
#include <math.h>
#include <string.h>

enum { MAX_CALL_NUMBERS = 64 };

static double component_value(Op op, double a, double b, double c)
{
    (void)b, (void)c;
    switch (op) {
#define FOLD(name, value)                                                                          \
    case OP_##name:                                                                                \
        return value;
#include "grammar/ops.def"
    default:
        return 0;
    }
}

static double component_of(const FoldArg *arg, int component)
{
    return arg->numbers[type_table[arg->type].components > 1 ? component : 0];
}

/* Folds an operation that works per component. Returns false for a comparison of vectors, which
 * GLSL writes with other functions. */
static bool fold_components(const IrNode *node, const FoldArg *args, double *result)
{
    static const FoldArg none = {TYPE_float, {0}};
    const FoldArg *b = node->count > 1 ? &args[1] : &none, *c = node->count > 2 ? &args[2] : &none;
    const bool compares = op_table[node->op].rule == RULE_boolean;
    int components = type_table[compares ? args[0].type : (Type)node->type].components;
    if (compares && components > 1)
        return false;
    for (int i = 0; i < components; i++)
        result[i] = component_value((Op)node->op, component_of(&args[0], i), component_of(b, i),
                                    component_of(c, i));
    return true;
}

/* A node that does not work per component, as passed to the FOLD_NODE functions of ops.def. */
typedef struct {
    const ReferenceContext *context;
    const IrNode *node;
    const FoldArg *args;
} Site;

static void fold_call(const Site *s, double *result)
{
    double numbers[MAX_CALL_NUMBERS];
    int used = 0;
    for (int i = 0; i < s->node->count; i++)
        for (int component = 0; component < type_table[s->args[i].type].components; component++)
            numbers[used++] = s->args[i].numbers[component];
    reference_of((int)s->node->payload)(s->context, numbers, result);
}

static void fold_vec(const Site *s, double *result)
{
    for (int i = 0; i < s->node->count; i++)
        for (int component = 0; component < type_table[s->args[i].type].components; component++)
            *result++ = s->args[i].numbers[component];
}

static void fold_swizzle(const Site *s, double *result)
{
    for (int i = 0; i < type_table[s->node->type].components; i++)
        result[i] = s->args[0].numbers[s->node->payload >> 2 * i & 3];
}

static void fold_select(const Site *s, double *result)
{
    memcpy(result, s->args[s->args[0].numbers[0] != 0 ? 1 : 2].numbers, sizeof s->args[1].numbers);
}

static double sum_of_products(const FoldArg *a, const FoldArg *b)
{
    double sum = 0;
    for (int i = 0; i < type_table[a->type].components; i++)
        sum += a->numbers[i] * b->numbers[i];
    return sum;
}

static void fold_dot(const Site *s, double *result)
{
    result[0] = sum_of_products(&s->args[0], &s->args[1]);
}

static void fold_length(const Site *s, double *result)
{
    result[0] = sqrt(sum_of_products(&s->args[0], &s->args[0]));
}

static void fold_cross(const Site *s, double *result)
{
    const double *a = s->args[0].numbers, *b = s->args[1].numbers;
    for (int i = 0; i < 3; i++)
        result[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static void fold_linear(const Site *s, double *result)
{
    for (int i = 0; i < type_table[s->node->type].components; i++) {
        result[i] = 0;
        for (int k = 1; k < s->node->count; k++)
            result[i] += s->args[k].numbers[i] * s->args[0].numbers[k - 1];
    }
}

bool fold_value(const ReferenceContext *context, const IrNode *node, const FoldArg *args,
                double *result)
{
    const Site site = {context, node, args};
    switch (node->op) {
#define FOLD(name, value)                                                                          \
    case OP_##name:                                                                                \
        return fold_components(node, args, result);
#define FOLD_NODE(name, function)                                                                  \
    case OP_##name:                                                                                \
        function(&site, result);                                                                   \
        return true;
#include "grammar/ops.def"
    default:
        return false;
    }
}

bool fold_component(Op op, const double *args, double *result)
{
    *result = component_value(op, args[0], args[1], args[2]);
    return isfinite(*result);
}

bool fold_node(const Ir *ir, const IrNode *node, const Ref *args, double *result)
{
    FoldArg values[FOLD_OPERANDS];
    if (node->count < 1 || node->count > FOLD_OPERANDS)
        return false;
    for (int i = 0; i < node->count; i++)
        if (!ir_is(ir, args[i], OP_const))
            return false;
    for (int i = 0; i < node->count; i++) {
        values[i].type = ir_type(ir, args[i]);
        memcpy(values[i].numbers, ir_numbers(ir, args[i]),
               sizeof(double) * (size_t)ir_components(ir, args[i]));
    }
    ReferenceContext context = {.noise = ir->noise};
    if (!fold_value(&context, node, values, result))
        return false;
    for (int i = 0; i < type_table[node->type].components; i++)
        if (!isfinite(result[i]))
            return false; /* leaves the result to the shader */
    return true;
}
