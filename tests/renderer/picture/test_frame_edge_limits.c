/* Thresholds of the edge pass: for each threshold a scene whose picture changes with the next
 * plausible value. Sums over rows of pixels are compared with the length of the row that an edge
 * covers. */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 64, PIXELS = SIDE * SIDE };

#define PICTURE "image: { width: 64, height: 64 }\n"
#define FACED                                                                                      \
    PICTURE "camera: { camera: Orthographic, position: [0, -10, 0], size: 6.4, depth: 100 }\n"
#define GLOWS(of) "material: { material: Phong, emissive: " of " }"
#define CHECKERED GLOWS("{ map: Checker, input: { map: UVTransform, scaleU: 23, scaleV: 23 } }")

static float *draw(GlContext *gl, const char *text, RendererEdges edges)
{
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(text, &options, &document);
    float *rgba = frame_floats(
        gl, scene, &(RendererOptions){.compile = &options, .edges = edges, .linear = true});
    frame_forget(scene, document);
    return rgba;
}

/* How many values differ from a picture without blended edges. */
static int count_blended(GlContext *gl, const char *text)
{
    float *none = draw(gl, text, RENDERER_EDGES_none),
          *all = draw(gl, text, RENDERER_EDGES_coverage);
    int count = 0;
    for (int i = 0; i < 4 * PIXELS; i++)
        count += none[i] != all[i];
    free(none);
    free(all);
    return count;
}

/* A panel's edge behind a patterned wall at reversed depth 0.9. The edge is hidden 0.15 % of that
 * depth behind the wall. 0.05 % behind it is blended, a tolerance for rounding and curved
 * surfaces. */
static void what_is_a_little_nearer_hides(void **state)
{
    static const char panel[] =
        FACED "objects:\n- { object: Parallelogram, u: [20, 0, 0], v: [0, 0, 20], transform: { "
              "translation: [-10, 0, -10] }, " CHECKERED " }\n"
              "- { object: Parallelogram, u: [2, 0, .3], v: [0, 0, 2], transform: { translation: "
              "[-1, %g, -1] }, " GLOWS("1") " }\n";
    char text[2048];
    snprintf(text, sizeof text, panel, .0015 * 90);
    assert_int_equal(count_blended(*state, text), 0);
    snprintf(text, sizeof text, panel, .0005 * 90);
    assert_true(count_blended(*state, text) > 20);
}

/* A sliver that covers no pixel center, in front of a pattern 15 % farther away in reversed depth.
 * No pixel shows the sliver at its edges, so nothing is blended. */
static void what_no_center_shows_blends_nothing(void **state)
{
    static const char text[] =
        FACED "objects:\n- { object: Parallelogram, u: [20, 0, 0], v: [0, 0, 20], transform: { "
              "translation: [-9.9, 13.5, -10] }, " CHECKERED " }\n"
              "- { object: Parallelogram, u: [.03, 0, 0], v: [0, 0, 20], transform: { translation: "
              "[.08, 0, -10] }, " GLOWS("1") " }\n";
    assert_int_equal(count_blended(*state, text), 0);
}

/* Greatest error of an edge's position in a picture that is white left of the edge and black
 * right of it: the sum of a row is the position. Skips rows near the border, and rows in which
 * the edge passes through a pixel center, where a slanted face looks like a separate edge. */
static double worst_row(GlContext *gl, const char *text, const double line[2])
{
    float *rgba = draw(gl, text, RENDERER_EDGES_coverage);
    double worst = 0;
    for (int y = 8; y < SIDE - 8; y++) {
        const double place = line[0] + line[1] * (y + .5);
        double sum = 0;
        if (fabs(place - floor(place) - .5) < .025)
            continue;
        for (int x = 0; x < SIDE; x++)
            sum += (double)rgba[4 * (y * SIDE + x)];
        worst = fmax(worst, fabs(sum - place));
    }
    free(rgba);
    return worst;
}

/* A valley: two panels that meet in a line and come 1.4 % of the distance nearer to the eye with
 * each pixel away from the line. Their nearer pixels must not count as hiding the line. */
static void valleys_are_blended(void **state)
{
    static const char text[] = PICTURE
        "camera: { camera: Perspective, position: [0, -10, 0], target: [0, 0, 0], angle: 40 }\n"
        "objects:\n"
        "- { object: Parallelogram, u: [-8, -9.8, 0], v: [1, 0, 10], transform: { translation: "
        "[-.48, 0, -5] }, " GLOWS("1") " }\n"
                                       "- { object: Parallelogram, u: [8, -9.8, 0], v: [1, 0, 10], "
                                       "transform: { translation: "
                                       "[-.48, 0, -5] }, " GLOWS("0") " }\n";
    const double pixels = SIDE / 2 / tan(20 * 3.14159265358979 / 180) / 10; /* in a unit */
    /* x = .02 + .1 z in units; y rows upward */
    const double line[2] = {SIDE / 2 + .02 * pixels - .1 * SIDE / 2, .1};
    const double worst = worst_row(*state, text, line);
    print_message("a valley: %.3f pixels off\n", worst);
    assert_true(worst < .01);
}

/* A box whose side is so slanted that its depth grows by 7 % with each pixel. Its front edge is
 * blended, since the neighboring pixel is less than 10 % farther away. */
static void slanted_sides_are_blended(void **state)
{
    static const char text[] = PICTURE
        "camera: { camera: Perspective, position: [0, -2, 0], target: [0, 0, 0], up: [.1, 0, 1], "
        "angle: 40 }\n"
        "objects:\n- { object: Box, size: [4, 400, 4], transform: { translation: [-2.325, 200, 0] "
        "}, "
        "material: { material: Phong, emissive: '= N.y < -.5 ? 1 : 0' } }\n";
    const double pixels = SIDE / 2 / tan(20 * 3.14159265358979 / 180) / 2;
    /* The edge x = -.325 of the world leans to the left by a tenth. */
    const double at = -(.325 + .1 * .0325) * cos(atan(.1)) * pixels;
    const double line[2] = {SIDE / 2 + at + .1 * SIDE / 2, -.1};
    const double worst = worst_row(*state, text, line);
    print_message("a slanted side: %.3f pixels off\n", worst);
    assert_true(worst < .01);
}

int main(void)
{
    GlContext *gl = frame_context();
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_prestate(what_is_a_little_nearer_hides, gl),
        cmocka_unit_test_prestate(what_no_center_shows_blends_nothing, gl),
        cmocka_unit_test_prestate(valleys_are_blended, gl),
        cmocka_unit_test_prestate(slanted_sides_are_blended, gl)};
    const int result = cmocka_run_group_tests(tests, NULL, NULL);
    gl_close(gl);
    return result;
}
