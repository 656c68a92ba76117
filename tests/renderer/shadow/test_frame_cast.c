/* Shadows of transparent casters, against Embree's rays that continue through them with the
 * oracle's transparency in double. A pixel is compared unless a shadow boundary is near: points
 * of the tangent planes of all its layers, a few texels away as each light sees them, must have
 * the same light. There a shadow map has the ray's information. */
/* ctest: unsanitized unoptimized seconds=50 */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/glass_ray.h"
#include "tests/frame_reference/reference_light.h"
#include "tests/frame_reference/shadow_ray.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* -- rays */

enum { WIDTH = 120, HEIGHT = 90, PIXELS = WIDTH * HEIGHT, FAR = 400 /* across the far ground */ };

static void shares_of(const Tracer *tracer, const SceneLight *light, const Hit *hit,
                      double shares[3])
{
    glass_shares(tracer, light, hit->world, hit->microfacet, shares);
}

/* As far as all can be seen there: the far ground is 400 deep, so cascades end at 25, 100 and 400;
 * the picture's diagonal is 1.3 of the depth. */
static double reach_of_cascade(const Scene *scene, const double point[3])
{
    double depth = 0;
    for (int i = 0; i < 3; i++)
        depth -= (point[i] - scene->camera.position[i]) * scene->camera.back[i];
    return 1.6 * (depth < 22 ? 25 : depth < 88 ? 100 : 400);
}

/* True if an object's transparency varies, so that its shadows come from maps. */
static bool has_cut_outs(const Scene *scene)
{
    bool has = false;
    for (int i = 0; i < scene->object_count; i++) {
        const SceneMaterial *material = &scene->materials[scene->objects[i].material];
        has |= !strcmp(matc_material_name(material->document, material->index), "round");
    }
    return has;
}

/* Texel width of a light's map at a point, by the documentation. Exact shadows have no map:
 * transparent surfaces are lit at a point offset by 1/64 of a pixel, 0.001. */
static double texel_at(const Scene *scene, const SceneLight *light, const double point[3])
{
    if (light->shadows == KEYWORD_Shadows_exact && !has_cut_outs(scene))
        return 0.003;
    const bool far = scene->objects[0].numbers[0] == FAR;
    const double reach = far ? reach_of_cascade(scene, point) : 11.5; /* across all objects */
    return shadow_texel(scene, light, point, reach);
}

/* True if the same light arrives at all nearby points. */
static bool is_even(const Tracer *tracer, const SceneLight *light, const Hit *hit)
{
    const double step =
        3.0 * (tracer->scene->shadow_filter + 1) * texel_at(tracer->scene, light, hit->world);
    double way[3], moved[3], shares[3], others[3];
    shadow_way_to(light, hit->world, way);
    if (reference_dot(way, hit->microfacet) * reference_dot(way, hit->normal) <= 0)
        return false; /* at the terminator of what triangles stand for */
    shares_of(tracer, light, hit, shares);
    for (int i = 0; i < 24; i++) {
        shadow_beside(hit, way, step * (i / 8 + 1) / 3, PI / 4 * i + i / 8, moved);
        glass_shares(tracer, light, moved, hit->microfacet, others);
        for (int k = 0; k < 3; k++)
            if (fabs(shares[k] - others[k]) > 1e-9)
                return false;
    }
    return true;
}

/* -- pictures */

typedef struct {
    int compared, shaded, band;
    int wrong;
    double most; /* that any is off */
} Count;

static bool are_even(const Tracer *tracer, const Hit *hits, int count)
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < tracer->scene->light_count; k++)
            if (hits[i].object >= 0 && !is_even(tracer, &tracer->scene->lights[k], &hits[i]))
                return false;
    return true;
}

