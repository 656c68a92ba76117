/* The lobes above a Principled's base, coat and fuzz: fits against integrals in double, the sum
 * of all lobes against their definitions, white furnaces, reciprocity. */
#include "tests/test.h"
#include "runtime/surface/surface_model.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/pass_values.h"
#include "tests/lobe_claims.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdlib.h>

enum { SIDE = 20 };

/* A pixel is a roughness, by its row, and an angle, by its column: cosines from 0.1 on. */
static const char head[] =
    "struct Surface { vec3 normal, diffuse, specular; float metalness, roughness, reflectance; "
    "float coat; vec3 coatTint; "
    "float coatRoughness, coatReflectance; float fuzz; vec3 fuzzColor; float fuzzRoughness; };\n"
    "#define SURFACE_HAS_normal\n#define SURFACE_HAS_diffuse\n#define SURFACE_HAS_specular\n"
    "#define SURFACE_HAS_metalness\n#define SURFACE_HAS_roughness\n#define "
    "SURFACE_HAS_reflectance\n"
    "#define SURFACE_HAS_coat\n#define SURFACE_HAS_coatTint\n#define "
    "SURFACE_HAS_coatRoughness\n#define SURFACE_HAS_coatReflectance\n"
    "#define SURFACE_HAS_fuzz\n#define SURFACE_HAS_fuzzColor\n#define SURFACE_HAS_fuzzRoughness\n";
static const char tools[] =
    "const float SIDE = 20.0;\n"
    "float roughOf(ivec2 p) { return 0.0316227766 + 0.9683772 * float(p.y) / (SIDE - 1.0); }\n"
    "float cosineOf(ivec2 p) { return 0.1 + 0.9 * float(p.x) / (SIDE - 1.0); }\n"
    "vec3 toward(float cosine, float turn) { float s = sqrt(max(1.0 - cosine * cosine, 0.0)); "
    "return vec3(s * cos(turn), s * sin(turn), cosine); }\n"
    "float varied(ivec2 p, float step) { return fract(0.5 + step * float(p.x + 20 * p.y)); }\n"
    "Surface made(vec3 base, vec3 numbers, vec3 coat, vec2 fuzz) { return Surface(vec3(0.0, 0.0, "
    "1.0), base, vec3(1.0), numbers.x, numbers.y, numbers.z, "
    "coat.x, vec3(1.0), coat.y, coat.z, fuzz.x, vec3(1.0), fuzz.y); }\n"
    "Surface mixed(ivec2 p) { Surface s = made(vec3(varied(p, 0.618), varied(p, 0.382), 0.9), "
    "vec3(varied(p, 0.733), roughOf(p), 0.3 * varied(p, 0.137)), "
    "vec3(varied(p, 0.415), 0.2 + 0.8 * varied(p, 0.29), 0.1 * varied(p, 0.653)), vec2(varied(p, "
    "0.811), 0.2 + 0.8 * varied(p, 0.177)));\n"
    "    s.coatTint = vec3(1.0, 0.7, varied(p, 0.55)); s.fuzzColor = vec3(varied(p, 0.345), 0.5, "
    "1.0); return s; }\n";
static const char fits[] =
    "vec4 passPixel(ivec2 p) { float r = 0.2 + 0.8 * float(p.y) / (SIDE - 1.0);\n"
    "    Lit m = surfaceLit(made(vec3(1.0), vec3(1.0, roughOf(p), 0.0), vec3(1.0, roughOf(p), "
    "0.05), vec2(1.0, r)), toward(cosineOf(p), 0.0));\n"
    "    return vec4(fuzzAlbedo(cosineOf(p), r), 1.0 - m.coatMean, 1.0 - m.fuzzMean, 1.0); }\n";
static const char lobes[] =
    "vec4 passPixel(ivec2 p) { Lit m = surfaceLit(mixed(p), toward(cosineOf(p), 0.0)); "
    "return vec4(surfaceLobe(m, toward(0.1 + 0.85 * varied(p, 0.5701), 3.14159 + (0.5 - varied(p, "
    "0.91)) * roughOf(p))), 1.0); }\n";
