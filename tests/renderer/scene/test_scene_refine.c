/* Bisection: after any order of splits no edge has another triangle's vertex in its interior,
 * checked by the half-edges alone. Bisection by error: flat parts are not split, features that
 * are found are finer, and the error equals that of a uniform subdivision with many times as
 * many triangles. */
#include "tests/test.h"
#include "runtime/tessellate/scene_bisection.h"
#include "runtime/tessellate/scene_divide.h"
#include "runtime/tessellate/scene_refine.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* -- half-edges */

/* A row of every half-edge of the triangles there are: its ends' positions, the lesser first. */
typedef struct {
    float ends[2][3];
} Edge;

static int compare_edges(const void *a, const void *b)
{
    const float *x = &((const Edge *)a)->ends[0][0], *y = &((const Edge *)b)->ends[0][0];
    for (int i = 0; i < 6; i++)
        if (x[i] != y[i])
            return x[i] < y[i] ? -1 : 1;
    return 0;
}

static Edge *edges_of(const SceneBisection *b)
{
    Edge *edges = malloc((3 * b->count + 1) * sizeof *edges);
    for (size_t i = 0; i < 3 * b->count; i++) {
        const SceneBisectionTriangle *t = &b->triangles[i / 3];
        const float *p = b->vertices[t->vertex[i % 3]].position,
                    *q = b->vertices[t->vertex[(i + 1) % 3]].position;
        bool first = true;
        for (int component = 0; component < 3; component++)
            if (p[component] != q[component]) {
                first = p[component] < q[component];
                break;
            }
        memcpy(edges[i].ends[!first], p, sizeof edges[i].ends[0]);
        memcpy(edges[i].ends[first], q, sizeof edges[i].ends[0]);
    }
    qsort(edges, 3 * b->count, sizeof *edges, compare_edges);
    return edges;
}

static double length(const Edge *edge)
{
    double sum = 0;
    for (int component = 0; component < 3; component++)
        sum += ((double)edge->ends[0][component] - edge->ends[1][component]) *
               ((double)edge->ends[0][component] - edge->ends[1][component]);
    return sqrt(sum);
}

/* How long all edges are that one triangle has alone. A point of one triangle within the edge of
 * another makes them more: neither that edge nor its parts have two. */
static double rim(const SceneBisection *b)
{
    Edge *edges = edges_of(b);
    double sum = 0;
    for (size_t i = 0, next; i < 3 * b->count; i = next) {
        for (next = i + 1; next < 3 * b->count && !compare_edges(&edges[i], &edges[next]); next++)
            continue;
        if (next - i > 2)
            fail_msg("%zu triangles at an edge", next - i);
        sum += next - i == 1 ? length(&edges[i]) : 0;
    }
    for (size_t i = 0; i < 3 * b->count; i++) { /* rings, both ways */
        const uint32_t next = b->triangles[i / 3].across[i % 3];
        assert_int_equal(b->triangles[next / 3].behind[next % 3], i);
    }
    free(edges);
    return sum;
}

static double area(const SceneBisection *b)
{
    double sum = 0;
    for (size_t i = 0; i < b->count; i++) {
        const uint32_t *v = b->triangles[i].vertex;
        double e[2][3], n[3];
        for (int k = 0; k < 2; k++)
            for (int component = 0; component < 3; component++)
                e[k][component] = (double)b->vertices[v[k + 1]].position[component] -
                                  b->vertices[v[0]].position[component];
        for (int k = 0; k < 3; k++)
            n[k] = e[0][(k + 1) % 3] * e[1][(k + 2) % 3] - e[0][(k + 2) % 3] * e[1][(k + 1) % 3];
        sum += sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]) / 2;
    }
    return sum;
}

/* Five in a row around one edge, of other sizes, so that each waits for the next one. */
static void fan(Shape *made)
{
    *made = (Shape){.vertices = calloc(7, sizeof *made->vertices),
                    .indices = calloc(15, sizeof *made->indices),
                    .vertex_count = 7,
                    .index_count = 15};
    for (int i = 0; i < 7; i++) {
        const double size = pow(1.4, i);
        made->vertices[i] =
            (ShapeVertex){.position = {(float)(size * cos(.5 * i)), (float)(size * sin(.5 * i)), 0},
                          .normal = {0, 0, 1}};
    }
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++)
            made->indices[3 * i + k] = (uint32_t)(i + k);
}

