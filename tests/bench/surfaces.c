/* matbench surfaces: the four most common kinds of Principled in `compact`. Prints the error of
 * each slot after it was packed, drawn and read back, against the oracle in double, next to the
 * error that its bits allow; then the instruction count and compile time of packing. Also a
 * test: no slot may exceed the allowed error by more than the rounding of the formulas. */
#include "matbench.h"
#include "compiler/describe/describe.h"
#include "compiler/evaluate.h"
#include "compiler/library/normal.h"
#include "runtime/autotune/meter.h"
#include "runtime/autotune/variant.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LONGEST_TEXT = 1024, BATCHES = 16, RUNS = 301, KEPT_BYTES = 16 };
/* Rounding error of a formula in floats, and of the normal in degrees. */
static const double FLOAT_SLACK = 1e-6, FLOAT_DEGREES = 1e-4;

static const struct {
    const char *name, *parameters;
} surfaces[] = {
#define SURFACE(name, parameters) {#name, parameters},
#include "surfaces.def"
};
enum { SURFACES = sizeof surfaces / sizeof *surfaces };

typedef struct {
    Meter *meter;
    FieldVertex points[POINTS];
    Surface at[POINTS];
    SlotValues want[POINTS], got[POINTS];
    double worst[SLOT_COUNT]; /* in the unit of the field's error; below 0: no point was measured */
} Sweep;

static size_t put_document(int which, char text[LONGEST_TEXT])
{
    return (size_t)snprintf(text, LONGEST_TEXT, "{ material: Principled, %s }\n",
                            surfaces[which].parameters);
}

/* u and v cover [0, 1], with other pairs in each batch. */
static void set_points(Sweep *s, int batch)
{
    sample_points(s->points, 1);
    for (int i = 0; i < POINTS; i++) {
        float *uv = s->points[i].input[INPUT_U];
        uv[0] = (float)((i + (batch + .5) / BATCHES) / POINTS);
        uv[1] = .5f + .5f * uv[1];
        sample_surface(&s->points[i], &s->at[i]);
    }
}

static double slot_error(const Sweep *s, int point, int slot)
{
    double most = 0;
    if (slot == SLOT_normal) {
        const float *n = s->points[point].input[INPUT_eyeN];
        return normal_angle((double[]){n[0], n[1], n[2]}, s->got[point].component[slot]);
    }
    for (int component = 0; component < type_table[slot_table[slot].type].components; component++)
        most = fmax(most, fabs(s->got[point].component[slot][component] -
                               s->want[point].component[slot][component]));
    return most;
}

static bool is_reported(const SlotValues *values, int slot)
{
    bool reported = slot == SLOT_normal;
    for (int component = 0; component < type_table[slot_table[slot].type].components; component++)
        reported |= values->component[slot][component] != slot_table[slot].absent;
    return reported;
}

/* Draws a batch of points, and records the errors of slots. */
static bool compare(Sweep *s, Material *material)
{
    Field field;
    const bool done = field_make(s->meter->gl, s->points, POINTS, GL_POINTS, &field) &&
                      meter_draw_packed(s->meter, material, LAYOUT_compact, &field, s->got);
    field_delete(s->meter->gl, &field);
    for (int i = 0; i < POINTS && done; i++)
        for (int slot = 0; slot < SLOT_COUNT; slot++)
            if (is_reported(&s->want[i], slot))
                s->worst[slot] = fmax(s->worst[slot], slot_error(s, i, slot));
    return done;
}

static bool sweep(Sweep *s, const MatcDocument *document, MatcProgram *program,
                  const MatcOptions *options)
{
    Material material;
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        s->worst[slot] = -1;
    bool fine =
        meter_make_material(s->meter, program, &material) &&
        meter_open_layout(s->meter, LAYOUT_compact, matc_output(program, MATC_UNPACK, NULL));
    for (int batch = 0; batch < BATCHES && fine; batch++) {
        set_points(s, batch);
        fine = evaluate_material(document, 0, options, (SurfacePoints){s->at, POINTS}, s->want) &&
               compare(s, &material);
    }
    material_delete(&material);
    return fine;
}

