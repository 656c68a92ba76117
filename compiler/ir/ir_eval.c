/* Evaluates an Ir in double precision, node by node, functions by applying them to their arguments' values. */
#include "compiler/ir/fold.h"
#include <string.h>

typedef struct {
    const Ir *ir;
    const ReferenceContext *context;
    const double (*inputs)[4];
    const IrRounding *rounding; /* NULL: none */
    Arena scratch;
} Evaluator;

typedef struct {
    double (*value)[4]; /* by Ref; valid where known */
    uint8_t *known;
    const IrFunction *function; /* under way */
    const FoldArg *arguments;   /* of it */
} Frame;

static void eval(Evaluator *e, Frame *frame, Ref result);

static double rounded(const Evaluator *e, const IrNode *node, const FoldArg *args, double value)
{
    return e->rounding ? e->rounding->round(e->rounding->user, node, args, value) : value;
}

static void load_argument(const Evaluator *e, const Frame *frame, Ref ref, FoldArg *arg)
{
    arg->type = ir_type(e->ir, ref);
    memcpy(arg->numbers, frame->value[ref], sizeof arg->numbers);
}

static void eval_apply(Evaluator *e, const IrNode *node, const FoldArg *args, double *result)
{
    Frame inner = {.function = &e->ir->functions[node->payload], .arguments = args};
    Ref body = inner.function->result;
    inner.value = arena_alloc(&e->scratch, sizeof *inner.value * (body + 1));
    inner.known = arena_zero(&e->scratch, body + 1);
    eval(e, &inner, body);
    memcpy(result, inner.value[body], sizeof *inner.value);
}

/* Its place among the arguments, which is not the number it was made with once others were dropped. */
static int argument_number(const IrFunction *function, Ref argument)
{
    int i = 0;
    while (function->arguments[i] != argument)
        i++;
    return i;
}

/* Each partial sum is rounded. The arguments at the point (x, y, z) of the kernel, each from -1 to 1: a position moves by all three, a vec2 by two. */
static void eval_kernel(Evaluator *e, const IrNode *node, const FoldArg *args, double *result)
{
    FoldArg moved[FOLD_OPERANDS];
    const double *size = args[node->count - 1].numbers;
    for (int n = 0; n < KERNEL_POINTS; n++) {
        const double offset[3] = {0.5 * (n / 9 - 1) * size[0], 0.5 * (n / 3 % 3 - 1) * size[1],
                                  0.5 * (n % 3 - 1) * size[2]};
        double value[4] = {0};
        memcpy(moved, args, sizeof moved);
        for (int i = 0; i < node->count - 1; i++)
            for (int lane = 0; lane < type_table[args[i].type].lanes; lane++)
                moved[i].numbers[lane] += offset[lane];
        eval_apply(e, node, moved, value);
        for (int lane = 0; lane < type_table[node->type].lanes; lane++)
            result[lane] = rounded(e, node, args, result[lane] + value[lane]);
    }
}

static void eval_node(Evaluator *e, Frame *frame, Ref ref)
{
    const IrNode *node = ir_at(e->ir, ref);
    double *result = frame->value[ref];
    FoldArg args[FOLD_OPERANDS];
    memset(result, 0, sizeof *frame->value);
    for (int i = 0; i < node->count; i++)
        load_argument(e, frame, ir_arg(e->ir, ref, i), &args[i]);
    size_t size = sizeof(double) * (size_t)type_table[node->type].lanes;
    switch (node->op) {
    case OP_const:
        memcpy(result, ir_numbers(e->ir, ref), size);
        break;
    case OP_input:
        memcpy(result, e->inputs[node->payload], size);
        break;
    case OP_uniform:
        memcpy(result, e->ir->graph->uniforms[node->payload]->initial, size);
        break;
    case OP_constant:
        memcpy(result, e->ir->constants[node->payload].numbers, size);
        break;
    case OP_argument:
        memcpy(result, frame->arguments[argument_number(frame->function, ref)].numbers, size);
        break;
    case OP_texture:
        result[0] = node->payload;
        break;
    case OP_apply:
        eval_apply(e, node, args, result);
        break;
    case OP_kernel:
        eval_kernel(e, node, args, result);
        break;
    default:
        if (node->op == OP_call) /* a sampler has no lanes; the reference gets its number */
            for (int i = 0; i < node->count; i++)
                if (args[i].type == TYPE_sampler)
                    args[i].type = TYPE_float;
        fold_value(e->context, (Op)node->op, (Type)node->type, node->payload, args, node->count, result);
    }
    for (int i = 0; i < type_table[node->type].lanes; i++)
        result[i] = rounded(e, node, args, result[i]);
}

/* All that `result` needs, in the order of the numbers: operands come first. Both arms of a select are evaluated. */
static void eval(Evaluator *e, Frame *frame, Ref result)
{
    uint8_t *needed = arena_zero(&e->scratch, result + 1);
    needed[result] = 1;
    for (Ref ref = result; ref > 0; ref--)
        for (int i = 0; needed[ref] && !frame->known[ref] && i < ir_at(e->ir, ref)->count; i++)
            needed[ir_arg(e->ir, ref, i)] = 1;
    for (Ref ref = 1; ref <= result; ref++)
        if (needed[ref] && !frame->known[ref]) {
            eval_node(e, frame, ref);
            frame->known[ref] = 1;
        }
}

void ir_eval_rounded(const Ir *ir, const ReferenceContext *context, const double inputs[INPUT_COUNT][4],
                     const IrRounding *rounding, double result[MOST_OUTPUTS][4])
{
    Evaluator e = {.ir = ir, .context = context, .inputs = inputs, .rounding = rounding};
    Frame frame = {0};
    frame.value = arena_alloc(&e.scratch, sizeof *frame.value * ir->count);
    frame.known = arena_zero(&e.scratch, ir->count);
    for (int i = 0; i < ir->output_count; i++) {
        eval(&e, &frame, ir->outputs[i].value);
        memcpy(result[i], frame.value[ir->outputs[i].value], sizeof result[i]);
    }
    arena_free(&e.scratch);
}

void ir_eval(const Ir *ir, const ReferenceContext *context, const double inputs[INPUT_COUNT][4],
             double result[MOST_OUTPUTS][4])
{
    ir_eval_rounded(ir, context, inputs, NULL, result);
}
