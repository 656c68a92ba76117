/* Every built-in layout: the error of each slot after a round trip, over a sweep of its values,
 * and the cost of packing and unpacking. */
#include "error.h"
#include "compiler/describe/describe.h"
#include "compiler/evaluate.h"
#include "matbench.h"
#include "compiler/library/normal.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BATCHES = 32, QUICK_BATCHES = 4, LONGEST_DOCUMENT = 2048 };

/* The components of a color are x, 1 - x and a part of [0, 1]; light is up to 64. */
#define COLOR                                                                                      \
    "{ map: Blend, blend: [{ value: 0, input: [0, 1, 0.2] }, { value: 1, input: [1, 0, 0.7] }], "  \
    "input: *t }\n"
#define LIGHT                                                                                      \
    "{ map: Blend, blend: [{ value: 0, input: [0, 64, 8] }, { value: 1, input: [64, 0, 28] }], "   \
    "input: *t }\n"
#define PLAIN                                                                                      \
    "material: Phong\nshininess: &t { map: Gradient, direction: [1, 0, 0] }\ndiffuse: " COLOR      \
    "specular: " COLOR
#define CLEAR "transparency: " COLOR "transparencyShininess: *t\n"
static const struct {
    const char *name, *text;
} documents[] = {
    {"opaque", PLAIN "ambient: " COLOR "emissive: " LIGHT},
    {"transparent", PLAIN CLEAR "diffuseTransparency: " COLOR},
    {"transparent and bright", PLAIN CLEAR "ambient: " COLOR "emissive: " LIGHT},
    {"everything", PLAIN CLEAR "diffuseTransparency: " COLOR "ambient: " COLOR "emissive: " LIGHT},
};
enum { DOCUMENTS = sizeof documents / sizeof *documents, EVERYTHING = DOCUMENTS - 1 };

typedef struct {
    double greatest[SLOT_COUNT], squares[SLOT_COUNT];
    long count[SLOT_COUNT];
} Errors;

typedef struct {
    ErrorBench *bench;
    Layout layout;
    FieldVertex points[POINTS];
    Surface surfaces[POINTS];
    SlotValues want[POINTS], got[POINTS];
} Sweep;

static void note(Errors *errors, int slot, double error)
{
    errors->greatest[slot] = fmax(errors->greatest[slot], error);
    errors->squares[slot] += error * error;
    errors->count[slot]++;
}

static double greatest_component(const SlotValues *values, int slot)
{
    double greatest = 1;
    for (int component = 0; component < type_table[slot_table[slot].type].components; component++)
        greatest = fmax(greatest, fabs(values->component[slot][component]));
    return greatest;
}

/* Errors in units of max(1, the greatest component); the normal's in degrees. */
static void compare(const Sweep *s, Errors *errors)
{
    for (int i = 0; i < POINTS; i++)
        for (int slot = 0; slot < SLOT_COUNT; slot++) {
            const SlotRow *row = &slot_table[slot];
            const float *n = s->points[i].input[INPUT_eyeN];
            if (!s->bench->meter->readers[s->layout].holds[slot])
                continue;
            if (slot == SLOT_normal)
                note(errors, slot,
                     normal_angle((double[]){n[0], n[1], n[2]}, s->got[i].component[slot]));
            for (int component = 0;
                 slot != SLOT_normal && component < type_table[row->type].components; component++) {
                double want =
                    fmin(fmax(s->want[i].component[slot][component], row->low), row->high);
                note(errors, slot,
                     fabs(s->got[i].component[slot][component] - want) /
                         greatest_component(&s->want[i], slot));
            }
        }
}

static bool draw(Sweep *s, Material *material)
{
    Field field;
    bool done = field_make(s->bench->meter->gl, s->points, POINTS, GL_POINTS, &field) &&
                meter_draw_packed(s->bench->meter, material, s->layout, &field, s->got);
    field_delete(s->bench->meter->gl, &field);
    return done;
}

