/* Shadow volumes cut by silhouettes: the triangles of a cell close it, for every crossing;
 * shadow boundaries compared with plain volumes; transparent casters, changes, and refused
 * scenes. test_frame_hybrid.c compares them with rays, and a boundary with its closed form. */
/* ctest: unsanitized seconds=14 */
#include "tests/test.h"
#include "gen/render_text.h"
#include "tests/frame_reference/shadow_ends.h"
#include "tests/frame/shadow_knot.h"
#include "runtime/scene/scene.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* -- the triangles of a cell */

enum { ROWS = 7, MOST = 10, RING = 12, NUMBERS = ROWS * 3 * MOST };

/* Reads the numbers of an array in the GLSL text, without its comments. */
static int read_numbers(const char *name, int *numbers, int most)
{
    const char *at = strstr(render_text_volume_cells, name);
    int count = 0;
    at = at ? strchr(at, '(') : NULL;
    assert_non_null(at);
    for (at++; *at && *at != ')' && count < most;
         at += strcspn(at, ",)/") + (at[strcspn(at, ",)/")] == ',')) {
        while (*at == '/' || *at == ' ' || *at == '\n')
            at += *at == '/' ? strcspn(at, "\n") : 1;
        numbers[count++] = (int)strtol(at, NULL, 10);
    }
    return count;
}

/* Bits of the crossed segments for each row of cells. */
static const int crossed_of[ROWS] = {0, 1, 1, 1 | 8, 1 | 4, 1 | 2 | 8, 15};

/* The corners that surround a cell, in order. */
static int ring_of(int crossed, int ring[RING])
{
    int count = 0;
    for (int i = 0; i < 4; i++) {
        ring[count++] = 3 * i;
        for (int side = 1; side < 3 && crossed >> i & 1; side++)
            ring[count++] = 3 * i + side;
    }
    return count;
}

/* Each edge of the ring belongs to one triangle, in the ring's direction; every other edge to
 * two triangles, once in each direction; and the number of triangles is minimal. */
static void triangles_close_cells(void **state)
{
    (void)state;
    int counts[ROWS], corners[NUMBERS];
    assert_int_equal(read_numbers("VOLUME_TRIANGLES[7] = int[7]", counts, ROWS), ROWS);
    assert_int_equal(read_numbers("VOLUME_CORNERS[210] = int[210]", corners, NUMBERS), NUMBERS);
    for (int row = 0; row < ROWS; row++) {
        int edges[RING][RING] = {{0}}, ring[RING];
        const int length = ring_of(crossed_of[row], ring);
        assert_int_equal(counts[row], length - 2);
        for (int i = 0; i < 3 * counts[row]; i++) {
            const int from = corners[3 * MOST * row + i],
                      to = corners[3 * MOST * row + i / 3 * 3 + (i + 1) % 3];
            assert_in_range(from, 0, RING - 1);
            edges[from][to]++;
        }
        for (int i = 0; i < length; i++)
            /* the cell beside has it the other way round */
            edges[ring[(i + 1) % length]][ring[i]]++;
        for (int from = 0; from < RING; from++)
            for (int to = 0; to < RING; to++)
                assert_true(edges[from][to] == edges[to][from] && edges[from][to] <= 1);
    }
}

/* -- ends */

static void ends_are_near(void **state)
{
    (void)state;
    static const double most[SHADOW_ENDS_RECEIVERS] = {.01, .01, .02, .03};
    ShadowPair pair;
    Shape knot = shadow_knot();
    shadow_pair_open(GL_KIND_osmesa, &pair);
    for (int i = 0; i < SHADOW_ENDS_RECEIVERS; i++) {
        ShadowEnds ends = {&knot, "hybrid", (ShadowEndsReceiver)i, false, KEYWORD_Volume_plain, 0};
        const double plain = shadow_ends_distance(&pair, &ends);
        ends.volume = KEYWORD_Volume_silhouette;
        const double cut = shadow_ends_distance(&pair, &ends);
        print_message("ends on %s: %.4f texels off, plain volumes %.4f\n", shadow_ends_receivers[i],
                      cut, plain);
        assert_true(cut <= most[i] && cut < .05 * plain);
    }
    shadow_pair_close(&pair);
    shape_free(&knot);
}

/* -- behind a cut */

