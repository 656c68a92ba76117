/* Prints the polynomials of runtime/surface/surface_anisotropic.glsl, and their errors against
 * the integrals that they fit: for GGX with widths a along a direction and b across it, the
 * energy lost to single scattering and the fifth root of the grazing term.
 *
 *   build/tests/fit_anisotropy          # half a minute
 *
 * For a view azimuth, the loss depends almost only on the angle and on the widths along the view
 * and across it. With 2 r^4 = a^2 + b^2 and k = (a^2 - b^2) / (a^2 + b^2), the width along the
 * view is r^2 g, g^2 = 1 + k (v.x^2 - v.y^2), v the direction to the eye, x along. The fit is a
 * polynomial in a number x of the angle, in g and in p, r^2 or r; plus one of lower degrees,
 * times 1 - k^2, for the rest. A printed line has four coefficients, of powers of g from 0 on;
 * lines are ordered by powers of p, and their groups by powers of x. */
#include "tests/fits/solve.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

enum {
    ANGLES = 6, /* powers of x */
    WIDTHS = 4, /* of g */
    ROUGHS = 6, /* of p */
    REST_ANGLES = 4,
    REST_ROUGHS = 4,
    MAIN = ANGLES * ROUGHS * WIDTHS,
    TERMS = MAIN + REST_ANGLES * REST_ROUGHS * WIDTHS,
    MAX_SAMPLES = 9000
};

typedef struct {
    double rough, ratio, width, cosine; /* r, k, g */
    double lost, grazing, weight;
} Sample;

typedef struct {
    Sample samples[MAX_SAMPLES];
    int count;
    bool of_grazing;
    double terms[TERMS];
} Fit;

/* By visible normals (Heitz 2018), at the centers of a grid of rings and azimuths: the energy
 * that microfacets lose, and the albedo of Schlick's (1 - cosine)^5 relative to the rest. */
static void integrate(const double eye[3], const double widths[2], double found[2])
{
    enum { SIDES = 48 };
    const double size =
        sqrt(pow(widths[0] * eye[0], 2) + pow(widths[1] * eye[1], 2) + eye[2] * eye[2]);
    const double w[3] = {widths[0] * eye[0] / size, widths[1] * eye[1] / size, eye[2] / size},
                 flat = hypot(w[0], w[1]);
    const double t[2] = {flat > 1e-8 ? -w[1] / flat : 1, flat > 1e-8 ? w[0] / flat : 0};
    const double b[3] = {-w[2] * t[1], w[2] * t[0], w[0] * t[1] - w[1] * t[0]};
    double all = 0, grazing = 0;
    for (int i = 0; i < SIDES * SIDES; i++) {
        const double r = sqrt((i / SIDES + .5) / SIDES), turn = 2 * PI * (i % SIDES + .5) / SIDES,
                     x = r * cos(turn), k = .5 + .5 * w[2];
        const double y = (1 - k) * sqrt(fmax(1 - x * x, 0)) + k * r * sin(turn),
                     z = sqrt(fmax(1 - x * x - y * y, 0));
        double h[3] = {widths[0] * (x * t[0] + y * b[0] + z * w[0]),
                       widths[1] * (x * t[1] + y * b[1] + z * w[1]), fmax(y * b[2] + z * w[2], 0)};
        const double length = sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]);
        const double facing = (h[0] * eye[0] + h[1] * eye[1] + h[2] * eye[2]) / length;
        double l[3];
        for (int component = 0; component < 3; component++)
            l[component] = 2 * facing * h[component] / length - eye[component];
        if (l[2] <= 0 || facing <= 0)
            continue;
        const double light =
            sqrt(pow(widths[0] * l[0], 2) + pow(widths[1] * l[1], 2) + l[2] * l[2]);
        const double share =
            l[2] * (eye[2] + size) / (eye[2] * light + l[2] * size) / (SIDES * SIDES);
        all += share;
        grazing += share * pow(1 - facing, 5);
    }
    found[0] = 1 - all;
    found[1] = grazing;
}

static void fill_terms(const Sample *s, bool of_grazing, double terms[TERMS])
{
    const double alpha = s->rough * s->rough, along = alpha * s->width,
                 p = of_grazing ? s->rough : alpha;
    const double x =
        of_grazing ? sqrt(s->cosine + .5 * along) : s->cosine * (1 + along) / (s->cosine + along);
    for (int i = 0; i < TERMS; i++) {
        const int own = i < MAIN ? i : i - MAIN, roughs = i < MAIN ? ROUGHS : REST_ROUGHS,
                  line = own / WIDTHS;
        terms[i] = (i < MAIN ? 1 : 1 - s->ratio * s->ratio) * pow(s->width, own % WIDTHS) *
                   pow(p, line % roughs) * pow(x, line / roughs);
    }
}

