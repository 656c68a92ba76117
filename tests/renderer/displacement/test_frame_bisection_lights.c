/* Bisection for the shadows of an Area light, under OSMesa: nowhere coarser than for a point
 * light anywhere on it, seldom finer than for all such lights, and equal to that of a point
 * light if the Area is small. */
/* ctest: unsanitized */
#include "tests/frame/bisection_body.h"
#include "runtime/scene/scene_matrix.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS = 5 /* along each edge, from end to end */, PER_TRIANGLE = 32 };

typedef struct {
    int body;
    double distance, pixels, corner[3], edges[2][3], box[2][3];
} Row;

static const Row rows[] = {
    {0, 3, 2, {2.5, 2, 1.7}, {{-1, .3, 0}, {.2, .7, .5}}, {{0}}},
    {1, 1.5, 1.5, {-2.2, 1.5, 1}, {{0, -2, .5}, {.3, 0, -1}}, {{0}}},
    {1, 3, 1.5, {4, -1, .5}, {{0, 2, 0}, {0, 0, 1}}, {{0}}},
    {2, 4, 2, {-2, -5, 3}, {{2, 0, 0}, {0, 0, -2}}, {{0}}},
    {0, 2, 2, {-3, 0, 1}, {{0, 2, 0}, {0, 0, 1}}, {{-4, -4, -1}, {4, 4, 1}}}};

static BisectionBody begin(void **state, const Row *row)
{
    char how[80];
    snprintf(how, sizeof how, "pixels: %g, triangles: 9000", row->pixels);
    BisectionBody b = bisection_body_begin(*state, how, bisection_bodies[row->body]);
    bisection_body_look(&b.scene->camera, 1, 8, row->distance);
    memcpy(b.low, row->box[0], sizeof b.low);
    memcpy(b.high, row->box[1], sizeof b.high);
    memcpy(b.scene->lights[0].position, row->corner, sizeof row->corner);
    memcpy(b.scene->lights[0].edges, row->edges, sizeof row->edges);
    return b;
}

static bool is_there(const uint64_t *leaves, int count, uint64_t leaf)
{
    int low = 0, high = count;
    while (low < high) {
        const int middle = (low + high) / 2;
        if (leaves[middle] < leaf)
            low = middle + 1;
        else
            high = middle;
    }
    return low < count && leaves[low] == leaf;
}

/* Number of triangles of `fine` inside a coarser one of `coarse`. The numbers of enclosing
 * triangles are prefixes, in bits. */
static int finer(const uint64_t *fine, int fine_count, const uint64_t *coarse, int coarse_count)
{
    int found = 0;
    for (int i = 0; i < fine_count; i++) {
        bool within = false;
        const uint64_t base = fine[i] & ~(uint64_t)UINT32_MAX;
        for (uint32_t number = (uint32_t)fine[i] >> 1; number; number >>= 1)
            within |= is_there(coarse, coarse_count, base | number);
        found += within;
    }
    return found;
}

/* Leaves for a lamp at a position on the Area; from malloc. */
static uint64_t *of_lamp(BisectionBody *b, const Row *row, const double at[2], int *count)
{
    SceneLight *lamp = &b->scene->lights[0];
    lamp->kind = SCENE_Point;
    for (int k = 0; k < 3; k++)
        lamp->position[k] = row->corner[k] + at[0] * row->edges[0][k] + at[1] * row->edges[1][k];
    return bisection_body_leaves(b, count);
}

static void no_point_of_a_light_needs_more(void **state)
{
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        BisectionBody b = begin(state, &rows[i]);
        int count, most = 0, least = PER_TRIANGLE * 9000;
        b.scene->lights[0].kind = SCENE_Area;
        uint64_t *area = bisection_body_leaves(&b, &count);
        assert_true(displaced_bisection_cost(&b.displaced).pixels == rows[i].pixels);
        for (int at = 0; at < POINTS * POINTS; at++) {
            int lamp_count;
            uint64_t *lamp = of_lamp(
                &b, &rows[i], (double[]){at % POINTS / (POINTS - 1.), at / POINTS / (POINTS - 1.)},
                &lamp_count);
            assert_int_equal(finer(lamp, lamp_count, area, count), 0);
            most = lamp_count > most ? lamp_count : most;
            least = lamp_count < least ? lamp_count : least;
            free(lamp);
        }
        print_message("%zu: %d triangles, %d to %d for a lamp of it\n", i, count, least, most);
        assert_true(least < count && count < 2 * most);
        free(area);
        bisection_body_end(&b);
    }
}

static void a_small_light_is_a_lamp(void **state)
{
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        Row row = rows[i];
        for (int k = 0; k < 6; k++)
            row.edges[k / 3][k % 3] *= 1e-5;
        BisectionBody b = begin(state, &row);
        int counts[2];
        b.scene->lights[0].kind = SCENE_Area;
        uint64_t *area = bisection_body_leaves(&b, &counts[0]),
                 *lamp = of_lamp(&b, &row, (double[]){.5, .5}, &counts[1]);
        assert_true(counts[0] > 200);
        assert_true(bisection_body_others(area, counts[0], lamp, counts[1]) <= 2 + counts[0] / 100);
        free(area);
        free(lamp);
        bisection_body_end(&b);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_point_of_a_light_needs_more),
        cmocka_unit_test(a_small_light_is_a_lamp),
    };
    return cmocka_run_group_tests(tests, bisection_bodies_open, bisection_bodies_close);
}
