/* A new operation needs only its row and that row's lines: this program is built with the
 * operation that the head of grammar/ops.def adds, and with no other change. The operation is
 * built by name, folded, evaluated, differentiated, bounded, counted, printed, read and written. */
#include "compiler/ir/build.h"
#include "compiler/ir/fold.h"
#include "compiler/ir/range.h"
#include "compiler/lower/slope.h"
#include "compiler/opt/opt.h"
#include "compiler/pipeline.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static int faults;

static void expect(bool holds, const char *what)
{
    if (!holds)
        fprintf(stderr, "inversesqrt: %s\n", what);
    faults += !holds;
}

static bool is_near(double a, double b) { return fabs(a - b) <= 1e-4 * fabs(b); }

/* Checks x, the texture coordinate's u, at 4: 1/2, and -4^(-3/2) / 2 = -1/16 by u. */
static void check_value(const Ir *ir)
{
    double inputs[INPUT_COUNT][4] = {{0}}, result[MAX_OUTPUTS][4];
    inputs[INPUT_U][0] = 4;
    ir_eval(ir, &(ReferenceContext){0}, (const double(*)[4])inputs, result);
    expect(is_near(result[0][0], 0.5), "its value is not that of its FOLD");
    expect(is_near(result[1][0], -1.0 / 16), "its derivative is not that of its SLOPE");
}

static void check_range(Ir *ir, Ref x)
{
    Ref root = build_inversesqrt(ir, build_clamp(ir, x, build_float(ir, 1), build_float(ir, 4)));
    Ranges ranges = range_find(ir, &ir->scratch, 1);
    const Interval within = range_of(&ranges, ir, root, 0);
    expect(is_near(within.low, 0.5) && is_near(within.high, 1),
           "its interval is not that of its RANGE");
    expect(!range_is_exact(OP_inversesqrt), "its interval is exact");
}

static void check_text(Session *session, const Ir *ir, const Graph *graph)
{
    Text text = text_new(session->arena);
    const char *fault = NULL;
    ir_print(&text, ir);
    expect(strstr(text.at, "inversesqrt float"), "it is not printed");
    expect(ir_read(session, text.at, graph, &fault), "what is printed of it cannot be read");
}

static void check_program(Session *session, const Ir *ir, const Job *job)
{
    Products products = {0};
    bool valid = compile_back(session, ir, job, &products);
    expect(valid && strstr(products.fragment, "inversesqrt("), "no valid program calls it");
}

int main(void)
{
    Arena arena = {0};
    const MatcOptions options = {.pass = "value", .derivatives = "analytic", .validate = true};
    Session session = {.arena = &arena, .options = &options, .optimize = 1};
    const Graph graph = {0};
    Job job;
    choice_job(&options, &job);
    Lower l = {.session = &session, .graph = &graph, .ir = ir_new(&session, &graph), .job = &job};
    Ir *ir = l.ir;
    ir->simplify = opt_simplify;
    Ref x = build_component(ir, build_input(ir, INPUT_U), 0), root = build_inversesqrt(ir, x);
    expect(ir_is_number(ir, build_inversesqrt(ir, build_float(ir, 16)), 0.25), "it is not folded");
    expect(ir_cost(ir, root) == 4, "its cost is not that of its COST");
    ir_output(ir, OUT_color, 0, build_convert(ir, root, TYPE_vec4));
    ir_output(ir, OUT_color, 1, build_convert(ir, slope_of(&l, root, DIRECTION_u), TYPE_vec4));
    expect(!ir_check(ir), "the IR is broken");
    check_value(ir);
    check_range(ir, x);
    check_text(&session, ir, &graph);
    check_program(&session, ir, &job);
    ir_done(ir);
    arena_free(&arena);
    return faults != 0;
}
