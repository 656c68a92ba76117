/* matbench indirect path: a camera moves around a ball and boxes in 60 frames. Measures the
 * error of ambient occlusion, and its change from frame to frame, which is visible as flicker,
 * by the share of history that is kept. */
#include "indirect_path.h"
#include "tests/bench/matbench.h"
#include "runtime/scene_reader/scene_read.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { EDGE = 96, PIXELS = EDGE * EDGE, STEPS = 60, TEXT = 2048 };

static const char body[] =
    "image: { width: 96, height: 96 }\ncamera: { camera: Perspective, position: [.4, -4, 1.8], "
    "target: [0, 0, .6], "
    "angle: 40 }\nmaterials: { m: { material: Phong, diffuse: .6 } }\nobjects:\n"
    "- { object: Box, material: m, size: [3, 3, .2], transform: { translation: [0, 0, -.1] } }\n"
    "- { object: Box, material: m, size: [3, .2, 2], transform: { translation: [0, .7, 1] } }\n"
    "- { object: Sphere, radius: .4, detail: 48, material: m, transform: { translation: [-.5, -.5, "
    ".4] } }\n"
    "- { object: Box, material: m, size: [.5, .5, .9], transform: { translation: [.5, -.2, .45], "
    "rotation: [0, 0, .4] "
    "} "
    "}\n";

/* The first one is the reference of the others. */
static const char *const ways[] = {"samples: 16",
                                   "filter: none",
                                   "filter: none, history: 16",
                                   "rays: 8",
                                   "rays: 8, history: 16",
                                   "rays: 4",
                                   "rays: 4, history: 16",
                                   "rays: 2, history: 16",
                                   "rays: 8, moving: half",
                                   "rays: 8, moving: quarter",
                                   "rays: 8, filter: atrous",
                                   "rays: 8, filter: atrous, history: 16",
                                   "rays: 4, filter: atrous, history: 16"};
enum { WAYS = sizeof ways / sizeof *ways };

typedef struct {
    MatcDocument *document;
    Scene *scene;
    Renderer *render;
    float now[4 * PIXELS];
    double error[PIXELS]; /* errors of the previous frame */
    double off, flicker;  /* sums of mean squares */
} Path;

static bool open_path(GlContext *gl, const char *keys, Path *p)
{
    char text[TEXT];
    MatcOptions compile;
    matc_options_init(&compile);
    compile.pixels = true;
    snprintf(text, sizeof text, "indirect: { radius: 1, bounces: 0, %s }\n%s", keys, body);
    p->document = scene_read("scene.yaml", text, strlen(text), &compile, &p->scene);
    if (!p->scene)
        return fputs(matc_diagnostics(p->document, MATC_TEXT), stderr), false;
    p->render = renderer_open(gl, &(RendererOptions){.compile = &compile, .view = "ao"});
    return p->render && renderer_set_scene(p->render, p->scene);
}

static bool step(Path *p, int number)
{
    const double angle = .01 * number, far = 4 - .008 * number;
    p->scene->camera.position[0] = .4 + far * sin(angle);
    p->scene->camera.position[1] = -far * cos(angle);
    return renderer_changed(p->render, RENDERER_CAMERA) && renderer_frame(p->render) &&
           renderer_read(p->render, p->now);
}

static void compare(Path *p, const Path *truth, bool first)
{
    for (int i = 0; i < PIXELS; i++) {
        const double error = (double)p->now[4 * i] - (double)truth->now[4 * i],
                     change = error - p->error[i];
        p->off += error * error / PIXELS / STEPS;
        p->flicker += first ? 0 : change * change / PIXELS / (STEPS - 1);
        p->error[i] = error;
    }
}

bool bench_indirect_path(GlContext *gl)
{
    static Path paths[WAYS];
    bool fine = true;
    memset(paths, 0, sizeof paths);
    for (int i = 0; fine && i < WAYS; i++)
        fine = open_path(gl, ways[i], &paths[i]);
    for (int k = 0; fine && k < STEPS; k++)
        for (int i = 0; fine && i < WAYS; i++) {
            fine = step(&paths[i], k);
            compare(&paths[i], &paths[0], k == 0);
        }
    printf("\na camera's path of %d frames, %d x %d: openness, root of the mean square against %s, "
           "and of what that "
           "differs by from frame to frame\n%-38s %10s %10s\n",
           STEPS, EDGE, EDGE, ways[0], "keys", "off", "flicker");
    for (int i = 1; fine && i < WAYS; i++)
        printf("%-38s %10.4f %10.4f\n", ways[i], sqrt(paths[i].off), sqrt(paths[i].flicker));
    if (!fine)
        fprintf(stderr, "matbench: %s\n", gl->error);
    for (int i = 0; i < WAYS; i++) {
        renderer_close(paths[i].render);
        scene_free(paths[i].scene);
        matc_document_free(paths[i].document);
    }
    return fine;
}
