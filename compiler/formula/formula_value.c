/* Evaluates formulas in double precision by the VALUE lines of expression.def. These are written
 * from the mathematics and are independent of the lowering to IR. A condition is 1 or 0. Scalars
 * are replicated to all four components. */
#include "compiler/formula/formula.h"
#include "compiler/library/reference.h"
#include "compiler/library/references.h"
#include <math.h>
#include <string.h>

static const double MIN_DIVISOR = 1e-30, MIN_BASE = 1e-37, GREATEST_POWER = 1e37;

/* Arguments of a term that does not work per component. */
typedef struct {
    const double *a, *b, *c, *d;
    int components; /* max width of the arguments of any width */
    const void *noise;
} Whole;

static double quotient(double a, double b) { return fabs(b) < MIN_DIVISOR ? 0 : a / b; }
static double remainder_of(double a, double b)
{
    return fabs(b) < MIN_DIVISOR ? 0 : a - b * floor(a / b);
}
static double share_of(double low, double high, double x)
{
    return fmin(fmax(quotient(x - low, high - low), 0), 1);
}

static double dot_components(const double *a, const double *b, int components)
{
    double sum = 0;
    for (int i = 0; i < components; i++)
        sum += a[i] * b[i];
    return sum;
}

static void average_of(const Whole *w, double *result)
{
    *result = dot_components(w->a, (const double[]){1, 1, 1, 1}, w->components) / w->components;
}

static void greatest_of(const Whole *w, double *result)
{
    *result = w->a[0];
    for (int i = 1; i < w->components; i++)
        *result = fmax(*result, w->a[i]);
}

static void least_of(const Whole *w, double *result)
{
    *result = w->a[0];
    for (int i = 1; i < w->components; i++)
        *result = fmin(*result, w->a[i]);
}

static void luminance_of(const Whole *w, double *result)
{
    *result = dot_components(w->a, (const double[]){.2126, .7152, .0722}, 3);
}

static void dot_of(const Whole *w, double *result)
{
    *result = dot_components(w->a, w->b, w->components);
}
static void length_of(const Whole *w, double *result)
{
    *result = sqrt(dot_components(w->a, w->a, w->components));
}

static void distance_of(const Whole *w, double *result)
{
    double between[4];
    for (int i = 0; i < 4; i++)
        between[i] = w->a[i] - w->b[i];
    *result = sqrt(dot_components(between, between, w->components));
}

static void cross_of(const Whole *w, double *result)
{
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        result[i] = w->a[j] * w->b[k] - w->a[k] * w->b[j];
    }
}

static void unit_of(const Whole *w, double *result)
{
    reference_of(FN_safeNormalize)(NULL, w->a, result);
}

static void reflection_of(const Whole *w, double *result)
{
    const double twice = 2 * dot_components(w->a, w->b, 3);
    for (int i = 0; i < 3; i++)
        result[i] = w->a[i] - twice * w->b[i];
}

static void turned_by(const Whole *w, double *result)
{
    const double c = cos(w->b[0]), s = sin(w->b[0]);
    result[0] = c * w->a[0] - s * w->a[1];
    result[1] = s * w->a[0] + c * w->a[1];
}

/* RGB of a hue in turns: red is 1 within a sixth of hue 0, and 0 from a third on; green and blue
 * are shifted by a third and two thirds. */
static void rgb_of(const Whole *w, double *result)
{
    for (int i = 0; i < 3; i++) {
        const double turn = w->a[0] - i / 3.0, away = fabs(turn - floor(turn) - .5) * 6;
        const double full = clamp(away - 1, 0, 1);
        result[i] = w->a[2] * (1 + w->a[1] * (full - 1));
    }
}

static void hsv_of(const Whole *w, double *result)
{
    const double r = w->a[0], g = w->a[1], b = w->a[2];
    const double most = fmax(fmax(r, g), b), spread = most - fmin(fmin(r, g), b);
    double sixth = most == r   ? quotient(g - b, spread)
                   : most == g ? 2 + quotient(b - r, spread)
                               : 4 + quotient(r - g, spread);
    if (spread < MIN_DIVISOR)
        sixth = 0;
    result[0] = sixth / 6 - floor(sixth / 6);
    result[1] = quotient(spread, most);
    result[2] = most;
}

static void odd_of(const Whole *w, double *result)
{
    *result = fmod(fabs(fmod(floor(w->a[0]), 2) + fmod(floor(w->a[1]), 2)), 2);
}

/* Evaluates a function of octaves at a position. */
static void octaves(const Whole *w, Function function, const double *after, double *result)
{
    const double args[6] = {
        w->a[0], w->a[1], w->a[2], after[0], clamp(after[1], -16, 16), clamp(after[2], -16, 16)};
    reference_of(function)(w->noise, args, result);
}

static void noise_at(const Whole *w, double *result)
{
    octaves(w, FN_turbulence, (const double[]){1, 2, .5}, result);
}
static void noises_at(const Whole *w, double *result)
{
    octaves(w, FN_vectorTurbulence, (const double[]){1, 2, .5}, result);
}

static void octaves_at(const Whole *w, double *result)
{
    octaves(w, FN_turbulence, (const double[]){w->b[0], w->c[0], w->d[0]}, result);
}

/* Sums octaves of noise, each folded at 0. */
static void folded_at(const Whole *w, double *result)
{
    const double finer = clamp(*w->c, -16, 16), weaker = clamp(*w->d, -16, 16);
    double at[3] = {w->a[0], w->a[1], w->a[2]}, strength = 1;
    Whole octave = *w;
    octave.a = at;
    *result = 0;
    for (int k = 0; k < *w->b; k++, strength *= weaker) {
        double noise;
        noise_at(&octave, &noise);
        *result += strength * fabs(noise);
        for (int i = 0; i < 3; i++)
            at[i] *= finer;
    }
}

