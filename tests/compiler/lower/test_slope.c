/* Forward differentiation: the derivative of every map of every example, by u and by v, against
 * finite differences of the oracle's values in double. If a crease or jump of the map makes the
 * two one-sided differences disagree, the point is skipped. */
/* ctest: seconds=16 */
#include "tests/test.h"
#include "compiler/ir/fold.h"
#include "compiler/opt/opt.h"
#include "compiler/lower/slope.h"
#include "tests/sanitized.h"
#include "tests/value/documents.h"
#include "tests/value/points.h"
#include "tests/value/evaluate.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STEP = 3 * SANITIZED_STEP, MAX_NODES = 4096 };
static const double bound = 1e-6; /* of |slope - difference| / max(1, |difference|) */

typedef struct {
    Document document;
    Oracle *oracle;
    Point points[POINT_COUNT];
    bool seen[MAX_NODES];
    int maps, faults;
    long compared, creased;
    double worst;
} Test;

static double value_at(Test *t, const Node *map, const Point *point, double du, double dv)
{
    Surface surface;
    point_surface(point, true, &surface);
    surface.root[channel_id(GROUP_U, 0)] += du;
    surface.root[channel_id(GROUP_U, 1)] += dv;
    for (int i = 0; i < 3; i++) {
        surface.root[channel_id(GROUP_P, i)] += du * surface.root[channel_id(GROUP_DU, i)];
        surface.root[channel_id(GROUP_P, i)] += dv * surface.root[channel_id(GROUP_DV, i)];
        surface.root[channel_id(GROUP_X, i)] += du * surface.local_u[i] + dv * surface.local_v[i];
    }
    return oracle_channel(t->oracle, map, channel_id(GROUP_R, 0), &surface);
}

static double differences(Test *t, const Node *map, const Point *point, int axis, double h)
{
    double at[5];
    for (int i = -2; i <= 2; i++)
        at[i + 2] = value_at(t, map, point, axis ? 0 : i * h, axis ? i * h : 0);
    return (8 * (at[3] - at[1]) - (at[4] - at[0])) / (12 * h);
}

/* How much steeper the right side is than the left one: of a smooth function in proportion to the
 * step. */
static double bend(Test *t, const Node *map, const Point *point, int axis, double h)
{
    double at[3];
    for (int i = -1; i <= 1; i++)
        at[i + 1] = value_at(t, map, point, axis ? 0 : i * h, axis ? i * h : 0);
    return fabs(at[2] - 2 * at[1] + at[0]) / h;
}

/* The derivative, where differences over several steps agree on one: not at a crease or a jump. */
static bool difference(Test *t, const Node *map, const Point *point, int axis, double *slope)
{
    const double h = 0x1p-19;
    *slope = differences(t, map, point, axis, h);
    double wider = differences(t, map, point, axis, 3 * h),
           narrower = differences(t, map, point, axis, h / 2.5);
    double size = fmax(1, fabs(*slope));
    double bent = bend(t, map, point, axis, h);
    return fabs(8 * bend(t, map, point, axis, h / 8) - bent) < 0.5 * bent + 1e-4 * size &&
           fabs(wider - *slope) < 0.3 * bound * size &&
           fabs(narrower - *slope) < 0.3 * bound * size;
}

static void compare(Test *t, const Node *map, int axis, const Ir *ir,
                    const ReferenceContext *context)
{
    for (int i = 0; i < POINT_COUNT; i += STEP) {
        const Point *point = &t->points[i];
        double inputs[INPUT_COUNT][4] = {{0}}, result[MAX_OUTPUTS][4], expected;
        if (point_is_extreme(point) || fabsf(point->input[INPUT_X][0]) > 100 ||
            fabsf(point->input[INPUT_U][0]) > 100 || fabsf(point->input[INPUT_X][1]) > 100 ||
            fabsf(point->input[INPUT_U][1]) > 100)
            continue;
        if (!difference(t, map, point, axis, &expected)) {
            t->creased++;
            continue;
        }
        for (int k = 0; k < POINT_VARYINGS; k++)
            for (int component = 0; component < 3; component++)
                inputs[k][component] = point->input[k][component];
        inputs[INPUT_front][0] = 1;
        inputs[INPUT_IOR][0] = point_ior;
        inputs[INPUT_time][0] = point_time;
        memcpy(inputs[INPUT_viewer], point_viewer, sizeof point_viewer);
        ir_eval(ir, context, (const double(*)[4])inputs, result);
        double size = fmax(1, fabs(expected));
        double miss = fabs(result[0][0] - expected) / size;
        t->compared++;
        t->worst = fmax(t->worst, miss < bound ? miss : 0);
        if (miss <= bound)
            continue;
        t->faults++;
        print_error("%s %s d/d%c: %.12g, differences %.12g at point %d\n",
                    document_name(&t->document), kind_table[map->kind].name, axis ? 'v' : 'u',
                    result[0][0], expected, i);
        return;
    }
}

