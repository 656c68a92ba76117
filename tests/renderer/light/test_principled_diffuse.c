/* A Principled's rough diffuse base: the lobe and its energy loss against sums in double, white
 * furnaces below microfacets, a coat and fuzz, reciprocity. */
/* ctest: seconds=12 */
#include "tests/test.h"
#include "runtime/surface/surface_model.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/pass_values.h"
#include "tests/lobe_claims.h"
#include <stdlib.h>

enum { SIDE = 20 };

/* A pixel is a roughness of microfacets, by its row, and an angle, by its column: cosines from 0.1
 * on. */
static const char head[] =
    "struct Surface { vec3 normal, diffuse, specular; float metalness, roughness, reflectance, "
    "diffuseRoughness, coat, coatRoughness, coatReflectance, fuzz; "
    "vec3 fuzzColor; float fuzzRoughness; };\n"
    "#define SURFACE_HAS_normal\n#define SURFACE_HAS_diffuse\n#define "
    "SURFACE_HAS_specular\n#define SURFACE_HAS_metalness\n#define SURFACE_HAS_roughness\n"
    "#define SURFACE_HAS_reflectance\n#define SURFACE_HAS_diffuseRoughness\n";
static const char layers[] =
    "#define SURFACE_HAS_coat\n#define SURFACE_HAS_coatRoughness\n#define "
    "SURFACE_HAS_coatReflectance\n"
    "#define SURFACE_HAS_fuzz\n#define SURFACE_HAS_fuzzColor\n#define SURFACE_HAS_fuzzRoughness\n";
static const char tools[] =
    LOBE_PIXELS "vec3 lightOf(ivec2 p) { return toward(0.05 + 0.95 * varied(p, 0.5701), 6.2831853 "
                "* varied(p, 0.91)); }\n"
                "Surface made(float base, float reflectance, float rough, float facets) { return "
                "Surface(vec3(0.0, 0.0, 1.0), vec3(base, 0.5 * base, 0.9 * base), vec3(1.0), 0.0, "
                "facets, reflectance, rough, 0.0, 0.0, 0.0, 0.0, vec3(1.0), 0.5); }\n";
/* Below nothing: the lobe over what an even white base sends; and what it loses where little of
 * light that grazes comes in. */
static const char bare[] = "vec4 passPixel(ivec2 p) {\n"
                           "    vec3 l = lightOf(p), v = toward(cosineOf(p), 0.0), color = "
                           "vec3(varied(p, 0.618), 1.0, varied(p, 0.733));\n"
                           "    Grain g = grainOf(varied(p, 0.382), 1.0, 1.0, 1.0);\n"
                           "    return vec4(grained(g, color, grainAgain(g, color) * grainLost(g, "
                           "v.z), dot(l, v), vec2(l.z, v.z), grainLost(g, l.z)), "
                           "grainLost(grainOf(varied(p, 0.382), 1.0, 1.0 - 0.2373046875 * "
                           "varied(p, 0.29), 1.0 - varied(p, 0.29) / 21.0), v.z));\n}\n";
static const char lobes[] =
    "vec4 passPixel(ivec2 p) { Surface s = made(0.2 + 0.8 * varied(p, 0.618), 0.1 * varied(p, "
    "0.137), varied(p, 0.382), roughOf(p)); s.specular = vec3(0.0);\n"
    "    return vec4(surfaceLobe(surfaceLit(s, toward(cosineOf(p), 0.0)), lightOf(p)), 1.0); }\n";
/* The base alone, which is nearly diffuse: directions by the cosine. Other tests take the rest, the
 * reflection of microfacets and layers. */
static const char furnace[] =
    "vec3 sent(Surface s, vec3 v) {\n"
    "    Surface flat_ = s; flat_.diffuseRoughness = 0.0;\n"
    "    Lit m = surfaceLit(s, v), even = surfaceLit(flat_, v);\n"
    "    vec3 sum = vec3(0.0);\n"
    "    for (int i = 0; i < 4096; i++) {\n"
    "        vec2 u = fract(vec2(0.7548776662, 0.5698402910) * float(i) + 0.5);\n"
    "        vec3 l = toward(sqrt(u.x), 6.2831853 * u.y);\n"
    "        sum += (surfaceLobe(m, l) - surfaceLobe(even, l)) / max(l.z, 1e-6);\n"
    "    }\n"
    "    return 1.0 + sum / 4096.0;\n}\n"
    "vec4 passPixel(ivec2 p) {\n"
    "    vec3 v = toward(cosineOf(p), 0.0);\n"
    "    Surface s = made(1.0, 0.04, 1.0, roughOf(p)); s.diffuse = vec3(1.0);\n"
    "    Surface t = s; t.diffuseRoughness = varied(p, 0.618); t.reflectance = 0.3 * varied(p, "
    "0.382);\n"
    "#ifdef LIT_COAT\n    s.coat = 1.0; s.coatRoughness = varied(p, 0.29); s.coatReflectance = "
    "0.0533; t.fuzz = 1.0; t.fuzzRoughness = 0.2 + 0.8 * varied(p, 0.733);\n#endif\n"
    "    vec3 a = sent(s, v), b = sent(t, v);\n"
    "    return vec4(a.x, b.x, 0.0, 1.0);\n}\n";