/* Every third pixel has no layer, a coat alone, fuzz alone; and what the coat's and the fuzz' other
 * numbers are does not matter there. */
static const char weights[] =
    "vec4 passPixel(ivec2 p) { Surface s = mixed(p); int kind = (p.x + p.y) % 3; if (kind != 1) { "
    "s.coat = 0.0; s.coatTint = vec3(1.0); } if (kind != 2) s.fuzz = 0.0; "
    "vec3 l = toward(0.1 + 0.85 * varied(p, 0.5701), 3.14159 + (0.5 - varied(p, 0.91)) * "
    "roughOf(p)); return vec4(surfaceLobe(surfaceLit(s, toward(cosineOf(p), 0.0)), l), 1.0); }\n";
/* A third of the directions by what of the base's microfacets the eye sees (Heitz 2018), one by the
 * coat's, one by the cosine. */
static const char furnace[] = LOBE_MICROFACET LOBE_SEEN
    "float sent(Surface surface, vec3 v) {\n"
    "    Lit m = surfaceLit(surface, v);\n"
    "    float sum = 0.0;\n"
    "    for (int i = 0; i < 1536; i++) {\n"
    "        vec2 u = fract(vec2(0.7548776662, 0.5698402910) * float(i) + 0.5);\n"
    "        int of = i % 3;\n"
    "        vec3 l = of == 2 ? toward(sqrt(u.x), 6.2831853 * u.y) : reflect(-v, facet(v, of == 0 "
    "? m.alpha : m.coatAlpha, u));\n"
    "        if (l.z > 0.0) sum += surfaceLobe(m, l).x / (seen(v, l, m.alpha) + seen(v, l, "
    "m.coatAlpha) + l.z) * 3.0;\n"
    "    }\n"
    "    return sum / 1536.0;\n}\n"
    "vec4 passPixel(ivec2 p) {\n"
    "    vec3 v = toward(cosineOf(p), 0.0), white = vec3(1.0);\n"
    "    float rough = roughOf(p), other = 0.1 + 0.9 * varied(p, 0.29);\n"
    "    return vec4(sent(made(white, vec3(0.0, rough, 0.04), vec3(1.0, other, 0.0533), vec2(0.0, "
    "0.5)), v),\n"
    "        sent(made(white, vec3(0.0, rough, 0.04), vec3(0.0), vec2(1.0, other)), v),\n"
    "        sent(made(white, vec3(0.0, rough, 0.04), vec3(1.0, 0.0, 0.0533), vec2(0.7, other)), "
    "v),\n"
    "        sent(made(white, vec3(1.0, rough, 0.0), vec3(1.0, 0.0, 0.0533), vec2(0.0)), v));\n}\n";
static const char turned[] = "vec4 passPixel(ivec2 p) {\n"
                             "    vec3 v = toward(cosineOf(p), 0.0), l = toward(0.05 + 0.95 * "
                             "varied(p, 0.5701), 6.2831853 * varied(p, 0.91));\n"
                             "    Surface s = mixed(p);\n"
                             "    vec3 a = surfaceLobe(surfaceLit(s, v), l) / l.z, b = "
                             "surfaceLobe(surfaceLit(s, l), v) / v.z;\n"
                             "    return vec4(abs(a - b) / (a + b), 1.0);\n}\n";
static const char around[] =
    "vec4 passPixel(ivec2 p) { Surface s = mixed(p); s.diffuse = s.coatTint = s.fuzzColor = "
    "vec3(1.0);\n"
    "    return vec4(surfaceAmbient(surfaceLit(s, toward(cosineOf(p), 0.0)), vec3(1.0)), 1.0); }\n";

static void run_lacking(GlContext *gl, const char *lacks, const char *body, float (*reported)[4])
{
    const SurfaceModel *model = &surface_model_principled;
    const ScreenPassText text = {.body = {lacks, head, model->text, model->more[0], model->more[1],
                                          model->more[2], tools, body},
                                 .format = "RGBA32F"};
    pass_values(gl, &text, SIDE, reported);
}

