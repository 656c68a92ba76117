/* Tone mapping: final pixels against the formulas of scene.def in double, applied to the light
 * that is read back; the picture's statistics, by the fragment and the compute entry; black
 * pictures, light that is NaN, infinite or all in one pixel. */
/* ctest: seconds=11 */
#include "tests/test.h"
#include "gen/render_text.h"
#include "runtime/gpu_material/measure.h"
#include "runtime/renderer/renderer.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Floats of a view of a scene, from malloc; *read is the scene, whose document is kept to the
 * end. */
static float *draw(GlContext *gl, const char *text, const char *view, bool fragment)
{
    MatcOptions options;
    Scene *scene = NULL;
    matc_options_init(&options);
    MatcDocument *document = scene_read("scene.yaml", text, strlen(text), &options, &scene);
    if (!scene)
        fail_msg("%s", matc_diagnostics(document, MATC_TEXT));
    Renderer *renderer = renderer_open(
        gl, &(RendererOptions){.compile = &options, .view = view, .fragment = fragment});
    if (!renderer || !renderer_set_scene(renderer, scene) || !renderer_frame(renderer))
        fail_msg("%s", gl->error);
    float *rgba = calloc((size_t)renderer_width(renderer) * (size_t)renderer_height(renderer),
                         4 * sizeof *rgba);
    assert_non_null(rgba);
    if (!renderer_read(renderer, rgba))
        fail_msg("%s", gl->error);
    renderer_close(renderer);
    scene_free(scene);
    matc_document_free(document);
    return rgba;
}

/* -- the formulas, of a picture */

typedef struct {
    int count;
    double greatest, mean[4], log_mean, brightest, darkest; /* component 3: luminance */
} Picture;

static double luminance(const double c[3]) { return .2126 * c[0] + .7152 * c[1] + .0722 * c[2]; }

static Picture measure(const float *rgba, int count)
{
    Picture p = {.count = count, .darkest = INFINITY};
    double logs = 0;
    int bright = 0;
    for (int i = 0; i < count; i++) {
        const double c[3] = {rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]}, l = luminance(c);
        for (int component = 0; component < 3; component++) {
            p.greatest = fmax(p.greatest, c[component]);
            p.mean[component] += c[component] / count;
        }
        p.mean[3] += l / count;
        p.brightest = fmax(p.brightest, l);
        if (l <= 1e-8)
            continue;
        logs += log(l);
        p.darkest = fmin(p.darkest, l);
        bright++;
    }
    p.log_mean = bright ? logs / bright : 0;
    return p;
}

/* Numbers of a kind, as the document has them: exposure as a factor; or intensity, contrast,
 * chromatic and light adaptation; or bias. */
typedef struct {
    const char *mapping;
    SceneKind kind;
    double exposure, numbers[4];
} Mapping;

static void adapt(const Mapping *m, const Picture *p, const double c[3], double out[3])
{
    const double k = (log(p->brightest) - p->log_mean) / (log(p->brightest) - log(p->darkest));
    const double contrast = m->numbers[1] > 0 ? m->numbers[1] : .3 + .7 * pow(k, 1.4);
    for (int i = 0; i < 3; i++) {
        const double here = m->numbers[2] * c[i] + (1 - m->numbers[2]) * luminance(c);
        const double mean = m->numbers[2] * p->mean[i] + (1 - m->numbers[2]) * p->mean[3];
        const double adaptation = m->numbers[3] * here + (1 - m->numbers[3]) * mean;
        out[i] = c[i] > 0 ? c[i] / (c[i] + pow(exp(-m->numbers[0]) * adaptation, contrast)) : 0;
    }
}

