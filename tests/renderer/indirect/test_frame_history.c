/* Temporal accumulation: means over sets of rays, under a moving camera or object, and after the
 * motion stops. */
/* ctest: unsanitized */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/frame_running.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EDGE = 48, PIXELS = EDGE * EDGE, TEXT = 2048, SPHERE = 2 };

/* A floor in front of a wall, with a ball between them and the camera. */
static const char room[] =
    "image: { width: 48, height: 48 }\ncamera: { camera: Perspective, position: [.4, -4, 1.6], "
    "target: [0, 0, .7], "
    "angle: 40 }\nvoxels: { size: 64 }\n"
    "materials: { m: { material: Phong, diffuse: .6, specular: 0 } }\nlights: [{ light: Point, "
    "position: [1, -2, 3], "
    "intensity: 9, shadows: none }]\nobjects:\n"
    "- { object: Box, material: m, size: [3, 3, .2], transform: { translation: [0, 0, -.1] } }\n"
    "- { object: Box, material: m, size: [3, .2, 2], transform: { translation: [0, .7, 1] } }\n"
    "- { object: Sphere, radius: .3, detail: 24, material: m, transform: { translation: [-.2, -.6, "
    ".6] } }\n";

static GlContext *gl; /* one context for all draws */

static void open_rig(FrameRunning *rig, const char *keys, const char *view)
{
    char text[TEXT];
    snprintf(text, sizeof text, "indirect: { radius: 1, %s }\n%s", keys, room);
    frame_running_open(gl, text, &(RendererOptions){.view = view, .deep = true}, rig);
}

/* Draws one frame. */
static void draw_alone(const char *keys, const char *view, float *rgba)
{
    static FrameRunning rig;
    open_rig(&rig, keys, view);
    memcpy(rgba, frame_running_draw(&rig), 4 * PIXELS * sizeof *rgba);
    frame_running_close(&rig);
}

static double apart(const float *a, const float *b)
{
    double sum = 0;
    for (int i = 0; i < PIXELS; i++)
        sum += ((double)a[4 * i] - (double)b[4 * i]) * ((double)a[4 * i] - (double)b[4 * i]);
    return sqrt(sum / PIXELS);
}

static FrameRunning one;
static float all[4 * PIXELS], some[4 * PIXELS], single[4 * PIXELS];

/* n sets are at least as exact as n times as many random rays; n accumulated frames equal n
 * sets; and then no more rays are traced. */
static void sets_are_averaged(void **state)
{
    (void)state;
    static const char *const views[] = {"ao", "indirect"};
    for (int i = 0; i < 2; i++) {
        draw_alone("filter: none, samples: 160", views[i], all);
        draw_alone("filter: none, samples: 16", views[i], some);
        draw_alone("filter: none", views[i], single);
        const double off = apart(some, all), first = apart(single, all);
        print_message("%s of 8 rays is %.4f off, of 16 sets of them %.4f\n", views[i], first, off);
        assert_true(first > .004 && off < .55 / 4 * first);
        open_rig(&one, "filter: none, history: 16", views[i]);
        for (int k = 0; k < 16; k++)
            frame_running_draw(&one);
        assert_true(apart(one.rgba, some) < 1e-6);
        memcpy(single, one.rgba, sizeof single);
        assert_memory_equal(frame_running_draw(&one), single, sizeof single);
        frame_running_close(&one);
    }
}

/* The number of sets is the smallest power of two that reaches the stated error. */
static void errors_are_as_stated(void **state)
{
    (void)state;
    static const double errors[] = {.02, .01};
    draw_alone("filter: none, samples: 160", "ao", all);
    for (int i = 0; i < 2; i++) {
        char keys[TEXT / 16];
        int sets = 2;
        snprintf(keys, sizeof keys, "filter: none, samples: 64, error: %g", errors[i]);
        draw_alone(keys, "ao", some);
        const double off = apart(some, all);
        for (; sets < 64; sets *= 2) {
            snprintf(keys, sizeof keys, "filter: none, samples: %d", sets);
            draw_alone(keys, "ao", single);
            if (!memcmp(single, some, sizeof single))
                break;
        }
        print_message("stated to be %.3f off, it is %.4f, with %d sets\n", errors[i], off, sets);
        assert_true(sets < 64 && off < .72 * errors[i] && off > errors[i] / 2);
    }
}

