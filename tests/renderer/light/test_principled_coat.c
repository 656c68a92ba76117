/* A coat with its own normal: the slot's value by OpenPBR's definition; the coat's lobe around
 * the normal against GGX in double; reciprocity; energy conservation. */
#include "tests/slot_values.h"
#include "runtime/surface/surface_model.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/pass_values.h"
#include "tests/lobe_claims.h"
#include "tests/vectors.h"

enum { SIDE = 20 };

/* Coats are tilted by up to 40 degrees. */
static const char head[] =
    "struct Surface { vec3 normal, diffuse, specular; float metalness, roughness, reflectance, "
    "coat, coatRoughness, coatReflectance; vec3 coatNormal; };\n"
    "#define SURFACE_HAS_normal\n#define SURFACE_HAS_diffuse\n#define "
    "SURFACE_HAS_specular\n#define SURFACE_HAS_metalness\n#define SURFACE_HAS_roughness\n"
    "#define SURFACE_HAS_reflectance\n#define SURFACE_HAS_coat\n#define "
    "SURFACE_HAS_coatRoughness\n#define SURFACE_HAS_coatReflectance\n#define "
    "SURFACE_HAS_coatNormal\n";
static const char tools[] =
    "vec3 toward(float cosine, float turn) { float s = sqrt(max(1.0 - cosine * cosine, 0.0)); "
    "return vec3(s * cos(turn), s * sin(turn), cosine); }\n"
    "float varied(ivec2 p, float step) { return fract(0.5 + step * float(p.x + 20 * p.y)); }\n"
    "vec3 eyeOf(ivec2 p) { return toward(0.3 + 0.7 * varied(p, 0.618), 0.0); }\n"
    "vec3 lightOf(ivec2 p) { return toward(0.3 + 0.7 * varied(p, 0.5701), 6.2831853 * varied(p, "
    "0.91)); }\n"
    "vec3 tiltOf(ivec2 p) { return toward(cos(0.7 * varied(p, 0.382)), 6.2831853 * varied(p, "
    "0.733)); }\n"
    "Surface made(ivec2 p, float base) { return Surface(vec3(0.0, 0.0, 1.0), vec3(base), "
    "vec3(base), 0.0, 0.2 + 0.8 * varied(p, 0.29), 0.04, 1.0, 0.2 + 0.8 * varied(p, 0.137), "
    "0.0533, tiltOf(p)); }\n";
/* A black base: the coat alone. A white base, over its value without the coat: both ways. */
static const char parts[] =
    "float coatAlone(ivec2 p, vec3 v, vec3 l) { return surfaceLobe(surfaceLit(made(p, 0.0), v), "
    "l).x; }\n"
    "float below_(ivec2 p, vec3 v, vec3 l) { return surfaceLobe(surfaceLit(made(p, 1.0), v), l).x "
    "- coatAlone(p, v, l); }\n"
    "vec4 passPixel(ivec2 p) { vec3 v = eyeOf(p), l = lightOf(p), n = tiltOf(p);\n"
    "    float a = coatAlone(p, v, l) / max(dot(n, l), 1e-3), b = coatAlone(p, l, v) / max(dot(n, "
    "v), 1e-3), c = below_(p, v, l) / l.z, d = below_(p, l, v) / v.z;\n"
    "    return vec4(coatAlone(p, v, l), abs(a - b) / max(a + b, 1e-3), abs(c - d) / (c + d), "
    "1.0); }\n";
static const char furnace[] =
    "vec4 passPixel(ivec2 p) {\n"
    "    Lit m = surfaceLit(made(p, 1.0), eyeOf(p));\n"
    "    float sum = 0.0;\n"
    "    for (int i = 0; i < 4096; i++) {\n"
    "        vec2 u = fract(vec2(0.7548776662, 0.5698402910) * float(i) + 0.5);\n"
    "        vec3 l = toward(u.x, 6.2831853 * u.y);\n"
    "        sum += 2.0 * surfaceLobe(m, l).x;\n"
    "    }\n"
    "    return vec4(sum / 4096.0, surfaceAmbient(m, vec3(1.0)).x, 0.0, 1.0);\n}\n";

