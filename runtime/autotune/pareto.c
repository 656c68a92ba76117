/* Formats tables and plots, and applies the measured choices. */
#include "runtime/autotune/pareto.h"
#include "compiler/base/memory.h"
#include "compiler/base/output.h"
#include "runtime/autotune/plot.h"
#include "runtime/gl/message.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_PATH = 4096 };
static const double pareto_seconds = 40, choose_seconds = 20, picture_scale = 2;

static PlotPoint *make_points(const MeasuredList *list, bool aliasing, char (*names)[VARIANT_NAME])
{
    PlotPoint *points = calloc((size_t)list->count + 1, sizeof *points);
    if (!points)
        memory_exhausted();
    for (int i = 0; i < list->count; i++) {
        const Measured *m = &list->at[i];
        variant_name(&m->variant, &list->at[0].variant, names[i]);
        points[i] = (PlotPoint){.x = m->nanoseconds,
                                .y = aliasing ? m->aliasing : m->error,
                                .front = aliasing ? m->alias_front : m->front,
                                .named = i == 0,
                                .label = names[i]};
    }
    return points;
}

char *pareto_svg(const MeasuredList *list, const char *title, const GlContext *gl)
{
    char note[512];
    char(*names)[VARIANT_NAME] = calloc((size_t)list->count + 1, sizeof *names);
    if (!names)
        memory_exhausted();
    PlotPoint *errors = make_points(list, false, names), *aliasing = make_points(list, true, names);
    snprintf(note, sizeof note, "%d variants on %s; the time of a constant color is subtracted",
             list->count, gl->renderer);
    const PlotPanel panels[] = {{"Greatest error of a slot, packed and read back", "ns a pixel",
                                 "error", errors, list->count},
                                {"Aliasing on a plane up to its horizon", "ns a pixel",
                                 "RMS of the worst slot", aliasing, list->count}};
    char *svg = plot_svg(&(Plot){title, note, panels, 2, 2});
    free(errors);
    free(aliasing);
    free(names);
    return svg;
}

static bool write_text(const char *basename, const char *suffix, const char *text,
                       ParetoChoice *answer)
{
    char path[LONGEST_PATH];
    snprintf(path, sizeof path, "%s%s", basename, suffix);
    const char *why = output_write(path, text, strlen(text));
    return !why || message_fail(answer->error, sizeof answer->error, "%s: %s", path, why);
}

/* Writes CSV, SVG and PNG. A missing PNG library is not an error: `out` reports the missing
 * file. */
static bool write_files(const ParetoSubject *subject, const MeasuredList *list, const GlContext *gl,
                        FILE *out, ParetoChoice *answer)
{
    char path[LONGEST_PATH], reason[512];
    const char *name = matc_material_name(subject->document, subject->material),
               *basename = subject->basename;
    char *csv = autotune_csv(list, name, gl, true), *svg = pareto_svg(list, name, gl);
    bool done =
        write_text(basename, ".csv", csv, answer) && write_text(basename, ".svg", svg, answer);
    snprintf(path, sizeof path, "%s.png", basename);
    if (done && !plot_png(svg, picture_scale, path, reason, sizeof reason))
        fprintf(out, "no %s: %s\n", path, reason);
    free(csv);
    free(svg);
    return done;
}

static void put_summary(FILE *out, const MeasuredList *list, const Meter *meter)
{
    char name[VARIANT_NAME];
    Variant none = list->at[0].variant;
    for (int axis = 0; axis < AXIS_COUNT; axis++)
        none.choice[axis] = -1;
    none.layout = -1;
    variant_name(&list->at[0].variant, &none, name);
    fprintf(out, "as given: %s\n", name);
    fprintf(out, "front: e, no variant is faster with less error; a, no variant is faster with "
                 "less aliasing\n");
    fprintf(out, "%d programs on %s; the time of a constant color, %.3f ns/pixel, is subtracted",
            list->count, meter->gl->renderer, list->constant);
    if (list->same)
        fprintf(out, "; %d variants are the same as one of them", list->same);
    if (list->refused)
        fprintf(out, "; %d cannot be had", list->refused);
    if (list->left_out)
        fprintf(out, "; %d skipped for lack of time", list->left_out);
    fputc('\n', out);
}

static AutotuneRequest request_of(const ParetoSubject *subject, const MatcOptions *options,
                                  VariantAxes open, double seconds)
{
    return (AutotuneRequest){.document = subject->document,
                             .material = subject->material,
                             .options = options,
                             .open = open,
                             .range = subject->range,
                             .progress = subject->progress,
                             .user = subject->user,
                             .seconds = seconds};
}