/* Steps of a camera that circles and approaches. */
static void turn(FrameRunning *rig, int step)
{
    SceneCamera *camera = &rig->scene->camera;
    const double angle = .012 * step, far = 4 - .01 * step;
    camera->position[0] = .4 + far * sin(angle);
    camera->position[1] = -far * cos(angle);
    assert_true(renderer_changed(rig->renderer, RENDERER_CAMERA));
}

/* Under camera motion the accumulated result is nearer to the truth than a single frame, and
 * varies less from frame to frame. */
static void paths_are_calmer(void **state)
{
    (void)state;
    static const char *const keys[] = {"filter: none, samples: 48", "filter: none",
                                       "filter: none, history: 16"};
    static float frames[3][4 * PIXELS];
    static FrameRunning rigs[3];
    double off[3] = {0};
    enum { STEPS = 12, SKIPPED = 4 };
    for (int i = 0; i < 3; i++)
        open_rig(&rigs[i], keys[i], "ao");
    for (int step = 0; step < STEPS; step++)
        for (int i = 0; i < 3; i++) {
            turn(&rigs[i], step);
            if (i || step >= SKIPPED)
                memcpy(frames[i], frame_running_draw(&rigs[i]), sizeof frames[i]);
            if (step >= SKIPPED)
                off[i] += apart(frames[i], frames[0]) / (STEPS - SKIPPED);
        }
    print_message("a moving camera: %.4f off by each frame alone, %.4f with 16 kept\n", off[1],
                  off[2]);
    assert_true(off[2] < .28 * off[1]);
    for (int i = 0; i < 3; i++)
        frame_running_close(&rigs[i]);
}

/* A ball jumps aside. The surface that it hid has no history except the denoised neighborhood;
 * in the next frame little of the ball's ambient occlusion remains, which was off by .3. */
static void nothing_is_left_behind_what_moves(void **state)
{
    (void)state;
    static const char *const keys[] = {"samples: 64", "samples: 1", "history: 12"};
    static FrameRunning rigs[3];
    static bool covered[PIXELS];
    double off[3] = {0}, most = 0, bare = 0;
    int count = 0;
    for (int i = 0; i < 3; i++) {
        open_rig(&rigs[i], keys[i], "ao");
        for (int k = 0; k < (i == 2 ? 12 : 1); k++)
            frame_running_draw(&rigs[i]);
    }
    static FrameRunning depth;
    open_rig(&depth, "samples: 1", "depth");
    memcpy(some, frame_running_draw(&depth), sizeof some);
    depth.scene->objects[SPHERE].world_from_local.m[12] += .9;
    assert_true(renderer_changed_objects(depth.renderer, SPHERE, 1));
    frame_running_draw(&depth);
    for (int p = 0; p < PIXELS; p++)
        covered[p] = some[4 * p] > depth.rgba[4 * p] * 1.02f;
    frame_running_close(&depth);
    for (int i = 0; i < 3; i++) {
        rigs[i].scene->objects[SPHERE].world_from_local.m[12] += .9;
        assert_true(renderer_changed_objects(rigs[i].renderer, SPHERE, 1));
        frame_running_draw(&rigs[i]);
        off[i] = apart(rigs[i].rgba, rigs[0].rgba);
    }
    for (int p = 0; p < PIXELS; p++)
        if (covered[p]) {
            count++;
            most = fmax(most, fabs((double)rigs[2].rgba[4 * p] - (double)rigs[0].rgba[4 * p]));
            bare = fmax(bare, fabs((double)rigs[1].rgba[4 * p] - (double)rigs[0].rgba[4 * p]));
        }
    print_message(
        "behind a ball, %d pixels: %.4f off at most, %.4f by a frame alone; all: %.4f and %.4f\n",
        count, most, bare, off[2], off[1]);
    assert_true(count > 40 && most < bare + .0025 && off[2] < 1.09 * off[1]);
    for (int i = 0; i < 3; i++)
        frame_running_close(&rigs[i]);
}

enum { STEPS = 14, SKIPPED = 8, TRAIL = 8 };

/* Rolls the ball by one frame's distance, .3 pixels in the middle. */
static void roll(FrameRunning *rig, int step)
{
    double *m = rig->scene->objects[SPHERE].world_from_local.m;
    const double angle = .07 * step;
    const double turned[9] = {cos(angle), 0, -sin(angle), 0, 1, 0, sin(angle), 0, cos(angle)};
    for (int k = 0; k < 9; k++)
        m[4 * (k / 3) + k % 3] = turned[k];
    m[12] += .3 * .07;
    assert_true(renderer_changed_objects(rig->renderer, SPHERE, 1));
}

