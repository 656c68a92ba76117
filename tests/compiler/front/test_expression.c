/* Formulas against an independent evaluator. Random trees are written as text, with no more
 * brackets than operator precedence needs, and computed here in long double by their
 * mathematical definition. The oracle, and the IR at -O0 and -O2, must agree.
 *
 *   tree  multiply(add(u, 1.25), sin(v))      text  (u + 1.25) * sin(v)
 *
 * The attainable accuracy is measured: the tree is also computed with every node off by a few
 * roundings. A value that jumps between both results, or loses all digits, is skipped; the test
 * bounds the number of skipped values. */
#include "tests/test.h"
#include "tests/sanitized.h"
#include "tests/value/documents.h"
#include "tests/value/evaluate.h"
#include "compiler/oracle/oracle.h"
#include "grammar/expression_tables.h"
#include "tests/formula_rules.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { FORMULAS = 4000 / SANITIZED_STEP, DEPTH = 4, CAPACITY = 1 << 15, LEAVES = 11 };

typedef struct Branch Branch;
struct Branch {
    const struct Rule *rule; /* NULL: a leaf */
    int width;               /* components; CONDITION */
    Branch *part[5];
    char leaf[24];
    Number own[4]; /* of a number */
    int place;     /* of a leaf that is no number; -1 */
};

static unsigned long long state = 88172645463325252ull;
static unsigned draw(unsigned n)
{
    state ^= state << 13, state ^= state >> 7, state ^= state << 17;
    return (unsigned)(state >> 33) % n;
}

static const char *const place_names[LEAVES] = {"u", "v", "x", "y",  "z",   "uv",
                                                "p", "P", "N", "du", "four"};
static const int place_widths[LEAVES] = {1, 1, 1, 1, 1, 2, 3, 3, 3, 3, 4};
static Number places[LEAVES][4];

static Branch *leaf(Arena *arena, int width)
{
    Branch *t = ARENA_NEW(arena, Branch);
    t->width = width;
    t->place = -1;
    for (int tries = 0; tries < 8 && t->place < 0; tries++) {
        const int i = (int)draw(LEAVES);
        if (place_widths[i] == width)
            t->place = i, snprintf(t->leaf, sizeof t->leaf, "%s", place_names[i]);
    }
    if (t->place >= 0)
        return t;
    const int number = (int)draw(4000) + 1;
    snprintf(t->leaf, sizeof t->leaf,
             width == 1   ? "%d.%03d"
             : width == 2 ? "vec2(%d.%03d)"
             : width == 3 ? "vec3(%d.%03d)"
                          : "vec4(%d.%03d)",
             number / 1000, number % 1000);
    for (int i = 0; i < 4; i++)
        t->own[i] = strtold(strpbrk(t->leaf, "0123456789") + (width > 1 ? 2 : 0), NULL);
    for (int i = 0; i < 4; i++)
        t->own[i] = (double)(number / 1000 + number % 1000 / 1000.0);
    return t;
}

static Branch *make(Arena *arena, int width, int depth)
{
    if (depth == 0 && width != CONDITION)
        return leaf(arena, width);
    const Rule *rule;
    do
        rule = &rules[draw(RULES)];
    while (rule->width != width && !(rule->width < 0 && width != CONDITION));
    Branch *t = ARENA_NEW(arena, Branch);
    t->rule = rule;
    t->width = width;
    const int wide =
        /* that one surely has the width; others may be numbers */
        (int)draw((unsigned)strlen(rule->parts));
    for (int i = 0; rule->parts[i]; i++) {
        const char c = rule->parts[i];
        const bool number = i != wide && draw(3) == 0 && !(rule->form[0] == '?');
        const int own = c == 'g'   ? (number ? 1 : width)
                        : c == 'b' ? CONDITION
                        : c == 'n' ? 2 + (int)draw(3)
                                   : c - '0';
        t->part[i] = make(arena, own, depth > 0 ? depth - 1 - (int)draw(2) * (depth > 1) : 0);
    }
    return t;
}

