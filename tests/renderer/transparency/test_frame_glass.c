/* Transparent surfaces: layers against their closed form, scenes against the reference,
 * per-pixel lists against depth peeling; lists whose memory is too small. */
/* ctest: unsanitized unoptimized seconds=35 */
#include "tests/test.h"
#include "tests/frame/frame_compare.h"
#include "tests/frame/frame_draw.h"
#include <stdio.h>
#include <string.h>

enum { SIZE = 8, MAX_LAYERS = 40 };

/* -- panes before the eye, against the sum in closed form */

typedef struct {
    double light[3], through[3];
} Pane;

static double between(double low, double high) { return low + (high - low) * rand() / RAND_MAX; }

static void random_panes(Pane *panes, int count)
{
    for (int i = 0; i < count; i++)
        for (int k = 0; k < 3; k++) {
            panes[i].light[k] = floor(between(0, 256)) / 256;
            panes[i].through[k] = floor(between(160, 256)) / 256;
        }
}

/* Panes at z = count, count - 1, ..., which emit light, before a sky, in an order that is mixed. */
static void write_panes(const Pane *panes, int count, char *text, size_t capacity)
{
    int order[MAX_LAYERS];
    size_t size = (size_t)snprintf(
        text, capacity,
        "image: { width: 8, height: 8 }\ncamera: { camera: Perspective, position: [0, 0, "
        "60], up: [0, 1, 0], angle: 30 }\n"
        "sky: { material: RGBA, r: .25, g: .5, b: .75 }\nobjects:\n");
    for (int i = 0; i < count; i++)
        order[i] = i;
    for (int i = count - 1; i > 0; i--) {
        const int k = rand() % (i + 1), kept = order[i];
        order[i] = order[k];
        order[k] = kept;
    }
    for (int i = 0; i < count; i++) {
        const Pane *p = &panes[order[i]];
        size += (size_t)snprintf(text + size, capacity - size,
                                 "- { object: Parallelogram, u: [80, 0, 0], v: [0, 80, 0], "
                                 "transform: { translation: [-40, -40, %d] }, "
                                 "material: "
                                 "{ material: Phong, diffuse: 0, emissive: [%.8f, %.8f, %.8f], "
                                 "transparency: [%.8f, %.8f, %.8f] } }\n",
                                 count - order[i], p->light[0], p->light[1], p->light[2],
                                 p->through[0], p->through[1], p->through[2]);
    }
}

static void closed_form(const Pane *panes, int count, double sum[3])
{
    for (int k = 0; k < 3; k++) {
        double passes = 1;
        sum[k] = 0;
        for (int i = 0; i < count; i++) {
            sum[k] += passes * panes[i].light[k];
            passes *= panes[i].through[k];
        }
        sum[k] += passes * .25 * (k + 1);
    }
}

/* Greatest difference of any pixel from a color. */
static double farthest(const float *rgba, int pixels, const double color[3])
{
    double greatest = 0;
    for (int i = 0; i < 4 * pixels; i++)
        if (i % 4 < 3)
            greatest = fmax(greatest, isnan(rgba[i]) ? INFINITY : fabs(rgba[i] - color[i % 4]));
    return greatest;
}

/* Hides features of OpenGL 4.3 and later that the renderer queries. */
static void grow_old(GlContext *gl)
{
    gl->major = gl->minor = 3;
    gl->ClipControl = NULL;
}

typedef struct {
    const char *name;
    RendererOptions options;
    bool old, other; /* other: it has no program over all pixels in common with the first */
} Way;
static const Way ways[] = {
    {"lists", {.transparency = "lists"}, false, false},
    {"lists, fragments", {.transparency = "lists", .fragment = true}, false, false},
    {"peeling", {.transparency = "peeling"}, false, false},
    {"peeling, fragments", {.transparency = "peeling", .fragment = true}, false, true},
    {"OpenGL 3.3", {0}, true, false},
    {"no room", {.list_bytes = 1000}, false, false}};
enum { WAYS = sizeof ways / sizeof *ways };

/* A renderer for each way, which is opened when it is needed and draws all that is drawn so:
 * compiling takes longest here. */
