/* Shadows against Embree's rays, for each kind of light, from straight above to half a degree
 * over the ground. The quotient of a picture with shadows and one without is the share of light
 * that arrives. It must equal the ray's away from shadow boundaries: where points of the
 * surface's tangent plane, a few texels away as seen by the light, all agree. A wrongly lit
 * pixel there is a light leak, a wrongly dark one is shadow acne. */
/* ctest: unsanitized */
#include "tests/test.h"
#include "tests/frame/shadow_band.h"
#include "tests/frame/shadow_scene.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* -- pictures */

enum { WIDTH = 120, HEIGHT = 90, PIXELS = WIDTH * HEIGHT };
static const double REACH = 11.5; /* width of all objects of a scene, approximately */

#define VIEW "image: { width: 120, height: 90 }\n" SHADOW_SCENE_VIEW

typedef struct {
    int lit, dark;   /* compared, outside of bands */
    int band;        /* within */
    int acne, leaks; /* wrong ones */
} Count;

/* Radius in texels around a point within which all rays have to agree. */
static double band_of(const Scene *scene) { return 3.0 * (scene->shadow_filter + 1); }

/* The true share of light: 0 or 1; -1 near a shadow boundary. */
static int share_of(const Tracer *tracer, const Hit *hit)
{
    const double texel = shadow_texel(tracer->scene, &tracer->scene->lights[0], hit->world, REACH);
    return shadow_band_expected(tracer, hit, band_of(tracer->scene) * texel);
}

static void add_pixel(const Tracer *tracer, int pixel, double share, Count *count)
{
    const Ray ray = reference_ray(tracer->scene, pixel % WIDTH + .5, pixel / WIDTH + .5);
    const Hit hit = reference_hit(tracer, &ray, 0);
    if (hit.object < 0 || !shadow_sides_agree(&tracer->scene->lights[0], &hit) ||
        reference_is_edge(tracer, pixel % WIDTH, pixel / WIDTH, &hit, 1))
        return;
    const int expected = share_of(tracer, &hit);
    count->band += expected < 0;
    count->lit += expected == 1;
    count->dark += expected == 0;
    count->acne += expected == 1 && share < 1 - 1e-3;
    count->leaks += expected == 0 && share > 1e-3;
}

static Count compare(GlContext *gl, const char *text,
                     void (*add)(const Tracer *, int, double, Count *))
{
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    Count count = {0};
    Scene *scene = frame_scene(text, &options, &document);
    float *with = frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = "light"});
    float *without = frame_floats(
        gl, scene, &(RendererOptions){.compile = &options, .view = "light", .no_shadows = true});
    Tracer tracer = reference_open(scene);
    for (int i = 0; i < PIXELS; i++)
        if (without[4 * i] > 1e-7f)
            add(&tracer, i, (double)with[4 * i] / without[4 * i], &count);
    reference_close(&tracer);
    free(with);
    free(without);
    frame_forget(scene, document);
    return count;
}

/* A light, but for its place and direction. */
typedef struct {
    const char *kind; /* and further params */
    bool placed, directed;
} Lamp;

/* Draws with the light at an angle, 6 from the origin, directed at the origin. */
static Count at_angle(GlContext *gl, const Lamp *lamp, const double angle[2], const char *objects,
                      const char *maps)
{
    char text[4096], place_text[128] = "", direction_text[128] = "";
    double at[3];
    shadow_place(angle, 6, at);
    if (lamp->placed)
        snprintf(place_text, sizeof place_text, ", position: [%g, %g, %g]", at[0], at[1], at[2]);
    if (lamp->directed)
        snprintf(direction_text, sizeof direction_text, ", direction: [%g, %g, %g]", -at[0], -at[1],
                 -at[2]);
    snprintf(text, sizeof text,
             VIEW "shadowMaps: %s\nlights: [{ light: %s%s%s }]\n%s" SHADOW_SCENE_OBJECTS(""), maps,
             lamp->kind, place_text, direction_text, objects);
    return compare(gl, text, add_pixel);
}

static void by_every_angle(const char *name, const Lamp *lamp, const char *objects,
                           const char *maps)
{
    GlContext *gl = frame_context();
    Count all = {0};
    for (size_t i = 0; i < sizeof shadow_angles / sizeof *shadow_angles; i++) {
        const Count count = at_angle(gl, lamp, shadow_angles[i], objects, maps);
        all.lit += count.lit, all.dark += count.dark, all.band += count.band;
        all.acne += count.acne, all.leaks += count.leaks;
        print_message("%-12s %4g degrees: %5d lit, %5d dark, %5d in bands; acne %d, leaks %d\n",
                      name, shadow_angles[i][0], count.lit, count.dark, count.band, count.acne,
                      count.leaks);
    }
    gl_close(gl);
    assert_true(all.lit > 8000 && all.dark > 2000);
    assert_int_equal(all.acne, 0);
    assert_int_equal(all.leaks, 0);
}

#define HARD "{ size: 1024, filter: 0 }"

