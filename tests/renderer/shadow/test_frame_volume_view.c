/* Views of shadow volumes and wireframes: their coverage and brightness by closed forms; pixels
 * that must stay unchanged; changes, tiles, and refused settings. */
#include "tests/test.h"
#include "runtime/renderer/renderer.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 120, HEIGHT = 90, PIXELS = WIDTH * HEIGHT, SIZE = 64 };

/* Light from above onto a box whose edge is 1 and whose lower side is at height 2. */
#define SCENE(camera, light)                                                                       \
    "image: { width: 120, height: 90 }\ncamera: { camera: " camera                                 \
    " }\nshadowMaps: { size: 64, volume: %s }\n"                                                   \
    "materials: { m: { material: Phong, diffuse: .5, emissive: .2 } }\nlights: [{ light: " light   \
    " }]\n"                                                                                        \
    "objects:\n- { object: Box, material: m, transform: { translation: [0, 0, 2.5] } }\n"
#define HYBRID  "Directional, shadows: hybrid"
#define FRONT   "Orthographic, position: [0, -9, 2], target: [0, 0, 2], size: 4"
#define ASIDE   "Orthographic, position: [4.5, -7.794228634, 2], target: [0, 0, 2], size: 4"
#define PINHOLE "Perspective, position: [2, -6, 1.4], target: [0, 0, 1.4], angle: 35"
#define BEFORE                                                                                     \
    "- { object: Box, size: [.5, .1, 2], material: m, transform: { translation: [.4, -2, .5] } "   \
    "}\n"
#define PLATE                                                                                      \
    "- { object: Box, size: [4, .1, 4], material: m, transform: { translation: [0, 3, 1] } }\n"

typedef struct {
    GlContext *gl;
    MatcOptions compile;
    MatcDocument *document;
    Scene *scene;
} Drawn;

static Drawn open_scene(const char *text)
{
    Drawn d = {.gl = frame_context(), .compile = frame_exact_options()};
    d.scene = frame_scene(text, &d.compile, &d.document);
    return d;
}

static float *draw(const Drawn *d, const char *view)
{
    return frame_floats(d->gl, d->scene, &(RendererOptions){.compile = &d->compile, .view = view});
}

static void close_scene(Drawn *d)
{
    frame_forget(d->scene, d->document);
    gl_close(d->gl);
}

/* The map is fitted to the box, 2 (filter + 2) texels wider; the volume ends at the outermost
 * center that the box covers. */
static double end_of_volume(void)
{
    const double half = .5 * (1 + 6.0 / SIZE);
    double end = 0;
    for (int i = 0; i < SIZE; i++) {
        const double centre = half * ((2 * i + 1.0) / SIZE - 1);
        if (fabs(centre) < .5)
            end = fmax(end, centre);
    }
    return end;
}

/* -- faces */

/* The ray through a pixel: from[3], way[3]. */
static void ray_of(const SceneCamera *camera, int pixel, double from[3], double way[3])
{
    const double x = (2 * (pixel % WIDTH) + 1.0 - WIDTH) / HEIGHT,
                 y = (2 * (pixel / WIDTH) + 1.0 - HEIGHT) / HEIGHT;
    const bool parallel = camera->kind == SCENE_Orthographic;
    const double half = camera->half;
    for (int i = 0; i < 3; i++) {
        const double aside = half * (x * camera->right[i] + y * camera->up[i]);
        from[i] = camera->position[i] + (parallel ? aside : 0);
        way[i] = -camera->back[i] + (parallel ? 0 : aside);
    }
}

/* First hit of the ray with the column of that half width below the height 2: the cosine to the
 * wall's normal; -1: no hit; -2: near a visible edge. */
static double column_facing(const double from[3], const double way[3], double half)
{
    double enter[2], leave[2], near = -1e9, far = 1e9;
    int side = 0;
    for (int i = 0; i < 2; i++) {
        const double a = (-half - from[i]) / way[i], b = (half - from[i]) / way[i];
        enter[i] = fmin(a, b), leave[i] = fmax(a, b);
        side = enter[i] > near ? i : side;
        near = fmax(near, enter[i]), far = fmin(far, leave[i]);
    }
    const double length = sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
    const double height = from[2] + near * way[2], margin = .03 * length;
    if (fabs(near - far) < 4 * margin || fabs(height - 2) < .06 ||
        fabs(enter[0] - enter[1]) < 4 * margin)
        return -2;
    return near < far && height < 2 ? fabs(way[side]) / length : -1;
}

