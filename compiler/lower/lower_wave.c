/* Waveforms, from the `build` column of waves.def, and with a footprint from its MEAN rows. */
#include "compiler/lower/footprint.h"

#define K(x)              number(l, x)
#define UNARY(op, a)      ir_unary(l->ir, OP_##op, a)
#define BINARY(op, a, b)  ir_binary(l->ir, OP_##op, a, b)
#define ADD(a, b)         add(l, a, b)
#define MUL(a, b)         mul(l, a, b)
#define SUB(a, b)         sub(l, a, b)
#define TWICE(a)          mul(l, a, K(2))
#define SQUARE(a)         square(l, a)
#define CLAMP(a, b, c)    ir_ternary(l->ir, OP_clamp, a, K(b), K(c))
#define CALL(name, a)     ir_call(l->ir, FN_##name, REFS(l->ir, a), 1)
#define CALL2(name, a, b) ir_call(l->ir, FN_##name, REFS(l->ir, a, b), 2)

/* By the choice of --powers. Squares of squares become higher powers in opt_power.c. */
static Ref square(Lower *l, Ref v)
{
    switch (l->job->choice[AXIS_powers]) {
    case CHOICE_powers_pow:
        return BINARY(pow, UNARY(abs, v), K(2));
    case CHOICE_powers_compensated:
        return ir_call(l->ir, FN_powerCompensated, REFS(l->ir, v, ir_int(l->ir, 2)), 2);
    default:
        return MUL(v, v);
    }
}

static Ref point_value(Lower *l, WaveKind kind, Ref v)
{
    switch (kind) {
#define WAVE(name, reference, build, doc)                                                                              \
    case WAVE_##name:                                                                                                  \
        return build;
#include "grammar/waves.def"
    default:
        return v;
    }
}

/* The mean over a box, and what it leaves out; 0 where the wave has no MEAN row. */
static Ref box_mean(Lower *l, WaveKind kind, Ref v, Ref w, double *variance, double *period)
{
    switch (kind) {
#define MEAN(name, mean, left, length)                                                                                 \
    case WAVE_##name:                                                                                                  \
        *variance = left;                                                                                              \
        *period = length;                                                                                              \
        return mean;
#include "grammar/waves.def"
    default:
        return 0;
    }
}

/* By how much the wave multiplies what is small; 0: it is taken to leave nothing of it. */
static Ref rate(Lower *l, WaveKind kind, Ref v)
{
    switch (kind) {
#define RATE(name, rate)                                                                                               \
    case WAVE_##name:                                                                                                  \
        return rate;
#include "grammar/waves.def"
    default:
        return 0;
    }
}

/* All of the variance once the box holds a period; below, about the cube of its share is not seen in the mean's slope. */
static Ref period_variance(Lower *l, Ref w, double variance, double period)
{
    Ref share = ir_binary(l->ir, OP_min, mul(l, w, K(1 / period)), K(1));
    return MUL(MUL(MUL(share, share), share), K(variance));
}

/* Of the argument's variance. */
static Ref passed_variance(Lower *l, WaveKind kind, Answer v)
{
    Ref factor = v.variance ? rate(l, kind, v.value) : 0;
    return factor ? MUL(v.variance, MUL(factor, factor)) : 0;
}

static Answer one_wave(Lower *l, WaveKind kind, Answer v)
{
    double variance = 0, period = 1;
    Ref w = footprint_edges(l, v), mean = w ? box_mean(l, kind, v.value, w, &variance, &period) : 0;
    Answer answer = answer_of(mean ? mean : point_value(l, kind, v.value));
    answer.variance = variance > 0 ? period_variance(l, w, variance, period) : passed_variance(l, kind, v);
    return answer;
}

Answer lower_wave(Lower *l, const Wave *wave, Answer v)
{
    if (!wave)
        return v;
    if (wave->kind != WAVE_Chain)
        return one_wave(l, wave->kind, v);
    Answer first = lower_wave(l, wave->first, v);
    first = answer_scaled(l, first, lower_param(l, &wave->factor, TYPE_float));
    first = answer_moved(l, first, lower_param(l, &wave->shift, TYPE_float));
    return lower_wave(l, wave->second, first);
}
