/* Lists of exact shadows: whatever stands between a point and a light, in double, is in the list of the point's cell. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "runtime/render/exact_lists.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TRIANGLES = 400, POINTS = 3000, MOST = 1 << 20 };

static uint64_t state_of_chance = 1;

static double chance(void)
{
    state_of_chance = state_of_chance * 6364136223846793005u + 1442695040888963407u;
    return (double)(state_of_chance >> 11) / 9007199254740992.0;
}

/* All sizes, needles and points among them; as floats. */
static ExactTriangles some_triangles(void)
{
    ExactTriangles made = {.corners = malloc(TRIANGLES * sizeof *made.corners), .count = TRIANGLES, .reach = 1};
    assert_non_null(made.corners);
    for (int i = 0; i < TRIANGLES; i++) {
        const double size = 2 * pow(10, -3 * chance());
        double middle[3];
        for (int k = 0; k < 3; k++)
            middle[k] = 2 * chance() - 1;
        for (int corner = 0; corner < 3; corner++)
            for (int k = 0; k < 3; k++)
                made.corners[i][corner][k] = (float)(middle[k] + (i % 7 && corner != 1 ? size * (chance() - .5) : 0));
        if (i % 11 == 0) /* a needle */
            for (int k = 0; k < 3; k++)
                made.corners[i][2][k] = made.corners[i][1][k] + 1e-6f * (float)k;
    }
    return made;
}

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void cross(const double a[3], const double b[3], double c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

/* Whether a triangle is met by at + t way, 0 < t < most: by volumes. */
static bool is_met(const float corners[3][3], const double at[3], const double way[3], double most)
{
    double from[3][3], sides[3], normal[3], edge[2][3];
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            from[i][k] = corners[i][k] - at[k];
    for (int i = 0; i < 3; i++) {
        cross(from[i], from[(i + 1) % 3], normal);
        sides[i] = dot(normal, way);
    }
    if (!((sides[0] > 0 && sides[1] > 0 && sides[2] > 0) || (sides[0] < 0 && sides[1] < 0 && sides[2] < 0)))
        return false;
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            edge[i][k] = from[i + 1][k] - from[0][k];
    cross(edge[0], edge[1], normal);
    const double t = dot(normal, from[0]) / dot(normal, way);
    return t > 0 && t < most;
}

/* -- the cell of a point, by the words of the head */

static float number_at(const uint32_t *head, int word)
{
    float number;
    memcpy(&number, head + word, sizeof number);
    return number;
}

/* -1: the light does not see it. */
static long cell_of(const uint32_t *head, const double at[3])
{
    const bool placed = number_at(head, EXACT_LISTS_PLACED) > 0;
    const long size = head[EXACT_LISTS_SIZE];
    double place[3], turned[3];
    long face = 0;
    for (int row = 0; row < 3; row++) {
        place[row] = number_at(head, EXACT_LISTS_ROWS + 4 * row + 3);
        for (int k = 0; k < 3; k++)
            place[row] += number_at(head, EXACT_LISTS_ROWS + 4 * row + k) *
                          (at[k] - (placed ? number_at(head, EXACT_LISTS_FROM + k) : 0));
    }
    memcpy(turned, place, sizeof turned);
    if (head[EXACT_LISTS_VIEWS] == 6) {
        int axis = 0;
        for (int k = 1; k < 3; k++)
            axis = fabs(place[k]) > fabs(place[axis]) ? k : axis;
        for (int k = 0; k < 3; k++)
            turned[k] = place[(axis + 1 + k) % 3];
        face = 2 * axis + (turned[2] < 0);
        turned[2] = fabs(turned[2]);
    }
    const double over = placed ? turned[2] : 1, x = turned[0] / over, y = turned[1] / over;
    if (over <= 0 || fabs(x) >= 1 || fabs(y) >= 1)
        return -1;
    return (face * size + (long)((y * .5 + .5) * (double)size)) * size + (long)((x * .5 + .5) * (double)size);
}

static bool is_listed(const ExactLists *lists, const uint32_t *head, long cell, uint32_t triangle)
{
    const uint32_t *begin = lists->words + head[EXACT_LISTS_CELLS] + cell;
    bool found = false;
    for (uint32_t i = begin[0]; i < begin[1]; i++)
        found |= lists->words[i] == triangle;
    return found;
}

/* How many triangles were met, each of which is listed. */
static int count_met(const ExactTriangles *triangles, const ExactLists *lists, int light)
{
    const uint32_t *head = lists->words + (size_t)lists->heads[light] * EXACT_LISTS_HEAD;
    const bool placed = number_at(head, EXACT_LISTS_PLACED) > 0;
    int met = 0;
    for (int i = 0; i < POINTS; i++) {
        double at[3], way[3];
        for (int k = 0; k < 3; k++) {
            at[k] = 3 * chance() - 1.5;
            way[k] = number_at(head, EXACT_LISTS_FROM + k) - (placed ? at[k] : 0);
        }
        const long cell = cell_of(head, at);
        for (int t = 0; cell >= 0 && t < triangles->count; t++)
            if (is_met((const float(*)[3])triangles->corners[t], at, way, placed ? 1 : INFINITY)) {
                assert_true(is_listed(lists, head, cell, (uint32_t)t));
                met++;
            }
    }
    return met;
}

/* -- */

#define EXACT .shadows = WORD_Shadows_exact
static SceneLight lights[] = {
    {.kind = SCENE_Point, EXACT, .position = {.1, .2, .3}}, /* among the triangles */
    {.kind = SCENE_Point, .shadows = WORD_Shadows_map},
    {.kind = SCENE_Point, EXACT, .position = {4, 1, 2}},
    {.kind = SCENE_Spot, EXACT, .position = {0, 3, 3}, .direction = {0, -.8, -.6}, .outer_cosine = .8},
    {.kind = SCENE_Spot, EXACT, .position = {0, 1, 2}, .direction = {0, -.8, -.6}, .outer_cosine = -.3},
    {.kind = SCENE_Directional, EXACT, .direction = {.6, 0, -.8}},
};
enum { LIGHTS = sizeof lights / sizeof *lights, EXACT_LIGHTS = LIGHTS - 1 };

static void all_are_listed(void **state)
{
    (void)state;
    const Scene scene = {.lights = lights, .light_count = LIGHTS};
    ExactTriangles triangles = some_triangles();
    ExactLists lists;
    assert_true(exact_lists_make(&(ExactListsSource){&scene, &triangles, MOST}, &lists));
    assert_int_equal(lists.light_count, EXACT_LIGHTS);
    assert_int_equal(lists.coarsened, 0);
    for (int i = 0; i < LIGHTS; i++)
        if (i == 1)
            assert_int_equal(lists.heads[i], -1);
        else
            assert_true(count_met(&triangles, &lists, i) > 100);
    exact_lists_free(&lists);
    exact_triangles_free(&triangles);
}

/* With less room cells are wider, and the lists are as complete; with too little, it is said how much there has to be. */
static void less_room(void **state)
{
    (void)state;
    const Scene scene = {.lights = lights, .light_count = LIGHTS};
    ExactTriangles triangles = some_triangles();
    ExactLists lists;
    assert_true(exact_lists_make(&(ExactListsSource){&scene, &triangles, MOST}, &lists));
    const size_t most = lists.count / 2;
    exact_lists_free(&lists);
    assert_true(exact_lists_make(&(ExactListsSource){&scene, &triangles, most}, &lists));
    assert_true(lists.coarsened > 0 && lists.count <= most);
    for (int i = 0; i < LIGHTS; i++)
        if (i != 1)
            assert_true(count_met(&triangles, &lists, i) > 100);
    exact_lists_free(&lists);
    assert_false(exact_lists_make(&(ExactListsSource){&scene, &triangles, TRIANGLES}, &lists));
    assert_true(lists.count > TRIANGLES && !lists.words && !lists.heads);
    exact_triangles_free(&triangles);
}

static void of_nothing(void **state)
{
    (void)state;
    const Scene scene = {.lights = lights, .light_count = LIGHTS};
    ExactTriangles nothing = {.count = 0};
    ExactLists lists;
    assert_true(exact_lists_make(&(ExactListsSource){&scene, &nothing, MOST}, &lists));
    assert_int_equal(lists.longest, 0);
    exact_lists_free(&lists);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(all_are_listed),
        cmocka_unit_test(less_room),
        cmocka_unit_test(of_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
