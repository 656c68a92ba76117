/* Anisotropic Principled surfaces: fits of their albedos and the lobe against integrals and
 * definitions in double, a white furnace, reciprocity, and directions decoded from the G-buffer. */
#include "tests/test.h"
#include "compiler/library/chunk.h"
#include "runtime/surface/surface_model.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/pass_values.h"
#include "tests/lobe_claims.h"
#include "tests/vectors.h"
#include <math.h>
#include <string.h>

enum { SIDE = 20 };

/* A pixel is a roughness, by its row, and an angle, by its column: cosines from 0.1 on; strength
 * and azimuth vary from pixel to pixel. */
static const char head[] =
    "struct Surface { vec3 normal, diffuse, specular; float metalness, roughness, reflectance, "
    "coat, coatRoughness, "
    "coatReflectance; vec2 anisotropy; };\n"
    "#define SURFACE_HAS_normal\n#define SURFACE_HAS_diffuse\n#define SURFACE_HAS_specular\n"
    "#define SURFACE_HAS_metalness\n#define SURFACE_HAS_roughness\n#define "
    "SURFACE_HAS_reflectance\n"
    "#define SURFACE_HAS_coat\n#define SURFACE_HAS_coatRoughness\n#define "
    "SURFACE_HAS_coatReflectance\n#define "
    "SURFACE_HAS_anisotropy\n";
static const char tools[] =
    "const float SIDE = 20.0;\n"
    "float roughOf(ivec2 p) { return 0.0316227766 + 0.9683772 * float(p.y) / (SIDE - 1.0); }\n"
    "float cosineOf(ivec2 p) { return 0.1 + 0.9 * float(p.x) / (SIDE - 1.0); }\n"
    "float varied(ivec2 p, float step) { return fract(0.5 + step * float(p.x + 20 * p.y)); }\n"
    "vec3 toward(float cosine, float turn) { float s = sqrt(max(1.0 - cosine * cosine, 0.0)); "
    "return vec3(s * cos(turn), s * sin(turn), cosine); }\n"
    "vec3 eyeOf(ivec2 p) { return toward(cosineOf(p), 6.2831853 * varied(p, 0.2391)); }\n"
    "vec3 lightOf(ivec2 p) { return toward(0.05 + 0.95 * varied(p, 0.5701), 6.2831853 * varied(p, "
    "0.91)); }\n"
    "vec2 directionOf(ivec2 p) { float t = 6.2831853 * varied(p, 0.1733); return varied(p, 0.4142) "
    "* vec2(cos(2.0 * "
    "t), sin(2.0 * t)); }\n"
    "Surface made(vec3 base, vec3 numbers, vec3 coat, vec2 direction) { return Surface(vec3(0.0, "
    "0.0, 1.0), base, "
    "vec3(1.0), numbers.x, numbers.y, numbers.z, "
    "coat.x, coat.y, coat.z, direction); }\n"
    "Surface mixed(ivec2 p) { return made(vec3(varied(p, 0.618), varied(p, 0.382), 0.9), "
    "vec3(varied(p, 0.733), "
    "roughOf(p), 0.3 * varied(p, 0.137)), "
    "vec3(varied(p, 0.415), 0.2 + 0.8 * varied(p, 0.29), 0.1 * varied(p, 0.653)), directionOf(p)); "
    "}\n";
static const char fits[] = "vec4 passPixel(ivec2 p) { Anisotropy m = anisotropyOf(directionOf(p), "
                           "vec3(0.0, 0.0, 1.0), roughOf(p));\n"
                           "    return vec4(albedoAlong(cosineOf(p), anisotropyToward(m, "
                           "eyeOf(p)), m), albedoAround(cosineOf(p), m)); }\n";
/* Around the mirrored direction, as wide as the lobe is. */
static const char lobes[] =
    "vec4 passPixel(ivec2 p) { Anisotropy m = anisotropyOf(directionOf(p), "
    "vec3(0.0, 0.0, 1.0), roughOf(p));\n"
    "    vec3 v = eyeOf(p), l = normalize(reflect(-v, vec3(0.0, 0.0, 1.0)) "
    "+ roughOf(p) * roughOf(p) * (lightOf(p) - "
    "vec3(0.0, 0.0, 0.4)));\n"
    "    l.z = max(l.z, 0.05); l = normalize(l);\n"
    "    return vec4(microfacetsAlong(m, vec3(0.0, 0.0, 1.0), l, normalize(l + "
    "v), l.z, vec2(v.z, maskedAlong(m, v, v.z))), l); }\n";