static void run(GlContext *gl, const char *body, float (*reported)[4])
{
    run_lacking(gl, "", body, reported);
}

static double rough_of(int y) { return .0316227766 + .9683772 * y / (SIDE - 1); }
static double cosine_of(int x) { return .1 + .9 * x / (SIDE - 1); }
static double varied(int i, double step) { return fmod(.5 + step * i, 1); }

/* Fibres, as a share of what arrives: pi D / (4 (c + e - c e)), D = (2 + 1/r) sin^(1/r) / (2 pi),
 * and the light's cosine. */
static double fibres(double rough, double eye, double l, double turn)
{
    const double vx = sqrt(1 - eye * eye), lx = sqrt(1 - l * l), x = vx + lx * cos(turn),
                 y = lx * sin(turn);
    const double sine = sqrt((x * x + y * y) / (x * x + y * y + (eye + l) * (eye + l)));
    return l * (2 + 1 / rough) * pow(sine, 1 / rough) / 2 / (4 * (l + eye - l * eye));
}

static double fuzz_albedo(double rough, double eye)
{
    enum { RINGS = 120, TURNS = 120 };
    double sum = 0;
    for (int i = 0; i < RINGS; i++)
        for (int k = 0; k < TURNS; k++) {
            const double t = (i + .5) / RINGS;
            sum += fibres(rough, eye, t * t, PI * (k + .5) / TURNS) * 2 * t / RINGS * 2 / TURNS;
        }
    return sum;
}

static double fuzz_mean(double rough)
{
    enum { STEPS = 30 };
    double sum = 0;
    for (int i = 0; i < STEPS; i++)
        sum += 2 * (i + .5) / STEPS / STEPS * fuzz_albedo(rough, (i + .5) / STEPS);
    return sum;
}

/* E, where the claims say what it lacks of 1, and the part of it that (1 - cosine)^5 has. */
static void integrate(double cosine, double alpha, double found[2])
{
    lobe_albedo(cosine, alpha, found);
    found[0] = 1 - found[0];
}

static void mean_of(double alpha, double found[2])
{
    lobe_mean(alpha, found);
    found[0] = 1 - found[0];
}

static double fresnel(const double albedo[2], double reflectance)
{
    return reflectance * (albedo[0] - albedo[1]) + albedo[1];
}

static void fits_are_integrals(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double worst[3] = {0};
    GlContext *gl = frame_context();
    run(gl, fits, reported);
    gl_close(gl);
    for (int i = 0; i < SIDE * SIDE; i++) {
        const double rough = .2 + .8 * (i / SIDE) / (SIDE - 1);
        worst[0] = fmax(worst[0], fabs(reported[i][0] - fuzz_albedo(rough, cosine_of(i % SIDE))));
        if (i % SIDE)
            continue;
        double mean[2];
        mean_of(pow(rough_of(i / SIDE), 2), mean);
        worst[1] = fmax(worst[1], fabs(reported[i][1] - fresnel(mean, .05)));
        worst[2] = fmax(worst[2], fabs(reported[i][2] - fuzz_mean(rough)));
    }
    print_message("fuzz: within %.4f, its mean %.4f; a coat's mean: %.4f\n", worst[0], worst[2],
                  worst[1]);
    assert_true(worst[0] < .006 && worst[1] < .004 && worst[2] < .004);
}

static double smooth(double low, double high, double x)
{
    const double t = fmin(fmax((x - low) / (high - low), 0), 1);
    return t * t * (3 - 2 * t);
}

/* Both directions by what a layer lets through of each; how evenly the base sends, as the GLSL says
 * it. */
typedef struct {
    double light, eye, mean;
} Through;

static double even_of(double rough, double cosine)
{
    return .86 * smooth(.05, .35 + .9 * sqrt(cosine), rough);
}

