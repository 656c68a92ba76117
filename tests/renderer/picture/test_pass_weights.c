/* Thresholds and weights of passes. Functions are cut out of pass_temporal.glsl,
 * pass_denoise.glsl, shadow.glsl and indirect_mask.glsl and run alone, with formulas in place of
 * textures, against the rules in double that their comments state. In a whole picture noise
 * would hide an error of these weights. */
#include "tests/test.h"
#include "gen/render_text.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/pass_values.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 32 };

/* A copy, from malloc, of the text from `from` up to `to`. */
static char *cut(const char *text, const char *from, const char *to)
{
    const char *first = strstr(text, from), *last = first ? strstr(first, to) : NULL;
    assert_true(first && last);
    char *copy = strndup(first, (size_t)(last - first));
    assert_non_null(copy);
    return copy;
}

/* Runs a program of four pieces of text, and reads its values. */
static void run(const char *const pieces[4], float (*values)[4])
{
    GlContext *gl = frame_context();
    const ScreenPassText text = {.body = {pieces[0], pieces[1], pieces[2], pieces[3]},
                                 .format = "RGBA32F"};
    pass_values(gl, &text, SIDE, values);
    gl_close(gl);
}

/* -- History ----------------------------------------------------------------------------------- */

/* The previous frame shows a wall that faces the eye at distance 10, where a pixel is 0.1 wide;
 * every pixel has accumulated four sets of rays. */
static const char history_head[] =
    "#define INDIRECT_COARSE 1\n"
    "const vec4 temporal_view = vec4(0.01, 0.0, 0.0, 0.0), temporal_ray = vec4(0.005, 0.005, 64.0, "
    "64.0);\n"
    "const int temporal_values = 0, temporal_places = 1;\n"
    "ivec2 only = ivec2(-1);\n" /* the only pixel with accumulated sets; -1: all pixels */
    "vec4 fetched(int which, ivec2 p) { if (which == 0) return vec4(0.5); "
    "bool has = only.x < 0 || p == only; return vec4(10.0, has ? 4.0 : 0.0, 0.0, 0.0); }\n"
    "#define texelFetch(s, p, level) fetched(s, p)\n"
    "#define textureSize(s, level) ivec2(64)\n";
/* Sets that are kept at the middle of pixel (40, 24), by column. x: the point lies `column` tenths
 * of a pixel's width off the wall. y: the normal is turned by 15 degrees and half a degree a
 * column. z: the point lies 0.75 pixels and more, along x and y, beside the only pixel with sets,
 * whose bilinear weight is the square of the rest. */
static const char history_body[] =
    "vec4 passPixel(ivec2 p) {\n"
    "    vec3 at = vec3(0.85, -0.75, -10.0);\n" /* (2 (40, 24) + 1 - 64) 0.005, times 10 */
    "    float a = radians(0.5 * float(p.x) + 15.0), s = 0.75 + 0.002 * float(p.x);\n"
    "    vec4 sum = vec4(0.0);\n"
    "    sum.x = temporalAt(at - vec3(0.0, 0.0, 0.01 * float(p.x)) * vec3(at.xy / -10.0, 1.0), "
    "vec3(0.0, 0.0, 1.0)).sets;\n"
    "    sum.y = temporalAt(at, vec3(sin(a), 0.0, cos(a))).sets;\n"
    "    only = ivec2(40, 24);\n"
    "    sum.z = temporalAt(at + vec3(0.1 * s, 0.1 * s, 0.0), vec3(0.0, 0.0, 1.0)).sets;\n"
    "    return sum;\n}\n";

