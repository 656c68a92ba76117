/* Light of a parallelogram at a point: the GLSL against Lambert's formula and Arvo's moments in
 * double, and these against quadrature over triangles of the light. Points near, far, behind, on
 * the light's plane and on its edges. */
#include "tests/test.h"
#include "gen/render_text.h"
#include "tests/area_reference.h"
#include "tests/frame/frame_cases.h"
#include "tests/frame/frame_draw.h"
#include <stdio.h>
#include <stdlib.h>

enum { WIDE = 64, HIGH = 128, CASES = WIDE * HIGH, TEXELS = 5 };

/* Texels of a case: corner, u, v and both sides, normal and exponent, axis. */
static const char body[] =
    "uniform sampler2D cases;\n"
    "vec4 caseTexel(ivec2 pixel, int i) { return texelFetch(cases, ivec2(5 * pixel.x + i, "
    "pixel.y), 0); }\n"
    "vec4 passPixel(ivec2 pixel)\n{\n"
    "    vec4 v = caseTexel(pixel, 2), normal = caseTexel(pixel, 3);\n"
    "    Area light = areaSeen(caseTexel(pixel, 0).xyz, caseTexel(pixel, 1).xyz, v.xyz, v.w > "
    "0.0);\n"
    "    return vec4(areaCosine(light, normal.xyz, AREA_ALL), areaLobe(light, areaHalf(light, "
    "normal.xyz), normal.xyz, caseTexel(pixel, 4).xyz, normal.w), "
    "0.0, 1.0);\n}\n";

/* Numbers of a case, as the GLSL and the reference read them. */
typedef float CaseTexels[TEXELS][4];

static uint32_t random_state;
static double random_unit(void)
{
    random_state = random_state * 1664525u + 1013904223u;
    return (random_state >> 8) / 16777216.;
}

static void random_direction(double v[3])
{
    do
        for (int i = 0; i < 3; i++)
            v[i] = 2 * random_unit() - 1;
    while (area_dot(v, v) > 1 || area_dot(v, v) < .01);
    area_normalize(v);
}

static void put(const double v[3], float texel[4])
{
    for (int i = 0; i < 3; i++)
        texel[i] = (float)v[i];
}

/* Renormalizes a unit vector that was rounded to floats. */
static void get_unit(const float texel[4], double v[3])
{
    for (int i = 0; i < 3; i++)
        v[i] = texel[i];
    area_normalize(v);
}

static AreaCase case_of(const CaseTexels t)
{
    AreaCase c = {.both_sides = t[2][3] > 0, .exponent = t[3][3]};
    for (int i = 0; i < 3; i++) {
        c.corner[i] = t[0][i];
        c.u[i] = t[1][i];
        c.v[i] = t[2][i];
    }
    get_unit(t[3], c.normal);
    get_unit(t[4], c.w);
    return c;
}

/* A light around a direction at distance 1, with edges from 0.001 to 10; the lobe mostly near
 * its center; the normal on the lobe's side. */
static void random_case(double exponent, CaseTexels t)
{
    double middle[3], u[3], v[3], w[3], n[3], aside[3], corner[3];
    const double size = pow(10, 4 * random_unit() - 3),
                 other = size * pow(10, 2 * random_unit() - 1);
    const double apart =
        (random_unit() < .3 ? 2 : 3 * random_unit() / sqrt(exponent + 1) + size * random_unit());
    random_direction(middle);
    random_direction(u);
    random_direction(v);
    random_direction(aside);
    random_direction(n);
    for (int i = 0; i < 3; i++) {
        u[i] *= size;
        v[i] *= other;
        corner[i] = middle[i] - (u[i] + v[i]) / 2;
        w[i] = middle[i] + apart * aside[i];
    }
    area_normalize(w);
    const double flip = area_dot(w, n) < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++)
        n[i] *= flip;
    memset(t, 0, sizeof(CaseTexels));
    put(corner, t[0]);
    put(u, t[1]);
    put(v, t[2]);
    put(n, t[3]);
    put(w, t[4]);
    t[2][3] = random_unit() < .7;
    t[3][3] = (float)exponent;
}

/* Values of the GLSL for CASES cases: x the cosine's integral, y the lobe's. */
static void run(GlContext *gl, const CaseTexels *cases, bool compute, float (*reported)[4])
{
    const TextureSpec texture = {
        .width = WIDE * TEXELS, .height = HIGH, .components = 4, .floats = cases[0][0]};
    const ScreenPassText text = {
        .body = {render_text_light_area, body}, .format = "RGBA32F", .compute = compute};
    frame_cases(gl, &text, &texture, (const int[]){WIDE, HIGH}, reported[0]);
}

static CaseTexels cases[CASES];
static float reported[CASES][4];

/* Upper bound of a light's value: facing the surface with the whole lobe on the light, or with
 * the light filling the whole lobe. */
static double most_of(const AreaCase *c, double lobe)
{
    const AreaPolygon seen = area_seen(c);
    return fmax(fmin(area_solid_angle(&seen) / AREA_PI, lobe), 1e-30);
}