static void add_pixel(const Tracer *tracer, const MatcOptions *options, int pixel,
                      const float *rgba, Count *count)
{
    Hit hits[REFERENCE_LAYERS];
    double light[3], unshaded[3], off = 0, shade = 0;
    const Ray ray = reference_ray(tracer->scene, pixel % WIDTH + .5, pixel / WIDTH + .5);
    const int layers = reference_pixel(tracer, &ray, options, light, hits);
    if (hits[0].object < 0 || reference_is_edge(tracer, pixel % WIDTH, pixel / WIDTH, hits, layers))
        return;
    if (!are_even(tracer, hits, layers)) {
        count->band++;
        return;
    }
    Tracer plain = *tracer;
    plain.shares = NULL;
    reference_pixel(&plain, &ray, options, unshaded, hits);
    for (int i = 0; i < 3; i++) {
        off = fmax(off, isnan(rgba[i]) ? INFINITY : fabs(rgba[i] - light[i]) / fmax(light[i], 1));
        shade = fmax(shade, unshaded[i] - light[i]);
    }
    count->compared++;
    count->shaded += shade > 1e-3;
    count->wrong += off > 1e-5;
    count->most = fmax(count->most, off);
}

enum { STEP = 7, TEXT = 8192 };

static Count compare(GlContext *gl, const char *text, const RendererOptions *with)
{
    MatcLayout *layout;
    MatcDocument *document;
    const MatcOptions options = frame_float_options(&layout);
    RendererOptions choice = *with;
    Count count = {0};
    Scene *scene = frame_scene(text, &options, &document);
    choice.compile = &options;
    choice.view = "light";
    float *rgba = frame_floats(gl, scene, &choice);
    Tracer tracer = reference_open(scene);
    tracer.shares = shares_of;
    for (int i = 0; i < PIXELS; i += STEP)
        add_pixel(&tracer, &options, i, rgba + 4 * (size_t)i, &count);
    reference_close(&tracer);
    free(rgba);
    frame_forget(scene, document);
    matc_layout_free(layout);
    return count;
}

#define VIEW                                                                                       \
    "image: { width: 120, height: 90 }\ncamera: { camera: Perspective, position: [1.5, -7, 4], "   \
    "target: [0, 0, .5], "                                                                         \
    "angle: 42 }\n"
#define GROUND                                                                                     \
    "objects:\n- { object: Parallelogram, u: [8, 0, 0], v: [0, 8, 0], material: m, transform: { "  \
    "translation: [-4, "                                                                           \
    "-4, 0] } }\n"
#define OBJECTS                                                                                    \
    "- { object: Sphere, radius: .8, material: round, transform: { translation: [-.6, -.4, .9] } " \
    "}\n"                                                                                          \
    "- { object: Sphere, radius: .3, material: m, transform: { translation: [-.6, -.4, .9] } }\n"  \
    "- { object: Box, material: solid, transform: { translation: [1.1, .6, .6], rotation: [0, 0, " \
    ".3] } }\n"                                                                                    \
    "- { object: Box, size: [.4, .4, .4], material: clear, transform: { translation: [.2, 1.4, "   \
    ".3] } }\n"                                                                                    \
    "- { object: Box, size: [.4, .4, .4], material: dim, transform: { translation: [.6, -1.5, "    \
    ".3] } }\n"                                                                                    \
    "- { object: Parallelogram, u: [0, 1.6, 0], v: [.4, 0, 1], material: coarse, transform: { "    \
    "translation: [-2.2, "                                                                         \
    "-.6, .1], scale: [-1, 1, 1] } }\n"                                                            \
    "- { object: Parallelogram, u: [.9, 0, 0], v: [0, .9, .1], material: coarse, transform: { "    \
    "translation: [1.3, "                                                                          \
    "-1.5, .8] } }\n"                                                                              \
    "- { object: Parallelogram, u: [.7, 0, .1], v: [0, .7, .1], material: sided, transform: { "    \
    "translation: [-1.9, "                                                                         \
    "1.1, .7] } }\n"                                                                               \
    "- { object: Parallelogram, u: [.7, 0, .1], v: [0, .7, .1], material: sided, transform: { "    \
    "translation: [-.8, "                                                                          \
    "1.4, .9], scale: [-1, 1, 1] } }\n"

/* Stacked panes, with the ground and a ball between; a clear ball with a solid inside;
 * intersecting boxes. */
