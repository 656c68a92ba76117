/* matbench indirect quality: time and error of each value of `quality:`, in the box of
 * indirect_scenes.h. The error is the root mean square over all pixels against 64 sets of 64
 * rays without a filter; for light it is relative to the mean. The time is that of the passes
 * that run in each frame, relative to `normal`, timed alternately. */
#include "indirect_quality.h"
#include "grammar/tables.h"
#include "tests/bench/matbench.h"
#include "runtime/scene_reader/scene_read.h"
#include "tests/frame/indirect_scenes.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT = 4096, FRAMES = 9, QUALITIES = KEYWORD_Quality_fine - KEYWORD_Quality_draft + 1 };

static const char truth_keys[] = "rays: 64, samples: 64, filter: none";

static const struct {
    const char *view, *keys;
    int components;
} views[] = {{"ao", "radius: .5, bounces: 0", 1}, {"indirect", "radius: 4", 3}};
enum { VIEWS = sizeof views / sizeof *views };

typedef struct {
    MatcDocument *document;
    Scene *scene;
    Renderer *render;
    float *values; /* four a pixel */
    double least;  /* seconds */
} Drawn;

static void close_drawn(Drawn *drawn)
{
    free(drawn->values);
    renderer_close(drawn->render);
    scene_free(drawn->scene);
    matc_document_free(drawn->document);
}

static bool draw(GlContext *gl, const IndirectQuality *q, int view, const char *keys, Drawn *drawn)
{
    char text[TEXT];
    MatcOptions compile;
    matc_options_init(&compile);
    compile.pixels = true;
    snprintf(text, sizeof text, "image: { width: %d, height: %d }\nindirect: { %s, %s }\n%s",
             q->edge, q->edge, views[view].keys, keys, indirect_scenes_box);
    drawn->document = scene_read("scene.yaml", text, strlen(text), &compile, &drawn->scene);
    if (!drawn->scene)
        return fputs(matc_diagnostics(drawn->document, MATC_TEXT), stderr), false;
    drawn->values = calloc((size_t)q->edge * (size_t)q->edge, 4 * sizeof *drawn->values);
    drawn->render =
        renderer_open(gl, &(RendererOptions){.compile = &compile, .view = views[view].view});
    return (drawn->values && drawn->render && renderer_set_scene(drawn->render, drawn->scene) &&
            renderer_frame(drawn->render) && renderer_read(drawn->render, drawn->values)) ||
           fprintf(stderr, "matbench: %s\n", gl->error) < 0;
}

static void time_frame(Drawn *drawn, bool first)
{
    static const char *const passes[] = {"rays", "temporal", "denoise", "upsample"};
    RendererPassTime times[RENDERER_PASSES_MAX];
    double sum = 0;
    for (int count = renderer_time_passes(drawn->render, times), i = 0; i < count; i++)
        for (size_t k = 0; k < sizeof passes / sizeof *passes; k++)
            sum += strcmp(times[i].name, passes[k]) ? 0 : times[i].seconds;
    drawn->least = first ? sum : fmin(drawn->least, sum);
}

static double error_of(const Drawn *drawn, const Drawn *truth, int edge, int components)
{
    double squares = 0, sum = 0;
    for (int i = 0; i < edge * edge; i++)
        for (int k = 0; k < components; k++) {
            const double is = (double)truth->values[4 * i + k];
            squares += pow((double)drawn->values[4 * i + k] - is, 2);
            sum += is;
        }
    const double count = (double)edge * edge * components;
    return sqrt(squares / count) / (components > 1 ? sum / count : 1);
}

static bool measure(GlContext *gl, const IndirectQuality *q, int view)
{
    Drawn truth = {0}, drawn[QUALITIES] = {{0}};
    bool fine = draw(gl, q, view, truth_keys, &truth);
    for (int i = 0; fine && i < QUALITIES; i++) {
        char keys[TEXT];
        snprintf(keys, sizeof keys, "quality: %s", keyword_table[KEYWORD_Quality_draft + i].name);
        fine = draw(gl, q, view, keys, &drawn[i]);
    }
    for (int frame = 0; fine && q->timed && frame < FRAMES; frame++)
        for (int i = 0; i < QUALITIES; i++)
            time_frame(&drawn[i], frame == 0);
    const Drawn *normal = &drawn[KEYWORD_Quality_normal - KEYWORD_Quality_draft];
    for (int i = 0; fine && i < QUALITIES; i++)
        printf("%-10s %-8s %8.4f %8s\n", views[view].view,
               keyword_table[KEYWORD_Quality_draft + i].name,
               error_of(&drawn[i], &truth, q->edge, views[view].components),
               NUMBER(2, q->timed ? drawn[i].least / normal->least : NAN));
    fflush(stdout);
    for (int i = 0; i < QUALITIES; i++)
        close_drawn(&drawn[i]);
    close_drawn(&truth);
    return fine;
}

bool bench_indirect_quality(GlContext *gl, const IndirectQuality *quality)
{
    bool fine = true;
    printf("\nqualities of indirect light, %d x %d: error against `%s`, of light over its mean; "
           "time of each frame's passes over that of normal\n%-10s %-8s %8s %8s\n",
           quality->edge, quality->edge, truth_keys, "view", "quality", "error", "time");
    for (int i = 0; fine && i < VIEWS; i++)
        fine = measure(gl, quality, i);
    return fine;
}