/* The sweep of a document. */
static bool measure(Sweep *s, int which, Errors *errors)
{
    MatcOptions options;
    Material material;
    const int batches = s->bench->quick ? QUICK_BATCHES : BATCHES;
    matc_options_init(&options);
    options.layout = layout_table[s->layout].name;
    MatcDocument *document = error_document("layouts", documents[which].text);
    MatcProgram *program = variant_compile(document, 0, MATC_FRAGMENT | MATC_UNPACK, &options);
    bool fine = program != NULL;
    if (fine) {
        fine =
            meter_make_material(s->bench->meter, program, &material) &&
            meter_open_layout(s->bench->meter, s->layout, matc_output(program, MATC_UNPACK, NULL));
        for (int batch = 0; batch < batches && fine; batch++) {
            for (int i = 0; i < POINTS; i++) {
                double x = (i * batches + batch + 0.5) / ((double)batches * POINTS);
                s->points[i].input[INPUT_X][0] = (float)x;
                sample_surface(&s->points[i], &s->surfaces[i]);
            }
            evaluate_material(document, 0, &options, (SurfacePoints){s->surfaces, POINTS}, s->want);
            fine = draw(s, &material);
            compare(s, errors);
        }
        material_delete(&material);
        matc_program_free(program);
    }
    matc_document_free(document);
    return fine;
}

/* The case of the document's material: the first that stores all of its slots. */
static const CaseRow *case_of(const LayoutRow *row, int which)
{
    int number = 0;
    for (; number + 1 < row->case_count; number++) {
        bool all = true;
        for (int slot = 0; slot < SLOT_COUNT; slot++)
            if (strstr(documents[which].text, slot_table[slot].name) &&
                layout_has_slot(row, (Slot)slot))
                all &= layout_case_has_slot(&row->cases[number], (Slot)slot);
        if (all)
            break;
    }
    return &row->cases[number];
}

static const char *encoding_of(Arena *arena, const CaseRow *row, Slot slot)
{
    Text text = text_new(arena);
    for (int i = 0; i < row->field_count; i++)
        for (int k = 0; k < row->fields[i].count; k++)
            if (row->fields[i].source[k].slot == slot && !text.size)
                layout_put_encoding(&text, &row->fields[i]);
    return text.size ? text.at : NULL;
}

static void put_table(Sweep *s, const Errors errors[DOCUMENTS], int first)
{
    const LayoutRow *row = &layout_table[s->layout];
    FILE *out = s->bench->part[SECTION_PART_layouts];
    Arena arena = {0};
    fputs("| slot |", out);
    for (int which = first; which < DOCUMENTS; which++)
        fprintf(out, " %s: stored as | maximum | RMS |", documents[which].name);
    fputs("\n| --- |", out);
    for (int which = first; which < DOCUMENTS; which++)
        fputs(" --- | --- | --- |", out);
    fputc('\n', out);
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        if (!layout_has_slot(row, (Slot)slot))
            continue;
        fprintf(out, "| %s%s |", slot_table[slot].name, slot == SLOT_normal ? ", degrees" : "");
        for (int which = first; which < DOCUMENTS; which++) {
            const Errors *e = &errors[which];
            const char *encoding = encoding_of(&arena, case_of(row, which), (Slot)slot);
            double rms = sqrt(e->squares[slot] / (double)(e->count[slot] ? e->count[slot] : 1));
            if (!encoding) {
                fputs(" | | |", out);
                continue;
            }
            fprintf(out, " %s | %.3g | %.3g |", encoding, e->greatest[slot], rms);
            error_figure(s->bench, (ErrorSubject){"layouts", row->name, documents[which].name},
                         slot_table[slot].name, e->greatest[slot]);
        }
        fputc('\n', out);
    }
    arena_free(&arena);
}

static void put_layout(Sweep *s)
{
    const LayoutRow *row = &layout_table[s->layout];
    const int first = row->case_count > 1 ? 0 : EVERYTHING;
    Errors errors[DOCUMENTS] = {{{0}, {0}, {0}}};
    double write, read;
    for (int which = first; which < DOCUMENTS; which++)
        if (!measure(s, which, &errors[which]))
            return;
    if (!bench_layout_cost(s->bench->meter->gl, (int)s->layout, &write, &read))
        return;
    fprintf(
        s->bench->part[SECTION_PART_layouts],
        "\n### %s\n\n%d bytes a pixel; writing it takes %.1f ns a pixel, reading it back %.1f.\n\n",
        row->name, layout_bytes(row), write, read);
    const ErrorSubject of = {"layouts", row->name, ""};
    error_figure(s->bench, of, "write", write);
    error_figure(s->bench, of, "read", read);
    put_table(s, errors, first);
}

void error_layouts(ErrorBench *bench)
{
    Sweep *s = calloc(1, sizeof *s);
    if (!s)
        abort();
    for (int layout = 0; layout < LAYOUT_COUNT; layout++) {
        bench_show(layout_table[layout].name);
        s->bench = bench;
        s->layout = (Layout)layout;
        sample_points(s->points, 1);
        put_layout(s);
    }
    free(s);
}