static double encoded(double light)
{
    return light <= .0031308 ? 12.92 * light : 1.055 * pow(light, 1 / 2.4) - .055;
}

static void faces_of(const char *camera, const char *volume)
{
    char text[2048];
    snprintf(text, sizeof text, camera, volume);
    Drawn d = open_scene(text);
    float *shown = draw(&d, "volumeAlone");
    int covered = 0, empty = 0, wrong = 0;
    for (int i = 0; i < PIXELS; i++) {
        double from[3], way[3];
        ray_of(&d.scene->camera, i, from, way);
        for (int k = 0; k < 3; k++) /* a wall along the view is met nowhere */
            way[k] = fabs(way[k]) < 1e-12 ? 1e-12 : way[k];
        const double facing = column_facing(from, way, end_of_volume());
        const double share = .25 + .75 * facing, colors[3] = {.95, .45, .1};
        covered += facing >= 0;
        empty += facing == -1;
        for (int component = 0; component < 3 && facing > -2; component++)
            wrong += fabs((double)shown[4 * i + component] -
                          (facing < 0 ? 0 : encoded(share * colors[component]))) > 1.5 / 255;
    }
    print_message("%-8s %d covered, %d empty, %d components wrong\n", volume, covered, empty,
                  wrong);
    assert_true(covered > 400 && empty > 3000);
    assert_int_equal(wrong, 0);
    free(shown);
    close_scene(&d);
}

static void a_column_is_seen_as_it_stands(void **state)
{
    (void)state;
    static const char *const volumes[] = {"plain", "perfect"};
    for (int i = 0; i < 2; i++) {
        faces_of(SCENE(FRONT, HYBRID), volumes[i]);
        faces_of(SCENE(ASIDE, HYBRID), volumes[i]);
        faces_of(SCENE(PINHOLE, HYBRID), volumes[i]);
    }
}

/* -- over the scene */

static void the_scene_stays_where_no_volume_is(void **state)
{
    (void)state;
    static const char *const views[] = {"volume", "volumeWireframe"};
    char text[2048];
    snprintf(text, sizeof text, SCENE(FRONT, HYBRID) BEFORE PLATE, "perfect");
    Drawn d = open_scene(text);
    float *plain = draw(&d, NULL);
    for (int k = 0; k < 2; k++) {
        float *shown = draw(&d, views[k]);
        int inside = 0, same = 0;
        for (int i = 0; i < PIXELS; i++) {
            double at[3], way[3];
            ray_of(&d.scene->camera, i, at, way);
            const bool other = memcmp(shown + 4 * i, plain + 4 * i, 4 * sizeof *plain) != 0;
            const bool below = fabs(at[0]) < .4 && at[2] < 1.9 && at[2] > -.4;
            const bool hidden = fabs(at[0] - .4) < .25 && at[2] > -.5 && at[2] < 1.5;
            if (below && !hidden && fabs(at[0] - .4) > .3 && k == 0)
                assert_true(other), inside++;
            if (fabs(at[0]) > 3.2 || at[2] > 3.1 ||
                (hidden && fabs(at[0] - .4) < .2 && at[2] < 1.45))
                assert_false(other), same++; /* the plate's own volume is 4 wide */
        }
        assert_true(same > 1000 && (k || inside > 300));
        free(shown);
    }
    free(plain);
    close_scene(&d);
}

/* -- lines */

/* From the front a box is a square, 22.5 pixels wide: exactly its outline and diagonals are
 * drawn. */
static void a_box_as_lines(void **state)
{
    (void)state;
    char text[2048];
    snprintf(text, sizeof text, SCENE(FRONT, "Ambient"), "perfect");
    Drawn d = open_scene(text);
    float *shown = draw(&d, "wireframe"), *filled = draw(&d, NULL);
    int rows = 0, inner = 0, lines = 0;
    for (int i = 0; i < PIXELS; i++) {
        const double x = i % WIDTH + .5 - WIDTH / 2.0,
                     y = i / WIDTH + .5 - (HEIGHT / 2.0 + HEIGHT / 8.0);
        const double half = HEIGHT / 8.0, edge = fmax(fabs(x), fabs(y)) - half,
                     diagonal = fabs(fabs(x) - fabs(y));
        const bool lit = shown[4 * i] > 0;
        lines += lit;
        rows += lit && fabs(x + half) < 1.01 && fabs(y) < half - 2;
        if (edge < -1.5 && diagonal > 1.5)
            assert_false(lit), inner++, assert_true(filled[4 * i] > 0);
        if (edge > 1.5)
            assert_false(lit);
    }
    print_message("%d pixels of lines, %d of the left edge, %d empty inside\n", lines, rows, inner);
    assert_true(rows >= 18 && inner > 200 && lines < 250);
    free(shown);
    free(filled);
    close_scene(&d);
}