static const char turned[] =
    "vec4 passPixel(ivec2 p) {\n"
    "    vec3 v = toward(cosineOf(p), 0.0), l = lightOf(p);\n"
    "    Surface s = made(0.8, 0.04, varied(p, 0.382), roughOf(p));\n"
    "#ifdef LIT_COAT\n    s.coat = varied(p, 0.27); s.coatRoughness = varied(p, 0.29); "
    "s.coatReflectance = 0.05; s.fuzz = varied(p, 0.733);\n#endif\n"
    "    vec3 a = surfaceLobe(surfaceLit(s, v), l) / l.z, b = surfaceLobe(surfaceLit(s, l), v) / "
    "v.z;\n"
    "    return vec4(abs(a - b) / (a + b), 1.0);\n}\n";
static const char around[] =
    "vec4 passPixel(ivec2 p) { Surface s = made(1.0, 0.04, varied(p, 0.382), roughOf(p)); "
    "s.diffuse = vec3(1.0);\n"
    "#ifdef LIT_COAT\n    s.coat = varied(p, 0.27); s.coatRoughness = varied(p, 0.29); "
    "s.coatReflectance = 0.05; s.fuzz = varied(p, 0.733);\n#endif\n"
    "    return vec4(surfaceAmbient(surfaceLit(s, toward(cosineOf(p), 0.0)), vec3(1.0)), 1.0); }\n";

static void run(const char *more, const char *body, float (*reported)[4])
{
    const SurfaceModel *model = &surface_model_principled;
    const ScreenPassText text = {.body = {head, more, model->text, model->more[0], model->more[1],
                                          model->more[2], tools, body},
                                 .format = "RGBA32F"};
    GlContext *gl = frame_context();
    pass_values(gl, &text, SIDE, reported);
    gl_close(gl);
}

static double rough_of(int y) { return .0316227766 + .9683772 * y / (SIDE - 1); }
static double cosine_of(int x) { return .1 + .9 * x / (SIDE - 1); }
static double varied(int i, double step) { return fmod(.5 + step * i, 1); }

/* Fujii's lobe relative to Lambert's. */
static double once_of(double rough, double l, double v, double turn)
{
    const double s = sqrt(1 - l * l) * sqrt(1 - v * v) * cos(turn), t = s > 0 ? fmax(l, v) : 1;
    return (1 + rough * s / t) / (1 + (.5 - 2 / (3 * LOBE_PI)) * rough);
}

/* Share of light from a direction that reaches a body below a layer; by the numbers that describe
 * it. */
typedef double Arrives(const double *numbers, double cosine);

/* The integral of that lobe over all directions, and the mean of what arrives. */
static double once_from(double rough, double v, Arrives *arrives, const double *numbers)
{
    enum { RINGS = 200, TURNS = 100 };
    double sum = 0, all = 0;
    for (int i = 0; i < RINGS; i++) {
        const double l = sqrt((i + .5) / RINGS), share = arrives(numbers, l);
        for (int k = 0; k < TURNS; k++)
            sum += share * once_of(rough, l, v, LOBE_PI * (k + .5) / TURNS) / TURNS;
        all += share;
    }
    return sum / all;
}

static double once_from_all(double rough, Arrives *arrives, const double *numbers)
{
    enum { STEPS = 40 };
    double sum = 0, all = 0;
    for (int i = 0; i < STEPS; i++) {
        const double v = sqrt((i + .5) / STEPS), share = arrives(numbers, v);
        sum += share * once_from(rough, v, arrives, numbers);
        all += share;
    }
    return sum / all;
}

static double all_arrives(const double *numbers, double cosine)
{
    (void)numbers, (void)cosine;
    return 1;
}

static double less_that_grazes(const double *most, double cosine)
{
    return 1 - *most * pow(1 - cosine, 5);
}

typedef struct {
    double rough, cosines[2], turn;
    Arrives *arrives;
    const double *numbers;
} Grained;

/* With light that goes on within: of a color, over what comes in and leaves. */
static double lobe_of(const Grained *of, double color)
{
    const double rough = of->rough, *cosines = of->cosines, *numbers = of->numbers;
    Arrives *arrives = of->arrives;
    const double all = once_from_all(rough, arrives, numbers),
                 again = color * color * all / (1 - color * (1 - all));
    const double lost = (1 - once_from(rough, cosines[0], arrives, numbers)) *
                        (1 - once_from(rough, cosines[1], arrives, numbers));
    return color * once_of(rough, cosines[0], cosines[1], of->turn) + again * lost / (1 - all);
}

