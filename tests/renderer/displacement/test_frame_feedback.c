/* Meshes subdivided by transform feedback, drawn under OSMesa: the triangle count that the
 * criterion gives in double; the points of a uniform subdivision where no edge is too long;
 * gaps, which each kind of skirts hides; fewer skirt triangles one step before the last. */
/* ctest: seconds=10 */
#include "tests/frame/frame_compare.h"
#include "tests/frame/displaced_bodies.h"
#include "tests/frame/frame_draw.h"
#include "runtime/frame_graph/frame.h"
#include "runtime/scene/scene_patches.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef enum {
    SKIRTS_none,
    SKIRTS_copy,
    SKIRTS_all,
    SKIRTS_borders,
    SKIRTS_early,
    SKIRTS_COUNT
} Skirts;
static const char *const names[SKIRTS_COUNT] = {"none", "copy", "all", "borders", "early"};

static const Shape *shape_of(const Scene *scene)
{
    return &scene->meshes[scene->objects[0].mesh].shape;
}

/* -- the criterion in double */

typedef struct {
    double eye[3], near, detail;
    int steps;
    Skirts skirts;
} Criterion;

static double length_of(const double a[3], const double b[3])
{
    return sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                (a[2] - b[2]) * (a[2] - b[2]));
}

/* Number of triangles that one becomes, skirts included, after `step` subdivisions. */
static long divided(const Criterion *c, double (*p)[3], int step)
{
    double middle[3], middles[3][3];
    if (step == c->steps)
        return 1;
    for (int i = 0; i < 3; i++)
        middle[i] = (p[0][i] + p[1][i] + p[2][i]) / 3;
    const double ab = length_of(p[0], p[1]), bc = length_of(p[1], p[2]), ca = length_of(p[2], p[0]),
                 s = (ab + bc + ca) / 2, area = sqrt(s * (s - ab) * (s - bc) * (s - ca)),
                 d = length_of(middle, c->eye);
    const bool early =
        c->skirts == SKIRTS_early && d - c->near >= c->detail * area / 4 && step + 1 < c->steps;
    if (d - c->near >= c->detail * area)
        return c->skirts == SKIRTS_all ||
                       (c->skirts >= SKIRTS_borders &&
                        fabs(d - c->near - c->detail * area) < area / 2 + c->near)
                   ? 7
                   : 1;
    if (early)
        return fabs(d - c->near - c->detail * area / 4) < area / 8 + c->near ? 16 : 4;
    if (c->skirts == SKIRTS_all && step + 1 == c->steps)
        return 16;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++)
            middles[k][i] = (p[k][i] + p[(k + 1) % 3][i]) / 2;
    long sum = divided(c, middles, step + 1);
    for (int k = 0; k < 3; k++) {
        double part[3][3];
        memcpy(part[0], p[k], sizeof part[0]);
        memcpy(part[1], middles[k], sizeof part[1]);
        memcpy(part[2], middles[(k + 2) % 3], sizeof part[2]);
        sum += divided(c, part, step + 1);
    }
    return sum;
}

/* Triangles of the square, whose corners are 1 from its center. */
static long divided_square(const Criterion *c)
{
    static const double corners[4][3] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
    long sum = c->skirts == SKIRTS_copy ? 2 : 0;
    for (int t = 0; t < 2; t++) {
        double p[3][3];
        for (int k = 0; k < 3; k++)
            memcpy(p[k], corners[k ? (k + t) % 4 : 0], sizeof p[k]);
        sum += divided(c, p, 0);
    }
    return sum;
}

static void triangles_are_those_of_the_criterion(void **state)
{
    (void)state;
    GlContext *gl = frame_context();
    long of[2][SKIRTS_COUNT];
    for (int i = 0; i < 2 * SKIRTS_COUNT; i++) {
        char how[160];
        MatcDocument *document;
        /* The camera of displaced_body, which is 2.4 to 4.9 away: borders at 2.6, 2.9 and 4.1, all
         * of which are near each other; and one at 4.02. */
        const bool first = i < SKIRTS_COUNT;
        const Criterion c = {{1, -3, 2},
                             first ? 2.5 : .5,
                             first ? 200.31 : 450.31,
                             first ? 7 : 6,
                             (Skirts)(i % SKIRTS_COUNT)};
        snprintf(how, sizeof how, "method: feedback, near: %g, detail: %g, steps: %d, skirts: %s",
                 c.near, c.detail, c.steps, names[c.skirts]);
        Scene *scene = displaced_drawn(gl, 3, how, &document);
        const long wanted = divided_square(&c);
        of[i / SKIRTS_COUNT][c.skirts] = shape_of(scene)->index_count / 3;
        print_message("%s: %ld triangles, %ld by the criterion\n", how,
                      of[i / SKIRTS_COUNT][c.skirts], wanted);
        assert_int_equal(of[i / SKIRTS_COUNT][c.skirts], wanted);
        frame_forget(scene, document);
    }
    assert_true(of[1][SKIRTS_none] < of[1][SKIRTS_borders] &&
                of[1][SKIRTS_borders] < of[1][SKIRTS_all]);
    assert_true(of[0][SKIRTS_early] < .6 * of[0][SKIRTS_borders] &&
                of[1][SKIRTS_early] < .9 * of[1][SKIRTS_borders]);
    gl_close(gl);
}

