/* Prints the polynomials of runtime/surface/surface_microfacets.glsl, and the error of each
 * against the integrals that it fits: the energy lost by microfacets and the grazing term, by
 * roughnessOf(); the energy that a white rough mirror lacks below a coat and below fuzz, by
 * coatSpread() and fuzzSpread().
 *
 *   build/tests/fit_principled          # some seconds
 *
 * A row is a power of x, a column one of r. Fits are iteratively reweighted least squares of
 * `scale` times the polynomial, which lowers the greatest error. */
#include "tests/fits/solve.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { DEGREES = 6, TERMS = DEGREES * DEGREES, MAX_SAMPLES = 8192 };

typedef struct {
    double r, x, value, scale, weight;
    double allowed;      /* an error of this size about doubles the weight */
    double share, power; /* the error is share |p^power - value^power| */
} Sample;

typedef struct {
    Sample samples[MAX_SAMPLES];
    int count;
    double terms[TERMS];
    double ridge, keep; /* regularization; share of a weight kept at each step */
} Fit;

static double term(int k, const Sample *s)
{
    return pow(s->r, k % DEGREES) * pow(s->x, k / DEGREES);
}

static double polynomial(const Fit *fit, const Sample *s)
{
    double sum = 0;
    for (int k = 0; k < TERMS; k++)
        sum += fit->terms[k] * term(k, s);
    return s->scale * sum;
}

static double error_of(const Fit *fit, const Sample *s)
{
    return s->share * fabs(pow(fmax(polynomial(fit, s), s->power > 1 ? 0 : -1), s->power) -
                           pow(s->value, s->power));
}

static void solve(Fit *fit)
{
    double a[TERMS][TERMS + 1] = {{0}};
    for (int i = 0; i < fit->count; i++) {
        const Sample *s = &fit->samples[i];
        double row[TERMS + 1];
        for (int k = 0; k < TERMS; k++)
            row[k] = s->weight * s->scale * term(k, s);
        row[TERMS] = s->weight * s->value;
        for (int k = 0; k < TERMS; k++)
            for (int l = 0; l <= TERMS; l++)
                a[k][l] += row[k] * row[l];
    }
    for (int k = 0; k < TERMS; k++)
        a[k][k] += fit->ridge;
    solve_equations(a[0], TERMS);
    for (int k = 0; k < TERMS; k++)
        fit->terms[k] = a[k][TERMS];
}

static void run(Fit *fit, const char *name, int steps, double raise)
{
    double worst = 0;
    for (int step = 0; step < steps; step++) {
        solve(fit);
        for (int i = 0; i < fit->count; i++)
            if (fit->samples[i].allowed > 0)
                fit->samples[i].weight *=
                    fit->keep + error_of(fit, &fit->samples[i]) / fit->samples[i].allowed;
    }
    for (int i = 0; i < fit->count; i++)
        worst = fit->samples[i].allowed > 0 ? fmax(worst, error_of(fit, &fit->samples[i])) : worst;
    /* below the white mirror's loss, most light is lost at grazing dielectrics: err on that side */
    fit->terms[0] += raise;
    printf("%s: within %.4f\n", name, worst);
    for (int k = 0; k < TERMS; k++)
        printf("%.9g%s", fit->terms[k], k % DEGREES == DEGREES - 1 ? "\n" : ", ");
}

/* -- GGX with Smith's masking by height, Fresnel's term 1 */

enum { MAX_RAYS = 96 * 64 };
typedef struct {
    /* cosines, and shares of all light sent */
    double light[MAX_RAYS], share[MAX_RAYS];
    int count;
    double all, grazing; /* the sum, and the sum weighted by Schlick's (1 - cosine)^5 */
} Rays;