static double veil(const Through *of, double rough, double l, double cosine)
{
    const double light = even_of(rough, l), eye = even_of(rough, cosine);
    return of->light * of->eye /
           sqrt((of->light * (1 - light) + of->mean * light) *
                (of->eye * (1 - eye) + of->mean * eye));
}

/* Once reflected by GGX, with Fresnel's term 1. */
static double once_of(double a, double cosine, double l, double turn, double *facing)
{
    const double vx = sqrt(1 - cosine * cosine), lx = sqrt(1 - l * l);
    const double sum[3] = {vx + lx * cos(turn), lx * sin(turn), cosine + l},
                 size = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    const double high = sum[2] / size, d = a * a / pow(high * high * (a * a - 1) + 1, 2);
    const double of_eye = (sqrt(1 + a * a * (1 / (cosine * cosine) - 1)) - 1) / 2,
                 of_light = (sqrt(1 + a * a * (1 / (l * l) - 1)) - 1) / 2;
    *facing = (vx * sum[0] + cosine * sum[2]) / size;
    return d / (1 + of_eye + of_light) / (4 * cosine);
}

/* A base of a roughness below a coat and fuzz, over all directions: by the root of the cosine, at
 * the middles of steps. */
enum { STEPS = 24 };
typedef struct {
    double rough, alpha, stray;                      /* of the base, the last as the GLSL says it */
    double base[STEPS][2], coat[STEPS], fuzz[STEPS]; /* albedos; what is let through */
    double base_mean[2], coat_mean, fuzz_mean;
} Layers;

static double step_share(int i) { return 4 * pow((i + .5) / STEPS, 3) / STEPS; }

static double between_steps(const double *values, double cosine)
{
    const double at = fmin(fmax(sqrt(cosine) * STEPS - .5, 0), STEPS - 1.001),
                 part = at - floor(at);
    return values[(int)at] * (1 - part) + values[(int)at + 1] * part;
}

/* Single reflection by a white base below a layer, by visible normals; `left` is the layer's
 * transmittance, by the cosine. */
static double once_below(const Layers *of, const double *left, double mean, double cosine)
{
    /* as of albedos, from which this is taken: what sums are off cancels */
    enum { RINGS = LOBE_RINGS, TURNS = LOBE_TURNS };
    const double alpha = of->alpha, vx = sqrt(fmax(1 - cosine * cosine, 0)),
                 size = hypot(alpha * vx, cosine), wx = alpha * vx / size, wz = cosine / size;
    const double eye = sqrt(alpha * alpha + (1 - alpha * alpha) * cosine * cosine);
    double sum = 0;
    for (int i = 0; i < RINGS * TURNS; i++) {
        const double r = sqrt((i / TURNS + .5) / RINGS), turn = 2 * PI * (i % TURNS + .5) / TURNS,
                     t = r * cos(turn), k = .5 + .5 * wz;
        const double s = (1 - k) * sqrt(fmax(1 - t * t, 0)) + k * r * sin(turn),
                     up = sqrt(fmax(1 - t * t - s * s, 0));
        const double h[3] = {alpha * (s * -wz + up * wx), alpha * t, fmax(s * wx + up * wz, 0)};
        const double length = sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]),
                     l = 2 * (vx * h[0] + cosine * h[2]) / length * h[2] / length - cosine;
        if (l > 0)
            sum += l * (cosine + eye) /
                   (cosine * sqrt(alpha * alpha + (1 - alpha * alpha) * l * l) + l * eye) *
                   veil(&(Through){between_steps(left, l), between_steps(left, cosine), mean},
                        of->rough, l, cosine);
    }
    return sum / (RINGS * TURNS);
}

/* Relative loss of that light compared with the layers' transmittance. */
static double strayed(const Layers *of, double cosine, double albedo)
{
    const double coat = between_steps(of->coat, cosine), fuzz = between_steps(of->fuzz, cosine);
    const double by_coat =
        albedo * coat - (1 - of->stray) * once_below(of, of->coat, of->coat_mean, cosine);
    return fmax(by_coat * fuzz +
                    coat * (albedo * fuzz - once_below(of, of->fuzz, of->fuzz_mean, cosine)),
                0);
}

