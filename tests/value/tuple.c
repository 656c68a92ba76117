/* Random numbers in ranges, and the special values at which functions tend to break. */
#include "tuple.h"
#include "compiler/library/java_random.h"
#include "compiler/library/sky.h"
#include <string.h>

enum {
    HOSTILE = 4 /* one number in HOSTILE, ... */,
    BORDERS = 8,
    AFFINE_VECTORS = 13,
    SKY_ROWS = 7
};

static double uniform(uint64_t *state, double low, double high)
{
    double coarse = (double)java_random_signed(state),
           fine = ldexp((double)java_random_signed(state), -24);
    return low + (high - low) * (.5 + .5 * (coarse + fine));
}

static unsigned pick(uint64_t *state, unsigned count)
{
    return java_random_bits(state, 16) % count;
}

/* The number, or one of its two adjacent floats. */
static float beside(uint64_t *state, float v)
{
    unsigned which = pick(state, 3);
    return which == 0 ? v : nextafterf(v, which == 1 ? 1e30f : -1e30f);
}

/* Integers, halves and quarters, and their adjacent floats. */
static float border(uint64_t *state)
{
    float v = (float)((int)pick(state, 2 * BORDERS * 4 + 1) - BORDERS * 4) / 4;
    return v == 0 ? (pick(state, 2) ? 0 : pick(state, 2) ? 1e-7f : -1e-7f) : beside(state, v);
}

static float place(uint64_t *state, double size, double far)
{
    if (pick(state, HOSTILE))
        return (float)uniform(state, -size, size);
    if (pick(state, 3))
        return border(state);
    return (float)(pick(state, 2) ? far : -far) + (pick(state, 2) ? 0.375f : 0);
}

static float in_range(uint64_t *state, double low, double high)
{
    float v = pick(state, 3) ? border(state) : (float)(pick(state, 2) ? low : high);
    if (pick(state, HOSTILE) || v < (float)low || v > (float)high)
        v = (float)uniform(state, low, high);
    return v;
}

static float logarithmic(uint64_t *state, double least, double most)
{
    return (float)fmin(fmax(exp(uniform(state, log(least), log(most))), least), most);
}

static float width(uint64_t *state, double least, double most)
{
    const double narrow = 1e-7;
    if (!pick(state, HOSTILE))
        return (float)(pick(state, 2) ? least : most);
    return logarithmic(state, fmax(least, narrow), most);
}

static float wide(uint64_t *state, double least, double most)
{
    float v = logarithmic(state, least, most);
    return pick(state, 2 * HOSTILE) ? pick(state, 2) ? v : -v : 0;
}

static float number(const Argument *a, uint64_t *state)
{
    static const float ratios[] = {2, 2, 1, -2, 0.5f};
    switch (a->form) {
    case FORM_position:
        return place(state, a->low, a->high);
    case FORM_width:
        return width(state, a->low, a->high);
    case FORM_wide:
        return wide(state, a->low, a->high);
    case FORM_whole:
        return (float)(a->low + pick(state, (unsigned)(a->high - a->low) + 1));
    case FORM_ratio:
        return ratios[pick(state, sizeof ratios / sizeof *ratios)];
    case FORM_rest:
        return pick(state, HOSTILE) ? (float)uniform(state, -1e-6, 1e-6) : 0;
    case FORM_texture:
        return (float)a->low;
    default:
        return in_range(state, a->low, a->high);
    }
}

/* A direction: random, an axis, a diagonal, or close to one of these. */
static void unit(uint64_t *state, float v[3])
{
    double length = 0;
    bool hostile = !pick(state, HOSTILE);
    do {
        length = 0;
        for (int i = 0; i < 3; i++) {
            v[i] = hostile ? (float)((int)pick(state, 3) - 1) : (float)uniform(state, -1, 1);
            if (hostile && pick(state, 2) == 0)
                v[i] += (float)uniform(state, -1e-3, 1e-3);
            length += (double)v[i] * (double)v[i];
        }
    } while (length < .01);
    for (int i = 0; i < 3; i++)
        v[i] = (float)((double)v[i] / sqrt(length));
}

/* The upper 12 bits of a number. */
static double upper_bits(double x)
{
    int exponent;
    double mantissa = frexp(x, &exponent);
    return ldexp(trunc(ldexp(mantissa, 12)), exponent - 12);
}

/* The base, then the columns of a matrix and an offset as three floats each. */
static void affine(uint64_t *state, Tuple tuple)
{
    for (int i = 0; i < 3; i++) {
        tuple[0][i] = place(state, 100, 1e4);
        for (int column = 0; column < 4; column++) {
            double v = pick(state, HOSTILE) ? uniform(state, -10, 10) : pick(state, 3),
                   a = upper_bits(v);
            tuple[1 + 3 * column][i] = (float)a;
            tuple[2 + 3 * column][i] = (float)upper_bits(v - a);
            tuple[3 + 3 * column][i] = (float)(v - a - upper_bits(v - a));
        }
    }
}

/* A view direction, the sun's, then the coefficients of a sky. */
static void sky(uint64_t *state, Tuple tuple)
{
    double rows[SKY_ROWS][3], sun[3];
    float v[3];
    unit(state, v);
    for (int i = 0; i < 3; i++)
        sun[i] = i == 2 ? fabs((double)v[i]) : (double)v[i];
    sky_coefficients(sun, uniform(state, 2, 10), 1, rows);
    unit(state, tuple[0]);
    for (int i = 0; i < 3; i++) {
        tuple[1][i] = (float)rows[SKY_ROWS - 1][i];
        for (int row = 0; row + 1 < SKY_ROWS; row++)
            tuple[2 + row][i] = (float)rows[row][i];
    }
}

int argument_components(char letter) { return letter >= '2' && letter <= '4' ? letter - '0' : 1; }

void tuple_draw(const Argument *arguments, const char *letters, uint64_t *state, Tuple tuple)
{
    memset(tuple, 0, sizeof(Tuple));
    if (arguments->form == FORM_affine)
        affine(state, tuple);
    else if (arguments->form == FORM_sky)
        sky(state, tuple);
    else
        for (int i = 0; letters[i]; i++) {
            const Argument *a = &arguments[i];
            if (a->form == FORM_unit) {
                unit(state, tuple[i]);
                continue;
            }
            for (int component = 0; component < argument_components(letters[i]); component++)
                tuple[i][component] =
                    a->form == FORM_size
                        ? (float)(component ? call_textures->height : call_textures->width)
                        : number(a, state);
        }
}

void tuple_flatten(Tuple tuple, const char *letters, double *args)
{
    for (int i = 0; letters[i]; i++)
        for (int component = 0; component < argument_components(letters[i]); component++)
            *args++ = (double)tuple[i][component];
}

static double reach_of(Form form, double v)
{
    const double step = ldexp(1, -23);
    switch (form) {
    case FORM_position:
    case FORM_range:
        return step * fmax(1, fabs(v));
    /* rounding of a sum or quotient of components is relative to the greatest component */
    case FORM_unit:
        return step;
    case FORM_width:
    case FORM_wide:
        return step * fabs(v);
    default:
        return 0;
    }
}

void tuple_move(double *args, const Argument *arguments, const char *letters, double reach,
                uint64_t *state)
{
    for (int i = 0; letters[i]; i++)
        for (int component = 0; component < argument_components(letters[i]); component++, args++) {
            double way = pick(state, 2) ? uniform(state, -1, 1) : (double)pick(state, 3) - 1;
            *args += way * reach * reach_of(arguments[i].form, *args);
        }
}