/* Brackets where the level asks for them, and now and then where it does not. */
static void print(Text *out, const Branch *t, int level, bool right)
{
    if (!t->rule) {
        text_put(out, t->leaf);
        return;
    }
    const Rule *r = t->rule;
    const int own = r->level == POSTFIX ? (r->form[0] == '^' ? POWER : 100) : r->level;
    const bool call = r->level == 0;
    bool brackets = !call && (own < level || (own == level && (own == POWER ? !right : right)) ||
                              (own == COMPARE && level == COMPARE));
    brackets |= !call && draw(8) == 0;
    text_put(out, brackets ? "(" : "");
    if (call) {
        text_format(out, "%s(", r->form);
        for (int i = 0; r->parts[i]; i++) {
            text_put(out, i ? ", " : "");
            print(out, t->part[i], CHOOSE - 1, false);
        }
        text_put(out, ")");
    } else if (r->level == CHOOSE) {
        print(out, t->part[0], OR, false);
        text_put(out, " ? ");
        print(out, t->part[1], CHOOSE, false);
        text_put(out, " : ");
        print(out, t->part[2], CHOOSE, false);
    } else if (r->level == PREFIX) {
        text_put(out, r->form);
        print(out, t->part[0], PREFIX, false);
    } else if (r->level == POSTFIX) {
        print(out, t->part[0], own == POWER ? POWER : 100, false);
        text_format(out, own == POWER ? " %s" : "%s", r->form);
    } else {
        print(out, t->part[0], own, false);
        text_format(out, draw(2) ? " %s " : "%s", r->form);
        print(out, t->part[1], own == POWER ? PREFIX : own, true);
    }
    text_put(out, brackets ? ")" : "");
}

/* Numbers are in all components. `off`: how far every node may be off. */
static void compute(const Branch *t, Number off, Number *result)
{
    Number x[5][4] = {{0}};
    if (!t->rule) {
        const Number by = 1 + off * ((int)draw(3) - 1);
        for (int i = 0; i < 4; i++)
            result[i] = by * (t->place < 0 ? t->own[i] : places[t->place][t->width == 1 ? 0 : i]);
        return;
    }
    int components = 1;
    for (int i = 0; t->rule->parts[i]; i++) {
        compute(t->part[i], off, x[i]);
        components = t->part[i]->width > components ? t->part[i]->width : components;
    }
    for (int component = 0; component < 4 && t->rule->component; component++)
        result[component] = t->rule->component((const Number[]){
            x[0][component], x[1][component], x[2][component], x[3][component], x[4][component]});
    if (t->rule->whole)
        t->rule->whole((const Number(*)[4])x, components, result);
    for (int component = 0; component < 4; component++) {
        if (t->width == 1 && t->rule->whole)
            result[component] = result[0];
        if (off != 0 && t->width != CONDITION)
            result[component] *= 1 + off * ((int)draw(3) - 1);
    }
}

static void set_place(Surface *surface, double inputs[INPUT_COUNT][4], int place,
                      const double *value)
{
    static const int groups[] = {
        [5] = GROUP_U, [6] = GROUP_X, [7] = GROUP_P, [8] = GROUP_N, [9] = GROUP_DU};
    static const Input input[] = {
        [5] = INPUT_U, [6] = INPUT_X, [7] = INPUT_P, [8] = INPUT_N, [9] = INPUT_DU};
    for (int i = 0; i < place_widths[place]; i++) {
        surface->root[channel_id((Group)groups[place], i)] = inputs[input[place]][i] = value[i];
        places[place][i] = value[i];
    }
}

/* A point that all three are asked at. */
static void draw_point(Surface *surface, double inputs[INPUT_COUNT][4])
{
    oracle_surface_default(surface);
    memset(inputs, 0, sizeof(double[INPUT_COUNT][4]));
    inputs[INPUT_DV][1] = inputs[INPUT_IOR][0] = inputs[INPUT_front][0] = 1;
    for (int place = 5; place < LEAVES - 1; place++) {
        double value[4];
        for (int i = 0; i < 4; i++)
            value[i] = (draw(100000) - 50000.0) / 25000;
        if (place == 8) {
            const double length =
                sqrt(value[0] * value[0] + value[1] * value[1] + value[2] * value[2]);
            for (int i = 0; i < 3; i++)
                value[i] /= length;
        }
        set_place(surface, inputs, place, value);
    }
    for (int i = 0; i < 5; i++)
        for (int component = 0; component < 4; component++)
            places[i][component] = i < 2 ? places[5][i] : places[6][i - 2];
    for (int component = 0; component < 4; component++)
        places[LEAVES - 1][component] = .25 * (component + 1);
}

/* The conversion table, to three components. */
static void as_color(const Number *own, int width, Number *color)
{
    for (int i = 0; i < 3; i++)
        color[i] = width == 1 ? own[0] : width == 2 && i == 2 ? 0 : own[i];
}

typedef struct {
    int compared, left_out, faults;
} Score;

/* A formula at a point: what it is there, and how far off that may be. */
typedef struct {
    Score *score;
    const char *text;
    Number exact[3], capacity[3];
    Surface surface;
    double inputs[INPUT_COUNT][4];
} Trial;

static void compare(const Trial *t, const char *who, const double *found)
{
    for (int i = 0; i < 3; i++) {
        if (fabsl(t->exact[i] - found[i]) <= t->capacity[i])
            continue;
        t->score->faults++;
        print_error("%s: %s lane %d is %.17g, not %.17Lg\n", t->text, who, i, found[i],
                    t->exact[i]);
        return;
    }
}

