/* Bisection by compute stages under small camera moves: triangles that cannot have changed are
 * not evaluated, and the result equals that of a mesh without history. */
/* ctest: unsanitized */
#include "tests/frame/bisection_body.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Random number in [-1, 1]. */
static double chance(uint32_t *state)
{
    *state = *state * 1664525u + 1013904223u;
    return (double)(*state >> 8) / (1 << 23) - 1;
}

/* Moves by at most `step` along each axis, and turns toward a target that moves as well. */
static void move_by(SceneCamera *camera, double step, double turn, uint32_t *state)
{
    for (int i = 0; i < 3; i++) {
        camera->position[i] += step * chance(state);
        camera->target[i] += turn * chance(state);
    }
    assert_true(scene_camera_aim(camera) == SCENE_AIM_fine);
}

static void assert_fresh_has_them(BisectionBody *b, const uint64_t *leaves, int count)
{
    int fresh_count;
    bisection_body_fresh(b);
    uint64_t *fresh = bisection_body_leaves(b, &fresh_count);
    assert_int_equal(bisection_body_others(fresh, fresh_count, leaves, count), 0);
    free(fresh);
}

/* Many steps, so that the remaining tolerance of triangles matters after several; with movement,
 * with rotation alone, with perspective and parallel rays; with a sun, and with a near lamp. */
static void little_moves_do_not_matter(void **state)
{
    static const struct {
        int body;
        bool parallel;
        double step, turn, lamp[3]; /* a point; of no length: far away */
    } rows[] = {{0, false, .01, 0, {0}},
                {0, false, 0, .02, {0}},
                {1, false, .04, .01, {-1, 1.5, 1}},
                {2, true, .01, .003, {0}},
                {4, false, .01, 0, {0}}};
    enum { VIEWS = 30 };
    const GlContext *gl = ((const BisectionBodies *)*state)->gl;
    /* a GPU evaluates sixteen triangles if one is due, a CPU four */
    const double most = gl->hardware ? 0.9 : 0.6;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        BisectionBody b = bisection_body_begin(*state, "pixels: 0.8, triangles: 9000",
                                               bisection_bodies[rows[i].body]);
        uint32_t random = 1;
        uint64_t *leaves[VIEWS];
        SceneCamera views[VIEWS];
        int counts[VIEWS], looked = 0, changed = 0;
        b.scene->lights[0].kind = rows[i].lamp[0] != 0 ? SCENE_Point : SCENE_Directional;
        memcpy(b.scene->lights[0].position, rows[i].lamp, sizeof rows[i].lamp);
        /* from nearer: merging then leaves free slots */
        bisection_body_look(&b.scene->camera, 1, 8, 1.3);
        free(bisection_body_leaves(&b, &counts[0]));
        bisection_body_look(&b.scene->camera, 1, 8, 2.4);
        if (rows[i].parallel) {
            b.scene->camera.kind = SCENE_Orthographic;
            b.scene->camera.half = 0.7;
        }
        for (int view = 0; view < VIEWS; view++) {
            move_by(&b.scene->camera, rows[i].step, rows[i].turn, &random);
            views[view] = b.scene->camera;
            leaves[view] = bisection_body_leaves(&b, &counts[view]);
            const DisplacedBisectionCost cost = displaced_bisection_cost(&b.displaced);
            looked += view ? cost.looked : 0;
            changed += view ? cost.splits + cost.merges : 0;
        }
        print_message(
            "%zu: %d triangles; in %d views %d bisected or merged, one in %.1f looked at\n", i,
            counts[0], VIEWS - 1, changed, (VIEWS - 1.) * counts[0] / looked);
        assert_true(counts[0] > 1000 && changed > 20 && looked < most * (VIEWS - 1) * counts[0]);
        for (int view = 0; view < VIEWS; view++) {
            b.scene->camera = views[view];
            assert_fresh_has_them(&b, leaves[view], counts[view]);
            free(leaves[view]);
        }
        bisection_body_end(&b);
    }
}

/* Every other input of a view rebuilds everything. */
static void what_else_changes_counts(void **state)
{
    BisectionBody b =
        bisection_body_begin(*state, "pixels: 1.5, triangles: 9000", bisection_bodies[1]);
    int count;
    bisection_body_look(&b.scene->camera, 1, 8, 2.4);
    free(bisection_body_leaves(&b, &count));
    for (int what = 0; what < 4; what++) {
        int before = count;
        b.scene->camera.half *= what == 0 ? .7 : 1;
        b.scene->meshes[b.scene->objects[0].mesh].patches->pixels *= what == 1 ? .7 : 1;
        b.scene->lights[0].kind = what == 2 ? SCENE_Point : b.scene->lights[0].kind;
        b.scene->lights[0].position[2] = what == 2 ? 1.2 : b.scene->lights[0].position[2];
        b.scene->camera.near *= what == 3 ? 40 : 1;
        b.scene->camera.position[0] += 1e-9;
        uint64_t *leaves = bisection_body_leaves(&b, &count);
        assert_true(displaced_bisection_cost(&b.displaced).looked >= before);
        assert_fresh_has_them(&b, leaves, count);
        free(leaves);
    }
    bisection_body_end(&b);
}

/* On a driver with many threads, nine threads compute a height each, and groups continue with
 * the remaining work: the result is the same. */
static void threads_beside_each_other_find_the_same(void **state)
{
    GlContext *gl = ((const BisectionBodies *)*state)->gl;
    BisectionBody b[2];
    for (int wide = 0; wide < 2; wide++) {
        gl->hardware = wide;
        b[wide] = bisection_body_begin(*state, "pixels: 4, triangles: 1500", bisection_bodies[2]);
    }
    for (int view = 0; view < 2; view++) {
        uint64_t *leaves[2];
        int counts[2];
        for (int wide = 0; wide < 2; wide++) {
            gl->hardware = wide;
            bisection_body_look(&b[wide].scene->camera, 1 + view, 8, 1.8 + view);
            leaves[wide] = bisection_body_leaves(&b[wide], &counts[wide]);
        }
        assert_true(counts[0] > 100);
        assert_int_equal(bisection_body_others(leaves[0], counts[0], leaves[1], counts[1]), 0);
        free(leaves[0]), free(leaves[1]);
    }
    gl->hardware = false;
    bisection_body_end(&b[0]), bisection_body_end(&b[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(little_moves_do_not_matter),
        cmocka_unit_test(what_else_changes_counts),
        cmocka_unit_test(threads_beside_each_other_find_the_same),
    };
    return cmocka_run_group_tests(tests, bisection_bodies_open, bisection_bodies_close);
}