/* A roof that is .98 radians steep, with a sheet .08 below it that it covers, and a beam over both,
 * whose sides cross segments of a texel each: beyond the beam's end the roof's own surface goes on
 * by its slope. As high as at the center beyond, it would be up to .39 too low, and the sheet
 * lit. */
#define ROOF                                                                                       \
    "image: { width: 96, height: 64 }\nmaterials: { m: { material: Phong, diffuse: .5 } }\n"       \
    "camera: { camera: Orthographic, position: [-.17845, 0, -.119755], target: [-1.00845, 0, "     \
    "-.676755], "                                                                                  \
    "up: [0, 1, 0], size: 1.8 }\nshadowMaps: { size: 16, volume: silhouette }\n"                   \
    "lights: [{ light: Directional, direction: [0, 0, -1], shadows: hybrid }]\nobjects:\n"         \
    "- { object: Box, size: [6, 4, .4], material: m, transform: { rotation: [0, .98, 0] } }\n"     \
    "- { object: Parallelogram, u: [2.7851, 0, -4.1525], v: [0, 3.6, 0], material: m, transform: " \
    "{ translation: "                                                                              \
    "[-1.6251, -1.8, 1.9203] } }\n"                                                                \
    "- { object: Box, size: [%g, 3, .3], material: m, transform: { translation: [0, 0, 4.5] } }\n"

static void the_slope_goes_on_behind_a_cut(void **state)
{
    (void)state;
    ShadowPair pair;
    int seen = 0, lit = 0;
    shadow_pair_open(GL_KIND_osmesa, &pair);
    for (int i = 0; i < 4; i++) {
        char text[2048];
        MatcDocument *document;
        snprintf(text, sizeof text, ROOF, .6 + .1 * i);
        Scene *scene = frame_scene(text, &pair.options, &document);
        float *shares = shadow_pair_shares(&pair, scene);
        for (int pixel = 0; pixel < scene->width * scene->height; pixel++) {
            seen += shares[pixel] >= 0;
            lit += shares[pixel] > .5f;
        }
        free(shares);
        frame_forget(scene, document);
    }
    shadow_pair_close(&pair);
    print_message("below the roof %d pixels, %d of them lit\n", seen, lit);
    assert_true(seen > 10000);
    assert_int_equal(lit, 0);
}

/* -- what is transparent */

#define SEEN                                                                                       \
    "image: { width: 96, height: 72 }\ncamera: { camera: Perspective, position: [1.5, -7, 4], "    \
    "target: [0, 0, .5], "                                                                         \
    "angle: 42 }\nmaterials: { m: { material: Phong, diffuse: .5 }, g: { material: Phong, "        \
    "diffuse: .5, transparency: "                                                                  \
    "%s, interpolatedTransparency: false } }\n"
#define OBJECTS                                                                                    \
    "- { object: Sphere, radius: .7, material: m, transform: { translation: [-.6, -.4, 1.2] } }\n" \
    "- { object: Box, material: m, transform: { translation: [1, .5, .9], rotation: [0, 0, .3] } " \
    "}\n"

/* A floor of glass is lit like a solid one: its fragments look up the triangles that the stencil
 * counts. */
static void glass_is_lit_as_floors_are(void **state)
{
    (void)state;
    static const char *const lights[] = {"Directional, direction: [1, .2, -.8]",
                                         "Point, position: [-1, -1, 3]"};
    ShadowPair pair;
    shadow_pair_open(GL_KIND_osmesa, &pair);
    for (int k = 0; k < 2; k++) {
        float *shares[2];
        int pixels = 0, dark = 0, other = 0;
        for (int glass = 0; glass < 2; glass++) {
            MatcDocument *document;
            char text[4096];
            snprintf(text, sizeof text,
                     SEEN "shadowMaps: { size: 64, volume: silhouette }\nlights: [{ light: %s, "
                          "shadows: hybrid }]\n"
                          "objects:\n- { object: Parallelogram, u: [5, 0, 0], v: [0, 5, 0], "
                          "material: g, transform: { "
                          "translation: [-2.5, -2.5, 0] } }\n" OBJECTS,
                     glass ? ".5" : "0", lights[k]);
            Scene *scene = frame_scene(text, &pair.options, &document);
            shares[glass] = shadow_pair_shares(&pair, scene);
            pixels = scene->width * scene->height;
            frame_forget(scene, document);
        }
        for (int i = 0; i < pixels; i++) {
            dark += shares[0][i] >= 0 && shares[0][i] < .5f;
            other += shares[0][i] >= 0 && fabsf(shares[0][i] - shares[1][i]) > .01f;
        }
        print_message("%s: %d of %d pixels dark, %d other by glass\n", lights[k], dark, pixels,
                      other);
        assert_true(dark > 200 && other <= dark / 50);
        free(shares[0]);
        free(shares[1]);
    }
    shadow_pair_close(&pair);
}