static void vector_octaves_at(const Whole *w, double *result)
{
    octaves(w, FN_vectorTurbulence, (const double[]){w->b[0], w->c[0], w->d[0]}, result);
}

static void cells_by(const Whole *w, double which, double *result)
{
    const double args[] = {w->a[0], w->a[1], w->a[2], 0, 0, 0, 1, 0, which};
    reference_of(FN_cells3)(w->noise, args, result);
}

static void cells_at(const Whole *w, double *result) { cells_by(w, 0, result); }
static void edge_at(const Whole *w, double *result) { cells_by(w, 2, result); }
static void cell_noise_at(const Whole *w, double *result)
{
    const double args[] = {w->a[0], w->a[1], w->a[2], 3};
    reference_of((Function)(FN_FIRST_MAP + KIND_CellNoise))(w->noise, args, result);
}

static void worley_at(const Whole *w, double *result)
{
    const double args[] = {w->a[0], w->a[1], w->a[2], 1, 0, 3};
    reference_of((Function)(FN_FIRST_MAP + KIND_Worley))(w->noise, args, result);
}

static void random_at(const Whole *w, double *result)
{
    reference_of(FN_cellRandom)(w->noise, w->a, result);
}

static bool whole_value(Term term, const Whole *w, double *result)
{
    switch (term) {
#define VALUE_WHOLE(name, function)                                                                \
    case TERM_##name:                                                                              \
        function(w, result);                                                                       \
        return true;
#include "grammar/expression.def"
    default:
        return false;
    }
}

/* Evaluates one component of a term that works per component, from its arguments' components. */
static double component_value(Term term, const double *x)
{
    const double a = x[0], b = x[1], c = x[2], d = x[3], e = x[4];
    switch (term) {
#define VALUE(name, value)                                                                         \
    case TERM_##name:                                                                              \
        return value;
#include "grammar/expression.def"
    default:
        return 0;
    }
}

/* Power with an integer exponent, by squaring; 0 to the power 0 is 1. */
static double whole_power(double a, int n)
{
    double product = 1, square = a;
    for (int left = n < 0 ? -n : n; left; left >>= 1, square *= square)
        product *= left & 1 ? square : 1;
    return n < 0 ? quotient(1, product) : product;
}

/* Returns the number of components to compute: a scalar is computed once and copied to all
 * components. */
static int components_of(const FormulaStep *step) { return step->width <= 1 ? 1 : 4; }

static void term_value(const Formula *f, const FormulaStep *step, const FormulaPoint *point,
                       double *result)
{
    static const double zeros[4];
    const double *args[TERM_MAX_ARGUMENTS] = {zeros, zeros, zeros, zeros, zeros};
    Whole whole = {.components = 1, .noise = point->noise};
    for (uint32_t i = 0; i < step->count; i++) {
        const uint32_t number = formula_argument(f, step, i);
        args[i] = point->values[number];
        if (f->steps[number].width > whole.components)
            whole.components = f->steps[number].width;
    }
    whole.a = args[0], whole.b = args[1], whole.c = args[2], whole.d = args[3];
    if (whole_value((Term)step->row, &whole, result))
        return;
    for (int component = 0; component < components_of(step); component++) {
        const double x[TERM_MAX_ARGUMENTS] = {args[0][component], args[1][component],
                                              args[2][component], args[3][component],
                                              args[4][component]};
        result[component] = component_value((Term)step->row, x);
    }
}

static void list_value(const Formula *f, const FormulaStep *step, const FormulaPoint *point,
                       double *result)
{
    int components = 0;
    for (uint32_t i = 0; i < step->count; i++) {
        const uint32_t number = formula_argument(f, step, i);
        for (int component = 0; component < f->steps[number].width && components < 4; component++)
            result[components++] = point->values[number][component];
    }
}

static void step_value(const Formula *f, const FormulaStep *step, const FormulaPoint *point,
                       double *result)
{
    const double *a = step->count ? point->values[formula_argument(f, step, 0)] : NULL;
    for (int component = 0; component < components_of(step); component++)
        result[component] =
            step->kind == FORMULA_number       ? step->number
            : step->kind == FORMULA_value      ? point->quantity[step->row][component]
            : step->kind == FORMULA_input      ? point->inputs[step->row][component]
            : step->kind == FORMULA_attribute  ? point->attributes[step->row][component]
            : step->kind == FORMULA_power      ? whole_power(a[component], (int)step->number)
            : step->kind == FORMULA_components ? a[step->row >> 2 * component & 3]
                                               : 0;
    if (step->kind == FORMULA_term)
        term_value(f, step, point, result);
    if (step->kind == FORMULA_list)
        list_value(f, step, point, result);
    for (int component = 1; step->width <= 1 && component < 4; component++)
        result[component] = result[0];
    if (step->kind == FORMULA_list && step->count == 1 &&
        f->steps[formula_argument(f, step, 0)].width == 1)
        for (int component = 1; component < 4; component++)
            result[component] = result[0];
}

void formula_value(const Formula *f, const FormulaPoint *point, double result[4])
{
    for (uint32_t i = 0; i <= f->result; i++)
        step_value(f, &f->steps[i], point, point->values[i]);
    memcpy(result, point->values[f->result], sizeof point->values[0]);
}