/* -- changes */

static void changes_and_tiles(void **state)
{
    (void)state;
    static const char *const views[] = {"wireframe",  "volume",      "volumeWireframe",
                                        "wireframes", "volumeAlone", "volumeWireframeAlone"};
    char text[2048];
    snprintf(text, sizeof text,
             SCENE(PINHOLE, "Point, position: [0, .3, 4], shadows: hybrid") BEFORE PLATE,
             "perfect");
    Drawn d = open_scene(text);
    const double place = d.scene->objects[0].world_from_local.m[12],
                 eye = d.scene->camera.position[2];
    for (size_t i = 0; i < sizeof views / sizeof *views; i++) {
        const RendererOptions how = {
            .compile = &d.compile, .view = views[i], .edges = RENDERER_EDGES_coverage};
        RendererOptions tiles = how;
        Renderer *renderer = renderer_open(d.gl, &how);
        float *changed = malloc(8 * sizeof *changed * PIXELS), *again = changed + 4 * PIXELS;
        d.scene->objects[0].world_from_local.m[12] = place;
        d.scene->camera.position[2] = eye;
        assert_true(renderer && renderer_set_scene(renderer, d.scene) && renderer_frame(renderer));
        d.scene->objects[0].world_from_local.m[12] += .4;
        d.scene->camera.position[2] += .3;
        assert_true(renderer_changed_objects(renderer, 0, 1) &&
                    renderer_changed(renderer, RENDERER_CAMERA) && renderer_frame(renderer) &&
                    renderer_read(renderer, changed));
        assert_true(renderer_frame(renderer) && renderer_read(renderer, again));
        assert_memory_equal(changed, again, 4 * sizeof *again * PIXELS);
        renderer_close(renderer);
        float *anew = frame_floats(d.gl, d.scene, &how);
        assert_memory_equal(changed, anew, 4 * sizeof *anew * PIXELS);
        int empty = 0;
        for (int k = 0; k < PIXELS; k++)
            empty += anew[4 * k] + anew[4 * k + 1] + anew[4 * k + 2] <= 0;
        /* what is infinitely far away is left out */
        assert_true(empty > PIXELS / 20 || !strstr(views[i], "Alone"));
        tiles.tile[0] = 64, tiles.tile[1] = 32;
        float *parts = frame_tiles(d.gl, d.scene, &tiles);
        int other = 0;
        for (int k = 0; k < 4 * PIXELS; k++)
            other += fabsf(parts[k] - anew[k]) > 1.5f / 255;
        print_message("%s: %d components are others in tiles\n", views[i], other);
        /* a line that is cut may step elsewhere */
        assert_true(other <= (strstr(views[i], "ireframe") ? 16 : 0));
        free(parts);
        free(anew);
        free(changed);
    }
    close_scene(&d);
}

static void what_is_refused(void **state)
{
    (void)state;
    static const struct {
        const char *light, *view;
        bool linear;
        const char *reported;
    } cases[] = {
        {"Directional", "volume", false,
         "view 'volume' is not available: no light of the scene casts hybrid shadows"},
        {"Directional, shadows: none", "wireframes", false,
         "view 'wireframes' is not available: no light of the scene casts hybrid shadows"},
        {HYBRID, "volumeAlone", true,
         "view 'volumeAlone' is a false-color image and cannot be written as OpenEXR"},
        {HYBRID, "wireframe", true, NULL},
        {"Ambient", "wireframe", false, NULL},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[2048];
        snprintf(text, sizeof text, SCENE(FRONT, "%s"), "perfect", cases[i].light);
        Drawn d = open_scene(text);
        const RendererOptions how = {
            .compile = &d.compile, .view = cases[i].view, .linear = cases[i].linear};
        Renderer *renderer = renderer_open(d.gl, &how);
        assert_non_null(renderer);
        assert_int_equal(renderer_set_scene(renderer, d.scene), !cases[i].reported);
        if (cases[i].reported)
            assert_string_equal(d.gl->error, cases[i].reported);
        renderer_close(renderer);
        close_scene(&d);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_column_is_seen_as_it_stands),
        cmocka_unit_test(the_scene_stays_where_no_volume_is),
        cmocka_unit_test(a_box_as_lines),
        cmocka_unit_test(changes_and_tiles),
        cmocka_unit_test(what_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
