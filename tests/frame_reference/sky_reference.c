#include "tests/frame_reference/sky_reference.h"
#include "tests/test.h"
#include "tests/lobe_claims.h"
#include "tests/vectors.h"
#include <string.h>

static void way_of(double z, double turn, double way[3])
{
    const double flat = sqrt(fmax(1 - z * z, 0));
    way[0] = flat * cos(turn);
    way[1] = flat * sin(turn);
    way[2] = z;
}

/* A direction in a cell, by two numbers in [0, 1]. */
static void cell_way(int cell, const double at[2], double way[3])
{
    way_of(2 * (cell / SKY_REFERENCE_TURNS + at[0]) / SKY_REFERENCE_HEIGHTS - 1,
           2 * LOBE_PI * (cell % SKY_REFERENCE_TURNS + at[1]) / SKY_REFERENCE_TURNS, way);
}

/* A twentieth of the samples is uniform, so that light between the evaluated points is found,
 * too. */
void sky_reference_open(SkyReference *reference, SkyReferenceLight light, const void *sky)
{
    enum { ASKED = 9 };
    double sum = 0;
    reference->light = light;
    reference->sky = sky;
    for (int cell = 0; cell < SKY_REFERENCE_CELLS; cell++) {
        reference->before[cell] = sum;
        for (int i = 0; i < ASKED; i++) {
            double way[3], rgb[3];
            cell_way(cell, (double[]){(i % 3 + .5) / 3, (i / 3 + .5) / 3}, way);
            light(sky, way, rgb);
            sum += .2126 * rgb[0] + .7152 * rgb[1] + .0722 * rgb[2];
        }
    }
    for (int cell = 0; cell < SKY_REFERENCE_CELLS; cell++)
        reference->before[cell] =
            .95 * reference->before[cell] / sum + .05 * cell / SKY_REFERENCE_CELLS;
    reference->before[SKY_REFERENCE_CELLS] = 1;
}

void sky_reference_surface(SkyReferenceSurface *surface)
{
    const double alpha = surface->roughness * surface->roughness;
    for (int i = 0; i < 65; i++)
        lobe_albedo(fmax(i / 64., 1e-4), alpha, surface->albedos[i]);
    lobe_mean(alpha, surface->mean);
}

static void albedo_at(const SkyReferenceSurface *surface, double cosine, double albedo[2])
{
    const double at = 64 * fmin(fmax(cosine, 0), 1);
    const int i = at < 63 ? (int)at : 63;
    for (int k = 0; k < 2; k++)
        albedo[k] = (i + 1 - at) * surface->albedos[i][k] + (at - i) * surface->albedos[i + 1][k];
}

/* Smith's lambda: the masked share over the visible share. */
static double masked(double cosine, double alpha)
{
    return (sqrt(1 + alpha * alpha * (1 / (cosine * cosine) - 1)) - 1) / 2;
}

static double microfacets_along(double high, double alpha)
{
    const double wide = high * high * (alpha * alpha - 1) + 1;
    return alpha * alpha / (LOBE_PI * wide * wide);
}

/* Multiple scattering of microfacets of a mean reflectance, relative to ideal mirrors. */
static double again_of(double mean_reflected, const double mean[2])
{
    return mean_reflected * mean_reflected * (1 - mean[0]) / (1 - mean_reflected * mean[0]);
}

void sky_reference_lobe(const SkyReferenceSurface *surface, const double eye[3],
                        const double way[3], double lobe[3])
{
    const double alpha = surface->roughness * surface->roughness, f0 = surface->reflectance;
    double half[3], v[2], l[2];
    memset(lobe, 0, 3 * sizeof *lobe);
    if (eye[2] <= 0 || way[2] <= 0)
        return;
    for (int k = 0; k < 3; k++)
        half[k] = eye[k] + way[k];
    const double length = sqrt(dot(half, half)), schlick = pow(1 - dot(half, eye) / length, 5);
    const double once = LOBE_PI * microfacets_along(half[2] / length, alpha) /
                        (1 + masked(eye[2], alpha) + masked(way[2], alpha)) / (4 * eye[2]);
    albedo_at(surface, eye[2], v);
    albedo_at(surface, way[2], l);
    const double *m = surface->mean, again = way[2] * v[0] * l[0] / m[0],
                 of_base = again_of(f0 + (1 - f0) / 21, m);
    const double left_v = 1 - (f0 * (1 - v[0] - v[1]) + v[1] + v[0] * of_base),
                 left_l = 1 - (f0 * (1 - l[0] - l[1]) + l[1] + l[0] * of_base);
    const double left = 1 - (f0 * (1 - m[0] - m[1]) + m[1] + m[0] * of_base);
    for (int k = 0; k < 3; k++) {
        const double base = surface->base[k], metal = once * (base + (1 - base) * schlick) +
                                                      again * again_of(base + (1 - base) / 21, m);
        const double dielectric = once * (f0 + (1 - f0) * schlick) + again * of_base +
                                  way[2] * base * left_v * left_l / left;
        lobe[k] = surface->metalness * metal + (1 - surface->metalness) * dielectric;
    }
}