/* Half of the directions by visible normals (Heitz 2018), half by the cosine; the coat is rough. */
static const char furnace[] =
    "float sent(Surface surface, vec3 v) {\n"
    "    Lit m = surfaceLit(surface, v);\n"
    "    Anisotropy a = m.anisotropy;\n"
    "    vec3 n = vec3(0.0, 0.0, 1.0), w = normalize(vec3(a.widths * vec2(dot(v, a.along), dot(v, "
    "a.across)), v.z));\n"
    "    vec3 t = w.z < 0.9999 ? normalize(vec3(-w.y, w.x, 0.0)) : vec3(1.0, 0.0, 0.0), s = "
    "cross(w, t);\n"
    "    float sum = 0.0;\n"
    "    for (int i = 0; i < 1536; i++) {\n"
    "        vec2 u = fract(vec2(0.7548776662, 0.5698402910) * float(i) + 0.5);\n"
    "        float r = sqrt(u.x), x = r * cos(6.2831853 * u.y), y = mix(sqrt(max(1.0 - x * x, "
    "0.0)), r * sin(6.2831853 "
    "* u.y), 0.5 + 0.5 * w.z);\n"
    "        vec3 f = x * t + y * s + sqrt(max(1.0 - x * x - y * y, 0.0)) * w;\n"
    "        vec3 h = normalize(a.widths.x * f.x * a.along + a.widths.y * f.y * a.across + "
    "max(f.z, 1e-6) * n);\n"
    "        vec3 l = (i & 1) == 0 ? reflect(-v, h) : toward(sqrt(u.x), 6.2831853 * u.y);\n"
    "        if (l.z <= 0.0) continue;\n"
    "        vec3 between = normalize(v + l);\n"
    "        vec2 off = vec2(dot(between, a.along), dot(between, a.across)) / a.widths;\n"
    "        float size = between.z * between.z + dot(off, off), masked = length(vec3(a.widths * "
    "vec2(dot(v, a.along), "
    "dot(v, a.across)), v.z));\n"
    "        float seen = 2.0 * v.z / (v.z + masked) / (a.widths.x * a.widths.y * size * size * "
    "4.0 * v.z);\n"
    "        sum += surfaceLobe(m, l).x / (0.5 * (seen + l.z));\n"
    "    }\n"
    "    return sum / 1536.0;\n}\n"
    "vec4 passPixel(ivec2 p) {\n"
    "    float rough = roughOf(p);\n"
    "    return vec4(sent(made(vec3(1.0), vec3(0.0, rough, 0.04), vec3(0.0), directionOf(p)), "
    "eyeOf(p)),\n"
    "        sent(made(vec3(1.0), vec3(1.0, rough, 0.0), vec3(0.0), directionOf(p)), eyeOf(p)),\n"
    "        sent(made(vec3(1.0), vec3(0.0, rough, 0.04), vec3(1.0, 0.7, 0.0533), directionOf(p)), "
    "eyeOf(p)), "
    "sent(mixed(p), eyeOf(p)));\n}\n";
static const char turned[] = "vec4 passPixel(ivec2 p) {\n"
                             "    vec3 v = eyeOf(p), l = lightOf(p);\n"
                             "    vec3 a = surfaceLobe(surfaceLit(mixed(p), v), l) / l.z, b = "
                             "surfaceLobe(surfaceLit(mixed(p), l), v) / v.z;\n"
                             "    return vec4(abs(a - b) / (a + b), 1.0);\n}\n";
/* A normal, a tangent at right angles to it, the side on which dP/dv lies, and an angle: what
 * direction comes out. */
