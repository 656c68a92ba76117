/* Plans of frames, worked out by hand: which passes run, which targets there are, which share memory. And of random lists of passes: what runs
 * finds what it reads, and no two that live at once share. And of the renderer's own list. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include "runtime/render/frame.h"

enum { X = 1, Y = 2, Z = 4, V = 8 };

static const FramePlanPass chain[] = {{"a", 0, X, 0}, {"b", X, Y, 0}, {"c", Y, Z, 0}, {"d", X, V, 0}};
static const int alike[4];

static FramePlan plan_of(unsigned allowed, unsigned wanted, const int *classes)
{
    FramePlan plan;
    frame_plan(&(FramePlanRequest){chain, 4, allowed, wanted, 4, classes}, &plan);
    return plan;
}

static void only_what_is_needed(void **state)
{
    (void)state;
    assert_int_equal(plan_of(15, Z, alike).runs, 7);
    assert_int_equal(plan_of(15, Z, alike).there, X | Y | Z);
    assert_int_equal(plan_of(15, V, alike).runs, 9);
    assert_int_equal(plan_of(15, X, alike).runs, 1);
    assert_int_equal(plan_of(15, Z | V, alike).runs, 15);
    assert_int_equal(plan_of(15, 0, alike).runs, 0);
    assert_int_equal(plan_of(15, 0, alike).memory_count, 0);
}

static void memory_is_shared(void **state)
{
    (void)state;
    static const int apart[4] = {0, 0, 1, 0};
    FramePlan plan = plan_of(15, Z, alike);
    assert_int_equal(plan.memory_count, 2);
    assert_int_equal(plan.memory[0], plan.memory[2]);
    assert_int_not_equal(plan.memory[0], plan.memory[1]);
    assert_int_equal(plan.memory[3], -1);
    plan = plan_of(15, Z, apart); /* z is of another class */
    assert_int_equal(plan.memory_count, 3);
    plan = plan_of(15, Z | X, alike); /* x is read at the end */
    assert_int_equal(plan.memory_count, 3);
}

/* A pass that changes a target needs what was there; one that fills it does not. */
static void changes_keep(void **state)
{
    (void)state;
    static const FramePlanPass passes[] = {
        {"fill", 0, X, 0}, {"change", Y, 0, X}, {"again", 0, X, 0}, {"show", X, Z, 0}};
    FramePlan plan;
    FramePlanRequest request = {passes, 4, 15, Z, 3, alike};
    frame_plan(&request, &plan);
    assert_int_equal(plan.runs, 8 | 4);
    assert_string_equal(frame_plan_reason(&request, &plan, 1), "nobody needs it");
    request.allowed = 1 | 2 | 8;
    frame_plan(&request, &plan);
    assert_int_equal(plan.runs, 1 | 2 | 8);
    assert_string_equal(frame_plan_reason(&request, &plan, 2), "nothing to do");
    assert_null(frame_plan_reason(&request, &plan, 0));
}

/* Plays the plan: every piece of memory knows which target wrote to it last. */
static void play(const FramePlanRequest *r, const FramePlan *plan)
{
    int holds[FRAME_PLAN_MOST];
    unsigned written = 0;
    memset(holds, -1, sizeof holds);
    for (int i = 0; i < r->pass_count; i++) {
        if (!(plan->runs >> i & 1))
            continue;
        const FramePlanPass *pass = &r->passes[i];
        for (int t = 0; t < r->target_count; t++) {
            if (pass->reads >> t & 1 && written >> t & 1)
                assert_int_equal(holds[plan->memory[t]], t);
            if (pass->changes >> t & 1 && written >> t & 1)
                assert_int_equal(holds[plan->memory[t]], t);
        }
        for (int t = 0; t < r->target_count; t++)
            if ((pass->fills | pass->changes) >> t & 1) {
                holds[plan->memory[t]] = t;
                written |= 1u << t;
            }
        /* both sides of a pass are there at once */
        for (int t = 0; t < r->target_count; t++)
            if (pass->reads >> t & 1 && !((pass->fills | pass->changes) >> t & 1) && written >> t & 1)
                assert_int_equal(holds[plan->memory[t]], t);
    }
    for (int t = 0; t < r->target_count; t++)
        if (r->wanted >> t & 1 && written >> t & 1)
            assert_int_equal(holds[plan->memory[t]], t);
}

