/* Meshes displaced by geometry programs, drawn under OSMesa: their points equal those of meshes
 * that the C reference displaced, below and above the output limit of one invocation;
 * independently subdivided patches have gaps, which skirts of each kind hide; stand-in points
 * are at the grid's points. */
/* ctest: seconds=43 */
#include "tests/frame/frame_compare.h"
#include "tests/frame/displaced_bodies.h"
#include "tests/frame/frame_draw.h"
#include "runtime/scene/scene_patches.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const Shape *shape_of(const Scene *scene)
{
    return &scene->meshes[scene->objects[0].mesh].shape;
}

static int triangles_of(GlContext *gl, int body, const char *how, MatcDocument **document,
                        Scene **scene)
{
    *scene = displaced_drawn(gl, body, how, document);
    return shape_of(*scene)->index_count / 3;
}

/* Patches of 7 segments in one pass; of 12, as three by four; on a box with hard edges, which
 * mix two normals. */
static void points_are_those_of_the_reference(void **state)
{
    (void)state;
    static const int levels[] = {5, 7, 12};
    GlContext *gl = frame_context();
    for (int i = 0; i < 3; i++) {
        char how[80];
        MatcDocument *documents[2];
        Scene *scenes[2];
        double worst = 0;
        int counts[2];
        for (int k = 0; k < 2; k++) {
            snprintf(how, sizeof how, "method: %s, level: %d", k ? "geometry" : "mesh", levels[i]);
            counts[k] = triangles_of(gl, 0, how, &documents[k], &scenes[k]);
        }
        const Shape *shape = shape_of(scenes[1]);
        for (int k = 0; k < shape->vertex_count; k++)
            worst = fmax(worst, displaced_nearest(shape_of(scenes[0]), shape->vertices[k].position,
                                                  shape->base[k]));
        print_message("%d parts: %d triangles, off by %.2g\n", levels[i], counts[1], worst);
        assert_true(counts[0] == 12 * levels[i] * levels[i] && counts[1] == counts[0] &&
                    worst < 1e-6);
        assert_true(shape_body(shape) != SHAPE_BODY_none);
        for (int k = 0; k < 2; k++)
            frame_forget(scenes[k], documents[k]);
    }
    gl_close(gl);
}

