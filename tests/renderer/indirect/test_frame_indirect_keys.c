/* Keys of `indirect:` without another test, against their documentation: the contrast of ambient
 * occlusion, and the offset of rays from the surface. */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 64, HEIGHT = 48, PIXELS = WIDTH * HEIGHT, TEXT = 2048, KEYS = 256 };

/* A floor, and a ceiling 1 above, seen from between; ambient occlusion in floats. From malloc. */
static float *draw(GlContext *gl, const char *keys, const char *objects)
{
    const MatcOptions options = frame_exact_options();
    MatcDocument *document;
    char text[TEXT];
    snprintf(text, sizeof text,
             "image: { width: %d, height: %d }\ncamera: { camera: Perspective, position: [0, -2, "
             ".8], target: [0, 0, "
             "0], angle: 40 }\nindirect: { filter: none, %s }\nmaterials: { m: { material: Phong } "
             "}\nobjects:\n"
             "- { object: Box, material: m, size: [8, 8, .3], transform: { translation: [0, 0, "
             "-.15] } }\n%s",
             WIDTH, HEIGHT, keys, objects);
    Scene *scene = frame_scene(text, &options, &document);
    float *open = frame_floats(gl, scene,
                               &(RendererOptions){.compile = &options, .view = "ao", .deep = true});
    frame_forget(scene, document);
    return open;
}

static void contrast_is_of_what_is_kept_off(void **state)
{
    (void)state;
    static const char *const methods[] = {"hybrid", "screen", "march, steps: 16", "points"};
    static const double contrasts[] = {0, .5, 2, 16};
    static const char boxes[] = "- { object: Box, material: m, transform: { translation: [.3, .4, "
                                ".5], rotation: [0, 0, .4] } }\n";
    GlContext *gl = frame_context();
    char keys[KEYS];
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        snprintf(keys, sizeof keys, "radius: 1, method: %s", methods[i]);
        float *plain = draw(gl, keys, boxes);
        for (size_t k = 0; k < sizeof contrasts / sizeof *contrasts; k++) {
            int clamped = 0, between = 0;
            double most = 0;
            snprintf(keys, sizeof keys, "radius: 1, method: %s, contrast: %g", methods[i],
                     contrasts[k]);
            float *open = draw(gl, keys, boxes);
            for (int p = 0; p < PIXELS; p++) {
                const double wanted = 1 - contrasts[k] * (1 - (double)plain[4 * p]);
                most = fmax(most, fabs((double)open[4 * p] - fmax(wanted, 0)));
                clamped += wanted < 0;
                between += wanted > 0 && wanted < 1;
            }
            print_message("%s, contrast %g: off by %.2g, %d pixels at 0\n", methods[i],
                          contrasts[k], most, clamped);
            assert_true(most < 1e-5 && (between > 100 || contrasts[k] == 0 || clamped > 100));
            free(open);
        }
        free(plain);
    }
    gl_close(gl);
}

/* A ceiling at height c above the rays' origin: rays within the radius r hit it if their cosine
 * exceeds c / r, which for cosine-weighted directions is the share 1 - (c / r)^2. A step is r /
 * 64 long, a voxel .064 wide: the ceiling's lowest full voxels begin at most half of a voxel
 * off. */
static void rays_begin_as_far_off_as_is_said(void **state)
{
    (void)state;
    static const double offsets[] = {.1, .3, .6}, radius = 1.2;
    static const char ceiling[] = "- { object: Box, material: m, size: [8, 8, .3], transform: { "
                                  "translation: [0, 0, 1.15] } }\n";
    GlContext *gl = frame_context();
    char keys[KEYS];
    for (size_t i = 0; i < sizeof offsets / sizeof *offsets; i++) {
        snprintf(keys, sizeof keys,
                 "method: march, march: voxels, rays: 64, steps: 64, radius: %g, offset: %g",
                 radius, offsets[i]);
        float *open = draw(gl, keys, ceiling);
        const double c = (1 - offsets[i]) / radius, edge = (.032 + radius / 64) / radius;
        double mean = 0;
        for (int p = 0; p < PIXELS / 2; p++) /* the lower half: the floor that is near */
            mean += (double)open[4 * p] / (PIXELS / 2);
        print_message("offset %g: %.4f open, by the closed form %.4f\n", offsets[i], mean, c * c);
        assert_true(fabs(mean - c * c) < (c + edge) * (c + edge) - c * c);
        free(open);
    }
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(contrast_is_of_what_is_kept_off),
                                       cmocka_unit_test(rays_begin_as_far_off_as_is_said)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