/* `span`: the least and greatest that adapt() makes of the picture. */
static void map(const Mapping *m, const Picture *p, const double span[2], const double c[3],
                double out[3])
{
    const double x = luminance(c) / exp(p->log_mean) * m->exposure,
                 top = p->brightest / exp(p->log_mean) * m->exposure;
    const double drago = log(1 + x) / log(2 + 8 * pow(x / top, log(m->numbers[0]) / log(.5))) /
                         log10(1 + top) / fmax(luminance(c), 1e-30);
    const double most = fmax(fmax(c[0], c[1]), c[2]) * m->exposure;
    if (m->kind == SCENE_ReinhardDevlin)
        adapt(m, p, c, out);
    for (int i = 0; i < 3; i++) {
        const double f = c[i] * m->exposure;
        if (m->kind == SCENE_Filmic)
            out[i] = f * (2.51 * f + .03) / (f * (2.43 * f + .59) + .14);
        else if (m->kind == SCENE_Shoulder)
            out[i] = f <= m->numbers[0] ? f
                                        : 1 - (1 - m->numbers[0]) * (1 - m->numbers[0]) /
                                                  (1 + f - 2 * m->numbers[0]);
        else if (m->kind == SCENE_Exponential)
            out[i] = most > 0 ? -expm1(-most) * f / most : 0;
        else if (m->kind == SCENE_ReinhardDevlin)
            out[i] = (out[i] - span[0]) / (span[1] - span[0]);
        else
            out[i] = m->kind == SCENE_Drago    ? c[i] * drago
                     : m->kind == SCENE_Linear ? f / p->greatest
                                               : f;
    }
}

/* IEC 61966-2-1, of a value clamped to [0, 1]. */
static double encode(double c)
{
    c = fmin(fmax(c, 0), 1);
    return c <= .0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - .055;
}

static void find_span(const Mapping *m, const Picture *p, const float *rgba, double span[2])
{
    span[0] = INFINITY;
    span[1] = 0;
    for (int i = 0; m->kind == SCENE_ReinhardDevlin && i < p->count; i++) {
        double out[3];
        adapt(m, p, (double[]){rgba[4 * i], rgba[4 * i + 1], rgba[4 * i + 2]}, out);
        for (int component = 0; component < 3; component++) {
            span[0] = fmin(span[0], out[component]);
            span[1] = fmax(span[1], out[component]);
        }
    }
}

#define SIZE_TEXT "image: { width: 165, height: 119 }\n" /* no multiples of a block */
enum { PIXELS = 165 * 119 };
#define LIT                                                                                        \
    SIZE_TEXT                                                                                      \
    "lights: [{ light: Point, position: [1, -4, 4], color: [1, .8, .6], intensity: 40 }]\n"        \
    "objects: [{ object: Sphere, material: { material: Phong, diffuse: [.9, .4, .1], specular: "   \
    "1, shininess: .9 } }, "                                                                       \
    "{ object: Plane, material: { material: Phong, diffuse: .3 } }]\nsky: { material: RGBA, r: "   \
    ".1, g: .2, b: .5 }\n"

static double off_by(GlContext *gl, const Mapping *m, const float *light, bool fragment)
{
    char text[2048];
    double span[2], greatest = 0;
    snprintf(text, sizeof text, LIT "toneMapping: { toneMapping: %s }\n", m->mapping);
    float *shown = draw(gl, text, NULL, fragment);
    const Picture p = measure(light, PIXELS);
    find_span(m, &p, light, span);
    for (int i = 0; i < PIXELS; i++) {
        double out[3] = {0};
        map(m, &p, span, (double[]){light[4 * i], light[4 * i + 1], light[4 * i + 2]}, out);
        for (int component = 0; component < 3; component++)
            greatest = fmax(greatest, fabs(shown[4 * i + component] - encode(out[component])));
    }
    free(shown);
    return greatest;
}

/* Within half a step of 8 bits, plus the rounding of floats. */
static void formulas(void **state)
{
    (void)state;
    static const Mapping mappings[] = {
        {"Clamp, exposure: -2", SCENE_Clamp, .25, {0}},
        {"Filmic, exposure: 1", SCENE_Filmic, 2, {0}},
        {"Shoulder, exposure: 1", SCENE_Shoulder, 2, {.7}},
        {"Shoulder, exposure: 3, knee: .25", SCENE_Shoulder, 8, {.25}},
        {"Exponential, exposure: 1", SCENE_Exponential, 2, {0}},
        {"Linear", SCENE_Linear, 1, {0}},
        {"Linear, exposure: 3", SCENE_Linear, 8, {0}},
        {"ReinhardDevlin", SCENE_ReinhardDevlin, 1, {0, 0, 0, 1}},
        {"ReinhardDevlin, intensity: 2, contrast: .6, chromaticAdaptation: .3, lightAdaptation: "
         ".25",
         SCENE_ReinhardDevlin,
         1,
         {2, .6, .3, .25}},
        {"ReinhardDevlin, intensity: -8, chromaticAdaptation: 1, lightAdaptation: 0",
         SCENE_ReinhardDevlin,
         1,
         {-8, 0, 1, 0}},
        {"Drago", SCENE_Drago, 1, {.85}},
        {"Drago, bias: .6, exposure: 4", SCENE_Drago, 16, {.6}},
        {"Drago, bias: 1", SCENE_Drago, 1, {1}},
    };
    GlContext *gl = frame_context();
    float *light = draw(gl, LIT, "light", false);
    int faults = 0;
    for (size_t i = 0; i < sizeof mappings / sizeof *mappings; i++) {
        const double off = off_by(gl, &mappings[i], light, i % 2);
        print_message("%s: %.3f steps of 8 bits\n", mappings[i].mapping, off * 255);
        faults += !(off * 255 <= .51);
    }
    free(light);
    gl_close(gl);
    assert_int_equal(faults, 0);
}

