/* Prints the polynomials of areaMicrofacets() in runtime/surface/surface_microfacets.glsl:
 * linearly transformed cosines that approximate GGX (Heitz, Dupuy, Hill and Neubelt 2016), by
 * roughness and the eye's angle, and their errors against the fitted matrices.
 *
 *   build/tests/fit_area          # a minute
 *
 * A direction o with density cosine / pi is mapped to M o, M = [X Y Z] (m11 0 m13; 0 m22 0; 0 0
 * 1), normalized: Z is the lobe's mean direction, X is perpendicular to Z in the plane of normal
 * and eye. m11, m22 and m13 minimize the squared difference to the lobe, over directions sampled
 * from either distribution. With a = roughness^2, c the eye's cosine and d the angle from Z to
 * the mirrored direction, m11 / a, m22 / (a (c + a)), m13 / a and d / a change little, and are
 * polynomials in the roughness and in x = c (1 + a) / (c + a). A printed line has these four
 * coefficients; lines are ordered by powers of the roughness, and their groups by powers of x. */
#include "tests/fits/solve.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

enum {
    PARTS = 4,
    ANGLES = 6,
    ROUGHS = 6,
    TERMS = ANGLES * ROUGHS,
    ROUGHNESSES = 21,
    COSINES = 17,
    SIDES = 32
};

typedef struct {
    double alpha, eye[3], albedo, mean[3]; /* mean: Z */
} Microfacets;

typedef struct {
    double rough, cosine, found[PARTS], weight;
} Sample;

static double lambda(double alpha, double cosine)
{
    return (sqrt(1 + alpha * alpha * (1 / (cosine * cosine) - 1)) - 1) / 2;
}

/* Value of the lobe in a direction, for a Fresnel term of 1, and the density of sampled normals;
 * 0 below the horizon. */
static double lobe(const Microfacets *f, const double l[3], double *density)
{
    *density = 0;
    if (l[2] <= 0)
        return 0;
    double h[3] = {f->eye[0] + l[0], f->eye[1] + l[1], f->eye[2] + l[2]};
    const double size = dot(h, h), high = h[2] * h[2] / size,
                 across = (h[0] * h[0] + h[1] * h[1]) / size, a2 = f->alpha * f->alpha;
    const double width = a2 * high + across, own = lambda(f->alpha, f->eye[2]),
                 d = a2 / (PI * width * width) / (4 * f->eye[2]);
    *density = d / (1 + own);
    return d / (1 + own + lambda(f->alpha, l[2])) / f->albedo;
}

/* Reflects at a sampled visible normal (Heitz 2018), by two numbers in (0, 1). */
static void choose(const Microfacets *f, const double u[2], double l[3])
{
    const double x = f->alpha * f->eye[0], size = hypot(x, f->eye[2]),
                 w[2] = {x / size, f->eye[2] / size};
    const double r = sqrt(u[0]), t = r * cos(2 * PI * u[1]), k = .5 + .5 * w[1];
    const double s = (1 - k) * sqrt(fmax(1 - t * t, 0)) + k * r * sin(2 * PI * u[1]),
                 up = sqrt(fmax(1 - t * t - s * s, 0));
    double h[3] = {f->alpha * (s * -w[1] + up * w[0]), f->alpha * t,
                   fmax(s * w[0] + up * w[1], 1e-9)};
    const double length = sqrt(dot(h, h)), facing = dot(h, f->eye) / length;
    for (int i = 0; i < 3; i++)
        l[i] = 2 * facing * h[i] / length - f->eye[i];
}

static void place(double alpha, double cosine, Microfacets *f)
{
    enum { MANY = 64 };
    *f = (Microfacets){
        .alpha = alpha, .eye = {sqrt(fmax(1 - cosine * cosine, 0)), 0, cosine}, .albedo = 1};
    double sum = 0, mean[3] = {0};
    for (int i = 0; i < MANY * MANY; i++) {
        double l[3], density;
        choose(f, (const double[]){(i / MANY + .5) / MANY, (i % MANY + .5) / MANY}, l);
        const double share = lobe(f, l, &density) / fmax(density, 1e-300);
        if (density <= 0)
            continue;
        sum += share;
        mean[0] += share * l[0], mean[2] += share * l[2];
    }
    const double length = hypot(mean[0], mean[2]);
    f->albedo = sum / (MANY * MANY);
    f->mean[0] = cosine < 1 ? mean[0] / length : 0;
    f->mean[2] = cosine < 1 ? mean[2] / length : 1;
}

