/* The backdrop of pixels without a surface: tiles and a glow by their formulas, with any tone
 * mapping, and through glass before them; a glow with tiles behind the glass. */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static float *draw(GlContext *gl, const char *text, int samples, bool fragment)
{
    MatcDocument *document;
    const MatcOptions options = frame_exact_options();
    Scene *scene = frame_scene(text, &options, &document);
    float *rgba = frame_floats(
        gl, scene,
        &(RendererOptions){.compile = &options, .samples = samples, .fragment = fragment});
    frame_forget(scene, document);
    return rgba;
}

/* IEC 61966-2-1. */
static double encode(double c)
{
    return c <= .0031308 ? 12.92 * c : 1.055 * pow(c, 1 / 2.4) - .055;
}

/* Gray tiles of 16 pixels where nothing is; none on an object, black as it is. */
static void tiles(void **state)
{
    (void)state;
    enum { SIDE = 64 };
    GlContext *gl = frame_context();
    float *shown =
        draw(gl,
             "image: { width: 64, height: 64, tiles: true }\ncamera: { camera: Orthographic, "
             "position: [0, -5, 0], "
             "size: 4 }\nobjects: [{ object: Box, material: { material: Phong, diffuse: 0 } }]\n"
             "toneMapping: { toneMapping: Drago }\n",
             1, false);
    for (int y = 0; y < SIDE; y++)
        for (int x = 0; x < SIDE; x++) {
            const bool box = x >= 24 && x < 40 && y >= 24 && y < 40;
            const double grey = box ? 0 : (x / 16 + y / 16) % 2 ? .4 : .6;
            assert_true(fabs(shown[4 * (y * SIDE + x)] - grey) <= .51 / 255);
        }
    free(shown);
    gl_close(gl);
}

/* A glow by its formula; through a pane, the glow or the tiles are multiplied by the pane's
 * transmittance, at any exposure. */
static void through_glass(void **state)
{
    (void)state;
    enum { WIDTH = 60, HEIGHT = 40 };
    static const double edge[2][3] = {{.034, .036, .04}, {.15, .155, .165}}, lets[3] = {.5, .25, 1};
    GlContext *gl = frame_context();
    for (int k = 0; k < 5; k++) {
        char text[1024];
        double most = 0;
        snprintf(text, sizeof text,
                 "image: { width: 60, height: 40, %s: true }\ncamera: { camera: Orthographic, "
                 "position: [0, -5, 0], "
                 "size: 4 }\nobjects: [{ object: Parallelogram, u: [2, 0, 0], v: [0, 0, 2], "
                 "material: { material: "
                 "Phong, diffuse: 0, transparency: [.5, .25, 1] }, transform: { translation: [-1, "
                 "0, -1] } }]\n"
                 "toneMapping: { toneMapping: Clamp, exposure: %d }\n",
                 k == 4  ? "glow: true, tiles"
                 : k % 2 ? "tiles"
                         : "glow",
                 k == 4 ? -6 : k / 2 % 2 * 3);
        float *shown = draw(gl, text, 1 + k / 2 % 2, k == 3);
        for (int i = 0; i < 3 * WIDTH * HEIGHT; i++) {
            const int x = i / 3 % WIDTH, y = i / 3 / WIDTH, component = i % 3;
            const bool pane = x >= 20 && x < 40 && y >= 10 && y < 30;
            const double right = (2 * x + 1 - WIDTH) / (double)HEIGHT,
                         up = (2 * y + 1 - HEIGHT) / (double)HEIGHT - .1;
            const double glow = exp(-1.6 * (right * right + up * up)),
                         grey = (x / 16 + y / 16) % 2 ? .4 : .6;
            const bool tiled = k == 4 ? pane : k % 2;
            const double behind =
                tiled ? pow((grey + .055) / 1.055, 2.4)
                      : edge[0][component] + glow * (edge[1][component] - edge[0][component]);
            most = fmax(most, fabs(shown[i / 3 * 4 + component] -
                                   encode(pane ? lets[component] * behind : behind)));
        }
        print_message("%s: %.3f steps of 8 bits\n", k % 2 ? "tiles" : "glow", 255 * most);
        assert_true(255 * most <= .6);
        free(shown);
    }
    gl_close(gl);
}

/* In a picture drawn in tiles of 24 pixels, the checkered backdrop and a glow are at the same
 * places as in one drawn at once. */
static void parts_have_the_picture_s_backdrop(void **state)
{
    (void)state;
    enum { WIDTH = 60, HEIGHT = 40 };
    static const char *const kinds[] = {"tiles: true", "glow: true"};
    GlContext *gl = frame_context();
    for (int kind = 0; kind < 2; kind++) {
        char text[256];
        MatcDocument *document;
        const MatcOptions options = frame_exact_options();
        snprintf(text, sizeof text,
                 "image: { width: %d, height: %d, %s }\nlights: [{ light: Ambient }]\n"
                 "objects: [{ object: Box, material: { material: Phong, ambient: .5 } }]\n",
                 WIDTH, HEIGHT, kinds[kind]);
        Scene *scene = frame_scene(text, &options, &document);
        float *whole = frame_floats(gl, scene, &(RendererOptions){.compile = &options});
        float *parts =
            frame_tiles(gl, scene, &(RendererOptions){.compile = &options, .tile = {24, 24}});
        for (int i = 0; i < 4 * WIDTH * HEIGHT; i++)
            assert_true(fabsf(whole[i] - parts[i]) < .51f / 255);
        free(whole);
        free(parts);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(tiles), cmocka_unit_test(through_glass),
                                       cmocka_unit_test(parts_have_the_picture_s_backdrop)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
