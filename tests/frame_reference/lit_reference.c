#include "tests/frame_reference/lit_reference.h"
#include "tests/fits/observer.h"
#include "tests/vectors.h"
#include <complex.h>
#include <math.h>
#include <string.h>

static double clamped(double x, double low, double high) { return fmin(fmax(x, low), high); }

static double value(const LitReference *lit, Slot slot) { return lit->slots.component[slot][0]; }

static bool is_principled(const LitReference *lit) { return value(lit, SLOT_model) > .5; }

static double share(const LitReference *lit, Slot slot) { return clamped(value(lit, slot), 0, 1); }

/* -- Tables over the cosine -------------------------------------------------------------------- */

static double step_cosine(int step) { return pow(fmax(step, .1) / LIT_STEPS, 2); }

static double table_at(const LitTable *table, double cosine, int component)
{
    const double at = LIT_STEPS * sqrt(clamped(cosine, 0, 1));
    const int i = at < LIT_STEPS - 1 ? (int)at : LIT_STEPS - 1;
    return (i + 1 - at) * table->by[i][component] + (at - i) * table->by[i + 1][component];
}

/* Weight of a step in a cosine-weighted mean over all directions: the integral of 2 c dc over the
 * cosine c, by the trapezoidal rule in sqrt(c). */
static double step_weight(int step)
{
    const double x = (double)step / LIT_STEPS;
    return (step == LIT_STEPS ? .5 : 1) * 4 * x * x * x / LIT_STEPS;
}

static void table_mean(LitTable *table)
{
    for (int component = 0; component < 3; component++) {
        table->mean[component] = 0;
        for (int i = 0; i <= LIT_STEPS; i++)
            table->mean[component] += step_weight(i) * table->by[i][component];
    }
}

/* -- Fresnel terms ----------------------------------------------------------------------------- */

/* Light of one polarization reflected by a film, all orders of reflection included. */
static double airy(double upper, double lower, double phase)
{
    const double complex turn = cexp(I * phase);
    const double complex sum = (upper + lower * turn) / (1 + upper * lower * turn);
    return creal(sum) * creal(sum) + cimag(sum) * cimag(sum);
}

static double film_at(const LitReference *lit, double cosine, double base, double nm)
{
    const double n = value(lit, SLOT_filmIor), root = sqrt(fmin(base, .9998));
    const double index = (1 + root) / (1 - root), sine2 = 1 - cosine * cosine;
    const double inner = sqrt(1 - sine2 / (n * n)), deep = sqrt(1 - sine2 / (index * index));
    const double phase = 2 * PI * value(lit, SLOT_filmPath) * inner / (nm * 1e-3);
    const double s = airy((cosine - n * inner) / (cosine + n * inner),
                          (n * inner - index * deep) / (n * inner + index * deep), phase);
    const double p = airy((n * cosine - inner) / (n * cosine + inner),
                          (index * inner - n * deep) / (index * inner + n * deep), phase);
    return (s + p) / 2;
}

static double film_reflected(const LitReference *lit, double cosine, double base, int component)
{
    double sum = 0, white = 0, weights[3];
    for (int nm = OBSERVER_FIRST; nm <= OBSERVER_LAST; nm += 4) {
        observer_components(nm, weights);
        sum += weights[component] * film_at(lit, cosine, base, nm);
        white += weights[component];
    }
    return clamped(sum / white, 0, 1);
}

/* Schlick's Fresnel term. For metal, Hoffman's term in cosine (1 - cosine)^6 lowers it to the tint
 * at 82 degrees, whose cosine is 1/7. */
static double microfacet_fresnel(const LitReference *lit, bool metal, double cosine, int component)
{
    const double low = metal ? clamped(lit->slots.component[SLOT_diffuse][component], 0, 1)
                             : share(lit, SLOT_reflectance);
    const double rest = 1 - cosine, film = share(lit, SLOT_film);
    double sum = low + (1 - low) * pow(rest, 5);
    if (metal) {
        const double edge = low + (1 - low) * pow(6. / 7, 5);
        const double tint = clamped(lit->slots.component[SLOT_specular][component], 0, 1);
        sum -= edge * (1 - tint) * cosine * pow(rest, 6) / (1. / 7 * pow(6. / 7, 6));
    }
    sum = fmax(sum, 0);
    return film > 0 ? sum + film * (film_reflected(lit, cosine, low, component) - sum) : sum;
}

/* -- GGX --------------------------------------------------------------------------------------- */