/* n^2 triangles; 6 n more around a patch, one below it, or 6 around each. */
static void skirts_have_their_triangles(void **state)
{
    (void)state;
    static const struct {
        const char *how;
        int triangles;
    } cases[] = {{"skirts: none, level: 4", 16},         {"skirts: copy, level: 4", 17},
                 {"skirts: outline, level: 4", 16 + 24}, {"skirts: all, level: 4", 112},
                 {"skirts: outline, level: 10", 160},    {"skirts: all, level: 5", 175}};
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char how[80];
        MatcDocument *document;
        Scene *scene;
        snprintf(how, sizeof how, "method: geometry, %s", cases[i].how);
        assert_int_equal(triangles_of(gl, 0, how, &document, &scene), 12 * cases[i].triangles);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

/* Edges have gaps unless their neighbors have equal segment counts. A lowered copy does not hide
 * all gaps seen obliquely, at the rim of the square. */
static void skirts_hide_gaps(void **state)
{
    (void)state;
    static const char *const skirts[] = {"none", "auto", "copy", "outline", "all"};
    static const int shown[] = {0, 3};
    GlContext *gl = frame_context();
    for (int i = 0; i < 5; i++) {
        long within = 0;
        char how[120];
        snprintf(how, sizeof how, "method: geometry, pixels: 5, triangles: 9000, skirts: %s",
                 skirts[i]);
        const int count = displaced_holes_of(gl, shown, how, &within);
        print_message("skirts: %s: %d holes in %ld pixels\n", skirts[i], count, within);
        assert_true(within > 9000 && (i == 0 ? count > 5 : i == 2 ? count < 3 : count == 0));
    }
    gl_close(gl);
}

/* Four corners of each symbol lie around the grid's point, in the plane perpendicular to its
 * normal; a ball's points are at equal distances. */
static void symbols_stand_around_points(void **state)
{
    (void)state;
    static const struct {
        const char *name;
        int triangles;
    } symbols[] = {{"square", 2}, {"billboard", 2}, {"cylinder", 22}, {"sphere", 36}};
    enum { LEVEL = 3, POINTS = (LEVEL + 1) * (LEVEL + 2) / 2 };
    GlContext *gl = frame_context();
    MatcDocument *documents[2];
    Scene *scenes[2];
    triangles_of(gl, 0, "method: grid, level: 3", &documents[0], &scenes[0]);
    const Shape *grid = shape_of(scenes[0]);
    for (int i = 0; i < 4; i++) {
        char how[80];
        double most = 0;
        snprintf(how, sizeof how, "method: points, level: 3, symbol: %s", symbols[i].name);
        assert_int_equal(triangles_of(gl, 0, how, &documents[1], &scenes[1]),
                         12 * POINTS * symbols[i].triangles);
        const Shape *shape = shape_of(scenes[1]);
        for (int first = 0; first < shape->vertex_count; first += 3 * symbols[i].triangles) {
            float low[3], high[3], middle[3];
            for (int component = 0; component < 3; component++) {
                low[component] = INFINITY, high[component] = -INFINITY;
                for (int k = first; k < first + 3 * symbols[i].triangles; k++) {
                    low[component] = fminf(low[component], shape->vertices[k].position[component]);
                    high[component] =
                        fmaxf(high[component], shape->vertices[k].position[component]);
                }
                middle[component] = (low[component] + high[component]) / 2;
            }
            most = fmax(most, displaced_nearest(grid, middle, shape->base[first]));
        }
        print_message("%s: the middle is off by %.2g\n", symbols[i].name, most);
        /* six sides and three bands do not reach as far to all sides */
        assert_true(most < (i == 3 ? .06 : 1e-5));
        frame_forget(scenes[1], documents[1]);
    }
    frame_forget(scenes[0], documents[0]);
    gl_close(gl);
}

/* Four heights over a square. The upper pair fills half of it: each height has a square of its own,
 * turned away from what is solid. The heights' planes lean by known slopes. */
static void volumes_have_points_for_each_height(void **state)
{
    (void)state;
    static const char text[] =
        "image: { width: 32, height: 32 }\ncamera: { camera: Perspective, position: [1, -3, 2], "
        "angle: 40 }\n"
        "materials: { m: { material: Phong, emissive: 1, displacementVolume: \"= [.1 * u, .3, .5 + "
        ".2 * v, v > .45 ? "
        ".9 : .2]\", displacementBound: 1 } }\n"
        "displacement: { method: points, level: 6 }\nlights: []\nobjects:\n"
        "- { object: Parallelogram, u: [2, 0, 0], v: [0, 2, 0], material: m }\n";
    enum { POINTS = 2 * 28, UPPER = 4 + 5 + 6 + 7 + 1 + 2 + 3 + 4 };
    GlContext *gl = frame_context();
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Scene *scene = frame_scene(text, &options, &document);
    double worst = 0, turned = 0;
    int of_height[4] = {0};
    free(frame_floats(gl, scene,
                      &(RendererOptions){
                          .compile = &options, .view = "light", .edges = RENDERER_EDGES_coverage}));
    const Shape *shape = shape_of(scene);
    for (int first = 0; first + 6 <= shape->index_count; first += 6) {
        const ShapeVertex *v = &shape->vertices[shape->indices[first]],
                          *across = &shape->vertices[shape->indices[first + 5]];
        const double *known = NULL;
        const double heights[4] = {.1 * v->uv[0], .3, .5 + .2 * v->uv[1], .9},
                     z = ((double)v->position[2] + across->position[2]) / 2;
        static const double slopes[4][3] = {{.05, 0, -1}, {0, 0, 1}, {0, .1, -1}, {0, 0, 1}};
        for (int k = 0; k < 4; k++)
            if (!known || fabs(heights[k] - z) < fabs(*known - z))
                known = &heights[k];
        const double *slope = slopes[known - heights],
                     size = sqrt(slope[0] * slope[0] + slope[1] * slope[1] + slope[2] * slope[2]);
        of_height[known - heights]++;
        worst = fmax(worst, fabs(*known - z));
        for (int k = 0; k < 3; k++)
            turned = fmax(turned, fabs((double)v->normal[k] - slope[k] / size));
    }
    print_message("%d, %d, %d and %d points, off by %.2g, normals by %.2g\n", of_height[0],
                  of_height[1], of_height[2], of_height[3], worst, turned);
    assert_true(of_height[0] == POINTS && of_height[1] == POINTS && of_height[2] == UPPER &&
                of_height[3] == UPPER);
    assert_true(worst < 1e-5 && turned < 1e-3);
    frame_forget(scene, document);
    gl_close(gl);
}

/* Three points for each small triangle, none where another is; halfway to its middle they are at
 * 2/3 and 1/6 of it. */
static void points_spread_into_gaps(void **state)
{
    (void)state;
    GlContext *gl = frame_context();
    MatcDocument *document;
    Scene *scene;
    assert_int_equal(
        triangles_of(gl, 3, "method: points, level: 4, spread: 0.5", &document, &scene),
        2 * 3 * 16 * 2);
    const Shape *shape = shape_of(scene);
    for (int i = 0; i < shape->vertex_count; i += 6)
        for (int component = 0; component < 2; component++) {
            /* steps of 1/2, in sixths */
            const double sixths = 3 * ((double)shape->base[i][component] + 0) * 4;
            assert_true(fabs(sixths - rint(sixths)) < 1e-4);
            for (int k = 0; k < i; k += 6)
                assert_true(memcmp(shape->base[i], shape->base[k], sizeof shape->base[i]) != 0);
        }
    frame_forget(scene, document);
    gl_close(gl);
}

/* A cube whose faces are pushed by the radius of the ball through its corners is that ball. Where
 * planes through corners have the middle of a face is 1 + 2 / 3 from the cube's: that point lies
 * between two opposite corners, whose planes it is 2 / sqrt(3) below. */
static void a_cube_becomes_a_ball(void **state)
{
    (void)state;
    static const char *const methods[] = {"grid, level: 8", "tessellation, level: 8",
                                          "geometry, level: 8", "feedback, near: 1e9, steps: 3",
                                          "bisection, pixels: 0.5, triangles: 2000"};
    GlContext *gl = frame_context();
    for (int i = 0; i < 2 * (int)(sizeof methods / sizeof *methods); i++) {
        char how[80];
        MatcDocument *document;
        Scene *scene;
        double worst = 0, middle = 0;
        snprintf(how, sizeof how, "method: %s, %s", methods[i / 2],
                 i % 2 ? "bulge: 0.5" : "push: 1.7320508");
        triangles_of(gl, 4, how, &document, &scene);
        const Shape *shape = shape_of(scene);
        for (int k = 0; k < shape->vertex_count; k++) {
            const float *p = shape->vertices[k].position, *base = shape->base[k];
            const double r = sqrt((double)p[0] * p[0] + (double)p[1] * p[1] + (double)p[2] * p[2]);
            worst = fmax(worst, fabs(r - sqrt(3)));
            if (fabsf(base[0]) + fabsf(base[1]) < 1e-6f)
                middle = fmax(middle, (double)fabsf(p[2]));
        }
        print_message("%s: off a ball by %.2g, the middle of a face at %.6f\n", how, worst, middle);
        assert_true(i % 2 ? worst > .1 && fabs(middle - 4. / 3) < 1e-5 : worst < 1e-5);
        /* it refined */
        assert_true(i / 2 < 4 || (shape->index_count > 3 * 100 && shape->index_count <= 3 * 2000));
        assert_true(i / 2 == 3 || shape_body(shape) != SHAPE_BODY_none);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

static void others_have_no_skirts(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    static const char text[] = "camera: { camera: Perspective }\ndisplacement: { method: grid, "
                               "skirts: all }\nlights: []\nobjects: []\n";
    Scene *scene;
    MatcDocument *document = scene_read("scene.yaml", text, sizeof text - 1, &options, &scene);
    assert_null(scene);
    assert_non_null(strstr(matc_diagnostics(document, MATC_TEXT),
                           "2:39: error: displacement by grid has no skirts of kind all"));
    matc_document_free(document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(points_are_those_of_the_reference),
        cmocka_unit_test(skirts_have_their_triangles),
        cmocka_unit_test(skirts_hide_gaps),
        cmocka_unit_test(symbols_stand_around_points),
        cmocka_unit_test(volumes_have_points_for_each_height),
        cmocka_unit_test(points_spread_into_gaps),
        cmocka_unit_test(a_cube_becomes_a_ball),
        cmocka_unit_test(others_have_no_skirts),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
