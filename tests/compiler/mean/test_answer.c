/* Means and variances of maps, at -O0 and -O2, against the oracle's values over the pixel: the
 * variance is what a mean leaves out, and a non-linear function of a two-valued map is averaged
 * over both values. The maps vary by whole periods, so that the slopes of their means carry no
 * variance. */
#include "tests/test.h"
#include "compiler/ir/build.h"
#include "compiler/ir/fold.h"
#include "compiler/lower/map_value.h"
#include "compiler/lower/slope.h"
#include "compiler/opt/opt.h"
#include "tests/value/documents.h"
#include "tests/value/evaluate.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The pixel: u changes by 1/2 towards the right one, y by 1 upward; a quarter of either lies in odd
 * squares. */
static const double CENTRE_U = 0.375, CENTRE_V = 0.1, WIDTH_U = 0.5, CENTRE_Y = 0.25, WIDTH_Y = 1,
                    CENTRE_XZ = 0.1;
enum { SAMPLES = 64 };

#define SINE  "{ map: Gradient, direction: [0, 1, 0], waveForm: Sin01 }"
#define CHAIN "map: Gradient, direction: [0, 1, 0], waveForm: { wave: Chain, first: Sin01"
#define HALF                                                                                       \
    "{ map: Gradient, direction: [0, 2, 0], waveForm: { wave: Chain, first: Sin01, factor: 0.5, "  \
    "second: Id } }"

#define PEAK "[{ value: 0, input: 0.25 }, { value: 0.5, input: 1 }, { value: 1, input: 0 }]"

/* of what is a straight line, and of what is only nearly one */
static const double CLOSE = 1e-6, ROUGHLY = 0.02;

static const struct {
    const char *name, *map;
    Group group;
    const double *bound; /* of the difference, in units of max(1, variance) */
} cases[] = {
    {"a wave", SINE, GROUP_R, &CLOSE},
    {"as a position", SINE, GROUP_X, &CLOSE},
    {"as a number", SINE, GROUP_IOR, &CLOSE},
    {"scaled and moved",
     "{ map: Gradient, direction: [0, 1, 0], waveForm: { wave: Chain, first: Sin01, factor: -3, "
     "shift: 7, second: Id } "
     "}",
     GROUP_R, &CLOSE},
    {"e v", "{ " CHAIN ", second: E } }", GROUP_R, &CLOSE},
    {"pi v", "{ " CHAIN ", second: Pi } }", GROUP_R, &CLOSE},
    {"phi v", "{ " CHAIN ", second: Phi } }", GROUP_R, &CLOSE},
    {"steps", "{ " CHAIN ", factor: 40, second: Floor } }", GROUP_R, &ROUGHLY},
    {"steps upward", "{ " CHAIN ", factor: 40, second: Ceil } }", GROUP_R, &ROUGHLY},
    {"a square", "{ " CHAIN ", shift: 5, second: Sqr } }", GROUP_R, &ROUGHLY},
    {"along a direction",
     "{ map: Gradient, direction: [0, -3, 0], input: { map: XYZTransform, transform: { "
     "translation: [0, 1, 0] }, "
     "input: " SINE " } }",
     GROUP_R, &CLOSE},
    {"scaled lanes", "{ map: XYZTransform, transform: { scale: [3, -2, 0.5] }, input: " SINE " }",
     GROUP_X, &CLOSE},
    {"turned",
     "{ map: XYZTransform, transform: { rotation: [0, 0, 1.5707963267948966], scale: [3, 2, 1] }, "
     "input: " SINE " }",
     GROUP_X, &CLOSE},
    {"turned uv", "{ map: UVTransform, scaleU: -2, scaleV: 3, offsetU: 5, input: " SINE " }",
     GROUP_U, &CLOSE},
    {"passed on", "{ map: UVTransform, scaleU: 2, input: " SINE " }", GROUP_X, &CLOSE},
    {"wrinkled by nothing", "{ map: Turbulence, amount: [0, 0, 0], input: " SINE " }", GROUP_X,
     &CLOSE},
    {"a share", "{ map: Checker, color1: " SINE ", color2: 0 }", GROUP_R, &CLOSE},
    {"the other share", "{ map: Checker, color1: 0, color2: " SINE " }", GROUP_R, &CLOSE},
    {"one colour twice", "{ map: Checker, color1: &s " SINE ", color2: *s }", GROUP_R, &CLOSE},
    {"with an alpha", "{ map: Checker, color1: " SINE ", color2: [0, 0, 0, 1] }", GROUP_R, &CLOSE},
    {"a share of a share",
     "{ map: Checker, color1: { map: Checker, input: 0, color1: 0, color2: " SINE
     " }, color2: " HALF " }",
     GROUP_R, &CLOSE},
    {"a Blend of one",
     "{ map: Blend, input: { map: Carpenter, input: 1 }, blend: [{ value: 1, input: " SINE " }] }",
     GROUP_R, &CLOSE},
    {"a Blend at a point",
     "{ map: Blend, input: 0.25, blend: [{ value: 0, input: " SINE " }, { value: 1, input: " HALF
     " }] }",
     GROUP_R, &CLOSE},
    {"a Blend at a step",
     "{ map: Blend, input: 1, blend: [{ value: 1, input: " SINE " }, { value: 1, input: " HALF
     " }, { value: 2, input: 0 }] }",
     GROUP_R, &CLOSE},
    {"a Blend far behind",
     "{ map: Blend, input: 9, blend: [{ value: 0, input: " SINE " }, { value: 1, input: " HALF
     " }] }",
     GROUP_R, &CLOSE},
};