static void history_keeps_the_same_surface(void **state)
{
    (void)state;
    static float values[SIDE * SIDE][4];
    char *functions = cut(render_text_pass_temporal, "struct TemporalKept",
                          "// Temporal reprojection of a pixel");
    run((const char *const[]){history_head, functions, history_body, NULL}, values);
    free(functions);
    for (int x = 0; x < SIDE; x++) {
        /* Kept up to a pixel's width off the wall; the width grows with the distance, 10 + 0.01
         * x. */
        const double off = .01 * x, width = .1 * (1 + .001 * x), left = pow(.25 - .002 * x, 2);
        if (fabs(off - width) > .002 && (values[x][0] > 0) != (off < width))
            fail_msg("%d tenths of a pixel off: %g sets", x, (double)values[x][0]);
        /* Kept up to 25.8 degrees, whose cosine is 0.9. */
        const double cosine = cos((.5 * x + 15) * 3.14159265358979 / 180);
        assert_true((values[x][1] > 0) == (cosine >= .9));
        /* Kept with a weight of a twentieth or more. */
        if ((values[x][2] > 0) != (left >= .05))
            fail_msg("a weight of %g: %g sets", left, (double)values[x][2]);
        if (values[x][2] > 0)
            assert_true(fabs((double)values[x][2] - 4) < 1e-4);
    }
}

/* Rays find 0.4 and 0.6 in turn, and the accumulated value is 0.54 + 0.01 a column. The mean of the
 * 16 pixels is 0.5, and the deviation of that mean a fourth of 0.1. The accumulated value is
 * clamped to 1.5 deviations, 0.5375, and loses the more sets the farther it was off. In rows 1 and
 * 2 the odd columns lie 1.8 and 2.2 widths of a pixel behind the tangent plane; from two widths on
 * they do not count. */
static const char limit_head[] =
    "#define INDIRECT_COARSE 1\n"
    "struct TemporalKept { vec4 value; float sets; };\n"
    "const vec4 temporal_dirty = vec4(1.0, 1.0, 0.0, 0.0), temporal_counts = vec4(0.0);\n"
    "const int temporal_rays = 0, indirect_depth = 1;\n"
    "float behind = 0.0;\n" /* distance of odd columns behind the plane, in widths of a pixel */
    "vec4 fetched(int which, ivec2 p) { if (which == 1) return vec4(1.0); "
    "return vec4(behind > 0.0 && (p.x & 1) == 1 ? 0.9 : ((p.x / 2 + p.y) & 1) == 0 ? 0.4 : 0.6); "
    "}\n"
    "#define texelFetch(s, p, level) fetched(s, p)\n"
    "#define textureSize(s, level) ivec2(64)\n"
    "ivec2 indirectPixel(ivec2 p) { return p; }\n"
    "vec3 indirectPoint(ivec2 p, float depth) { return vec3(vec2(p), (p.x & 1) == 1 ? -behind : "
    "0.0); }\n"
    "float indirectPixelSize(vec3 point) { return 1.0; }\n"
    "bool temporalIsNear(vec3 point) { return true; }\n";
static const char limit_body[] =
    "vec4 passPixel(ivec2 p) {\n"
    "    TemporalKept kept = TemporalKept(vec4(0.54 + 0.01 * float(p.x)), 8.0);\n"
    "    behind = p.y == 0 ? 0.0 : p.y == 1 ? 1.8 : 2.2;\n"
    "    temporalLimit(kept, ivec2(20, 20), vec3(20.0, 20.0, 0.0), vec3(0.0, 0.0, 1.0));\n"
    "    return vec4(kept.value.xw, kept.sets, 0.0);\n}\n";

static void history_is_brought_near_what_rays_find(void **state)
{
    (void)state;
    static float values[SIDE * SIDE][4];
    char *function = cut(render_text_pass_temporal, "void temporalLimit", "vec4 passPixel");
    run((const char *const[]){limit_head, function, limit_body, NULL}, values);
    free(function);
    for (int x = 0; x < SIDE; x++) {
        const double kept = .54 + .01 * x, off = 1.5 * .1 / 4, limited = fmin(kept, .5 + off);
        const double sets = 8 * fmax(1 - (kept - limited) / (off + 1e-4), 0);
        assert_true(fabs((double)values[x][0] - limited) < 1e-4);
        assert_true(fabs((double)values[x][1] - limited) < 1e-4);
        assert_true(fabs((double)values[x][2] - sets) < .02);
    }
    /* Within two widths the 0.9 of odd columns counts too: a mean of 0.7. Beyond two it does
     * not. */
    assert_true(values[SIDE + 20][0] > .7f && fabsf(values[2 * SIDE + 20][0] - .55f) < .02f);
}

