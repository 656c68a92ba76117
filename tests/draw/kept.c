/* Compares slot values before and after storage in a G-buffer. */
#include "kept.h"
#include "compiler/layout/layout.h"
#include "compiler/pipeline.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

typedef struct {
    Kept *kept;
    const LayoutRow *layout;
    const CaseRow *fields; /* fields of the case that was drawn */
    int count;             /* number of points */
    float *want, *got;     /* four floats per point */
} Comparison;

static bool fail(Comparison *c, SlotComponent at, double want, double got, double bound)
{
    snprintf(c->kept->error, sizeof c->kept->error,
             "layout %s, %s, lane %d: %.9g comes back as %.9g, the bound is %.3g", c->layout->name,
             slot_table[at.slot].name, at.component, want, got, bound);
    return false;
}

static double within(double value, double low, double high) { return fmin(fmax(value, low), high); }

static const FieldRow *field_of(const Comparison *c, Slot slot, int component)
{
    for (int i = 0; i < c->fields->field_count; i++) {
        const FieldRow *field = &c->fields->fields[i];
        for (int k = 0; k < field->count; k++)
            if (field->source[k].slot == slot &&
                (field->gray || field->source[k].component == component))
                return field;
    }
    return NULL;
}

/* The field's error bound, relative to the value, or to the greatest component if components
 * share an exponent; `least`: error of values without a code nearby. */
static double bound_of(const FieldRow *field, Slot slot, int component, const float *want)
{
    const double high = field_high(field),
                 least = field->encoding == ENCODING_logarithm ? 1. / 32 : ldexp(1, -20);
    double of = fabs(want[component]);
    for (int i = 0; field->encoding == ENCODING_sharedExponent &&
                    i < type_table[slot_table[slot].type].components;
         i++)
        of = fmax(of, fabs(want[i]));
    if (encoding_table[field->encoding].unit == UNIT_relative)
        return (field_error(field) + 5e-6) * fmin(of, high) + least;
    return field_error(field) + 5e-6;
}

static bool compare_component(Comparison *c, Slot slot, int component, const float *want,
                              double got)
{
    const SlotRow *row = &slot_table[slot];
    const FixedRow *fixed = layout_fixed(c->layout, slot);
    const FieldRow *field = field_of(c, slot, component);
    const double value = within(want[component], row->low, row->high);
    /* a constant, or a slot that this case leaves out */
    double bound = 1e-5 * fmax(1, fabs(value));
    if (field && encoding_table[field->encoding].unit == UNIT_degrees)
        return true;
    if (field && !fixed)
        bound = bound_of(field, slot, component, want);
    c->kept->values++;
    c->kept->worst = fmax(c->kept->worst, field ? fabs(got - value) / bound : 0);
    return fabs(got - value) <= bound ||
           fail(c, (SlotComponent){slot, component}, value, got, bound);
}

/* Compares a slot; one that the layout leaves out must have the absent value. */
static bool compare_slot(Comparison *c, Slot slot)
{
    const SlotRow *row = &slot_table[slot];
    const bool has = layout_has_slot(c->layout, slot);
    for (int i = 0; i < c->count; i++)
        for (int component = 0; component < type_table[row->type].components; component++) {
            double want = within(c->want[4 * i + component], row->low, row->high);
            if (has &&
                !compare_component(c, slot, component, &c->want[4 * i], c->got[4 * i + component]))
                return false;
            if (!has && fabs(want - row->absent) > 1e-5)
                return fail(c, (SlotComponent){slot, component}, want, row->absent, 0);
        }
    return true;
}

/* Draws the slot values themselves at all points, with the pass value. */
static bool draw_values(Comparison *c, Drawer *drawer, const KeptMaterial *material, Slot slot)
{
    MatcOptions own = *material->options;
    own.pass = "value";
    own.slot = slot_table[slot].name;
    MatcProgram *program =
        matc_compile(material->document->document, material->material, MATC_FRAGMENT, &own);
    Shading shading = {.fragment = matc_output(program, MATC_FRAGMENT, NULL),
                       .target = TARGET_glsl330,
                       .program = program,
                       .graph = material->document->graph};
    Material drawn = {0};
    bool fine = matc_ok(program) && drawer_material(drawer, &shading, &drawn) &&
                drawer_draw(drawer, &drawn, true, &c->want, 1);
    if (!fine)
        snprintf(c->kept->error, sizeof c->kept->error, "%.500s%.500s",
                 matc_program_diagnostics(program, MATC_TEXT), drawer->error);
    material_delete(&drawn);
    matc_program_free(program);
    return fine;
}

static int drawn_case(const Gbuffer *g, int count)
{
    if (g->layout->case_count == 1)
        return 0;
    GLuint(*words)[4] = calloc((size_t)count, sizeof *words);
    if (!words || !framebuffer_read_words(g->drawer->gl, &g->targets, 0, &words[0][0]))
        abort();
    const int last = layout_targets(g->layout) - 1;
    const GLuint first = words[0][0];
    if (!framebuffer_read_words(g->drawer->gl, &g->targets, last, &words[0][0]))
        abort();
    const int number = layout_case_of(
        g->layout, first, words[0][format_table[g->layout->formats[last]].components - 1]);
    free(words);
    return number;
}

static bool compare_all(Comparison *c, Gbuffer *g, const KeptMaterial *material,
                        const bool matters[SLOT_COUNT])
{
    c->layout = g->layout;
    if (!gbuffer_draw(g, true)) {
        snprintf(c->kept->error, sizeof c->kept->error, "%.1000s", g->error);
        return false;
    }
    const int number = drawn_case(g, g->drawer->count);
    c->fields = &g->layout->cases[number];
    c->kept->drawn[number]++;
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        const bool has = layout_has_slot(g->layout, (Slot)slot);
        if (slot == SLOT_normal || !(matters ? matters[slot] : has))
            continue;
        c->kept->fields += has;
        if ((has && !gbuffer_read(g, (Slot)slot, c->got)) ||
            !draw_values(c, g->drawer, material, (Slot)slot) || !compare_slot(c, (Slot)slot))
            return false;
    }
    return true;
}

bool kept_check(Kept *kept, Drawer *drawer, const KeptMaterial *material,
                const bool matters[SLOT_COUNT])
{
    Gbuffer g;
    Comparison c = {.kept = kept, .count = drawer->count};
    c.want = calloc((size_t)c.count, 4 * sizeof(float));
    c.got = calloc((size_t)c.count, 4 * sizeof(float));
    if (!c.want || !c.got)
        abort();
    bool fine = gbuffer_open(&g, drawer, material->document, material->material, material->options);
    if (!fine)
        snprintf(kept->error, sizeof kept->error, "%.1000s", g.error);
    fine = fine && compare_all(&c, &g, material, matters);
    gbuffer_close(&g);
    kept->materials++;
    free(c.want);
    free(c.got);
    return fine;
}
