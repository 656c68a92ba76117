/* Principled balls in the sun against Cycles' Principled: tests/reference/README.md. Both use
 * GGX with height-correlated masking and multiple scattering. The Fresnel terms differ:
 * Schlick's here, a dielectric's of index 1.5 in Cycles, from the same color to white. The
 * single-scattered light is converted from one to the other by the angle between light and
 * microfacet normal, half of the angle between light and eye. */
/* ctest: alone */
#include "tests/frame/frame_compare.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/reference_picture.h"
#include "tests/frame_reference/reference_ray.h"
#include <stdio.h>
#include <string.h>

enum { WIDTH = 192, HEIGHT = 144, PIXELS = WIDTH * HEIGHT, BALLS = 12, TEXT = 8000 };
#define DOCUMENT SOURCE_FOLDER "/tests/reference/cycles/principled.yaml"

static const double colors[3][3] = {{1, 1, 1}, {.9, .5, .3}, {.04, .04, .04}},
                    roughnesses[4] = {.25, .5, .75, 1};

#define AGAIN                                                                                      \
    .85 /* what light that is reflected again may be off by: set by what is seen, where both lobes \
           are lawful and none is the truth for the other */
#define STEP 3e-4 /* Cycles' noise, and 2^-14 of its file */

/* The document, every `from` of its text replaced by a `to`; none where that is empty. */
static Scene *open_scene(const char *from, const char *to, const MatcOptions *options,
                         MatcDocument **document)
{
    char whole[TEXT] = "", text[TEXT] = "";
    Scene *scene = NULL;
    FILE *file = fopen(DOCUMENT, "rb");
    assert_non_null(file);
    const size_t size = fread(whole, 1, TEXT - 1, file);
    fclose(file);
    assert_true(size < TEXT / 2);
    size_t used = 0;
    for (const char *at = whole; *at;) {
        const bool replaced = *from && !strncmp(at, from, strlen(from));
        assert_true(used + strlen(to) + 1 < TEXT);
        used += (size_t)snprintf(text + used, TEXT - used, "%.*s", replaced ? (int)strlen(to) : 1,
                                 replaced ? to : at);
        at += replaced ? strlen(from) : 1;
    }
    *document = scene_read(DOCUMENT, text, strlen(text), options, &scene);
    if (!scene)
        fail_msg("%s", matc_diagnostics(*document, MATC_TEXT));
    return scene;
}

/* Fresnel reflectance of a dielectric of index 1.5, averaged over both polarizations. */
static double dielectric(double cosine)
{
    const double inner = sqrt(1 - (1 - cosine * cosine) / 2.25),
                 across = (cosine - 1.5 * inner) / (cosine + 1.5 * inner),
                 along = (1.5 * cosine - inner) / (1.5 * cosine + inner);
    return (across * across + along * along) / 2;
}

/* Ratio of Cycles' Fresnel term to Schlick's, for a color. */
static double fresnel_ratio(double color, double cosine)
{
    const double theirs = color + (1 - color) * (dielectric(cosine) - .04) / .96,
                 ours = color + (1 - color) * pow(1 - cosine, 5);
    return theirs / ours;
}

/* The cosines of eye and light on a ball, and of the angle between light and microfacet; false
 * if the ray misses. */
static bool place(const Scene *scene, int i, int *ball, double cosines[3])
{
    const Ray ray = reference_ray(scene, i % WIDTH + .5, i / WIDTH + .5);
    const double far = sqrt(reference_dot(ray.way, ray.way)), sun = sqrt(.25 + .64 + .36),
                 light[3] = {-.5 / sun, -.8 / sun, .6 / sun};
    for (*ball = 0; *ball < BALLS; ++*ball) {
        const double centre[3] = {1.1 * (*ball % 4) - 1.65, 0, 1.1 - 1.1 * (*ball / 4)};
        double from[3], n[3], h[3];
        for (int k = 0; k < 3; k++)
            from[k] = ray.at[k] - centre[k];
        const double b = reference_dot(from, ray.way) / far,
                     d = b * b - reference_dot(from, from) + .52 * .52;
        if (d < 0)
            continue;
        const double t = -b - sqrt(d);
        for (int k = 0; k < 3; k++) {
            n[k] = (from[k] + t * ray.way[k] / far) / .52;
            h[k] = light[k] - ray.way[k] / far;
        }
        cosines[0] = -reference_dot(n, ray.way) / far;
        cosines[1] = reference_dot(n, light);
        cosines[2] = sqrt(reference_dot(h, h)) / 2;
        return true;
    }
    return false;
}

/* Single scattering of sunlight by GGX microfacets: pi times the lobe and the cosine, with
 * Schlick's term. */