/* -- what changes, and what is refused */

#define CHANGING                                                                                   \
    "shadowMaps: { size: 64, volume: silhouette }\nlights: [{ light: Directional, direction: [1, " \
    ".2, -.6], shadows: "                                                                          \
    "hybrid },\n  { light: Point, position: [0, .6, 2.5], shadows: hybrid },\n"                    \
    "  { light: Spot, position: [-2, -4, 5], direction: [2, 4, -5], intensity: 40, shadows: "      \
    "silhouette }]\n"                                                                              \
    "objects:\n- { object: Plane, material: m }\n" OBJECTS

/* A light is moved, and has a method; an object is. */
typedef struct {
    int light;
    Keyword method;
    double moved;
} Step;

static void what_changes_is_as_new(void **state)
{
    (void)state;
    static const Step steps[] = {
        {1, KEYWORD_Shadows_hybrid, .7},      {1, KEYWORD_Shadows_hybrid, 0},
        {0, KEYWORD_Shadows_map, 0},          {1, KEYWORD_Shadows_exact, .1},
        {2, KEYWORD_Shadows_hybrid, 0},       {1, KEYWORD_Shadows_silhouette, 0},
        {2, KEYWORD_Shadows_none, .1},        {1, KEYWORD_Shadows_none, 0},
        {0, KEYWORD_Shadows_silhouette, -.2}, {1, KEYWORD_Shadows_hybrid, 0}};
    const MatcOptions options = frame_exact_options();
    const RendererOptions how = {.compile = &options, .view = "light"};
    GlContext *gl = frame_context_of(GL_KIND_osmesa);
    MatcDocument *document;
    char text[4096];
    snprintf(text, sizeof text, SEEN CHANGING, "0");
    Scene *scene = frame_scene(text, &options, &document);
    Renderer *renderer = renderer_open(gl, &how);
    const size_t floats = 4 * (size_t)scene->width * (size_t)scene->height;
    float *changed = malloc(floats * sizeof *changed);
    assert_true(changed && renderer && renderer_set_scene(renderer, scene) &&
                renderer_frame(renderer));
    for (size_t step = 0; step < sizeof steps / sizeof *steps; step++) {
        const Step *next = &steps[step];
        scene->objects[1].world_from_local.m[12] += next->moved;
        scene->lights[next->light].position[0] += .1;
        scene->lights[next->light].shadows = next->method;
        assert_true(renderer_changed(renderer, RENDERER_LIGHTS) &&
                    renderer_changed_objects(renderer, 1, 1));
        assert_true(renderer_frame(renderer) && renderer_read(renderer, changed));
        float *anew = frame_floats(gl, scene, &how);
        assert_memory_equal(changed, anew, floats * sizeof *anew);
        free(anew);
    }
    renderer_close(renderer);
    free(changed);
    frame_forget(scene, document);
    gl_close(gl);
}

/* Only the path compute lists cells. */
static void other_paths_are_refused(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context_of(GL_KIND_osmesa);
    for (int k = 0; k < 2; k++) {
        MatcDocument *document;
        char text[4096];
        snprintf(text, sizeof text,
                 SEEN "shadowMaps: { size: 64, volume: silhouette, path: %s }\nlights: [{ light: "
                      "Directional, shadows: "
                      "hybrid }]\nobjects:\n" OBJECTS,
                 "0", k ? "copy" : "fetch");
        Scene *scene = frame_scene(text, &options, &document);
        Renderer *renderer = renderer_open(gl, &(RendererOptions){.compile = &options});
        assert_false(renderer_set_scene(renderer, scene));
        assert_string_equal(
            gl->error, "shadow volumes that silhouettes cut come by the path compute, or auto");
        renderer_close(renderer);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(triangles_close_cells),
                                       cmocka_unit_test(ends_are_near),
                                       cmocka_unit_test(the_slope_goes_on_behind_a_cut),
                                       cmocka_unit_test(glass_is_lit_as_floors_are),
                                       cmocka_unit_test(what_changes_is_as_new),
                                       cmocka_unit_test(other_paths_are_refused)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