static double transformed(const Microfacets *f, const double m[3], const double l[3])
{
    const double x = l[0] * f->mean[2] - l[2] * f->mean[0], z = dot(l, f->mean);
    const double o[3] = {(x - m[2] * z) / m[0], l[1] / m[1], z}, length = sqrt(dot(o, o));
    return z <= 0 ? 0 : z / length / (PI * m[0] * m[1] * pow(length, 3));
}

static double difference(const Microfacets *f, const double m[3])
{
    if (m[0] < 1e-5 || m[1] < 1e-5)
        return INFINITY;
    double sum = 0;
    for (int i = 0; i < 2 * SIDES * SIDES; i++) {
        const double u[2] = {(i / 2 / SIDES + .5) / SIDES, (i / 2 % SIDES + .5) / SIDES};
        double l[3], density;
        if (i % 2) {
            const double r = sqrt(u[0]), z = sqrt(1 - u[0]),
                         x = m[0] * r * cos(2 * PI * u[1]) + m[2] * z,
                         y = m[1] * r * sin(2 * PI * u[1]);
            const double length = sqrt(x * x + y * y + z * z);
            l[0] = (x * f->mean[2] + z * f->mean[0]) / length, l[1] = y / length,
            l[2] = (z * f->mean[2] - x * f->mean[0]) / length;
        } else
            choose(f, u, l);
        const double want = lobe(f, l, &density), have = transformed(f, m, l);
        if (density + have > 0)
            sum += (want - have) * (want - have) / (density + have);
    }
    return sum;
}

/* Nelder and Mead's simplex method, starting at m. */
static void descend(const Microfacets *f, double step, double m[3])
{
    double corner[4][3], value[4];
    for (int i = 0; i < 4; i++) {
        memcpy(corner[i], m, sizeof corner[i]);
        if (i)
            corner[i][i - 1] += step * fmax(fabs(m[i - 1]), .02);
        value[i] = difference(f, corner[i]);
    }
    for (int turn = 0; turn < 120; turn++) {
        int best = 0, worst = 0, second;
        for (int i = 1; i < 4; i++)
            best = value[i] < value[best] ? i : best, worst = value[i] > value[worst] ? i : worst;
        if (value[worst] - value[best] < 1e-6 * value[best])
            break;
        second = best;
        for (int i = 0; i < 4; i++)
            second = i != worst && value[i] > value[second] ? i : second;
        double others[3] = {0}, tried[3], far[3];
        for (int i = 0; i < 4; i++)
            for (int k = 0; k < 3; k++)
                others[k] += i == worst ? 0 : corner[i][k] / 3;
        for (int k = 0; k < 3; k++)
            tried[k] = 2 * others[k] - corner[worst][k],
            far[k] = 3 * others[k] - 2 * corner[worst][k];
        double at = difference(f, tried);
        const double farther = at < value[best] ? difference(f, far) : INFINITY;
        if (farther < at)
            memcpy(tried, far, sizeof far), at = farther;
        if (at >= value[second]) {
            for (int k = 0; k < 3; k++)
                tried[k] = .5 * others[k] + .5 * corner[worst][k];
            at = difference(f, tried);
        }
        const bool better = at < value[worst];
        for (int i = 0; i < 4; i++) {
            if (better ? i != worst : i == best)
                continue;
            for (int k = 0; k < 3; k++)
                corner[i][k] = better ? tried[k] : .5 * (corner[i][k] + corner[best][k]);
            value[i] = better ? at : difference(f, corner[i]);
        }
    }
    int best = 0;
    for (int i = 1; i < 4; i++)
        best = value[i] < value[best] ? i : best;
    memcpy(m, corner[best], sizeof corner[best]);
}

