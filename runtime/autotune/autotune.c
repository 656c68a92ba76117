/* Measures the errors of all variants one after the other, then their times together. */
#include "runtime/autotune/candidates.h"
#include "runtime/autotune/errors.h"
#include "runtime/gl/message.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

const double measure_range = 4;

enum { MIN_ROUNDS = 5, SOFTWARE_SIDE = 512, HARDWARE_SIDE = 2048 };

typedef struct {
    Errors errors;
    Meter *meter;
    const AutotuneRequest *request;
    Material *materials; /* materials of pass gbuffer, parallel to list->at */
    double start;
} Work;

/* Errors get two thirds of the time budget, timing the rest. */
static bool has_time(const Work *w) { return meter_now() - w->start < w->request->seconds * 2 / 3; }

static void measure_errors(Work *w, Candidate *candidates, int count, MeasuredList *list)
{
    list->at = errors_allocate((size_t)count, sizeof *list->at);
    w->materials = errors_allocate((size_t)count, sizeof *w->materials);
    for (int i = 0; i < count; i++) {
        Measured *m = &list->at[list->count];
        Material *material = &w->materials[list->count];
        if (w->request->progress)
            w->request->progress(w->request->user, i, count);
        if (i > 0 && !has_time(w)) {
            list->left_out++;
            continue;
        }
        *m = (Measured){.variant = candidates[i].variant};
        if (!errors_measure(&w->errors, m, candidates[i].program, material)) {
            material_delete(material);
            list->refused++;
            continue;
        }
        list->count++;
    }
}

/* Creates the render targets for timing: one set per layout, and one of the constant color. */
static bool make_targets(Work *w, const MeasuredList *list, Framebuffer targets[LAYOUT_COUNT],
                         Framebuffer *plain)
{
    int side = w->meter->gl->hardware ? HARDWARE_SIDE : SOFTWARE_SIDE;
    FramebufferSpec spec = {
        .width = side, .height = side, .color_count = 1, .color_format = GL_RGBA16F};
    for (int i = 0; i < list->count; i++) {
        int layout = list->at[i].variant.layout;
        if (!targets[layout].name &&
            !meter_make_targets(w->meter, (Layout)layout, side, side, &targets[layout]))
            return false;
    }
    return framebuffer_make(w->meter->gl, &spec, plain) ||
           message_fail(w->meter->error, sizeof w->meter->error, "%s", w->meter->gl->error);
}

/* Returns the number of timing rounds that fit into the remaining time. */
static int find_rounds(Work *w, const MeterDraw *draws, int count)
{
    double *scratch = errors_allocate((size_t)count, sizeof *scratch), start = meter_now();
    meter_time(w->meter, draws, count, 1, scratch);
    double once = meter_now() - start, left = w->request->seconds - (start - w->start) - once;
    free(scratch);
    return (int)clamp(left / fmax(once, 1e-3) - 2, MIN_ROUNDS, MEASURE_ROUNDS);
}

static bool measure_times(Work *w, MeasuredList *list)
{
    Framebuffer targets[LAYOUT_COUNT], plain;
    Material constant = {0};
    MeterDraw *draws = errors_allocate((size_t)list->count + 1, sizeof *draws);
    double *nanoseconds = errors_allocate((size_t)list->count + 1, sizeof *nanoseconds);
    memset(targets, 0, sizeof targets);
    memset(&plain, 0, sizeof plain);
    bool fine = make_targets(w, list, targets, &plain) && meter_make_constant(w->meter, &constant);
    draws[0] = (MeterDraw){&constant, &w->errors.view, &plain};
    for (int i = 0; i < list->count; i++)
        draws[1 + i] =
            (MeterDraw){&w->materials[i], &w->errors.view, &targets[list->at[i].variant.layout]};
    fine = fine && meter_time(w->meter, draws, list->count + 1,
                              find_rounds(w, draws, list->count + 1), nanoseconds);
    list->constant = nanoseconds[0];
    for (int i = 0; i < list->count; i++)
        list->at[i].nanoseconds = fmax(0, nanoseconds[1 + i] - nanoseconds[0]);
    for (int i = 0; i < LAYOUT_COUNT; i++)
        framebuffer_delete(w->meter->gl, &targets[i]);
    framebuffer_delete(w->meter->gl, &plain);
    material_delete(&constant);
    free(nanoseconds);
    free(draws);
    return fine;
}

static void mark_fronts(MeasuredList *list)
{
    FrontPoint *points = errors_allocate((size_t)list->count, sizeof *points);
    for (int front = 0; front < 2; front++) {
        for (int i = 0; i < list->count; i++)
            points[i] = (FrontPoint){list->at[i].nanoseconds,
                                     front ? list->at[i].aliasing : list->at[i].error, false};
        front_mark(points, list->count);
        for (int i = 0; i < list->count; i++)
            *(front ? &list->at[i].alias_front : &list->at[i].front) = points[i].front;
    }
    free(points);
}

static void discard(Work *w, int materials)
{
    for (int i = 0; i < materials; i++)
        material_delete(&w->materials[i]);
    errors_close(&w->errors);
    free(w->materials);
    free(w);
}

/* Measures the errors of all candidates, then the times of those that could be drawn. */
static bool measure_candidates(Work *w, MeasuredList *list)
{
    int count;
    Candidate *candidates = candidates_make(w->request, list, &count);
    measure_errors(w, candidates, count, list);
    for (int i = 0; i < count; i++)
        matc_program_free(candidates[i].program);
    free(candidates);
    char *error = w->meter->error;
    if (list->count == 0)
        return *error ||
               message_fail(error, sizeof w->meter->error,
                            "the material does not compile with any of the requested choices");
    return measure_times(w, list);
}

bool autotune_variants(Meter *meter, const AutotuneRequest *request, MeasuredList *list)
{
    Work *w = errors_allocate(1, sizeof *w);
    Variant base;
    *list = (MeasuredList){0};
    w->meter = meter;
    w->request = request;
    w->start = meter_now();
    *meter->error = 0;
    variant_of(request->options, &base);
    bool fine = errors_open(&w->errors, meter, request) && errors_has_truth(&w->errors, &base);
    fine = fine && measure_candidates(w, list) && list->count > 0;
    if (fine)
        mark_fronts(list);
    discard(w, list->count);
    if (!fine)
        autotune_free(list);
    return fine;
}

void autotune_free(MeasuredList *list)
{
    free(list->at);
    *list = (MeasuredList){0};
}
