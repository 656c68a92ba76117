/* Edges and glass: edges behind glass, the glass' own outlines, in front of near objects and of
 * the background. Against 8 x 8 samples per pixel. */
#include "tests/test.h"
#include "tests/frame/frame_draw.h"
#include <math.h>
#include <stdlib.h>

enum { WIDTH = 120, HEIGHT = 80, SAMPLES = 8 };

#define CAMERA                                                                                     \
    "image: { width: 120, height: 80 }\ncamera: { camera: Perspective, position: [.5, -6, 2.5], "  \
    "target: [0, 0, .5], "                                                                         \
    "angle: 40 }\nsky: { material: RGBA, r: .25, g: .5, b: 1 }\nlights: [{ light: Ambient "        \
    "}]\nobjects:\n"
#define GLASS      "material: { material: Phong, ambient: [.1, 0, 0], transparency: [.9, .3, .3] }"
#define GLOWS(rgb) "material: { material: Phong, emissive: " rgb " }"

/* Greatest ratio of the edge pass's error to that of one sample: 1, nothing is worse; less, where
 * it finds the edges. */
static const struct {
    const char *name, *text;
    double share;
} cases[] = {
    {"a pane before nothing",
     CAMERA "- { object: Parallelogram, u: [2, 0, .3], v: [0, .3, 2], " GLASS " }\n", 1},
    {"a ball before nothing", CAMERA "- { object: Sphere, " GLASS " }\n", 1},
    {"a pane near a wall",
     CAMERA "- { object: Parallelogram, u: [9, 0, .3], v: [0, .3, 9], " GLOWS(
         "[1, 1, .5]") ", transform: { translation: [-4, .1, -2] } }\n- { object: Parallelogram, "
                       "u: [2, 0, .3], v: "
                       "[0, .3, 2], " GLASS " }\n",
     .5},
    {"a ball on the ground",
     CAMERA
     "- { object: Plane, " GLOWS("[.5, .25, .125]") " }\n- { object: Sphere, " GLASS
                                                    ", transform: { translation: [0, 0, 1] } }\n",
     1},
    {"a box behind a pane",
     CAMERA "- { object: Box, " GLOWS(
         "[1, 1, .5]") ", transform: { rotation: [.3, .2, .7] } }\n- { object: "
                       "Parallelogram, u: [9, 0, .3], v: [0, .3, 9], " GLASS
                       ", transform: { translation: [-4, -2, -2] } }\n",
     .3},
};

/* Root mean square difference of pixels, as sRGB in [0, 1]. */
static double difference(const float *a, const float *b)
{
    double sum = 0;
    for (int i = 0; i < WIDTH * HEIGHT * 4; i++)
        sum += (a[i] - b[i]) * (double)(a[i] - b[i]);
    return sqrt(sum / (WIDTH * HEIGHT));
}

static void nothing_is_worse(void **state)
{
    (void)state;
    const MatcOptions options = frame_exact_options();
    GlContext *gl = frame_context();
    int faults = 0;
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        MatcDocument *document;
        Scene *scene = frame_scene(cases[i].text, &options, &document);
        RendererOptions ways[] = {{.samples = SAMPLES},
                                  {.edges = RENDERER_EDGES_none},
                                  {.edges = RENDERER_EDGES_coverage}};
        float *pictures[3];
        for (int way = 0; way < 3; way++) {
            ways[way].compile = &options;
            pictures[way] = frame_floats(gl, scene, &ways[way]);
        }
        const double none = difference(pictures[1], pictures[0]),
                     edges = difference(pictures[2], pictures[0]);
        print_message("%-22s one sample off by %.4f, edges by %.4f\n", cases[i].name, none, edges);
        faults += !(none > 1e-3 && edges <= none * cases[i].share);
        for (int way = 0; way < 3; way++)
            free(pictures[way]);
        frame_forget(scene, document);
    }
    gl_close(gl);
    assert_int_equal(faults, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(nothing_is_worse)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
