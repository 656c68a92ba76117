/* Prints the polynomials of runtime/surface/surface_microfacets.glsl for a rough diffuse base,
 * and the error of each against its integral. With S the sine,
 *
 *   G(c, k) = S(c) / pi * the integral over c' from 0 to 1 of
 *             S(c') (1 / max(c, c') - 1) (1 - c')^k 2 c' dc'
 *
 * is the part of Fujii's lobe that exceeds a Lambertian one, averaged over azimuths, for light
 * that arrives weighted by (1 - c')^k; k is 0 for all of the light, 1 for approximately the
 * share that fuzz takes, 5 for the share of Schlick's formula. J(i, k) is the mean of (1 - c)^i
 * G(c, k) over all directions.
 *
 *   build/tests/fit_diffuse
 *
 * G(1, k) is 0, so a polynomial in 1 - c has no constant term. The fits are iteratively
 * reweighted least squares, which lowers the greatest error. */
#include "tests/fits/solve.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdio.h>

enum { TERMS = 4, ANGLES = 400, STEPS = 2000, ROUNDS = 100, KINDS = 3 };
static const int power_of[KINDS] = {0, 1, 5};

/* Midpoint rule over the angle above the horizon, whose sine is c'. */
static double part(double from, double to, double cosine, int power)
{
    double sum = 0;
    for (int i = 0; i < STEPS && to > from; i++) {
        const double angle = from + (to - from) * (i + .5) / STEPS, c = sin(angle), s = cos(angle);
        sum += s * s * (1 / fmax(c, cosine) - 1) * pow(1 - c, power) * 2 * c * (to - from) / STEPS;
    }
    return sum;
}

static double beyond_even(double cosine, int power)
{
    const double at = asin(cosine), sine = sqrt(fmax(1 - cosine * cosine, 0));
    return sine / PI * (part(0, at, cosine, power) + part(at, PI / 2, cosine, power));
}

static void fit(int power)
{
    static double value[ANGLES], weight[ANGLES];
    double terms[TERMS] = {0}, worst = 0;
    for (int i = 0; i < ANGLES; i++)
        value[i] = beyond_even(i / (ANGLES - 1.), power), weight[i] = 1;
    for (int round = 0; round < ROUNDS; round++) {
        double rows[TERMS * (TERMS + 1)] = {0};
        for (int i = 0; i < ANGLES; i++)
            for (int a = 0; a < TERMS; a++)
                for (int b = 0; b <= TERMS; b++)
                    rows[a * (TERMS + 1) + b] +=
                        weight[i] * pow(1 - i / (ANGLES - 1.), a + 1) *
                        (b < TERMS ? pow(1 - i / (ANGLES - 1.), b + 1) : value[i]);
        solve_equations(rows, TERMS);
        for (int k = 0; k < TERMS; k++)
            terms[k] = rows[k * (TERMS + 1) + TERMS];
        worst = 0;
        for (int pass = 0; pass < 2; pass++)
            for (int i = 0; i < ANGLES; i++) {
                double off = -value[i];
                for (int k = 0; k < TERMS; k++)
                    off += terms[k] * pow(1 - i / (ANGLES - 1.), k + 1);
                if (pass)
                    weight[i] *= .5 + fabs(off) / worst;
                worst = fmax(worst, fabs(off));
            }
    }
    printf("G(c, %d): within %.6f\n", power, worst);
    for (int k = 0; k < TERMS; k++)
        printf("%.9g%s", terms[k], k < TERMS - 1 ? ", " : "\n");
}

static double mean(int i, int power)
{
    double sum = 0;
    for (int k = 0; k < ANGLES; k++) {
        const double c = (k + .5) / ANGLES;
        sum += 2 * c * pow(1 - c, i) * beyond_even(c, power) / ANGLES;
    }
    return sum;
}

int main(void)
{
    for (int i = 0; i < KINDS; i++)
        fit(power_of[i]);
    for (int i = 0; i < KINDS; i++)
        for (int k = i; k < KINDS; k++)
            printf("J(%d, %d) = %.9g\n", power_of[i], power_of[k], mean(power_of[i], power_of[k]));
    printf("2/3 - 28 / (15 pi) = %.9g, which is J(0, 0)\n", 2. / 3 - 28 / (15 * PI));
    return 0;
}
