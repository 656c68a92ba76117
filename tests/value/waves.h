/* Waves of semantics.md 2.4, and their integrals, from which means over boxes are made: W(v),
 * and the integral from 0 to v. */
#ifndef MATC_VALUE_WAVES_H
#define MATC_VALUE_WAVES_H

typedef double Curve(double v);

typedef struct {
    const char *name;
    Curve *wave, *area;
    double period; /* 0: it has none */
} WaveCurve;

enum { WAVE_CURVES = 11 };
extern const WaveCurve wave_curves[WAVE_CURVES];

/* v less the greatest whole number below. */
double part_of(double v);
/* The mean between middle - edge / 2 and middle + edge / 2 of what `area` is the integral of; an
 * edge of 0 is a narrow one. */
double mean_between(Curve *area, double middle, double edge);
/* Mean of any function, from samples in the middles of so many slices. */
double mean_of_slices(Curve *curve, double middle, double edge, int slices);

/* The integrals of others: what is 1 in the lower half of every period 1 and -1 in the upper;
 * cosine and sine. */
double area_stripes(double v);
double area_cosine(double v);
double area_sine(double v);
#endif
