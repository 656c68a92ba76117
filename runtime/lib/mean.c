/* Means over boxes, from antiderivatives in double precision. Arguments: the place, the box's edge. */
#include "runtime/reference.h"

enum { PIECES = 4096 };

typedef double Wave(double v);

/* By the midpoint rule, which needs no antiderivative: a box of at most some periods in thousands of pieces. */
static double box_mean(Wave *wave, double v, double edge)
{
    double sum = 0;
    if (edge <= 1e-6)
        return wave(v);
    for (int i = 0; i < PIECES; i++)
        sum += wave(v + edge * ((i + .5) / PIECES - .5));
    return sum / PIECES;
}

static double stripe(double v) { return fraction(v) < .5 ? 1 : -1; }
static double ramp(double v) { return 2 * fraction(v) - 1; }
static double cubic(double v) { return fraction(v) * fraction(v) * (6 - 4 * fraction(v)) - 1; }
static double triangle(double v) { return fabs(4 * fraction(v - .25) - 2) - 1; }
static double scallop(double v) { return 2 * fabs(sin(M_PI * v)) - 1; }

/* Exact: the antiderivative of the stripes is a triangle of period 1. */
static double stripe_mean(double v, double edge)
{
    double a = v - edge / 2, b = v + edge / 2;
    if (edge <= 1e-6)
        return stripe(v);
    return (fabs(fraction(a) - .5) - fabs(fraction(b) - .5)) / edge;
}

static void stripes(const double *args, int lanes, double *result)
{
    for (int i = 0; i < lanes; i++)
        result[i] = stripe_mean(args[i], args[lanes + i]);
}

static void rates(const double *args, int lanes, double *result)
{
    for (int i = 0; i < lanes; i++) {
        double v = args[i], edge = fmax(args[lanes + i], 1e-12);
        result[i] = (stripe(v + edge / 2) - stripe(v - edge / 2)) / edge;
    }
}

REFERENCE(stripes2) { (void)context, stripes(args, 2, result); }
REFERENCE(stripes3) { (void)context, stripes(args, 3, result); }
static double stripes_along(const double *args, int lanes)
{
    double sum = 0;
    for (int i = 0; i < 4; i++) {
        double product = 1;
        for (int lane = 0; lane < lanes; lane++)
            product *= stripe_mean(args[lane] + ((i + .5) / 4 - .5) * args[lanes + lane], args[2 * lanes + lane]);
        sum += product / 4;
    }
    return sum;
}

REFERENCE(stripesAlong2) { (void)context, result[0] = stripes_along(args, 2); }
REFERENCE(stripesAlong3) { (void)context, result[0] = stripes_along(args, 3); }
REFERENCE(stripesRate2) { (void)context, rates(args, 2, result); }
REFERENCE(stripesRate3) { (void)context, rates(args, 3, result); }

REFERENCE(sincMean)
{
    (void)context;
    double h = args[0] / 2;
    result[0] = fabs(h) < 1e-9 ? 1 : sin(h) / h;
}

REFERENCE(rampMean) { (void)context, result[0] = box_mean(ramp, args[0], args[1]); }
REFERENCE(cubicMean) { (void)context, result[0] = box_mean(cubic, args[0], args[1]); }
REFERENCE(triangleMean) { (void)context, result[0] = box_mean(triangle, args[0], args[1]); }
REFERENCE(scallopMean) { (void)context, result[0] = box_mean(scallop, args[0], args[1]); }

static double end_rate(Wave *wave, const double *args)
{
    double edge = fmax(args[1], 1. / 256);
    return (wave(args[0] + edge / 2) - wave(args[0] - edge / 2)) / edge;
}

REFERENCE(rampRate) { (void)context, result[0] = end_rate(ramp, args); }
REFERENCE(cubicRate) { (void)context, result[0] = end_rate(cubic, args); }
REFERENCE(triangleRate) { (void)context, result[0] = end_rate(triangle, args); }
REFERENCE(scallopRate) { (void)context, result[0] = end_rate(scallop, args); }

/* Arguments: root, then columns and offset, each as three numbers that are added. */
static double affine(const double *args, int lane)
{
    double sum = 0;
    for (int column = 0; column < 4; column++)
        for (int part = 0; part < 3; part++)
            sum += args[3 + 9 * column + 3 * part + lane] * (column < 3 ? args[column] : 1);
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