/* -- Denoiser ---------------------------------------------------------------------------------- */

/* Pixels of width 1 on a plane; every third column is raised, every fifth row has a turned normal,
 * and formulas give the values. */
static const char smooth_head[] =
    "#define INDIRECT_COARSE 1\n"
    "ivec2 smoothLow() { return ivec2(0); }\nivec2 smoothSize() { return ivec2(64); }\n"
    "const int smooth_source = 0, smooth_rays = 1, indirect_depth = 2;\n"
    "float smooth_level = 0.0;\n"
    "float source(ivec2 p) { return 0.5 + 0.2 * sin(float(3 * p.x + 5 * p.y)); }\n"
    "float rays(ivec2 p) { return 0.5 + 0.05 * sin(float(7 * p.x + 11 * p.y)); }\n"
    "vec4 fetched(int which, ivec2 p) { return which == 0 ? vec4(source(p)) : which == 1 ? "
    "vec4(rays(p)) : vec4(1.0); }\n"
    "#define texelFetch(s, p, level) fetched(s, p)\n"
    "ivec2 indirectPixel(ivec2 p) { return p; }\n"
    "vec3 indirectPoint(ivec2 p, float depth) { return vec3(vec2(p), p.x % 3 == 0 ? 0.4 : 0.0); }\n"
    "vec3 indirectNormal(ivec2 p) { return p.y % 5 == 0 ? vec3(0.6, 0.0, 0.8) : vec3(0.0, 0.0, "
    "1.0); }\n"
    "float indirectPixelSize(vec3 point) { return 1.0; }\n";

static double source_of(int x, int y) { return .5 + .2 * sin(3 * x + 5 * y); }
static double rays_of(int x, int y) { return .5 + .05 * sin(7 * x + 11 * y); }
static double height_of(int x) { return x % 3 == 0 ? .4 : 0; }

/* Weight of a pixel by plane and normal. It falls linearly to 0 at a distance from the plane of as
 * many widths as the pixel is pixels away, and has the eighth power of the normals' cosine as a
 * factor. */
static double same_surface(const int from[2], const int to[2], double away)
{
    const double n[2][2] = {{from[1] % 5 ? 0 : .6, from[1] % 5 ? 1 : .8},
                            {to[1] % 5 ? 0 : .6, to[1] % 5 ? 1 : .8}};
    const double off =
        fabs(n[0][0] * (to[0] - from[0]) + n[0][1] * (height_of(to[0]) - height_of(from[0])));
    const double cosine = n[0][0] * n[1][0] + n[0][1] * n[1][1];
    return fmax(1 - off / fmax(away, 1), 0) * pow(cosine, 8);
}

/* Deviation of the rays in 3 x 3 pixels that is left after the earlier levels: 70 / 256 after level
 * 0, half of that after each further level. */
static double noise_of(const int at[2], int level)
{
    double sums[3] = {0};
    for (int i = 0; i < 9; i++) {
        const int to[2] = {at[0] + i % 3 - 1, at[1] + i / 3 - 1};
        const double weight = same_surface(at, to, abs(i % 3 - 1) + abs(i / 3 - 1));
        sums[0] += weight;
        sums[1] += weight * rays_of(to[0], to[1]);
        sums[2] += weight * pow(rays_of(to[0], to[1]), 2);
    }
    return 70 / 256. * pow(.5, level - 1) *
           sqrt(fmax(sums[2] / sums[0] - pow(sums[1] / sums[0], 2), 0));
}

