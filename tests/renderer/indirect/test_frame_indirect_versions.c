/* Indirect light on drivers below OpenGL 4.3, without compute and voxels. `auto` selects an
 * available method and reports the reason; a method that needs voxels is an error that names the
 * method; pictures equal those of newer drivers. MESA_GL_VERSION_OVERRIDE makes Mesa report an
 * older version. */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EDGE = 48, PIXELS = EDGE * EDGE, TEXT = 2048 };

static const char body[] =
    "image: { width: 48, height: 48 }\ncamera: { camera: Perspective, position: [.4, -4, 1.8], "
    "target: [0, 0, .6], "
    "angle: 40 }\nmaterials: { m: { material: Phong, diffuse: .6 } }\nlights: [{ light: Point, "
    "position: [2, -3, 4], "
    "intensity: 9, shadows: none }, { light: Ambient, color: .2 }]\nobjects:\n"
    "- { object: Box, material: m, size: [3, 3, .2], transform: { translation: [0, 0, -.1] } }\n"
    "- { object: Sphere, radius: .5, detail: 24, material: m, transform: { translation: [0, 0, .5] "
    "} }\n";

/* Draws one frame, or two. Returns NULL if that fails; *reported is the reason, from malloc, or
 * else the method used. */
static float *drawn(GlContext *gl, const char *keys, bool twice, char **reported)
{
    const MatcOptions options = frame_exact_options();
    char text[TEXT];
    MatcDocument *document;
    snprintf(text, sizeof text, "indirect: { radius: 1, %s }\n%s", keys, body);
    Scene *scene = frame_scene(text, &options, &document);
    Renderer *renderer =
        renderer_open(gl, &(RendererOptions){.compile = &options, .view = "light", .deep = true});
    float *rgba = calloc(4 * PIXELS, sizeof *rgba);
    const bool fine = renderer && rgba && renderer_set_scene(renderer, scene) &&
                      renderer_frame(renderer) && (!twice || renderer_frame(renderer)) &&
                      renderer_read(renderer, rgba);
    *reported = fine ? renderer_stats(renderer) : strdup(gl->error);
    renderer_close(renderer);
    frame_forget(scene, document);
    if (!fine)
        free(rgba);
    return fine ? rgba : NULL;
}

/* Root mean square difference: with `screen`, one sector of 32 may round to the other side. */
static double apart(const float *a, const float *b)
{
    double sum = 0;
    for (int i = 0; i < 4 * PIXELS; i++)
        sum += ((double)a[i] - (double)b[i]) * ((double)a[i] - (double)b[i]);
    return sqrt(sum / (4 * PIXELS));
}

static const char *const versions[] = {"3.3", "4.2"};
static const char *const glsl[] = {"330", "420"};

static GlContext *older(int version)
{
    setenv("MESA_GL_VERSION_OVERRIDE", versions[version], 1);
    setenv("MESA_GLSL_VERSION_OVERRIDE", glsl[version], 1);
    GlContext *gl = frame_context();
    unsetenv("MESA_GL_VERSION_OVERRIDE");
    unsetenv("MESA_GLSL_VERSION_OVERRIDE");
    return gl;
}

/* By all screen-space methods, with every full-screen pass as a fragment program, and with
 * accumulation over frames. */
static void pictures_are_the_same(void **state)
{
    (void)state;
    static const char *const keys[] = {"method: march",
                                       "method: points",
                                       "method: screen, rotation: blue",
                                       "method: screen, bounces: 2, filter: atrous",
                                       "method: screen, history: 4",
                                       "method: march, march: picture, resolution: half"};
    enum { KEYS = sizeof keys / sizeof *keys };
    float *right[KEYS];
    char *reported;
    GlContext *gl = frame_context();
    assert_true(gl->major * 10 + gl->minor >= 43);
    for (int i = 0; i < KEYS; i++) {
        right[i] = drawn(gl, keys[i], true, &reported);
        assert_true(right[i] && strstr(reported, "in compute"));
        free(reported);
    }
    gl_close(gl);
    for (int version = 0; version < 2; version++) {
        gl = older(version);
        assert_true(gl->major * 10 + gl->minor < 43);
        for (int i = 0; i < (version ? 1 : KEYS); i++) {
            float *rgba = drawn(gl, keys[i], true, &reported);
            if (!rgba)
                fail_msg("%s", reported);
            const double off = apart(rgba, right[i]);
            print_message("OpenGL %s, %s: %.2g off\n", versions[version], keys[i], off);
            assert_true(off < 1e-4 && !strstr(reported, "in compute"));
            free(rgba);
            free(reported);
        }
        gl_close(gl);
    }
    for (int i = 0; i < KEYS; i++)
        free(right[i]);
}

static void voxels_are_missed_by_name(void **state)
{
    (void)state;
    static const char *const keys[] = {"method: voxels", "method: hybrid",
                                       "method: march, march: voxels"};
    GlContext *gl = older(0);
    char *reported;
    for (int i = 0; i < 3; i++) {
        assert_null(drawn(gl, keys[i], false, &reported));
        print_message("%s: %s\n", keys[i], reported);
        assert_non_null(strstr(reported, "voxels take OpenGL 4.3, and the driver has 3.3"));
        free(reported);
    }
    float *rgba = drawn(gl, "method: auto", false, &reported);
    assert_true(rgba && strstr(reported, "by the method screen, as voxels take OpenGL 4.3"));
    free(rgba);
    free(reported);
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(pictures_are_the_same),
                                       cmocka_unit_test(voxels_are_missed_by_name)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