/* Smith's lambda of a direction in tangent space: along the tangent, across it, along the
 * normal. */
static double masking(const double widths[2], const double w[3])
{
    const double x = widths[0] * w[0], y = widths[1] * w[1];
    return (sqrt(1 + (x * x + y * y) / (w[2] * w[2])) - 1) / 2;
}

/* pi times the cosine of the light times the BRDF of single scattering, with a Fresnel term of
 * 1. */
static double microfacets_once(const double widths[2], const double v[3], const double l[3])
{
    double h[3];
    for (int i = 0; i < 3; i++)
        h[i] = v[i] + l[i];
    const double length2 = dot(h, h), x = h[0] / widths[0], y = h[1] / widths[1];
    const double wide = (x * x + y * y + h[2] * h[2]) / length2;
    const double density = 1 / (widths[0] * widths[1] * wide * wide);
    return density / (1 + masking(widths, v) + masking(widths, l)) / (4 * v[2]);
}

/* Samples the normal of a microfacet that v sees, from two numbers in [0, 1) (Heitz 2018). */
static void visible_microfacet(double alpha, const double v[3], const double at[2], double h[3])
{
    const double x = alpha * v[0], size = hypot(x, v[2]), wx = x / size, wz = v[2] / size;
    const double r = sqrt(at[0]), turn = 2 * PI * at[1], t = r * cos(turn), k = (1 + wz) / 2;
    const double s = (1 - k) * sqrt(fmax(1 - t * t, 0)) + k * r * sin(turn);
    const double up = sqrt(fmax(1 - t * t - s * s, 0));
    const double n[3] = {alpha * (up * wx - s * wz), alpha * t, fmax(s * wx + up * wz, 0)};
    const double length = sqrt(dot(n, n));
    for (int i = 0; i < 3; i++)
        h[i] = n[i] / length;
}

/* Directional albedo of single scattering, by components of the Fresnel term; NULL: a term of 1. */
static void microfacet_albedo(double alpha, double cosine, const LitTable *fresnel,
                              double albedo[3])
{
    enum { RINGS = 24, TURNS = 32 };
    const double v[3] = {sqrt(fmax(1 - cosine * cosine, 0)), 0, cosine};
    const double widths[2] = {alpha, alpha};
    memset(albedo, 0, 3 * sizeof *albedo);
    for (int i = 0; i < RINGS * TURNS; i++) {
        const double at[2] = {(i / TURNS + .5) / RINGS, (i % TURNS + .5) / TURNS};
        double h[3], l[3];
        visible_microfacet(alpha, v, at, h);
        const double facing = dot(v, h);
        for (int k = 0; k < 3; k++)
            l[k] = 2 * facing * h[k] - v[k];
        if (l[2] <= 0)
            continue;
        const double left =
            (1 + masking(widths, v)) / (1 + masking(widths, v) + masking(widths, l));
        for (int component = 0; component < 3; component++)
            albedo[component] +=
                left * (fresnel ? table_at(fresnel, facing, component) : 1) / (RINGS * TURNS);
    }
}

/* -- Layers ------------------------------------------------------------------------------------ */

/* pi times the cosine of the light times the BRDF of fuzz of weight 1. */
static double fibres(double rough, double high, double l, double v)
{
    const double sine = sqrt(fmax(1 - high * high, 0));
    return l * (2 + 1 / rough) * pow(sine, 1 / rough) / 2 / (4 * (l + v - l * v));
}

static double fuzz_albedo(double rough, double v)
{
    enum { RINGS = 40, TURNS = 40 };
    const double vx = sqrt(1 - v * v);
    double sum = 0;
    for (int i = 0; i < RINGS * TURNS; i++) {
        const double t = (i / TURNS + .5) / RINGS, l = t * t, lx = sqrt(1 - l * l);
        const double turn = PI * (i % TURNS + .5) / TURNS, x = vx + lx * cos(turn);
        const double y = lx * sin(turn), size = sqrt(x * x + y * y + (l + v) * (l + v));
        sum += fibres(rough, (l + v) / size, l, v) * 2 * t / RINGS * 2 / TURNS;
    }
    return fmin(sum, 1);
}

static double fuzz_rough(const LitReference *lit)
{
    return clamped(value(lit, SLOT_fuzzRoughness), .2, 1);
}

static double coat_alpha(const LitReference *lit)
{
    return pow(clamped(value(lit, SLOT_coatRoughness), .0316227766, 1), 2);
}