static double light_cosine(int i) { return .05 + .95 * varied(i, .5701); }

static void base_is_its_definition(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double worst[2] = {0};
    run("", bare, reported);
    for (int i = 0; i < SIDE * SIDE; i += 7) {
        const double rough = varied(i, .382), cosines[2] = {light_cosine(i), cosine_of(i % SIDE)},
                     color[3] = {varied(i, .618), 1, varied(i, .733)}, most = varied(i, .29);
        for (int component = 0; component < 3; component++) {
            const Grained of = {
                rough, {cosines[0], cosines[1]}, 2 * LOBE_PI * varied(i, .91), all_arrives, NULL};
            const double want = lobe_of(&of, color[component]);
            worst[0] = fmax(worst[0], fabs((double)reported[i][component] - want) / (.25 + want));
        }
        worst[1] = fmax(worst[1], fabs((double)reported[i][3] - 1 +
                                       once_from(rough, cosines[1], less_that_grazes, &most)));
    }
    print_message("the lobe: within %.4f; what it loses: %.4f\n", worst[0], worst[1]);
    assert_true(worst[0] < .003 && worst[1] < .001);
}

/* Light that microfacets do not reflect, by their integrals. Twenty roughnesses, at angles kept in
 * a table. */
enum { ANGLES = 200 };
static double albedos[SIDE][ANGLES][2], means[SIDE][2];

static double between_microfacets(const double *numbers, double cosine)
{
    const int row = (int)numbers[0];
    const double place = fmin(sqrt(cosine) * (ANGLES - 1), ANGLES - 1.001),
                 f = place - floor(place), *a = albedos[row][(int)place],
                 *b = albedos[row][(int)place + 1];
    const double own[2] = {a[0] + f * (b[0] - a[0]), a[1] + f * (b[1] - a[1])}, *m = means[row],
                 mean_f = numbers[1] + (1 - numbers[1]) / 21;
    return 1 - (numbers[1] * (1 - own[0] - own[1]) + own[1] +
                own[0] * mean_f * mean_f * (1 - m[0]) / (1 - mean_f * m[0]));
}

static void lobes_are_below_microfacets(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double worst = 0;
    run("", lobes, reported);
    for (int y = 0; y < SIDE; y++) {
        for (int k = 0; k < ANGLES; k++)
            lobe_albedo(fmax(pow(k / (ANGLES - 1.), 2), 1e-4), pow(rough_of(y), 2), albedos[y][k]);
        lobe_mean(pow(rough_of(y), 2), means[y]);
    }
    for (int i = 0; i < SIDE * SIDE; i += 7) {
        const double numbers[2] = {i / SIDE, .1 * varied(i, .137)},
                     cosines[2] = {light_cosine(i), cosine_of(i % SIDE)},
                     base = .2 + .8 * varied(i, .618);
        double mean = 0;
        for (int k = 0; k < ANGLES; k++)
            mean += between_microfacets(numbers, sqrt((k + .5) / ANGLES)) / ANGLES;
        for (int component = 0; component < 3; component++) {
            const double tone = base * (component == 0 ? 1 : component == 1 ? .5 : .9);
            const Grained of = {varied(i, .382),
                                {cosines[0], cosines[1]},
                                2 * LOBE_PI * varied(i, .91),
                                between_microfacets,
                                numbers};
            const double lobe = lobe_of(&of, tone);
            const double want = cosines[0] * between_microfacets(numbers, cosines[0]) *
                                between_microfacets(numbers, cosines[1]) / mean * lobe;
            worst = fmax(worst, fabs((double)reported[i][component] - want) / (.25 + want));
        }
    }
    print_message("below facets: within %.4f\n", worst);
    assert_true(worst < .01);
}

static void white_sends_all(void **state)
{
    (void)state;
    static float reported[2][SIDE * SIDE][4];
    double least = 2, most = 0;
    run("", furnace, reported[0]);
    run(layers, furnace, reported[1]);
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < SIDE * SIDE; i++) {
            least = fmin(least, fmin((double)reported[k][i][0], (double)reported[k][i][1]));
            most = fmax(most, fmax((double)reported[k][i][0], (double)reported[k][i][1]));
        }
    print_message("white, beside an even base: %.4f to %.4f\n", least, most);
    assert_true(least > .99 && most < 1.01);
}

static void light_and_eye_change_places(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    for (int k = 0; k < 2; k++) {
        run(k ? layers : "", turned, reported);
        lobe_changes_places(reported, SIDE * SIDE);
        run(k ? layers : "", around, reported);
        lobe_is_white_around(reported, SIDE * SIDE);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(base_is_its_definition), cmocka_unit_test(lobes_are_below_microfacets),
        cmocka_unit_test(white_sends_all), cmocka_unit_test(light_and_eye_change_places)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
