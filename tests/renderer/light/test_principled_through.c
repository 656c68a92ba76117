/* Light transmitted by a Principled surface: as by a dielectric, and diffusely by thin walls.
 * Reflection and transmission of a white surface add up to 1; light from behind equals integrals
 * in double, and is reciprocal; each kind of surface has its own program. */
#include "tests/test.h"
#include "runtime/surface/surface_model.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/pass_values.h"
#include "tests/lobe_claims.h"
#include <stdlib.h>

enum { SIDE = 20 };

/* A pixel is a roughness, by its row, and an angle, by its column: cosines from 0.1 on. */
static const char head[] =
    "struct Surface { vec3 normal, diffuse, specular; float metalness, roughness, reflectance; "
    "vec3 transparency; float transmission; vec3 diffuseTransparency;\n"
    "    float coat; vec3 coatTint; float coatRoughness, coatReflectance; };\n"
    "#define SURFACE_HAS_normal\n#define SURFACE_HAS_diffuse\n#define "
    "SURFACE_HAS_specular\n#define SURFACE_HAS_metalness\n#define SURFACE_HAS_roughness\n"
    "#define SURFACE_HAS_reflectance\n#define SURFACE_HAS_transparency\n#define "
    "SURFACE_HAS_transmission\n#define SURFACE_HAS_diffuseTransparency\n"
    "#define SURFACE_HAS_coat\n#define SURFACE_HAS_coatTint\n#define "
    "SURFACE_HAS_coatRoughness\n#define SURFACE_HAS_coatReflectance\n";
static const char tools[] = LOBE_PIXELS
    "Surface made(float base, float behind, float clear, float rough, float reflectance, vec2 "
    "coat) { return Surface(vec3(0.0, 0.0, 1.0), vec3(base), vec3(1.0), 0.0, rough,\n"
    "    reflectance, vec3(clear), clear, vec3(behind), coat.x, vec3(1.0), coat.y, 0.0533); }\n"
    "Surface leaf(ivec2 p) { return made(0.7 * varied(p, 0.618), varied(p, 0.382), 0.0, "
    "roughOf(p), 0.2 * varied(p, 0.137), vec2(0.0)); }\n";
static const char furnace[] = LOBE_MICROFACET LOBE_SEEN
    "float sent(Surface surface, vec3 v) {\n"
    "    Lit m = surfaceLit(surface, v);\n"
    "    float sum = 0.0;\n"
    "    for (int i = 0; i < 1536; i++) {\n"
    "        vec2 u = fract(vec2(0.7548776662, 0.5698402910) * float(i) + 0.5);\n"
    "        int of = i % 3;\n"
    "        vec3 even = toward(sqrt(u.x), 6.2831853 * u.y), l = of == 2 ? even : reflect(-v, "
    "facet(v, of == 0 ? m.alpha : m.coatAlpha, u));\n"
    "        if (l.z > 0.0) sum += surfaceLobe(m, l).x / (seen(v, l, m.alpha) + seen(v, l, "
    "m.coatAlpha) + l.z) * 3.0;\n"
    "        if (of == 2) sum += 3.0 * surfaceLobe(m, -even).x / even.z;\n"
    "    }\n"
    "    return sum / 1536.0 + surfaceThrough(surface, v).x;\n}\n"
    "vec4 passPixel(ivec2 p) {\n"
    "    vec3 v = toward(cosineOf(p), 0.0);\n"
    "    float rough = roughOf(p), other = 0.1 + 0.9 * varied(p, 0.29), g = varied(p, 0.618);\n"
    "    return vec4(sent(made(1.0 - g, g, 0.0, rough, 0.04, vec2(0.0, 0.5)), v), sent(made(0.0, "
    "0.0, 1.0, rough, 0.04, vec2(0.0, 0.5)), v),\n"
    "        sent(made(1.0 - g, g, 0.0, rough, 0.04, vec2(1.0, other)), v), "
    "surfaceThrough(made(0.0, 0.0, 1.0, rough, 0.1, vec2(0.0, 0.5)), v).x);\n}\n";
static const char lobes[] =
    "vec4 passPixel(ivec2 p) { Lit m = surfaceLit(leaf(p), toward(cosineOf(p), 0.0)); "
    "return vec4(surfaceLobe(m, toward(-0.05 - 0.9 * varied(p, 0.5701), 6.28 * varied(p, "
    "0.91))).x, surfaceEven(m).x, surfaceAmbient(m, vec3(1.0)).x, 1.0); }\n";
/* The eye on the other side sees the other normal. Of light behind by component 0, before by
 * component 1; through by component 2. */
static const char turned[] =
    "vec4 passPixel(ivec2 p) {\n"
    "    vec3 v = toward(cosineOf(p), 0.0), l = toward(0.05 + 0.95 * varied(p, 0.5701), 6.2831853 "
    "* varied(p, 0.91)), back = l * vec3(1.0, 1.0, -1.0);\n"
    "    Surface s = leaf(p), other = s;\n"
    "    s.coat = other.coat = varied(p, 0.43);\n"
    "    other.normal = -s.normal;\n"
    "    float a = surfaceLobe(surfaceLit(s, v), back).x / l.z, b = surfaceLobe(surfaceLit(other, "
    "back), v).x / v.z;\n"
    "    float c = surfaceLobe(surfaceLit(s, v), l).x / l.z, d = surfaceLobe(surfaceLit(s, l), "
    "v).x / v.z;\n"
    "    Surface glass = made(0.1, 0.0, 0.7, roughOf(p), 0.05, vec2(0.3)), behind = glass;\n"
    "    behind.normal = -glass.normal;\n"
    "    float e = surfaceThrough(glass, v).x, f = surfaceThrough(behind, -v).x;\n"
    "    return vec4(abs(a - b) / (a + b + 1e-6), abs(c - d) / (c + d), abs(e - f) / (e + f), "
    "1.0);\n}\n";
