/* Checks the invariants of the IR after lowering and after every pass. */
#include "compiler/ir/ir.h"
#include <math.h>
#include <string.h>

static const char *check_arity(const IrNode *node)
{
    int arity = op_table[node->op].arity;
    return arity >= 0 && arity != node->count ? "a node has the wrong number of operands" : NULL;
}

static const char *check_call(const Ir *ir, Ref ref)
{
    static const char letters[] = "?if234s";
    static const Type types[] = {TYPE_bool, TYPE_int,  TYPE_float,  TYPE_vec2,
                                 TYPE_vec3, TYPE_vec4, TYPE_sampler};
    const IrNode *node = ir_at(ir, ref);
    const char *arguments = function_arguments((int)node->payload);
    if (strlen(arguments) != node->count)
        return "a call has the wrong number of arguments";
    for (int i = 0; i < node->count; i++)
        if (ir_type(ir, ir_arg(ir, ref, i)) != types[strchr(letters, arguments[i]) - letters])
            return "a call's argument has the wrong type";
    return node->type == function_row((int)node->payload)->result ? NULL
                                                                  : "a call has the wrong type";
}

static const char *check_application(const Ir *ir, Ref ref)
{
    const IrFunction *function = &ir->functions[ir_at(ir, ref)->payload];
    if (function->result >= ref)
        return "a function's result comes after its call";
    for (int i = 0; i < function->count; i++)
        if (ir_type(ir, ir_arg(ir, ref, i)) != ir_type(ir, function->arguments[i]))
            return "an application's argument has the wrong type";
    return ir_type(ir, ref) == ir_type(ir, function->result) ? NULL
                                                             : "an application has the wrong type";
}

static const char *check_apply(const Ir *ir, Ref ref)
{
    const IrNode *node = ir_at(ir, ref);
    if (node->payload >= ir->function_count || ir->functions[node->payload].count != node->count)
        return "an application does not fit its function";
    return check_application(ir, ref);
}

static const char *check_kernel(const Ir *ir, Ref ref)
{
    const IrNode *node = ir_at(ir, ref);
    if (node->payload >= ir->function_count ||
        ir->functions[node->payload].count + 1 != node->count ||
        ir_type(ir, ir_arg(ir, ref, node->count - 1)) != TYPE_vec3)
        return "a kernel does not fit its function";
    return check_application(ir, ref);
}

static const char *check_widest(const Ir *ir, Ref ref)
{
    int widest = 1;
    for (int i = 0; i < ir_at(ir, ref)->count; i++) {
        Type type = ir_type(ir, ir_arg(ir, ref, i));
        if (type < TYPE_float || type > TYPE_vec4)
            return "an operand of arithmetic is not a number";
        widest = type_table[type].components > widest ? type_table[type].components : widest;
    }
    for (int i = 0; i < ir_at(ir, ref)->count; i++)
        if (ir_components(ir, ir_arg(ir, ref, i)) != 1 &&
            ir_components(ir, ir_arg(ir, ref, i)) != widest)
            return "operands of arithmetic have different widths";
    return ir_components(ir, ref) == widest ? NULL
                                            : "the width of a result differs from its operands";
}

static const char *check_boolean(const Ir *ir, Ref ref)
{
    const IrNode *node = ir_at(ir, ref);
    bool logic = node->op == OP_and || node->op == OP_or || node->op == OP_not;
    for (int i = 0; i < node->count; i++) {
        Ref arg = ir_arg(ir, ref, i);
        if (ir_components(ir, arg) != 1 || (logic && ir_type(ir, arg) != TYPE_bool) ||
            ir_type(ir, arg) != ir_type(ir, ir_arg(ir, ref, 0)))
            return "operands of a comparison do not fit";
    }
    return node->type == TYPE_bool ? NULL : "a comparison is not a truth value";
}

static const char *check_const(const Ir *ir, Ref ref)
{
    for (int i = 0; i < ir_components(ir, ref); i++)
        if (!isfinite(ir_numbers(ir, ref)[i]))
            return "a constant is not finite";
    return NULL;
}

static const char *check_select(const Ir *ir, Ref ref)
{
    const Type type = ir_type(ir, ref);
    if (ir_type(ir, ir_arg(ir, ref, 0)) != TYPE_bool)
        return "a select's condition is not a truth value";
    if (ir_type(ir, ir_arg(ir, ref, 1)) != type || ir_type(ir, ir_arg(ir, ref, 2)) != type)
        return "a select's arms have another type";
    return NULL;
}