static const struct {
    const char *name, *slots;
    Slot slot;
} means[] = {
    {"an exponent", "shininess: { map: Checker, color1: 0.1, color2: 0.9 }", SLOT_shininess},
    {"an exponent passed on",
     "shininess: { map: BumpMap, input: { map: Checker, color1: 0.1, color2: 0.9 } }",
     SLOT_shininess},
    {"exponents of three",
     "shininess: { map: Checker, color1: 0.1, color2: { map: VolumeChecker, color1: 0.4, color2: "
     "0.9 } }",
     SLOT_shininess},
    {"an exponent that is decided",
     "shininess: { map: Checker, input: 0.3, color1: { map: Checker, color1: 0.1, color2: 0.9 } }",
     SLOT_shininess},
    {"a Blend",
     "diffuse: { map: Blend, input: { map: Checker, color1: 0, color2: 0.5 }, blend: " PEAK " }",
     SLOT_diffuse},
    {"a Blend of three",
     "diffuse: { map: Blend, input: { map: Checker, color1: 0, color2: { map: VolumeChecker, "
     "color1: 0.5, color2: 0.9 "
     "} }, blend: " PEAK " }",
     SLOT_diffuse},
    {"a Blend over a Blend",
     "diffuse: { map: Blend, input: { map: Blend, input: { map: Checker, color1: 0, color2: 0.5 }, "
     "blend: " PEAK " }, blend: " PEAK " }",
     SLOT_diffuse},
};

enum { MAX_POINTS = SAMPLES * SAMPLES };

/* The points of the pixel. */
static void surface_at(int i, Surface *surface)
{
    oracle_surface_default(surface);
    surface->root[channel_id(GROUP_U, 0)] =
        CENTRE_U + WIDTH_U * ((i % SAMPLES + 0.5) / SAMPLES - 0.5);
    surface->root[channel_id(GROUP_U, 1)] = CENTRE_V;
    for (int component = 0; component < 3; component++)
        surface->root[channel_id(GROUP_X, component)] = CENTRE_XZ;
    surface->root[channel_id(GROUP_X, 1)] =
        CENTRE_Y + WIDTH_Y * ((i / SAMPLES + 0.5) / SAMPLES - 0.5);
}

static Oracle *open_oracle(const Document *d)
{
    return oracle_open(d->graph, &(ReferenceContext){.noise = REFERENCE_LATTICE});
}

typedef struct {
    Document document;
    const Node *map;
    Group group;
} Question;

/* Variance of a component over the pixel. */
static double true_variance(Question *q, int component)
{
    Surface surface;
    double sum = 0, squares = 0;
    Oracle *oracle = open_oracle(&q->document);
    for (int i = 0; i < MAX_POINTS; i++) {
        surface_at(i, &surface);
        double value = oracle_channel(oracle, q->map, channel_id(q->group, component), &surface);
        sum += value;
        squares += value * value;
    }
    oracle_close(oracle);
    return squares / MAX_POINTS - sum / MAX_POINTS * (sum / MAX_POINTS);
}

