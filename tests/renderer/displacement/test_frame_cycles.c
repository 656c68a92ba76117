/* Displaced surfaces against Cycles, which subdivides and displaces them by its own nodes:
 * tests/reference/README.md. The tolerance of each method's triangles follows from their size
 * and the surface's second derivative; for ray-marched surfaces it is only that of Cycles' own
 * triangles. */
/* ctest: unsanitized seconds=17 */
#include "tests/frame/frame_compare.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/reference_picture.h"
#include "tests/frame_reference/reference_ray.h"
#include <stdio.h>
#include <string.h>

enum { EDGE = 160, PIXELS = EDGE * EDGE, TEXT = 4000 };
#define DOCUMENT SOURCE_FOLDER "/tests/reference/cycles/displaced.yaml"

/* For the sheet, then for the box: the longest edge of a face's two triangles, and the greatest
 * second derivative of the height by length: the sum over both sines of amplitude times the square
 * of the wave's number. A unit normal turns by at most this much a length of the face. */
static const struct {
    double edge, bent;
} bodies[2] = {{3 * 1.41421356, .08 * (144 + 25) / 9 + .05 * (49 + 256) / 9},
               {1.6 * 1.41421356, .06 * 34 + .042 * 52}};

/* Subdivided into `parts` per edge, or into triangles with an error of `pixels`; neither:
 * ray-marched. */
typedef struct {
    const char *how;
    int parts;
    double pixels;
} Way;
static const Way ways[] = {{"method: mesh, level: 32", 32, 0},
                           {"method: grid, level: 32", 32, 0},
                           {"method: tessellation, level: 32", 32, 0},
                           {"method: geometry, level: 32", 32, 0},
                           {"method: bisection, pixels: 1, triangles: 200000", 0, 1},
                           {"method: traced, level: 32", 0, 0}};
enum { WAYS = sizeof ways / sizeof *ways };

#define ROUNDED 5e-6 /* files hold multiples of 2^-18, Cycles its rays in floats */

/* Options of all drawings, and Cycles' points and normals. */
typedef struct {
    const MatcOptions *options;
    MatcLayout *layout;
    GlContext *gl;
    Renderer *depth, *normal;
    ReferencePicture wanted[2];
} World;

typedef struct {
    float *depth, *normal;
    ReferencePicture wanted[2];
} Pictures;

/* Opens the document with its line `displacement:` replaced; with a wrong scale, the box's in
 * proportion, unless NULL. */
static Scene *open_scene(const char *how, const char *scale, const MatcOptions *options,
                         MatcDocument **document)
{
    char text[TEXT] = "", line[TEXT / 4];
    Scene *scene = NULL;
    FILE *file = fopen(DOCUMENT, "rb");
    assert_non_null(file);
    while (fgets(line, sizeof line, file)) {
        if (!strncmp(line, "displacement:", strlen("displacement:")))
            snprintf(line, sizeof line, "displacement: { %s }\n", how);
        double was;
        if (scale && sscanf(line, " displacementScale: %lf", &was) == 1)
            snprintf(line, sizeof line, "    displacementScale: %g\n",
                     was * strtod(scale, NULL) / .2);
        strncat(text, line, TEXT - 1 - strlen(text));
    }
    fclose(file);
    *document = scene_read(DOCUMENT, text, strlen(text), options, &scene);
    if (!scene)
        fail_msg("%s", matc_diagnostics(*document, MATC_TEXT));
    return scene;
}

/* Errors relative to their bounds, of points and of normals, on each object. */
typedef struct {
    double share[2][2][PIXELS], off[2][2][PIXELS];
    int count[2], missing;
} Judged;

static double length_of(const double a[3]) { return sqrt(reference_dot(a, a)); }

/* On a face of the box, away from its edges by more than a part of them: there a body without gaps
 * is between its faces, by rules that Cycles need not have. */
static bool is_within(const double p[3])
{
    double sizes[3] = {fabs(p[0]), fabs(p[1]), fabs(p[2])};
    qsort(sizes, 3, sizeof *sizes, ascending);
    return sizes[1] < .8 - .1;
}

static void note(Judged *judged, int body, int what, double off, double bound)
{
    judged->off[body][what][judged->count[body]] = off;
    judged->share[body][what][judged->count[body]] = off / bound;
}

/* Compares a point in front of the camera, and a normal, with Cycles' of the same pixel. Points
 * are compared along the normal of Cycles' tangent plane, from which the surface curves away;
 * normals by the distance of the points. Cycles' triangles are half a pixel wide; at grazing
 * angles longer: one pixel is assumed. */
static void judge(const Scene *scene, const Way *way, double shown[2][3], double wanted[2][3],
                  Judged *judged)
{
    double apart[3], turned[3], from[3];
    for (int k = 0; k < 3; k++) {
        apart[k] = shown[0][k] - wanted[0][k];
        turned[k] = shown[1][k] - wanted[1][k];
        from[k] = wanted[0][k] - scene->camera.position[k];
    }
    const int body = wanted[0][2] > -1.05;
    if (body && !is_within(wanted[0]))
        return;
    const double pixel = 2 * length_of(from) * tan(21 * acos(-1) / 180) / EDGE,
                 far = length_of(apart);
    const double bent = bodies[body].bent, parts = way->parts ? bodies[body].edge / way->parts : 0;
    const double triangles = bent * parts * parts / 8 + way->pixels * pixel,
                 theirs = bent * pixel * pixel / 8;
    note(judged, body, 0, fabs(reference_dot(apart, wanted[1])),
         triangles + theirs + bent * far * far / 2 + ROUNDED);
    note(judged, body, 1, length_of(turned), bent * (far + pixel / 2) + ROUNDED);
    judged->count[body]++;
}

