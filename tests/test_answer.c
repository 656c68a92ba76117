/* What a map's answer leaves out of a pixel, at every level of -O, against the variance of the oracle's values over that pixel. The
 * maps here vary by whole periods, so that their means' slopes show nothing of it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "compiler/ir/build.h"
#include "compiler/ir/fold.h"
#include "compiler/lower/answer.h"
#include "compiler/opt/opt.h"
#include "tests/value/documents.h"
#include "tests/value/evaluate.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* The pixel: u changes by 1/2 towards the right one, of which a checker's odd squares have a quarter; y by 1 upward. */
static const double CENTRE_U = 0.375, CENTRE_V = 0.1, WIDTH_U = 0.5, CENTRE_Y = 0.2, WIDTH_Y = 1;
enum { SAMPLES = 64 };

#define SINE  "{ map: Gradient, direction: [0, 1, 0], waveForm: Sin01 }"
#define CHAIN "map: Gradient, direction: [0, 1, 0], waveForm: { wave: Chain, first: Sin01"
#define HALF  "{ map: Gradient, direction: [0, 2, 0], waveForm: { wave: Chain, first: Sin01, factor: 0.5, second: Id } }"

static const double CLOSE = 1e-6, ROUGHLY = 0.02; /* of what is a straight line, and of what is only nearly one */

static const struct {
    const char *name, *map;
    Group group;
    const double *bound; /* of the difference, in units of max(1, variance) */
} cases[] = {
    {"a wave", SINE, GROUP_R, &CLOSE},
    {"as a position", SINE, GROUP_X, &CLOSE},
    {"as a number", SINE, GROUP_IOR, &CLOSE},
    {"scaled and moved",
     "{ map: Gradient, direction: [0, 1, 0], waveForm: { wave: Chain, first: Sin01, factor: -3, shift: 7, second: Id } "
     "}",
     GROUP_R, &CLOSE},
    {"e v", "{ " CHAIN ", second: E } }", GROUP_R, &CLOSE},
    {"pi v", "{ " CHAIN ", second: Pi } }", GROUP_R, &CLOSE},
    {"phi v", "{ " CHAIN ", second: Phi } }", GROUP_R, &CLOSE},
    {"steps", "{ " CHAIN ", factor: 40, second: Floor } }", GROUP_R, &ROUGHLY},
    {"steps upward", "{ " CHAIN ", factor: 40, second: Ceil } }", GROUP_R, &ROUGHLY},
    {"a square", "{ " CHAIN ", shift: 5, second: Sqr } }", GROUP_R, &ROUGHLY},
    {"along a direction",
     "{ map: Gradient, direction: [0, -3, 0], input: { map: XYZTransform, transform: { translation: [0, 1, 0] }, "
     "input: " SINE " } }",
     GROUP_R, &CLOSE},
    {"scaled lanes", "{ map: XYZTransform, transform: { scale: [3, -2, 0.5] }, input: " SINE " }", GROUP_X, &CLOSE},
    {"turned",
     "{ map: XYZTransform, transform: { rotation: [0, 0, 1.5707963267948966], scale: [3, 2, 1] }, input: " SINE " }",
     GROUP_X, &CLOSE},
    {"turned uv", "{ map: UVTransform, scaleU: -2, scaleV: 3, offsetU: 5, input: " SINE " }", GROUP_U, &CLOSE},
    {"passed on", "{ map: UVTransform, scaleU: 2, input: " SINE " }", GROUP_X, &CLOSE},
    {"wrinkled by nothing", "{ map: Turbulence, amount: [0, 0, 0], input: " SINE " }", GROUP_X, &CLOSE},
    {"a share", "{ map: Checker, color1: " SINE ", color2: 0 }", GROUP_R, &CLOSE},
    {"the other share", "{ map: Checker, color1: 0, color2: " SINE " }", GROUP_R, &CLOSE},
    {"one colour twice", "{ map: Checker, color1: &s " SINE ", color2: *s }", GROUP_R, &CLOSE},
    {"with an alpha", "{ map: Checker, color1: " SINE ", color2: [0, 0, 0, 1] }", GROUP_R, &CLOSE},
    {"a share of a share",
     "{ map: Checker, color1: { map: Checker, input: 0, color1: 0, color2: " SINE " }, color2: " HALF " }", GROUP_R,
     &CLOSE},
    {"a Blend of one", "{ map: Blend, input: { map: Carpenter, input: 1 }, blend: [{ value: 1, input: " SINE " }] }",
     GROUP_R, &CLOSE},
    {"a Blend at a point",
     "{ map: Blend, input: 0.25, blend: [{ value: 0, input: " SINE " }, { value: 1, input: " HALF " }] }", GROUP_R,
     &CLOSE},
    {"a Blend at a step",
     "{ map: Blend, input: 1, blend: [{ value: 1, input: " SINE " }, { value: 1, input: " HALF
     " }, { value: 2, input: 0 }] }",
     GROUP_R, &CLOSE},
    {"a Blend far behind",
     "{ map: Blend, input: 9, blend: [{ value: 0, input: " SINE " }, { value: 1, input: " HALF " }] }", GROUP_R,
     &CLOSE},
};