static double coat_fresnel(const LitReference *lit, double cosine)
{
    const double low = share(lit, SLOT_coatReflectance);
    return low + (1 - low) * pow(1 - cosine, 5);
}

/* Transmittance of coat and fuzz for a direction. */
static double layers_through(const LitReference *lit, double cosine, double of_coat)
{
    return table_at(&lit->coat, of_coat, 0) * table_at(&lit->fuzz, cosine, 0);
}

static void open_layers(LitReference *lit)
{
    const double coat = share(lit, SLOT_coat), fuzz = share(lit, SLOT_fuzz);
    LitTable fresnel;
    for (int i = 0; i <= LIT_STEPS; i++)
        for (int component = 0; component < 3; component++) {
            fresnel.by[i][component] = coat_fresnel(lit, step_cosine(i));
            lit->coat.by[i][component] = lit->fuzz.by[i][component] = 1;
        }
    for (int i = 0; i <= LIT_STEPS && coat > 0; i++) {
        double albedo[3];
        microfacet_albedo(coat_alpha(lit), step_cosine(i), &fresnel, albedo);
        lit->coat.by[i][0] = 1 - coat * albedo[0];
    }
    for (int i = 0; i <= LIT_STEPS && fuzz > 0; i++)
        lit->fuzz.by[i][0] = 1 - fuzz * fuzz_albedo(fuzz_rough(lit), step_cosine(i));
}

/* -- The base ---------------------------------------------------------------------------------- */

/* Directional albedo of dielectric or metal, multiple scattering included. */
static double reflected(const LitReference *lit, bool metal, double cosine, int component)
{
    return table_at(&lit->once[metal], cosine, component) +
           table_at(&lit->loss, cosine, component) * lit->again[metal][component];
}

static void open_base(LitReference *lit)
{
    const double alpha = sqrt((pow(lit->widths[0], 2) + pow(lit->widths[1], 2)) / 2);
    for (int metal = 0; metal < 2; metal++) {
        for (int i = 0; i <= LIT_STEPS; i++)
            for (int component = 0; component < 3; component++)
                lit->fresnel[metal].by[i][component] =
                    microfacet_fresnel(lit, metal, step_cosine(i), component);
        table_mean(&lit->fresnel[metal]);
    }
    for (int i = 0; i <= LIT_STEPS; i++) {
        for (int metal = 0; metal < 2; metal++)
            microfacet_albedo(alpha, step_cosine(i), &lit->fresnel[metal], lit->once[metal].by[i]);
        microfacet_albedo(alpha, step_cosine(i), NULL, lit->loss.by[i]);
        for (int component = 0; component < 3; component++)
            lit->loss.by[i][component] = fmax(1 - lit->loss.by[i][component], 0);
    }
    table_mean(&lit->loss);
    for (int metal = 0; metal < 2; metal++)
        for (int component = 0; component < 3; component++) {
            const double mean = lit->fresnel[metal].mean[component],
                         loss = lit->loss.mean[component];
            lit->again[metal][component] = mean * mean * (1 - loss) / (1 - mean * loss);
        }
}

static void open_means(LitReference *lit)
{
    memset(lit->base_mean, 0, sizeof lit->base_mean);
    lit->loss_mean = 1e-9;
    for (int i = 0; i <= LIT_STEPS; i++) {
        const double cosine = step_cosine(i), through = layers_through(lit, cosine, cosine);
        for (int component = 0; component < 3; component++)
            lit->base_mean[component] +=
                step_weight(i) * through * (1 - reflected(lit, false, cosine, component));
        lit->loss_mean += step_weight(i) * through * lit->loss.by[i][0];
    }
}

/* The slot anisotropy is (cos 2 t, sin 2 t) times the strength, t from x toward y: the patches of
 * these tests have dP/du and dP/dv along x and y. */
