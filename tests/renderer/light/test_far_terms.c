/* The far-field expansion of distant lights, at hostile groups of surfaces: the series of their
 * diffuse light and the expansion of their specular light, as in the GLSL, against the exact
 * light in double. The error is within the bounds that far_terms.glsl and far_lobe.glsl state. */
/* ctest: alone */
#include "tests/test.h"
#include "gen/render_text.h"
#include "tests/frame/frame_cases.h"
#include "tests/frame/frame_draw.h"
#include "tests/vectors.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    ACROSS = 32,
    HIGH = 128,
    CASES = ACROSS * HIGH,
    IN = 7,
    OUT = 3 /* texels of a case */,
    SURFACES = 24
};

static const char head[] =
    "#define FAR_LIGHTS 512\n#define FAR_INVOCATIONS 8\n#define FAR_BITS 16\n#define FAR_TOPS 1\n"
    "#define FAR_NEAR 17\n#define FAR_MARKS 33\n#define FAR_WORDS 196\n"
    "#define FAR_NUMBERS_BINDING 5\n#define FAR_WORDS_BINDING 4\n"
    "struct Lit { vec3 even, gloss; };\nvec3 surfaceEven(Lit m) { return m.even; }\n"
    "vec3 surfaceSpecular(Lit m) { return m.gloss; }\nbool surfaceLetsThrough(Lit m) { return "
    "false; "
    "}\n";

/* A lamp at a distance of 1, with a power of 1. */
static const char body[] =
    "uniform sampler2D cases;\n"
    "vec4 passPixel(ivec2 pixel)\n{\n"
    "    vec4 t[7];\n"
    "    for (int i = 0; i < 7; i++) t[i] = texelFetch(cases, ivec2(pixel.x / 3 * 7 + i, pixel.y), "
    "0);\n"
    "    Group group;\n"
    "    group.axis = t[1].xyz; group.exponent = t[1].w; group.view = t[2].xyz; group.radius = "
    "t[0].w;\n"
    "    group.mirror = t[4].x; group.turn = t[4].y; group.lean = t[4].z; group.spread = t[4].w;\n"
    "    Far far = Far(t[0].xyz, vec3(1.0), t[0].w, t[3].w, t[3].x, t[3].y, t[3].z, true);\n"
    "    Lobe lobe = farLobe(far, group);\n"
    "    vec3 sums[FAR_TERMS], gloss[FAR_LOBES];\n"
    "    float slopes[FAR_TERMS], even = 0.0;\n"
    "    for (int i = 0; i < FAR_TERMS; i++) sums[i] = vec3(0.0);\n"
    "    for (int i = 0; i < FAR_LOBES; i++) gloss[i] = vec3(0.0);\n"
    "    farAdd(far.way, far.ratio, far.power, sums);\n"
    "    farAddLobe(far, group, gloss);\n"
    "    farSlopes(t[5].xyz, t[6].xyz, slopes);\n"
    "    for (int i = 0; i < FAR_TERMS; i++) even += slopes[i] * sums[i].x;\n"
    "    if (pixel.x % 3 == 0) return vec4(lobe.most, lobe.rest, gloss[0].x, even);\n"
    "    return pixel.x % 3 == 1 ? vec4(gloss[1].x, gloss[2].x, gloss[3].x, "
    "farLeftOut(far.ratio))\n"
    "                            : vec4(gloss[4].x, gloss[5].x, gloss[6].x, 0.0);\n}\n";

typedef double Vector[3];

/* A surface of the group: its position from the center, in radii; its normal, mirrored view and
 * exponent. */
typedef struct {
    Vector at, normal, mirror;
    double exponent;
} Patch;

typedef struct {
    Vector way, axis, view; /* to the lamp; of the seed */
    double ratio, exponent;
    Patch patches[SURFACES];
} Case;

static uint32_t random_state;
static double random_unit(void)
{
    random_state = random_state * 1664525u + 1013904223u;
    return (random_state >> 8) / 16777216.;
}

static void normalize(Vector v)
{
    const double length = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++)
        v[i] /= length;
}

static void random_direction(Vector v)
{
    do
        for (int i = 0; i < 3; i++)
            v[i] = 2 * random_unit() - 1;
    while (dot(v, v) > 1 || dot(v, v) < .01);
    normalize(v);
}