static struct {
    MatcLayout *layout;
    MatcOptions options;
    GlContext *gl[WAYS];
    Renderer *renderer[WAYS];
} all;

static int set_up(void **state)
{
    (void)state;
    all.options = frame_float_options(&all.layout);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    for (int i = 0; i < WAYS; i++) {
        if (all.gl[i])
            gl_use(all.gl[i]);
        renderer_close(all.renderer[i]);
        gl_close(all.gl[i]);
    }
    matc_layout_free(all.layout);
    return 0;
}

/* A context each: that of old drivers is another. */
static void open_way(int way)
{
    RendererOptions options = ways[way].options;
    options.compile = &all.options;
    options.view = "light";
    options.no_shadows = true;
    all.gl[way] = frame_context();
    if (ways[way].old)
        grow_old(all.gl[way]);
    all.renderer[way] = renderer_open(all.gl[way], &options);
}

/* The light of a scene, by one of the ways. */
static float *draw_by(int way, const Scene *scene)
{
    if (!all.gl[way])
        open_way(way);
    gl_use(all.gl[way]);
    return frame_floats_by(all.gl[way], all.renderer[way], scene);
}

static void layers_are_their_closed_form(void **state)
{
    (void)state;
    static const struct {
        int count;
        double bound;
    } cases[] = {{1, 1e-6}, {10, 1e-6}, {40, 1e-5}};
    static char text[1 << 15];
    Pane panes[MAX_LAYERS];
    srand(1);
    for (size_t i = 0; i < WAYS * sizeof cases / sizeof *cases; i++) {
        const int count = cases[i / WAYS].count;
        double expected[3];
        MatcDocument *document;
        random_panes(panes, count);
        write_panes(panes, count, text, sizeof text);
        closed_form(panes, count, expected);
        Scene *scene = frame_scene(text, &all.options, &document);
        float *rgba = draw_by((int)(i % WAYS), scene);
        const double off = farthest(rgba, SIZE * SIZE, expected);
        print_message("%2d layers, %-18s off by %.2g\n", count, ways[i % WAYS].name, off);
        assert_true(off <= cases[i / WAYS].bound);
        free(rgba);
        frame_forget(scene, document);
    }
}

/* -- packing of each target format in the lists */

#define BYTES                                                                                      \
    "{ slot: normal, encoding: octahedral, bits: 8 }, "                                            \
    "{ slot: emissive, encoding: unorm, bits: 8 }, "                                               \
    "{ slot: transparency, encoding: unorm, bits: 8 }"
#define WORDS                                                                                      \
    "{ slot: normal, encoding: octahedral, bits: 8 }, "                                            \
    "{ slot: emissive, encoding: unorm, bits: 16 }, "                                              \
    "{ slot: transparency, encoding: unorm, bits: 16 }"

/* 8 and 16 bits store fifths exactly. The expected red is .2 + .8 * .6 + .8 * .4 * .25 = .76, and
 * the other components follow likewise. The picture has half floats, which round each pane's sum by
 * 2^-12 at most. */
static void lists_hold_words_of_each_format(void **state)
{
    (void)state;
    static const char *const layouts[] = {
        "layout: few\ntargets: [RGBA16UI]\nfields: [" BYTES "]\n",
        "layout: few\ntargets: [RGBA16UI, RGBA16UI]\nfields: [" WORDS "]\n",
        "layout: few\ntargets: [RG32UI]\nfields: [" BYTES "]\n",
        "layout: few\ntargets: [R32UI, R32UI]\nfields: [" BYTES "]\n",
        "layout: few\ntargets: [R32UI, RGBA16UI, R32UI]\nfields: [" WORDS "]\n",
        "layout: few\ntargets: [RGBA32UI]\nfields: [" WORDS "]\n",
    };
    static const Pane panes[] = {{{.2, .4, .8}, {.8, .6, .2}}, {{.6, .4, .2}, {.4, .8, .6}}};
    static const double expected[] = {.76, .88, .93};
    static char text[1 << 15];
    write_panes(panes, 2, text, sizeof text);
    for (size_t i = 0; i < sizeof layouts / sizeof *layouts; i++) {
        MatcOptions options = frame_exact_options();
        options.layout = NULL;
        MatcLayout *layout = matc_layout_read("few.yaml", layouts[i], strlen(layouts[i]), &options);
        if (!matc_layout_ok(layout))
            fail_msg("%s", matc_layout_diagnostics(layout, MATC_TEXT));
        options.custom = layout;
        MatcDocument *document;
        Scene *scene = frame_scene(text, &options, &document);
        GlContext *gl = frame_context();
        const RendererOptions with = {
            .compile = &options, .view = "light", .transparency = "lists", .no_shadows = true};
        float *rgba = frame_floats(gl, scene, &with);
        const double off = farthest(rgba, SIZE * SIZE, expected);
        print_message("%s off by %.2g\n", layouts[i], off);
        assert_true(off <= 2 * exp2(-12));
        free(rgba);
        gl_close(gl);
        frame_forget(scene, document);
        matc_layout_free(layout);
    }
}