static void check_axis(Test *t, const Node *map, int axis)
{
    Arena arena = {0};
    Session session = {
        .options = &t->document.options, .arena = &arena, .optimize = 2, .check = true};
    Job job;
    ReferenceTexture textures[EVALUATE_TEXTURES];
    choice_job(&(MatcOptions){.pass = "value", .derivatives = "analytic"}, &job);
    Lower l = {.session = &session,
               .graph = t->document.graph,
               .ir = ir_new(&session, t->document.graph),
               .job = &job,
               .cheap = true};
    l.uniform_use = ARENA_ARRAY(&arena, uint8_t, l.graph->uniform_count);
    Env env = lower_surface_env(&l);
    Ref height = build_swizzle(l.ir, lower_query(&l, map, GROUP_R, &env), "x");
    Ref slope = slope_of(&l, height, axis ? DIRECTION_v : DIRECTION_u);
    ir_output(l.ir, OUT_color, 0,
              build_convert(l.ir, slope ? slope : build_float(l.ir, 0), TYPE_vec4));
    assert_null(ir_check(l.ir));
    assert_true(opt_run(&session, l.ir));
    opt_dead(l.ir);
    assert_true(evaluate_textures(&arena, l.ir, textures));
    ReferenceContext context = {l.ir->noise, textures};
    compare(t, map, axis, l.ir, &context);
    ir_done(l.ir);
    arena_free(&arena);
}

static void walk(Test *t, const Node *node)
{
    if (!node || t->seen[node->index])
        return;
    t->seen[node->index] = true;
    for (int i = 0; i < kind_table[node->kind].count; i++) {
        const Value *value = &node->params[i];
        if (value->kind == VALUE_node)
            walk(t, value->node);
        for (int k = 0; value->kind == VALUE_items && k < value->items->count; k++)
            walk(t, value->items->item[k].input);
    }
    if (kind_table[node->kind].lowering == LOWERING_MATERIAL)
        return;
    t->maps++;
    for (int axis = 0; axis < 2; axis++)
        check_axis(t, node, axis);
}

static void slopes_are_those_of_the_oracle(void **state)
{
    (void)state;
    static Test test;
    points_make(test.points);
    DocumentList list = documents_tried(SOURCE_FOLDER);
    const char *only = getenv("VALUE_ONLY");
    for (int i = 0; i < list.count; i++) {
        if (only && !strstr(list.paths[i], only))
            continue;
        bool good = document_open(&test.document, list.paths[i]);
        if (!good || test.document.graph->node_count > MAX_NODES) {
            document_close(&test.document);
            continue;
        }
        memset(test.seen, 0, sizeof test.seen);
        test.oracle =
            oracle_open(test.document.graph, &(ReferenceContext){.noise = REFERENCE_LATTICE});
        for (int material = 0; material < test.document.graph->material_count; material++)
            walk(&test, test.document.graph->materials[material].node);
        oracle_close(test.oracle);
        document_close(&test.document);
    }
    documents_free(&list);
    print_message(
        "%d maps, %ld slopes, %ld points at a crease; worst within the bound of %.0e: %.1e\n",
        test.maps, test.compared, test.creased, bound, test.worst);
    assert_true(only || test.compared > 20 * test.creased);
    assert_int_equal(test.faults, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slopes_are_those_of_the_oracle),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