/* With all triangles near: the points of 2^3 segments; and closed, on a box with hard edges. */
static void all_near_is_an_even_division(void **state)
{
    (void)state;
    GlContext *gl = frame_context();
    MatcDocument *documents[2];
    Scene *scenes[2] = {
        displaced_drawn(gl, 0, "method: mesh, level: 8", &documents[0]),
        displaced_drawn(gl, 0, "method: feedback, near: 1e9, steps: 3", &documents[1])};
    const Shape *shape = shape_of(scenes[1]);
    double worst = 0;
    for (int i = 0; i < shape->vertex_count; i++)
        worst = fmax(worst, displaced_nearest(shape_of(scenes[0]), shape->vertices[i].position,
                                              shape->base[i]));
    print_message("%d triangles, off by %.2g\n", shape->index_count / 3, worst);
    assert_true(shape->index_count == 3 * 12 * 64 && worst < 1e-6 &&
                shape_body(shape) != SHAPE_BODY_none);
    for (int i = 0; i < 2; i++)
        frame_forget(scenes[i], documents[i]);
    gl_close(gl);
}

/* Skirts of a ball, whose triangles differ in area, and of the square. */
static void skirts_hide_gaps(void **state)
{
    (void)state;
    static const int shown[] = {1, 3};
    GlContext *gl = frame_context();
    for (int i = 0; i < SKIRTS_COUNT; i++) {
        long within = 0;
        char how[120];
        snprintf(how, sizeof how, "method: feedback, near: 0.8, detail: 60, steps: 5, skirts: %s",
                 names[i]);
        const int count = displaced_holes_of(gl, shown, how, &within);
        print_message("skirts: %s: %d holes in %ld pixels\n", names[i], count, within);
        assert_true(within > 9000 && (i == SKIRTS_none   ? count > 3
                                      : i == SKIRTS_copy ? count < 5
                                                         : count == 0));
    }
    gl_close(gl);
}

static int triangles_from(Renderer *renderer, Scene *scene, const double eye[3],
                          const double target[3])
{
    memcpy(scene->camera.position, eye, sizeof scene->camera.position);
    memcpy(scene->camera.target, target, sizeof scene->camera.target);
    assert_true(scene_camera_aim(&scene->camera) == SCENE_AIM_fine &&
                renderer_changed(renderer, RENDERER_CAMERA) && renderer_frame(renderer));
    return (int)renderer->gpu_scene.triangles;
}

/* Rotation of the camera leaves the number of triangles unchanged; from another position there
 * are as many as the criterion gives. */
static void a_turn_leaves_triangles_alone(void **state)
{
    (void)state;
    static const double eyes[2][3] = {{1, -3, 2}, {.2, -2.2, 1.7}},
                        targets[3][3] = {{0, 0, 0}, {.9, .4, -.3}, {3, -9, 2}};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    MatcDocument *document;
    Scene *scene =
        displaced_body(3, "method: feedback, near: 0.5, detail: 450.31, steps: 6, skirts: none",
                       &options, &document);
    Renderer *renderer =
        renderer_open(gl, &(RendererOptions){.compile = &options, .view = "light"});
    long wanted[2];
    assert_true(renderer && renderer_set_scene(renderer, scene));
    for (int i = 0; i < 6; i++) {
        Criterion c = {.near = .5, .detail = 450.31, .steps = 6, .skirts = SKIRTS_none};
        memcpy(c.eye, eyes[i / 3], sizeof c.eye);
        wanted[i / 3] = divided_square(&c);
        assert_int_equal(triangles_from(renderer, scene, eyes[i / 3], targets[i % 3]),
                         wanted[i / 3]);
    }
    print_message("%ld triangles, and %ld from nearer, however the camera is turned\n", wanted[0],
                  wanted[1]);
    assert_true(wanted[0] < wanted[1]);
    renderer_close(renderer);
    frame_forget(scene, document);
    gl_close(gl);
}

/* 2 times 4^4. */
static void steps_go_by_triangles(void **state)
{
    (void)state;
    GlContext *gl = frame_context();
    MatcDocument *document;
    Scene *scene = displaced_drawn(gl, 3, "method: feedback, near: 1e9, triangles: 600", &document);
    assert_int_equal(shape_of(scene)->index_count / 3, 512);
    frame_forget(scene, document);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(triangles_are_those_of_the_criterion),
        cmocka_unit_test(all_near_is_an_even_division),
        cmocka_unit_test(skirts_hide_gaps),
        cmocka_unit_test(a_turn_leaves_triangles_alone),
        cmocka_unit_test(steps_go_by_triangles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
