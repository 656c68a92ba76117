/* A Blend's costly item, and a Mix's costly side, are computed only where they are visible,
 * anywhere in a tree; a value that is computed in any case has no branch. */
#include "tests/test.h"
#include "compiler/matc.h"
#include "compiler/opt/opt.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORTH_A_BRANCH = 40 };

/* A guard over so many additions; shared: an output needs its value, too. Whether it stays. */
static bool stays(int cost, bool shared)
{
    Arena arena = {0};
    MatcOptions options;
    matc_options_init(&options);
    Session session = {.options = &options, .arena = &arena};
    Graph graph = {0};
    Ir *ir = ir_new(&session, &graph);
    Ref x = build_swizzle(ir, build_input(ir, INPUT_U), "x"),
        y = build_swizzle(ir, build_input(ir, INPUT_U), "y");
    Ref value = x;
    for (int i = 0; i < cost; i++)
        value = build_add(ir, value, build_float(ir, i + 1.5));
    Ref guard = build_guard(ir, build_lt(ir, y, build_float(ir, 0.5)), value);
    Ref sum = build_add(ir, guard, y);
    ir_output(ir, OUT_color, 0, shared ? build_vec(ir, TYPE_vec2, sum, value) : sum);
    assert_true(opt_guard(ir));
    assert_null(ir_check(ir));
    bool found = false;
    const uint8_t *live = ir_live(ir, &arena);
    for (Ref ref = 1; ref < ir->count; ref++) {
        found |= live[ref] && ir_is(ir, ref, OP_select);
        assert_false(live[ref] && build_is_guard(ir, ref));
    }
    ir_done(ir);
    arena_free(&arena);
    return found;
}

static void a_guard_stays_where_it_spares_something(void **state)
{
    (void)state;
    assert_true(stays(WORTH_A_BRANCH, false));
    assert_false(stays(WORTH_A_BRANCH - 1, false));
    assert_false(stays(WORTH_A_BRANCH, true));
    assert_true(stays(100 * WORTH_A_BRANCH, false));
}

/* The fewest braces around a call in main(); -1: there is none. */
static int depth_of(const char *fragment, const char *call)
{
    int depth = 0, least = -1;
    for (const char *at = strstr(fragment, "void main"); *at; at++) {
        depth += (*at == '{') - (*at == '}');
        if (!strncmp(at, call, strlen(call)) && (least < 0 || depth < least))
            least = depth;
    }
    return least;
}