static double true_mean(const Document *d, Slot slot)
{
    Surface surface;
    SlotValues values;
    double sum = 0;
    Oracle *oracle = open_oracle(d);
    for (int i = 0; i < MAX_POINTS; i++) {
        surface_at(i, &surface);
        assert_true(oracle_material(oracle, d->graph->materials[0].node, &surface, &values));
        sum += values.component[slot][0];
    }
    oracle_close(oracle);
    return sum / MAX_POINTS;
}

static void inputs_of_pixel(double inputs[INPUT_COUNT][4])
{
    memset(inputs, 0, sizeof(double[INPUT_COUNT][4]));
    inputs[INPUT_U][0] = CENTRE_U;
    inputs[INPUT_U][1] = CENTRE_V;
    inputs[INPUT_X][0] = inputs[INPUT_X][2] = CENTRE_XZ;
    inputs[INPUT_X][1] = CENTRE_Y;
    inputs[INPUT_UX][0] = WIDTH_U;
    inputs[INPUT_XY][1] = WIDTH_Y;
}

/* A lowering under way. */
typedef struct {
    Arena arena;
    Session session;
    Job job;
    Lower l;
} Attempt;

static void attempt_open(Attempt *w, const Document *d, int level)
{
    *w = (Attempt){0};
    w->session =
        (Session){.options = &d->options, .arena = &w->arena, .optimize = level, .check = true};
    choice_job(&(MatcOptions){.pass = "value", .aa = "box"}, &w->job);
    w->l = (Lower){.session = &w->session,
                   .graph = d->graph,
                   .ir = ir_new(&w->session, d->graph),
                   .job = &w->job,
                   .cheap = level > 0};
    w->l.ir->simplify = level > 0 ? opt_simplify : NULL;
}

/* A value at the pixel. */
static void attempt_close(Attempt *w, Ref value, double result[4])
{
    Ir *ir = w->l.ir;
    ReferenceTexture textures[EVALUATE_TEXTURES];
    double inputs[INPUT_COUNT][4], results[MAX_OUTPUTS][4];
    ir_output(ir, OUT_color, 0, build_convert(ir, value, TYPE_vec4));
    assert_null(ir_check(ir));
    assert_true(evaluate_textures(&w->arena, ir, textures));
    inputs_of_pixel(inputs);
    ir_eval(ir, &(ReferenceContext){ir->noise, textures}, (const double(*)[4])inputs, results);
    memcpy(result, results[0], sizeof results[0]);
    ir_done(ir);
    arena_free(&w->arena);
}

/* The variance that the answer has, by component; the number of components. */
static int known_variance(Question *q, int level, double variance[4])
{
    Attempt w;
    attempt_open(&w, &q->document, level);
    Env env = lower_surface_env(&w.l);
    MapValue answer = lower_map_value(&w.l, q->map, q->group, &env);
    Type type = ir_type(w.l.ir, answer.value);
    assert_true(!answer.variance || ir_type(w.l.ir, answer.variance) == type);
    Ref zero = ir_const(w.l.ir, type, (double[4]){0});
    attempt_close(&w, answer.variance ? answer.variance : zero, variance);
    return type_table[type].components;
}

static double known_mean(const Document *d, Slot slot, int level)
{
    Attempt w;
    double result[4];
    attempt_open(&w, d, level);
    Env env = lower_surface_env(&w.l);
    Ref value = lower_slot(&w.l, d->graph->materials[0].node, slot, &env);
    attempt_close(&w, build_swizzle(w.l.ir, value, "x"), result);
    return result[0];
}

static void open_text(Document *d, const char *name, const char *slots)
{
    char text[2048];
    snprintf(text, sizeof text, "material: Phong\n%s\n", slots);
    if (!document_open_text(d, text))
        fail_msg("%s: %s", name, document_fault(d));
}