/* Rough ones first; each fit starts from the previous one. */
static int find_samples(Sample *samples)
{
    double first[3] = {1, 1, 0};
    int count = 0;
    for (int i = ROUGHNESSES - 1; i >= 0; i--) {
        const double rough = .0316227766 + .9683772234 * i / (ROUGHNESSES - 1),
                     alpha = rough * rough;
        double m[3];
        for (int j = 0; j < COSINES; j++) {
            const double t = (double)j / (COSINES - 1),
                         cosine = j == COSINES - 1 ? .01 : 1 - .997 * t * t;
            Microfacets f;
            place(alpha, cosine, &f);
            if (j == 0) { /* isotropic at normal incidence */
                for (int k = 0; k < 3; k++)
                    m[k] = first[k] * alpha;
                if (rough > .2)
                    descend(&f, .05, m);
                m[0] = m[1] = rough > .2 ? .5 * (m[0] + m[1]) : 2 * alpha, m[2] = 0;
                for (int k = 0; k < 3; k++)
                    first[k] = m[k] / alpha;
            } else {
                descend(&f, .1, m);
                descend(&f, .03, m);
            }
            const double off = acos(cosine) - atan2(-f.mean[0], f.mean[2]);
            samples[count++] =
                (Sample){rough,
                         cosine,
                         {m[0] / alpha, m[1] / alpha / (cosine + alpha), m[2] / alpha, off / alpha},
                         1};
        }
    }
    return count;
}

static void fill_terms(const Sample *s, double terms[TERMS])
{
    const double alpha = s->rough * s->rough, x = s->cosine * (1 + alpha) / (s->cosine + alpha);
    for (int i = 0; i < TERMS; i++)
        terms[i] = pow(x, i / ROUGHS) * pow(s->rough, i % ROUGHS);
}

static double error_of(const Sample *s, int part, const double solution[TERMS])
{
    double terms[TERMS], sum = 0;
    fill_terms(s, terms);
    for (int k = 0; k < TERMS; k++)
        sum += solution[k] * terms[k];
    return fabs(sum - s->found[part]);
}

static void solve(const Sample *samples, int count, int part, double solution[TERMS])
{
    double rows[TERMS][TERMS + 1] = {{0}}, terms[TERMS], trace = 0;
    for (int i = 0; i < count; i++) {
        fill_terms(&samples[i], terms);
        for (int k = 0; k < TERMS; k++) {
            for (int l = 0; l < TERMS; l++)
                rows[k][l] += samples[i].weight * terms[k] * terms[l];
            rows[k][TERMS] += samples[i].weight * terms[k] * samples[i].found[part];
        }
    }
    for (int k = 0; k < TERMS; k++)
        trace += rows[k][k];
    for (int k = 0; k < TERMS; k++)
        /* regularization, so that coefficients stay small enough for floats */
        rows[k][k] += 1e-12 * trace / TERMS;
    solve_equations(rows[0], TERMS);
    for (int k = 0; k < TERMS; k++)
        solution[k] = rows[k][TERMS];
}

int main(void)
{
    static Sample samples[ROUGHNESSES * COSINES];
    double solution[PARTS][TERMS];
    const int count = find_samples(samples);
    for (int part = 0; part < PARTS; part++) {
        double worst = 0;
        for (int i = 0; i < count; i++)
            samples[i].weight = 1;
        for (int step = 0; step < 5; step++) {
            solve(samples, count, part, solution[part]);
            for (int i = 0; i < count; i++)
                samples[i].weight *= .7 + error_of(&samples[i], part, solution[part]) / .05;
        }
        for (int i = 0; i < count; i++)
            worst = fmax(worst,
                         samples[i].cosine < .02 ? 0 : error_of(&samples[i], part, solution[part]));
        printf("%s: within %.3f\n",
               (const char *[]){"m11 / a", "m22 / (a (c + a))", "m13 / a", "d / a"}[part], worst);
    }
    for (int k = 0; k < TERMS; k++)
        printf("vec4(%.6g, %.6g, %.6g, %.6g)\n", solution[0][k], solution[1][k], solution[2][k],
               solution[3][k]);
    return 0;
}