static void judge_pixel(const Scene *scene, const Way *way, const Pictures *is, int i,
                        Judged *judged)
{
    double shown[2][3], wanted[2][3];
    const Ray ray = reference_ray(scene, i % EDGE + .5, i / EDGE + .5);
    if (is->wanted[0].rgba[4 * i + 3] != 1)
        return;
    if (!(is->depth[4 * i] > 0)) {
        judged->missing++;
        return;
    }
    const float *normal = is->normal + 4 * i;
    for (int k = 0; k < 3; k++) {
        shown[0][k] = ray.at[k] + scene->camera.near / (double)is->depth[4 * i] * ray.way[k];
        shown[1][k] = (double)normal[0] * scene->camera.right[k] +
                      (double)normal[1] * scene->camera.up[k] +
                      (double)normal[2] * scene->camera.back[k];
        wanted[0][k] = (double)is->wanted[0].rgba[4 * i + k];
        wanted[1][k] = (double)is->wanted[1].rgba[4 * i + k];
    }
    judge(scene, way, shown, wanted, judged);
}

static double quantile(const double *of, int count, double share)
{
    static double sorted[PIXELS];
    memcpy(sorted, of, (size_t)count * sizeof *of);
    qsort(sorted, (size_t)count, sizeof *sorted, ascending);
    return sorted[(int)(share * (count - 1))];
}

static void draw(const World *world, const Way *way, const char *scale, Judged *judged)
{
    MatcDocument *document;
    Scene *scene = open_scene(way->how, scale, world->options, &document);
    Pictures is = {.wanted = {world->wanted[0], world->wanted[1]}};
    is.depth = frame_floats_by(world->gl, world->depth, scene);
    is.normal = frame_floats_by(world->gl, world->normal, scene);
    judged->count[0] = judged->count[1] = judged->missing = 0;
    for (int i = 0; i < PIXELS; i++)
        judge_pixel(scene, way, &is, i, judged);
    free(is.depth);
    free(is.normal);
    frame_forget(scene, document);
}

/* All pixels except one in a thousand, at which moved triangles may shift an outline. */
static void each_method_is_as_near_as_its_triangles(void **state)
{
    static const char *const names[] = {"sheet, points", "sheet, normals", "box, points",
                                        "box, normals"};
    const World *world = *state;
    static Judged judged;
    for (int i = 0; i < WAYS; i++) {
        draw(world, &ways[i], NULL, &judged);
        print_message("%s\n", ways[i].how);
        for (int k = 0; k < 4; k++) {
            const int body = k / 2, what = k % 2, count = judged.count[body];
            const double *off = judged.off[body][what], *share = judged.share[body][what];
            print_message(
                "  %s: half within %.2g, 99.9 %% %.2g; of what may be %.2g, %.2g; %d pixels\n",
                names[k], quantile(off, count, .5), quantile(off, count, .999),
                quantile(share, count, .5), quantile(share, count, .999), count);
            assert_true(count > 2500 && quantile(share, count, .999) < 1);
        }
        assert_int_equal(judged.missing, 0);
    }
}

/* The comparison detects heights that are 1 % too large on the ray-marched surface, and normals
 * off by a fifth. */
static void other_heights_are_seen(void **state)
{
    const World *world = *state;
    static Judged judged;
    draw(world, &ways[WAYS - 1], "0.202", &judged);
    for (int body = 0; body < 2; body++)
        assert_true(quantile(judged.share[body][0], judged.count[body], .5) > 1);
    draw(world, &ways[WAYS - 1], "0.16", &judged);
    assert_true(quantile(judged.share[0][1], judged.count[0], .999) > 1);
}

static int begin(void **state)
{
    static World world;
    static MatcOptions options;
    options = frame_float_options(&world.layout);
    world.options = &options;
    world.gl = frame_context();
    world.depth = renderer_open(world.gl, &(RendererOptions){.compile = &options, .view = "depth"});
    world.normal =
        renderer_open(world.gl, &(RendererOptions){.compile = &options, .view = "normal"});
    *state = &world;
    return !(world.depth && world.normal &&
             reference_picture_read("cycles/displaced_points", &world.wanted[0]) &&
             reference_picture_read("cycles/displaced_normals", &world.wanted[1]));
}

static int end(void **state)
{
    World *world = *state;
    renderer_close(world->depth);
    renderer_close(world->normal);
    for (int k = 0; k < 2; k++)
        reference_picture_free(&world->wanted[k]);
    matc_layout_free(world->layout);
    gl_close(world->gl);
    return 0;
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_method_is_as_near_as_its_triangles),
        cmocka_unit_test(other_heights_are_seen),
    };
    return cmocka_run_group_tests(tests, begin, end);
}