static void run(const char *body, float (*reported)[4])
{
    const SurfaceModel *model = &surface_model_principled;
    const ScreenPassText text = {
        .body = {head, model->text, model->more[0], model->more[1], model->more[2], tools, body},
        .format = "RGBA32F"};
    GlContext *gl = frame_context();
    pass_values(gl, &text, SIDE, reported);
    gl_close(gl);
}

static double varied(int i, double step) { return fmod(.5 + step * i, 1); }

static void toward(double cosine, double turn, double v[3])
{
    const double s = sqrt(fmax(1 - cosine * cosine, 0));
    v[0] = s * cos(turn), v[1] = s * sin(turn), v[2] = cosine;
}

/* GGX about n, by Fresnel's term of Schlick, times the cosine and pi. */
static double coat_of(double rough, double reflectance, const double n[3], const double v[3],
                      const double l[3])
{
    const double sum[3] = {v[0] + l[0], v[1] + l[1], v[2] + l[2]}, size = sqrt(dot(sum, sum)),
                 a2 = pow(rough, 4);
    const double high = dot(n, sum) / size, facing = dot(v, sum) / size, cv = dot(n, v),
                 cl = dot(n, l);
    if (cl <= 0)
        return 0;
    const double d = a2 / (LOBE_PI * pow(high * high * (a2 - 1) + 1, 2)),
                 masked = cl * sqrt(a2 + (1 - a2) * cv * cv) + cv * sqrt(a2 + (1 - a2) * cl * cl);
    return LOBE_PI * d / (2 * masked) * cl * (reflectance + (1 - reflectance) * pow(1 - facing, 5));
}

static void coats_lie_as_they_say(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double worst = 0, turned[2] = {0};
    /* angles are fractions of floats up to 400, 3e-5 off: what a lobe of width 0.04 shows as
     * 1e-3 */
    int seen = 0;
    run(parts, reported);
    for (int i = 0; i < SIDE * SIDE; i++) {
        double v[3], l[3], n[3];
        toward(.3 + .7 * varied(i, .618), 0, v);
        toward(.3 + .7 * varied(i, .5701), 2 * LOBE_PI * varied(i, .91), l);
        toward(cos(.7 * varied(i, .382)), 2 * LOBE_PI * varied(i, .733), n);
        if (dot(n, v) < .05 || fabs(dot(n, l)) < .05)
            continue;
        const double want = coat_of(.2 + .8 * varied(i, .137), .0533, n, v, l);
        worst = fmax(worst, fabs((double)reported[i][0] - want) / (.25 + want));
        turned[0] = fmax(turned[0], dot(n, l) > 0 ? (double)reported[i][1] : 0);
        turned[1] = fmax(turned[1], (double)reported[i][2]);
        seen++;
    }
    print_message("of %d coats: within %.1e; changed places: the coat %.1e, what lies below %.1e\n",
                  seen, worst, turned[0], turned[1]);
    assert_true(seen > 300 && worst < 2e-3 && turned[0] < 2e-5 && turned[1] < 2e-5);
}

/* Light that the coat reflects below the surface is lost: less light leaves than arrives. */
static void sends_no_more_than_arrives(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double most = 0, around = 0;
    run(furnace, reported);
    for (int i = 0; i < SIDE * SIDE; i++) {
        most = fmax(most, (double)reported[i][0]);
        around = fmax(around, fabs((double)reported[i][1] - 1));
    }
    print_message("white under tilted coats: at most %.4f; of ambient light 1 within %.4f\n", most,
                  around);
    assert_true(most < 1.05 && around < .01);
}

static void expect_coat(const char *text, const char *at, const double want[3])
{
    char *values = values_at(text, at, NULL);
    expect_slot(values, "coatNormal", want, 3);
    free(values);
}

