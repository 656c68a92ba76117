/* The optimizer does no needless work: each node that no rule changes is tried once, and rounds
 * end when a round leaves the program unchanged. The test counts steps, which are equal on every
 * machine. Equal nodes are found, however many nodes share an operand. */
#include "tests/test.h"
#include "compiler/opt/opt.h"
#include "compiler/pipeline.h"
#include <string.h>

static int asked; /* how often a rule was */

static Ref count_asked(Ir *ir, Ref ref)
{
    asked++;
    return opt_simplify(ir, ref);
}

static void a_simple_node_is_asked_once(void **state)
{
    (void)state;
    Arena arena = {0};
    MatcOptions options;
    matc_options_init(&options);
    Session session = {.options = &options, .arena = &arena, .optimize = 2};
    Ir *ir = ir_new(&session, NULL);
    ir->simplify = count_asked;
    const Ref p = build_input(ir, INPUT_X), x = build_swizzle(ir, p, "x"),
              y = build_swizzle(ir, p, "y");
    asked = 0;
    const Ref sum = build_add(ir, y, x);
    const int first = asked;
    assert_true(first > 0);
    assert_int_equal(build_add(ir, y, x), sum);
    assert_int_equal(asked, first);
    /* what a rule does change is changed whenever it is met: x * 1 is x */
    const Ref one = build_float(ir, 1);
    assert_int_equal(build_mul(ir, x, one), x);
    assert_int_equal(build_mul(ir, x, one), x);
    assert_true(asked > first + 1);
    ir_done(ir);
    arena_free(&arena);
}

static Ref twice(Ir *ir, Ref ref, const void *user)
{
    asked++;
    return ref == *(const Ref *)user ? build_add(ir, ref, ref) : ref;
}

/* Fixture of an IR that is made by hand. */
typedef struct {
    MatcOptions options;
    Session session;
} Bench;

static Ir *bench_open(Bench *bench, Arena *arena)
{
    matc_options_init(&bench->options);
    bench->session = (Session){.options = &bench->options, .arena = arena};
    return ir_new(&bench->session, NULL);
}

/* sin cos x + |x|: what is settled is not asked; but what is made anew, since an operand was,
 * is. */
static void a_settled_node_is_asked_when_it_is_made_anew(void **state)
{
    (void)state;
    Arena arena = {0};
    Bench bench;
    Ir *ir = bench_open(&bench, &arena);
    const Ref x = build_swizzle(ir, build_input(ir, INPUT_X), "x"), a = build_cos(ir, x),
              other = build_abs(ir, x);
    const Ref b = build_add_of(ir, (Ref[]){build_sin(ir, a), other}), none = 0;
    ir_output(ir, OUT_depth, 0, b);
    const uint8_t *live = ir_live_kept(ir);
    for (Ref ref = 1; ref < ir->count; ref++)
        ir->nodes[ref].flags |= NODE_decided;
    asked = 0;
    assert_false(ir_sweep_unsettled(ir, NODE_decided, twice, &none));
    assert_int_equal(asked, 0);
    assert_ptr_equal(ir_live_kept(ir), live); /* nobody has to look again who is alive */
    ir->nodes[a].flags &= (uint8_t)~NODE_decided;
    assert_true(ir_sweep_unsettled(ir, NODE_decided, twice, &a));
    assert_int_equal(asked, 3); /* a, and the sine of what stands for it, and the sum with that */
    const Ref sum = ir->outputs[0].value, sine = ir_arg(ir, sum, 0);
    assert_true(sum != b && ir_is(ir, sine, OP_sin) && ir_is(ir, ir_arg(ir, sine, 0), OP_add));
    assert_int_equal(ir_arg(ir, sum, 1), other);
    assert_true(ir_live_kept(ir)[sine] && !ir_live_kept(ir)[b]);
    /* and who is alive is asked again when there is one more to see it */
    ir_output(ir, OUT_depth, 1, b);
    assert_true(ir_live_kept(ir)[b]);
    ir_done(ir);
    arena_free(&arena);
}

