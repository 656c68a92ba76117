/* Values packed into half floats survive a real RGBA16F target: every code of packPair, and
 * normals through the spheremap. The GLSL is the library's own, drawn; a second program samples
 * the target. */
/* ctest: quick */
#include "tests/test.h"
#include "tests/draw/canvas.h"
#include "tests/value/half.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 128, TEXELS = SIDE * SIDE, LEVELS = 128 };

typedef struct {
    Canvas canvas;
    GLuint source; /* the numbers to be packed */
    float numbers[TEXELS][4], packed[TEXELS][4], unpacked[TEXELS][4];
} Fixture;

static int set_up(void **state)
{
    Fixture *f = calloc(1, sizeof *f);
    *state = f;
    if (f && canvas_open(&f->canvas, SIDE))
        return 0;
    print_error("%s\n", f ? f->canvas.error : "out of memory");
    return -1;
}

static int tear_down(void **state)
{
    Fixture *f = *state;
    canvas_close(&f->canvas);
    free(f);
    return 0;
}

static void draw(Fixture *f, const Drawing *drawing, const Framebuffer *target, float (*texels)[4])
{
    if (!canvas_draw(&f->canvas, drawing, target))
        fail_msg("%s", f->canvas.error);
    assert_true(framebuffer_read(f->canvas.gl, target, 0, &texels[0][0]));
}

/* numbers -> pack -> half floats -> unpack -> numbers. `t` is the texel under the pixel. */
static void round_trip(Fixture *f, const char *pack, const char *packing, const char *unpack,
                       const char *unpacking)
{
    const TextureSpec numbers = {
        .width = SIDE, .height = SIDE, .components = 4, .floats = &f->numbers[0][0]};
    f->canvas.gl->DeleteTextures(1, &f->source); /* GL ignores the name 0 */
    f->source = texture_make(f->canvas.gl, &numbers);
    assert_true(f->source);
    draw(f, &(Drawing){.functions = pack, .expression = packing, .texture = f->source},
         &f->canvas.halves, f->packed);
    draw(f, &(Drawing){.functions = unpack, .expression = unpacking, .source = &f->canvas.halves},
         &f->canvas.floats, f->unpacked);
}

static void all_plain(const Fixture *f, int components)
{
    for (int i = 0; i < TEXELS; i++)
        for (int component = 0; component < components; component++)
            if (!half_is_plain(f->packed[i][component]))
                fail_msg("texel %d, lane %d is %g", i, component, f->packed[i][component]);
}

static void round_trip_pairs(Fixture *f)
{
    round_trip(f, "packPair", "vec4(packPair(t.xy), packPair(t.zw), 0., 1.)", "unpackPair",
               "vec4(unpackPair(t.x), unpackPair(t.y))");
    all_plain(f, 2);
}

/* Code (k, m) is that of every x in [k, k + 1) / 127.5: its middle in components x, y; 1 where that
 * is beyond. */
static void every_code_survives(void **state)
{
    Fixture *f = *state;
    for (int i = 0; i < TEXELS; i++)
        for (int component = 0; component < 4; component++) {
            int code = component % 2 ? i / LEVELS : i % LEVELS;
            f->numbers[i][component] =
                (float)fmin(1, (code + (component < 2 ? 0.5 : 0.01)) / 127.5);
        }
    round_trip_pairs(f);
    for (int i = 0; i < TEXELS; i++) {
        int x = i % LEVELS, y = i / LEVELS;
        double want = (1 + x % 8 / 8. + y / 1024.) * ldexp(1, x / 8); /* the layout of the thesis */
        assert_true(f->packed[i][0] == want && f->packed[i][1] == want);
        for (int component = 0; component < 4; component++)
            if (fabs(f->unpacked[i][component] - (component % 2 ? y : x) / 127.5) > 1.2e-7)
                fail_msg("%.9g comes back as %.9g", f->numbers[i][component],
                         f->unpacked[i][component]);
    }
}

/* Packing unpacked values again gives the same codes: a surface that is copied does not drift. */
static void packing_again_changes_nothing(void **state)
{
    Fixture *f = *state;
    static float before[TEXELS];
    int changed = 0;
    every_code_survives(state);
    for (int i = 0; i < TEXELS; i++) {
        memcpy(f->numbers[i], f->unpacked[i], sizeof f->numbers[i]);
        before[i] = f->packed[i][0];
    }
    round_trip_pairs(f);
    for (int i = 0; i < TEXELS; i++)
        changed += f->packed[i][0] != before[i];
    if (changed)
        fail_msg("%d of %d codes", changed, TEXELS);
}

/* Numbers beyond [0, 1] are taken into it, and no number is stored more than a step off. */
static void anything_can_be_packed(void **state)
{
    static const float hard[] = {
        0,     -0.f,   1,     -1,          2,          1e30f,        -1e30f,
        3e38f, 1e-38f, 1e-8f, 0.99999994f, 1.0000001f, 127 / 127.5f, 126.99999f / 127.5f,
        1e-45f};
    enum { HARD = sizeof hard / sizeof *hard };
    Fixture *f = *state;
    for (int i = 0; i < TEXELS; i++)
        for (int component = 0; component < 4; component++) {
            int n = i / (component % 2 ? 1 : HARD) % HARD;
            f->numbers[i][component] =
                component < 2 ? hard[n]
                              : (float)fmod(i * (component == 2 ? 0.6180339887 : 0.4142135624), 1);
        }
    round_trip_pairs(f);
    for (int i = 0; i < TEXELS; i++)
        for (int component = 0; component < 4; component++) {
            double number = fmin(fmax(f->numbers[i][component], 0), 1),
                   error = number - f->unpacked[i][component];
            if (error < -6e-8 || error > 1 / 127.5 + 6e-8)
                fail_msg("%.9g comes back as %.9g", f->numbers[i][component],
                         f->unpacked[i][component]);
        }
}

