/* A thin film on a Principled surface: its reflection against sums over wavelengths in double, a
 * white furnace, reciprocity. */
#include "tests/test.h"
#include "runtime/surface/surface_model.h"
#include "tests/fits/observer.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/pass_values.h"
#include "tests/lobe_claims.h"
#include <complex.h>
#include <stdlib.h>

enum { SIDE = 20 };

static const char head[] =
    "struct Surface { vec3 normal, diffuse, specular; float metalness, roughness, reflectance, "
    "film, filmPath, filmIor; };\n"
    "#define SURFACE_HAS_normal\n#define SURFACE_HAS_diffuse\n#define "
    "SURFACE_HAS_specular\n#define SURFACE_HAS_metalness\n#define SURFACE_HAS_roughness\n"
    "#define SURFACE_HAS_reflectance\n#define SURFACE_HAS_film\n#define "
    "SURFACE_HAS_filmPath\n#define SURFACE_HAS_filmIor\n";
static const char tools[] =
    LOBE_PIXELS "Surface made(ivec2 p, float base, float metal) { return Surface(vec3(0.0, 0.0, "
                "1.0), vec3(base), vec3(1.0), metal, roughOf(p), 0.04, 1.0, 3.0 * varied(p, 0.29), "
                "1.2 + 0.8 * varied(p, 0.43)); }\n";
static const char films[] =
    "vec4 passPixel(ivec2 p) { return vec4(filmReflected(Film(1.0, 5.0 * varied(p, 0.618), 1.1 + "
    "1.2 * varied(p, 0.382)), cosineOf(p), vec3(varied(p, 0.733) * varied(p, 0.733))), 1.0); }\n";
/* A smooth film of water in air, a meter's millionth thick at most, along the normal and at 60
 * degrees: what it sends of white light from all around. */
static const char soap[] =
    "vec4 passPixel(ivec2 p) { Surface s = Surface(vec3(0.0, 0.0, 1.0), vec3(0.0), vec3(1.0), 0.0, "
    "0.0, 0.0, 1.0, 2.0 * 1.33 * (float(p.x) + 0.5 + SIDE * float(p.y)) / (SIDE * SIDE), 1.33);\n"
    "    return vec4(surfaceAmbient(surfaceLit(s, toward((p.x & 1) == 0 ? 1.0 : 0.5, 0.0)), "
    "vec3(1.0)), 1.0); }\n";
static const char furnace[] = LOBE_MICROFACET LOBE_SEEN
    "float density(vec3 v, vec3 l, float a) { return 0.5 * (seen(v, l, a) + l.z) / 3.14159265; }\n"
    "vec3 sent(Surface surface, vec3 v) {\n"
    "    Lit m = surfaceLit(surface, v);\n"
    "    vec3 sum = vec3(0.0);\n"
    "    for (int i = 0; i < 512; i++) {\n"
    "        vec2 u = fract(vec2(0.7548776662, 0.5698402910) * float(i) + 0.5);\n"
    "        vec3 l = (i & 1) == 0 ? reflect(-v, facet(v, m.alpha, u)) : toward(sqrt(u.x), "
    "6.2831853 * u.y);\n"
    "        if (l.z > 0.0) sum += surfaceLobe(m, l) / (3.14159265 * density(v, l, m.alpha));\n"
    "    }\n"
    "    return sum / 512.0;\n}\n"
    "vec4 passPixel(ivec2 p) {\n"
    "    vec3 v = toward(cosineOf(p), 0.0), one = sent(made(p, 1.0, 0.0), v), other = sent(made(p, "
    "1.0, 1.0), v);\n"
    "    return vec4(min(min(one.x, one.y), one.z), max(max(one.x, one.y), one.z), "
    "min(min(other.x, other.y), other.z), max(max(other.x, other.y), other.z));\n}\n";
static const char turned[] = "vec4 passPixel(ivec2 p) {\n"
                             "    vec3 v = toward(cosineOf(p), 0.0), l = toward(0.05 + 0.95 * "
                             "varied(p, 0.5701), 6.2831853 * varied(p, 0.91));\n"
                             "    Surface s = made(p, 0.6, varied(p, 0.27));\n"
                             "    vec3 a = surfaceLobe(surfaceLit(s, v), l) / l.z, b = "
                             "surfaceLobe(surfaceLit(s, l), v) / v.z;\n"
                             "    return vec4(abs(a - b) / (a + b), 1.0);\n}\n";

static void run(GlContext *gl, const char *body, float (*reported)[4])
{
    const SurfaceModel *model = &surface_model_principled;
    const ScreenPassText text = {
        .body = {head, model->text, model->more[0], model->more[1], model->more[2], tools, body},
        .format = "RGBA32F"};
    pass_values(gl, &text, SIDE, reported);
}

static double cosine_of(int x) { return .1 + .9 * x / (SIDE - 1); }
static double varied(int i, double step) { return fmod(.5 + step * i, 1); }

/* One polarization: all interreflections within the film. */
static double airy(double a, double b, double phase)
{
    const double complex turn = cexp(I * phase), sum = (a + b * turn) / (1 + a * b * turn);
    return creal(sum) * creal(sum) + cimag(sum) * cimag(sum);
}

