/* The library's surface: what a material is at a point. */
#include "compiler/evaluate.h"
#include "compiler/choice.h"
#include "compiler/document.h"
#include "compiler/pipeline.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* "u=0.3 v=0.4 front=0" */
static const char *read_point(Surface *surface, const char *point)
{
    for (const char *at = point; *(at += strspn(at, " ,\t\n"));) {
        size_t size = strcspn(at, " ,\t\n"), name = strcspn(at, "=");
        char key[16] = {0};
        double value;
        if (name >= size || name >= sizeof key || !text_number(at + name + 1, size - name - 1, &value) ||
            !isfinite(value))
            return "a point is a list of channel=number";
        memcpy(key, at, name);
        if (!strcmp(key, "front"))
            surface->front = value != 0;
        else if (!oracle_surface_set(surface, key, value))
            return "no such channel; see --list";
        at += size;
    }
    return NULL;
}

bool evaluate_material(const MatcDocument *d, int material, const MatcOptions *options, SurfacePoints points,
                       SlotValues *values)
{
    Job job;
    choice_job(options, &job);
    const ReferenceContext context = {.noise = job_noise(job.choice[AXIS_noise], job.target)};
    Oracle *oracle = oracle_open(d->graph, &context);
    oracle_derivatives(oracle, (Choice)job.choice[AXIS_derivatives]);
    bool known = true;
    double work = 0;
    for (int i = 0; i < points.count && known; i++) {
        known = oracle_material(oracle, d->graph->materials[material].node, &points.at[i], &values[i]);
        work += oracle_work(oracle);
        known = known && work <= (double)LIMIT_WORK * LIMIT_WORK_POINTS;
    }
    oracle_close(oracle);
    return known;
}

char *matc_eval(const MatcDocument *d, int material, const char *point, const MatcOptions *options, const char **fault)
{
    Job job;
    Surface surface;
    SlotValues values;
    Arena arena = {0};
    Text out = text_new(&arena);
    const MatcOptions whole = choice_whole_options(options);
    oracle_surface_default(&surface);
    *fault = choice_job(&whole, &job) ? "an option has no such value; see matc_options_fault" : read_point(&surface, point);
    if (!*fault && (!d->graph || material < 0 || material >= d->graph->material_count))
        *fault = "no such material";
    if (!*fault && !evaluate_material(d, material, &whole, (SurfacePoints){&surface, 1}, &values))
        *fault = "the value takes too many operations: filters within filters, over maps that cost much";
    if (!*fault) {
        for (int slot = 0; slot < SLOT_COUNT; slot++) {
            text_put(&out, slot_table[slot].name);
            for (int i = 0; i < type_table[slot_table[slot].type].lanes; i++) {
                text_char(&out, ' ');
                text_double(&out, values.lane[slot][i]);
            }
            text_char(&out, '\n');
        }
    }
    char *result = *fault ? NULL : strdup(out.at);
    arena_free(&arena);
    return result;
}
