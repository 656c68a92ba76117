/* Prints the thin film constants of runtime/surface/surface_microfacets.glsl: the response of
 * linear sRGB components to light of strength cos(2 pi way / wavelength), as sums of terms
 * exp(-narrow way^2) cos(turn way), with way in micrometers. The CIE's observer of 1931 is that
 * of Wyman, Sloan and Shirley (2013); a component's response is 1 for way 0.
 *
 *   build/tests/fit_film          # some seconds
 *
 * The terms' frequencies and widths are changed in turn while the sum of squares decreases;
 * their weights follow by linear least squares. */
#include "tests/fits/solve.h"
#include "tests/fits/observer.h"
#include <math.h>
#include <stdio.h>

enum { TERMS = 4, WAYS = 251, ROUNDS = 400 };
static const double FARTHEST = 5;

typedef struct {
    double turn[TERMS], narrow[TERMS], weight[3][TERMS], square;
} Fit;

static double way_at(int i) { return FARTHEST * i / (WAYS - 1); }

static double term(const Fit *f, int k, double way)
{
    return exp(-f->narrow[k] * way * way) * cos(f->turn[k] * way);
}

static void weigh(Fit *f, double (*want)[3])
{
    f->square = 0;
    for (int component = 0; component < 3; component++) {
        double rows[TERMS * (TERMS + 1)] = {0};
        for (int i = 0; i < WAYS; i++) {
            const double weight = i ? 1 : 1e4; /* the sums must give white for way 0 */
            for (int a = 0; a < TERMS; a++) {
                for (int b = 0; b < TERMS; b++)
                    rows[a * (TERMS + 1) + b] +=
                        weight * term(f, a, way_at(i)) * term(f, b, way_at(i));
                rows[a * (TERMS + 1) + TERMS] +=
                    weight * term(f, a, way_at(i)) * want[i][component];
            }
        }
        solve_equations(rows, TERMS);
        for (int k = 0; k < TERMS; k++)
            f->weight[component][k] = rows[k * (TERMS + 1) + TERMS];
        for (int i = 0; i < WAYS; i++) {
            double sum = -want[i][component];
            for (int k = 0; k < TERMS; k++)
                sum += f->weight[component][k] * term(f, k, way_at(i));
            f->square += sum * sum;
        }
    }
}

/* Response of the components, as a sum over wavelengths. */
static void respond(double way, double components[3])
{
    double sum[3] = {0}, white[3] = {0}, one[3];
    for (int nm = OBSERVER_FIRST; nm <= OBSERVER_LAST; nm++) {
        observer_components(nm, one);
        for (int component = 0; component < 3; component++) {
            white[component] += one[component];
            sum[component] += one[component] * cos(6.28318530717958648 * way / (nm * 1e-3));
        }
    }
    for (int component = 0; component < 3; component++)
        components[component] = sum[component] / white[component];
}

int main(void)
{
    static double want[WAYS][3];
    const double starts[TERMS] = {.60, .56, .50, .45};
    Fit best = {0};
    double worst = 0;
    for (int i = 0; i < WAYS; i++)
        respond(way_at(i), want[i]);
    for (int k = 0; k < TERMS; k++) {
        best.turn[k] = 6.28318530717958648 / starts[k];
        best.narrow[k] = .35;
    }
    weigh(&best, want);
    double step = .2;
    for (int round = 0; round < ROUNDS; round++) {
        const double before = best.square;
        for (int i = 0; i < 4 * TERMS; i++) {
            Fit other = best;
            double *number = i / 2 < TERMS ? &other.turn[i / 2] : &other.narrow[i / 2 - TERMS];
            *number *= i % 2 ? 1 + step : 1 / (1 + step);
            weigh(&other, want);
            best = other.square < best.square ? other : best;
        }
        step = best.square < before ? step : step / 2;
    }
    for (int i = 0; i < WAYS; i++)
        for (int component = 0; component < 3; component++) {
            double sum = -want[i][component];
            for (int k = 0; k < TERMS; k++)
                sum += best.weight[component][k] * term(&best, k, way_at(i));
            worst = fmax(worst, fabs(sum));
        }
    for (int k = 0; k < TERMS; k++)
        printf("turn %.6g narrow %.6g weights %.6g %.6g %.6g\n", best.turn[k], best.narrow[k],
               best.weight[0][k], best.weight[1][k], best.weight[2][k]);
    printf("within %.4f, root of the mean square %.5f\n", worst, sqrt(best.square / (3 * WAYS)));
    return 0;
}
