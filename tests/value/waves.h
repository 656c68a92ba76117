/* Waves of semantics.md 2.4, and their integrals, from which means over boxes are made: W(v),
 * and the integral from 0 to v. */
#ifndef MATC_VALUE_WAVES_H
#define MATC_VALUE_WAVES_H

typedef double Curve(double v);

typedef struct {
    const char *name;
    Curve *wave, *area;
    double period; /* 0: aperiodic */
} WaveCurve;

enum { WAVE_CURVES = 11 };
extern const WaveCurve wave_curves[WAVE_CURVES];

/* The fractional part: v - floor(v). */
double part_of(double v);
/* The mean of the function whose integral is `area`, from middle - edge / 2 to middle + edge /
 * 2; an edge of 0 is replaced by a narrow one. */
double mean_between(Curve *area, double middle, double edge);
/* Mean of any function, by the midpoint rule with `slices` slices. */
double mean_of_slices(Curve *curve, double middle, double edge, int slices);

/* Integrals of: a square wave, 1 in the lower half of every period of 1 and -1 in the upper;
 * cosine and sine. */
double area_stripes(double v);
double area_cosine(double v);
double area_sine(double v);
#endif