static double once(double color, double alpha, const double c[3])
{
    const double up = fmin((c[0] + c[1]) / (2 * c[2]), 1), wide = up * up * (alpha * alpha - 1) + 1,
                 a2 = alpha * alpha;
    const double seen =
        c[1] * sqrt(c[0] * c[0] * (1 - a2) + a2) + c[0] * sqrt(c[1] * c[1] * (1 - a2) + a2);
    return a2 / (wide * wide) * .5 / seen * c[1] * (color + (1 - color) * pow(1 - c[2], 5));
}

/* A ball: errors over their bounds; the sum of light here and in Cycles' picture. */
typedef struct {
    double share[3 * PIXELS], here, there, brightest[2];
    int count;
} Judged;

/* Single-scattered light is within 2 %. Multiple scattering uses Kulla and Conty's lobe here,
 * and random walks between microfacets in Cycles: equal in the sum over directions, but not in
 * each. */
static void judge(const float *wanted, const float *light, const double c[3], int ball,
                  Judged *judged)
{
    for (int k = 0; k < 3; k++) {
        const double color = colors[ball / 4][k], ratio = fresnel_ratio(color, c[2]),
                     here = (double)light[k] * ratio, there = (double)wanted[k];
        const double first = once(color, roughnesses[ball % 4] * roughnesses[ball % 4], c) * ratio;
        judged->share[judged->count++] =
            fabs(here - there) / (.02 * first + AGAIN * fabs(here - first) + STEP);
        judged->here += here;
        judged->there += there;
        judged->brightest[0] = fmax(judged->brightest[0], here);
        judged->brightest[1] = fmax(judged->brightest[1], there);
    }
}

static void draw(const char *from, const char *to, Judged judged[BALLS])
{
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    ReferencePicture picture;
    MatcDocument *document;
    Scene *scene = open_scene(from, to, &options, &document);
    float *light = frame_floats(
        gl, scene, &(RendererOptions){.compile = &options, .view = "light", .no_shadows = true});
    assert_true(reference_picture_read("cycles/principled", &picture));
    memset(judged, 0, BALLS * sizeof *judged);
    for (int i = 0; i < PIXELS; i++) {
        int ball;
        double c[3];
        if (picture.rgba[4 * i + 3] == 1 && place(scene, i, &ball, c) && c[0] > .15 && c[1] > .05)
            judge(picture.rgba + 4 * i, light + 4 * i, c, ball, &judged[ball]);
    }
    for (int i = 0; i < BALLS; i++)
        qsort(judged[i].share, (size_t)judged[i].count, sizeof *judged[i].share, ascending);
    free(light);
    frame_forget(scene, document);
    reference_picture_free(&picture);
    gl_close(gl);
}

static double quantile(const Judged *judged, double share)
{
    return judged->share[(int)(share * (judged->count - 1))];
}

/* Whether a ball is Cycles': each component; all light; and the brightest, which is what
 * microfacets reflect once, of smooth ones: of rough ones Cycles' noise. */
static bool agrees(const Judged *judged, int ball, bool reported)
{
    static const double all[] = {.005, .05, .08, .12}, most[] = {.02, .02, 9, 9};
    const double more = judged->here / judged->there - 1,
                 brighter = judged->brightest[0] / judged->brightest[1] - 1;
    if (reported)
        print_message("%5.2f %% more light, the brightest %5.2f %%; off by %.2f, 99 %% by %.2f of "
                      "what may be; %d components\n",
                      100 * more, 100 * brighter, quantile(judged, .5), quantile(judged, .99),
                      judged->count);
    return judged->count > 3000 && quantile(judged, .99) < 1 && fabs(more) < all[ball % 4] &&
           fabs(brighter) < most[ball % 4];
}

static void gloss_is_that_of_cycles(void **state)
{
    (void)state;
    static const char *const names[] = {"white metal", "copper", "dielectric"};
    static Judged judged[BALLS];
    draw("", "", judged);
    for (int i = 0; i < BALLS; i++) {
        print_message("%-12s roughness %.2f: ", names[i / 4], roughnesses[i % 4]);
        assert_true(agrees(&judged[i], i, true));
    }
}

/* Balls that each lobe concerns. */
static void other_lobes_are_seen(void **state)
{
    (void)state;
    static const struct {
        const char *from, *to;
        int first, last;
    } faults[] = {{"roughness: 0.25", "roughness: 0.26", 0, 8},
                  {"roughness: 0.5", "roughness: 0.52", 1, 9},
                  {"roughness: 0.75", "roughness: 0.85", 2, 10},
                  {"metalness: 0,", "metalness: 0, ior: 1.53,", 8, 8},
                  {"metalness: 0,", "metalness: 0, coat: 0.05,", 8, 8}};
    static Judged judged[BALLS];
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++) {
        draw(faults[i].from, faults[i].to, judged);
        for (int ball = faults[i].first; ball <= faults[i].last; ball += 4)
            assert_false(agrees(&judged[ball], ball, false));
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(gloss_is_that_of_cycles),
                                       cmocka_unit_test(other_lobes_are_seen)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
