/* Metamorphic test: pairs of documents with different text and equal meaning, built of random
 * maps. Both are compared as IR in double, as written and optimized, at hostile points. If the
 * optimizer should recognize the equality, both must have equal node counts and costs. */
#include "tests/test.h"
#include "tests/stress/generate.h"
#include "tests/stress/spread.h"
#include "tests/stress/trial.h"
#include <stdio.h>
#include <string.h>

enum { TREES = 150, POINTS = 24, TREE_SIZE = 6, LONGEST = 1 << 16 };

/* How closely two documents must agree; a bound is relative to max(1, |value|). */
static const double bits = 0, roundings = 1e-14, sums = 1e-11;
typedef struct {
    double bound;
    bool one; /* the optimized IR has the same nodes */
} Same;

typedef struct {
    Arena arena;
    MatcOptions options;
    Session session;
    Graph *graph;
    const Ir *ir[2];
    ReferenceTexture textures[2][EVALUATE_TEXTURES];
} Side;

static void side_open(Side *s, const char *text, Slot slot)
{
    Tree *tree;
    *s = (Side){0};
    matc_options_init(&s->options);
    s->options.pixels = true;
    s->options.aa =
        /* what is averaged goes by what a program costs, and documents that mean the same may
         * differ in that */
        "none";
    s->options.read_file = generate_file;
    s->session = (Session){.options = &s->options, .arena = &s->arena, .check = true};
    Source source = {.name = "same.yaml", .text = text, .size = strlen(text)};
    ARENA_PUSH(&s->arena, s->session.sources, s->session.source_count, s->session.source_capacity,
               source);
    s->graph = compile_front(&s->session, 0, &tree);
    if (!s->graph || s->session.diags.errors)
        fail_msg("%s\n%s", text, s->session.diags.count ? s->session.diags.at[0].message : "");
    Job job;
    choice_job(&s->options, &job);
    job.pass = PASS_value;
    job.slot = slot;
    for (int i = 0; i < 2; i++) {
        s->session.optimize = 2 * i;
        s->ir[i] = compile_ir(&s->session, s->graph, s->graph->materials[0].node, &job);
        assert_non_null(s->ir[i]);
        assert_true(evaluate_textures(&s->arena, s->ir[i], s->textures[i]));
    }
}

static void evaluate(const Side *s, int level, const Point *point, bool front, Evaluation *e)
{
    double inputs[INPUT_COUNT][4];
    ReferenceContext context = {s->ir[level]->noise, s->textures[level]};
    evaluate_inputs(point, front, inputs);
    evaluate_double(s->ir[level], &context, (const double(*)[4])inputs, e);
}

static const char *ir_text(Side *s)
{
    Text text = text_new(&s->arena);
    ir_print(&text, s->ir[1]);
    return text.at;
}

/* Where floats cannot tell the parts of a pattern, or moving a coordinate loses it, nothing is
 * compared. */
static bool is_fit(const Point *p)
{
    for (int component = 0; component < 2; component++)
        if (p->input[INPUT_U][component] != 0 && fabsf(p->input[INPUT_U][component]) < 1e-6f)
            return false;
    return !point_is_extreme(p);
}

/* A rule: two documents, made with the same random maps a, b, c. Where the maps are put in, those
 * documents. */
typedef struct {
    const char *first, *second; /* %a, %b and %c stand for the maps */
    Slot slot;
    Same same;
} Rule;

