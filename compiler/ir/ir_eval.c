/* Evaluates an Ir in double precision, node by node; functions are applied to the values of
 * their arguments. */
#include "compiler/ir/fold.h"
#include <string.h>

typedef struct {
    const Ir *ir;
    const ReferenceContext *context;
    const double (*inputs)[4];
    const IrRounding *rounding; /* rounding of results; NULL: none */
    Arena scratch;
} Evaluator;

typedef struct {
    double (*value)[4]; /* per Ref: the node's value; valid where `known` is set */
    uint8_t *known;
    const IrFunction *function; /* the function being evaluated */
    const FoldArg *arguments;   /* values of its arguments */
} Frame;

static void eval(Evaluator *e, Frame *frame, Ref result);

/* A node with known operands, as passed to the EVAL functions of ops.def. */
typedef struct {
    Evaluator *e;
    const Frame *frame;
    const IrNode *node;
    Ref ref;
    const FoldArg *args;
} Site;

static double rounded(const Evaluator *e, const IrNode *node, const FoldArg *args, double value)
{
    return e->rounding ? e->rounding->round(e->rounding->user, node, args, value) : value;
}

static void copy(const IrNode *node, const double *numbers, double *result)
{
    memcpy(result, numbers, sizeof *numbers * (size_t)type_table[node->type].components);
}

static void eval_const(const Site *s, double *result)
{
    copy(s->node, ir_numbers(s->e->ir, s->ref), result);
}
static void eval_input(const Site *s, double *result)
{
    copy(s->node, s->e->inputs[s->node->payload], result);
}
/* A sampler has no components; the reference function gets its number. */
static void eval_texture(const Site *s, double *result) { result[0] = s->node->payload; }

static void eval_uniform(const Site *s, double *result)
{
    copy(s->node, s->e->ir->graph->uniforms[s->node->payload]->initial, result);
}

/* Evaluates to the attribute's default, as for a mesh without the attribute; its derivatives are
 * 0. */
static void eval_attribute(const Site *s, double *result)
{
    static const double none[4] = {0};
    const double *initial = s->e->ir->graph->attributes[attribute_of(s->node->payload)]->initial;
    copy(s->node, attribute_part(s->node->payload) == ATTRIBUTE_value ? initial : none, result);
}

static void eval_member(const Site *s, double *result)
{
    copy(s->node, s->e->ir->constants[s->node->payload].numbers, result);
}

/* Returns an argument's position in the function. The position differs from the original number
 * after other arguments were dropped. */
static int argument_number(const IrFunction *function, Ref argument)
{
    int i = 0;
    while (function->arguments[i] != argument)
        i++;
    return i;
}

static void eval_argument(const Site *s, double *result)
{
    copy(s->node, s->frame->arguments[argument_number(s->frame->function, s->ref)].numbers, result);
}

static void run_function(const Site *s, const FoldArg *args, double *result)
{
    Evaluator *e = s->e;
    Frame inner = {.function = &e->ir->functions[s->node->payload], .arguments = args};
    Ref body = inner.function->result;
    inner.value = arena_alloc(&e->scratch, sizeof *inner.value * (body + 1));
    inner.known = arena_zero(&e->scratch, body + 1);
    eval(e, &inner, body);
    memcpy(result, inner.value[body], sizeof *inner.value);
}

static void eval_apply(const Site *s, double *result) { run_function(s, s->args, result); }

/* Sums the function over the kernel, rounding each partial sum. Point (x, y, z) of the kernel
 * has coordinates -1, 0 or 1: a position is offset by all three, a vec2 by two. */
static void eval_kernel(const Site *s, double *result)
{
    FoldArg moved[FOLD_OPERANDS];
    const IrNode *node = s->node;
    const double *size = s->args[node->count - 1].numbers;
    for (int n = 0; n < KERNEL_POINTS; n++) {
        const double offset[3] = {0.5 * (n / 9 - 1) * size[0], 0.5 * (n / 3 % 3 - 1) * size[1],
                                  0.5 * (n % 3 - 1) * size[2]};
        double value[4] = {0};
        memcpy(moved, s->args, sizeof moved);
        for (int i = 0; i < node->count - 1; i++)
            for (int component = 0; component < type_table[s->args[i].type].components; component++)
                moved[i].numbers[component] += offset[component];
        run_function(s, moved, value);
        for (int component = 0; component < type_table[node->type].components; component++)
            result[component] = rounded(s->e, node, s->args, result[component] + value[component]);
    }
}

static void load_arguments(const Evaluator *e, const Frame *frame, Ref ref, FoldArg *args)
{
    const IrNode *node = ir_at(e->ir, ref);
    for (int i = 0; i < node->count; i++) {
        const Ref arg = ir_arg(e->ir, ref, i);
        args[i].type = ir_type(e->ir, arg) == TYPE_sampler ? TYPE_float : ir_type(e->ir, arg);
        memcpy(args[i].numbers, frame->value[arg], sizeof args[i].numbers);
    }
}

static void eval_node(Evaluator *e, Frame *frame, Ref ref)
{
    const IrNode *node = ir_at(e->ir, ref);
    double *result = frame->value[ref];
    FoldArg args[FOLD_OPERANDS];
    const Site site = {e, frame, node, ref, args};
    memset(result, 0, sizeof *frame->value);
    load_arguments(e, frame, ref, args);
    switch (node->op) {
#define EVAL(name, function)                                                                       \
    case OP_##name:                                                                                \
        function(&site, result);                                                                   \
        break;
#include "grammar/ops.def"
    default:
        fold_value(e->context, node, args, result);
    }
    for (int i = 0; i < type_table[node->type].components; i++)
        result[i] = rounded(e, node, args, result[i]);
}

/* Evaluates all nodes that `result` needs in numeric order, operands first. Both arms of a
 * select are evaluated. */
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

void ir_eval_rounded(const Ir *ir, const ReferenceContext *context,
                     const double inputs[INPUT_COUNT][4], const IrRounding *rounding,
                     double result[MAX_OUTPUTS][4])
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
             double result[MAX_OUTPUTS][4])
{
    ir_eval_rounded(ir, context, inputs, NULL, result);
}
