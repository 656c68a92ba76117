/* Noise and turbulence, semantics.md 3.1 and 3.2: point values, means over a square (Filtered),
 * and gradients. Arguments of the last two: p, a rest that is added to p, octaves,
 * frequencyRatio, noiseRatio, the square's edge. */
#include "compiler/library/reference.h"

enum { GRANITE_OCTAVES = 6 };

/* Measured statistics that replace an octave finer than the square; equal to
 * noiseStatistics.glsl. */
typedef struct {
    double mean, variance, magnitude, grain;
} Statistics;

static ReferenceNoise noise_of(const void *context)
{
    return ((const ReferenceContext *)context)->noise;
}

static Statistics statistics(const void *context)
{
    switch (noise_of(context)) {
    case REFERENCE_GROIMP:
    case REFERENCE_GROIMP_FLOAT:
        return (Statistics){-0.0206, 0.25, 0.412, 1};
    case REFERENCE_SIMPLEX:
    case REFERENCE_SIMPLEX_FLOAT:
        return (Statistics){0, 0.232, 0.382, 2.06};
    default:
        return (Statistics){0, 0.25, 0.412, 1};
    }
}

/* Returns noise at (p + rest) times `scale`, and its gradient, which is 0 where the noise is
 * clamped. */
static double noise_at(const void *context, const double p[3], const double rest[3], double scale,
                       double gradient[3])
{
    const double q[3] = {scale * (p[0] + rest[0]), scale * (p[1] + rest[1]),
                         scale * (p[2] + rest[2])};
    double slope[3];
    const double value = 2 * reference_lattice(noise_of(context), q, slope);
    for (int i = 0; i < 3; i++)
        gradient[i] = fabs(value) < 1 ? 2 * slope[i] : 0;
    return clamp(value, -1, 1);
}

/* Fraction of an octave that the mean over a square loses: a (1 - 1 / (1 + b w^2 + c w^4)),
 * rewritten so that a narrow width does not cancel. */
static double lost(const void *context, double width, const double factor[3])
{
    double w = width * statistics(context).grain, bend = w * w * (factor[1] + factor[2] * w * w);
    return isinf(bend) ? 1 : fmin(factor[0] * bend / (1 + bend), 1);
}

static const double of_octave[] = {1.43, .383, .0467}, of_magnitude[] = {1.35, 1.08, .19};

static double octave_share(const void *context, double width)
{
    return 1 - lost(context, width, of_octave);
}

static double magnitude_share(const void *context, double width)
{
    return 1 - lost(context, width, of_magnitude);
}

/* Residual variance of an octave in the square, less the part that its slope explains. `steep`
 * is the mean square slope over an edge of 1, relative to the variance. */
static double left_out(const void *context, double loss, double width, double steep)
{
    double w = width * statistics(context).grain, share = 1 - loss;
    return fmax(loss * (1 + share) - (share > 0 ? share * share * w * w * steep / 12 : 0), 0);
}

REFERENCE(noise)
{
    double gradient[3];
    result[0] = noise_at(context, args, (const double[3]){0}, 1, gradient);
}

typedef struct {
    const double *p, *rest;
    int octaves;
    double frequency, strength, width;
} Octaves;

/* Reads the arguments that follow p, starting at `args`. */
static Octaves octaves_of(const double *p, const double *rest, const double *args, double width)
{
    return (Octaves){p,       rest,    whole_between(args[0], 1, REFERENCE_OCTAVES),
                     args[1], args[2], width};
}

/* Computes the gradient (0 to 2) and the value (3). */
static void turbulence(const void *context, const Octaves *o, double result[4])
{
    for (int i = 0; i < 4; i++)
        result[i] = 0;
    for (int k = 0; k < o->octaves; k++) {
        double scale = pow(o->frequency, k), strength = pow(o->strength, k), gradient[3];
        double share = o->width > 0 ? octave_share(context, o->width * fabs(scale)) : 1;
        double value = noise_at(context, o->p, o->rest, scale, gradient),
               mean = statistics(context).mean;
        for (int i = 0; i < 3; i++)
            result[i] += strength * share * scale * gradient[i];
        result[3] += strength * (mean + share * (value - mean));
    }
}

