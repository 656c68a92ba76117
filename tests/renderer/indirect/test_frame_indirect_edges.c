/* No halo at shadow boundaries: indirect light is smooth across the sharp boundary of a lamp's
 * shadow. */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/shadow_ray.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { EDGE = 128, PIXELS = EDGE * EDGE, TEXT = 2048, AWAY = 4, ASIDE = 2 * AWAY + 2 };

/* A slab over a floor, beside a red wall; below the lamp, so that its shadow's edges lie on
 * both. */
static const char body[] =
    "image: { width: 128, height: 128 }\nvoxels: { size: 64 }\ncamera: { camera: Perspective, "
    "position: [.3, -4, 2.6], "
    "target: [.1, 0, .3], angle: 40 }\nmaterials: { m: { material: Phong, diffuse: .7, specular: 0 "
    "}, r: { material: "
    "Phong, diffuse: [.8, .3, .2], specular: 0 } }\nlights: [{ light: Point, position: [.6, -1.4, "
    "3], intensity: 20, "
    "shadows: exact }]\nobjects:\n"
    "- { object: Box, material: m, size: [3, 3, .2], transform: { translation: [0, 0, -.1] } }\n"
    "- { object: Box, material: r, size: [3, .2, 2], transform: { translation: [0, 1, 1] } }\n"
    "- { object: Box, material: m, size: [.9, .7, .1], transform: { translation: [.1, .1, 1.2], "
    "rotation: [0, 0, .2] "
    "} }\n";

enum { NOTHING, DARK, LIT };

/* Finds lit pixels of the floor or the wall by rays in double to the lamp; pixels adjacent to
 * another face are excluded. */
static void find_lit(const Scene *scene, unsigned char *lit)
{
    Tracer tracer = reference_open(scene);
    for (int p = 0; p < PIXELS; p++) {
        const Ray ray = reference_ray(scene, p % EDGE + .5, p / EDGE + .5);
        const Hit hit = reference_hit(&tracer, &ray, 0);
        lit[p] = NOTHING;
        if (!isfinite(hit.distance) || hit.object > 1 ||
            reference_is_edge(&tracer, p % EDGE, p / EDGE, &hit, 1))
            continue;
        lit[p] = shadow_is_lit(&tracer, &scene->lights[0], hit.world, hit.microfacet) ? LIT : DARK;
    }
    reference_close(&tracer);
}

/* True if all pixels of a row from `from` to `to` show one surface. */
static bool is_even(const unsigned char *lit, int from, int to)
{
    bool even = from / EDGE == to / EDGE;
    for (int p = from; even && p <= to; p++)
        even = lit[p] != NOTHING;
    return even;
}

static double grey(const float *rgba, int p)
{
    return ((double)rgba[4 * p] + (double)rgba[4 * p + 1] + (double)rgba[4 * p + 2]) / 3;
}

/* Relative excess of the two pixels p, p + 1 over those AWAY from them. */
static double rim(const float *rgba, int p)
{
    const double around = grey(rgba, p - AWAY) + grey(rgba, p + 1 + AWAY);
    return (grey(rgba, p) + grey(rgba, p + 1)) / around - 1;
}

static float *drawn(GlContext *gl, const char *keys, const char *view, unsigned char *lit)
{
    const MatcOptions options = frame_exact_options();
    char text[TEXT];
    MatcDocument *document;
    snprintf(text, sizeof text, "indirect: { radius: 4, %s }\n%s", keys, body);
    Scene *scene = frame_scene(text, &options, &document);
    if (lit)
        find_lit(scene, lit);
    float *rgba = frame_floats(gl, scene,
                               &(RendererOptions){.compile = &options, .view = view, .deep = true});
    frame_forget(scene, document);
    return rgba;
}

typedef struct {
    double mean, square, most;
    int count;
} Rims;

static void add(Rims *rims, double share)
{
    rims->mean += share;
    rims->square += share * share;
    rims->most = fmax(rims->most, fabs(share));
    rims->count++;
}

/* Compares at edges, and next to edges on either side, where no difference is allowed. */
static void edges_do_not_glow(void **state)
{
    (void)state;
    static const char *const keys[] = {"method: hybrid, rays: 32", "method: voxels, rays: 32",
                                       "method: hybrid, rays: 32, resolution: half"};
    static unsigned char lit[PIXELS];
    GlContext *gl = frame_context();
    float *light = drawn(gl, "rays: 1, bounces: 0", "light", lit);
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        float *rgba = drawn(gl, keys[i], "indirect", NULL);
        Rims at = {0}, beside = {0};
        double jump = 0;
        for (int p = ASIDE + AWAY; p < PIXELS - ASIDE - AWAY - 1; p++) {
            if (!is_even(lit, p - AWAY - ASIDE, p + 1 + AWAY + ASIDE) || lit[p] == lit[p + 1])
                continue;
            add(&at, rim(rgba, p));
            add(&beside, rim(rgba, p - ASIDE));
            add(&beside, rim(rgba, p + ASIDE));
            jump += fabs(grey(light, p) - grey(light, p + 1)) /
                    fmax(grey(light, p), grey(light, p + 1));
        }
        const double mean = at.mean / at.count, noise = sqrt(beside.square / beside.count);
        print_message("%s: %d places, where light of the lamp jumps by %.2f: lighter by %.4f in "
                      "the mean, by %.4f at "
                      "most; root of the mean square %.4f, beside %.4f\n",
                      keys[i], at.count, jump / at.count, mean, at.most, sqrt(at.square / at.count),
                      noise);
        assert_true(at.count > 30 && jump > .9 * at.count);
        assert_true(fabs(mean) < .01 && at.most < .02 && sqrt(at.square / at.count) < noise + .002);
        free(rgba);
    }
    free(light);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(edges_do_not_glow)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
