/* Silhouette shadows: the covered part of a cell between four texel centers, against polygons in
 * double. */
#include "tests/test.h"
#include "gen/render_text.h"
#include "runtime/gpu_material/screen_pass.h"
#include "tests/frame/frame_draw.h"
#include <stdlib.h>
#include <string.h>

enum { CELLS = 64 /* squared */ };

/* The case, four cuts and a place, all of which a float has. */
typedef struct {
    bool covered[4]; /* (0, 0), (1, 0), (1, 1), (0, 1) */
    double cuts[4];  /* of the lower, the upper, the left, the right segment */
    double at[2];
} Cell;

static Cell cell_of(int number)
{
    Cell cell;
    for (int i = 0; i < 4; i++) {
        cell.covered[i] = number >> i & 1;
        cell.cuts[i] = ((number >> 4) * (7 + 2 * i) + 5 * i) % 31 / 32.0 + 1 / 32.0;
    }
    cell.at[0] = number * 11 % 64 / 64.0 + 1 / 128.0;
    cell.at[1] = (number >> 3) * 13 % 64 / 64.0 + 1 / 128.0;
    return cell;
}

/* True if a point is in the polygon around the ring of covered, or uncovered, corners. */
static bool is_in_ring(const Cell *cell, bool covered)
{
    static const double corners[5][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}};
    const double cuts[4][2] = {
        {cell->cuts[0], 0}, {1, cell->cuts[3]}, {cell->cuts[1], 1}, {0, cell->cuts[2]}};
    double ring[9][2];
    int count = 0, crossed = 0;
    for (int i = 0; i < 4; i++) {
        if (cell->covered[i] == covered)
            memcpy(ring[count++], corners[i], sizeof *ring);
        if (cell->covered[i] != cell->covered[(i + 1) % 4])
            memcpy(ring[count++], cuts[i], sizeof *ring);
    }
    for (int i = 0; i < count; i++) {
        const double *a = ring[i], *b = ring[(i + 1) % count];
        const double x = a[0] + (cell->at[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0]);
        crossed += (a[1] > cell->at[1]) != (b[1] > cell->at[1]) && x > cell->at[0];
    }
    return crossed % 2;
}

/* Two opposite covered corners share one ring if they are joined: if more than half of the
 * segments is covered. */
static bool is_covered(const Cell *cell)
{
    const bool *c = cell->covered;
    if (c[0] == c[1] || c[1] == c[2] || c[2] == c[3])
        return is_in_ring(cell, true);
    const double free[4] = {cell->cuts[0], 1 - cell->cuts[1], cell->cuts[2], 1 - cell->cuts[3]};
    const double *cuts = cell->cuts;
    const double sum =
        c[0] ? free[0] + free[1] + free[2] + free[3] : 2 - cuts[0] + cuts[1] - cuts[2] + cuts[3];
    return sum > 2 ? is_in_ring(cell, true) : !is_in_ring(cell, false);
}

/* All cases, with one pixel each for many cuts and positions. */
static void cells(void **state)
{
    (void)state;
    static const char body[] =
        "vec4 passPixel(ivec2 pixel)\n{\n    int n = pixel.y * 64 + pixel.x, high = n >> 4;\n"
        "    vec4 cut = (vec4(high * 7 % 31, (high * 9 + 5) % 31, (high * 11 + 10) % 31, (high * "
        "13 + 15) % 31) + 1.0) "
        "/ 32.0;\n"
        "    vec2 at = (vec2(n * 11 % 64, (n >> 3) * 13 % 64) + 0.5) / 64.0;\n"
        "    bvec4 c = notEqual(ivec4(n) >> ivec4(0, 1, 2, 3) & 1, ivec4(0));\n"
        "    return vec4(silhouetteCovers(c.xy, c.wz, cut, at));\n}\n";
    GlContext *gl = frame_context();
    Store *store = store_new(gl);
    ScreenPass pass;
    Screen screen;
    Framebuffer target;
    const ScreenPassText text = {.body = {render_text_silhouette, body}, .format = "RGBA32F"};
    float *pixels = malloc(4 * sizeof *pixels * CELLS * CELLS);
    int covered = 0, divided = 0;
    assert_true(pixels && store && screen_make(gl, &screen) &&
                screen_pass_make(store, &text, &pass));
    assert_true(
        framebuffer_make(gl, &(FramebufferSpec){CELLS, CELLS, 1, GL_RGBA32F, false}, &target));
    screen_pass_run(&pass, &target, &screen);
    assert_true(framebuffer_read(gl, &target, 0, pixels));
    for (int i = 0; i < CELLS * CELLS; i++) {
        const Cell cell = cell_of(i);
        if (i % 16 == 0 || i % 16 == 15)
            continue; /* nothing is divided */
        assert_int_equal(pixels[4 * i] > .5f, is_covered(&cell));
        covered += is_covered(&cell);
        divided++;
    }
    assert_true(covered > divided / 4 && covered < divided * 3 / 4);
    free(pixels);
    framebuffer_delete(gl, &target);
    screen_pass_delete(&pass);
    screen_delete(gl, &screen);
    store_free(store);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(cells)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
