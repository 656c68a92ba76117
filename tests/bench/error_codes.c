/* Round trip of every layout: each value that a slot reads back is packed and read back a second
 * time, and must be equal, so that no code is lost between a shader, a render target and the
 * next shader. */
#include "error.h"
#include "matbench.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SWEEP = 65536, QUICK_SWEEP = 8192 };

/* Every slot of a color has the value x. */
static const char document_text[] =
    "material: Phong\n"
    "diffuse: &x { map: Gradient, direction: [1, 0, 0] }\n"
    "specular: *x\ntransparency: *x\ndiffuseTransparency: *x\nambient: *x\nemissive: *x\n";
static const Slot slots[] = {SLOT_diffuse,      SLOT_specular,
                             SLOT_transparency, SLOT_diffuseTransparency,
                             SLOT_ambient,      SLOT_emissive};
enum { SLOTS = sizeof slots / sizeof *slots };

typedef struct {
    ErrorBench *bench;
    Layout layout;
    Material material;
    FieldVertex points[POINTS];
    SlotValues first[POINTS], second[POINTS];
    double *codes; /* values read back for one component, in the order of the sweep */
    long read, changed;
} Sweep;

static bool draw(Sweep *s, SlotValues *values)
{
    Field field;
    bool done = field_make(s->bench->meter->gl, s->points, POINTS, GL_POINTS, &field) &&
                meter_draw_packed(s->bench->meter, &s->material, s->layout, &field, values);
    field_delete(s->bench->meter->gl, &field);
    return done;
}

/* Feeds the component with the values that were read back. */
static bool check_component(Sweep *s, Slot slot, int component)
{
    for (int i = 0; i < POINTS; i++)
        s->points[i].input[INPUT_X][0] = (float)s->first[i].component[slot][component];
    if (!draw(s, s->second))
        return false;
    for (int i = 0; i < POINTS; i++, s->read++)
        s->changed +=
            s->second[i].component[slot][component] != s->first[i].component[slot][component];
    return true;
}

static bool check_batch(Sweep *s, int from, int steps)
{
    for (int i = 0; i < POINTS; i++)
        s->points[i].input[INPUT_X][0] = (float)(from + i) / (float)(steps - 1);
    if (!draw(s, s->first))
        return false;
    for (int i = 0; i < POINTS; i++)
        s->codes[from + i] = s->first[i].component[SLOT_specular][0];
    for (int k = 0; k < SLOTS; k++)
        for (int component = 0;
             component < 3 && s->bench->meter->readers[s->layout].holds[slots[k]]; component++)
            if (!check_component(s, slots[k], component))
                return false;
    return true;
}

static int distinct(const double *codes, int count)
{
    int found = count > 0;
    for (int i = 1; i < count; i++)
        found += codes[i] != codes[i - 1]; /* an ascending sweep reads back ascending */
    return found;
}

static bool sweep_layout(Sweep *s, const MatcDocument *document)
{
    Variant variant;
    MatcOptions options;
    matc_options_init(&options);
    variant_of(&options, &variant);
    variant.layout = (int)s->layout;
    options = variant_options(&variant, &options);
    MatcProgram *program = variant_compile(document, 0, MATC_FRAGMENT | MATC_UNPACK, &options);
    if (!program)
        return false;
    int steps = s->bench->quick ? QUICK_SWEEP : SWEEP;
    bool done =
        meter_make_material(s->bench->meter, program, &s->material) &&
        meter_open_layout(s->bench->meter, s->layout, matc_output(program, MATC_UNPACK, NULL));
    sample_points(s->points, 1);
    for (int from = 0; from < steps && done; from += POINTS)
        done = check_batch(s, from, steps);
    if (done) {
        fprintf(s->bench->part[SECTION_PART_codes], "| %s | %d | %ld | %ld |\n",
                layout_table[s->layout].name, distinct(s->codes, steps), s->read, s->changed);
        const ErrorSubject of = {"codes", layout_table[s->layout].name, ""};
        error_figure(s->bench, of, "read", (double)s->read);
        error_figure(s->bench, of, "changed", (double)s->changed);
    }
    material_delete(&s->material);
    matc_program_free(program);
    return done;
}

void error_codes(ErrorBench *bench)
{
    long read = 0, changed = 0;
    Sweep *s = calloc(1, sizeof *s);
    double *codes = calloc(SWEEP, sizeof *codes);
    if (!s || !codes)
        abort();
    MatcDocument *document = error_document("codes", document_text);
    fputs("| layout | codes of a lane of specular | codes read twice, all lanes | changed |\n| --- "
          "| --- | --- | --- |\n",
          bench->part[SECTION_PART_codes]);
    for (int layout = 0; layout < LAYOUT_COUNT; layout++) {
        bench_show(layout_table[layout].name);
        *s = (Sweep){.bench = bench, .layout = (Layout)layout, .codes = codes};
        if (!sweep_layout(s, document))
            continue;
        read += s->read;
        changed += s->changed;
    }
    error_target(bench, "packed codes of colours", read > 0 && changed == 0,
                 "every one exact|%ld of %ld changed when packed again", changed, read);
    matc_document_free(document);
    free(codes);
    free(s);
}