static void directional(void **state)
{
    (void)state;
    by_every_angle("directional", &(Lamp){"Directional", false, true}, SHADOW_SCENE_GROUND, HARD);
}

static void spot(void **state)
{
    (void)state;
    by_every_angle("spot", &(Lamp){"Spot, innerAngle: 30, outerAngle: 45", true, true},
                   SHADOW_SCENE_GROUND, HARD);
}

static void wide_spot(void **state)
{
    (void)state;
    by_every_angle("wide spot", &(Lamp){"Spot, innerAngle: 80, outerAngle: 100", true, true},
                   SHADOW_SCENE_PLANE, HARD);
}

static void point(void **state)
{
    (void)state;
    by_every_angle("point", &(Lamp){"Point", true, false}, SHADOW_SCENE_GROUND, HARD);
}

/* Edges that are spread do not spread acne. */
static void filtered(void **state)
{
    (void)state;
    by_every_angle("filter 1", &(Lamp){"Directional", false, true}, SHADOW_SCENE_GROUND,
                   "{ filter: 1 }");
    by_every_angle("filter 3", &(Lamp){"Point", true, false}, SHADOW_SCENE_PLANE, "{ filter: 3 }");
}

/* -- where the eye is the light, all that is seen is lit */

/* True if a neighbor pixel is far behind or in front: within a texel, the map may contain either
 * depth. Touching meshes make no step. */
static bool has_step(const Tracer *tracer, int pixel, const Hit *hit)
{
    for (int k = 0; k < 9; k++) {
        const Ray ray =
            reference_ray(tracer->scene, pixel % WIDTH + k % 3 - .5, pixel / WIDTH + k / 3 - .5);
        const Hit other = reference_hit(tracer, &ray, 0);
        if (other.object < 0 || (other.object != hit->object &&
                                 fabs(other.distance - hit->distance) > .03 * hit->distance))
            return true;
    }
    return false;
}

/* Counts pixels without a step that are not fully lit. */
static void add_dark(const Tracer *tracer, int pixel, double share, Count *count)
{
    const Ray ray = reference_ray(tracer->scene, pixel % WIDTH + .5, pixel / WIDTH + .5);
    const Hit hit = reference_hit(tracer, &ray, 0);
    if (hit.object < 0 || has_step(tracer, pixel, &hit))
        return;
    count->lit++;
    count->acne += share < 1 - 1e-3;
}

static void seen_from_the_light(void **state)
{
    (void)state;
    static const char *const lamps[] = {
        "Point", "Spot, direction: [-1.5, 7, -3.5], innerAngle: 40, outerAngle: 44"};
    GlContext *gl = frame_context();
    for (int filter = 0; filter < 4; filter++)
        for (int i = 0; i < 2; i++) {
            char text[4096];
            snprintf(text, sizeof text,
                     VIEW "shadowMaps: { filter: %d }\nlights: [{ light: %s, position: [1.5, -7, "
                          "4] }]\n" SHADOW_SCENE_GROUND SHADOW_SCENE_OBJECTS(""),
                     filter, lamps[i]);
            const Count count = compare(gl, text, add_dark);
            print_message("filter %d, %.5s: %d lit, acne %d\n", filter, lamps[i], count.lit,
                          count.acne);
            assert_true(count.lit > 4000);
            assert_int_equal(count.acne, 0);
        }
    gl_close(gl);
}

/* -- what is drawn, and when */

#define LAMPS "lights: [{ light: Point, position: [1, -4, 4], intensity: 9, shadows: %s }]\n"

static char *graph_of(GlContext *gl, const char *switched, bool none)
{
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    char text[4096];
    snprintf(text, sizeof text, VIEW LAMPS SHADOW_SCENE_GROUND SHADOW_SCENE_OBJECTS(""), switched);
    Scene *scene = frame_scene(text, &options, &document);
    Renderer *renderer =
        renderer_open(gl, &(RendererOptions){.compile = &options, .no_shadows = none});
    assert_true(renderer && renderer_set_scene(renderer, scene));
    char *graph = frame_graph(renderer);
    renderer_close(renderer);
    frame_forget(scene, document);
    return graph;
}

/* Where no light casts shadows, there are no maps. */
static void switches(void **state)
{
    (void)state;
    static const struct {
        const char *switched;
        bool none, maps;
    } cases[] = {{"true", false, true}, {"false", false, false}, {"true", true, false}};
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char *graph = graph_of(gl, cases[i].switched, cases[i].none);
        assert_int_equal(strstr(graph, "6 maps of 1024 x 1024, DEPTH32F, 25165824 bytes") != NULL,
                         cases[i].maps);
        assert_int_equal(strstr(graph, "shadow - shadow not run: nothing to do") == NULL,
                         cases[i].maps);
        free(graph);
    }
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(directional),
        cmocka_unit_test(spot),
        cmocka_unit_test(wide_spot),
        cmocka_unit_test(point),
        cmocka_unit_test(seen_from_the_light),
        cmocka_unit_test(filtered),
        cmocka_unit_test(switches),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
