/* The thesis' own program, its listing 4.2, against matc's program for the same tree: the same
 * four render targets. */
/* ctest: quick */
#include "tests/test.h"
#include "tests/value/documents.h"
#include "tests/draw/draw.h"
#include "tests/value/half.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TARGETS = 4 };
typedef struct {
    float texels[TARGETS][POINT_COUNT * 4];
} Gbuffer;

/* The listing's normal is the interpolated one in eye space, which matc calls eyeNormal. */
static char *listing(void)
{
    static const char old[] = "varying vec3 normal;",
                      new[] = "varying vec3 eyeNormal;\n#define normal eyeNormal";
    char *text = calloc(1, 8192), *whole = calloc(1, 8192);
    FILE *file = fopen(SOURCE_FOLDER "/tests/thesis/listing42.frag", "rb");
    assert_non_null(file);
    assert_true(fread(text, 1, 4096, file) > 100);
    fclose(file);
    char *at = strstr(text, old);
    assert_non_null(at);
    snprintf(whole, 8192, "%.*s%s%s", (int)(at - text), text, new, at + strlen(old));
    free(text);
    return whole;
}

static void draw(Drawer *drawer, const Shading *shading, bool front, Gbuffer *made)
{
    float *rgba[TARGETS] = {made->texels[0], made->texels[1], made->texels[2], made->texels[3]};
    Material material;
    if (!drawer_material(drawer, shading, &material) ||
        !drawer_draw(drawer, &material, front, rgba, TARGETS))
        fail_msg("%s", drawer->error);
    material_delete(&material);
}

/* A sphere's worth of fragments: points of the value test whose coordinates are those of a texture,
 * with their normals. */
static void make_points(Point points[POINT_COUNT])
{
    points_make(points);
    for (int i = 0; i < POINT_COUNT; i++) {
        float *n = points[i].input[INPUT_eyeN];
        if (n[0] == 0 && n[1] == 0 && n[2] == 0)
            n[2] = 1; /* the listing has no guard */
        for (int component = 0; component < 2; component++)
            if (fabsf(points[i].input[INPUT_U][component]) >
                64) /* beyond, the listing's sum of two floors loses its last bit */
                points[i].input[INPUT_U][component] =
                    fmodf(points[i].input[INPUT_U][component], 64);
    }
}

/* Both components of the encoded normal in double precision, as the listing means it. */
static void encode(const Point *point, bool front, double code[2])
{
    const float *n = point->input[INPUT_eyeN];
    double length =
        (front ? 1 : -1) * sqrt((double)n[0] * n[0] + (double)n[1] * n[1] + (double)n[2] * n[2]);
    double f = sqrt(8 * (n[2] / length) + 8);
    for (int component = 0; component < 2; component++)
        code[component] = n[component] / length / f + 0.5;
}

static double eye_z(const Point *point, bool front)
{
    const float *n = point->input[INPUT_eyeN];
    return (front ? 1 : -1) * n[2] /
           sqrt((double)n[0] * n[0] + (double)n[1] * n[1] + (double)n[2] * n[2]);
}

static const double FLOAT_ERROR = 2e-7; /* of a sum with 1/2, below which a code near 0 may lie */

/* The normal's components: both round a number that they compute in their own ways, so the halves
 * may be neighbors; a driver may cut as well as round. Near z = -1 the listing divides two small
 * numbers that have lost their digits; matc does not. */
static void compare_normal(const Point *point, bool front, const float *theirs, const float *ours,
                           int *neighbours)
{
    double truth[2];
    encode(point, front, truth);
    for (int component = 0; component < 2; component++) {
        double step = half_step(truth[component]) + FLOAT_ERROR;
        if (fabs(ours[component] - truth[component]) > step)
            fail_msg("n.z %.9g: matc writes %.9g, the normal's code is %.9g", eye_z(point, front),
                     ours[component], truth[component]);
        if (eye_z(point, front) > -0.999 &&
            fabs((double)ours[component] - theirs[component]) > step)
            fail_msg("n.z %.9g: matc writes %.9g, the thesis %.9g", eye_z(point, front),
                     ours[component], theirs[component]);
        *neighbours += ours[component] != theirs[component];
    }
}

static void compare(const Point *points, bool front, const Gbuffer *theirs, const Gbuffer *ours)
{
    int neighbours = 0;
    for (int i = 0; i < POINT_COUNT; i++) {
        compare_normal(&points[i], front, &theirs->texels[0][4 * i], &ours->texels[0][4 * i],
                       &neighbours);
        for (int component = 2; component < 4 * TARGETS; component++) {
            float their = theirs->texels[component / 4][4 * i + component % 4],
                  our = ours->texels[component / 4][4 * i + component % 4];
            if (memcmp(&their, &our, sizeof our) != 0)
                fail_msg("target %d, lane %d, u %.9g, v %.9g: the thesis writes %.9g, matc %.9g",
                         component / 4, component % 4, points[i].input[INPUT_U][0],
                         points[i].input[INPUT_U][1], their, our);
            assert_true(half_is_plain(our));
        }
    }
    print_message("%s: %d fragments; %d of %d normal lanes are neighbouring halves, all else is "
                  "equal to the bit\n",
                  front ? "front" : "back", POINT_COUNT, neighbours, 2 * POINT_COUNT);
}

static void listing_and_matc_write_the_same(void **state)
{
    (void)state;
    static Point points[POINT_COUNT];
    static Gbuffer theirs, ours;
    Drawer drawer;
    Document document;
    char *text = listing();
    make_points(points);
    assert_true(drawer_open_half(&drawer, false, points, POINT_COUNT, TARGETS));
    if (!document_open(&document, SOURCE_FOLDER "/tests/thesis/listing42.yaml"))
        fail_msg("%s", document_fault(&document));
    for (int level = 0; level <= 2; level += 2) {
        MatcOptions options = document.options;
        options.target = "glsl110";
        options.layout = "thesis";
        options.optimize = level;
        MatcProgram *program = matc_compile(document.document, 0, MATC_FRAGMENT, &options);
        assert_true(matc_ok(program));
        const char *fragment = matc_output(program, MATC_FRAGMENT, NULL);
        for (int front = 0; front < 2; front++) {
            draw(&drawer, &(Shading){.fragment = text, .target = TARGET_glsl110}, front, &theirs);
            draw(&drawer,
                 &(Shading){.fragment = fragment, .target = TARGET_glsl110, .program = program},
                 front, &ours);
            compare(points, front, &theirs, &ours);
        }
        matc_program_free(program);
    }
    document_close(&document);
    drawer_close(&drawer);
    free(text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(listing_and_matc_write_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
