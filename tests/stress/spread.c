/* Evaluates an IR with operations that err like the roundings of ir_eval. One evaluation in
 * eight errs to 0 wherever possible: a cross product of parallel vectors is 0 except for
 * rounding, and a true 0 may lead to another result. */
#include "spread.h"
#include "choices.h"
#include "compiler/library/references.h"
#include <float.h>
#include <string.h>

static const double FLOAT_ULP = 1. / (1 << 23), DOUBLE_ULP = DBL_EPSILON;
/* 8-bit weights and results of samplers: tests/draw/sampler.h */
static const double SAMPLER_ERROR = 3. / 255;

static double greatest(const FoldArg *arg)
{
    double most = 0;
    for (int i = 0; i < type_table[arg->type].components; i++)
        most = fmax(most, fabs(arg->numbers[i]));
    return most;
}

/* Magnitude that a result's error is relative to: sums of products may cancel. */
static double size_of(const IrNode *node, const FoldArg *args, double value)
{
    double columns = 0;
    switch (node->op) {
    case OP_dot:
    case OP_cross:
        return 3 * greatest(&args[0]) * greatest(&args[1]);
    case OP_linear:
        for (int i = 1; i < node->count; i++)
            columns = fmax(columns, greatest(&args[i]));
        return 3 * greatest(&args[0]) * columns;
    case OP_mix:
        return fmax(greatest(&args[0]), greatest(&args[1])) * fmax(1, greatest(&args[2]));
    case OP_mod:
        return greatest(&args[0]);
    case OP_fract:
        return fmax(fabs(value), fmin(1, greatest(&args[0])));
    default:
        return fabs(value);
    }
}

static double octaves_error(const FoldArg *args, double each)
{
    double ratio = fabs(args[3].numbers[0]), count = args[1].numbers[0];
    return each * count * fmax(1, pow(ratio, count - 1));
}

typedef struct {
    Machine machine;
    const ReferenceContext *context;
    Choices random;
    int evaluation;
} Erring;

/* A random error in [-1, 1). In every other evaluation equal operations have equal errors, like
 * a driver's functions: such errors do not cancel in sums. */
static double toss(Erring *e, const IrNode *node, int component)
{
    Choices same;
    e->random.count = 0; /* no script is replayed */
    if (e->evaluation % 2 == 0)
        return 2 * choose_part(&e->random) - 1;
    same.script = NULL;
    same.count = 0;
    same.state =
        (((uint64_t)e->evaluation * OP_COUNT + node->op) * 1024 + node->payload % 1024) * 64 +
        (uint64_t)component;
    return 2 * choose_part(&same) - 1;
}

/* Error of a library function's internal rounding: that of arguments with such errors, also near
 * 0. */
static double inner_error(Erring *e, const IrNode *node, const FoldArg *args, double value)
{
    double numbers[64], result[4] = {0}, most = 0;
    const char *types = function_arguments((int)node->payload);
    int used = 0;
    for (int i = 0; i < node->count; i++)
        for (int component = 0; component < type_table[args[i].type].components; component++) {
            double v = args[i].numbers[component];
            bool whole = types[i] == 's' || types[i] == 'i';
            numbers[used] =
                whole ? v : v + 4 * FLOAT_ULP * toss(e, node, 1 + used) * fmax(1, fabs(v));
            used++;
        }
    reference_of((int)node->payload)(e->context, numbers, result);
    /* the component is unknown: take the nearest */
    for (int i = 0; i < type_table[node->type].components; i++)
        most = i && fabs(result[i] - value) > most ? most : fabs(result[i] - value);
    return 2 * most;
}

/* True if the footprint, given by the last two arguments before the displayed one, is certainly
 * below a texel. */
static bool is_magnified(const IrNode *node, const FoldArg *args)
{
    double texels = 0;
    const int end = node->count - (node->payload == FN_imageRiseNear);
    for (int i = end - 2; i < end; i++)
        texels = fmax(texels, hypot(args[i].numbers[0] * args[2].numbers[0],
                                    args[i].numbers[1] * args[2].numbers[1]));
    return texels < 0.5;
}

