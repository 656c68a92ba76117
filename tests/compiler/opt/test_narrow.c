/* opt_function: if the calls of a function use only some of its components, these keep their
 * values. */
/* ctest: quick */
#include "tests/test.h"
#include "compiler/opt/opt.h"
#include "tests/rule_case.h"
#include <stdio.h>

enum { COMPONENTS = 4, MASKS = 1 << COMPONENTS };

/* f(p) = (2 x, 3 y, 5 z, x + 7 y): no two components are alike. */
static int function_of_four(Ir *ir)
{
    static const double factor[] = {2, 3, 5};
    static const double last[] = {1, 7, 0};
    Ref p, components[COMPONENTS];
    ir_arguments(ir, 0, (Type[]){TYPE_vec3}, 1, &p);
    for (int i = 0; i < 3; i++)
        components[i] =
            build_scale(ir, build_swizzle(ir, p, (const char[]){"xyz"[i], 0}), factor[i]);
    components[3] = build_dot(ir, p, ir_const(ir, TYPE_vec3, last));
    return ir_function(ir, &p, 1, build_vec_of(ir, TYPE_vec4, components, COMPONENTS));
}

/* Components of a mask, first to last or last to first, in two bits each. */
static uint32_t components_of(unsigned mask, bool backwards, int *count)
{
    uint32_t components = 0;
    *count = 0;
    for (int i = 0; i < COMPONENTS; i++) {
        const uint32_t component = (uint32_t)(backwards ? COMPONENTS - 1 - i : i);
        if (mask >> component & 1)
            components |= component << 2 * (*count)++;
    }
    return components;
}

/* Calls of f at two points: some components of one, others of the other, each in its own order; all
 * four components of the output have a number. */
static void write_calls(Ir *ir, unsigned one, unsigned other)
{
    static const Input at[] = {INPUT_X, INPUT_P};
    const int f = function_of_four(ir);
    Ref sum = build_all(ir, TYPE_vec4, 0);
    for (int i = 0; i < 2; i++) {
        int count;
        const uint32_t components = components_of(i ? other : one, i, &count);
        Ref read = build_components(ir, build_apply(ir, f, (Ref[]){build_input(ir, at[i])}),
                                    components, count),
            own[COMPONENTS];
        for (int component = 0; component < COMPONENTS;
             component++) /* one component after the other, the last one again */
            own[component] =
                count == 1
                    ? read
                    : build_components(ir, read,
                                       (uint32_t)(component < count ? component : count - 1), 1);
        sum = build_add(ir, sum, build_vec_of(ir, TYPE_vec4, own, COMPONENTS));
    }
    ir_output(ir, OUT_color, 0, sum);
}

/* Components that the live calls return. */
static int components_returned(const Ir *ir)
{
    Arena arena = {0};
    const uint8_t *live = ir_live(ir, &arena);
    int components = 0;
    for (Ref ref = 1; ref < ir->count; ref++)
        if (live[ref] && ir_is(ir, ref, OP_apply))
            components = ir_components(ir, ref) > components ? ir_components(ir, ref) : components;
    arena_free(&arena);
    return components;
}

static void components_that_are_read_keep_their_values(void **state)
{
    (void)state;
    for (unsigned one = 1; one < MASKS; one++)
        for (unsigned other = 1; other < MASKS; other++) {
            Site sites[2];
            char text[64];
            snprintf(text, sizeof text, "lanes %x and %x", one, other);
            for (int i = 0; i < 2; i++) {
                site_open(&sites[i]);
                write_calls(sites[i].ir, one, other);
            }
            const int read = __builtin_popcount(one | other);
            assert_int_equal(opt_function(sites[1].ir), read < COMPONENTS);
            assert_null(ir_check(sites[1].ir));
            assert_int_equal(components_returned(sites[1].ir), read);
            rule_check_values(text, sites[0].ir, sites[1].ir);
            site_close(&sites[0]);
            site_close(&sites[1]);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(components_that_are_read_keep_their_values)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
