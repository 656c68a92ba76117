/* The lobe of Principled surfaces: fits of its albedos against integrals in double, the GLSL's
 * lobe against microfacet theory, a white furnace at every roughness, reciprocity, and energy
 * conservation for every color. */
/* ctest: seconds=11 */
#include "tests/test.h"
#include "gen/render_text.h"
#include "runtime/surface/surface_model.h"
#include "compiler/matc.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/pass_values.h"
#include "tests/lobe_claims.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { SIDE = 20 };

/* A pixel has a roughness by its row, and an angle by its column: cosines from 0.1 on. */
static const char head[] =
    "struct Surface { vec3 normal, diffuse, specular; float metalness, roughness, reflectance; };\n"
    "#define SURFACE_HAS_normal\n#define SURFACE_HAS_diffuse\n#define SURFACE_HAS_specular\n"
    "#define SURFACE_HAS_metalness\n#define SURFACE_HAS_roughness\n#define "
    "SURFACE_HAS_reflectance\n";
static const char tools[] =
    "const float SIDE = 20.0;\n"
    "float roughOf(ivec2 p) { return 0.0316227766 + 0.9683772 * float(p.y) / (SIDE - 1.0); }\n"
    "float cosineOf(ivec2 p) { return 0.1 + 0.9 * float(p.x) / (SIDE - 1.0); }\n"
    "vec3 toward(float cosine, float turn) { float s = sqrt(max(1.0 - cosine * cosine, 0.0)); "
    "return vec3(s * cos(turn), s * sin(turn), cosine); }\n"
    "Surface made(vec3 base, vec3 tint, vec3 numbers) { return Surface(vec3(0.0, 0.0, 1.0), base, "
    "tint, numbers.x, numbers.y, numbers.z); }\n"
    "float varied(ivec2 p, float step) { return fract(0.5 + step * float(p.x + 20 * p.y)); }\n"
    "Surface mixed(ivec2 p, float rough) { return made(vec3(varied(p, 0.618), varied(p, 0.382), "
    "0.9), vec3(1.0, varied(p, 0.271), 0.8), "
    "vec3(varied(p, 0.733), rough, 0.3 * varied(p, 0.137))); }\n";
static const char fits[] = "vec4 passPixel(ivec2 p) { return vec4(albedo(cosineOf(p), "
                           "roughnessOf(roughOf(p))), 0.0, 1.0); }\n";
static const char lobes[] =
    "vec4 passPixel(ivec2 p) { Lit m = surfaceLit(mixed(p, roughOf(p)), toward(cosineOf(p), 0.0)); "
    "return vec4(surfaceLobe(m, toward(0.05 + 0.9 * varied(p, 0.5701), 3.14159 + (0.5 - varied(p, "
    "0.91)) * roughOf(p))), 1.0); }\n";
/* Half of the directions by sampling GGX's visible normals (Heitz 2018), half by the cosine. */
static const char furnace[] = LOBE_MICROFACET LOBE_SEEN
    "float density(vec3 v, vec3 l, float a) { return 0.5 * (seen(v, l, a) + l.z) / 3.14159265; }\n"
    "vec3 sent(Surface surface, vec3 v) {\n"
    "    Lit m = surfaceLit(surface, v);\n"
    "    vec3 sum = vec3(0.0);\n"
    "    for (int i = 0; i < 1024; i++) {\n"
    "        vec2 u = fract(vec2(0.7548776662, 0.5698402910) * float(i) + 0.5);\n"
    "        vec3 l = (i & 1) == 0 ? reflect(-v, facet(v, m.alpha, u)) : toward(sqrt(u.x), "
    "6.2831853 * u.y);\n"
    "        if (l.z > 0.0) sum += surfaceLobe(m, l) / (3.14159265 * density(v, l, m.alpha));\n"
    "    }\n"
    "    return sum / 1024.0;\n}\n"
    "vec4 passPixel(ivec2 p) {\n"
    "    vec3 v = toward(cosineOf(p), 0.0), white = vec3(1.0);\n"
    "    float rough = roughOf(p);\n"
    "    return vec4(sent(made(white, white, vec3(0.0, rough, 0.04)), v).x, sent(made(white, "
    "white, vec3(1.0, rough, 0.0)), v).x,\n"
    "        sent(made(white, white, vec3(0.4, rough, 0.3)), v).x, sent(mixed(p, rough), "
    "v).z);\n}\n";