/* By visible normals (Heitz 2018), at the centers of a grid of rings and azimuths. */
static void find_rays(double cosine, double alpha, const int sides[2], Rays *rays)
{
    const double vx = sqrt(fmax(1 - cosine * cosine, 0)), size = hypot(alpha * vx, cosine),
                 wx = alpha * vx / size, wz = cosine / size;
    const double eye = sqrt(alpha * alpha + (1 - alpha * alpha) * cosine * cosine);
    rays->count = 0, rays->all = rays->grazing = 0;
    for (int i = 0; i < sides[0] * sides[1]; i++) {
        const double r = sqrt((i / sides[1] + .5) / sides[0]),
                     turn = 2 * PI * (i % sides[1] + .5) / sides[1], t = r * cos(turn),
                     k = .5 + .5 * wz;
        const double s = (1 - k) * sqrt(fmax(1 - t * t, 0)) + k * r * sin(turn),
                     up = sqrt(fmax(1 - t * t - s * s, 0));
        const double h[3] = {alpha * (s * -wz + up * wx), alpha * t, fmax(s * wx + up * wz, 0)};
        const double length = sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]),
                     facing = (vx * h[0] + cosine * h[2]) / length,
                     l = 2 * facing * h[2] / length - cosine;
        if (l <= 0 || facing <= 0)
            continue;
        const double light = sqrt(alpha * alpha + (1 - alpha * alpha) * l * l);
        rays->light[rays->count] = l;
        rays->share[rays->count] =
            l * (cosine + eye) / (cosine * light + l * eye) / (sides[0] * sides[1]);
        rays->all += rays->share[rays->count];
        rays->grazing += rays->share[rays->count++] * pow(1 - facing, 5);
    }
}

static void fit_albedos(void)
{
    enum { ROUGH = 28, ANGLES = 36 };
    static Fit loss = {.keep = .8}, grazing = {.keep = .8};
    static Rays rays;
    for (int i = 0; i < ROUGH; i++)
        for (int k = 0; k < ANGLES; k++) {
            const double rough = .0316227766 + (1 - .0316227766) * i / (ROUGH - 1),
                         alpha = rough * rough, cosine = pow((k + .7) / (ANGLES - .3), 2);
            find_rays(cosine, alpha, (const int[]){96, 64}, &rays);
            const double lost = 1 - rays.all, root = pow(rays.grazing / rays.all, .2);
            loss.samples[loss.count++] = (Sample){alpha, cosine * (1 + alpha) / (cosine + alpha),
                                                  lost,  1,
                                                  1,     .01 + .02 * fmin(lost, .5),
                                                  1,     1};
            grazing.samples[grazing.count++] = (Sample){rough,
                                                        sqrt(cosine + .5 * alpha),
                                                        root,
                                                        1,
                                                        5 * pow(root, 4) * rays.all + .02,
                                                        .02,
                                                        rays.all,
                                                        5};
        }
    run(&loss, "what facets lose, r alpha, x cosine (1 + alpha) / (cosine + alpha)", 8, 0);
    run(&grazing, "the fifth root of what grazes, r roughness, x sqrt(cosine + alpha / 2)", 8, 0);
}

/* -- Layers */

enum { STEPS = 40, LAYERS = 6, BASES = 20 };
typedef struct {
    /* at cosines ((i + 1/2) / STEPS)^2; weight of the polynomial */
    double through[STEPS], mean, share;
} Layer;

static double cosine_of(int i) { return pow((i + .5) / STEPS, 2); }

static double between(const double *values, double cosine)
{
    const double at = fmin(fmax(sqrt(cosine) * STEPS - .5, 0), STEPS - 1);
    const int i = at > STEPS - 2 ? STEPS - 2 : (int)at;
    return values[i] * (1 - at + i) + values[i + 1] * (at - i);
}

static void find_mean(Layer *layer)
{
    double sum = 0, all = 0;
    for (int i = 0; i < STEPS; i++) {
        const double share = pow((i + .5) / STEPS, 3);
        sum += share * layer->through[i];
        all += share;
    }
    layer->mean = sum / all;
}