#define PANES                                                                                      \
    "- { object: Parallelogram, u: [1.2, 0, 0], v: [0, 1.2, 0], material: clear, transform: { "    \
    "translation: [-.5, "                                                                          \
    "-2.2, .3] } }\n"                                                                              \
    "- { object: Parallelogram, u: [1.2, 0, 0], v: [0, 1.2, 0], material: red, transform: { "      \
    "translation: [-.5, -2.2, "                                                                    \
    ".6] } }\n"                                                                                    \
    "- { object: Parallelogram, u: [1.2, 0, 0], v: [0, 1.2, 0], material: dim, transform: { "      \
    "translation: [-.5, -2.2, "                                                                    \
    "1.1] } }\n"                                                                                   \
    "- { object: Sphere, radius: .15, material: m, transform: { translation: [.1, -1.6, .85] } "   \
    "}\n"                                                                                          \
    "- { object: Sphere, radius: .5, material: red, transform: { translation: [2.2, -.6, .6] } "   \
    "}\n"                                                                                          \
    "- { object: Box, size: .3, material: m, transform: { translation: [2.2, -.6, .6] } }\n"       \
    "- { object: Box, size: [.9, .4, .4], material: clear, transform: { translation: [-1.6, "      \
    "-1.6, .5] } }\n"                                                                              \
    "- { object: Box, size: [.4, .9, .3], material: red, transform: { translation: [-1.6, -1.6, "  \
    ".5], rotation: [.2, "                                                                         \
    ".1, .4] } }\n"

/* Infinite planes: of cells, tilted, over all; one whose sides differ, beside; and one of glass. */
#define SHEETS                                                                                     \
    "- { object: Plane, material: coarse, transform: { scale: [3, -3, 3], rotation: [.1, .05, "    \
    ".4], translation: [.3, "                                                                      \
    ".2, 3] } }\n"                                                                                 \
    "- { object: Plane, material: sided, transform: { rotation: [.1, 1.4, 0], translation: "       \
    "[-2.5, 0, 0] } }\n"                                                                           \
    "- { object: Plane, material: clear, transform: { rotation: [-1.5, 0, 0], translation: [0, "   \
    "4.5, 0] } }\n"

/* Along a wide ground, with something at every distance. */
#define FAR_VIEW                                                                                   \
    "image: { width: 120, height: 90 }\ncamera: { camera: Perspective, position: [1.5, -7, 3], "   \
    "target: [1, 0, 1.6], "                                                                        \
    "angle: 42 }\n"
#define FAR_GROUND                                                                                 \
    "objects:\n- { object: Parallelogram, u: [400, 0, 0], v: [0, 400, 0], material: m, "           \
    "transform: { translation: "                                                                   \
    "[-200, -10, 0] } }\n"                                                                         \
    "- { object: Box, size: [3, 3, 6], material: m, transform: { translation: [-6, 20, 3] } }\n"   \
    "- { object: Box, size: [3, 3, 6], material: clear, transform: { translation: [6, 14, 3.1] } " \
    "}\n"                                                                                          \
    "- { object: Box, size: [8, 8, 16], material: m, transform: { translation: [14, 60, 8] } }\n"  \
    "- { object: Box, size: [20, 20, 50], material: m, transform: { translation: [-30, 150, 25] "  \
    "} }\n"

/* A light, but for its place and direction. */
typedef struct {
    const char *name, *kind; /* and further params */
    bool placed, directed;
    const char *maps;
    int first, step; /* angles */
    bool far;        /* over a wide ground */
    /* OpenGL 3.3: objects are drawn by themselves, depth in clip space begins at -1 */
    bool old;
} Lamp;
static const Lamp lamps[] = {
    {"directional", "Directional", false, true, "filter: 0", 0, 2, false, false},
    {"spot", "Spot, innerAngle: 30, outerAngle: 45", true, true, "filter: 0", 1, 3, false, false},
    {"wide spot", "Spot, innerAngle: 80, outerAngle: 100", true, true, "filter: 1", 2, 3, false,
     false},
    {"point", "Point", true, false, "filter: 1", 1, 3, false, false},
    {"OpenGL 3.3", "Directional", false, true, "filter: 0", 2, 4, false, true}};