/* -- two at one depth */

#define PANE                                                                                       \
    "- { object: Parallelogram, u: [80, 0, 0], v: [0, 80, 0], transform: { translation: [-40, "    \
    "-40, %d] }, material: "                                                                       \
    "%s }\n"
static const char before_sky[] = "image: { width: 8, height: 8 }\ncamera: { camera: Perspective, "
                                 "position: [0, 0, 60], up: [0, 1, 0], angle: 30 }\n"
                                 "sky: { material: RGBA, r: .25, g: .5, b: .75 }\nobjects:\n";
static const char clear_pane[] = "{ material: Phong, diffuse: 0, transparency: [.5, .25, 1] }";
static const char bright_pane[] = "{ material: Phong, diffuse: 0, emissive: .5, transparency: .5 }";
static const char nothing_pane[] = "{ material: Phong, diffuse: 0, transparency: 1 }";

/* Two panes at one depth, behind `before` panes without effect. */
static float *draw_two(int way, const char *const materials[2], int before)
{
    char text[1 << 13];
    MatcDocument *document;
    size_t size = (size_t)snprintf(text, sizeof text, "%s", before_sky);
    for (int i = 0; i < 2; i++)
        size += (size_t)snprintf(text + size, sizeof text - size, PANE, 1, materials[i]);
    for (int i = 0; i < before; i++)
        size += (size_t)snprintf(text + size, sizeof text - size, PANE, 2 + i, nothing_pane);
    assert_true(size < sizeof text);
    Scene *scene = frame_scene(text, &all.options, &document);
    float *rgba = draw_by(way, scene);
    frame_forget(scene, document);
    return rgba;
}

/* Both count, one of them in front of the other: equal ones, too. By lists, which it is does not
 * depend on the order of the objects. */
static void none_of_equal_depth_is_lost(void **state)
{
    (void)state;
    static const double alike[3] = {.0625, .03125, .75};
    static const double either[2][3] = {{.5625, .5625, .875}, {.3125, .1875, .875}};
    static const int before[] = {0, 14, 15, 16, 33}; /* lists are sorted in parts of 16 */
    enum { BEFORE = sizeof before / sizeof *before };
    for (int i = 0; i < WAYS * BEFORE; i++) {
        const int way = i / BEFORE, count = before[i % BEFORE];
        const char *order = ways[way].options.transparency;
        float *same = draw_two(way, (const char *[]){clear_pane, clear_pane}, count);
        float *one = draw_two(way, (const char *[]){clear_pane, bright_pane}, count);
        float *other = draw_two(way, (const char *[]){bright_pane, clear_pane}, count);
        assert_true(farthest(same, SIZE * SIZE, alike) <= 1e-6);
        assert_true(farthest(one, SIZE * SIZE, either[0]) <= 1e-6 ||
                    farthest(one, SIZE * SIZE, either[1]) <= 1e-6);
        if (order && !strcmp(order, "lists"))
            assert_memory_equal(one, other, SIZE * SIZE * 4 * sizeof *one);
        free(same);
        free(one);
        free(other);
    }
}

/* -- against the reference */

#define CAMERA                                                                                     \
    "image: { width: 300, height: 200 }\ncamera: { camera: Perspective, position: [2.5, -6, "      \
    "2.5], target: [0, 0, "                                                                        \
    ".5], "                                                                                        \
    "angle: 30 }\n"