static void compare(const Rule *rule, const Point *field, int first)
{
    const char *a = rule->first, *b = rule->second;
    const Same same = rule->same;
    Side sides[2];
    side_open(&sides[0], a, rule->slot);
    side_open(&sides[1], b, rule->slot);
    int nodes[2], costs[2];
    for (int i = 0; i < 2; i++)
        ir_measure(sides[i].ir[1], &nodes[i], &costs[i]);
    if (same.one && (nodes[0] != nodes[1] || costs[0] != costs[1]))
        fail_msg("not one program:\n%s\n%s\n%s\n%s", a, b, ir_text(&sides[0]), ir_text(&sides[1]));
    for (int i = 0; i < POINTS; i++)
        for (int level = 0; level < 2; level++) {
            const Point *point = &field[(first + i) % FIELD_COUNT];
            Evaluation x, y;
            evaluate(&sides[0], level, point, i % 3, &x);
            evaluate(&sides[1], level, point, i % 3, &y);
            if (!is_fit(point) || x.peak > GREATEST_VALUE || y.peak > GREATEST_VALUE)
                continue;
            for (int component = 0; component < 3; component++) {
                double want = x.value[0][component], got = y.value[0][component];
                /* both may be infinite */
                if (want != got && !(fabs(want - got) <= same.bound * fmax(1, fabs(want))))
                    fail_msg("-O%d lane %d: %.17g and %.17g at point %d\n%s\n%s", 2 * level,
                             component, want, got, (first + i) % FIELD_COUNT, a, b);
            }
        }
    arena_free(&sides[0].arena);
    arena_free(&sides[1].arena);
}

static void fill(char *out, const char *pattern, char *const maps[3])
{
    size_t size = 0;
    for (; *pattern; pattern++) {
        if (pattern[0] == '%' && pattern[1] >= 'a' && pattern[1] <= 'c') {
            const char *map = maps[*++pattern - 'a'];
            size += (size_t)snprintf(out + size, LONGEST - size, "%s", map);
        } else {
            out[size++] = *pattern;
        }
        assert_true(size < LONGEST - 1);
    }
    out[size] = 0;
}

static void try_rule(const Rule *rule, uint64_t seed)
{
    static Point field[FIELD_COUNT];
    static char first[LONGEST], second[LONGEST];
    hostile_points(field);
    for (int tree = 0; tree < TREES; tree++) {
        Arena arena = {0};
        Choices choices;
        char *maps[3];
        choices_random(&choices, seed, (uint64_t)tree);
        for (int i = 0; i < 3; i++) {
            Text text = text_new(&arena);
            generate_map(&choices, &text, tree % TREE_SIZE);
            maps[i] = text.at;
            for (char *at = maps[i]; (at = strstr(at, "param: p")); at += 8)
                at[7] = (char)('q' + i); /* params of different maps have different names */
        }
        fill(first, rule->first, maps);
        fill(second, rule->second, maps);
        compare(&(Rule){first, second, rule->slot, rule->same}, field, tree * 131);
        arena_free(&arena);
    }
}

#define PHONG(map)  "material: Phong\nemissive: " map "\n"
#define NORMAL(map) "material: Phong\ninput: " map "\n"