/* Nodes of one young operand and many old ones, which would all stand at one place of the table;
 * each is one node, and found again. */
static void equal_nodes_are_one(void **state)
{
    enum { COUNT = 20000 };
    (void)state;
    Arena arena = {0};
    Bench bench;
    Ir *ir = bench_open(&bench, &arena);
    Ref *old = ARENA_ARRAY(&arena, Ref, COUNT), *sum = ARENA_ARRAY(&arena, Ref, COUNT);
    for (int i = 0; i < COUNT; i++)
        old[i] = build_float(ir, i);
    const Ref young = build_swizzle(ir, build_input(ir, INPUT_X), "x");
    for (int i = 0; i < COUNT; i++)
        sum[i] = build_add(ir, young, old[i]);
    const size_t count = ir->count;
    for (int again = 0; again < 2; again++, ir_rehash(ir))
        for (int i = 0; i < COUNT; i++) {
            assert_int_equal(build_float(ir, i), old[i]);
            assert_int_equal(build_add(ir, young, old[i]), sum[i]);
            assert_true(!i || sum[i] == sum[i - 1] + 1);
        }
    assert_int_equal(ir->count, count);
    ir_done(ir);
    arena_free(&arena);
}

static Ir *ir_for(Session *session, const char *text, Job *job)
{
    Tree *tree;
    const Source source = {.name = "rounds.yaml", .text = text, .size = strlen(text)};
    ARENA_PUSH(session->arena, session->sources, session->source_count, session->source_capacity,
               source);
    assert_null(choice_job(session->options, job));
    const Graph *graph = compile_front(session, 0, &tree);
    assert_non_null(graph);
    Ir *ir = compile_ir(session, graph, graph->materials[0].node, job);
    assert_non_null(ir);
    return ir;
}

static Ir *ir_of(Session *session, const char *text)
{
    Job job;
    return ir_for(session, text, &job);
}

/* Bytes that arenas hand out for a product of so many quotients under a BumpMap, from its text to
 * the program's. */
static double memory_of(int quotients)
{
    Arena arena = {0}, own = {0};
    Text text = text_new(&own);
    Products products = {0};
    MatcOptions options;
    Job job;
    matc_options_init(&options);
    options.validate = false;
    Session session = {.options = &options, .arena = &arena, .optimize = 2};
    text_put(&text, "material: Phong\ninput: { map: BumpMap, displacement: \"= 1");
    for (int i = 0; i < quotients; i++)
        text_format(&text, " * (u / (v + %d))", i + 1);
    text_put(&text, "\" }\n");
    Ir *ir = ir_for(&session, text.at, &job);
    assert_true(compile_back(&session, ir, &job, &products));
    const double used = (double)arena.used;
    arena_free(&arena);
    arena_free(&own);
    return used;
}

/* Its slopes are sums of as many products as it has factors, each of all others: they are made of
 * what there is already. */
static void a_long_product_takes_memory_by_its_length(void **state)
{
    (void)state;
    const double most_each = 10000, one = memory_of(1000), eight = memory_of(8000);
    print_message("%.0f bytes for each of 1,000 quotients, %.0f for each of 8,000\n", one / 1000,
                  eight / 8000);
    assert_true(one <= 1000 * most_each && eight <= 8000 * most_each);
}

typedef struct {
    bool (*may)(const Ir *ir, Ref ref);
    IrRewrite *rewrite;
} AskedRule;

/* On the IR as lowering makes it, of which every rule changes something: a node that the optimizer
 * skips for a rule is one that the rule would leave. */
