/* Threads with stacks of 256 KiB: documents nested to every limit compile, evaluate and print on
 * one (docs/reference/stability.md, Stack). */
/* ctest: unsanitized small-pages seconds=18 */
#include "tests/test.h"
#include "compiler/base/session.h"
#include "tests/growth/growth.h"
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

enum { STACK_KIB = 256, HALF_STACK_KIB = STACK_KIB / 2 };
enum { DEEPEST = LIMIT_GRAPH_DEPTH - 8, NESTED = LIMIT_DEPTH - 8 };

typedef struct {
    const GrowthRow *row;
    int count;
    GrowthRun run;
} Work;

static void *work(void *user)
{
    Work *w = user;
    w->run = growth_run(w->row, w->count);
    return NULL;
}

/* Errors of a row at that count, on a stack of that size: memory of its own before which nothing
 * may be written, since the C library gives a thread the stack of one that has ended, though it be
 * four times as large. */
static int errors_within(const GrowthRow *row, int count, size_t stack_kib)
{
    Work w = {.row = row, .count = count};
    pthread_t thread;
    pthread_attr_t attributes;
    const size_t size = stack_kib * 1024, guard = (size_t)sysconf(_SC_PAGESIZE);
    char *memory =
        mmap(NULL, guard + size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    assert_true(memory != MAP_FAILED);
    assert_int_equal(mprotect(memory, guard, PROT_NONE), 0);
    assert_int_equal(pthread_attr_init(&attributes), 0);
    assert_int_equal(pthread_attr_setstack(&attributes, memory + guard, size), 0);
    assert_int_equal(pthread_create(&thread, &attributes, work, &w), 0);
    assert_int_equal(pthread_join(thread, NULL), 0);
    pthread_attr_destroy(&attributes);
    munmap(memory, guard + size);
    assert_true(w.run.written > 0);
    return w.run.errors;
}

static int errors_of(const GrowthRow *row, int count)
{
    return errors_within(row, count, STACK_KIB);
}

/* Maps of one part, those within others included. */
static int maps_in(const char *part)
{
    int count = 0;
    for (const char *at = part; (at = strstr(at, "map: ")); at++)
        count++;
    return count;
}

/* Every kind of map over itself, with the options that ask more of it than its value. */
static void maps_over_maps(void **state)
{
    (void)state;
    static const char *const parts[] = {
        "{ map: UVTransform, angle: 0.1, scaleU: 1.01, input: @ }",
        "{ map: XYZTransform, transform: { rotation: [0.1, 0.2, 0.3] }, input: @ }",
        "{ map: Turbulence, amount: [0.1, 0.1, 0.1], input: @ }",
        "{ map: Blend, blend: [{ value: 0, input: 0.5 }, { value: 1, input: @ }] }",
        "{ map: Blend, input: @ }",
        "{ map: Checker, color1: @ }",
        "{ map: VolumeChecker, color2: @ }",
        "{ map: ImageMap, image: a.png, input: @ }",
        "{ map: Granite, input: @ }",
        "{ map: VolumeTurbulence, input: @ }",
        "{ map: Gradient, input: @ }",
        "{ map: BumpMap, displacement: 0.5, input: @ }",
        "{ map: BumpMap, displacement: @ }",
        "{ map: WaveMap, uCount: 3, input: @ }",
        "{ map: WaveMap, boxTop: true, input: { map: UVTransform, angle: 0.1, input: @ } }",
        "{ map: BumpMap, displacement: { map: Granite }, input: { map: UVTransform, angle: 0.1, "
        "input: @ } }",
    };
    static const char *const options[] = {"",
                                          "O0",
                                          "validate aa=box",
                                          "aa=aniso",
                                          "derivatives=analytic aa=box",
                                          "coordinates=long",
                                          "eval",
                                          "eval derivatives=analytic",
                                          "precision=exact",
                                          "fit"};
    static const char *const tops[] = {"{ map: Granite, input: @ }",
                                       "!{ map: BumpMap, displacement: @, input: @ }"};
    for (size_t p = 0; p < sizeof parts / sizeof *parts; p++)
        for (size_t o = 0; o < sizeof options / sizeof *options; o++) {
            if ((p + o) % 2)
                /* half of all pairs: each part meets half of the options, each option half of the
                 * parts */
                continue;
            const GrowthRow row = {"",       options[o], 1,  false, true, tops[(p + o) / 2 % 2],
                                   parts[p], "",         "", ""};
            int nested = maps_in(parts[p]) > 1 ? 2 : 1, errors = errors_of(&row, DEEPEST / nested);
            if (errors)
                fail_msg("%s %s: %d errors", parts[p], options[o], errors);
        }
}

/* Deeper is refused, and not tried. */
static void one_more_is_too_deep(void **state)
{
    (void)state;
    const GrowthRow row = {"", "", 1, false, true, "@", "{ map: UVTransform, input: @ }",
                           "", "", ""};
    assert_int_equal(errors_of(&row, LIMIT_GRAPH_DEPTH - 2), 0);
    assert_true(errors_of(&row, LIMIT_GRAPH_DEPTH + 1) > 0);
}

/* Constructs that nest in the text itself. */
static void nested_text(void **state)
{
    (void)state;
    static const GrowthRow rows[] = {
        {"", "validate", 1, false, false, "material: Phong\ndiffuse: ",
         "{ map: UVTransform, input: ", "{ map: Checker }", " }", "\n"},
        {"", "validate", 1, false, false,
         "material: Phong\ndiffuse: ", "{ map: Blend, blend: [{ input: ", "0.5", " }] }", "\n"},
        {"", "", 1, false, false, "material: Phong\ndiffuse: { map: Gradient, waveForm: ",
         "{ wave: Chain, second: Sin, first: ", "Sin", " }", " }\n"},
        {"", "", 1, false, false, "materials: { m: ", "{ material: SideSwitch, frontShader: ",
         "{ material: Phong }", " }", " }\n"},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        assert_int_equal(errors_of(&rows[i], i == 1 ? NESTED / 3 : NESTED), 0);
    static const GrowthRow lists = {
        "", "", 1, false, false, "material: Phong\ndiffuse: ", "[", "", "]", "\n"};
    static const GrowthRow json = {
        "",  "json", 1,   false, false, "{\"material\": \"Phong\", \"diffuse\": ",
        "[", "",     "]", "}\n"};
    assert_true(errors_of(&lists, NESTED) > 0);
    assert_true(errors_of(&lists, 100 * NESTED) > 0);
    assert_true(errors_of(&json, NESTED) > 0);
    assert_true(errors_of(&json, 100 * NESTED) > 0);
}

/* Blends whose items are tried one after the other, over one another: branches within branches. */
static void nested_branches(void **state)
{
    (void)state;
    static const GrowthRow row = {"",
                                  "validate",
                                  1,
                                  false,
                                  true,
                                  "@",
                                  "{ map: Blend, blend: [{ value: { param: low, default: 0.5 }, "
                                  "input: { map: Granite, frequency: 1.$ } }, { value: { param: "
                                  "high, default: 1 }, input: @ }] }",
                                  "",
                                  "",
                                  ""};
    assert_int_equal(errors_of(&row, 600), 0);
}

/* Intervals for --layout=auto: arms of selects within arms, where what is known of a condition is
 * taken to all that follows from it. */
static void intervals_of_arms(void **state)
{
    (void)state;
    static const char *const parts[] = {
        "{ map: Blend, blend: [{ value: 0, input: 0.5 }, { value: 1, input: @ }] }",
        "{ map: Blend, blend: [{ value: 0, input: 0.5 }, { value: 1, input: @ }], input: { map: "
        "Gradient } }",
        "{ map: Blend, blend: [{ value: 0, input: 0.1 }, { value: 0.25, input: 0.9 }, { value: "
        "0.5, input: 0.3 }], "
        "input: @ }",
    };
    static const char top[] = "{ map: Blend, blend: [{ value: 0, input: 0.2 }, { value: 0.5, "
                              "input: @ }], input: { map: Gradient } }";
    for (size_t p = 0; p < sizeof parts / sizeof *parts; p++)
        for (int o = 0; o < 2; o++) {
            const GrowthRow row = {"", o ? "fit O0" : "fit", 1, false, true, top, parts[p], "", "",
                                   ""};
            assert_int_equal(errors_within(&row, DEEPEST / maps_in(parts[p]), HALF_STACK_KIB), 0);
        }
}

/* A formula is no nesting, however long it is or however many brackets are in one another: a flat
 * sum, a product, conditions, choices, functions. */
static void long_formulas(void **state)
{
    (void)state;
    static const struct {
        const char *part, *middle, *close;
    } rows[] = {
        {"u*$ + ", "v", ""},
        {"fract(u*$) - ", "v", ""},
        {"(u + $) * ", "v", ""},
        {"(u + $) / ", "2", ""},
        {"u > .$ && ", "v > .5 ? 1 : 0", ""},
        {"u > .$ || ", "v > .5 ? 1 : 0", ""},
        {"u > .$ ? v : ", "u", ""},
        {"(u + $)^", "1.5", ""},
        {"-", "u", ""},
        {"(", "u", ")"},
        {"sin(", "u", ")"},
        {"max(v, ", "u", ")"},
    };
    static const char *const options[] = {
        "", "O0", "eval", "derivatives=analytic aa=box", "fit", "ir", "precision=exact"};
    enum { TERMS = 3000, MAX_TERMS = 100000 };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (size_t o = i % 2; o < sizeof options / sizeof *options; o += 2)
            for (int bump = 0; bump < 2; bump++) {
                const char *head =
                    bump ? "material: Phong\ninput: { map: BumpMap, displacement: \"= "
                         : "material: Phong\ndiffuse: \"= ";
                const GrowthRow row = {"",
                                       options[o],
                                       1,
                                       false,
                                       false,
                                       head,
                                       rows[i].part,
                                       rows[i].middle,
                                       rows[i].close,
                                       bump ? "\" }\n" : "\"\n"};
                const int errors = errors_of(&row, TERMS);
                if (errors)
                    fail_msg("%s %s: %d errors", rows[i].part, options[o], errors);
            }
    static const GrowthRow longest = {
        "", "", 1, false, false, "material: Phong\ndiffuse: \"= ", "u*$ + ", "v", "", "\"\n"};
    assert_int_equal(errors_of(&longest, MAX_TERMS), 0);
}

/* Definitions that name one another: as long a chain as maps may lie over one another, in either
 * order; longer is refused. */
static void long_chains_of_definitions(void **state)
{
    (void)state;
    static const struct {
        const char *part, *tail;
        int most;
    } rows[] = {
        {"  d$: '= d@ * .5 + .1'\n", "", LIMIT_GRAPH_DEPTH - 1},
        {"  d$: { map: Wood, input: { ref: d@ } }\n", "", LIMIT_GRAPH_DEPTH - 2},
        {"  d$: { ref: d@ }\n", "", LIMIT_REFERENCES - 4},
        {"  d$: { params: { t: 1 }, map: UVTransform, scaleU: { param: t }, input: { ref: d@, t: { "
         "param: t } } }\n",
         ", t: 2", LIMIT_GRAPH_DEPTH / 2},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (int more = 0; more < 2; more++) {
            char *text = NULL;
            size_t size;
            FILE *out = open_memstream(&text, &size);
            const int count = more ? LIMIT_REFERENCES + 1 : rows[i].most;
            fprintf(out, "defs:\n  d0: %s\n",
                    i == 3 ? "{ params: { t: 1 }, map: UVTransform, scaleU: { param: t } }"
                           : "0.5");
            for (int k = 1; k < count; k++)
                for (const char *at = rows[i].part; *at; at++)
                    *at == '$' || *at == '@' ? fprintf(out, "%d", k - (*at == '@'))
                                             : fputc(*at, out);
            fclose(out);
            char tail[80];
            snprintf(tail, sizeof tail, "material: Phong\ndiffuse: { ref: d%d%s }\n", count - 1,
                     rows[i].tail);
            const GrowthRow row = {"", "", 1, false, false, text, "", tail, "", ""};
            const int errors = errors_of(&row, 1);
            if ((errors > 0) != more)
                fail_msg("%s %d: %d errors", rows[i].part, count, errors);
            free(text);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(maps_over_maps),
        cmocka_unit_test(one_more_is_too_deep),
        cmocka_unit_test(nested_text),
        cmocka_unit_test(nested_branches),
        cmocka_unit_test(intervals_of_arms),
        cmocka_unit_test(long_formulas),
        cmocka_unit_test(long_chains_of_definitions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