static void nothing_ends_within_an_edge(void **state)
{
    (void)state;
    static const ShapeKind kinds[] = {SHAPE_sphere, SHAPE_cube,  SHAPE_torus,
                                      SHAPE_cloth,  SHAPE_plane, SHAPE_count};
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
        for (int order = 0; order < 4; order++) {
            Shape shape;
            SceneBisection b;
            uint32_t chance = 12345;
            if (kinds[k] == SHAPE_count)
                fan(&shape);
            else
                assert_true(shape_make_detailed(kinds[k], (int[]){9, 5}, &shape));
            assert_true(scene_bisection_begin(&shape, &b));
            const double whole = area(&b), outline = rim(&b);
            /* by chance; at one corner; what was made last; the first */
            for (int step = 0; step < 1500; step++) {
                chance = chance * 1664525u + 1013904223u;
                const uint32_t which[] = {(uint32_t)(chance >> 8) % (uint32_t)b.count,
                                          step % 3 ? 0 : (chance >> 8) % (uint32_t)b.count,
                                          (uint32_t)b.count - 1, (uint32_t)step % 7};
                if (b.triangles[which[order]].depth < 24)
                    assert_true(scene_bisection_split(&b, which[order]));
                if (step % 100 == 99)
                    assert_true(fabs(rim(&b) - outline) < 1e-5 * (1 + outline));
            }
            assert_true(fabs(area(&b) / whole - 1) < 1e-6); /* all of it, once */
            scene_bisection_end(&b);
            shape_free(&shape);
        }
}

/* -- by error */

typedef double Height(double x, double y);

static double hill(double x, double y)
{
    return .3 * exp(-80 * ((x - .2) * (x - .2) + (y + .3) * (y + .3)));
}
static double flat(double x, double y) { return .25 * x - .5 * y; }
static double waves(double x, double y)
{
    return .05 * sin(9 * x * x + 14 * y) * exp(-3 * (x * x + y * y));
}
static double dome(double x, double y) { return .3 - .1 * (x * x + y * y); }
static double cliff(double x, double y) { return 1e-3 * x * x + (x + .5 * y < .1 ? 0 : .2); }
static double wall(double x, double y) { return .2 / (1 + exp(-120 * (x + .5 * y - .1))); }

static bool lift(void *user, const ShapeVertex *at, int count, double (*to)[3])
{
    Height *height = *(Height *const *)user;
    for (int i = 0; i < count; i++) {
        for (int component = 0; component < 3; component++)
            to[i][component] = at[i].position[component];
        to[i][2] += height(to[i][0], to[i][1]);
    }
    return true;
}

/* How far, in the mean square, triangles over a square are from a height, at points on a grid that
 * no division has. */
static double error_of(const Shape *shape, Height *height)
{
    enum { GRID = 700 };
    double square = 0;
    int met = 0;
    for (int i = 0; i < shape->index_count; i += 3) {
        const float *p[3];
        double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
        for (int k = 0; k < 3; k++) {
            p[k] = shape->vertices[shape->indices[i + k]].position;
            for (int component = 0; component < 2; component++) {
                low[component] = fmin(low[component], p[k][component]);
                high[component] = fmax(high[component], p[k][component]);
            }
        }
        const double twice = ((double)p[1][0] - p[0][0]) * ((double)p[2][1] - p[0][1]) -
                             ((double)p[2][0] - p[0][0]) * ((double)p[1][1] - p[0][1]);
        for (int row = (int)ceil((low[1] + 1) * GRID / 2 - .37);
             row >= 0 && row < GRID && (row + .37) * 2 / GRID - 1 < high[1]; row++)
            for (int column = (int)ceil((low[0] + 1) * GRID / 2 - .41);
                 column >= 0 && column < GRID && (column + .41) * 2 / GRID - 1 < high[0];
                 column++) {
                const double x = (column + .41) * 2 / GRID - 1, y = (row + .37) * 2 / GRID - 1;
                const double b = ((x - p[0][0]) * ((double)p[2][1] - p[0][1]) -
                                  ((double)p[2][0] - p[0][0]) * (y - p[0][1])) /
                                 twice;
                const double c = (((double)p[1][0] - p[0][0]) * (y - p[0][1]) -
                                  (x - p[0][0]) * ((double)p[1][1] - p[0][1])) /
                                 twice;
                if (b < 0 || c < 0 || b + c > 1)
                    continue;
                const double z =
                    p[0][2] + b * ((double)p[1][2] - p[0][2]) + c * ((double)p[2][2] - p[0][2]);
                square += (z - height(x, y)) * (z - height(x, y));
                met++;
            }
    }
    assert_true(abs(met - GRID * GRID) < 50); /* on an edge twice, or by rounding not at all */
    return sqrt(square / met);
}