/* 1e-5 and 2e-3 of that, and what floats round off of the light's radiance. */
#define ROUNDING 2e-7
static void by_exponent(void **state)
{
    (void)state;
    static const int exponents[] = {1, 2, 3, 4, 9, 30, 101, 1000, 9999, 65504};
    GlContext *gl = frame_context();
    int faults = 0;
    for (size_t e = 0; e < sizeof exponents / sizeof *exponents; e++) {
        const double lobe = 2 / (exponents[e] + 2.);
        double off[3] = {0};
        random_state = 7;
        for (int i = 0; i < CASES; i++)
            random_case(exponents[e], cases[i]);
        run(gl, (const CaseTexels *)cases, e % 2, reported);
        for (int i = 0; i < CASES; i += 1 + exponents[e] / 500) {
            const AreaCase c = case_of((const float(*)[4])cases[i]);
            const double cosine = fabs(reported[i][0] - area_lambert(&c)),
                         moment = fabs(reported[i][1] - area_moment(&c));
            off[0] = fmax(off[0], fmax(cosine - ROUNDING, 0) / most_of(&c, 1));
            off[1] = fmax(off[1], moment / lobe);
            off[2] = fmax(off[2], fmax(moment - ROUNDING, 0) / most_of(&c, lobe));
        }
        print_message("exponent %5d: cosine %.1e, lobe %.1e of its whole, %.1e of the light's\n",
                      exponents[e], off[0], off[1], off[2]);
        faults += !(off[0] <= 1e-5) + !(off[2] <= 2e-3);
    }
    gl_close(gl);
    assert_int_equal(faults, 0);
}

/* Both references agree, and non-integer exponents are as accurate. */
static void by_triangles(void **state)
{
    (void)state;
    static const double exponents[] = {0, .3, 1, 1.5, 2, 4, 7.25, 20};
    enum { EACH = 8 };
    GlContext *gl = frame_context();
    double off[2] = {0};
    random_state = 11;
    for (int i = 0; i < CASES; i++)
        random_case(exponents[i / EACH % 8], cases[i]);
    run(gl, (const CaseTexels *)cases, true, reported);
    for (int i = 0; i < 8 * EACH; i++) {
        const AreaCase c = case_of((const float(*)[4])cases[i]);
        const double integral = area_integral(&c), k = c.exponent;
        if (k == floor(k))
            off[0] = fmax(off[0], fabs((k > 0 ? area_moment(&c) : area_lambert(&c)) - integral));
        off[1] = fmax(off[1], fmax(fabs(reported[i][1] - integral) - ROUNDING, 0) /
                                  most_of(&c, 2 / (k + 2)));
    }
    print_message("moments are %.1e off the sum over triangles, the GLSL %.1e\n", off[0], off[1]);
    assert_true(off[0] <= 1e-7);
    assert_true(off[1] <= 2e-3);
    gl_close(gl);
}

/* A square of edge 2 a above a point that faces its center, at distance 1: 4 / pi * a / sqrt(1 +
 * a^2) atan(a / sqrt(1 + a^2)); a published form factor. */
static void closed_form(void **state)
{
    (void)state;
    static const double halves[] = {1e-3, .01, .07, .1, .15, .2, .25, 1, 10, 1000};
    enum { HALVES = sizeof halves / sizeof *halves };
    GlContext *gl = frame_context();
    memset(cases, 0, sizeof cases);
    for (int i = 0; i < HALVES; i++) {
        const double a = halves[i];
        put((double[]){-a, -a, 1}, cases[i][0]);
        put((double[]){0, 2 * a, 0}, cases[i][1]);
        put((double[]){2 * a, 0, 0}, cases[i][2]);
        put((double[]){0, 0, 1}, cases[i][3]);
        put((double[]){0, 0, 1}, cases[i][4]);
    }
    run(gl, (const CaseTexels *)cases, true, reported);
    for (int i = 0; i < HALVES; i++) {
        const double x = halves[i] / sqrt(1 + halves[i] * halves[i]),
                     share = 4 / AREA_PI * x * atan(x);
        assert_true(fabs(reported[i][0] - share) <= 1e-5 * share);
    }
    gl_close(gl);
}

/* Points on the light's plane, an edge, a corner; lights too small for floats; lobes along the
 * horizon: values are in [0, 1]. */
static void stable(void **state)
{
    (void)state;
    static const double exponents[] = {0, 1e-30, .5, 1, 4, 65504};
    GlContext *gl = frame_context();
    random_state = 3;
    for (int i = 0; i < CASES; i++) {
        float(*t)[4] = cases[i];
        random_case(exponents[i % 6], t);
        const float scale = (float)pow(10, 30 * random_unit() - 15), s = (float)(i / 6 % 3),
                    half = .5f;
        for (int component = 0; component < 3; component++) {
            if (i % 4 == 0) /* on a corner, an edge, or in the middle */
                t[0][component] =
                    -half * s * t[1][component] - (i % 3 ? half : 0) * t[2][component];
            if (i % 4 == 1) /* the lobe lies in the horizon, along the light's plane */
                t[4][component] = t[1][component];
            for (int k = 0; k < 3; k++)
                t[k][component] *= scale;
        }
        if (i % 5 == 0) { /* the normal is the light's, or its opposite, but for rounding */
            double face[3];
            const AreaCase c = case_of((const float(*)[4])t);
            area_cross(c.u, c.v, face);
            for (int component = 0; component < 3; component++)
                face[component] *= i % 10 ? 1 / (double)scale / scale : -1 / (double)scale / scale;
            area_normalize(face);
            put(face, t[3]);
        }
        double axis[3];
        get_unit((const float *)t[4], axis);
        put(axis, t[4]);
    }
    run(gl, (const CaseTexels *)cases, true, reported);
    for (int i = 0; i < CASES; i++)
        for (int k = 0; k < 2; k++)
            if (!(reported[i][k] >= 0 && reported[i][k] <= 1.0001f))
                fail_msg("case %d: %g %g", i, reported[i][0], reported[i][1]);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(by_exponent),
        cmocka_unit_test(by_triangles),
        cmocka_unit_test(closed_form),
        cmocka_unit_test(stable),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