/* Finds the pixels that show the ball in each frame, by comparing depths with the ball below the
 * floor. */
static void find_ball(bool shown[STEPS][PIXELS])
{
    static FrameRunning shape, empty;
    open_rig(&shape, "samples: 1", "depth");
    open_rig(&empty, "samples: 1", "depth");
    empty.scene->objects[SPHERE].world_from_local.m[14] -= 5;
    assert_true(renderer_changed_objects(empty.renderer, SPHERE, 1));
    frame_running_draw(&empty);
    for (int step = 0; step < STEPS; step++) {
        roll(&shape, step);
        frame_running_draw(&shape);
        for (int p = 0; p < PIXELS; p++)
            shown[step][p] = shape.rgba[4 * p] > empty.rgba[4 * p] * 1.01f;
    }
    frame_running_close(&shape);
    frame_running_close(&empty);
}

static bool was_shown(bool shown[STEPS][PIXELS], int step, int p)
{
    bool was = false;
    for (int before = step - TRAIL; before < step; before++)
        was |= shown[before][p];
    return was;
}

/* A rolling ball leaves no trail: on the surface that it uncovers, and overall, the accumulated
 * result is nearer to the truth than a single frame; on the ball, which is reprojected, it is no
 * farther off. */
static void what_moves_is_followed(void **state)
{
    (void)state;
    enum { BALL, BEHIND, ALL, AREAS };
    static const struct {
        const char *name;
        double most; /* max share of the single frames' error */
    } areas[AREAS] = {{"on the ball", .98}, {"where it was", .74}, {"all", .9}};
    static const char *const keys[] = {"samples: 48", "samples: 1", "history: 16"};
    static bool shown[STEPS][PIXELS];
    static FrameRunning rigs[3];
    double sums[3][AREAS] = {{0}};
    find_ball(shown);
    for (int i = 0; i < 3; i++)
        open_rig(&rigs[i], keys[i], "ao");
    for (int step = 0; step < STEPS; step++) {
        for (int i = 0; i < 3; i++) {
            roll(&rigs[i], step);
            if (i == 2 || step >= SKIPPED)
                frame_running_draw(&rigs[i]);
        }
        for (int p = 0; step >= SKIPPED && p < PIXELS; p++)
            for (int i = 1; i < 3; i++) {
                const double off = (double)rigs[i].rgba[4 * p] - (double)rigs[0].rgba[4 * p];
                const bool now = shown[step][p];
                sums[i][BALL] += now ? off * off : 0;
                sums[i][BEHIND] += !now && was_shown(shown, step, p) ? off * off : 0;
                sums[i][ALL] += off * off;
            }
    }
    for (int area = 0; area < AREAS; area++) {
        const double share = sqrt(sums[2][area] / sums[1][area]);
        print_message("a rolling ball, %s: %.2f of what frames alone are off\n", areas[area].name,
                      share);
        assert_true(share < areas[area].most);
    }
    for (int i = 0; i < 3; i++)
        frame_running_close(&rigs[i]);
}

/* A plate slides over a wall, so close in front of the wall that the history of the plate also
 * passes the rejection test for the wall: within a pixel, and with an equal normal. The
 * uncovered wall is no farther off than a single frame, because light at places within a pixel
 * of each other is alike. */
