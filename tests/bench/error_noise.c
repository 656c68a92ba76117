/* Speed of noise, and the time and error when octaves fade with distance. */
#include "error.h"
#include "matbench.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SIDE = 512, ROUNDS = 25, QUICK_ROUNDS = 7, MOST = 16 };

/* Cells of the first octave per pixel; size of the picture whose error is measured, and its
 * samples per pixel along an axis: at a distance where all octaves have faded, a pixel's true
 * mean needs thousands of samples. */
typedef struct {
    double cells;
    int side, samples;
} View;
static const View distances[] = {{0.2, SIDE, 16}, {2, SIDE, 16}, {128, 64, 128}};

static const char noise_document[] = "material: Phong\ndiffuse: { map: VolumeTurbulence, octaves: "
                                     "1, size: 8, frequency: 0.5, phase: 0.5 }\n";
static const char octaves_document[] =
    "material: Phong\ndiffuse: { map: VolumeTurbulence, octaves: 8, noiseRatio: 0.5, "
    "frequency: 0.5, phase: 0.5 }\n";

/* A square of 2 x `extent` units that fills the picture, seen perpendicularly. */
static bool make_square(Meter *m, double extent, Field *made)
{
    FieldVertex corners[4];
    memset(corners, 0, sizeof corners);
    for (int i = 0; i < 4; i++) {
        FieldVertex *v = &corners[i];
        const float x = i % 2 ? 1 : -1, y = i < 2 ? -1 : 1, reach = (float)extent;
        v->at[0] = 1.1f * x;
        v->at[1] = 1.1f * y;
        v->at[3] = 1;
        v->input[INPUT_N][2] = v->input[INPUT_eyeN][2] = v->input[INPUT_DU][0] =
            v->input[INPUT_DV][1] = 1;
        v->input[INPUT_XU][0] = v->input[INPUT_XV][1] = 1;
        for (int k = 0; k < 3; k++) {
            float at = 1.1f * reach * (k == 0 ? x : k == 1 ? y : 0.1f * x + 0.3f);
            v->input[INPUT_P][k] = v->input[INPUT_X][k] = at;
            v->input[INPUT_U][k] = k < 2 ? at : 0;
        }
    }
    return field_make(m->gl, corners, 4, GL_TRIANGLE_STRIP, made);
}

typedef struct {
    char name[VARIANT_NAME];
    Material material;
    double nanoseconds;
} Timed;

/* Every choice of an axis; returns how many compile. */
static int make_choices(ErrorBench *bench, const MatcDocument *document, Axis axis,
                        Timed list[MOST])
{
    Variant base, variant;
    MatcOptions options;
    int count = 0;
    matc_options_init(&options);
    variant_of(&options, &base);
    for (int i = 0; i < axis_choices(axis) && count < MOST; i++) {
        variant = base;
        variant.choice[axis] = axis_table[axis].first + i;
        snprintf(list[count].name, VARIANT_NAME, "%s=%s", axis_table[axis].name,
                 choice_table[variant.choice[axis]].name);
        count += error_material(bench, document, &variant, &list[count].material);
    }
    return count;
}

static bool time_choices(ErrorBench *bench, const Field *field, const Framebuffer *target,
                         Timed *list, int count)
{
    Material constant;
    MeterDraw draws[MOST + 1];
    double nanoseconds[MOST + 1];
    if (!meter_make_constant(bench->meter, &constant))
        return false;
    draws[0] = (MeterDraw){&constant, field, target};
    for (int i = 0; i < count; i++)
        draws[1 + i] = (MeterDraw){&list[i].material, field, target};
    bool done = meter_time(bench->meter, draws, count + 1, bench->quick ? QUICK_ROUNDS : ROUNDS,
                           nanoseconds);
    for (int i = 0; i < count; i++)
        list[i].nanoseconds = fmax(nanoseconds[1 + i] - nanoseconds[0], 1e-3);
    material_delete(&constant);
    return done;
}

static void report_noise(ErrorBench *bench, const Timed *list, int count)
{
    FILE *out = bench->part[SECTION_PART_noise];
    double best = 0;
    fputs("| one octave in space | ns a pixel | Mpixel/s |\n| --- | --- | --- |\n", out);
    for (int i = 0; i < count; i++) {
        double speed = 1000 / list[i].nanoseconds;
        fprintf(out, "| %s | %.2f | %.0f |\n", list[i].name, list[i].nanoseconds, speed);
        error_figure(bench, (ErrorSubject){"noise", "one octave", list[i].name}, "ns_per_pixel",
                     list[i].nanoseconds);
        best = strcmp(list[i].name, "noise=lattice") ? best : speed;
    }
    error_target(bench, "lattice noise in space", best >= 200, "200 Mpixel/s|%.0f Mpixel/s", best);
}