/* A small picture for scenes whose reference is slow. */
#define SMALL                                                                                      \
    "image: { width: 180, height: 120 }\ncamera: { camera: Perspective, position: [2.5, -6, "      \
    "2.5], target: [0, 0, "                                                                        \
    ".5], "                                                                                        \
    "angle: 30 }\n"
#define LIGHTS                                                                                     \
    "lights: [{ light: Point, position: [1, -4, 4], color: [1, .8, .6], intensity: 12 }, { "       \
    "light: Point, position: "                                                                     \
    "[-1, 5, 3], intensity: 5 }, { light: Ambient, intensity: .5 }]\n"
#define SKY  "sky: { material: RGBA, r: .1, g: .2, b: .5 }\n"
#define MATT "{ material: Phong, diffuse: [.8, .6, .4] }"

static const struct {
    const char *name, *text;
    /* lobes of area lights take 20 s to compile: drawn in two ways, without a program in common */
    bool costly;
} pictures[] = {
    {"nested",
     CAMERA LIGHTS SKY
     "objects: [{ object: Plane, material: " MATT ", transform: { translation: [0, 0, -.2] } }, "
     "{ object: Box, size: [2, 2, 2], material: { material: RGBA, r: 1, g: .5, b: .2, a: .4 }, "
     "transform: { translation: "
     "[0, 0, 1] } }, { object: Box, size: 1.3, material: { material: Phong, diffuse: [.2, .4, 1], "
     "transparency: [.5, .7, "
     ".9], specular: .5, ambient: .2, shininess: .7 }, transform: { translation: [0, 0, 1], "
     "rotation: [.2, .3, .4] } }, "
     "{ object: Sphere, radius: .4, material: " MATT ", transform: { translation: [0, 0, 1] } }]\n",
     false},
    {"crossing",
     CAMERA LIGHTS
     "objects: [{ object: Box, size: [2, 1, 1], material: { material: RGBA, r: 1, a: .5 } }, "
     "{ object: Box, size: [1, 2, 1], material: { material: RGBA, g: 1, a: .3 }, transform: { "
     "rotation: [.1, .2, .3] } "
     "}, "
     "{ object: Cylinder, radius: .6, height: 2, material: { material: Phong, diffuse: .5, "
     "transparency: [.9, .2, .6], "
     "interpolatedTransparency: false }, transform: { translation: [0, 0, -.7], scale: [-1, 1, 1] "
     "} }]\n",
     false},
    {"checkered",
     CAMERA LIGHTS SKY
     "objects: [{ object: Plane, material: " MATT ", transform: { translation: [0, 0, -.2] } }, "
     "{ object: Box, size: 2, transform: { translation: [0, 0, 1] }, material: { material: Phong, "
     "diffuse: [.3, .5, .7], "
     "transparency: { map: Checker, color1: [1, 1, .5], color2: 0, input: { map: UVTransform, "
     "scaleU: 3, scaleV: 3 } } } "
     "}]\n",
     false},
    {"plane",
     CAMERA LIGHTS SKY "objects: [{ object: Plane, material: { material: Phong, diffuse: [.1, .3, "
                       ".3], specular: .5, transparency: [.3, "
                       ".6, .6] } }, { object: Sphere, material: " MATT
                       " }, { object: Box, size: [3, .5, .5], material: { material: RGBA, "
                       "a: .5 } }]\n",
     false},
    {"from behind",
     CAMERA
     "lights: [{ light: Point, position: [-1, 3, 0], intensity: 30 }]\n"
     "objects: [{ object: Sphere, material: { material: Phong, diffuse: .3, transparency: [.5, "
     ".6, .7], transparencyShininess: .3, diffuseTransparency: [.2, .3, .4] } }]\n",
     false},
    {"lamp",
     SMALL "lights: [{ light: Area, position: [-1, 2, .5], u: [2, 0, 0], v: [0, 0, 1.5], "
           "intensity: 4, shadows: none }, "
           "{ light: Area, position: [-2, -4, 0], u: [0, 0, 2], v: [2, 0, 0], intensity: 3, "
           "bothSides: true, shadows: none "
           "}]\n"
           "objects: [{ object: Parallelogram, u: [3, 0, 0], v: [0, 0, 2], transform: { "
           "translation: [-1.5, 0, "
           "-.5] }, material: { material: Phong, diffuse: .5, specular: .4, shininess: .5, "
           "transparency: [.3, .5, "
           ".7], transparencyShininess: .7, diffuseTransparency: [.2, .1, .3] } }]\n",
     true},
};
enum { PICTURES = sizeof pictures / sizeof *pictures };