static const char *check_vec(const Ir *ir, Ref ref)
{
    int components = 0;
    for (int i = 0; i < ir_at(ir, ref)->count; i++)
        components += ir_components(ir, ir_arg(ir, ref, i));
    return components == ir_components(ir, ref) && components > 1
               ? NULL
               : "a vector's parts do not fill it";
}

static const char *check_linear(const Ir *ir, Ref ref)
{
    for (int i = 0; i < ir_at(ir, ref)->count; i++)
        if (ir_type(ir, ir_arg(ir, ref, i)) != ir_type(ir, ref))
            return "a matrix and its vector have different widths";
    return ir_at(ir, ref)->count == ir_components(ir, ref) + 1
               ? NULL
               : "a matrix has the wrong number of columns";
}

static const char *check_swizzle(const Ir *ir, Ref ref)
{
    for (int i = 0; i < ir_components(ir, ref); i++)
        if ((int)(ir_at(ir, ref)->payload >> 2 * i & 3) >= ir_components(ir, ir_arg(ir, ref, 0)))
            return "a swizzle uses a component that does not exist";
    return NULL;
}

/* Applies the CHECK lines of ops.def. */
static const char *check_special(const Ir *ir, Ref ref)
{
    switch (ir_at(ir, ref)->op) {
#define CHECK(name, function)                                                                      \
    case OP_##name:                                                                                \
        return function(ir, ref);
#include "grammar/ops.def"
    default:
        return NULL;
    }
}

static const char *check_node(const Ir *ir, Ref ref)
{
    const IrNode *node = ir_at(ir, ref);
    const char *fault = check_arity(node);
    for (int i = 0; !fault && i < node->count; i++)
        if (ir_arg(ir, ref, i) >= ref || !ir_arg(ir, ref, i))
            fault = "an operand comes after its user";
    if (fault)
        return fault;
    switch (op_table[node->op].rule) {
    case RULE_widest:
        return check_widest(ir, ref);
    case RULE_boolean:
        return check_boolean(ir, ref);
    default:
        return check_special(ir, ref);
    }
}

/* Checks that a function reads only its own arguments. */
static const char *check_function(const Ir *ir, const IrFunction *function, IrReach *reach)
{
    ir_reach(ir, &function->result, 1, reach);
    for (size_t k = 0; k < reach->count; k++) {
        Ref ref = reach->at[k];
        bool own = !ir_is(ir, ref, OP_argument);
        for (int i = 0; !own && i < function->count; i++)
            own = function->arguments[i] == ref;
        if (!own)
            return "a function reads another's argument";
    }
    return NULL;
}

static const char *check_functions(const Ir *ir, const uint8_t *live, Arena *scratch)
{
    uint8_t *called = ARENA_ARRAY(scratch, uint8_t, ir->function_count + 1);
    IrReach reach = ir_reach_new(ir, scratch);
    const char *fault = NULL;
    for (Ref ref = 1; ref < ir->count; ref++)
        if (live[ref] && ir_applies(ir, ref) && ir_at(ir, ref)->payload < ir->function_count)
            called[ir_at(ir, ref)->payload] = 1;
    for (size_t f = 0; !fault && f < ir->function_count; f++)
        if (called[f])
            fault = check_function(ir, &ir->functions[f], &reach);
    return fault;
}

/* Checks that no argument is read outside functions. */
static const char *check_main(const Ir *ir, Arena *scratch)
{
    uint8_t *in_main = ARENA_ARRAY(scratch, uint8_t, ir->count);
    for (int i = 0; i < ir->output_count; i++)
        in_main[ir->outputs[i].value] = 1;
    for (Ref ref = (Ref)ir->count - 1; ref > 0; ref--)
        for (int i = 0; in_main[ref] && i < ir_at(ir, ref)->count; i++)
            in_main[ir_arg(ir, ref, i)] = 1;
    for (Ref ref = 1; ref < ir->count; ref++)
        if (in_main[ref] && ir_is(ir, ref, OP_argument))
            return "an argument is read outside its function";
    return NULL;
}

const char *ir_check(const Ir *ir)
{
    Arena scratch = {0};
    uint8_t *live = ir_live(ir, &scratch);
    const char *fault = check_main(ir, &scratch);
    for (Ref ref = 1; !fault && ref < ir->count; ref++)
        if (live[ref])
            fault = check_node(ir, ref);
    if (!fault)
        fault = check_functions(ir, live, &scratch);
    arena_free(&scratch);
    return fault;
}