/* Error of a library function whose arguments already have errors. */
static double call_error(const IrNode *node, const FoldArg *args, double value)
{
    switch (node->payload) {
    case FN_turbulence:
    case FN_vectorTurbulence:
        return octaves_error(args, 2e-6);
    case FN_waveCosh:
    case FN_waveSinh:
    case FN_waveExpm1:
        return 6 * FLOAT_ULP * fabs(value) * (2 + fabs(args[0].numbers[0]));
    case FN_imageSampled:
    case FN_imageCentred:
        return SAMPLER_ERROR;
    case FN_imageSampledOver: /* above a texel the driver's filter is undefined */
        return is_magnified(node, args) ? SAMPLER_ERROR : 1;
    case FN_imageRise:
        return 2e-6 * greatest(&args[2]);
    case FN_imageRiseOver:
    case FN_imageRiseNear:
    case FN_imageRiseBeyond:
        return (is_magnified(node, args) ? 2e-6 : 1) * greatest(&args[2]);
    case FN_phongExponent:
        return 4e-6 * fabs(value);
    case FN_skyRadiance:
        return 2e-5 * fabs(value);
    default:
        return 2e-6 * fmax(1, fabs(value));
    }
}

/* Error of an sRGB texture that the driver decodes: tests/bounds.def, ColorSpace srgb. A slope
 * has it once for each texel it reads. */
static double decoding_error(const Erring *e, const IrNode *node, const FoldArg *args)
{
    const double decoded = 1.3e-3;
    if (function_arguments((int)node->payload)[0] != 's' ||
        !e->context->textures[(int)args[0].numbers[0]].srgb)
        return 0;
    if (function_row((int)node->payload)->result == TYPE_vec2 && node->count > 3)
        return 2 * decoded * greatest(&args[2]);
    if (node->payload != FN_imageAlong)
        return decoded;
    const double *size = args[2].numbers, *direction = args[3].numbers;
    return 2 * decoded * (fabs(direction[0] * size[0]) + fabs(direction[1] * size[1]));
}

/* Errors of drivers: numerics.md 6.2, with some margin. */
static double float_error(Erring *e, const IrNode *node, const FoldArg *args, double value)
{
    switch (node->op) {
    case OP_exp:
    case OP_exp2:
        return FLOAT_ULP * fabs(value) * (4 + 2 * fabs(args[0].numbers[0]));
    case OP_log:
        return FLOAT_ULP * (4 + 4 * fabs(value));
    case OP_sin:
    case OP_cos:
        return 2 * FLOAT_ULP * (1 + 0.1 * fmin(greatest(&args[0]), 10));
    case OP_tan:
        return 4 * FLOAT_ULP * (1 + value * value);
    case OP_asin:
    case OP_acos:
        return 4e-4;
    case OP_atan:
    case OP_atan2:
        return 5e-6;
    case OP_pow:
        return 70 * FLOAT_ULP * fabs(value);
    case OP_call:
        return call_error(node, args, value) + inner_error(e, node, args, value) +
               decoding_error(e, node, args);
    case OP_input:
    case OP_uniform:
    case OP_member:
    case OP_const:
        return 4 * FLOAT_ULP * fabs(value);
    default:
        return 2.5 * FLOAT_ULP * size_of(node, args, value);
    }
}

static bool is_exact(const IrNode *node)
{
    static const bool exact[OP_COUNT] = {
        [OP_argument] = true, [OP_texture] = true, [OP_neg] = true,   [OP_abs] = true,
        [OP_floor] = true,    [OP_ceil] = true,    [OP_min] = true,   [OP_max] = true,
        [OP_lt] = true,       [OP_le] = true,      [OP_eq] = true,    [OP_ne] = true,
        [OP_not] = true,      [OP_and] = true,     [OP_or] = true,    [OP_select] = true,
        [OP_vec] = true,      [OP_swizzle] = true, [OP_clamp] = true, [OP_apply] = true,
    };
    return exact[node->op] || node->type == TYPE_bool || node->type == TYPE_int;
}

