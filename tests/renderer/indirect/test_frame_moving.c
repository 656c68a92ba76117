/* `moving:` of indirect light: a frame with a change equals one at the coarser resolution; the
 * next frame, without changes, equals one at the finer resolution. */
/* ctest: unsanitized */
#include "tests/test.h"
#include "runtime/indirect/radiance/radiance.h"
#include "runtime/indirect/voxels/voxels.h"
#include "runtime/frame_graph/frame.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/frame_running.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 92, HEIGHT = 70, COMPONENTS = 4 * WIDTH * HEIGHT, TEXT = 2048 };

static const char body[] =
    "image: { width: 92, height: 70 }\ncamera: { camera: Perspective, position: [.4, -4, 1.8], "
    "target: [0, 0, .6], "
    "angle: 40 }\nlights: [{ light: Point, position: [1, -2, 3], intensity: 9 }]\nmaterials: { m: "
    "{ material: Phong, "
    "diffuse: .6 } }\nobjects:\n"
    "- { object: Box, material: m, size: [.6, .6, .9], transform: { translation: [.5, -.2, .45], "
    "rotation: [0, 0, .4] "
    "} "
    "}\n- { object: Box, material: m, size: [3, 3, .2], transform: { translation: [0, 0, -.1] } }\n"
    "- { object: Box, material: m, size: [3, .2, 2], transform: { translation: [0, .7, 1] } }\n";

static FrameRunning open_rig(GlContext *gl, const char *keys, const char *view, bool fragment)
{
    FrameRunning rig;
    char text[TEXT];
    snprintf(text, sizeof text, "indirect: { %s }\n%s", keys, body);
    frame_running_open(gl, text,
                       &(RendererOptions){.view = view, .deep = true, .fragment = fragment}, &rig);
    frame_running_draw(&rig);
    return rig;
}

typedef enum { CAMERA, OBJECT, LIGHTS, CHANGES } Change;

static void move(FrameRunning *rig, Change change)
{
    if (change == CAMERA)
        rig->scene->camera.position[0] += .2;
    if (change == OBJECT)
        rig->scene->objects[0].world_from_local.m[12] -= .3;
    if (change == LIGHTS)
        rig->scene->lights[0].position[2] += .4;
    assert_true(change == OBJECT
                    ? renderer_changed_objects(rig->renderer, 0, 1)
                    : renderer_changed(rig->renderer,
                                       change == CAMERA ? RENDERER_CAMERA : RENDERER_LIGHTS));
}

static double difference(const float *a, const float *b)
{
    double most = 0;
    for (int i = 0; i < COMPONENTS; i++)
        most = fmax(most, fabs((double)a[i] - (double)b[i]));
    return most;
}

/* Root mean square difference: of the first component, ambient occlusion; of three, light
 * relative to its mean. */
static double off_by(const float *a, const float *b, int components)
{
    double sum = 0, mean = 0;
    for (int i = 0; i < COMPONENTS; i++)
        if (i % 4 < components) {
            sum += ((double)a[i] - (double)b[i]) * ((double)a[i] - (double)b[i]) /
                   (COMPONENTS / 4 * components);
            mean += (double)b[i] / (COMPONENTS / 4 * components);
        }
    return sqrt(sum) / (components == 1 ? 1 : mean);
}

static void read(FrameRunning *rig, float *rgba)
{
    memcpy(rgba, frame_running_draw(rig), COMPONENTS * sizeof *rgba);
}

static void coarse_while_it_moves_then_fine(void **state)
{
    (void)state;
    static const struct {
        const char *keys, *fine, *moving, *view;
        bool fragment;
        double
            /* max root mean square difference of coarser frames in ambient occlusion; light by
             * few rays is bounded only by its noise */
            off;
        double exact; /* passes of means over one pixel round */
    } cases[] = {{"rays: 16, radius: 1", "", "resolution: quarter", "ao", false, .05, 0},
                 {"rays: 16, radius: 1", "", "resolution: half", "ao", false, .025, 0},
                 {"rays: 16, method: march, bounces: 2", "resolution: half", "resolution: quarter",
                  "indirect", false, 9, 0},
                 {"rays: 8, method: screen, filter: none", "", "resolution: half", "indirect", true,
                  9, 1e-6}};
    static float now[COMPONENTS], want[COMPONENTS], fine[COMPONENTS];
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char keys[3][TEXT / 8];
        snprintf(keys[0], sizeof keys[0], "%s, %s%smoving: %s", cases[i].keys, cases[i].fine,
                 *cases[i].fine ? ", " : "", strchr(cases[i].moving, ':') + 2);
        snprintf(keys[1], sizeof keys[1], "%s, %s", cases[i].keys, cases[i].moving);
        snprintf(keys[2], sizeof keys[2], "%s, %s", cases[i].keys,
                 *cases[i].fine ? cases[i].fine : "resolution: full");
        FrameRunning rigs[3];
        for (int k = 0; k < 3; k++)
            rigs[k] = open_rig(gl, keys[k], cases[i].view, cases[i].fragment);
        const int components = strcmp(cases[i].view, "ao") ? 3 : 1;
        for (int change = -1; change < CHANGES; change++) {
            for (int k = 0; k < 3 && change >= 0; k++)
                move(&rigs[k], (Change)change);
            read(&rigs[0], now);
            read(&rigs[1], want);
            read(&rigs[2], fine);
            const double off = off_by(now, fine, components);
            if (change >= 0)
                print_message("%s, change %d: the coarser frame is %.3f off the finer\n", keys[0],
                              change, off);
            assert_true(difference(now, change < 0 ? fine : want) <= cases[i].exact);
            assert_true(change < 0 || (off > .001 && off < cases[i].off));
            read(&rigs[0], now);
            assert_true(difference(now, fine) <= cases[i].exact);
        }
        for (int k = 0; k < 3; k++)
            frame_running_close(&rigs[k]);
    }
    gl_close(gl);
}