/* Makes a coat of index 1.6. */
static void make_coat(double rough, Layer *layer)
{
    static Rays rays;
    for (int i = 0; i < STEPS; i++) {
        find_rays(cosine_of(i), rough * rough, (const int[]){48, 48}, &rays);
        layer->through[i] = 1 - (.0533 * (rays.all - rays.grazing) + rays.grazing);
    }
    layer->share = pow(1 - rough * rough, 5);
    find_mean(layer);
}

static double fibres(double rough, double eye, double l, double turn)
{
    const double vx = sqrt(1 - eye * eye), lx = sqrt(1 - l * l), x = vx + lx * cos(turn),
                 y = lx * sin(turn);
    const double sine = sqrt((x * x + y * y) / (x * x + y * y + (eye + l) * (eye + l)));
    return l * (2 + 1 / rough) * pow(sine, 1 / rough) / 2 / (4 * (l + eye - l * eye));
}

static void make_fuzz(double rough, Layer *layer)
{
    enum { SIDES = 60 };
    for (int i = 0; i < STEPS; i++) {
        double sum = 0;
        for (int k = 0; k < SIDES * SIDES; k++) {
            const double t = (k / SIDES + .5) / SIDES;
            sum += fibres(rough, cosine_of(i), t * t, PI * (k % SIDES + .5) / SIDES) * 4 * t /
                   SIDES / SIDES;
        }
        layer->through[i] = fmax(1 - sum, .004);
    }
    layer->share = 1 / (.8 + 1.05 * rough);
    find_mean(layer);
}

/* veil() for one direction, by evenOf(). */
static double veil(const Layer *layer, double through, double rough, double cosine)
{
    const double x = fmin(fmax((rough - .05) / (.3 + .9 * sqrt(cosine)), 0), 1);
    return through / sqrt(through + .86 * x * x * (3 - 2 * x) * (layer->mean - through));
}

/* Adds the light that a white mirror loses below each layer, by roughness and angle. */
static void add_base(double rough, const Layer *layers, Fit *fit)
{
    static Rays rays;
    for (int layer = 0; layer < LAYERS; layer++) {
        double veils[STEPS];
        for (int i = 0; i < STEPS; i++)
            veils[i] = veil(&layers[layer], layers[layer].through[i], rough, cosine_of(i));
        for (int i = 0; i < STEPS; i++) {
            double sum = 0;
            find_rays(cosine_of(i), rough * rough, (const int[]){48, 48}, &rays);
            for (int k = 0; k < rays.count; k++)
                sum += rays.share[k] * between(veils, rays.light[k]);
            fit->samples[fit->count++] =
                (Sample){rough,
                         sqrt(cosine_of(i)),
                         layers[layer].through[i] * rays.all - veils[i] * sum,
                         layers[layer].share,
                         cosine_of(i) < .1 ? .3 : 1,
                         cosine_of(i) < .08 ? 0 : .008,
                         1,
                         1};
        }
    }
}

static void fit_layer(const char *name, void (*make)(double, Layer *), const double *roughnesses,
                      int steps, double raise)
{
    static Fit fit;
    Layer layers[LAYERS];
    fit = (Fit){.keep = .6, .ridge = 1e-9};
    for (int i = 0; i < LAYERS; i++)
        make(roughnesses[i], &layers[i]);
    for (int i = 0; i < BASES; i++)
        add_base(.0316 + .9684 * i / (BASES - 1), layers, &fit);
    run(&fit, name, steps, raise);
}

int main(void)
{
    fit_albedos();
    fit_layer("below a coat, r the base's roughness, x the root of the cosine", make_coat,
              (const double[]){.0316, .15, .3, .45, .6, 1}, 2, .0015);
    fit_layer("below fuzz, the same", make_fuzz, (const double[]){.2, .3, .4, .55, .75, 1}, 3,
              .003);
    return 0;
}