/* All lobes of component 1 of a pixel's surface by their definitions and integrals. */
static double lobe_of(int i, double cosine, double l, double turn)
{
    const double rough = rough_of(i / SIDE), base = varied(i, .382), metal = varied(i, .733),
                 f0 = .3 * varied(i, .137);
    const double coat = varied(i, .415), coat_rough = .2 + .8 * varied(i, .29),
                 c0 = .1 * varied(i, .653), fuzz = varied(i, .811),
                 fuzz_rough = .2 + .8 * varied(i, .177), a = rough * rough,
                 ca = coat_rough * coat_rough;
    Layers of = {.rough = rough, .alpha = a};
    of.stray = .022 * coat * (1 - c0) * pow(1 - ca, 5) * 1.0563 * smooth(.1, .35, rough);
    double v[2], w[2], found[2], facing;
    for (int k = 0; k < STEPS; k++) {
        const double at = pow((k + .5) / STEPS, 2);
        integrate(at, a, of.base[k]), integrate(at, ca, found);
        of.coat[k] = 1 - coat * fresnel(found, c0);
        of.fuzz[k] = 1 - fuzz * fuzz_albedo(fuzz_rough, at);
        of.coat_mean += step_share(k) * of.coat[k], of.fuzz_mean += step_share(k) * of.fuzz[k];
        for (int n = 0; n < 2; n++)
            of.base_mean[n] += step_share(k) * of.base[k][n];
    }
    integrate(cosine, a, v), integrate(l, a, w);
    integrate(cosine, ca, found);
    const double coat_v = 1 - coat * fresnel(found, c0),
                 fuzz_v = 1 - fuzz * fuzz_albedo(fuzz_rough, cosine);
    integrate(l, ca, found);
    const double coat_l = 1 - coat * fresnel(found, c0),
                 fuzz_l = 1 - fuzz * fuzz_albedo(fuzz_rough, l),
                 through = coat_v * coat_l * fuzz_v * fuzz_l;
    const double mean_f = f0 + (1 - f0) / 21,
                 ms = mean_f * mean_f * of.base_mean[0] / (1 - mean_f * (1 - of.base_mean[0]));
    const double more = 1 + 1.75 * smooth(.15, .4, rough);
    /* means of what is left, with what layers let through of it */
    double matt = 0, again = 0, stray[2] = {0};
    for (int k = 0; k < STEPS; k++) {
        const double left = step_share(k) * of.coat[k] * of.fuzz[k];
        matt += left * (1 - fresnel(of.base[k], f0) - (1 - of.base[k][0]) * ms);
        again += left * (1 - of.base[k][0]);
        const double lacks = step_share(k) * strayed(&of, pow((k + .5) / STEPS, 2), of.base[k][0]);
        stray[0] += lacks, stray[1] += lacks * more * fresnel(of.base[k], f0) / of.base[k][0];
    }
    const Through below = {fuzz_l, fuzz_v, of.fuzz_mean};
    const double mirrored = (1 - of.stray) *
                            veil(&(Through){coat_l, coat_v, of.coat_mean}, rough, l, cosine) *
                            veil(&below, rough, l, cosine);
    const double once = once_of(a, cosine, l, turn, &facing) * mirrored,
                 twice = l * (1 - v[0]) * (1 - w[0]) / again * through;
    const double spread = l * strayed(&of, cosine, v[0]) * strayed(&of, l, w[0]);
    const double schlick = pow(1 - facing, 5), sv = fresnel(v, f0) + (1 - v[0]) * ms,
                 sl = fresnel(w, f0) + (1 - w[0]) * ms;
    const double mean_m = base + (1 - base) / 21,
                 ms_m = mean_m * mean_m * of.base_mean[0] / (1 - mean_m * (1 - of.base_mean[0]));
    const double plain =
        l * base * (1 - sv) * (1 - sl) / matt * through + once * (f0 + (1 - f0) * schlick) +
        twice * ms +
        spread * more * more * fresnel(v, f0) / v[0] * fresnel(w, f0) / w[0] / fmax(stray[1], 1e-6);
    const double of_metal = once * (base + (1 - base) * schlick) + twice * ms_m +
                            spread * mean_m / fmax(stray[0], 1e-6);
    const double shine = coat * once_of(ca, cosine, l, turn, &facing) * (c0 + (1 - c0) * schlick) *
                         veil(&below, coat_rough, l, cosine);
    return .7 * ((1 - metal) * plain + metal * of_metal) + shine +
           fuzz * .5 * fibres(fuzz_rough, cosine, l, turn);
}