/* Cut-outs and transmission combined: half of the surface is present, and four fifths of that
 * transmit light. */
static const char holes[] =
    "vec4 passPixel(ivec2 p) { Surface s = made(1.0, 0.0, 0.5 + 0.4, 0.0, 0.04, vec2(0.0)); "
    "s.transmission = 0.4; s.diffuse = vec3(0.2);\n"
    "    vec3 v = vec3(0.0, 0.0, 1.0); Lit m = surfaceLit(s, v); return vec4(surfaceThrough(s, "
    "v).x, m.kept, surfaceAmbient(m, vec3(1.0)).x, 1.0); }\n";

static void run(GlContext *gl, const char *lacks, const char *body, float (*reported)[4])
{
    const SurfaceModel *model = &surface_model_principled;
    const ScreenPassText text = {.body = {head, lacks, model->text, model->more[0], model->more[1],
                                          model->more[2], model->more[3], tools, body},
                                 .format = "RGBA32F"};
    pass_values(gl, &text, SIDE, reported);
}

static double rough_of(int y) { return .0316227766 + .9683772 * y / (SIDE - 1); }
static double cosine_of(int x) { return .1 + .9 * x / (SIDE - 1); }
static double varied(int i, double step) { return fmod(.5 + step * i, 1); }

static void white_is_all(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double least[3] = {2, 2, 2}, most[3] = {0}, through = 0;
    GlContext *gl = frame_context();
    run(gl, "", furnace, reported);
    gl_close(gl);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double own[2];
        lobe_albedo(cosine_of(i % SIDE), pow(rough_of(i / SIDE), 2), own);
        through =
            fmax(through, fabs((double)reported[i][3] - (1 - .1 * (1 - own[0]) - .9 * own[1])));
        for (int k = 0; k < 3; k++) {
            least[k] = fmin(least[k], (double)reported[i][k]);
            most[k] = fmax(most[k], (double)reported[i][k]);
        }
    }
    print_message("through glass: within %.4f\n", through);
    for (int k = 0; k < 3; k++)
        print_message("white, %s: %.4f to %.4f\n",
                      (const char *[]){"leaf", "glass", "leaf under a coat"}[k], least[k], most[k]);
    for (int k = 0; k < 3; k++)
        assert_true(least[k] > .99 && most[k] < 1.01);
    assert_true(through < .005);
}

/* Albedos of a dielectric: the reflection toward v, in the mean, and after multiple scattering. */
static double reflected(const double own[2], double f0, double again)
{
    return f0 * (1 - own[0] - own[1]) + own[1] + own[0] * again;
}

static void light_from_behind_is_an_integral(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double worst = 0, whole = 0;
    GlContext *gl = frame_context();
    run(gl, "#define SURFACE_MISSING_coat\n", lobes, reported);
    gl_close(gl);
    for (int i = 0; i < SIDE * SIDE; i += 3) {
        const double a = pow(rough_of(i / SIDE), 2), f0 = .2 * varied(i, .137),
                     l = .05 + .9 * varied(i, .5701), behind = varied(i, .382);
        const double f = f0 + (1 - f0) / 21;
        double v[2], w[2], m[2];
        lobe_albedo(cosine_of(i % SIDE), a, v);
        lobe_albedo(l, a, w);
        lobe_mean(a, m);
        const double again = f * f * (1 - m[0]) / (1 - f * m[0]);
        const double out = 1 - reflected(v, f0, again), in = 1 - reflected(w, f0, again),
                     mean = 1 - reflected(m, f0, again);
        worst = fmax(worst, fabs(reported[i][0] - l * behind * in * out / mean));
        whole = fmax(
            whole, fabs(reported[i][2] - reported[i][1] - behind * out - reflected(v, f0, again)));
    }
    print_message("from behind: within %.4f, from all around %.4f\n", worst, whole);
    assert_true(worst < .006 && whole < .01);
}

static void light_and_eye_change_places(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    GlContext *gl = frame_context();
    run(gl, "", turned, reported);
    gl_close(gl);
    lobe_changes_places(reported, SIDE * SIDE);
}

static void holes_reflect_nothing(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    GlContext *gl = frame_context();
    run(gl, "#define SURFACE_MISSING_diffuseTransparency\n", holes, reported);
    assert_true(fabs((double)reported[0][1] - .5) < 1e-6 &&
                fabs((double)reported[0][0] - (.5 + .4 * .96)) < 1e-3);
    assert_true(fabs((double)reported[0][2] - .5 * (.04 + .2 * .96)) < 1e-3);
    /* all of it is a hole then */
    run(gl, "#define SURFACE_MISSING_transmission\n#define SURFACE_MISSING_diffuseTransparency\n",
        holes, reported);
    gl_close(gl);
    assert_true(fabs((double)reported[0][0] - .9) < 1e-6 &&
                fabs((double)reported[0][1] - .1) < 1e-6);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(white_is_all), cmocka_unit_test(light_from_behind_is_an_integral),
        cmocka_unit_test(light_and_eye_change_places), cmocka_unit_test(holes_reflect_nothing)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