/* During motion one set of rays for fewer pixels; afterwards sets accumulate to the requested
 * number. */
static void samples_begin_when_it_stands_still(void **state)
{
    (void)state;
    static float now[COMPONENTS], want[COMPONENTS];
    GlContext *gl = frame_context();
    FrameRunning moving = open_rig(gl, "rays: 8, samples: 4, moving: quarter", "indirect", false),
                 still = open_rig(gl, "rays: 8, samples: 4", "indirect", false),
                 coarse = open_rig(gl, "rays: 8, resolution: quarter", "indirect", false);
    for (int i = 0; i < 2; i++) {
        move(&moving, CAMERA);
        move(&still, CAMERA);
        move(&coarse, CAMERA);
        read(&moving, now);
        read(&coarse, want);
        assert_true(off_by(now, want, 3) < .3); /* another set of rays */
    }
    read(&moving, now);
    read(&still, want);
    print_message("of as many samples: %.3f of the mean of light between the one that moved and "
                  "one that did not\n",
                  off_by(now, want, 3));
    assert_true(off_by(now, want, 3) < .05);
    frame_running_close(&moving);
    frame_running_close(&still);
    frame_running_close(&coarse);
    gl_close(gl);
}

/* Radiance nodes are updated only if they may have changed; a scene with only ambient light and
 * without emission has none. */
static void nodes_are_made_when_needed(void **state)
{
    (void)state;
    static const struct {
        const char *lights, *material;
        bool has, by_time;
    } cases[] = {
        {"{ light: Point, position: [1, 1, 3] }", "material: Phong, diffuse: .5", true, false},
        {"{ light: Point, position: [1, 1, 3] }",
         "material: Phong, diffuse: \"= [.2 + .3 * time, .4, .3]\"", true, true},
        {"{ light: Ambient }", "material: Phong, diffuse: .5", false, false},
        {"{ light: Hemisphere }", "material: Phong, diffuse: .5", false, false},
        {"{ light: Ambient }", "material: Phong, emissive: [.2, 0, 0]", true, false},
        {"{ light: Ambient }", "material: Phong, emissive: \"= [time, 0, 0]\"", true, true},
        {"{ light: Ambient }", "material: glTF", false, false},
        {"{ light: Ambient }", "material: Principled, emissionColor: [.2, 0, 0]", false, false},
        {"{ light: Ambient }", "material: glTF, emissiveFactor: [0, 0, .2]", true, false}};
    const MatcOptions options = frame_exact_options();
    const RendererOptions how = {.compile = &options, .view = "light"};
    GlContext *gl = frame_context();
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[1024];
        MatcDocument *document;
        snprintf(text, sizeof text,
                 "image: { width: 32, height: 32 }\nindirect: { method: voxels }\nvoxels: { size: "
                 "32 }\nlights:\n- %s\n"
                 "objects:\n- { object: Box, material: { %s } }\n",
                 cases[i].lights, cases[i].material);
        Scene *scene = frame_scene(text, &options, &document);
        Renderer *renderer = renderer_open(gl, &how);
        assert_true(renderer && renderer_set_scene(renderer, scene) && renderer_frame(renderer));
        assert_int_equal(renderer->radiance->drawn, cases[i].has);
        scene->time = 2;
        assert_true(renderer_changed(renderer, RENDERER_TIME));
        assert_int_equal(renderer->radiance->drawn, cases[i].has && !cases[i].by_time);
        assert_true(renderer->voxels->drawn);
        float *as_new = frame_floats(gl, scene, &how), *rgba = malloc(sizeof *rgba * 4 * 32 * 32);
        assert_true(rgba && renderer_frame(renderer) && renderer_read(renderer, rgba));
        assert_memory_equal(as_new, rgba, sizeof *rgba * 4 * 32 * 32);
        free(rgba);
        free(as_new);
        renderer_close(renderer);
        frame_forget(scene, document);
    }
    gl_close(gl);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(coarse_while_it_moves_then_fine),
                                       cmocka_unit_test(samples_begin_when_it_stands_still),
                                       cmocka_unit_test(nodes_are_made_when_needed)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