static void what_slides_over_a_wall_lends_what_is_alike(void **state)
{
    (void)state;
    static const char slide[] =
        "voxels: { size: 64 }\nimage: { width: 48, height: 48 }\ncamera: { camera: Perspective, "
        "position: [0, -4, .5], "
        "target: [0, 0, .5], "
        "angle: 40 }\nmaterials: { m: { material: Phong, diffuse: .6, specular: 0 } }\nobjects:\n"
        "- { object: Box, material: m, size: [3, 3, .2], transform: { translation: [0, -.9, -.1] } "
        "}\n"
        "- { object: Box, material: m, size: [3, .4, 2], transform: { translation: [0, .8, 1] } }\n"
        "- { object: Box, material: m, size: [.5, .3, .9], transform: { translation: [-.7, .7, "
        ".47] } }\n";
    static const char *const keys[] = {"samples: 48", "samples: 1", "history: 16"};
    static const double step_way = .12;
    static FrameRunning rigs[3], depth;
    static float before[PIXELS];
    double sums[3] = {0};
    char text[TEXT];
    int count = 0;
    enum { STEPS = 10, SKIPPED = 2 };
    for (int i = 0; i < 4; i++) {
        snprintf(text, sizeof text, "indirect: { radius: 1, %s }\n%s", keys[i % 3], slide);
        frame_running_open(gl, text,
                           &(RendererOptions){.view = i < 3 ? "ao" : "depth", .deep = true},
                           i < 3 ? &rigs[i] : &depth);
    }
    for (int step = 0; step < STEPS; step++) {
        for (int i = 0; i < 4; i++) {
            FrameRunning *rig = i < 3 ? &rigs[i] : &depth;
            rig->scene->objects[2].world_from_local.m[12] += step_way;
            assert_true(renderer_changed_objects(rig->renderer, 2, 1));
            frame_running_draw(rig);
        }
        for (int p = 0; p < PIXELS; p++) {
            const bool bared =
                step >= SKIPPED && depth.rgba[4 * p] < before[p] * .995f && depth.rgba[4 * p] > 0;
            for (int i = 1; bared && i < 3; i++)
                sums[i] += pow((double)rigs[i].rgba[4 * p] - (double)rigs[0].rgba[4 * p], 2);
            count += bared;
            before[p] = depth.rgba[4 * p];
        }
    }
    print_message("a plate over a wall: %d pixels bared, %.4f off, %.4f by frames alone\n", count,
                  sqrt(sums[2] / count), sqrt(sums[1] / count));
    assert_true(count > 100 && sums[2] < .99 * sums[1]);
    for (int i = 0; i < 4; i++)
        frame_running_close(i < 3 ? &rigs[i] : &depth);
}

/* A lamp halves its intensity between two frames: its indirect light follows at once, except for
 * noise. */
static void lamps_that_change_are_followed(void **state)
{
    (void)state;
    static const char *const keys[] = {"samples: 48", "samples: 1", "history: 16"};
    static FrameRunning rigs[3];
    double off[3], most = 0;
    for (int i = 0; i < 3; i++) {
        open_rig(&rigs[i], keys[i], "indirect");
        for (int k = 0; k < (i == 2 ? 16 : 1); k++)
            frame_running_draw(&rigs[i]);
        for (int k = 0; k < 3; k++)
            rigs[i].scene->lights[0].light[k] /= 2;
        assert_true(renderer_changed(rigs[i].renderer, RENDERER_LIGHTS));
        frame_running_draw(&rigs[i]);
        off[i] = apart(rigs[i].rgba, rigs[0].rgba);
    }
    for (int p = 0; p < PIXELS; p++)
        most = fmax(most, (double)rigs[0].rgba[4 * p]);
    print_message("half a lamp: %.5f off, %.5f by a frame alone, of %.3f at most\n", off[2], off[1],
                  most);
    assert_true(off[2] < .013 * most && off[2] < 1.5 * off[1]);
    for (int i = 0; i < 3; i++)
        frame_running_close(&rigs[i]);
}

/* Fragment programs accumulate like compute programs; without the setting nothing is
 * accumulated. */
static void ways_and_wants(void **state)
{
    (void)state;
    static const char *const keys[] = {"samples: 1", "samples: 4",
                                       "samples: 1, filter: atrous, filterSize: 8"};
    for (int i = 0; i < 3; i++) {
        open_rig(&one, keys[i], "light");
        char *graph = frame_graph(one.renderer);
        assert_true((strstr(graph, " rays temporal not run: nothing to do\n") == NULL) == (i == 1));
        free(graph);
        memcpy(some, frame_running_draw(&one), sizeof some);
        Renderer *fragment = renderer_open(
            gl, &(RendererOptions){
                    .compile = &one.options, .view = "light", .deep = true, .fragment = true});
        float *drawn = frame_floats_by(gl, fragment, one.scene);
        assert_true(apart(drawn, some) < 1e-6);
        free(drawn);
        renderer_close(fragment);
        frame_running_close(&one);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sets_are_averaged),
        cmocka_unit_test(errors_are_as_stated),
        cmocka_unit_test(paths_are_calmer),
        cmocka_unit_test(nothing_is_left_behind_what_moves),
        cmocka_unit_test(what_moves_is_followed),
        cmocka_unit_test(what_slides_over_a_wall_lends_what_is_alike),
        cmocka_unit_test(lamps_that_change_are_followed),
        cmocka_unit_test(ways_and_wants)};
    gl = frame_context();
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    gl_close(gl);
    return failed;
}