/* RMS and greatest difference from the supersampled picture. */
static Distance difference(ErrorBench *bench, const MeterDraw *draw, const float *wanted)
{
    double squares = 0, most = 0;
    int pixels = draw->target->spec.width * draw->target->spec.height;
    float *found = calloc((size_t)pixels * 4, sizeof *found);
    if (!found)
        abort();
    meter_draw_mean(bench->meter, draw, 1, found);
    for (int i = 0; i < pixels; i++) {
        double d = fabs((double)found[4 * i] - wanted[4 * i]);
        squares += d * d / pixels;
        most = fmax(most, d);
    }
    free(found);
    return (Distance){most, sqrt(squares)};
}

/* The drawing, and its target. */
typedef struct {
    const Field *field;
    const Framebuffer *target;
} Canvas;

static void report_fading(ErrorBench *bench, const View *view, Canvas canvas, Timed *list,
                          int count)
{
    FILE *out = bench->part[SECTION_PART_noise];
    float *wanted = calloc((size_t)view->side * (size_t)view->side * 4, sizeof *wanted);
    double speedup = 0, rms = 0;
    char what[TARGET_TEXT];
    if (!wanted)
        abort();
    fprintf(
        out,
        "\n| eight octaves, %g cells of the first a pixel | ns a pixel | RMS error | max error |\n",
        view->cells);
    fputs("| --- | --- | --- | --- |\n", out);
    snprintf(what, sizeof what, "%g cells a pixel", view->cells);
    const MeterDraw plain = {&list[0].material, canvas.field, canvas.target};
    meter_draw_mean(bench->meter, &plain, view->samples, wanted);
    for (int i = 0; i < count; i++) {
        Distance d =
            difference(bench, &(MeterDraw){&list[i].material, canvas.field, canvas.target}, wanted);
        fprintf(out, "| %s | %.2f | %.5f | %.4f |\n", list[i].name, list[i].nanoseconds, d.rms,
                d.maximum);
        const ErrorSubject of = {"fading", what, list[i].name};
        error_figure(bench, of, "ns_per_pixel", list[i].nanoseconds);
        error_figure(bench, of, "rmse", d.rms);
        if (!strcmp(list[i].name, "aa=box")) {
            speedup = list[0].nanoseconds / list[i].nanoseconds;
            rms = d.rms;
        }
    }
    snprintf(what, sizeof what, "fading of octaves, aa=box, %g cells a pixel", view->cells);
    if (speedup > 0 && view->samples > 16)
        error_target(bench, what, speedup >= 2 && rms <= 1. / 255,
                     "2 times faster, within 1/255 = 0.0039|%.2f times, RMS error %.4f", speedup,
                     rms);
    free(wanted);
}

static bool make_target(ErrorBench *bench, int side, GLenum format, Framebuffer *made)
{
    const FramebufferSpec spec = {
        .width = side, .height = side, .color_count = 1, .color_format = format};
    return framebuffer_make(bench->meter->gl, &spec, made);
}

static void measure_document(ErrorBench *bench, const char *text, Axis axis, double extent,
                             const View *view)
{
    Field field = {0}, wide = {0}; /* the measured field; a larger one for timing */
    Framebuffer full, half;
    Timed *list = calloc(MOST, sizeof *list);
    GlContext *gl = bench->meter->gl;
    if (!list)
        abort();
    MatcDocument *document = error_document("noise", text);
    int count = make_choices(bench, document, axis, list);
    double part = view ? (double)view->side / SIDE : 1;
    bool done = count > 0 && make_square(bench->meter, extent * part, &field) &&
                make_square(bench->meter, extent * bench->factor, &wide);
    bool made = done && make_target(bench, SIDE * bench->factor, GL_RGBA16F, &half) &&
                make_target(bench, view ? view->side : SIDE, GL_RGBA32F, &full);
    if (made && time_choices(bench, &wide, &half, list, count)) {
        if (view)
            report_fading(bench, view, (Canvas){&field, &full}, list, count);
        else
            report_noise(bench, list, count);
    }
    if (made) {
        framebuffer_delete(gl, &full);
        framebuffer_delete(gl, &half);
    }
    for (int i = 0; i < count; i++)
        material_delete(&list[i].material);
    field_delete(gl, &field);
    field_delete(gl, &wide);
    matc_document_free(document);
    free(list);
}

void error_noise(ErrorBench *bench)
{
    bench_show("speed of noise");
    measure_document(bench, noise_document, AXIS_noise, 1, NULL);
    bench_show("fading of octaves");
    for (size_t i = 0; i < sizeof distances / sizeof *distances; i++)
        measure_document(bench, octaves_document, AXIS_aa, distances[i].cells * SIDE / 2,
                         &distances[i]);
}