static void film_of(double path, double n, double cosine, double base, double components[3])
{
    const double index = (1 + sqrt(base)) / (1 - sqrt(base)), sine2 = 1 - cosine * cosine;
    const double inner = sqrt(1 - sine2 / (n * n)), deep = sqrt(1 - sine2 / (index * index));
    double white[3] = {0}, one[3];
    components[0] = components[1] = components[2] = 0;
    for (int nm = OBSERVER_FIRST; nm <= OBSERVER_LAST; nm++) {
        const double phase = 2 * LOBE_PI * path * inner / (nm * 1e-3);
        const double s = airy((cosine - n * inner) / (cosine + n * inner),
                              (n * inner - index * deep) / (n * inner + index * deep), phase);
        const double p = airy((n * cosine - inner) / (n * cosine + inner),
                              (index * inner - n * deep) / (index * inner + n * deep), phase);
        observer_components(nm, one);
        for (int component = 0; component < 3; component++) {
            components[component] += one[component] * .5 * (s + p);
            white[component] += one[component];
        }
    }
    for (int component = 0; component < 3; component++)
        components[component] = fmin(fmax(components[component] / white[component], 0), 1);
}

static void films_are_sums_over_wavelengths(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double worst = 0, squares = 0;
    GlContext *gl = frame_context();
    run(gl, films, reported);
    gl_close(gl);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double want[3];
        film_of(5 * varied(i, .618), 1.1 + 1.2 * varied(i, .382), cosine_of(i % SIDE),
                varied(i, .733) * varied(i, .733), want);
        for (int component = 0; component < 3; component++) {
            const double error = fabs((double)reported[i][component] - want[component]);
            worst = fmax(worst, error);
            squares += error * error / (3 * SIDE * SIDE);
        }
    }
    print_message("films: within %.4f, root of the mean square %.4f\n", worst, sqrt(squares));
    assert_true(worst < .11 && sqrt(squares) < .006);
}

/* Airy's sum in closed form: F sin^2 / (1 + F sin^2) of half the phase between the sides, F = 4 R /
 * (1 - R)^2, R what one side reflects by Fresnel's formulas, of both polarizations, by wavelengths
 * as an observer weighs them. */
static void airy_of(double thickness, double cosine, double components[3])
{
    const double n = 1.33, inner = sqrt(1 - (1 - cosine * cosine) / (n * n));
    const double r[2] = {(cosine - n * inner) / (cosine + n * inner),
                         (n * cosine - inner) / (n * cosine + inner)};
    double white[3] = {0}, one[3];
    components[0] = components[1] = components[2] = 0;
    for (int nm = OBSERVER_FIRST; nm <= OBSERVER_LAST; nm++) {
        const double half = sin(2 * LOBE_PI * n * thickness * inner / (nm * 1e-3)),
                     sine2 = half * half;
        double sum = 0;
        for (int k = 0; k < 2; k++) {
            const double side = r[k] * r[k], finesse = 4 * side / ((1 - side) * (1 - side));
            sum += .5 * finesse * sine2 / (1 + finesse * sine2);
        }
        observer_components(nm, one);
        for (int component = 0; component < 3; component++) {
            components[component] += one[component] * sum;
            white[component] += one[component];
        }
    }
    for (int component = 0; component < 3; component++)
        components[component] /= white[component];
}

/* A film in air equals one on a base of index 1, which reflects nothing itself. */
static void soap_is_airys(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double worst[2] = {0}, most[2] = {0}, least[2] = {1, 1};
    GlContext *gl = frame_context();
    run(gl, soap, reported);
    gl_close(gl);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double want[3];
        airy_of((i + .5) / (SIDE * SIDE), i % 2 ? .5 : 1, want);
        for (int component = 0; component < 3; component++) {
            worst[i % 2] = fmax(worst[i % 2], fabs((double)reported[i][component] -
                                                   fmin(fmax(want[component], 0), 1)));
            most[i % 2] = fmax(most[i % 2], want[component]);
            least[i % 2] = fmin(least[i % 2], want[component]);
        }
    }
    for (int k = 0; k < 2; k++)
        print_message("soap, %s: %.4f to %.4f, within %.4f\n",
                      k ? "60 degrees" : "along the normal", least[k], most[k], worst[k]);
    assert_true(worst[0] < .003 && worst[1] < .006);
}

static void white_sends_all(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double least[2] = {2, 2}, most[2] = {0};
    GlContext *gl = frame_context();
    run(gl, furnace, reported);
    gl_close(gl);
    for (int i = 0; i < SIDE * SIDE; i++)
        for (int k = 0; k < 2; k++) {
            least[k] = fmin(least[k], (double)reported[i][2 * k]);
            most[k] = fmax(most[k], (double)reported[i][2 * k + 1]);
        }
    print_message("white: %.4f to %.4f, of metal %.4f to %.4f\n", least[0], most[0], least[1],
                  most[1]);
    assert_true(least[0] > .97 && most[0] < 1.03 && least[1] > .99 && most[1] < 1.01);
}

static void light_and_eye_change_places(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    GlContext *gl = frame_context();
    run(gl, turned, reported);
    gl_close(gl);
    lobe_changes_places(reported, SIDE * SIDE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(films_are_sums_over_wavelengths), cmocka_unit_test(soap_is_airys),
        cmocka_unit_test(white_sends_all), cmocka_unit_test(light_and_eye_change_places)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