/* -- what is measured */

/* The three texels of a picture. */
static void run(GlContext *gl, const float *rgba, const int size[2], bool compute,
                float reported[3][4])
{
    const char *const texts[] = {"#define TONE_Linear\n#define TONE_MEASURES\n", render_text_tone,
                                 NULL};
    const TextureSpec spec = {.width = size[0], .height = size[1], .components = 4, .floats = rgba};
    Store *store = store_new(gl);
    Screen screen;
    Measure made;
    const GLuint name = texture_make(gl, &spec);
    if (!store || !name || !screen_make(gl, &screen) ||
        !measure_make(store, size, compute, texts, &made))
        fail_msg("%s", gl->error);
    measure_run(&made, name, &screen);
    assert_true(framebuffer_read(gl, &made.targets[made.count - 1], 0, reported[0]));
    measure_delete(gl, &made);
    screen_delete(gl, &screen);
    gl->DeleteTextures(1, &name);
    store_free(store);
}

/* Sizes around blocks; a pixel that is no number, one that is infinite, one below 0; one that is
 * brighter than all. */
static void measured(void **state)
{
    (void)state;
    static const int sizes[][2] = {{1, 1}, {16, 16}, {17, 1}, {1, 300}, {300, 257}};
    GlContext *gl = frame_context();
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        const int count = sizes[s][0] * sizes[s][1];
        float *rgba = calloc((size_t)count * 4, sizeof *rgba), reported[3][4];
        assert_non_null(rgba);
        for (unsigned i = 0; i < 4u * (unsigned)count; i++)
            rgba[i] = i % 4 == 3 ? 1 : (float)((i * 7919 % 1009) / 1009.);
        memcpy(rgba + 4 * (count / 2), (float[]){9, 5000, .5f, 1}, 4 * sizeof *rgba);
        const Picture p = measure(rgba, count);
        for (int compute = 0; compute < 2; compute++) {
            run(gl, rgba, sizes[s], compute, reported);
            assert_true(fabs(reported[0][1] - p.greatest) <= 1e-6 * p.greatest);
            assert_true(fabs(reported[0][3] - p.brightest) <= 1e-6 * p.brightest);
            for (int component = 0; component < 4; component++)
                assert_true(fabs(reported[1][component] / count - p.mean[component]) <=
                            1e-5 * p.mean[component]);
            assert_true(fabs(reported[2][0] / reported[2][1] - p.log_mean) <=
                        1e-5 * (fabs(p.log_mean) + 1));
            assert_true(fabs(reported[2][2] - p.darkest) <= 1e-5 * p.darkest);
        }
        for (int i = 0; i < 3 && count > 3; i++)
            rgba[4 * i] = ((float[]){NAN, INFINITY, -INFINITY})[i];
        run(gl, rgba, sizes[s], true, reported);
        for (int i = 0; i < 12; i++)
            assert_true(isfinite(reported[i / 4][i % 4]));
        if (count > 3)
            assert_true(reported[0][0] == 1e18f);
        free(rgba);
    }
    gl_close(gl);
}

/* -- extremes */

/* Black stays black; one lamp that is infinite in the light's format leaves numbers, and is the
 * brightest. */