static const char frames[] =
    "vec4 passPixel(ivec2 p) {\n"
    "    float z = -0.98 + 1.98 * varied(p, 0.618);\n"
    "    vec3 n = toward(z, 6.2831853 * varied(p, 0.382)), x = normalize(cross(n, vec3(0.3, -0.8, "
    "0.52))), y = "
    "cross(n, x);\n"
    "    float turn = 6.2831853 * varied(p, 0.733), hand = varied(p, 0.271) < 0.5 ? -1.0 : 1.0, t "
    "= 3.14159 * "
    "varied(p, 0.137);\n"
    "    vec3 du = 3.0 * (cos(turn) * x + sin(turn) * y) + 0.7 * n, side = cos(turn) * y - "
    "sin(turn) * x, dv = 0.2 * "
    "hand * side + 0.1 * du;\n"
    "    vec2 stored = anisotropyStored(0.6 * vec2(cos(2.0 * t), sin(2.0 * t)), n, du, dv);\n"
    "    Anisotropy m = anisotropyOf(stored, n, 0.5);\n"
    "    vec3 want = cos(t) * normalize(du - dot(du, n) * n) + sin(t) * hand * side;\n"
    "    return vec4(length(cross(m.along, want)), abs(dot(m.along, n)) + length(cross(m.across, "
    "cross(n, m.along))), "
    "length(stored), m.widths.y / m.widths.x); }\n";

static const char *chunk(const char *name)
{
    for (int i = 0; i < chunk_count; i++)
        if (!strcmp(chunk_table[i].name, name))
            return chunk_table[i].body;
    fail_msg("no chunk %s", name);
    return "";
}

static void run(GlContext *gl, const char *body, float (*reported)[4])
{
    const SurfaceModel *model = &surface_model_principled;
    const ScreenPassText text = {.body = {head, chunk("anisotropyStored"), model->text,
                                          model->more[0], model->more[1], model->more[2], tools,
                                          body},
                                 .format = "RGBA32F"};
    pass_values(gl, &text, SIDE, reported);
}

/* A pixel's case, in double. */
typedef struct {
    /* along: x and y of the direction, whose other is (-y, x) */
    double eye[3], along[2], widths[2];
} Pixel;

static double varied(int i, double step) { return fmod(.5 + step * i, 1); }

static Pixel pixel_of(int i)
{
    const double rough = .0316227766 + .9683772 * (i / SIDE) / (SIDE - 1),
                 cosine = .1 + .9 * (i % SIDE) / (SIDE - 1),
                 sine = sqrt(fmax(1 - cosine * cosine, 0));
    const double turn = 2 * PI * varied(i, .2391), direction = 2 * PI * varied(i, .1733),
                 strength = varied(i, .4142);
    const double wide = rough * rough * sqrt(2 / (1 + (1 - strength) * (1 - strength)));
    return (Pixel){{sine * cos(turn), sine * sin(turn), cosine},
                   {cos(direction), sin(direction)},
                   {fmax(wide, .001), fmax(wide * (1 - strength), .001)}};
}

/* A direction by the widths: along, across, up. */
static void stretch(const Pixel *p, const double v[3], double to[3])
{
    to[0] = p->widths[0] * (v[0] * p->along[0] + v[1] * p->along[1]);
    to[1] = p->widths[1] * (v[1] * p->along[0] - v[0] * p->along[1]);
    to[2] = v[2];
}

/* Smith's Lambda. */
static double masking(const Pixel *p, const double v[3])
{
    double s[3];
    stretch(p, v, s);
    return (sqrt(1 + (s[0] * s[0] + s[1] * s[1]) / (s[2] * s[2])) - 1) / 2;
}

/* GGX's microfacets per solid angle, of two widths, their slopes being x and y. */
static double distribution(const Pixel *p, const double h[3])
{
    const double x = -(h[0] * p->along[0] + h[1] * p->along[1]) / h[2],
                 y = -(h[1] * p->along[0] - h[0] * p->along[1]) / h[2];
    const double slopes = 1 + x * x / pow(p->widths[0], 2) + y * y / pow(p->widths[1], 2);
    return 1 / (PI * p->widths[0] * p->widths[1] * slopes * slopes * pow(h[2], 4));
}

/* The loss, and the share of Schlick's grazing term: over half vectors, by the distribution's
 * slopes in polar coordinates. */