static void open_widths(LitReference *lit)
{
    const double rough = clamped(value(lit, SLOT_roughness), .0316227766, 1);
    const double *slot = lit->slots.component[SLOT_anisotropy],
                 strength = fmin(hypot(slot[0], slot[1]), 1);
    const double turn = atan2(slot[1], slot[0]) / 2, narrow = 1 - strength;
    const double axis[3] = {cos(turn), sin(turn), 0}, high = dot(axis, lit->normal);
    lit->widths[0] = rough * rough * sqrt(2 / (1 + narrow * narrow));
    lit->widths[1] = narrow * lit->widths[0];
    for (int i = 0; i < 2; i++)
        lit->widths[i] = fmax(lit->widths[i], 1e-3);
    for (int i = 0; i < 3; i++)
        lit->along[i] = axis[i] - high * lit->normal[i];
    const double length = sqrt(dot(lit->along, lit->along));
    for (int i = 0; i < 3; i++)
        lit->along[i] /= length;
    for (int i = 0; i < 3; i++)
        lit->across[i] = lit->normal[(i + 1) % 3] * lit->along[(i + 2) % 3] -
                         lit->normal[(i + 2) % 3] * lit->along[(i + 1) % 3];
}

/* -- Lobes ------------------------------------------------------------------------------------- */

static void phong_lobe(const LitReference *lit, const double l[3], double parts[LIT_PARTS][3])
{
    const double cosine = dot(lit->normal, l), *clear = lit->slots.component[SLOT_transparency];
    const double lobe = pow(fmax(dot(lit->mirrored, l), 0), value(lit, SLOT_shininess));
    const double on = pow(fmax(-dot(lit->eye, l), 0), value(lit, SLOT_transparencyShininess));
    for (int i = 0; i < 3; i++) {
        const double kept = value(lit, SLOT_interpolatedTransparency) > 0 ? 1 - clear[i] : 1;
        if (cosine > 0) {
            parts[LIT_EVEN][i] = kept * lit->slots.component[SLOT_diffuse][i] * cosine;
            parts[LIT_SPECULAR][i] = kept * lit->slots.component[SLOT_specular][i] * lobe * cosine;
        } else {
            parts[LIT_BEHIND][i] = -cosine * lit->slots.component[SLOT_diffuseTransparency][i];
            parts[LIT_STRAIGHT][i] = clear[i] * on;
        }
    }
}

/* Fujii's lobe relative to Lambert's, from the cosines of light, of eye and of the angle
 * between. */
static double grain_once(const LitReference *lit, double l, double v, double between)
{
    const double rough = share(lit, SLOT_diffuseRoughness), s = between - l * v;
    return (1 + rough * s / (s > 0 ? fmax(l, v) : 1)) / (1 + (.5 - 2 / (3 * PI)) * rough);
}

/* The base's color; for a rough base single scattering by Fujii's lobe and multiple scattering,
 * which is diffuse. A rough base must not have layers over it here. */
static double base_color(const LitReference *lit, const double l[3], int component)
{
    const double color = clamped(lit->slots.component[SLOT_diffuse][component], 0, 1),
                 all = lit->grain.mean[0];
    if (share(lit, SLOT_diffuseRoughness) <= 0)
        return color;
    const double to = dot(lit->normal, l), from = dot(lit->normal, lit->eye);
    const double again = color * color * all / ((1 - color * (1 - all)) * (1 - all));
    return color * grain_once(lit, to, from, dot(l, lit->eye)) +
           again * (1 - table_at(&lit->grain, to, 0)) * (1 - table_at(&lit->grain, from, 0));
}

static void open_grain(LitReference *lit)
{
    enum { RINGS = 40, TURNS = 40 };
    for (int i = 0; i <= LIT_STEPS; i++)
        for (int k = 0; k < RINGS * TURNS; k++) {
            const double to = step_cosine(i), from = sqrt((k / TURNS + .5) / RINGS);
            const double across = sqrt(1 - to * to) * sqrt(1 - from * from);
            const double between = to * from + across * cos(PI * (k % TURNS + .5) / TURNS);
            lit->grain.by[i][0] += grain_once(lit, from, to, between) / (RINGS * TURNS);
        }
    table_mean(&lit->grain);
}

/* Diffuse transmission of thin walls, below the specular interface and the layers of both sides. */
static void principled_behind(const LitReference *lit, double l, double parts[LIT_PARTS][3])
{
    const double v = dot(lit->normal, lit->eye),
                 through = layers_through(lit, l, l) * layers_through(lit, v, v);
    for (int i = 0; i < 3; i++) {
        const double in = 1 - reflected(lit, false, l, i), out = 1 - reflected(lit, false, v, i);
        const double tint = value(lit, SLOT_coat) > 0 ? lit->slots.component[SLOT_coatTint][i] : 1;
        parts[LIT_BEHIND][i] = lit->kept * l * lit->slots.component[SLOT_diffuseTransparency][i] *
                               in * out * through * tint / lit->base_mean[i];
    }
}