static const double NO_REST[3] = {0};

REFERENCE(turbulence)
{
    Octaves o = octaves_of(args, NO_REST, args + 3, 0);
    double all[4];
    turbulence(context, &o, all);
    result[0] = all[3];
}

REFERENCE(turbulenceFiltered)
{
    Octaves o = octaves_of(args, args + 3, args + 6, args[9]);
    double all[4];
    turbulence(context, &o, all);
    result[0] = all[3];
}

REFERENCE(turbulenceGradient)
{
    Octaves o = octaves_of(args, args + 3, args + 6, args[9]);
    turbulence(context, &o, result);
}

REFERENCE(turbulenceVariance)
{
    int octaves = whole_between(args[0], 1, REFERENCE_OCTAVES);
    const double variance = statistics(context).variance;
    result[0] = 0;
    for (int k = 0; k < octaves; k++) {
        double width = args[3] * fabs(pow(args[1], k));
        result[0] += variance * pow(args[2], 2 * k) *
                     left_out(context, lost(context, width, of_octave), width, 4.73);
    }
}

/* Computes the vector and its derivative along `direction`. */
static void vector_turbulence(const void *context, const Octaves *o, const double direction[3],
                              double value[3], double along[3])
{
    const double mean = statistics(context).mean / 2; /* mean of each component */
    for (int i = 0; i < 3; i++)
        value[i] = along[i] = 0;
    for (int k = 0; k < o->octaves; k++) {
        double scale = pow(o->frequency, k), term[3], slope[3][3], q[3];
        double whole = pow(o->strength, k);
        double strength =
            whole * (o->width > 0 ? octave_share(context, o->width * fabs(scale)) : 1);
        for (int i = 0; i < 3; i++)
            q[i] = scale * (o->p[i] + o->rest[i]);
        reference_lattice_slope(noise_of(context), q, term, slope);
        for (int i = 0; i < 3; i++) {
            value[i] += strength * term[i] + (whole - strength) * mean;
            for (int axis = 0; axis < 3; axis++)
                along[i] += strength * scale * slope[i][axis] * direction[axis];
        }
    }
}

REFERENCE(vectorTurbulence)
{
    Octaves o = octaves_of(args, NO_REST, args + 3, 0);
    double along[3];
    vector_turbulence(context, &o, NO_REST, result, along);
}

REFERENCE(vectorTurbulenceFiltered)
{
    Octaves o = octaves_of(args, args + 3, args + 6, args[9]);
    double along[3];
    vector_turbulence(context, &o, NO_REST, result, along);
}

REFERENCE(vectorTurbulenceAlong)
{
    Octaves o = octaves_of(args, args + 3, args + 6, args[9]);
    double value[3];
    vector_turbulence(context, &o, args + 10, value, result);
}

static void granite(const void *context, const double *args, double result[4])
{
    for (int i = 0; i < 4; i++)
        result[i] = 0;
    for (int k = 0; k < GRANITE_OCTAVES; k++) {
        double scale = ldexp(4, k), strength = ldexp(1, -k), gradient[3],
               mean = statistics(context).magnitude;
        double value = noise_at(context, args, args + 3, scale, gradient);
        double share = magnitude_share(context, scale * args[6]), side = value < 0 ? -1 : 1;
        for (int i = 0; i < 3; i++)
            result[i] += strength * share * scale * side * gradient[i];
        result[3] += strength * (mean + share * (fabs(value) - mean) - .5);
    }
}

REFERENCE(graniteFiltered)
{
    double all[4];
    granite(context, args, all);
    result[0] = all[3];
}

REFERENCE(graniteGradient) { granite(context, args, result); }

REFERENCE(graniteVariance)
{
    result[0] = 0;
    for (int k = 0; k < GRANITE_OCTAVES; k++) {
        double width = args[0] * ldexp(4, k);
        result[0] += ldexp(.081, -2 * k) *
                     left_out(context, lost(context, width, of_magnitude), width, 14.6);
    }
}