static double smoothed(const int at[2], int level)
{
    static const double spline[3] = {6 / 16., 4 / 16., 1 / 16.};
    const int apart = 1 << level;
    const double noise = level ? 3 * noise_of(at, level) + 1e-4 : 1;
    double sum = 0, mean = 0;
    for (int i = 0; i < 25; i++) {
        const int x = i % 5 - 2, y = i / 5 - 2, to[2] = {at[0] + apart * x, at[1] + apart * y};
        const double value = source_of(to[0], to[1]),
                     change = fabs(value - source_of(at[0], at[1]));
        double weight = spline[abs(x)] * spline[abs(y)] * (level ? exp(-change / noise) : 1);
        if (i != 12)
            weight *= same_surface(at, to, apart * (abs(x) + abs(y)));
        sum += weight;
        mean += weight * value;
    }
    return mean / sum;
}

static void denoiser_weighs_by_surface_and_noise(void **state)
{
    (void)state;
    static const char body[] = "vec4 passPixel(ivec2 p) { vec4 sum = vec4(0.0);\n"
                               "    for (int i = 0; i < 3; i++) { smooth_level = float(i); sum[i] "
                               "= filtered_(p + 16).w; }\n"
                               "    return sum; }\n";
    static float values[SIDE * SIDE][4];
    char *weights =
        cut(render_text_pass_denoise, "struct SmoothPlace", "// Returns the bounds of the picture");
    char *filter =
        cut(render_text_pass_denoise, "const float SMOOTH_NOISE", "#else\nvec4 passPixel");
    char *entry = strstr(filter, "vec4 passPixel");
    assert_non_null(entry);
    memcpy(entry, "vec4 filtered_", strlen("vec4 passPixel"));
    run((const char *const[]){smooth_head, weights, filter, body}, values);
    free(weights);
    free(filter);
    double worst = 0;
    for (int i = 0; i < SIDE * SIDE; i++)
        for (int level = 0; level < 3; level++)
            worst = fmax(worst, fabs((double)values[i][level] -
                                     smoothed((const int[]){i % SIDE + 16, i / SIDE + 16}, level)));
    print_message("the denoiser: within %.1e\n", worst);
    assert_true(worst < 2e-5);
}

/* -- Cascades ---------------------------------------------------------------------------------- */

/* Cascades of 64 texels with a filter of 1 texel. The weight of a cascade is 0 within three texels
 * of its border, and 1 from a sixteenth of half its width farther inside. */
static const char cascade_head[] =
    "#define SHADOW_SIZE 64\n#define SHADOW_FILTER 1\nconst int VIEW_HOW = 3;\n"
    "vec4 shadowRow(int view, int row) { return vec4(0.0, 0.01, 0.0, 0.0); }\n"
    "vec3 shadowPlace(int view, vec4 point) { return point.xyz; }\n"
    "const float SHADOW_LIFT = 1.5;\n";
static const char cascade_body[] =
    "vec4 passPixel(ivec2 p) { float x = 0.85 + 0.005 * float(p.x);\n"
    "    return vec4(shadowInside(0, vec3(x, 0.0, 0.0), vec3(0.0, 0.0, 1.0), 0.0),\n"
    "                shadowInside(0, vec3(0.0, -x, 0.0), vec3(0.0, 0.0, 1.0), 0.0),\n"
    "                shadowInside(0, vec3(x, 0.0, 0.0), vec3(1.0, 0.0, 0.0), 0.0),\n"
    "                shadowInside(0, vec3(x, 0.0, 0.0), vec3(1.0, 0.0, 0.0), 0.64)); }\n";