static void extremes(void **state)
{
    (void)state;
    static const char *const kinds[] = {
        "Clamp",  "Filmic",         "Shoulder", "Exponential",
        "Linear", "ReinhardDevlin", "Drago",    "Linear, exposure: 64"};
    enum { SIDE = 40 };
    GlContext *gl = frame_context();
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
        for (int bright = 0; bright < 2; bright++) {
            char text[1024];
            snprintf(text, sizeof text,
                     "image: { width: 40, height: 40 }\ncamera: { camera: Orthographic, position: "
                     "[0, -5, 0], size: 2 }\n"
                     "objects: [{ object: Box, material: { material: Phong, emissive: %s } }]\n"
                     "toneMapping: { toneMapping: %s }\n",
                     bright ? "[1e9, 1e9, 1e9]" : "0", kinds[k]);
            float *shown = draw(gl, text, NULL, k % 2);
            assert_true(shown[0] == 0);
            if (!(shown[4 * (SIDE / 2 * SIDE + SIDE / 2)] == (float)bright))
                fail_msg("%s: %g", kinds[k], shown[4 * (SIDE / 2 * SIDE + SIDE / 2)]);
            free(shown);
        }
    gl_close(gl);
}

/* -- in tiles */

static const char *const tiled[] = {"toneMapping: { toneMapping: Linear, exposure: 1 }",
                                    "toneMapping: { toneMapping: ReinhardDevlin }",
                                    "toneMapping: { toneMapping: Drago }", ""};

/* A plane to the horizon and a sky, bright on the left, dark on the right. */
static Scene *read_horizon(const char *mapping, const MatcOptions *options, MatcDocument **document)
{
    char text[1024];
    snprintf(
        text, sizeof text,
        "image: { width: 75, height: 53, tiles: true }\ncamera: { camera: Perspective, position: "
        "[0, -5, 1], "
        "target: [0, 0, 1.31] }\nmaterials: { m: { material: Phong, diffuse: [0.9, 0.3, 0.1] } }\n"
        "objects: [{ object: Plane, material: m }]\nsky: { material: RGBA, r: 0.3, g: 0.5, b: 0.7 "
        "}\n"
        "lights: [{ light: Point, position: [-3, 1, 1], intensity: 9 }]\n%s\n",
        mapping);
    return frame_scene(text, options, document);
}

/* Statistics of the whole picture are equal in tiles, up to the order of sums: with edges, which
 * take tiles that overlap, and for a scene that changes. */
static void in_tiles(void **state)
{
    (void)state;
    MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    for (int k = 0; k < 8; k++) {
        MatcDocument *document;
        Scene *scene = read_horizon(tiled[k / 2], &options, &document);
        RendererOptions how = {.compile = &options,
                               .deep = true,
                               .edges = k & 1 ? RENDERER_EDGES_coverage : RENDERER_EDGES_none,
                               .tile = {32, 18}};
        Renderer *renderer = renderer_open(gl, &how);
        float part[4 * 32 * 18];
        assert_true(renderer && renderer_set_scene(renderer, scene) && renderer_frame(renderer));
        scene->camera.position[2] = .8;
        scene->lights[0].light[0] *= 2;
        assert_true(renderer_changed(renderer, RENDERER_CAMERA) && renderer_frame(renderer));
        assert_true(renderer_changed(renderer, RENDERER_LIGHTS));
        how.tile[0] = how.tile[1] = 0;
        float *whole = frame_floats(gl, scene, &how);
        for (int y = 0; y < 53; y += 18)
            for (int x = 0; x < 75; x += 32) {
                renderer_set_tile(renderer, x, y);
                assert_true(renderer_frame(renderer) && renderer_read(renderer, part));
                for (int row = 0; row < 18 && y + row < 53; row++)
                    for (int i = 0; i < 4 * 32 && x + i / 4 < 75; i++)
                        if (!(fabsf(part[4 * 32 * row + i] - whole[4 * (75 * (y + row) + x) + i]) <=
                              4e-5f))
                            fail_msg("%s: %g, not %g", tiled[k / 2], part[4 * 32 * row + i],
                                     whole[4 * (75 * (y + row) + x) + i]);
            }
        free(whole);
        renderer_close(renderer);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(formulas),
        cmocka_unit_test(measured),
        cmocka_unit_test(extremes),
        cmocka_unit_test(in_tiles),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
