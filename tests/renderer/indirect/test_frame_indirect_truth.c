/* Ambient occlusion and indirect light by every method against many rays in double; the error of
 * each is printed, and bounded. `build/tests/test_frame_indirect_truth goals [FILE.obj LIFT
 * [KEYS...]]`, or `errors` without times: prints the rows of goals of docs/results/indirect.md;
 * with FILE.obj also for that mesh, y up, LIFT above the ground. */
/* ctest: unsanitized */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame/indirect_goals.h"
#include "tests/frame_reference/indirect_truth.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { EDGE = 256, TEXT = 4096 };

static void methods_against_rays(void **state)
{
    (void)state;
    static const struct {
        const char *keys;
        double open, light; /* upper bounds */
    } methods[] = {{"method: march, rays: 32, steps: 32", 0.09, 0.5},
                   {"method: march, march: voxels, rays: 32, steps: 32", 0.0095, 0.2},
                   {"method: screen, rays: 32, steps: 16", 0.075, 0.55},
                   {"method: voxels", 0.0145, 0.05},
                   {"method: hybrid", 0.0125, 0.05},
                   {"method: hybrid, rays: 16, sequence: hammersley", 0.0095, 0.07},
                   {"method: hybrid, rays: 64", 0.0082, 0.042},
                   {"method: hybrid, filter: atrous", 0.0135, 0.068},
                   {"method: hybrid, filter: atrous, filterSize: 8", 0.0145, 0.058},
                   {"method: hybrid, rays: 32, resolution: half", 0.018, 0.12},
                   {"method: hybrid, rays: 32, resolution: half, filter: atrous", 0.0165, 0.055},
                   {"method: hybrid, rays: 64, resolution: quarter", 0.038, 0.09},
                   {"method: hybrid, rays: 64, resolution: quarter, filter: atrous", 0.031, 0.085}};
    static const double radii[2] = {.5, 4};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    IndirectTruth *truth = malloc(sizeof *truth);
    for (int light = 0; light < 2; light++)
        for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
            char text[TEXT];
            MatcDocument *document;
            snprintf(text, sizeof text,
                     "image: { width: %d, height: %d }\nindirect: { radius: %g, %s }\n%s", EDGE,
                     EDGE, radii[light], methods[i].keys, indirect_scenes_box);
            Scene *scene = frame_scene(text, &options, &document);
            if (i == 0)
                indirect_truth_find(
                    scene,
                    &(OpenRays){.across = light ? 24 : 32, .radius = radii[light], .bounces = 1},
                    light ? &options : NULL, truth);
            float *rgba = frame_floats(
                gl, scene,
                &(RendererOptions){.compile = &options, .view = light ? "indirect" : "ao"});
            const double off = indirect_truth_off(truth, rgba, light);
            print_message("%-48s %s %.4f off, of %d places", methods[i].keys,
                          light ? "light" : "openness", off, truth->count);
            print_message(light ? "; its mean %.3f\n" : "\n", indirect_truth_more(truth, rgba));
            assert_true(!light || !strstr(methods[i].keys, "hybrid") ||
                        fabs(indirect_truth_more(truth, rgba)) < .03);
            assert_true(truth->count > 600 && off < (light ? methods[i].light : methods[i].open));
            free(rgba);
            frame_forget(scene, document);
        }
    free(truth);
    gl_close(gl);
}

/* A second bounce has no greater error than the first. Averaged samples are as good as equally
 * many rays at once. */
static void bounces_and_samples(void **state)
{
    (void)state;
    static const struct {
        const char *keys, *view;
        int across, bounces;
        double most;
    } cases[] = {{"bounces: 2", "indirect", 20, 2, .07},
                 {"samples: 8, rotation: random, filter: none, rays: 8", "ao", 32, 1, .025}};
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    IndirectTruth *truth = malloc(sizeof *truth);
    for (int i = 0; i < 2; i++) {
        char text[TEXT];
        MatcDocument *document;
        snprintf(text, sizeof text,
                 "image: { width: %d, height: %d }\nindirect: { radius: %g, %s }\n%s", EDGE, EDGE,
                 i ? .5 : 4., cases[i].keys, indirect_scenes_box);
        Scene *scene = frame_scene(text, &options, &document);
        indirect_truth_find(scene,
                            &(OpenRays){.across = cases[i].across,
                                        .radius = i ? .5 : 4,
                                        .bounces = cases[i].bounces},
                            i ? NULL : &options, truth);
        float *rgba =
            frame_floats(gl, scene, &(RendererOptions){.compile = &options, .view = cases[i].view});
        const double off = indirect_truth_off(truth, rgba, !i);
        print_message("%-48s %.4f off\n", cases[i].keys, off);
        assert_true(off < cases[i].most);
        free(rgba);
        frame_forget(scene, document);
    }
    free(truth);
    gl_close(gl);
}

int main(int count, char **arguments)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(methods_against_rays),
                                       cmocka_unit_test(bounces_and_samples)};
    const bool mesh = count > 3;
    const bool timed = count > 1 && !strcmp(arguments[1], "goals");
    if (timed || (count > 1 && !strcmp(arguments[1], "errors")))
        return !indirect_goals_print(&(IndirectGoals){.mesh = mesh ? arguments[2] : NULL,
                                                      .lift = mesh ? arguments[3] : "0",
                                                      .keys = (const char *const *)arguments + 4,
                                                      .key_count = mesh ? count - 4 : 0,
                                                      .timed = timed});
    return cmocka_run_group_tests(tests, NULL, NULL);
}