static const char turned[] = "vec4 passPixel(ivec2 p) {\n"
                             "    vec3 v = toward(cosineOf(p), 0.0), l = toward(0.05 + 0.95 * "
                             "varied(p, 0.5701), 6.2831853 * varied(p, 0.91));\n"
                             "    Surface s = mixed(p, roughOf(p));\n"
                             "    vec3 a = surfaceLobe(surfaceLit(s, v), l) / l.z, b = "
                             "surfaceLobe(surfaceLit(s, l), v) / v.z;\n"
                             "    return vec4(abs(a - b) / (a + b), 1.0);\n}\n";
static const char around[] =
    "vec4 passPixel(ivec2 p) { Lit m = surfaceLit(made(vec3(1.0), vec3(1.0), vec3(varied(p, "
    "0.733), roughOf(p), 0.3)), toward(cosineOf(p), 0.0)); "
    "return vec4(surfaceAmbient(m, vec3(1.0)), 1.0); }\n";

/* A parallelogram of radiance 1 around a direction near the mirrored one: areaOfSide() by the
 * approximation of microfacets, and by Phong's lobe of equal width. */
static const char areas[] =
    "vec4 passPixel(ivec2 p) {\n"
    "    vec3 v = toward(cosineOf(p), 0.0), n = vec3(0.0, 0.0, 1.0), to = toward(clamp(v.z + 0.5 * "
    "(varied(p, 0.618) - 0.5), 0.05, 1.0), 3.14159265 + 2.0 * (varied(p, 0.382) - 0.5));\n"
    "    float rough = 0.1 + 0.9 * float(p.y) / (SIDE - 1.0), size = exp(1.5 - 3.5 * varied(p, "
    "0.733));\n"
    "    vec3 x = normalize(cross(to, vec3(0.3, 0.8, 0.52))), y = cross(to, x);\n"
    "    Area light = areaSeen(to - size * (x + 0.6 * y), 2.0 * size * x, 1.2 * size * y, true);\n"
    "    AreaSide side = areaPowers(n, vec3(0.0), vec3(1.0), n, n, -1.0);\n"
    "    side.into = areaMicrofacets(rough, n, v);\n"
    "    side.even = vec3(1.0);\n"
    "    float exponent = clamp(0.5 / pow(rough, 4.0) - 0.5, 0.0, 65504.0);\n"
    "    AreaSide other = areaPowers(n, vec3(0.0), vec3(0.5 * exponent + 1.0), reflect(-v, n), "
    "reflect(-v, n), exponent);\n"
    "    return vec4(areaOfSide(light, side).x, areaOfSide(light, other).x, 0.0, 1.0); }\n";

static void run_texts(GlContext *gl, const char *const texts[7], float (*reported)[4])
{
    const ScreenPassText text = {
        .body = {texts[0], texts[1], texts[2], texts[3], texts[4], texts[5], texts[6]},
        .format = "RGBA32F"};
    pass_values(gl, &text, SIDE, reported);
}

static void run(GlContext *gl, const char *body, float (*reported)[4])
{
    run_texts(gl,
              (const char *const[]){
                  head, surface_model_principled.text, surface_model_principled.more[0],
                  surface_model_principled.more[1], surface_model_principled.more[2], tools, body},
              reported);
}

static double rough_of(int y) { return .0316227766 + .9683772 * y / (SIDE - 1); }
static double cosine_of(int x) { return .1 + .9 * x / (SIDE - 1); }
static double varied(int i, double step) { return fmod(.5 + step * i, 1); }