static void a_rule_leaves_what_it_is_not_asked_of(void **state)
{
    static const AskedRule rules[] = {{opt_may_fold, opt_rewrite_fold},
                                      {opt_may_swizzle, opt_rewrite_swizzle},
                                      {opt_may_select, opt_rewrite_select},
                                      {opt_may_power, opt_rewrite_power}};
    enum { RULE_COUNT = sizeof rules / sizeof *rules };
    static const char text[] =
        "material: Phong\n"
        "diffuse: \"= a = p.zyx * pow(max(u, .1), .5); b = 2 > 1 ? a : [u, v, .5]; c = u > .5 ? 1 "
        ": 2;"
        " mix(b, [3 * c, v / (1 + c), (u > v ? u : v) ^ 3], fract(4 * u))\"\n"
        "shininess: { map: Granite, input: { map: UVTransform, scaleU: 2 } }\n";
    int spared = 0, changed[RULE_COUNT] = {0};
    Arena arena = {0};
    MatcOptions options;
    (void)state;
    matc_options_init(&options);
    Session session = {.options = &options, .arena = &arena};
    Ir *ir = ir_of(&session, text);
    const Uses uses = opt_uses(ir, &arena);
    for (Ref ref = 1; ref < uses.count; ref++)
        for (int i = 0; i < RULE_COUNT; i++) {
            const bool leaves = rules[i].rewrite(ir, ref, &uses) == ref,
                       asked = rules[i].may(ir, ref);
            assert_true(leaves || asked);
            spared += !asked;
            changed[i] += !leaves;
        }
    for (int i = 0; i < RULE_COUNT; i++)
        assert_true(changed[i] > 0);
    assert_true(spared > 2 * (int)uses.count); /* of four */
    ir_done(ir);
    arena_free(&arena);
}

/* How often a pass ran over a document's program, and how many nodes are left. */
static int runs_of(const char *text, const char *pass, int *nodes)
{
    Arena arena = {0};
    MatcOptions options;
    int runs = 0;
    matc_options_init(&options);
    Session session = {.options = &options, .arena = &arena, .optimize = 2, .measure = true};
    ir_of(&session, text);
    for (size_t i = 0; i < session.stat_count; i++) {
        runs += !strcmp(session.stats[i].name, pass);
        *nodes = session.stats[i].nodes ? session.stats[i].nodes : *nodes;
    }
    arena_free(&arena);
    return runs;
}

/* A number has no intervals to find; a formula whose author clamped a bounded value has one round
 * of them. */
static void rounds_end_where_nothing_is_found(void **state)
{
    (void)state;
    int nodes, left;
    static const char number[] = "material: Phong\ndiffuse: 0.5\n",
                      plain[] = "material: Phong\ndiffuse: \"= fract(u)\"\n",
                      bounded[] = "material: Phong\ndiffuse: \"= max(fract(u), -1)\"\n";
    assert_int_equal(runs_of(number, "polish", &nodes), 1);
    assert_int_equal(runs_of(number, "range", &nodes), 1);
    assert_int_equal(runs_of(plain, "range", &nodes), 1);
    assert_int_equal(runs_of(bounded, "range", &left), 2);
    assert_int_equal(runs_of(plain, "range", &nodes), 1);
    assert_int_equal(left, nodes); /* and that is all that was there to be found */
    /* what a sweep made anew has an interval in the next round alone, and is decided then */
    runs_of("material: Phong\ndiffuse: \"= 2 * fract(u)\"\n", "range", &nodes);
    assert_int_equal(
        runs_of("material: Phong\ndiffuse: \"= max(2 * max(fract(u), -1), -3)\"\n", "range", &left),
        3);
    assert_int_equal(left, nodes);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_simple_node_is_asked_once),
        cmocka_unit_test(a_settled_node_is_asked_when_it_is_made_anew),
        cmocka_unit_test(equal_nodes_are_one),
        cmocka_unit_test(a_rule_leaves_what_it_is_not_asked_of),
        cmocka_unit_test(rounds_end_where_nothing_is_found),
        cmocka_unit_test(a_long_product_takes_memory_by_its_length),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