static void cascades_give_way_in_a_band(void **state)
{
    (void)state;
    static float values[SIDE * SIDE][4];
    char *function =
        cut(render_text_shadow, "const float SHADOW_BAND", "// Returns the share by cascaded");
    run((const char *const[]){cascade_head, function, cascade_body, NULL}, values);
    free(function);
    for (int x = 0; x < SIDE; x++)
        for (int i = 0; i < 4; i++) {
            /* The point is lifted along the normal by 1.5 texels, each 0.01 wide, and a 64th of a
             * pixel. */
            const double place = .85 + .005 * x + (i < 2 ? 0 : i < 3 ? .015 : .025);
            const double inside = fmin(fmax((1 - 3 / 64. - place) / .0625, 0), 1);
            assert_true(fabs((double)values[x][i] - inside) < 1e-4);
        }
}

/* -- Sectors ----------------------------------------------------------------------------------- */

/* Columns are angles from -90 to 90 degrees, rows angles of the normal. x: the sector of the
 * column's angle. y: number of bits from `column` + 0.9 to 2 `column` + 0.5. z: number of bits of
 * 0xFFFFFFFF shifted right by the column. w: 1 if indirectBits() sets the column's bit alone, and
 * as many bits below it as the column's number. */
static const char sector_body[] =
    "vec4 passPixel(ivec2 p) { float g = radians(5.0 * float(p.y) - 77.5), quarter = "
    "radians(90.0);\n"
    "    IndirectSlice s = IndirectSlice(vec3(0.0, 0.0, 1.0), vec3(1.0, 0.0, 0.0), g, 0.0, 0.0);\n"
    "    s.left = indirectPrimitive(g - quarter, g); s.all = s.left + indirectPrimitive(g + "
    "quarter, g);\n"
    "    float t = radians(-90.0 + 180.0 * float(p.x) / 31.0), x = float(p.x);\n"
    "    uint bits = indirectBits(x + 0.9, 2.0 * x + 0.5), from = indirectBits(x + 0.1, x + 1.6);\n"
    "    return vec4(indirectSector(s, t), indirectCount(bits), indirectCount(0xFFFFFFFFu >> "
    "uint(p.x)),\n"
    "                float(from == 1u << uint(p.x) && indirectCount(indirectBits(0.2, x + 0.5)) == "
    "x)); }\n";

/* Integral of cos(t - g) |sin t| from low to high by the midpoint rule. */
static double weight_between(double low, double high, double g)
{
    enum { STEPS = 2000 };
    double sum = 0;
    for (int i = 0; i < STEPS; i++) {
        const double t = low + (high - low) * (i + .5) / STEPS;
        sum += cos(t - g) * fabs(sin(t)) * (high - low) / STEPS;
    }
    return sum;
}

static void sectors_count_alike(void **state)
{
    (void)state;
    static float values[SIDE * SIDE][4];
    const double quarter = acos(0);
    char *functions =
        cut(render_text_indirect_mask, "float indirectPrimitive", "vec4 indirectAround");
    run((const char *const[]){functions, sector_body, NULL, NULL}, values);
    free(functions);
    for (int i = 0; i < SIDE * SIDE; i++) {
        const int x = i % SIDE, last = 2 * x < 32 ? 2 * x : 32;
        const double g = (5. * (i / SIDE) - 77.5) * quarter / 90;
        const double t = fmin(fmax(-quarter + 2 * quarter * x / 31, g - quarter), g + quarter);
        const double place =
            32 * weight_between(g - quarter, t, g) / weight_between(g - quarter, g + quarter, g);
        assert_true(fabs((double)values[i][0] - place) < 2e-3);
        assert_true(values[i][1] == (float)(last > x ? last - x : 0));
        assert_true(values[i][2] == (float)(32 - x) && values[i][3] == 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(history_keeps_the_same_surface),
                                       cmocka_unit_test(history_is_brought_near_what_rays_find),
                                       cmocka_unit_test(denoiser_weighs_by_surface_and_noise),
                                       cmocka_unit_test(cascades_give_way_in_a_band),
                                       cmocka_unit_test(sectors_count_alike)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
