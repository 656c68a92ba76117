/* Materials from small to hostile, each with every combination of options. */
#include "error.h"
#include "matbench.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MARBLE                                                                                     \
    "diffuse:\n"                                                                                   \
    "  map: Blend\n"                                                                               \
    "  blend: [{ value: -1, input: [0.9, 0.88, 0.8] }, { value: 0.6, input: [0.4, 0.48, 0.45] }, " \
    "{ value: 1, input: [0.03, 0.06, 0.05] }]\n"                                                   \
    "  input:\n"                                                                                   \
    "    map: Gradient\n"                                                                          \
    "    waveForm: Sin01\n"                                                                        \
    "    direction: [1.5, 0.5, 1.5]\n"                                                             \
    "    input: { map: Turbulence, amount: [0.5, 0.5, 0.5], octaves: 5, noiseRatio: 0.5 }\n"
#define IMAGE                                                                                      \
    "{ map: ImageMap, image: examples/tiles.png, input: { map: UVTransform, scaleU: 6, scaleV: 3 " \
    "} "                                                                                           \
    "}"

static const struct {
    const char *name, *text;
    double range; /* range of the points */
    double scale; /* u and v per unit of the plane */
} subjects[] = {
    {"constant", "material: Phong\ndiffuse: [0.1, 0.4, 0.3]\nspecular: 0.4\nshininess: 0.6\n", 4,
     1},
    {"checker near",
     "material: Phong\ndiffuse: { map: Checker, color1: [0.8, 0.7, 0.5], color2: [0.1, 0.2, 0.3] "
     "}\n",
     4, 0.1},
    {"checker to the horizon",
     "material: Phong\ndiffuse: { map: Checker, color1: [0.8, 0.7, 0.5], color2: [0.1, 0.2, 0.3] "
     "}\n",
     4, 2},
    {"checker, far offset",
     "material: Phong\ndiffuse:\n  map: Checker\n  color1: 1\n  color2: 0\n"
     "  input: { map: UVTransform, scaleU: 1000.3, scaleV: 700.7, offsetU: 5000.7, offsetV: 300.1 "
     "}\n",
     4, 0.01},
    {"image", "material: Phong\ndiffuse: " IMAGE "\nspecular: 0.35\n", 4, 0.25},
    {"bumped image",
     "material: Phong\ninput: { map: BumpMap, strength: 12, displacement: &t " IMAGE
     " }\ndiffuse: *t\nspecular: 0.4\n",
     4, 0.25},
    {"wood with a sine",
     "material: Phong\ndiffuse:\n  map: Blend\n"
     "  blend: [{ value: -0.6, input: [0.45, 0.25, 0.1] }, { value: 0.8, input: [0.75, 0.5, 0.25] "
     "}]\n"
     "  input: { map: Wood, waveForm: Sin, frequency: 8, input: { map: XYZTransform, transform: { "
     "rotation: [1.2, 0, "
     "0], "
     "translation: [0.3, 0.1, 0] } } }\nspecular: 0.2\nshininess: 0.7\n",
     4, 1},
    {"marble", "material: Phong\n" MARBLE "specular: 0.35\nshininess: 0.9\n", 4, 1},
    {"granite",
     "material: Phong\ndiffuse:\n  map: Blend\n"
     "  blend: [{ value: -0.75, input: 0.02 }, { value: 0, input: [0.6, 0.4, 0.3] }, { value: 0.5, "
     "input: 0.8 }]\n"
     "  input: { map: Granite, input: { map: XYZTransform, transform: { scale: 1.5 } } }\n",
     4, 1},
    {"bump of noise",
     "material: Phong\ninput: { map: BumpMap, strength: 0.1, displacement: { map: "
     "VolumeTurbulence, octaves: 4, "
     "noiseRatio: "
     "0.5, size: 4 } }\ndiffuse: 0.5\n",
     4, 1},
    {"mandel", "material: Phong\ndiffuse: { map: Mandel }\n", 4, 1},
    {"power of a wave",
     "material: Phong\ndiffuse:\n  map: Gradient\n  direction: [0.3, 0, 0]\n"
     "  waveForm: { wave: Chain, first: Cos, second: { wave: Chain, first: Sqr, second: { wave: "
     "Chain, first: Sqr, "
     "second: Sqr "
     "} } }\n",
     4, 1},
    {"marble at 1e3", "material: Phong\n" MARBLE, 1e3, 1},
    {"marble at 1e6", "material: Phong\n" MARBLE, 1e6, 1},
    {"granite, far offset",
     "material: Phong\ndiffuse: { map: Granite, frequency: 0.3, phase: 0.5, input: { map: "
     "XYZTransform, transform: { "
     "scale: "
     "31.7, translation: [100000.3, 0.7, -54321.1] } } }\n",
     4, 1},
};
enum { SUBJECTS = sizeof subjects / sizeof *subjects };