static void lobes_are_as_defined(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double worst = 0;
    GlContext *gl = frame_context();
    run(gl, lobes, reported);
    gl_close(gl);
    /* rows above the first, whose lobe is narrower than floats of the directions */
    for (int i = SIDE; i < SIDE * SIDE; i += 11) {
        const double turn = 3.14159 + (.5 - varied(i, .91)) * rough_of(i / SIDE);
        const double want = lobe_of(i, cosine_of(i % SIDE), .1 + .85 * varied(i, .5701), turn);
        worst = fmax(worst, fabs(reported[i][1] - want) / (.25 + want));
    }
    print_message("lobes: within %.4f\n", worst);
    /* what the polynomials of what is spread are within, of white light */
    assert_true(worst < .008);
}

static void white_sends_all(void **state)
{
    (void)state;
    static const char *const names[] = {"coat", "fuzz", "fuzz over a coat", "coat over metal"};
    static const double bound = .01;
    static float reported[SIDE * SIDE][4];
    bool fine = true;
    GlContext *gl = frame_context();
    run(gl, furnace, reported);
    gl_close(gl);
    for (int k = 0; k < 4; k++) {
        double least = 2, most = 0;
        for (int i = 0; i < SIDE * SIDE; i++) {
            least = fmin(least, (double)reported[i][k]);
            most = fmax(most, (double)reported[i][k]);
        }
        print_message("white, %s: %.4f to %.4f\n", names[k], least, most);
        fine &= least > 1 - bound && most < 1 + bound;
    }
    assert_true(fine);
}

/* A surface whose layers have weight 0 equals one without layers. */
static void layers_of_no_weight_change_nothing(void **state)
{
    (void)state;
    static const char *const lacks[] = {
        "#define SURFACE_MISSING_coat\n#define SURFACE_MISSING_fuzz\n",
        "#define SURFACE_MISSING_fuzz\n", "#define SURFACE_MISSING_coat\n"};
    static float all[SIDE * SIDE][4], alone[SIDE * SIDE][4];
    double worst = 0;
    int seen = 0;
    GlContext *gl = frame_context();
    run(gl, weights, all);
    for (int kind = 0; kind < 3; kind++) {
        run_lacking(gl, lacks[kind], weights, alone);
        for (int i = 0; i < 4 * SIDE * SIDE; i++) {
            const int pixel = i / 4;
            if ((pixel % SIDE + pixel / SIDE) % 3 != kind || i % 4 == 3)
                continue;
            worst = fmax(worst, fabs((double)all[pixel][i % 4] - (double)alone[pixel][i % 4]) /
                                    (.25 + fabs((double)alone[pixel][i % 4])));
            seen += alone[pixel][i % 4] > 1e-3F;
        }
    }
    gl_close(gl);
    print_message("layers of no weight: %.2g\n", worst);
    assert_true(worst < 1e-6 && seen > 2 * SIDE * SIDE);
}

static void light_and_eye_change_places(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    GlContext *gl = frame_context();
    run(gl, turned, reported);
    lobe_changes_places(reported, SIDE * SIDE);
    run(gl, around, reported);
    gl_close(gl);
    lobe_is_white_around(reported, SIDE * SIDE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fits_are_integrals), cmocka_unit_test(lobes_are_as_defined),
        cmocka_unit_test(white_sends_all), cmocka_unit_test(layers_of_no_weight_change_nothing),
        cmocka_unit_test(light_and_eye_change_places)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
