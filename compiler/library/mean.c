/* Means over boxes, computed from antiderivatives in double precision. Arguments: the position,
 * then the box's edge. */
#include "compiler/library/reference.h"

typedef double Wave(double v);

static const double NARROW = 1e-9; /* A narrower box returns the point value: the difference of two
                                      integrals would cancel. */
static const double POINT =
    /* A narrower box over a jump returns the point value: GLSL's distance to the jump has no
     * digits. */
    1e-6;

/* A wave of period 1 and its antiderivative over [0, 1], which is 0 at 0. */
typedef struct {
    Wave *wave, *integral;
} Periodic;

static double integral_to(const Periodic *p, double v)
{
    return floor(v) * p->integral(1) + p->integral(fraction(v));
}

static double box_mean(const Periodic *p, double v, double edge)
{
    double t = fraction(v);
    return edge <= NARROW ? p->wave(t)
                          : (integral_to(p, t + edge / 2) - integral_to(p, t - edge / 2)) / edge;
}

static double stripe(double v) { return fraction(v) < .5 ? 1 : -1; }
static double ramp(double t) { return 2 * t - 1; }
static double ramp_integral(double t) { return t * (t - 1); }
static double cubic(double t) { return t * t * (6 - 4 * t) - 1; }
static double cubic_integral(double t) { return t * (t * t * (2 - t) - 1); }
static double triangle(double t) { return fabs(4 * fraction(t - .25) - 2) - 1; }
static double triangle_integral(double t)
{
    return t < .25 ? 2 * t * t : t < .75 ? .25 - 2 * (t - .5) * (t - .5) : 2 * (t - 1) * (t - 1);
}
static double scallop(double t) { return 2 * sin(M_PI * t) - 1; }
static double scallop_integral(double t) { return 2 / M_PI * (1 - cos(M_PI * t)) - t; }

/* Exact: the antiderivative of the stripes is a triangle of period 1. */
static double stripe_mean(double v, double edge)
{
    double a = v - edge / 2, b = v + edge / 2;
    if (edge <= POINT)
        return v < .5 ? 1 : -1; /* numbers just below 1 round to 1 */
    return (fabs(fraction(a) - .5) - fabs(fraction(b) - .5)) / edge;
}

static void stripes(const double *args, int components, double *result)
{
    for (int i = 0; i < components; i++)
        result[i] = stripe_mean(args[i], args[components + i]);
}

static void rates(const double *args, int components, double *result)
{
    for (int i = 0; i < components; i++) {
        double v = args[i], edge = args[components + i];
        result[i] = edge <= POINT ? 0 : (stripe(v + edge / 2) - stripe(v - edge / 2)) / edge;
    }
}

REFERENCE(stripes2) { (void)context, stripes(args, 2, result); }
REFERENCE(stripes3) { (void)context, stripes(args, 3, result); }
static double stripes_along(const double *args, int components)
{
    double sum = 0;
    for (int i = 0; i < 4; i++) {
        double product = 1;
        for (int component = 0; component < components; component++)
            product *=
                stripe_mean(args[component] + ((i + .5) / 4 - .5) * args[components + component],
                            args[2 * components + component]);
        sum += product / 4;
    }
    return sum;
}

/* Derivative of the product over the four boxes: changes one factor at a time. */
static void stripes_along_rate(const double *args, int components, double *result)
{
    for (int by = 0; by < components; by++)
        result[by] = 0;
    for (int i = 0; i < 4; i++) {
        double box[6], mean[3], rate[3];
        for (int component = 0; component < components; component++) {
            box[component] = args[component] + ((i + .5) / 4 - .5) * args[components + component];
            box[components + component] = args[2 * components + component];
        }
        stripes(box, components, mean);
        rates(box, components, rate);
        for (int by = 0; by < components; by++) {
            double product = rate[by] / 4;
            for (int component = 0; component < components; component++)
                product *= component == by ? 1 : mean[component];
            result[by] += product;
        }
    }
}

REFERENCE(stripesAlong2) { (void)context, result[0] = stripes_along(args, 2); }
REFERENCE(stripesAlong3) { (void)context, result[0] = stripes_along(args, 3); }
REFERENCE(stripesAlongRate2) { (void)context, stripes_along_rate(args, 2, result); }
REFERENCE(stripesAlongRate3) { (void)context, stripes_along_rate(args, 3, result); }
REFERENCE(stripesRate2) { (void)context, rates(args, 2, result); }
REFERENCE(stripesRate3) { (void)context, rates(args, 3, result); }

REFERENCE(sincMean)
{
    (void)context;
    double h = args[0] / 2;
    result[0] = fabs(h) < 1e-9 ? 1 : sin(h) / h;
}

/* Returns the mean of a wave with a jump: a narrow box returns the point value, as in GLSL. */
static double jump_mean(const Periodic *p, double v, double edge)
{
    return edge <= POINT ? p->wave(fraction(v)) : box_mean(p, v, edge);
}

REFERENCE(rampMean)
{
    (void)context, result[0] = jump_mean(&(Periodic){ramp, ramp_integral}, args[0], args[1]);
}
REFERENCE(cubicMean)
{
    (void)context, result[0] = jump_mean(&(Periodic){cubic, cubic_integral}, args[0], args[1]);
}
REFERENCE(triangleMean)
{
    (void)context, result[0] = box_mean(&(Periodic){triangle, triangle_integral}, args[0], args[1]);
}
REFERENCE(scallopMean)
{
    (void)context, result[0] = box_mean(&(Periodic){scallop, scallop_integral}, args[0], args[1]);
}

/* Returns the derivative of a box mean: the wave's difference between the box's ends over the
 * edge. A box narrower than `point` returns the wave's slope. */
static double end_rate(Wave *wave, Wave *slope, const double *args, double point)
{
    double t = fraction(args[0]), edge = args[1];
    return edge <= point ? slope(t)
                         : (wave(fraction(t + edge / 2)) - wave(fraction(t - edge / 2))) / edge;
}

static double ramp_slope(double t)
{
    (void)t;
    return 2;
}
static double cubic_slope(double t) { return 12 * t * (1 - t); }
static double triangle_slope(double t)
{
    return t == .25 || t == .75 ? 0 : t < .25 || t > .75 ? 4 : -4;
}
static double scallop_slope(double t) { return 2 * M_PI * cos(M_PI * t); }

REFERENCE(rampRate) { (void)context, result[0] = end_rate(ramp, ramp_slope, args, POINT); }
REFERENCE(cubicRate) { (void)context, result[0] = end_rate(cubic, cubic_slope, args, POINT); }
REFERENCE(triangleRate)
{
    (void)context, result[0] = end_rate(triangle, triangle_slope, args, NARROW);
}
REFERENCE(scallopRate)
{
    (void)context, result[0] = end_rate(scallop, scallop_slope, args, NARROW);
}

/* M root + offset. Arguments: root, then three columns and the offset, each as a sum of three
 * vectors. */
static double affine(const double *args, int component)
{
    double sum = 0;
    for (int column = 0; column < 4; column++)
        for (int part = 0; part < 3; part++)
            sum += args[3 + 9 * column + 3 * part + component] * (column < 3 ? args[column] : 1);
    return sum;
}

REFERENCE(affineWhole)
{
    (void)context;
    for (int i = 0; i < 3; i++)
        result[i] = floor(affine(args, i) + .5);
}

REFERENCE(affineFraction)
{
    (void)context;
    for (int i = 0; i < 3; i++)
        result[i] = affine(args, i) - floor(affine(args, i) + .5);
}
