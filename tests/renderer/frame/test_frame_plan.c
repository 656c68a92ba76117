/* Frame graphs worked out by hand: which passes run, which targets are allocated, which share
 * memory. For random lists of passes: inputs of a running pass were written before, and no two
 * live targets share memory. Also the renderer's own list. */
#include "tests/test.h"
#include <stdlib.h>
#include <string.h>
#include "runtime/frame_graph/frame.h"
#include "runtime/renderer/passes.h"

enum { X = 1, Y = 2, Z = 4, V = 8 };

static const FramePlanPass chain[] = {
    {"a", 0, X, 0, 0}, {"b", X, Y, 0, 0}, {"c", Y, Z, 0, 0}, {"d", X, V, 0, 0}};
static const FramePlanTarget alike[4] = {{1, {0}}, {1, {0}}, {1, {0}}, {1, {0}}};

static FramePlan plan_of(unsigned allowed, unsigned wanted, const FramePlanTarget *targets)
{
    FramePlan plan;
    frame_plan(&(FramePlanRequest){chain, 4, allowed, wanted, targets, 4}, &plan);
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
    static const FramePlanTarget apart[4] = {{1, {0}}, {1, {0}}, {1, {1}}, {1, {0}}};
    FramePlan plan = plan_of(15, Z, alike);
    assert_int_equal(plan.memory_count, 2);
    assert_int_equal(plan.memory[0][0], plan.memory[2][0]);
    assert_int_not_equal(plan.memory[0][0], plan.memory[1][0]);
    assert_int_equal(plan.memory[3][0], -1);
    plan = plan_of(15, Z, apart); /* z is of another class */
    assert_int_equal(plan.memory_count, 3);
    plan = plan_of(15, Z | X, alike); /* x is read at the end */
    assert_int_equal(plan.memory_count, 3);
}

/* x has textures of classes 0, 1 and 0, y and z one of 1 and two of 0: y is there while x is, z
 * takes two of x. A buffer has no texture. */
static void textures_are_shared(void **state)
{
    (void)state;
    static const FramePlanTarget targets[4] = {{3, {0, 1, 0}}, {1, {1}}, {2, {0, 0}}, {0}};
    const FramePlan plan = plan_of(15, Z, targets);
    assert_int_equal(plan.memory_count, 4);
    assert_int_not_equal(plan.memory[1][0], plan.memory[0][1]);
    assert_int_equal(plan.memory[2][0], plan.memory[0][0]);
    assert_int_equal(plan.memory[2][1], plan.memory[0][2]);
    assert_int_equal(plan.memory[2][2], -1);
    const FramePlan buffer = plan_of(15, V, targets);
    assert_int_equal(buffer.there, X | V);
    assert_int_equal(buffer.memory[3][0], -1);
}

/* A pass that reads only the written pixel of a target may write to the target's memory, if no
 * later pass reads the target. */
static void pixels_are_replaced(void **state)
{
    (void)state;
    FramePlanPass passes[] = {{"a", 0, X, 0, 0}, {"b", X, Y, 0, X}, {"c", Y, Z, 0, Y}};
    const FramePlanRequest request = {passes, 3, 7, Z, alike, 3};
    FramePlan plan;
    frame_plan(&request, &plan);
    assert_int_equal(plan.memory_count, 1);
    passes[1].own = 0; /* the pass reads other pixels: y needs its own memory */
    frame_plan(&request, &plan);
    assert_int_equal(plan.memory_count, 2);
    assert_int_not_equal(plan.memory[0][0], plan.memory[1][0]);
    passes[1].own = X;
    passes[2].reads |= X; /* x is still read later */
    frame_plan(&request, &plan);
    assert_int_equal(plan.memory_count, 2);
    passes[2].reads = Y;
    passes[1].fills = Y | V; /* and x has memory for one of the two */
    frame_plan(&(FramePlanRequest){passes, 3, 7, Z | V, alike, 4}, &plan);
    assert_int_equal(plan.memory_count, 2);
    assert_int_not_equal(plan.memory[1][0], plan.memory[3][0]);
}

/* A pass that modifies a target needs its content; one that overwrites the target does not. */
static void changes_keep(void **state)
{
    (void)state;
    static const FramePlanPass passes[] = {
        {"fill", 0, X, 0, 0}, {"change", Y, 0, X, 0}, {"again", 0, X, 0, 0}, {"show", X, Z, 0, 0}};
    FramePlan plan;
    FramePlanRequest request = {passes, 4, 15, Z, alike, 3};
    frame_plan(&request, &plan);
    assert_int_equal(plan.runs, 8 | 4);
    assert_string_equal(frame_plan_reason(&request, &plan, 1), "nobody needs it");
    request.allowed = 1 | 2 | 8;
    frame_plan(&request, &plan);
    assert_int_equal(plan.runs, 1 | 2 | 8);
    assert_string_equal(frame_plan_reason(&request, &plan, 2), "nothing to do");
    assert_null(frame_plan_reason(&request, &plan, 0));
}

/* Simulated memory: each piece records the texture that wrote last: 8 times the target, plus the
 * texture. */
typedef struct {
    const FramePlanRequest *request;
    const FramePlan *plan;
    int holds[FRAME_PLAN_PIECES];
    unsigned written; /* targets */
} Player;

/* Checks that the written ones of these targets still exist. */
static void check_there(const Player *p, unsigned targets)
{
    for (int t = 0; t < p->request->target_count; t++)
        for (int i = 0; i < p->request->targets[t].count; i++)
            if ((targets & p->written) >> t & 1)
                assert_int_equal(p->holds[p->plan->memory[t][i]], 8 * t + i);
}