typedef struct {
    Document document;
    const Node *map;
    Group group;
} Question;

/* Of a lane over the pixel. */
static double true_variance(Question *q, int lane)
{
    Surface surface;
    double sum = 0, squares = 0;
    Oracle *oracle = oracle_open(q->document.graph, &(ReferenceContext){.noise = REFERENCE_LATTICE});
    oracle_surface_default(&surface);
    surface.root[channel_id(GROUP_U, 1)] = CENTRE_V;
    for (int i = 0; i < SAMPLES * SAMPLES; i++) {
        surface.root[channel_id(GROUP_U, 0)] = CENTRE_U + WIDTH_U * ((i % SAMPLES + 0.5) / SAMPLES - 0.5);
        surface.root[channel_id(GROUP_X, 1)] = CENTRE_Y + WIDTH_Y * ((i / SAMPLES + 0.5) / SAMPLES - 0.5);
        double value = oracle_channel(oracle, q->map, channel_id(q->group, lane), &surface);
        sum += value;
        squares += value * value;
    }
    oracle_close(oracle);
    const double count = SAMPLES * SAMPLES;
    return squares / count - sum / count * (sum / count);
}

static void inputs_of_pixel(double inputs[INPUT_COUNT][4])
{
    memset(inputs, 0, sizeof(double[INPUT_COUNT][4]));
    inputs[INPUT_U][0] = CENTRE_U;
    inputs[INPUT_U][1] = CENTRE_V;
    inputs[INPUT_X][1] = CENTRE_Y;
    inputs[INPUT_UX][0] = WIDTH_U;
    inputs[INPUT_XY][1] = WIDTH_Y;
}

/* The variance that the answer has, by lane; the number of lanes. */
static int known_variance(Question *q, int level, double variance[4])
{
    Arena arena = {0};
    Session session = {.options = &q->document.options, .arena = &arena, .optimize = level, .check = true};
    Job job;
    ReferenceTexture textures[EVALUATE_TEXTURES];
    double inputs[INPUT_COUNT][4], result[MOST_OUTPUTS][4];
    choice_job(&(MatcOptions){.pass = "value", .aa = "box"}, &job);
    Lower l = {.session = &session,
               .graph = q->document.graph,
               .ir = ir_new(&session, q->document.graph),
               .job = &job,
               .cheap = level > 0};
    l.ir->simplify = level > 0 ? opt_simplify : NULL;
    Env env = lower_surface_env(&l);
    Answer answer = lower_answer(&l, q->map, q->group, &env);
    int lanes = ir_lanes(l.ir, answer.value);
    assert_true(!answer.variance || ir_type(l.ir, answer.variance) == ir_type(l.ir, answer.value));
    Ref zero = ir_const(l.ir, ir_type(l.ir, answer.value), (double[4]){0});
    ir_output(l.ir, OUT_color, 0, build_convert(l.ir, answer.variance ? answer.variance : zero, TYPE_vec4));
    assert_null(ir_check(l.ir));
    assert_true(evaluate_textures(&arena, l.ir, textures));
    inputs_of_pixel(inputs);
    ir_eval(l.ir, &(ReferenceContext){l.ir->noise, textures}, (const double(*)[4])inputs, result);
    memcpy(variance, result[0], sizeof result[0]);
    ir_done(l.ir);
    arena_free(&arena);
    return lanes;
}

static void variance_is_what_a_mean_leaves_out(void **state)
{
    (void)state;
    int faults = 0;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Question q = {.group = cases[i].group};
        char text[1024];
        snprintf(text, sizeof text, "material: Phong\ndiffuse: %s\n", cases[i].map);
        if (!document_open_text(&q.document, text))
            fail_msg("%s: %s", cases[i].name, document_fault(&q.document));
        q.map = node_param(q.document.graph->materials[0].node, P_Phong_diffuse)->node;
        for (int level = 0; level <= 2; level += 2) {
            double known[4];
            int lanes = known_variance(&q, level, known);
            for (int lane = 0; lane < lanes; lane++) {
                double want = true_variance(&q, lane);
                if (fabs(known[lane] - want) <= *cases[i].bound * fmax(1, want))
                    continue;
                print_error("%s at -O%d: lane %d has the variance %g, should have %g\n", cases[i].name, level, lane,
                            known[lane], want);
                faults++;
            }
        }
        document_close(&q.document);
    }
    assert_int_equal(faults, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(variance_is_what_a_mean_leaves_out),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