static void variance_is_what_a_mean_leaves_out(void **state)
{
    (void)state;
    int faults = 0;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Question q = {.group = cases[i].group};
        char slots[1024];
        snprintf(slots, sizeof slots, "diffuse: %s", cases[i].map);
        open_text(&q.document, cases[i].name, slots);
        q.map = node_param(q.document.graph->materials[0].node, P_Phong_diffuse)->node;
        for (int level = 0; level <= 2; level += 2) {
            double known[4];
            int components = known_variance(&q, level, known);
            for (int component = 0; component < components; component++) {
                double want = true_variance(&q, component);
                if (fabs(known[component] - want) <= *cases[i].bound * fmax(1, want))
                    continue;
                print_error("%s at -O%d: lane %d has the variance %g, should have %g\n",
                            cases[i].name, level, component, known[component], want);
                faults++;
            }
        }
        document_close(&q.document);
    }
    assert_int_equal(faults, 0);
}

static void what_is_no_line_is_asked_of_both(void **state)
{
    (void)state;
    int faults = 0;
    for (size_t i = 0; i < sizeof means / sizeof *means; i++) {
        Document d;
        open_text(&d, means[i].name, means[i].slots);
        for (int level = 0; level <= 2; level += 2) {
            double known = known_mean(&d, means[i].slot, level),
                   want = true_mean(&d, means[i].slot);
            if (fabs(known - want) <= CLOSE * fmax(1, want))
                continue;
            print_error("%s at -O%d: %.9g, should be %.9g\n", means[i].name, level, known, want);
            faults++;
        }
        document_close(&d);
    }
    assert_int_equal(faults, 0);
}

/* (p q)^2 = p^2 q^2: as good a rule as any, and what was marked by its node, p q, is gone. */
static Ref square_apart(Ir *ir, Ref ref)
{
    if (!ir_is(ir, ref, OP_mul) || ir_arg(ir, ref, 0) != ir_arg(ir, ref, 1) ||
        !ir_is(ir, ir_arg(ir, ref, 0), OP_mul))
        return ref;
    Ref product = ir_arg(ir, ref, 0), p = ir_arg(ir, product, 0), q = ir_arg(ir, product, 1);
    return build_mul(ir, build_square(ir, p), build_square(ir, q));
}

/* sin(e^y) over a pixel: its mean is sin(v) sinc(b / 2) with v = e^y, and b = e^y of the footprint,
 * which is no part of the slope. */
static void a_footprint_is_constant_whatever_is_rewritten(void **state)
{
    (void)state;
    static Simplify *const rules[] = {NULL, square_apart, opt_simplify};
    const double v = exp(CENTRE_Y), b = v * WIDTH_Y, want = cos(v) * v * sin(b / 2) / (b / 2);
    Document d;
    open_text(&d, "a footprint",
              "diffuse: { map: Gradient, direction: [0, 1, 0], waveForm: { wave: Chain, first: "
              "Exp, second: Sin } }");
    for (size_t i = 0; i < sizeof rules / sizeof *rules; i++) {
        Attempt w;
        double known[4];
        attempt_open(&w, &d, 0);
        w.l.ir->simplify = rules[i];
        Env env = lower_surface_env(&w.l);
        const Node *map = node_param(d.graph->materials[0].node, P_Phong_diffuse)->node;
        Ref value = lower_query(&w.l, map, GROUP_IOR, &env);
        slope_set(&w.l, env.root[GROUP_X], DIRECTION_u, build_vec3(w.l.ir, 0, 1, 0));
        attempt_close(&w, slope_of(&w.l, value, DIRECTION_u), known);
        assert_true(fabs(known[0] - want) < 1e-12);
    }
    document_close(&d);
}

/* The footprint is all that remains of it. */
static void no_mark_of_a_footprint_is_left(void **state)
{
    (void)state;
    Document d;
    open_text(&d, "no mark", "diffuse: { map: Checker, input: { map: UVTransform, scaleU: 3 } }");
    for (int level = 0; level <= 2; level += 2) {
        Attempt w;
        attempt_open(&w, &d, level);
        w.job.slot = SLOT_diffuse;
        const Ir *ir = compile_ir(&w.session, d.graph, d.graph->materials[0].node, &w.job);
        assert_non_null(ir);
        for (Ref ref = 1; ref < ir->count; ref++)
            assert_false(ir_is(ir, ref, OP_detach));
        arena_free(&w.arena);
    }
    document_close(&d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(variance_is_what_a_mean_leaves_out),
        cmocka_unit_test(what_is_no_line_is_asked_of_both),
        cmocka_unit_test(a_footprint_is_constant_whatever_is_rewritten),
        cmocka_unit_test(no_mark_of_a_footprint_is_left),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