static void write_to(Player *p, unsigned targets)
{
    for (int t = 0; t < p->request->target_count; t++)
        for (int i = 0; i < p->request->targets[t].count; i++)
            if (targets >> t & 1) {
                const int piece = p->plan->memory[t][i];
                assert_int_equal(p->plan->memory_class[piece], p->request->targets[t].classes[i]);
                p->holds[piece] = 8 * t + i;
            }
    p->written |= targets;
}

/* Inputs of a pass must exist when it begins; inputs read at other pixels, and outputs, when it
 * ends. */
static void play(const FramePlanRequest *r, const FramePlan *plan)
{
    Player player = {.request = r, .plan = plan};
    memset(player.holds, -1, sizeof player.holds);
    for (int i = 0; i < r->pass_count; i++) {
        const FramePlanPass *pass = &r->passes[i];
        if (!(plan->runs >> i & 1))
            continue;
        check_there(&player, pass->reads | pass->changes);
        write_to(&player, pass->fills | pass->changes);
        check_there(&player, (pass->reads & ~pass->own) | pass->fills | pass->changes);
    }
    check_there(&player, r->wanted);
}

static void random_plans(void **state)
{
    (void)state;
    srand(1);
    for (int round = 0; round < 20000; round++) {
        FramePlanPass passes[8];
        FramePlanTarget targets[6];
        for (int i = 0; i < 8; i++) {
            const unsigned fills = (unsigned)rand() & (unsigned)rand() & 63,
                           changes = (unsigned)rand() & (unsigned)rand() & 63;
            const unsigned reads = (unsigned)rand() & (unsigned)rand() & 63 & ~fills;
            passes[i] =
                (FramePlanPass){"p", reads, fills, changes & ~fills, reads & (unsigned)rand()};
        }
        for (int i = 0; i < 6; i++)
            targets[i] = (FramePlanTarget){rand() % 4, {rand() % 2, rand() % 2, rand() % 2}};
        const FramePlanRequest request = {passes,  8, (unsigned)rand() & 255, (unsigned)rand() & 63,
                                          targets, 6};
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
        while (i < frame_pass_count() && strcmp(frame_pass(i)->plan.name, *names) != 0)
            i++;
        assert_true(i < frame_pass_count());
        passes |= 1u << i;
    }
    return passes;
}
#define PASSES(...) passes_of((const char *const[]){__VA_ARGS__, NULL})

/* The plan of a scene in which these passes have work. A layer has the G-buffer's textures; all
 * other formats differ. */
static FramePlan plan_of_frame(unsigned allowed, FrameTarget wanted)
{
    FramePlanPass rows[FRAME_PLAN_MAX];
    FramePlanTarget targets[FRAME_TARGET_COUNT];
    FramePlan plan;
    for (int i = 0; i < frame_pass_count(); i++)
        rows[i] = frame_pass(i)->plan;
    for (int i = 0; i < FRAME_TARGET_COUNT; i++)
        targets[i] = (FramePlanTarget){1, {i == FRAME_TARGET_layer ? FRAME_TARGET_gbuffer : i}};
    frame_plan(&(FramePlanRequest){rows, frame_pass_count(), allowed, 1u << wanted, targets,
                                   FRAME_TARGET_COUNT},
               &plan);
    return plan;
}

static void rows_of_glass_shadows_and_edges(void **state)
{
    (void)state;
    const unsigned lit = PASSES("surface", "shadow", "light", "lists", "blend");
    const unsigned shown = lit | PASSES("edge", "tone");
    const unsigned peeled = PASSES("surface", "light", "peel", "tone");
    assert_int_equal(plan_of_frame(shown, FRAME_TARGET_final).runs, shown);
    assert_int_equal(plan_of_frame(shown, FRAME_TARGET_light).runs, lit); /* no edge without tone */
    assert_int_equal(plan_of_frame(shown, FRAME_TARGET_gbuffer).runs, PASSES("surface"));
    assert_int_equal(plan_of_frame(shown, FRAME_TARGET_depth).runs, PASSES("surface"));
    const unsigned many = shown | PASSES("light_cluster");
    assert_int_equal(plan_of_frame(many, FRAME_TARGET_final).runs, many);
    assert_int_equal(plan_of_frame(many, FRAME_TARGET_depth).runs, PASSES("surface"));
    assert_int_equal(plan_of_frame(shown & ~PASSES("blend"), FRAME_TARGET_final).runs,
                     shown & ~PASSES("blend", "lists")); /* nobody reads the lists */
    const FramePlan plan = plan_of_frame(peeled, FRAME_TARGET_final);
    assert_int_equal(plan.runs, peeled);
    assert_int_equal(plan.memory[FRAME_TARGET_layer][0], plan.memory[FRAME_TARGET_gbuffer][0]);
    assert_true(plan.there >> FRAME_TARGET_layer_keys & 1);
    assert_false(plan.there >> FRAME_TARGET_lists & 1);
    assert_false(plan_of_frame(shown, FRAME_TARGET_final).there >> FRAME_TARGET_layer & 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(only_what_is_needed),
                                       cmocka_unit_test(memory_is_shared),
                                       cmocka_unit_test(textures_are_shared),
                                       cmocka_unit_test(pixels_are_replaced),
                                       cmocka_unit_test(changes_keep),
                                       cmocka_unit_test(random_plans),
                                       cmocka_unit_test(rows_of_glass_shadows_and_edges)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