static const Lamp hybrids[] = {
    {"sun, hybrid", "Directional, shadows: hybrid", false, true, "filter: 0", 1, 3, false, false},
    {"spot, hybrid", "Spot, innerAngle: 30, outerAngle: 45, shadows: hybrid", true, true,
     "filter: 0, volume: plain", 2, 4, false, false},
    {"point, hybrid", "Point, shadows: hybrid", true, false, "filter: 1", 3, 2, false, false}};
static const Lamp cascaded = {"cascades", "Directional", false, true, "filter: 0, cascades: 4", 0,
                              2,          true,          false};
static const Lamp exact[] = {
    {"exact", "Directional, shadows: exact", false, true, "filter: 0", 4, 7, false, false},
    {"exact", "Point, shadows: exact", true, false, "filter: 0", 4, 7, false, false}};
static const Lamp exact_and_maps = {
    "exact, maps", "Directional, shadows: exact", false, true, "filter: 0", 4, 2, false, false};
static const Lamp uncascaded = {"one map", "Directional", false, true, "filter: 0", 2,
                                4,         true,          false};
enum { LAMPS = sizeof lamps / sizeof *lamps };

/* The light is at an angle, 6 from the origin, directed at the origin. */
static void write_scene(const Lamp *lamp, const double angle[2], const char *objects, bool colored,
                        char text[TEXT])
{
    char place[128] = "", direction[128] = "";
    double at[3];
    shadow_place(angle, 6, at);
    if (lamp->placed)
        snprintf(place, sizeof place, ", position: [%g, %g, %g], intensity: 36", at[0], at[1],
                 at[2]);
    if (lamp->directed)
        snprintf(direction, sizeof direction, ", direction: [%g, %g, %g]", -at[0], -at[1], -at[2]);
    int size = snprintf(
        text, TEXT, "%sshadowMaps: { %s, colored: %s }\nlights: [{ light: %s%s%s }]\nmaterials:\n",
        lamp->far ? FAR_VIEW : VIEW, lamp->maps, colored ? "true" : "false", lamp->kind, place,
        direction);
    for (int i = 0; i < GLASS_COUNT; i++)
        size += snprintf(text + size, (size_t)(TEXT - size), "  %s\n", glass_text(i));
    snprintf(text + size, (size_t)(TEXT - size), "%s%s", lamp->far ? FAR_GROUND : GROUND, objects);
}

static Count by_angles(const Lamp *lamp, const char *objects, bool colored,
                       const RendererOptions *options)
{
    GlContext *gl = frame_context();
    static char text[TEXT];
    if (lamp->old) {
        gl->major = gl->minor = 3;
        gl->ClipControl = NULL;
    }
    Count all = {0};
    for (int i = lamp->first; i < SHADOW_ANGLES; i += lamp->step) {
        write_scene(lamp, shadow_angles[i], objects, colored, text);
        const Count count = compare(gl, text, options);
        print_message(
            "%-12s %4g degrees: %5d compared, %5d shaded, %5d in bands; wrong %d, off by %.2g\n",
            lamp->name, shadow_angles[i][0], count.compared, count.shaded, count.band, count.wrong,
            count.most);
        all.compared += count.compared, all.shaded += count.shaded, all.wrong += count.wrong;
    }
    gl_close(gl);
    assert_true(all.compared > 700 && all.shaded > 40);
    return all;
}

static void by_every_angle(const Lamp *lamp, const char *objects, bool colored,
                           const RendererOptions *options)
{
    assert_int_equal(by_angles(lamp, objects, colored, options).wrong, 0);
}

/* Surfaces with a mean transmittance above one half cast no shadow; all others do. */
static void cut_outs(void **state)
{
    (void)state;
    for (int i = 0; i < LAMPS; i++)
        by_every_angle(&lamps[i], OBJECTS, false, &(RendererOptions){0});
}

/* Light is multiplied by the transmittance of surfaces in front of the light, and by no other. */
static void colors(void **state)
{
    (void)state;
    for (int i = 0; i < LAMPS; i++)
        if (!lamps[i].old)
            by_every_angle(&lamps[i], OBJECTS PANES, true, &(RendererOptions){.fragment = i == 1});
}