static double aim(const Sample *s, bool of_grazing)
{
    return of_grazing ? pow(s->grazing / (1 - s->lost), .2) : s->lost;
}

static double error_of(const Fit *fit, const Sample *s)
{
    double terms[TERMS], sum = 0;
    fill_terms(s, fit->of_grazing, terms);
    for (int k = 0; k < TERMS; k++)
        sum += fit->terms[k] * terms[k];
    sum = fmin(fmax(sum, 0), 1);
    return fit->of_grazing ? fabs((1 - s->lost) * pow(sum, 5) - s->grazing) : fabs(sum - s->lost);
}

static void solve(Fit *fit)
{
    static double rows[TERMS][TERMS + 1];
    double trace = 0;
    memset(rows, 0, sizeof rows);
    for (int i = 0; i < fit->count; i++) {
        const Sample *s = &fit->samples[i];
        double terms[TERMS + 1];
        fill_terms(s, fit->of_grazing, terms);
        terms[TERMS] = aim(s, fit->of_grazing);
        for (int k = 0; k < TERMS; k++)
            for (int l = 0; l <= TERMS; l++)
                rows[k][l] += s->weight * terms[k] * terms[l];
    }
    for (int k = 0; k < TERMS; k++)
        trace += rows[k][k];
    for (int k = 0; k < TERMS; k++)
        /* regularization, so that coefficients stay small enough for floats */
        rows[k][k] += 1e-11 * trace / TERMS;
    solve_equations(rows[0], TERMS);
    for (int k = 0; k < TERMS; k++)
        fit->terms[k] = rows[k][TERMS];
}

static void add_samples(Fit *fit)
{
    enum { ROUGHNESSES = 15, AZIMUTHS = 7, COSINES = 16, RATIOS = 5 };
    static const double across[RATIOS] = {.01, .16, .33, .58, 1}; /* b / a */
    for (int i = 0; i < ROUGHNESSES * RATIOS * AZIMUTHS * COSINES; i++) {
        const int at = i / COSINES / AZIMUTHS;
        const double rough = .0316227766 + .9683772234 * (at / RATIOS) / (ROUGHNESSES - 1),
                     b = across[at % RATIOS];
        const double turn = PI / 2 * (i / COSINES % AZIMUTHS) / (AZIMUTHS - 1),
                     cosine = pow((i % COSINES + .7) / (COSINES - .3), 2);
        const double sine = sqrt(1 - cosine * cosine),
                     eye[3] = {sine * cos(turn), sine * sin(turn), cosine};
        const double ratio = (1 - b * b) / (1 + b * b),
                     wide = rough * rough * sqrt(2 / (1 + b * b));
        double found[2];
        integrate(eye, (const double[]){wide, b * wide}, found);
        Sample *s = &fit->samples[fit->count++];
        *s = (Sample){rough,  ratio,    sqrt(1 + ratio * (eye[0] * eye[0] - eye[1] * eye[1])),
                      cosine, found[0], found[1],
                      1};
    }
}

static void run(Fit *fit, const char *name)
{
    double worst = 0, of_some = 0;
    for (int i = 0; i < fit->count; i++) {
        Sample *s = &fit->samples[i];
        s->weight = fit->of_grazing ? 5 * pow(aim(s, true), 4) * (1 - s->lost) + .02 : 1;
    }
    for (int step = 0; step < 8; step++) {
        solve(fit);
        for (int i = 0; i < fit->count; i++)
            fit->samples[i].weight *=
                .8 + error_of(fit, &fit->samples[i]) / (fit->samples[i].cosine < .03 ? .03 : .012);
    }
    for (int i = 0; i < fit->count; i++) {
        const double error = error_of(fit, &fit->samples[i]);
        worst = fmax(worst, error);
        of_some = fit->samples[i].cosine < .03 ? of_some : fmax(of_some, error);
    }
    printf("%s: within %.4f, and %.4f for cosines from 0.03 on\n", name, worst, of_some);
    for (int k = 0; k < TERMS; k += WIDTHS)
        printf("%svec4(%.7g, %.7g, %.7g, %.7g)\n", k == MAIN ? "times 1 - k^2:\n" : "",
               fit->terms[k], fit->terms[k + 1], fit->terms[k + 2], fit->terms[k + 3]);
}

int main(void)
{
    static Fit fit;
    add_samples(&fit);
    run(&fit, "what facets lose, p r^2, x c (1 + r^2 g) / (c + r^2 g)");
    fit.of_grazing = true;
    run(&fit, "the fifth root of what grazes, p r, x sqrt(c + r^2 g / 2)");
    return 0;
}
