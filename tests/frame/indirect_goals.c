/* Rows of goals: a scene each, drawn with several settings. */
#include "tests/frame/indirect_goals.h"
#include "runtime/renderer/passes.h"
#include "tests/frame/frame_draw.h"
#include "tests/frame_reference/indirect_truth.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { EDGE = 512, TEXT = 4096, FRAMES = 15 };

/* Time of the thesis' ambient occlusion march under llvmpipe on two cores; times of goals are
 * relative to it. */
static const double march_milliseconds = 1700;

typedef struct {
    const char *name, *view;
    double radius;
    int across;               /* rays of a place: across * across */
    double off, milliseconds; /* upper bounds */
} Goal;

static const Goal goals[] = {{"openness, box", "ao", .5, 64, .010, 250},
                             {"openness, bunny", "ao", .75, 64, .010, 250},
                             {"light, box", "indirect", 4, 40, .03, 500}};
static const char *const usual[] = {"rays: 8", "method: voxels"};

static bool is_light(const Goal *goal) { return !strcmp(goal->view, "indirect"); }

/* CPU time of this process on all cores, hardly affected by other programs. */
static double processor_seconds(void)
{
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

/* Seconds per frame of the passes that indirect light adds; excludes work done once per scene. */
static double pass_time(Renderer *renderer)
{
    static const char *const passes[] = {"rays", "temporal", "denoise", "upsample"};
    renderer->gl->Finish();
    const double begin = processor_seconds();
    for (int i = 0; i < frame_pass_count(); i++)
        for (size_t pass = 0; pass < sizeof passes / sizeof *passes; pass++)
            if (renderer->targets.plan.runs >> i & 1 &&
                !strcmp(frame_pass(i)->plan.name, passes[pass]))
                frame_pass(i)->draw(renderer);
    renderer->gl->Finish();
    return processor_seconds() - begin;
}

/* Ratio of both minimum times, measured alternately, so that other load affects both. */
static double share_of_time(Renderer *renderer, Renderer *march)
{
    double least[2] = {INFINITY, INFINITY};
    for (int i = 0; i < FRAMES; i++) {
        least[0] = fmin(least[0], pass_time(renderer));
        least[1] = fmin(least[1], pass_time(march));
    }
    return least[0] / least[1];
}

static void put_scene(const IndirectGoals *g, const Goal *goal, const char *keys, char text[TEXT])
{
    char body[INDIRECT_SCENES_TEXT];
    indirect_scenes_bunny(g->mesh ? g->mesh : "", g->lift, body);
    snprintf(text, TEXT,
             "image: { width: %d, height: %d }\nindirect: { radius: %g, bounces: %d, %s }\n%s",
             EDGE, EDGE, goal->radius, is_light(goal), keys,
             strstr(goal->name, "bunny") ? body : indirect_scenes_box);
}

typedef struct {
    const IndirectGoals *goals;
    const Goal *goal;
    GlContext *gl;
    MatcOptions options;
    IndirectTruth *truth;
    Renderer *march;
    MatcDocument *march_document;
    Scene *march_scene;
} Row;

/* Opens the thesis' march in the box, and draws it once. */
static void open_march(Row *row)
{
    char text[TEXT];
    row->goal = &goals[0];
    put_scene(row->goals, row->goal, "method: march, rays: 32, steps: 32, filter: none", text);
    row->march_scene = frame_scene(text, &row->options, &row->march_document);
    row->march = renderer_open(row->gl, &(RendererOptions){.compile = &row->options, .view = "ao"});
    free(frame_floats_by(row->gl, row->march, row->march_scene));
}

/* Returns false if the error or the time exceeds its bound. */
static bool put_row(Row *row, const char *keys)
{
    char text[TEXT], time[32] = "";
    MatcDocument *document;
    const Goal *goal = row->goal;
    put_scene(row->goals, goal, keys, text);
    Scene *scene = frame_scene(text, &row->options, &document);
    if (!row->truth->count)
        indirect_truth_find(
            scene, &(OpenRays){.across = goal->across, .radius = goal->radius, .bounces = 1},
            is_light(goal) ? &row->options : NULL, row->truth);
    Renderer *renderer =
        renderer_open(row->gl, &(RendererOptions){.compile = &row->options, .view = goal->view});
    float *rgba = frame_floats_by(row->gl, renderer, scene);
    const double off = indirect_truth_off(row->truth, rgba, is_light(goal)),
                 share = row->goals->timed ? share_of_time(renderer, row->march) : 0;
    if (row->goals->timed)
        snprintf(time, sizeof time, "%.3f", share);
    const bool exact = off <= goal->off + 5e-4,
               fast = share * march_milliseconds <= goal->milliseconds;
    printf("| %s | `%s` | %.4f | %.3f, %s | %s | %.3f%s |\n", goal->name, keys, off, goal->off,
           exact ? "reached" : "missed", time, goal->milliseconds / march_milliseconds,
           !row->goals->timed ? ""
           : fast             ? ", reached"
                              : ", missed");
    fflush(stdout);
    renderer_close(renderer);
    free(rgba);
    frame_forget(scene, document);
    return exact && fast;
}

bool indirect_goals_print(const IndirectGoals *g)
{
    Row row = {.goals = g,
               .options = frame_exact_options(),
               .gl = frame_context(),
               .truth = malloc(sizeof *row.truth)};
    open_march(&row);
    const int count = g->key_count ? g->key_count : (int)(sizeof usual / sizeof *usual);
    bool fine = row.truth != NULL;
    printf("| | keys | off | at most | of the march's time | at most |\n| --- | --- | --- | --- | "
           "--- | --- |\n");
    for (size_t i = 0; row.truth && i < sizeof goals / sizeof *goals; i++) {
        row.goal = &goals[i];
        row.truth->count = 0;
        if (strstr(goals[i].name, "bunny") && !g->mesh)
            continue;
        for (int k = 0; k < count; k++)
            fine = put_row(&row, g->key_count ? g->keys[k] : usual[k]) && fine;
    }
    renderer_close(row.march);
    frame_forget(row.march_scene, row.march_document);
    free(row.truth);
    gl_close(row.gl);
    return fine;
}