/* A direction at an angle from another one, rounded to floats. */
static void turned(const Vector from, double angle, Vector to)
{
    Vector aside;
    random_direction(aside);
    const double along = dot(aside, from);
    for (int i = 0; i < 3; i++)
        aside[i] -= along * from[i];
    normalize(aside);
    for (int i = 0; i < 3; i++)
        to[i] = (float)(cos(angle) * from[i] + sin(angle) * aside[i]);
    normalize(to);
}

/* Properties that make a group harder, alone and together. */
enum { WIDE = 1, TURNED = 2, LEANING = 4, SHARPER = 8, KINDS = 16 };

static void make_case(int kind, double exponent, Case *c)
{
    const double lobe = 1 / sqrt(exponent), lean = kind & LEANING ? .5 * random_unit() : 0;
    const double turn = kind & TURNED ? 2 * lobe * random_unit() : 0,
                 more = kind & SHARPER ? exponent * random_unit() : 0;
    random_direction(c->way);
    turned(c->way, 1.2 * random_unit(), c->axis);
    turned(c->way, 2.5 * lobe * random_unit(), c->view);
    c->ratio = kind & WIDE ? .001 + .599 * random_unit() * random_unit() : 1e-9;
    c->exponent = exponent;
    for (int i = 0; i < SURFACES; i++) {
        Patch *p = &c->patches[i];
        const double radius = i % 2 ? 1 : random_unit();
        random_direction(p->at);
        if (i < 4) /* towards the lamp, and away */
            memcpy(p->at, c->way, sizeof p->at);
        for (int k = 0; k < 3; k++)
            p->at[k] = (float)((i % 4 < 2 ? radius : -radius) * p->at[k]);
        turned(c->axis, i % 3 ? lean : lean * random_unit(), p->normal);
        turned(c->view, i % 5 ? turn : turn * random_unit(), p->mirror);
        p->exponent = exponent + (i % 2 ? more : more * random_unit());
    }
}

/* From the patch to the lamp. */
static void to_lamp(const Case *c, const Patch *p, Vector way)
{
    for (int i = 0; i < 3; i++)
        way[i] = c->way[i] - c->ratio * p->at[i];
}

static double even_of(const Case *c, const Patch *p)
{
    Vector way;
    to_lamp(c, p, way);
    return dot(p->normal, way) / pow(dot(way, way), 1.5);
}

static double gloss_of(const Case *c, const Patch *p)
{
    Vector way;
    to_lamp(c, p, way);
    return even_of(c, p) * pow(fmax(dot(p->mirror, way) / sqrt(dot(way, way)), 0), p->exponent);
}

static void put(const Vector v, double last, float texel[4])
{
    for (int i = 0; i < 3; i++)
        texel[i] = (float)v[i];
    texel[3] = (float)last;
}

/* The least and the greatest cosine between a direction and those around an axis. */
static void cosines_of(double along, double cosine, double out[2])
{
    const double between = acos(fmax(-1, fmin(1, along))), angle = acos(fmin(cosine, 1));
    out[0] = cos(fmin(between + angle, acos(-1)));
    out[1] = cos(fmax(between - angle, 0));
}

/* The values that pass_groups.glsl computes for the group, and far_light.glsl for the lamp. */
static void put_case(const Case *c, float t[IN][4])
{
    double cosine = 1, mirror = 1, above = -1e9, below = 1e9, sharp = c->exponent, cosines[2];
    for (int i = 0; i < SURFACES; i++) {
        const Patch *p = &c->patches[i];
        const double height = c->ratio * dot(p->normal, p->at);
        above = fmax(above, height);
        below = fmin(below, height);
        cosine = fmin(cosine, dot(p->normal, c->axis));
        mirror = fmin(mirror, dot(p->mirror, c->view));
        sharp = fmax(sharp, p->exponent);
    }
    cosine -= 1e-6;
    mirror -= 1e-6;
    cosines_of(dot(c->way, c->axis), cosine, cosines);
    const Vector range = {cosines[0] - above, cosines[1] - below,
                          fmax(fmax(cosines[1], cosines[1] - below), -cosines[0])};
    put(c->way, c->ratio, t[0]);
    put(c->axis, c->exponent, t[1]);
    put(c->view, 0, t[2]);
    put(range, fmax(above, -below), t[3]);
    put((const Vector){mirror, sqrt(2 - 2 * mirror), sqrt(2 - 2 * cosine)},
        (sharp - c->exponent) / (2.718 * c->exponent), t[4]);
    put(c->patches[1].at, 0, t[5]);
    put(c->patches[1].normal, 0, t[6]);
}