/* Reflection by the coat about its own normal, dimmed by the fuzz over it. */
static double coat_shine(const LitReference *lit, const double l[3])
{
    const double *n = lit->coat_normal, cosines[2] = {dot(n, l), fmax(dot(n, lit->eye), 1e-3)};
    double h[3], widths[2] = {coat_alpha(lit), coat_alpha(lit)};
    if (cosines[0] <= 0 || value(lit, SLOT_coat) <= 0)
        return 0;
    for (int i = 0; i < 3; i++)
        h[i] = l[i] + lit->eye[i];
    const double length = sqrt(dot(h, h)), high = dot(h, n) / length, facing = dot(h, l) / length;
    const double alpha2 = widths[0] * widths[0], wide = (1 - high * high) / alpha2 + high * high;
    const double v[3] = {sqrt(1 - cosines[1] * cosines[1]), 0, cosines[1]};
    const double w[3] = {sqrt(1 - cosines[0] * cosines[0]), 0, cosines[0]};
    const double masked = 1 + masking(widths, v) + masking(widths, w);
    const double fuzz = table_at(&lit->fuzz, dot(lit->normal, l), 0) *
                        table_at(&lit->fuzz, dot(lit->normal, lit->eye), 0);
    return share(lit, SLOT_coat) * coat_fresnel(lit, facing) / (alpha2 * wide * wide) / masked /
           (4 * cosines[1]) * sqrt(fuzz);
}

static void principled_lobe(const LitReference *lit, const double l[3], double parts[LIT_PARTS][3])
{
    const double cosine = dot(lit->normal, l), eye = fmax(dot(lit->normal, lit->eye), 1e-3);
    if (cosine <= 0) {
        principled_behind(lit, -cosine, parts);
        return;
    }
    const double metal = share(lit, SLOT_metalness), fuzz = share(lit, SLOT_fuzz);
    const double to[3] = {dot(lit->along, lit->eye), dot(lit->across, lit->eye), eye};
    const double from[3] = {dot(lit->along, l), dot(lit->across, l), cosine};
    const double between[3] = {to[0] + from[0], to[1] + from[1], to[2] + from[2]};
    const double length = sqrt(dot(between, between)), facing = dot(between, to) / length;
    const double of_eye = layers_through(lit, eye, fmax(dot(lit->coat_normal, lit->eye), 1e-3));
    const double of_light = layers_through(lit, cosine, fmax(dot(lit->coat_normal, l), 1e-3));
    const double once = microfacets_once(lit->widths, to, from) * sqrt(of_eye * of_light);
    const double again = cosine * table_at(&lit->loss, cosine, 0) * table_at(&lit->loss, eye, 0) *
                         of_eye * of_light / lit->loss_mean;
    for (int i = 0; i < 3; i++) {
        const double tint = share(lit, SLOT_coat) > 0 ? lit->slots.component[SLOT_coatTint][i] : 1;
        const double specular = clamped(lit->slots.component[SLOT_specular][i], 0, 1);
        const double matt = cosine * of_eye * of_light * (1 - reflected(lit, false, eye, i)) *
                            (1 - reflected(lit, false, cosine, i)) / lit->base_mean[i];
        double shine[2];
        for (int k = 0; k < 2; k++)
            shine[k] = once * table_at(&lit->fresnel[k], facing, i) + again * lit->again[k][i];
        parts[LIT_EVEN][i] =
            lit->kept * (tint * (1 - metal) * matt * base_color(lit, l, i) +
                         fuzz * lit->slots.component[SLOT_fuzzColor][i] *
                             fibres(fuzz_rough(lit), between[2] / length, cosine, eye));
        parts[LIT_SPECULAR][i] =
            lit->kept * tint * ((1 - metal) * specular * shine[0] + metal * shine[1]);
        parts[LIT_COAT][i] = lit->kept * coat_shine(lit, l);
    }
}

void lit_reference_lobe(const LitReference *lit, const double way[3], double parts[LIT_PARTS][3])
{
    memset(parts, 0, LIT_PARTS * sizeof *parts);
    (is_principled(lit) ? principled_lobe : phong_lobe)(lit, way, parts);
}

/* -- Albedos ----------------------------------------------------------------------------------- */