/* The normal, and two tangents. */
static void frame_around(const double normal[3], double axes[3][3])
{
    const double side[3] = {fabs(normal[2]) < .7 ? 0 : 1, 0, fabs(normal[2]) < .7 ? 1 : 0};
    double length = 0;
    for (int i = 0; i < 3; i++) {
        axes[0][i] =
            normal[(i + 1) % 3] * side[(i + 2) % 3] - normal[(i + 2) % 3] * side[(i + 1) % 3];
        length += axes[0][i] * axes[0][i];
    }
    for (int i = 0; i < 3; i++)
        axes[0][i] /= sqrt(length);
    for (int i = 0; i < 3; i++) {
        axes[1][i] =
            normal[(i + 1) % 3] * axes[0][(i + 2) % 3] - normal[(i + 2) % 3] * axes[0][(i + 1) % 3];
        axes[2][i] = normal[i];
    }
}

/* Reflects the eye's ray at a sampled visible normal: a point of the disc, lifted onto the
 * hemisphere that faces the stretched eye (Heitz 2018). */
static void microfacet_way(const double eye[3], double alpha, const double at[2], double way[3])
{
    const double stretched[3] = {alpha * eye[0], alpha * eye[1], eye[2]},
                 size = sqrt(dot(stretched, stretched));
    double axes[3][3], h[3], w[3];
    for (int k = 0; k < 3; k++)
        w[k] = stretched[k] / size;
    frame_around(w, axes);
    const double flat = hypot(w[0], w[1]);
    if (flat > 1e-9) { /* the first tangent is horizontal */
        const double level[3] = {-w[1] / flat, w[0] / flat, 0};
        for (int k = 0; k < 3; k++) {
            axes[0][k] = level[k];
            axes[1][k] = w[(k + 1) % 3] * level[(k + 2) % 3] - w[(k + 2) % 3] * level[(k + 1) % 3];
        }
    }
    const double r = sqrt(at[0]), turn = 2 * LOBE_PI * at[1], x = r * cos(turn),
                 part = (1 + w[2]) / 2;
    const double y = (1 - part) * sqrt(fmax(1 - x * x, 0)) + part * r * sin(turn),
                 z = sqrt(fmax(1 - x * x - y * y, 0));
    for (int k = 0; k < 3; k++)
        h[k] = x * axes[0][k] + y * axes[1][k] + z * axes[2][k];
    h[0] *= alpha;
    h[1] *= alpha;
    h[2] = fmax(h[2], 1e-12);
    const double length = sqrt(dot(h, h)), facing = dot(h, eye) / length;
    for (int k = 0; k < 3; k++)
        way[k] = 2 * facing * h[k] / length - eye[k];
}

/* Density of directions sampled by visible normals. */
static double microfacet_density(const double eye[3], double alpha, const double way[3])
{
    const double half[3] = {eye[0] + way[0], eye[1] + way[1], eye[2] + way[2]};
    return microfacets_along(half[2] / sqrt(dot(half, half)), alpha) / (1 + masked(eye[2], alpha)) /
           (4 * eye[2]);
}

static int find_cell(const SkyReference *reference, double share)
{
    int low = 0, high = SKY_REFERENCE_CELLS;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        *(reference->before[middle] <= share ? &low : &high) = middle;
    }
    return low;
}

static double sky_density(const SkyReference *reference, const double way[3])
{
    const int row = (int)fmin((way[2] + 1) / 2 * SKY_REFERENCE_HEIGHTS, SKY_REFERENCE_HEIGHTS - 1);
    const double turn = atan2(way[1], way[0]) / (2 * LOBE_PI);
    const int cell =
        row * SKY_REFERENCE_TURNS +
        (int)fmin((turn < 0 ? turn + 1 : turn) * SKY_REFERENCE_TURNS, SKY_REFERENCE_TURNS - 1);
    return (reference->before[cell + 1] - reference->before[cell]) * SKY_REFERENCE_CELLS /
           (4 * LOBE_PI);
}

/* The i-th point of the R2 low-discrepancy sequence: multiples of powers of the inverse of g,
 * with g^3 = g + 1. */
static void spread(int i, double at[2])
{
    at[0] = fmod(.5 + .7548776662466927 * (i + 1), 1);
    at[1] = fmod(.5 + .5698402909980532 * (i + 1), 1);
}

void sky_reference_sent(const SkyReference *reference, const SkyReferenceSurface *surface,
                        double ways[2][3], int samples, double rgb[3])
{
    const double alpha = surface->roughness * surface->roughness;
    double axes[3][3], eye[3];
    frame_around(ways[0], axes);
    for (int k = 0; k < 3; k++)
        eye[k] = dot(axes[k], ways[1]);
    memset(rgb, 0, 3 * sizeof *rgb);
    for (int i = 0; i < 2 * samples; i++) {
        double at[2], way[3], world[3] = {0}, lobe[3], light[3];
        spread(i / 2, at);
        if (i % 2) {
            const int cell = find_cell(reference, at[0]);
            at[0] = (at[0] - reference->before[cell]) /
                    (reference->before[cell + 1] - reference->before[cell]);
            cell_way(cell, at, world);
            for (int k = 0; k < 3; k++)
                way[k] = dot(axes[k], world);
        } else {
            microfacet_way(eye, alpha, at, way);
            for (int k = 0; k < 9; k++)
                world[k % 3] += way[k / 3] * axes[k / 3][k % 3];
        }
        if (way[2] <= 0)
            continue;
        sky_reference_lobe(surface, eye, way, lobe);
        reference->light(reference->sky, world, light);
        const double density = microfacet_density(eye, alpha, way) + sky_density(reference, world);
        for (int k = 0; k < 3; k++)
            rgb[k] += lobe[k] / LOBE_PI * light[k] / density / samples;
    }
}