static void integrate(const Pixel *p, double found[2])
{
    enum { RINGS = 160, TURNS = 160 };
    double all = 0;
    found[1] = 0;
    for (int i = 0; i < RINGS * TURNS; i++) {
        const double share = (i / TURNS + .5) / RINGS, turn = 2 * PI * (i % TURNS + .5) / TURNS,
                     steep = sqrt(share / (1 - share));
        const double x = p->widths[0] * steep * cos(turn), y = p->widths[1] * steep * sin(turn),
                     size = 1 / sqrt(1 + x * x + y * y);
        const double h[3] = {-(x * p->along[0] - y * p->along[1]) * size,
                             -(x * p->along[1] + y * p->along[0]) * size, size};
        const double facing = dot(h, p->eye);
        double l[3];
        for (int k = 0; k < 3; k++)
            l[k] = 2 * facing * h[k] - p->eye[k];
        if (facing <= 0 || l[2] <= 0)
            continue;
        const double sent = facing / (p->eye[2] * h[2]) / (1 + masking(p, p->eye) + masking(p, l)) /
                            (RINGS * TURNS);
        all += sent;
        found[1] += sent * pow(1 - facing, 5);
    }
    found[0] = 1 - all;
}

static void fits_are_integrals(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double worst[2] = {0};
    GlContext *gl = frame_context();
    run(gl, fits, reported);
    gl_close(gl);
    for (int i = 0; i < SIDE * SIDE; i++) {
        const Pixel p = pixel_of(i);
        double found[2];
        integrate(&p, found);
        for (int k = 0; k < 2; k++)
            worst[k] = fmax(worst[k], fabs((double)reported[i][k] - found[k]));
    }
    print_message("what is lost: within %.4f, what grazes: %.4f\n", worst[0], worst[1]);
    assert_true(worst[0] < .012 && worst[1] < .007);
}

static void lobes_are_microfacets(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double worst = 0;
    GlContext *gl = frame_context();
    run(gl, lobes, reported);
    gl_close(gl);
    for (int i = 2 * SIDE; i < SIDE * SIDE;
         i++) { /* rows above the first, whose lobes are narrower than floats of the directions */
        const Pixel p = pixel_of(i);
        const double l[3] = {(double)reported[i][1], (double)reported[i][2],
                             (double)reported[i][3]};
        double h[3] = {p.eye[0] + l[0], p.eye[1] + l[1], p.eye[2] + l[2]};
        const double size = sqrt(dot(h, h));
        for (int k = 0; k < 3; k++)
            h[k] /= size;
        const double want =
            PI * distribution(&p, h) / (1 + masking(&p, p.eye) + masking(&p, l)) / (4 * p.eye[2]);
        worst = fmax(worst, fabs((double)reported[i][0] - want) / (.25 + want));
    }
    print_message("lobes: within %.1e\n", worst);
    assert_true(worst < .002);
}

static void white_sends_all(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double least[3] = {2, 2, 2}, most[4] = {0};
    GlContext *gl = frame_context();
    run(gl, furnace, reported);
    gl_close(gl);
    for (int i = 0; i < SIDE * SIDE; i++)
        for (int k = 0; k < 4; k++) {
            least[k % 3] = k < 3 ? fmin(least[k], (double)reported[i][k]) : least[k % 3];
            most[k] = fmax(most[k], (double)reported[i][k]);
        }
    for (int k = 0; k < 3; k++)
        print_message("white, %s: %.4f to %.4f\n",
                      (const char *[]){"dielectric", "metal", "below a coat"}[k], least[k],
                      most[k]);
    for (int k = 0; k < 2; k++)
        assert_true(least[k] > .99 && most[k] < 1.01);
    assert_true(least[2] > .985 && most[2] < 1.015 && most[3] < 1.01);
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

static void directions_come_back(void **state)
{
    (void)state;
    static float reported[SIDE * SIDE][4];
    double worst[3] = {0};
    GlContext *gl = frame_context();
    run(gl, frames, reported);
    gl_close(gl);
    for (int i = 0; i < SIDE * SIDE; i++) {
        worst[0] = fmax(worst[0], (double)reported[i][0]);
        worst[1] = fmax(worst[1], (double)reported[i][1]);
        worst[2] = fmax(worst[2],
                        fmax(fabs((double)reported[i][2] - .6), fabs((double)reported[i][3] - .4)));
    }
    print_message("directions: within %.1e, frames %.1e, strengths %.1e\n", worst[0], worst[1],
                  worst[2]);
    assert_true(worst[0] < 2e-4 && worst[1] < 1e-5 && worst[2] < 1e-5);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fits_are_integrals), cmocka_unit_test(lobes_are_microfacets),
        cmocka_unit_test(white_sends_all), cmocka_unit_test(light_and_eye_change_places),
        cmocka_unit_test(directions_come_back)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