static void phong_albedos(const LitReference *lit, double parts[LIT_PARTS][3])
{
    for (int i = 0; i < 3; i++) {
        const double clear = lit->slots.component[SLOT_transparency][i];
        const double kept = value(lit, SLOT_interpolatedTransparency) > 0 ? 1 - clear : 1;
        parts[LIT_EVEN][i] = kept * lit->slots.component[SLOT_diffuse][i];
        parts[LIT_SPECULAR][i] = kept * lit->slots.component[SLOT_specular][i];
        parts[LIT_BEHIND][i] = lit->slots.component[SLOT_diffuseTransparency][i];
        parts[LIT_STRAIGHT][i] = clear;
    }
}

/* Albedo of the diffuse base for uniform light from all directions. */
static double base_albedo(const LitReference *lit, double eye, int component)
{
    const double color = clamped(lit->slots.component[SLOT_diffuse][component], 0, 1),
                 all = lit->grain.mean[0];
    if (share(lit, SLOT_diffuseRoughness) <= 0)
        return color;
    const double once = table_at(&lit->grain, eye, 0);
    return color * once + color * color * all / (1 - color * (1 - all)) * (1 - once);
}

void lit_reference_albedos(const LitReference *lit, double parts[LIT_PARTS][3])
{
    memset(parts, 0, LIT_PARTS * sizeof *parts);
    if (!is_principled(lit)) {
        phong_albedos(lit, parts);
        return;
    }
    const double eye = dot(lit->normal, lit->eye),
                 of_coat = fmax(dot(lit->coat_normal, lit->eye), 1e-3);
    const double through = layers_through(lit, eye, of_coat), metal = share(lit, SLOT_metalness);
    const double fuzz = table_at(&lit->fuzz, eye, 0),
                 *clear = lit->slots.component[SLOT_transparency];
    for (int i = 0; i < 3; i++) {
        const double tint = value(lit, SLOT_coat) > 0 ? lit->slots.component[SLOT_coatTint][i] : 1;
        const double left = lit->kept * through * tint, out = 1 - reflected(lit, false, eye, i);
        const double specular = clamped(lit->slots.component[SLOT_specular][i], 0, 1);
        parts[LIT_EVEN][i] = left * (1 - metal) * out * base_albedo(lit, eye, i) +
                             lit->kept * (1 - fuzz) * lit->slots.component[SLOT_fuzzColor][i];
        parts[LIT_SPECULAR][i] =
            left * ((1 - metal) * specular * (1 - out) + metal * reflected(lit, true, eye, i));
        parts[LIT_COAT][i] = lit->kept * (1 - table_at(&lit->coat, of_coat, 0)) * fuzz;
        parts[LIT_BEHIND][i] = left * out * lit->slots.component[SLOT_diffuseTransparency][i];
        const double holes = 1 - lit->kept, once = table_at(&lit->once[0], eye, i);
        parts[LIT_STRAIGHT][i] = value(lit, SLOT_transmission) > 0
                                     ? holes + (clear[i] - holes) * (1 - once) * through * tint
                                     : clear[i];
    }
}

void lit_reference_emission(const LitReference *lit, double rgb[3])
{
    const double eye = dot(lit->normal, lit->eye);
    for (int i = 0; i < 3; i++)
        rgb[i] = lit->slots.component[SLOT_emissive][i] *
                 (is_principled(lit)
                      ? layers_through(lit, eye, fmax(dot(lit->coat_normal, lit->eye), 1e-3))
                      : 1);
}

void lit_reference_open(const SlotValues *slots, const double eye[3], LitReference *lit)
{
    memset(lit, 0, sizeof *lit);
    lit->slots = *slots;
    memcpy(lit->eye, eye, sizeof lit->eye);
    memcpy(lit->normal, slots->component[SLOT_normal], sizeof lit->normal);
    const double *coat_normal = slots->component[SLOT_coatNormal];
    memcpy(lit->coat_normal, dot(coat_normal, coat_normal) > 0 ? coat_normal : lit->normal,
           sizeof lit->coat_normal);
    for (int i = 0; i < 3; i++)
        lit->mirrored[i] = 2 * dot(lit->normal, eye) * lit->normal[i] - eye[i];
    if (!is_principled(lit))
        return;
    const double *clear = slots->component[SLOT_transparency];
    lit->kept =
        1 - clamped(fmax(clear[0], fmax(clear[1], clear[2])) - value(lit, SLOT_transmission), 0, 1);
    open_widths(lit);
    open_layers(lit);
    open_base(lit);
    open_means(lit);
    if (share(lit, SLOT_diffuseRoughness) > 0)
        open_grain(lit);
}