bool pareto_measure(const ParetoSubject *subject, const MatcOptions *options, ParetoChoice *answer)
{
    MeasuredList list;
    size_t size;
    Meter *meter = meter_open(subject->gl, answer->error, sizeof answer->error);
    if (!meter)
        return false;
    AutotuneRequest request = request_of(subject, options, variant_open(options), pareto_seconds);
    request.aliasing = true;
    bool done = autotune_variants(meter, &request, &list) ||
                message_fail(answer->error, sizeof answer->error, "%s", meter->error);
    FILE *out = done ? open_memstream(&answer->text, &size) : NULL;
    if (out) {
        char *lines = autotune_table(&list);
        fputs(lines, out);
        put_summary(out, &list, meter);
        free(lines);
        done = !subject->basename || write_files(subject, &list, meter->gl, out, answer);
        fclose(out);
        autotune_free(&list);
        if (!done)
            free(answer->text);
    }
    meter_close(meter);
    return done && out;
}

/* Returns the axes that change the precision of a program but not what is computed. */
static VariantAxes open_for_choice(const MatcOptions *options)
{
    VariantAxes open = variant_open(options);
    open.axis[AXIS_noise] = open.axis[AXIS_aa] = open.axis[AXIS_derivatives] = false;
    return open;
}

static const char *worst_slot(const Measured *m)
{
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (m->packed[slot].maximum == m->error)
            return slot_table[slot].name;
    return "?";
}

/* Formats the names of all choices that were open. */
static void chosen_name(const Measured *m, const VariantAxes *open, char name[VARIANT_NAME])
{
    Variant other = m->variant;
    for (int axis = 0; axis < AXIS_COUNT; axis++)
        if (open->axis[axis])
            other.choice[axis] = -1;
    if (open->layout)
        other.layout = -1;
    variant_name(&m->variant, &other, name);
}

static char *explain(const MeasuredList *list, int chosen, double most, const VariantAxes *open,
                     const Meter *meter)
{
    char *text = NULL, name[VARIANT_NAME];
    size_t size;
    const Measured *m = &list->at[chosen];
    FILE *out = open_memstream(&text, &size);
    if (!out)
        memory_exhausted();
    chosen_name(m, open, name);
    fprintf(out,
            "chosen: %s, because it is the fastest of %d within %g: %.3f ns/pixel, error %.3g "
            "(%s), on %s\n",
            name, list->count, most, m->nanoseconds, m->error, worst_slot(m), meter->gl->renderer);
    for (int i = 0; i < list->count; i++)
        if (list->at[i].nanoseconds < m->nanoseconds && list->at[i].error > most) {
            chosen_name(&list->at[i], open, name);
            fprintf(out, "not:    %s: %.3f ns/pixel, error %.3g (%s)\n", name,
                    list->at[i].nanoseconds, list->at[i].error, worst_slot(&list->at[i]));
        }
    fclose(out);
    return text;
}

static bool refuse(const MeasuredList *list, int best, double most, const VariantAxes *open,
                   ParetoChoice *answer)
{
    char name[VARIANT_NAME];
    chosen_name(&list->at[best], open, name);
    return message_fail(answer->error, sizeof answer->error,
                        "no choice keeps every slot within %g; the best is %s: %.3g (%s)", most,
                        name, list->at[best].error, worst_slot(&list->at[best]));
}

/* Sets the choices of the varied axes in the options. */
static void take(const Variant *variant, const VariantAxes *open, MatcOptions *options)
{
    if (open->layout)
        options->layout = layout_table[variant->layout].name;
    for (int axis = 0; axis < AXIS_COUNT; axis++) {
        if (!open->axis[axis])
            continue;
        matc_options_set(options, axis_table[axis].name, choice_table[variant->choice[axis]].name);
        options->measured |= 1u << axis;
    }
}

bool pareto_choose(const ParetoSubject *subject, double most, MatcOptions *options,
                   ParetoChoice *answer)
{
    MeasuredList list;
    int best;
    Meter *meter = meter_open(subject->gl, answer->error, sizeof answer->error);
    if (!meter)
        return false;
    const AutotuneRequest request =
        request_of(subject, options, open_for_choice(options), choose_seconds);
    bool done = autotune_variants(meter, &request, &list) ||
                message_fail(answer->error, sizeof answer->error, "%s", meter->error);
    if (done) {
        int chosen = autotune_choose(&list, most, &best);
        done = chosen >= 0 || refuse(&list, best, most, &request.open, answer);
        if (done) {
            answer->text = explain(&list, chosen, most, &request.open, meter);
            take(&list.at[chosen].variant, &request.open, options);
        }
        autotune_free(&list);
    }
    meter_close(meter);
    return done;
}