static void by_ir(const Trial *t, Document *d)
{
    for (int level = 0; level <= 2; level += 2) {
        Arena arena = {0};
        Session session = {
            .options = &d->options, .arena = &arena, .optimize = level, .check = true};
        Job job;
        choice_job(&(MatcOptions){.pass = "value"}, &job);
        job.slot = SLOT_emissive;
        job.choice[AXIS_aa] = CHOICE_aa_none;
        const Ir *ir = compile_ir(&session, d->graph, d->graph->materials[0].node, &job);
        double result[MAX_OUTPUTS][4];
        assert_non_null(ir);
        ir_eval(ir, &(ReferenceContext){.noise = REFERENCE_LATTICE}, t->inputs, result);
        compare(t, level ? "-O2" : "-O0", result[0]);
        arena_free(&arena);
    }
}

/* The truth, and by how much it moves where every node is off by a few roundings; false: by too
 * much. */
static bool find_truth(Trial *t, const Branch *tree)
{
    enum { TRIALS = 40 };
    Number own[4], off[3];
    rule_unsure = false;
    compute(tree, 0, own);
    as_color(own, tree->width, t->exact);
    bool known = !rule_unsure;
    for (int trial = 0; trial < TRIALS; trial++) {
        compute(tree, 1e-14L, own);
        as_color(own, tree->width, off);
        for (int i = 0; i < 3; i++)
            t->capacity[i] = fmaxl(t->capacity[i], 50 * fabsl(off[i] - t->exact[i]) +
                                                       1e-13L * fmaxl(1, fabsl(t->exact[i])));
    }
    for (int i = 0; i < 3; i++)
        known &=
            t->capacity[i] < 1e-6L * fmaxl(1, fabsl(t->exact[i])) && fabsl(t->exact[i]) < 1e30L;
    t->score->compared += known;
    t->score->left_out += !known;
    return known;
}

static void try_one(Score *s, const Branch *tree, const char *formula)
{
    enum { POINTS = 3 };
    static const char before[] = "material: Phong\nemissive: { map: Expression, is: '",
                      behind[] = "', with: { four: [.25, .5, .75, 1] } }\n";
    Document d;
    char *text = malloc(CAPACITY);
    snprintf(text, CAPACITY, "%s%s%s", before, formula, behind);
    if (!document_open_text(&d, text))
        fail_msg("%s: %s", formula, document_fault(&d));
    ReferenceContext noise = {.noise = REFERENCE_LATTICE};
    Oracle *oracle = oracle_open(d.graph, &noise);
    for (int point = 0; point < POINTS; point++) {
        Trial t = {.score = s, .text = formula};
        SlotValues slots;
        draw_point(&t.surface, t.inputs);
        if (!find_truth(&t, tree))
            continue;
        assert_true(oracle_material(oracle, d.graph->materials[0].node, &t.surface, &slots));
        compare(&t, "oracle", slots.component[SLOT_emissive]);
        by_ir(&t, &d);
    }
    oracle_close(oracle);
    document_close(&d);
    free(text);
}

static void random_formulas_are_what_mathematics_says(void **unused)
{
    (void)unused;
    Score score = {0};
    if (getenv("EXPRESSION_SEED"))
        state += strtoull(getenv("EXPRESSION_SEED"), NULL, 10) * 7919;
    for (int i = 0; i < FORMULAS && score.faults < 8; i++) {
        Arena arena = {0};
        Text text = text_new(&arena);
        const Branch *tree = make(&arena, 1 + (int)draw(4), 1 + (int)draw(DEPTH));
        print(&text, tree, CHOOSE - 1, false);
        if (text.size < CAPACITY / 2)
            try_one(&score, tree, text.at);
        arena_free(&arena);
    }
    print_message("%d values compared, %d left out\n", score.compared, score.left_out);
    assert_int_equal(score.faults, 0);
    assert_true(score.compared > 2 * score.left_out);
}

/* Every function and operator of the table is in a rule above, but noise and cells, which
 * test_function and test_value have. */
static void every_term_is_tried(void **unused)
{
    (void)unused;
    for (int i = 0; i < TERM_COUNT; i++) {
        const char *name = term_symbol((Term)i);
        bool found = term_table[i].noisy || i == TERM_same || i == TERM_choose;
        for (int k = 0; k < RULES && !found; k++)
            found = !strcmp(rules[k].form, name) || !strcmp(rules[k].form, term_table[i].name);
        if (!found)
            fail_msg("%s is in no rule", name);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_term_is_tried),
        cmocka_unit_test(random_formulas_are_what_mathematics_says),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