static double even_error(const Shape *square, int parts, Height *height)
{
    Shape made;
    assert_true(scene_divide(square, parts, &made));
    for (int i = 0; i < made.vertex_count; i++) {
        float *p = made.vertices[i].position;
        p[2] += (float)height(p[0], p[1]);
    }
    const double error = error_of(&made, height);
    shape_free(&made);
    return error;
}

/* The error is smaller than that of a uniform subdivision with as many triangles, at least by
 * this factor. */
static void error_is_less(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        Height *height;
        double times;
    } rows[] = {{"hill", hill, 6}, {"waves", waves, 1.5}, {"wall", wall, 15}};
    Shape square;
    assert_true(shape_make_detailed(SHAPE_plane, (int[]){1, 1}, &square));
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        Height *height = rows[i].height;
        const SceneRefining how = {.move = lift, .user = &height, .triangles = 8192};
        Shape made;
        assert_true(scene_refine(&square, &how, &made));
        assert_true(made.index_count / 3 >= 8192 && made.index_count / 3 < 8192 + 200);
        const double error = error_of(&made, height), even = even_error(&square, 64, height);
        print_message("%-6s %d triangles: %.3g, evenly %.3g, %.1f times\n", rows[i].name,
                      made.index_count / 3, error, even, even / error);
        assert_true(even / error > rows[i].times);
        shape_free(&made);
    }
    shape_free(&square);
}

/* If all triangles err to one side, their corners leave the surface, which reduces the error by
 * more than a third; no corner moves farther than the farthest sample, and nearly flat parts
 * next to a cliff stay. */
static void corners_leave_what_is_bent(void **state)
{
    (void)state;
    Shape square, made;
    Height *height = dome;
    assert_true(shape_make_detailed(SHAPE_plane, (int[]){1, 1}, &square));
    assert_true(scene_refine(
        &square, &(SceneRefining){.move = lift, .user = &height, .triangles = 2000}, &made));
    const double fitted = error_of(&made, height);
    for (int i = 0; i < made.vertex_count; i++) {
        float *p = made.vertices[i].position;
        assert_true(p[2] <= .3F);
        p[2] = (float)height((double)p[0], (double)p[1]);
    }
    const double upon = error_of(&made, height);
    print_message("a dome: %.3g, with corners on it %.3g\n", fitted, upon);
    assert_true(fitted < .6 * upon);
    shape_free(&made);
    height = cliff;
    assert_true(scene_refine(
        &square, &(SceneRefining){.move = lift, .user = &height, .triangles = 2000}, &made));
    int below = 0, above = 0;
    for (int i = 0; i < made.vertex_count; i++) {
        const float *p = made.vertices[i].position;
        const double off = ((double)p[0] + .5 * (double)p[1] - .1) / sqrt(1.25);
        if (fabs(off) < .02)
            continue;
        assert_true(fabs((double)p[2] - height((double)p[0], (double)p[1])) < 1e-4);
        off < 0 ? below++ : above++;
    }
    assert_true(below > 20 && above > 20);
    shape_free(&made);
    shape_free(&square);
}

/* A plane, even one that is tilted, is not divided, but for the part that goes by area. */
static void what_is_flat_stays(void **state)
{
    (void)state;
    Shape square, made;
    Height *height = flat;
    assert_true(shape_make_detailed(SHAPE_plane, (int[]){1, 1}, &square));
    assert_true(scene_refine(
        &square, &(SceneRefining){.move = lift, .user = &height, .triangles = 16}, &made));
    assert_int_equal(made.index_count / 3, 2);
    shape_free(&made);
    assert_true(scene_refine(
        &square, &(SceneRefining){.move = lift, .user = &height, .triangles = 100000}, &made));
    assert_true(made.index_count / 3 < 100000 / 16 + 100 && error_of(&made, flat) < 1e-7);
    shape_free(&made);
    shape_free(&square);
}

static bool refuse(void *user, const ShapeVertex *at, int count, double (*to)[3])
{
    int *left = user;
    Height *height = wall;
    return (*left)-- > 0 && lift(&height, at, count, to);
}

static void what_cannot_be_moved_is_empty(void **state)
{
    (void)state;
    Shape square, made;
    assert_true(shape_make_detailed(SHAPE_plane, (int[]){1, 1}, &square));
    for (int calls = 0; calls < 6; calls++) {
        int left = calls;
        assert_false(scene_refine(
            &square, &(SceneRefining){.move = refuse, .user = &left, .triangles = 20000}, &made));
        assert_null(made.vertices);
    }
    shape_free(&square);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_ends_within_an_edge),   cmocka_unit_test(error_is_less),
        cmocka_unit_test(corners_leave_what_is_bent),    cmocka_unit_test(what_is_flat_stays),
        cmocka_unit_test(what_cannot_be_moved_is_empty),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