static void figures(ErrorBench *bench, const char *subject, const MeasuredList *list)
{
    char name[VARIANT_NAME];
    for (int i = 0; i < list->count; i++) {
        const Measured *m = &list->at[i];
        variant_name(&m->variant, &list->at[0].variant, name);
        const ErrorSubject of = {"material", subject, name};
        error_figure(bench, of, "ns_per_pixel", m->nanoseconds);
        error_figure(bench, of, "error_max", m->error);
        error_figure(bench, of, "error_rms", m->rms);
        error_figure(bench, of, "error_max_8bit", m->error * 255);
        error_figure(bench, of, "aliasing_rms", m->aliasing);
        error_figure(bench, of, "front", m->front);
        error_figure(bench, of, "aliasing_front", m->alias_front);
    }
}

static int by_time(const void *a, const void *b)
{
    double x = ((const Measured *)a)->nanoseconds, y = ((const Measured *)b)->nanoseconds;
    return (x > y) - (x < y);
}

/* Worst error of all slots before packing, for comparison with the layout's error. */
static double computed(const Measured *m)
{
    double most = 0;
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        most = fmax(most, m->computed[slot].maximum);
    return most;
}

/* Prints the default and all variants on a Pareto front, sorted by time. */
static void report(ErrorBench *bench, int subject, const MeasuredList *list)
{
    char name[VARIANT_NAME];
    FILE *out = bench->part[SECTION_PART_materials];
    Variant base = list->at[0].variant;
    Measured *sorted = calloc((size_t)list->count, sizeof *sorted);
    if (!sorted)
        abort();
    memcpy(sorted, list->at, (size_t)list->count * sizeof *sorted);
    qsort(sorted, (size_t)list->count, sizeof *sorted, by_time);
    fprintf(out, "\n**%s**, coordinates to %g: %d programs measured%s\n\n", subjects[subject].name,
            subjects[subject].range, list->count,
            list->left_out ? ", others left out for want of time" : "");
    fputs("| choices | ns a pixel | error, 8-bit steps | RMS, 8-bit steps | before packing, 8-bit "
          "steps | aliasing, "
          "RMS | "
          "front |\n| --- | --- | --- | --- | --- | --- | --- |\n",
          out);
    for (int i = 0; i < list->count; i++) {
        const Measured *m = &sorted[i];
        if (!m->front && !m->alias_front && variant_distance(&m->variant, &base))
            continue;
        variant_name(&m->variant, &base, name);
        fprintf(out, "| %s | %.2f | %.3g | %.3g | %.3g ",
                strcmp(name, "as given") ? name : "default", m->nanoseconds, 255 * m->error,
                255 * m->rms, 255 * computed(m));
        if (isnan(m->aliasing))
            fputs("| - ", out);
        else
            fprintf(out, "| %.4f ", m->aliasing);
        fprintf(out, "| %s%s |\n", m->front ? "error " : "", m->alias_front ? "aliasing" : "");
    }
    free(sorted);
}

/* The plot's points outlive the list; labels are from malloc and are never freed. */
static void add_panel(ErrorBench *bench, const char *subject, const MeasuredList *list,
                      bool aliasing)
{
    char title[128];
    bool varies = !aliasing;
    for (int i = 0; i < list->count; i++)
        varies |= list->at[i].aliasing > 0;
    if (!varies)
        return;
    snprintf(title, sizeof title, "%s: %s", subject, aliasing ? "aliasing" : "error");
    PlotPoint *points = calloc((size_t)list->count + 1, sizeof *points);
    if (!points || bench->panel_count == PANELS_LIMIT)
        abort();
    for (int i = 0; i < list->count; i++) {
        const Measured *m = &list->at[i];
        char name[VARIANT_NAME];
        variant_name(&m->variant, &list->at[0].variant, name);
        points[i] = (PlotPoint){
            m->nanoseconds, aliasing ? m->aliasing : m->error, aliasing ? m->alias_front : m->front,
            i == 0,         strdup(i ? name : "default"),      0};
    }
    bench->panels[bench->panel_count++] = (PlotPanel){
        strdup(title), "ns a pixel", aliasing ? "RMS of the worst slot" : "greatest of all slots",
        points, list->count};
}

void error_materials(ErrorBench *bench)
{
    MatcOptions options;
    matc_options_init(&options);
    for (int i = 0; i < SUBJECTS; i++) {
        MeasuredList list;
        bench_show(subjects[i].name);
        MatcDocument *document = error_document(subjects[i].name, subjects[i].text);
        const AutotuneRequest request = {.document = document,
                                         .options = &options,
                                         .open = variant_open(&options),
                                         .range = subjects[i].range,
                                         .scale = subjects[i].scale,
                                         .seconds = bench->seconds,
                                         .aliasing = true};
        if (autotune_variants(bench->meter, &request, &list)) {
            figures(bench, subjects[i].name, &list);
            report(bench, i, &list);
            add_panel(bench, subjects[i].name, &list, false);
            add_panel(bench, subjects[i].name, &list, true);
            autotune_free(&list);
        }
        matc_document_free(document);
    }
}