static const Rule rules[] = {
    /* Blend(a, a, t) = a; mix(a, a, t) rounds unless it is optimized. */
    {PHONG("%a"),
     PHONG("{ map: Blend, blend: [{ value: -1, input: %a }, { value: 1, input: %a }], input: %b }"),
     SLOT_emissive,
     {roundings, false}},
    {PHONG("%a"),
     PHONG("{ map: Blend, blend: [{ value: 0.5, input: %a }], input: %b }"),
     SLOT_emissive,
     {bits, true}},
    /* Two items of one value are an edge: what stands between them is never seen. */
    {PHONG("{ map: Blend, blend: [{ value: 0, input: %a }, { value: 0, input: %b }], input: %c }"),
     PHONG("{ map: Blend, blend: [{ value: 0, input: %a }, { value: 0, input: [1, 2, 3] }, { "
           "value: 0, input: %b }], "
           "input: %c }"),
     SLOT_emissive,
     {bits, false}},
    /* Transforms that do nothing. */
    {PHONG("{ map: Checker, color1: %a, color2: %b, input: %c }"),
     PHONG("{ map: Checker, color1: %a, color2: %b, input: { map: UVTransform, input: %c } }"),
     SLOT_emissive,
     {bits, true}},
    {NORMAL("{ map: BumpMap, displacement: { map: UVTransform, input: %a }, input: %b }"),
     NORMAL("{ map: BumpMap, displacement: { map: UVTransform, input: %a }, input: { map: "
            "UVTransform, input: %b } }"),
     SLOT_normal,
     {bits, true}},
    {PHONG("{ map: Wood, input: %c }"),
     PHONG("{ map: Wood, input: { map: XYZTransform, transform: { translation: [0, 0, 0] }, input: "
           "%c } }"),
     SLOT_emissive,
     {bits, true}},
    {PHONG("{ map: Leopard, input: %c }"),
     PHONG("{ map: Leopard, input: { map: XYZTransform, transform: { rotation: [0, 0, 0], scale: "
           "[1, 1, 1] }, input: "
           "%c } }"),
     SLOT_emissive,
     {bits, true}},
    {PHONG("%a"), PHONG("{ map: XYZTransform, input: %a }"), SLOT_emissive, {bits, true}},
    /* Two transforms and their product. Powers of two round nothing. */
    {PHONG("{ map: Checker, color1: %a, color2: %b, input: { map: UVTransform, scaleU: 8, scaleV: "
           "0.5, input: %c } }"),
     PHONG("{ map: Checker, color1: %a, color2: %b, input: { map: UVTransform, scaleU: 2, scaleV: "
           "2, input: { map: "
           "UVTransform, scaleU: 4, scaleV: 0.25, input: %c } } }"),
     SLOT_emissive,
     {bits, false}},
    {PHONG("{ map: Granite, input: { map: XYZTransform, transform: { scale: 0.5 }, input: %c } }"),
     PHONG("{ map: Granite, input: { map: XYZTransform, transform: { scale: 2 }, input: { map: "
           "XYZTransform, "
           "transform: { scale: 0.25 }, input: %c } } }"),
     SLOT_emissive,
     {bits, false}},
    {PHONG("{ map: Gradient, waveForm: Atan, input: { map: XYZTransform, transform: { rotation: "
           "[0, 0, 1.25] } } }"),
     PHONG("{ map: Gradient, waveForm: Atan, input: { map: XYZTransform, transform: { rotation: "
           "[0, 0, 0.5] }, input: "
           "{ map: XYZTransform, transform: { rotation: [0, 0, 0.75] } } } }"),
     SLOT_emissive,
     {1e-8, false}}, /* of coordinates to 4e6, whose 1e-16 is as much */
    {PHONG("{ map: Gradient, waveForm: Atan, input: { map: XYZTransform, transform: { matrix: [2, "
           "0.5, 0, 1, 0, 1, 0, "
           "0, 0, 0, 1, 0, 0, 0, 0, 1] } } }"),
     PHONG("{ map: Gradient, waveForm: Atan, input: { map: XYZTransform, transform: { translation: "
           "[1, 0, 0] }, input: "
           "{ map: XYZTransform, transform: { scale: [2, 1, 1], shear: [0.25, 0, 0] } } } }"),
     SLOT_emissive,
     {1e-8, false}},
    /* Colors that change places, and a pattern that moves by a cell. */
    {PHONG("{ map: Checker, color1: %a, color2: %b }"),
     PHONG("{ map: Checker, color1: %b, color2: %a, input: { map: UVTransform, offsetU: 0.5 } }"),
     SLOT_emissive,
     {bits, false}},
    {PHONG("{ map: Checker, color1: %a, color2: %b }"),
     PHONG("{ map: Checker, color1: %a, color2: %b, input: { map: UVTransform, offsetU: -0.5, "
           "offsetV: 1.5 } }"),
     SLOT_emissive,
     {bits, false}},
    /* Numbers and params of the same value. */
    {PHONG("{ map: Blend, blend: [{ value: -0.5, input: %a }, { value: 0.75, input: [0.25, 0.5, 1] "
           "}], input: { map: "
           "Wood, frequency: 3, phase: 0.125, waveForm: Sin01, input: %c } }"),
     PHONG("{ map: Blend, blend: [{ value: { param: v0, default: -0.5 }, input: %a }, { value: { "
           "param: v1, default: "
           "0.75 }, input: { param: v2, default: [0.25, 0.5, 1] } }], input: { map: Wood, "
           "frequency: { param: v3, "
           "default: 3 }, phase: { param: v4, default: 0.125 }, waveForm: Sin01, input: %c } }"),
     SLOT_emissive,
     {sums, false}},
    {PHONG("{ map: Checker, color1: %a, color2: 0.25, input: { map: UVTransform, scaleU: 3, "
           "scaleV: 5, shear: 0.5, "
           "offsetU: 0.125 } }"),
     PHONG("{ map: Checker, color1: %a, color2: { param: v0, default: 0.25 }, input: { map: "
           "UVTransform, scaleU: { "
           "param: v1, default: 3 }, scaleV: { param: v2, default: 5 }, shear: { param: v3, "
           "default: 0.5 }, offsetU: { "
           "param: v4, default: 0.125 } } }"),
     SLOT_emissive,
     {bits, false}},
    {NORMAL("{ map: WaveMap, amplitude: 0.5, uCount: 3, vCount: 2 }"),
     NORMAL("{ map: WaveMap, amplitude: { param: v0, default: 0.5 }, uCount: { param: v1, default: "
            "3 }, vCount: { "
            "param: v2, default: 2 } }"),
     SLOT_normal,
     {sums, false}},
    /* Switches of one material, sharing, other names. A filter that is written twice is two
     * functions. */
    {PHONG("%a"),
     "material: SideSwitch\nfrontShader: { material: Phong, emissive: %a }\n",
     SLOT_emissive,
     {bits, true}},
    {PHONG("%a"),
     "material: SideSwitch\nfrontShader: { material: Phong, emissive: %a }\nbackShader: { "
     "material: Phong, emissive: "
     "%a "
     "}\n",
     SLOT_emissive,
     {bits, false}},
    {PHONG("%a"),
     "material: AlgorithmSwitch\nraytracerShader: { material: Lambert, emissive: %a }\n",
     SLOT_emissive,
     {bits, true}},
    {PHONG("{ map: Checker, color1: %a, color2: %b, input: %a }"),
     "defs: { d: %a }\nmaterial: Phong\nemissive: { map: Checker, color1: { ref: d }, color2: %b, "
     "input: { ref: d } "
     "}\n",
     SLOT_emissive,
     {bits, false}},
    {PHONG("{ map: Checker, color1: %a, color2: %b }"),
     "defs: { p: { params: { dark: black }, material: Phong, emissive: { map: Checker, color1: { "
     "param: dark }, "
     "color2: %b } } }\nref: p\ndark: %a\n",
     SLOT_emissive,
     {bits, true}},
    {PHONG("{ map: Checker, color1: { map: Checker, color1: %a, color2: %b }, color2: %b }"),
     "defs: { p: { params: { dark: black }, map: Checker, color1: { param: dark }, color2: %b } "
     "}\nmaterial: Phong\n"
     /* a use of what it is given to, which is no circle */
     "emissive: { ref: p, dark: { ref: p, dark: %a } }\n",
     SLOT_emissive,
     {bits, true}},
    {"material: Mix\nmask: 0.25\na: { material: Mix, mask: 0.25, a: { material: Phong, emissive: "
     "%a }, b: { material: "
     "Phong, "
     "emissive: %b } }\nb: { material: Phong, emissive: %b }\n",
     "defs: { m: { params: { t: { type: material } }, material: Mix, mask: 0.25, a: { param: t }, "
     "b: { material: "
     "Phong, "
     "emissive: %b } } }\nref: m\nt: { ref: m, t: { material: Phong, emissive: %a } }\n",
     SLOT_emissive,
     {bits, true}},
    {"material: RGBA\nr: 0.25\na: 0.75\n",
     "material: Phong\ndiffuse: [0.25, 0.5, 0.5]\ntransparency: 0.25\n",
     SLOT_transparency,
     {bits, true}},
};

static void rules_hold(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof rules / sizeof *rules; i++)
        try_rule(&rules[i], 1000 + i);
    print_message("%zu rules, each of %d random trees\n", sizeof rules / sizeof *rules, TREES);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rules_hold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