static void albedos_are_fitted(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double worst[2] = {0};
    GlContext *gl = frame_context();
    run(gl, fits, reported);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double want[2];
        lobe_albedo(cosine_of(i % SIDE), pow(rough_of(i / SIDE), 2), want);
        for (int k = 0; k < 2; k++)
            worst[k] = fmax(worst[k], fabs(reported[i][k] - want[k]));
    }
    gl_close(gl);
    print_message("albedos: within %.4f and %.4f\n", worst[0], worst[1]);
    assert_true(worst[0] < .0055 && worst[1] < .0035);
}

typedef struct {
    double base, tint, metal, rough, reflectance;
} Case;

/* The lobe by its definition, for one component, by integrals. */
static double lobe_of(const Case *c, double cosine, double l, double turn)
{
    const double a = c->rough * c->rough, vx = sqrt(1 - cosine * cosine), lx = sqrt(1 - l * l);
    const double sum[3] = {vx + lx * cos(turn), lx * sin(turn), cosine + l},
                 size = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    const double high = sum[2] / size, facing = (vx * sum[0] + cosine * sum[2]) / size;
    const double d = a * a / (PI * pow(high * high * (a * a - 1) + 1, 2));
    const double lambda_v = (sqrt(1 + a * a * (1 / (cosine * cosine) - 1)) - 1) / 2,
                 lambda_l = (sqrt(1 + a * a * (1 / (l * l) - 1)) - 1) / 2;
    const double once = PI * d / (1 + lambda_v + lambda_l) / (4 * cosine);
    double v[2], w[2], m[2];
    lobe_albedo(cosine, a, v);
    lobe_albedo(l, a, w);
    lobe_mean(a, m);
    const double again = l * v[0] * w[0] / m[0], f0 = c->reflectance, mean_f = f0 + (1 - f0) / 21;
    const double ms = mean_f * mean_f * (1 - m[0]) / (1 - mean_f * m[0]);
    const double es_v = f0 * (1 - v[0] - v[1]) + v[1] + v[0] * ms,
                 es_l = f0 * (1 - w[0] - w[1]) + w[1] + w[0] * ms;
    const double es_m = f0 * (1 - m[0] - m[1]) + m[1] + m[0] * ms, schlick = pow(1 - facing, 5);
    const double plain = l * c->base * (1 - es_v) * (1 - es_l) / (1 - es_m) +
                         c->tint * (once * (f0 + (1 - f0) * schlick) + again * ms);
    const double at = 1. / 7, at82 = c->base + (1 - c->base) * pow(1 - at, 5),
                 dip = at82 * (1 - c->tint) / (at * pow(1 - at, 6));
    const double f = c->base + (1 - c->base) * schlick - dip * facing * pow(1 - facing, 6);
    const double mean_m = c->base + (1 - c->base) / 21 - dip / 126,
                 ms_m = mean_m * mean_m * (1 - m[0]) / (1 - mean_m * m[0]);
    return (1 - c->metal) * plain + c->metal * (once * fmax(f, 0) + again * ms_m);
}

static void lobes_are_microfacets(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double worst = 0;
    GlContext *gl = frame_context();
    run(gl, lobes, reported);
    /* rows above the first, whose lobe is narrower than floats of the directions */
    for (int i = SIDE; i < SIDE * SIDE; i += 3) {
        const double base[3] = {varied(i, .618), varied(i, .382), .9},
                     tint[3] = {1, varied(i, .271), .8};
        const double turn = 3.14159 + (.5 - varied(i, .91)) * rough_of(i / SIDE);
        for (int component = 0; component < 3; component++) {
            const Case c = {base[component], tint[component], varied(i, .733), rough_of(i / SIDE),
                            .3 * varied(i, .137)};
            const double want = lobe_of(&c, cosine_of(i % SIDE), .05 + .9 * varied(i, .5701), turn);
            worst = fmax(worst, fabs(reported[i][component] - want) / (.25 + want));
        }
    }
    gl_close(gl);
    print_message("lobes: within %.4f\n", worst);
    assert_true(worst < .01);
}