static void put_normal(float n[4], double z, double angle)
{
    double r = sqrt(fmax(0, 1 - z * z));
    n[0] = (float)(r * cos(angle));
    n[1] = (float)(r * sin(angle));
    n[2] = (float)z;
    n[3] = 0;
}

/* Angle in degrees between two vectors, by the sine and the cosine: exact for small ones. */
static double angle_between(const float a[3], const float b[3])
{
    double c[3], dot = 0, cross = 0;
    for (int i = 0; i < 3; i++) {
        c[i] = (double)a[(i + 1) % 3] * b[(i + 2) % 3] - (double)a[(i + 2) % 3] * b[(i + 1) % 3];
        cross += c[i] * c[i];
        dot += (double)a[i] * b[i];
    }
    return atan2(sqrt(cross), dot) * 180 / 3.14159265358979323846;
}

typedef struct {
    double sum, worst;
    long count;
} Angles;

static void add_angle(Angles *angles, double angle)
{
    angles->sum += angle;
    angles->count++;
    angles->worst = fmax(angles->worst, angle);
}

/* numerics.md: spheremap in two halves, mean and worst, sphere and hemisphere that is seen. Those
 * are of a driver that rounds; one that cuts, as llvmpipe does, errs twice as much. */
static void normals_come_back(void **state)
{
    const double mean_sphere = 0.0419, worst_sphere = 3.93, mean_seen = 0.0324, worst_seen = 0.108,
                 cut = 2.1;
    enum { ROUNDS = 16 };
    Fixture *f = *state;
    Angles sphere = {0}, seen = {0};
    for (int round = 0; round < ROUNDS; round++) {
        for (int i = 0; i < TEXELS; i++) {
            double index = (double)round * TEXELS + i;
            put_normal(f->numbers[i], 1 - 2 * (index + 0.5) / ((double)ROUNDS * TEXELS),
                       index * 2.399963229728653);
        }
        round_trip(f, "encodeSpheremap", "vec4(encodeSpheremap(t.xyz), 0., 1.)", "decodeSpheremap",
                   "vec4(decodeSpheremap(t.xy), 0.)");
        for (int i = 0; i < TEXELS; i++) {
            const float *n = f->unpacked[i];
            double length = sqrt((double)n[0] * n[0] + (double)n[1] * n[1] + (double)n[2] * n[2]);
            assert_true(fabs(length - 1) < 1e-6);
            add_angle(&sphere, angle_between(f->numbers[i], n));
            if (f->numbers[i][2] >= 0)
                add_angle(&seen, angle_between(f->numbers[i], n));
        }
        for (int i = 0; i < TEXELS; i++)
            for (int component = 0; component < 2; component++)
                assert_true(isfinite(f->packed[i][component]) && f->packed[i][component] >= 0 &&
                            f->packed[i][component] <= 1);
    }
    print_message("degrees: sphere mean %.4f worst %.2f, hemisphere mean %.4f worst %.4f\n",
                  sphere.sum / (double)sphere.count, sphere.worst, seen.sum / (double)seen.count,
                  seen.worst);
    assert_true(sphere.sum / (double)sphere.count <= cut * mean_sphere &&
                sphere.worst <= cut * worst_sphere);
    assert_true(seen.sum / (double)seen.count <= cut * mean_seen && seen.worst <= cut * worst_seen);
}

/* The axes, the singular direction and its neighbors: numbers, of unit length. */
static void hard_normals_come_back(void **state)
{
    Fixture *f = *state;
    for (int i = 0; i < TEXELS; i++) {
        double off = pow(10, -(i / 16 % 16)), angle = i % 16 * 3.14159265358979323846 / 8;
        put_normal(f->numbers[i], (i / 256 % 2 ? -1 : 1) * sqrt(fmax(0, 1 - off * off)), angle);
        if (i / 256 % 4 >= 2) { /* not quite what its length says */
            f->numbers[i][0] = (float)(off * cos(angle));
            f->numbers[i][1] = (float)(off * sin(angle));
        }
    }
    round_trip(f, "encodeSpheremap", "vec4(encodeSpheremap(t.xyz), 0., 1.)", "decodeSpheremap",
               "vec4(decodeSpheremap(t.xy), 0.)");
    for (int i = 0; i < TEXELS; i++) {
        const float *n = f->unpacked[i];
        assert_true(
            fabs(sqrt((double)n[0] * n[0] + (double)n[1] * n[1] + (double)n[2] * n[2]) - 1) < 1e-6);
        assert_true(angle_between(f->numbers[i], n) < 8); /* next to -z */
        assert_true(f->packed[i][0] >= 0 && f->packed[i][0] <= 1 && f->packed[i][1] >= 0 &&
                    f->packed[i][1] <= 1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_code_survives),    cmocka_unit_test(packing_again_changes_nothing),
        cmocka_unit_test(anything_can_be_packed), cmocka_unit_test(normals_come_back),
        cmocka_unit_test(hard_normals_come_back),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