/* Returns false if the error exceeds the bound. */
static bool put_slot(const Sweep *s, int which, const FieldRow *field, Slot slot)
{
    Arena arena = {0};
    Text stored = text_new(&arena), promised = text_new(&arena);
    const bool degrees = encoding_table[field->encoding].unit == UNIT_degrees;
    layout_put_encoding(&stored, field);
    describe_error(&promised, field);
    printf("%-8s %-16s %-15s %5d   %-14s %8.2g\n", surfaces[which].name, slot_table[slot].name,
           stored.at, field_size(field), promised.at, s->worst[slot]);
    arena_free(&arena);
    return s->worst[slot] <= field_error(field) + (degrees ? FLOAT_DEGREES : FLOAT_SLACK);
}

/* Every slot that the material sets must be stored, within the error of its bits. */
static bool put_slots(const Sweep *s, int which, const CaseRow *row)
{
    bool fine = true;
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        fine &= s->worst[slot] < 0 || slot == SLOT_alpha || layout_case_has_slot(row, (Slot)slot) ||
                layout_case_fixed(row, (Slot)slot);
    for (int i = 0; i < row->field_count; i++) {
        const FieldRow *field = &row->fields[i];
        if (s->worst[field->source[0].slot] >= 0)
            fine &= put_slot(s, which, field, field->source[0].slot);
    }
    return fine;
}

static bool measure(Sweep *s, int which)
{
    char text[LONGEST_TEXT];
    MatcOptions options;
    matc_options_init(&options);
    options.layout = "compact";
    MatcDocument *document = matc_read("surfaces.yaml", text, put_document(which, text), &options);
    MatcProgram *program = variant_compile(document, 0, MATC_FRAGMENT | MATC_UNPACK, &options);
    bool fine = program && sweep(s, document, program, &options);
    if (!fine)
        fprintf(stderr, "matbench: %s: %s%s\n", surfaces[which].name,
                matc_diagnostics(document, MATC_TEXT), s->meter->error);
    else if (!put_slots(s, which, &layout_table[LAYOUT_compact].cases[matc_case(program)])) {
        fprintf(stderr, "matbench: %s: a slot is off by more than is promised, or not stored\n",
                surfaces[which].name);
        fine = false;
    }
    matc_program_free(program);
    matc_document_free(document);
    return fine;
}

/* Cost of a program for a whole layout; the pass `value`, one slot in floats, would tell little. */
static void put_cost(int which, bool timed)
{
    static const char *const layouts[] = {"compact", "integer"};
    char text[LONGEST_TEXT];
    const size_t size = put_document(which, text);
    printf("%-8s", surfaces[which].name);
    for (int i = 0; i < 2; i++) {
        MatcOptions options;
        matc_options_init(&options);
        options.layout = layouts[i];
        const int count = bench_count(surfaces[which].name, text, size, layouts[i]);
        printf(" %13s", NUMBER(0, count < 0 ? NAN : count));
        options.validate = options.check = false;
        printf(" %13s",
               NUMBER(1, 1e6 * bench_compile_least(text, size, &options, timed ? RUNS : 0)));
    }
    putchar('\n');
}

int bench_surfaces(const BenchOptions *options)
{
    const bool timed = options->timed;
    char error[LONGEST_TEXT];
    Sweep *s = calloc(1, sizeof *s);
    if (!s)
        abort();
    s->meter = meter_open(GL_KIND_osmesa, error, sizeof error);
    bool fine = s->meter && layout_bytes(&layout_table[LAYOUT_compact]) == KEPT_BYTES;
    printf("%d bytes a pixel, %d points\n", layout_bytes(&layout_table[LAYOUT_compact]),
           BATCHES * POINTS);
    printf("surface  slot             stored as        bits   error at most  greatest\n");
    for (int i = 0; i < SURFACES && s->meter; i++)
        fine &= measure(s, i);
    if (!s->meter)
        fprintf(stderr, "matbench: %s\n", error);
    printf("\nsurface  compact: instructions  microseconds  integer: instructions  microseconds\n");
    for (int i = 0; i < SURFACES; i++)
        put_cost(i, timed);
    meter_close(s->meter);
    free(s);
    return !fine;
}