static void run(GlContext *gl, float (*in)[IN][4], float (*out)[OUT][4])
{
    const TextureSpec texture = {
        .width = ACROSS * IN, .height = HIGH, .components = 4, .floats = in[0][0]};
    const ScreenPassText text = {.body = {head, render_text_far_terms, render_text_far_blocks,
                                          render_text_far_group, render_text_far_lobe, body},
                                 .format = "RGBA32F",
                                 .compute = true};
    frame_cases(gl, &text, &texture, (const int[]){ACROSS * OUT, HIGH}, out[0][0]);
}

static Case cases[CASES];
static float in[CASES][IN][4], out[CASES][OUT][4];

/* Diffuse light at a patch. */
static double linear_of(const Case *c, const Patch *p, float (*reported)[4])
{
    double sum = reported[0][2];
    for (int i = 0; i < 3; i++)
        sum += reported[1][i] * p->at[i] + reported[2][i] * (p->mirror[i] - c->view[i]);
    return sum;
}

/* The greatest ratio of the specular error to its bound; every patch must be within the bound,
 * and the stated maximum must be right. Below 0: not expanded. */
static double check_gloss(const Case *c, float (*reported)[4])
{
    const double never = 1e29, rounding = 2e-6 * (1 + c->exponent);
    double share = -1;
    for (int i = 0; i < SURFACES; i++) {
        const double specular = gloss_of(c, &c->patches[i]),
                     off = fabs(specular - linear_of(c, &c->patches[i], reported));
        assert_true(specular <= reported[0][0] * (1 + rounding) + 1e-7);
        if (reported[0][1] > never)
            continue;
        if (!(off <= reported[0][1] + rounding))
            fail_msg("exponent %g, ratio %g: off by %g, and the bound is %g", c->exponent, c->ratio,
                     off, reported[0][1]);
        share = fmax(share, fmax(off - rounding, 0) / reported[0][1]);
    }
    return share;
}

/* Each kind of group comes near its bound, so no term could be much smaller. */
static void gloss_is_within_its_bound(void **state)
{
    (void)state;
    static const double exponents[] = {2, 3.3, 8, 30, 120};
    double most[KINDS] = {0};
    GlContext *gl = frame_context();
    random_state = 5;
    for (int i = 0; i < CASES; i++) {
        make_case(i % KINDS, exponents[i / KINDS % 5], &cases[i]);
        put_case(&cases[i], in[i]);
    }
    run(gl, in, out);
    for (int i = 0; i < CASES; i++)
        most[i % KINDS] = fmax(most[i % KINDS], check_gloss(&cases[i], out[i]));
    for (int kind = 1; kind < KINDS; kind++) {
        print_message("wide %d, turned %d, leaning %d, sharper %d: %.2f of the bound\n",
                      kind & WIDE, kind / TURNED & 1, kind / LEANING & 1, kind / SHARPER,
                      most[kind]);
        assert_true(most[kind] > .3);
    }
    gl_close(gl);
}

/* The bound q^6 (7 - 6 q) / (1 - q)^2 is nearly reached; farLeftOut computes the same. */
static void series_are_within_their_bound(void **state)
{
    (void)state;
    const double rounding = 2e-6;
    double most = 0;
    GlContext *gl = frame_context();
    random_state = 7;
    for (int i = 0; i < CASES; i++) {
        make_case(WIDE | LEANING, 2, &cases[i]);
        put_case(&cases[i], in[i]);
    }
    run(gl, in, out);
    for (int i = 0; i < CASES; i++) {
        const double q = cases[i].ratio, bound = pow(q, 6) * (7 - 6 * q) / pow(1 - q, 2);
        const double off = fabs(even_of(&cases[i], &cases[i].patches[1]) - out[i][0][3]);
        assert_true(off <= bound + rounding &&
                    fabs(out[i][1][3] - bound) <= rounding * (1 + bound));
        most = fmax(most, (off - rounding) / bound);
    }
    print_message("series: %.2f of the bound\n", most);
    assert_true(most > .8 && most <= 1);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(gloss_is_within_its_bound),
                                       cmocka_unit_test(series_are_within_their_bound)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
