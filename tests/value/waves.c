/* Written from the formulas of semantics.md; integrals by hand. */
#include "waves.h"
#include <math.h>

double part_of(double v) { return v - floor(v); }

double mean_between(Curve *area, double middle, double edge)
{
    double half = fmax(edge, 1e-6) / 2;
    return (area(middle + half) - area(middle - half)) / (2 * half);
}

double mean_of_slices(Curve *curve, double middle, double edge, int slices)
{
    double sum = 0;
    for (int i = 0; i < slices; i++)
        sum += curve(middle + edge * ((i + .5) / slices - .5));
    return sum / slices;
}

double area_stripes(double v) { return .5 - fabs(part_of(v) - .5); }
double area_cosine(double v) { return sin(v); }
double area_sine(double v) { return 1 - cos(v); }

static double area_Abs(double v) { return v * fabs(v) / 2; }
static double area_Floor(double v) { return floor(v) * (floor(v) - 1) / 2 + floor(v) * part_of(v); }
static double area_Ceil(double v) { return area_Floor(-v); }
static double wave_Sqr(double v) { return v * v; }
static double area_Sqr(double v) { return v * v * v / 3; }
static double wave_Sin01(double v) { return sin(2 * M_PI * v); }
static double area_Sin01(double v) { return (1 - cos(2 * M_PI * v)) / (2 * M_PI); }
static double wave_Ramp(double v) { return 2 * part_of(v) - 1; }
static double area_Ramp(double v) { return part_of(v) * part_of(v) - part_of(v); }

static double wave_Cubic(double v)
{
    double t = part_of(v);
    return t * t * (6 - 4 * t) - 1;
}

static double area_Cubic(double v)
{
    double t = part_of(v);
    return 2 * t * t * t - t * t * t * t - t;
}

static double wave_Triangle(double v)
{
    double t = part_of(v);
    return t < .25 ? 4 * t : t < .75 ? 2 - 4 * t : 4 * t - 4;
}

static double area_Triangle(double v)
{
    double t = part_of(v);
    return t < .25 ? 2 * t * t : t < .75 ? 2 * t - 2 * t * t - .25 : 2 * (1 - t) * (1 - t);
}

static double wave_Scallop(double v) { return 2 * fabs(sin(M_PI * v)) - 1; }
static double area_Scallop(double v)
{
    return floor(v) * (4 / M_PI - 1) + 2 / M_PI * (1 - cos(M_PI * part_of(v))) - part_of(v);
}

const WaveCurve wave_curves[WAVE_CURVES] = {
    {"Abs", fabs, area_Abs, 0},
    {"Ceil", ceil, area_Ceil, 0},
    {"Floor", floor, area_Floor, 0},
    {"Sqr", wave_Sqr, area_Sqr, 0},
    {"Cos", cos, area_cosine, 2 * M_PI},
    {"Sin", sin, area_sine, 2 * M_PI},
    {"Sin01", wave_Sin01, area_Sin01, 1},
    {"Ramp", wave_Ramp, area_Ramp, 1},
    {"Cubic", wave_Cubic, area_Cubic, 1},
    {"Triangle", wave_Triangle, area_Triangle, 1},
    {"Scallop", wave_Scallop, area_Scallop, 1},
};
