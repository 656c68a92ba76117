/* Waveforms, by the `build` column of waves.def; with a footprint, by its MEAN rows. */
#include "compiler/lower/footprint.h"
#include "compiler/ir/build_words.h"

#define SQUARE(a)         square(l, a)
#define CLAMP(a, b, c)    build_clamp(ir, a, K(b), K(c))
#define CALL(name, a)     build_call(ir, FN_##name, a)
#define CALL2(name, a, b) build_call(ir, FN_##name, a, b)

/* Returns the square, in the form that --powers selects. Squares of squares become higher powers
 * in opt_power.c. */
static Ref square(Lower *l, Ref v)
{
    Ir *ir = l->ir;
    switch (l->job->choice[AXIS_powers]) {
    case CHOICE_powers_pow:
        return BINARY(pow, UNARY(abs, v), K(2));
    case CHOICE_powers_compensated:
        return build_call(ir, FN_powerCompensated, v, build_int(ir, 2));
    default:
        return build_square(ir, v);
    }
}

static Ref point_value(Lower *l, WaveKind kind, Ref v)
{
    Ir *ir = l->ir;
    switch (kind) {
#define WAVE(name, reference, build, doc)                                                          \
    case WAVE_##name:                                                                              \
        return build;
#include "grammar/waves.def"
    default:
        return v;
    }
}

/* The mean over a box, 0 if the wave has no MEAN row, and the variance that the mean of a whole
 * period leaves out. */
typedef struct {
    Ref mean;
    double variance, period;
} BoxMean;

static BoxMean box_mean(Lower *l, WaveKind kind, Ref v, Ref w)
{
    Ir *ir = l->ir;
    switch (kind) {
#define MEAN(name, mean, left, length)                                                             \
    case WAVE_##name:                                                                              \
        return (BoxMean){mean, left, length};
#include "grammar/waves.def"
    default:
        return (BoxMean){0, 0, 1};
    }
}

/* Returns the factor by which the wave scales small changes of its argument; 0: unknown, no
 * variance is passed on. */
static Ref rate(Lower *l, WaveKind kind, Ref v)
{
    Ir *ir = l->ir;
    switch (kind) {
#define RATE(name, rate)                                                                           \
    case WAVE_##name:                                                                              \
        return rate;
#include "grammar/waves.def"
    default:
        return 0;
    }
}

/* Returns the variance within a box of width w: all of it once the box is as wide as a period.
 * Below, the part not covered by the mean's slope is about the cube of the box's share of the
 * period. */
static Ref period_variance(Lower *l, Ref w, double variance, double period)
{
    Ir *ir = l->ir;
    Ref share = build_min(ir, build_scale(ir, w, 1 / period), K(1));
    return MUL(MUL(MUL(share, share), share), K(variance));
}

/* Returns the variance of the wave that results from its argument's variance. */
static Ref passed_variance(Lower *l, WaveKind kind, MapValue v)
{
    Ir *ir = l->ir;
    Ref factor = v.variance ? rate(l, kind, v.value) : 0;
    return factor ? MUL(v.variance, build_square(ir, factor)) : 0;
}

static MapValue one_wave(Lower *l, WaveKind kind, MapValue v)
{
    Ref w = footprint_edges(l, v);
    const BoxMean box = w ? box_mean(l, kind, v.value, w) : (BoxMean){0, 0, 1};
    MapValue answer = map_value_of(box.mean ? box.mean : point_value(l, kind, v.value));
    answer.variance = box.variance > 0 ? period_variance(l, w, box.variance, box.period)
                                       : passed_variance(l, kind, v);
    return answer;
}

MapValue lower_wave(Lower *l, const Wave *wave, MapValue v)
{
    if (!wave)
        return v;
    if (wave->kind != WAVE_Chain)
        return one_wave(l, wave->kind, v);
    MapValue first = lower_wave(l, wave->first, v);
    first = map_value_scaled(l, first, lower_param(l, &wave->factor, TYPE_float));
    first = map_value_moved(l, first, lower_param(l, &wave->shift, TYPE_float));
    return lower_wave(l, wave->second, first);
}