static void random_plans(void **state)
{
    (void)state;
    srand(1);
    for (int round = 0; round < 20000; round++) {
        FramePlanPass passes[8];
        int classes[6];
        for (int i = 0; i < 8; i++) {
            const unsigned fills = (unsigned)rand() & (unsigned)rand() & 63,
                           changes = (unsigned)rand() & (unsigned)rand() & 63;
            passes[i] =
                (FramePlanPass){"p", (unsigned)rand() & (unsigned)rand() & 63 & ~fills, fills, changes & ~fills};
        }
        for (int i = 0; i < 6; i++)
            classes[i] = rand() % 2;
        const FramePlanRequest request = {passes, 8, (unsigned)rand() & 255, (unsigned)rand() & 63, 6, classes};
        FramePlan plan;
        frame_plan(&request, &plan);
        assert_int_equal(plan.runs & ~request.allowed, 0);
        play(&request, &plan);
    }
}

/* -- the renderer's own rows */

/* The passes of these names, as a set; the names end with NULL. */
static unsigned passes_of(const char *const *names)
{
    unsigned passes = 0;
    for (; *names; names++) {
        int i = 0;
        while (i < frame_pass_count() && strcmp(frame_passes[i].plan.name, *names) != 0)
            i++;
        assert_true(i < frame_pass_count());
        passes |= 1u << i;
    }
    return passes;
}
#define PASSES(...) passes_of((const char *const[]){__VA_ARGS__, NULL})

/* The plan of a scene for which these passes have something to do. A layer has the G-buffer's textures, no two others are alike. */
static FramePlan plan_of_frame(unsigned allowed, FrameTarget wanted)
{
    FramePlanPass rows[FRAME_PLAN_MOST];
    int classes[FRAME_TARGET_COUNT];
    FramePlan plan;
    for (int i = 0; i < frame_pass_count(); i++)
        rows[i] = frame_passes[i].plan;
    for (int i = 0; i < FRAME_TARGET_COUNT; i++)
        classes[i] = i == FRAME_TARGET_layer ? FRAME_TARGET_gbuffer : i;
    frame_plan(&(FramePlanRequest){rows, frame_pass_count(), allowed, 1u << wanted, FRAME_TARGET_COUNT, classes},
               &plan);
    return plan;
}

static void rows_of_glass_shadows_and_edges(void **state)
{
    (void)state;
    const unsigned lit = PASSES("surface", "shadow", "light", "lists", "blend");
    const unsigned shown = lit | PASSES("edge", "tone");
    const unsigned peeled = PASSES("surface", "light", "peel", "tone");
    assert_int_equal(plan_of_frame(shown, FRAME_TARGET_shown).runs, shown);
    assert_int_equal(plan_of_frame(shown, FRAME_TARGET_light).runs, lit); /* no edge without tone */
    assert_int_equal(plan_of_frame(shown, FRAME_TARGET_gbuffer).runs, PASSES("surface"));
    assert_int_equal(plan_of_frame(shown, FRAME_TARGET_depth).runs, PASSES("surface"));
    const unsigned many = shown | PASSES("gather");
    assert_int_equal(plan_of_frame(many, FRAME_TARGET_shown).runs, many);
    assert_int_equal(plan_of_frame(many, FRAME_TARGET_depth).runs, PASSES("surface"));
    assert_int_equal(plan_of_frame(shown & ~PASSES("blend"), FRAME_TARGET_shown).runs,
                     shown & ~PASSES("blend", "lists")); /* nobody reads the lists */
    const FramePlan plan = plan_of_frame(peeled, FRAME_TARGET_shown);
    assert_int_equal(plan.runs, peeled);
    assert_int_equal(plan.memory[FRAME_TARGET_layer], plan.memory[FRAME_TARGET_gbuffer]);
    assert_true(plan.there >> FRAME_TARGET_layer_keys & 1);
    assert_false(plan.there >> FRAME_TARGET_lists & 1);
    assert_false(plan_of_frame(shown, FRAME_TARGET_shown).there >> FRAME_TARGET_layer & 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(only_what_is_needed), cmocka_unit_test(memory_is_shared),
                                       cmocka_unit_test(changes_keep), cmocka_unit_test(random_plans),
                                       cmocka_unit_test(rows_of_glass_shadows_and_edges)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