static int depth_in(const char *items, const char *rest, const char *aa)
{
    static char text[2048];
    MatcOptions options;
    matc_options_init(&options);
    options.validate = true;
    assert_true(matc_options_set(&options, "aa", aa));
    snprintf(text, sizeof text,
             "material: Phong\ndiffuse: { map: Blend, input: { map: Gradient, direction: [0, 0, 1] "
             "}, blend: [%s] }\n%s",
             items, rest);
    MatcDocument *document = matc_read("blend.yaml", text, strlen(text), &options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    if (!matc_ok(program))
        fail_msg("%s\n%s%s", text, matc_diagnostics(document, MATC_TEXT),
                 matc_program_diagnostics(program, MATC_TEXT));
    const char *call = strcmp(aa, "none") ? "graniteFiltered(" : "granite(";
    int depth = depth_of(matc_output(program, MATC_FRAGMENT, NULL), call);
    matc_program_free(program);
    matc_document_free(document);
    return depth;
}

static void an_item_branches_wherever_it_stands(void **state)
{
    static const char *const items[] = {
        /* first */
        "{ value: 0, input: &g { map: Granite } }, { value: 0.5, input: red }",
        /* last */
        "{ value: 0, input: red }, { value: 0.5, input: &g { map: Granite } }",
        /* middle */
        "{ value: 0, input: red }, { value: 0.5, input: &g { map: Granite } }, { value: 1, input: "
        "blue }",
        "{ value: 0, input: &g { map: Granite } }, { value: 0.5, input: { map: Wood, input: { map: "
        "Turbulence } } }",
        /* both ends */
        "{ value: 0, input: &g { map: Granite } }, { value: 0.5, input: red }, { value: 1, input: "
        "*g }",
        "{ value: 0, input: red }, { value: 0.2, input: &g { map: Granite } }, { value: 0.6, "
        "input: *g }, { value: 1, "
        "input: red }",
    };
    (void)state;
    /* by the point, by the item's weight in the pixel */
    static const char *const ways[] = {"none", "box", "aniso"};
    for (size_t way = 0; way < sizeof ways / sizeof *ways; way++) {
        for (size_t i = 0; i < sizeof items / sizeof *items; i++)
            assert_int_equal(depth_in(items[i], "", ways[way]), 2);
        for (size_t i = 0; i < sizeof items / sizeof *items; i++)
            assert_int_equal(depth_in(items[i], "specular: *g\n", ways[way]), 1);
        /* it shows everywhere */
        assert_int_equal(
            depth_in("{ value: 0, input: &g { map: Granite } }, { value: 0.5, input: *g }", "",
                     ways[way]),
            1);
    }
}

/* Around calls of a Mix by a mask that is 0, something between, and 1. */
static void expect_depths(const char *sides, int granite, int turbulence)
{
    char text[2048];
    MatcOptions options;
    matc_options_init(&options);
    options.validate = true;
    snprintf(text, sizeof text, "material: MixMaterial\nmask: \"= smoothstep(.4, .6, u)\"\n%s",
             sides);
    MatcDocument *document = matc_read("mix.yaml", text, strlen(text), &options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    if (!matc_ok(program))
        fail_msg("%s\n%s%s", text, matc_diagnostics(document, MATC_TEXT),
                 matc_program_diagnostics(program, MATC_TEXT));
    const char *fragment = matc_output(program, MATC_FRAGMENT, NULL);
    const int found[] = {depth_of(fragment, "granite("), depth_of(fragment, "vectorTurbulence(")};
    if (found[0] != granite || found[1] != turbulence)
        fail_msg("%s\n%s\n%d and %d braces around granite and turbulence", text, fragment, found[0],
                 found[1]);
    assert_int_equal(depth_of(fragment, "if (") > 0, granite > 1 || turbulence > 1);
    matc_program_free(program);
    matc_document_free(document);
}

/* Each side where the mask shows it; one that stands in two slots of its side once. What both sides
 * need, and what is cheap, has no branch. */
static void a_side_of_a_mix_is_computed_where_it_shows(void **state)
{
    (void)state;
#define NOISE "{ map: Wood, input: { map: Turbulence, octaves: 4 } }"
    expect_depths(
        "a: { material: Phong, diffuse: { map: Granite } }\nb: { material: Phong, diffuse: " NOISE
        " }\n",
        2, 2);
    expect_depths("a: { material: Phong, diffuse: &g { map: Granite }, specular: *g }\nb: { "
                  "material: Phong }\n",
                  2, -1);
    expect_depths(
        "a: { material: Phong, diffuse: red }\nb: { material: Principled, baseColor: " NOISE " }\n",
        -1, 2);
    expect_depths("a: { material: Phong, diffuse: &g { map: Granite } }\nb: { material: Phong, "
                  "specular: *g }\n",
                  1, -1);
    expect_depths(
        "a: { material: Phong, diffuse: { map: Checker } }\nb: { material: Phong, diffuse: red }\n",
        -1, -1);
}

/* Transparency of a map by the reflection, and whether a program stores it. */
static void expect_opacity(const char *map, const char *aa, const char *wanted, bool stored)
{
    char text[2048];
    MatcOptions options;
    matc_options_init(&options);
    options.validate = true;
    assert_true(matc_options_set(&options, "aa", aa));
    snprintf(text, sizeof text, "material: Phong\ndiffuse: %s\n", map);
    MatcDocument *document = matc_read("examples/blend.yaml", text, strlen(text), &options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
    if (!matc_ok(program))
        fail_msg("%s\n%s%s", text, matc_diagnostics(document, MATC_TEXT),
                 matc_program_diagnostics(program, MATC_TEXT));
    assert_string_equal(matc_opacity(program), wanted);
    if (!!strstr(matc_output(program, MATC_FRAGMENT, NULL), " transparency = ") != stored)
        fail_msg("%s", matc_output(program, MATC_FRAGMENT, NULL));
    matc_program_free(program);
    matc_document_free(document);
}

#define PICTURE "{ map: ImageMap, image: tiles.png }" /* it has no alpha */

static void opaque_colors_of_checkers_are_opaque_together(void **state)
{
    static const char *const ways[] = {"none", "auto", "box", "aniso"};
    static const struct {
        const char *map;
        bool opaque;
    } maps[] = {
        {"{ map: Checker, color1: " PICTURE ", color2: red }", true},
        {"{ map: Checker, color1: '#ff0000ff', color2: " PICTURE " }", true},
        {"{ map: Checker, color1: " PICTURE ", color2: '#ff0000fe' }", false},
        {"{ map: VolumeChecker, color1: " PICTURE ", color2: { map: Granite } }", true},
        {"{ map: Checker, color1: " PICTURE
         ", color2: { map: VolumeChecker, color1: '#ff0000ff', color2: { map: "
         "Checker, color1: { map: Checker, color1: { map: Checker, color1: { map: Checker, "
         "color1: " PICTURE ", color2: 0.3 } } } } } }",
         true},
        {"{ map: Blend, input: { map: Checker }, blend: [{ value: 0.2, input: " PICTURE
         " }, { value: 0.8, input: { map: Checker, color1: " PICTURE " } }] }",
         true},
    };
    (void)state;
    for (size_t i = 0; i < sizeof ways / sizeof *ways; i++)
        for (size_t k = 0; k < sizeof maps / sizeof *maps; k++)
            expect_opacity(maps[k].map, ways[i], maps[k].opaque ? "opaque" : "varying",
                           !maps[k].opaque);
}

static void expect_opacity_of_items(const char *items, const char *aa, const char *wanted,
                                    bool stored)
{
    char map[1024];
    snprintf(map, sizeof map, "{ map: Blend, input: { map: Granite }, blend: [%s] }", items);
    expect_opacity(map, aa, wanted, stored);
}

static void opaque_items_are_opaque_together(void **state)
{
    static const char *const ways[] = {"none", "auto", "box"};
    static const char picture[] = "{ value: 0, input: " PICTURE " }";
    char items[512];
    (void)state;
    for (int i = 0; i < 3; i++) {
        snprintf(items, sizeof items, "%s, { value: 1, input: red }", picture);
        expect_opacity_of_items(items, ways[i], "opaque", false);
        snprintf(items, sizeof items,
                 "{ value: -1, input: '#ff0000ff' }, %s, { value: 1, input: { map: Blend, blend: "
                 "[%s, { value: 2, "
                 "input: { map: Granite } }] } }",
                 picture, picture);
        expect_opacity_of_items(items, ways[i], "opaque", false);
        snprintf(items, sizeof items, "%s, { value: 1, input: '#ff0000fe' }", picture);
        expect_opacity_of_items(items, ways[i], "varying", true);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_guard_stays_where_it_spares_something),
        cmocka_unit_test(an_item_branches_wherever_it_stands),
        cmocka_unit_test(a_side_of_a_mix_is_computed_where_it_shows),
        cmocka_unit_test(opaque_items_are_opaque_together),
        cmocka_unit_test(opaque_colors_of_checkers_are_opaque_together),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