/* As in OpenPBR, a coat without its own normal has the geometry's, not that of the base. */
static void slots_are_openpbrs(void **state)
{
    (void)state;
#define BASE "material: Principled\ninput: { map: NormalMap, normal: [0.8, 0.5, 0.9] }\n"
    expect_coat(BASE "coat: 1\n", "u=0.3 v=0.4", (double[]){0, 0, 1});
    expect_coat(BASE "coat: 0\n", "u=0.3 v=0.4", (double[]){0, 0, 0});
    expect_coat("material: Principled\ncoat: 1\n", "u=0.3 v=0.4", (double[]){0, 0, 0});
    expect_coat(
        "material: Principled\ncoat: 1\ncoatNormal: { map: NormalMap, normal: [0.8, 0.5, 0.9] }\n",
        "u=0.3", (double[]){.6, 0, .8});
    expect_coat("material: glTF\nclearcoatFactor: 1\nclearcoatNormalTexture: [0.5, 0.8, 0.9]\n",
                "u=0.3", (double[]){0, .6, .8});
    expect_coat("material: Layer\nbase: { material: Principled, coat: 1, coatNormal: { map: "
                "NormalMap, normal: [0.8, 0.5, 0.9] } }\ncoat: '= step(.5, u)'\n",
                "u=0.3 v=0.4", (double[]){.6, 0, .8});
    expect_coat("material: Layer\nbase: { material: Principled, coat: 1, coatNormal: { map: "
                "NormalMap, normal: [0.8, 0.5, 0.9] } }\ncoat: '= step(.5, u)'\n",
                "u=0.7 v=0.4", (double[]){0, 0, 0});
    expect_coat("material: Layer\nbase: { material: Principled, input: { map: NormalMap, normal: "
                "[0.8, 0.5, 0.9] } }\n",
                "u=0.3", (double[]){0, 0, 1});
    expect_coat("material: Layer\nbase: { material: Phong, input: { map: NormalMap, normal: [0.8, "
                "0.5, 0.9] } }\n",
                "u=0.3", (double[]){0, 0, 1});
    expect_coat("material: Layer\nbase: { material: Phong, input: &a { map: NormalMap, normal: "
                "[0.8, 0.5, 0.9] } }\ncoatNormal: *a\n",
                "u=0.3", (double[]){0, 0, 0});
    expect_coat("material: Layer\nbase: { material: Phong }\ncoatNormal: { map: NormalMap, normal: "
                "[0.8, 0.5, 0.9] }\n",
                "u=0.3", (double[]){.6, 0, .8});
    expect_coat("material: Layer\nbase: { material: Mix, mask: 1, a: { material: Phong, input: { "
                "map: BumpMap } }, b: { material: Phong } }\n",
                "u=0.3", (double[]){0, 0, 1});
    expect_coat("material: Layer\nbase: { material: Mix, mask: 1, a: { material: Phong }, b: { "
                "material: Principled } }\n",
                "u=0.3", (double[]){0, 0, 0});
    expect_coat("material: Mix\nmask: 0.5\na: { material: Principled, coat: 1, coatNormal: { map: "
                "NormalMap, normal: [0.8, 0.5, 0.9] } }\n"
                "b: { material: Principled, coat: 1, coatNormal: { map: NormalMap, normal: [0.2, "
                "0.5, 0.9] } }\n",
                "u=0.3", (double[]){0, 0, 1});
    expect_coat("material: Mix\nmask: 0.5\na: { material: Principled, coat: 1, coatNormal: { map: "
                "NormalMap, normal: [0.8, 0.5, 0.9] } }\nb: { material: Principled }\n",
                "u=0.3", (double[]){.6, 0, .8});
}

/* A value of weight 0 has no effect, however large it is. */
static void what_does_not_count_is_not_seen(void **state)
{
    (void)state;
    static const struct {
        const char *text, *slot;
        double want[3];
        int components;
    } rows[] = {
        {"material: Principled\nroughness: 1e20\ncoat: 1\n", "roughness", {1}, 1},
        {"material: Layer\nbase: { material: Principled, roughness: 1e20 }\n", "roughness", {1}, 1},
        {"material: Principled\nior: 1e20\ncoat: 0\n", "reflectance", {1}, 1},
        {"material: Principled\nspecular: 1e20\ntransmission: 1\nthinWalled: true\n",
         "reflectance",
         {2},
         1},
        {"material: Principled\nbaseColor: [1e20, 1, 0]\nsubsurface: 1\nsubsurfaceColor: [0.2, "
         "0.4, 0.6]\n",
         "diffuse",
         {.2, .4, .6},
         3},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char *values = values_at(rows[i].text, "u=0.3 v=0.4", NULL);
        expect_slot(values, rows[i].slot, rows[i].want, rows[i].components);
        free(values);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_does_not_count_is_not_seen), cmocka_unit_test(coats_lie_as_they_say),
        cmocka_unit_test(sends_no_more_than_arrives), cmocka_unit_test(slots_are_openpbrs)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