/* Also for inputs and constants, which doubles represent exactly. */
static double double_error(const IrNode *node, const FoldArg *args, double value)
{
    if (node->op == OP_input || node->op == OP_uniform || node->op == OP_member ||
        node->op == OP_const)
        return 0;
    double size = node->op == OP_call || node->op == OP_sin || node->op == OP_cos
                      ? fmax(1, fabs(value))
                      : size_of(node, args, value);
    if (node->op == OP_call &&
        (node->payload == FN_turbulence || node->payload == FN_vectorTurbulence))
        size = fmax(size, octaves_error(args, 1));
    return 8 * DOUBLE_ULP * size;
}

static double err(void *user, const IrNode *node, const FoldArg *args, double value)
{
    Erring *e = user;
    if (is_exact(node) || !isfinite(value))
        return value;
    const double error = e->machine == MACHINE_float ? float_error(e, node, args, value)
                                                     : double_error(node, args, value);
    const double tossed = toss(e, node, 0) * error;
    value = e->evaluation % 8 == 7 && fabs(value) <= error ? 0 : value + tossed;
    return e->machine == MACHINE_float && fabs(value) < FLT_MIN ? 0 : value;
}

double spread_miss(const Spread *spread, int output, int component, double value, double number)
{
    double low = spread->low[output][component], high = spread->high[output][component],
           width = high - low;
    if (!isfinite(number))
        return INFINITY;
    return fmax(0, fmax(low - width - number, number - high - width)) / fmax(1, fabs(value));
}

static double watch(void *user, const IrNode *node, const FoldArg *args, double value)
{
    (void)node, (void)args;
    Evaluation *e = user;
    if (isfinite(value))
        e->peak = fmax(e->peak, fabs(value));
    else
        e->finite = false;
    return value;
}

static double to_float(void *user, const IrNode *node, const FoldArg *args, double value)
{
    float rounded = (float)value;
    if (node->op == OP_const && isfinite(value))
        rounded = (float)fmin(fmax(value, -FLT_MAX), FLT_MAX); /* as text_float writes it */
    return watch(user, node, args, fabsf(rounded) < FLT_MIN ? 0 : (double)rounded);
}

static void evaluate(const Ir *ir, const ReferenceContext *context,
                     const double inputs[INPUT_COUNT][4],
                     double (*round)(void *, const IrNode *, const FoldArg *, double),
                     Evaluation *e)
{
    IrRounding rounding = {round, e};
    memset(e, 0, sizeof *e);
    e->finite = true;
    ir_eval_rounded(ir, context, inputs, &rounding, e->value);
}

void evaluate_double(const Ir *ir, const ReferenceContext *context,
                     const double inputs[INPUT_COUNT][4], Evaluation *e)
{
    evaluate(ir, context, inputs, watch, e);
}

void evaluate_float(const Ir *ir, const ReferenceContext *context,
                    const double inputs[INPUT_COUNT][4], Evaluation *e)
{
    evaluate(ir, context, inputs, to_float, e);
}

static void widen(Spread *spread, const double result[MAX_OUTPUTS][4])
{
    for (int k = 0; k < 4 * MAX_OUTPUTS; k++) {
        spread->low[k / 4][k % 4] = fmin(spread->low[k / 4][k % 4], result[k / 4][k % 4]);
        spread->high[k / 4][k % 4] = fmax(spread->high[k / 4][k % 4], result[k / 4][k % 4]);
    }
}

/* For floats, one evaluation has regular rounding: it may reach a position, at a texel or an
 * edge, that no random one reaches. */
void spread_make(const Evaluated *at, Machine machine, int count, Spread *spread)
{
    Erring erring = {.machine = machine, .context = at->context};
    IrRounding rounding = {err, &erring};
    Evaluation rounded;
    choices_random(&erring.random, 1, (uint64_t)count);
    memcpy(spread->low, at->value, sizeof spread->low);
    memcpy(spread->high, at->value, sizeof spread->high);
    if (machine == MACHINE_float) {
        evaluate_float(at->ir, at->context, at->inputs, &rounded);
        widen(spread, (const double(*)[4])rounded.value);
    }
    for (int i = 0; i < count; i++) {
        double result[MAX_OUTPUTS][4] = {{0}};
        erring.evaluation = i;
        ir_eval_rounded(at->ir, at->context, at->inputs, &rounding, result);
        widen(spread, (const double(*)[4])result);
    }
}