static void white_sends_all(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double least[3] = {2, 2, 2}, most[3] = {0}, colored = 0;
    GlContext *gl = frame_context();
    run(gl, furnace, reported);
    for (int i = 0; i < SIDE * SIDE; i++) {
        for (int k = 0; k < 3; k++) {
            least[k] = fmin(least[k], (double)reported[i][k]);
            most[k] = fmax(most[k], (double)reported[i][k]);
        }
        colored = fmax(colored, (double)reported[i][3]);
    }
    gl_close(gl);
    for (int k = 0; k < 3; k++)
        print_message("white, %s: %.4f to %.4f\n",
                      (const char *[]){"dielectric", "metal", "between"}[k], least[k], most[k]);
    for (int k = 0; k < 3; k++)
        assert_true(least[k] > .99 && most[k] < 1.01);
    assert_true(colored < 1);
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

/* The share of GGX's reflection that comes from the parallelogram, by visible normals (Heitz
 * 2018). */
static double share_of_area(int i)
{
    enum { RINGS = 192 };
    const double cosine = .1 + .9 * (i % SIDE) / (SIDE - 1),
                 a = pow(.1 + .9 * (i / SIDE) / (SIDE - 1), 2),
                 size = exp(1.5 - 3.5 * varied(i, .733));
    const double z = fmin(fmax(cosine + .5 * (varied(i, .618) - .5), .05), 1),
                 turn = PI + 2 * (varied(i, .382) - .5), flat = sqrt(1 - z * z);
    const double to[3] = {flat * cos(turn), flat * sin(turn), z},
                 vx = sqrt(fmax(1 - cosine * cosine, 0)), w = hypot(a * vx, cosine),
                 wx = a * vx / w, wz = cosine / w;
    double x[3] = {.52 * to[1] - .8 * to[2], .3 * to[2] - .52 * to[0], .8 * to[0] - .3 * to[1]},
           seen = 0, all = 0;
    const double length = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    for (int k = 0; k < 3; k++)
        x[k] /= length;
    const double y[3] = {to[1] * x[2] - to[2] * x[1], to[2] * x[0] - to[0] * x[2],
                         to[0] * x[1] - to[1] * x[0]};
    for (int k = 0; k < RINGS * RINGS; k++) {
        const double r = sqrt((k / RINGS + .5) / RINGS), f = 2 * PI * (k % RINGS + .5) / RINGS,
                     t = r * cos(f), half = .5 + .5 * wz;
        const double s = (1 - half) * sqrt(fmax(1 - t * t, 0)) + half * r * sin(f),
                     up = sqrt(fmax(1 - t * t - s * s, 0));
        double h[3] = {a * (s * -wz + up * wx), a * t, fmax(s * wx + up * wz, 0)};
        const double steep = sqrt(h[0] * h[0] + h[1] * h[1] + h[2] * h[2]),
                     facing = (vx * h[0] + cosine * h[2]) / steep;
        const double l[3] = {2 * facing * h[0] / steep - vx, 2 * facing * h[1] / steep,
                             2 * facing * h[2] / steep - cosine};
        if (l[2] <= 0)
            continue;
        const double eye = sqrt(a * a + (1 - a * a) * cosine * cosine),
                     light = sqrt(a * a + (1 - a * a) * l[2] * l[2]);
        const double share = l[2] * (cosine + eye) / (cosine * light + l[2] * eye),
                     front = l[0] * to[0] + l[1] * to[1] + l[2] * to[2];
        const bool inside = front > 0 &&
                            fabs(l[0] * x[0] + l[1] * x[1] + l[2] * x[2]) < size * front &&
                            fabs(l[0] * y[0] + l[1] * y[1] + l[2] * y[2]) < .6 * size * front;
        all += share;
        seen += inside ? share : 0;
    }
    return seen / all;
}

static void parallelograms_are_integrals(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double worst[2] = {0}, squares[2] = {0};
    GlContext *gl = frame_context();
    run_texts(gl,
              (const char *const[]){head, render_text_light_area, surface_model_principled.text,
                                    tools, areas, NULL, NULL},
              reported);
    gl_close(gl);
    for (int i = 0; i < SIDE * SIDE; i++) {
        const double want = share_of_area(i);
        for (int k = 0; k < 2; k++) {
            const double error = fabs((double)reported[i][k] - want);
            worst[k] = fmax(worst[k], error);
            squares[k] += error * error / (SIDE * SIDE);
        }
    }
    print_message(
        "parallelograms: within %.3f, root of the mean square %.4f; Phong's lobes %.3f, %.4f\n",
        worst[0], sqrt(squares[0]), worst[1], sqrt(squares[1]));
    assert_true(worst[0] < .1 && sqrt(squares[0]) < .02);
}

/* matc's unpacking code for a layout, followed by the lobe, compiles without other code. */
static void stands_behind_unpacking(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    /* the last with the one case that the material takes */
    static const char *const layouts[] = {"compact", "integer", "compact"};
    static const char text[] = "material: Principled\nbaseColor: 1\n";
    static const char body[] =
        "vec4 passPixel(ivec2 p) { Surface s = unpackTexels(TEXELS); s.normal = vec3(0.0, 0.0, "
        "1.0); s.diffuse = s.specular = vec3(1.0); "
        "s.metalness = 0.0; s.roughness = 1.0; s.reflectance = 0.04; s.emissive = vec3(0.0);\n"
        "#ifdef SURFACE_HAS_coat\n    s.coatTint = vec3(1.0); s.transparency = vec3(0.0); s.coat = "
        "s.fuzz = 0.0; s.transmission = 0.0; s.diffuseTransparency = vec3(0.0);\n#endif\n#ifdef "
        "SURFACE_HAS_anisotropy\n    s.anisotropy = vec2(0.0);\n#endif\n    return "
        "vec4(surfaceAmbient(surfaceLit(s, vec3(0.0, 0.0, 1.0)), vec3(1.0)) + "
        "surfaceOwn(surfaceLit(s, vec3(0.0, 0.0, 1.0))), 1.0); }\n";
    for (int i = 0; i < 3; i++) {
        MatcOptions options;
        matc_options_init(&options);
        options.layout = layouts[i];
        options.cases = i == 2 ? 1u << 4 : 0;
        MatcDocument *document = matc_read("test.yaml", text, sizeof text - 1, &options);
        MatcProgram *program = matc_compile(document, 0, MATC_UNPACK, &options);
        assert_true(matc_ok(program));
        GlContext *gl = frame_context();
        const char *const texts[] = {matc_output(program, MATC_UNPACK, NULL),
                                     i == 1 ? "#define TEXELS uvec4(0u), uvec4(0u), uvec4(0u)\n"
                                            : "#define TEXELS uvec4(0u)\n"};
        run_texts(gl,
                  (const char *const[]){texts[0], surface_model_principled.text,
                                        surface_model_principled.more[0],
                                        surface_model_principled.more[1],
                                        surface_model_principled.more[2], texts[1], body},
                  reported);
        gl_close(gl);
        matc_program_free(program);
        matc_document_free(document);
        assert_true(fabs((double)reported[0][0] - 1) < .01);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(albedos_are_fitted),
                                       cmocka_unit_test(lobes_are_microfacets),
                                       cmocka_unit_test(white_sends_all),
                                       cmocka_unit_test(light_and_eye_change_places),
                                       cmocka_unit_test(parallelograms_are_integrals),
                                       cmocka_unit_test(stands_behind_unpacking)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