/* Pixel by pixel, edges too: all ways have the same fragments. What is off is rounding, which each
 * layer that is peeled has more of. */
static void agree(int picture, int way, const Scene *scene, const float *first)
{
    const size_t components = (size_t)scene->width * (size_t)scene->height * 4;
    float *rgba = draw_by(way, scene);
    size_t apart = 0;
    for (size_t component = 0; component < components; component++)
        apart += !(fabsf(first[component] - rgba[component]) <=
                   2e-6f * fmaxf(fabsf(first[component]), 1));
    if (apart)
        fail_msg("%s, %s: %zu components", pictures[picture].name, ways[way].name, apart);
    free(rgba);
}

static void scenes_are_the_reference_by_all_ways(void **state)
{
    (void)state;
    static Spread spread;
    int faults = 0;
    for (int i = 0; i < PICTURES; i++) {
        MatcDocument *document;
        Scene *scene = frame_scene(pictures[i].text, &all.options, &document);
        float *first = draw_by(0, scene);
        compare(scene, &all.options, first, &spread);
        faults += !is_close(pictures[i].name, 2e-6, &spread);
        for (int way = 1; way < WAYS; way++)
            /* old: its depth is another */
            if (!ways[way].old && (!pictures[i].costly || ways[way].other))
                agree(i, way, scene, first);
        free(first);
        frame_forget(scene, document);
    }
    assert_int_equal(faults, 0);
}

/* -- what there is no room for */

static void capacity(void **state)
{
    (void)state;
    static const struct {
        RendererOptions options;
        const char *reported; /* by the graph, or of the fault */
    } cases[] = {
        {{.transparency = NULL}, "a buffer 4, and 16 a fragment: 624 bytes for 24"},
        {{.list_bytes = 624}, "a buffer 4, and 16 a fragment: 624 bytes for 24"},
        {{.list_bytes = 623}, "lists depth lists not run: nothing to do"},
        {{.list_bytes = 8}, "lists depth lists not run: nothing to do"},
        {{.transparency = "peeling"}, "lists depth lists not run: nothing to do"},
        {{.transparency = "lists", .list_bytes = 623},
         "24 transparent fragments take 624 bytes in lists, and there may be 623"},
        {{.transparency = "blend"}, "transparency is auto, lists or peeling, not 'blend'"},
    };
    MatcOptions options = frame_exact_options();
    options.layout = NULL; /* the smallest */
    MatcDocument *document;
    /* A pane over three rows of eight pixels: four words, the heads of all pixels, four words for
     * each fragment. */
    Scene *scene = frame_scene("image: { width: 8, height: 7 }\ncamera: { camera: Orthographic, "
                               "position: [0, 0, 60], up: [0, 1, 0], size: 7, "
                               "depth: 100 }\nobjects:\n"
                               "- { object: Parallelogram, u: [8, 0, 0], v: [0, 3, 0], transform: "
                               "{ translation: [-4, -3.5, 1] }, "
                               "material: { material: Phong, diffuse: [.2, .3, .4], specular: .5, "
                               "shininess: { map: Checker }, transparency: "
                               "[.1, .2, .3], ambient: [.1, .2, .3] } }\n",
                               &options, &document);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        GlContext *gl = frame_context();
        RendererOptions with = cases[i].options;
        with.compile = &options;
        char *reported = frame_graph_or_fault(gl, scene, &with);
        if (!strstr(reported, cases[i].reported))
            fail_msg("%s", reported);
        free(reported);
        gl_close(gl);
    }
    frame_forget(scene, document);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(layers_are_their_closed_form),
        cmocka_unit_test(lists_hold_words_of_each_format),
        cmocka_unit_test(none_of_equal_depth_is_lost),
        cmocka_unit_test(scenes_are_the_reference_by_all_ways),
        cmocka_unit_test(capacity),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