/* Casters that volumes cannot represent are looked up in maps, on opaque and on transparent
 * surfaces. */
static void colors_beside_volumes(void **state)
{
    (void)state;
    for (int i = 0; i < 3; i++)
        by_every_angle(&hybrids[i], OBJECTS PANES, true, &(RendererOptions){0});
}

/* Where there are no lists, volumes have no cut-outs, and the statistics say so. */
static void cut_outs_beside_volumes(void **state)
{
    (void)state;
    static const char *const words[2] = {"method hybrid: shadows are not colored\n",
                                         "method hybrid: needs OpenGL 4.3\n"};
    static char text[TEXT];
    for (int old = 0; old < 2; old++) {
        GlContext *gl = frame_context();
        MatcDocument *document;
        const MatcOptions options = frame_exact_options();
        gl->major = old ? 3 : gl->major;
        gl->minor = old ? 3 : gl->minor;
        write_scene(&hybrids[0], shadow_angles[3], OBJECTS, old, text);
        Scene *scene = frame_scene(text, &options, &document);
        char *reported = frame_graph_or_fault(gl, scene, &(RendererOptions){.compile = &options});
        assert_non_null(strstr(reported, words[old]));
        free(reported);
        frame_forget(scene, document);
        gl_close(gl);
    }
}

/* Colored shadows if lists of the maps, with 1 and 25 MB of heads alone, find room only in parts:
 * beside lists of pixels and while peeling. */
static void colors_in_parts(void **state)
{
    (void)state;
    static const Lamp divided[] = {
        {"directional", "Directional", false, true, "size: 512, filter: 0", 2, 4, false, false},
        {"point", "Point", true, false, "size: 1024, filter: 1", 1, 3, false, false}};
    for (int i = 0; i < 2; i++)
        by_every_angle(&divided[i], OBJECTS PANES, true,
                       &(RendererOptions){.list_bytes = i ? 5000000 : 700000,
                                          .transparency = i ? "peeling" : "lists"});
}

/* Varying transmittance of an infinite plane is evaluated for each direction to a light, without a
 * map: in colors, and all or nothing. */
static void sheets(void **state)
{
    (void)state;
    static const struct {
        int lamp, angle;
        bool colored;
        RendererOptions options;
    } cases[] = {{0, 4, true, {0}},
                 {1, 4, false, {.fragment = true}},
                 {2, 5, true, {.transparency = "peeling"}},
                 {3, 1, true, {.list_bytes = 9000000}}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Lamp lamp = lamps[cases[i].lamp];
        lamp.first = cases[i].angle;
        lamp.step = SHADOW_ANGLES;
        by_every_angle(&lamp, OBJECTS SHEETS, cases[i].colored, &cases[i].options);
    }
}

/* In each cascade the error is that of its texels; a single map has a greater error. */
static void cascades(void **state)
{
    (void)state;
    by_every_angle(&cascaded, OBJECTS, true, &(RendererOptions){0});
    assert_true(by_angles(&uncascaded, OBJECTS, true, &(RendererOptions){0}).wrong > 0);
}

/* Casters of constant transmittance are as exact as opaque ones: up to 0.01 from ends of shadows,
 * where maps end at 0.07 and more. */
static void exact_colors(void **state)
{
    (void)state;
    for (int i = 0; i < 4; i++)
        by_every_angle(&exact[i % 2], PANES, i < 2,
                       &(RendererOptions){.transparency = i % 2 ? "peeling" : "lists"});
    by_every_angle(&exact_and_maps, OBJECTS PANES, true, &(RendererOptions){0});
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(cut_outs),
        cmocka_unit_test(colors),
        cmocka_unit_test(colors_in_parts),
        cmocka_unit_test(colors_beside_volumes),
        cmocka_unit_test(cut_outs_beside_volumes),
        cmocka_unit_test(sheets),
        cmocka_unit_test(cascades),
        cmocka_unit_test(exact_colors),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
