#include "runtime/autotune/errors.h"
#include "compiler/base/memory.h"
#include "runtime/gl/message.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Samples per pixel and direction of a supersampled reference picture. */
enum { REFERENCE_SIDE = 16 };

static void *grow(void *list, int count, int *capacity, size_t size)
{
    if (count < *capacity)
        return list;
    *capacity = *capacity ? 2 * *capacity : 16;
    list = realloc(list, (size_t)*capacity * size);
    if (!list)
        memory_exhausted();
    return list;
}

void *errors_allocate(size_t count, size_t size)
{
    void *memory = calloc(count ? count : 1, size);
    if (!memory)
        memory_exhausted();
    return memory;
}

/* Variants share a reference only if their noise and derivatives are equal. */
static int truth_index(const Variant *variant)
{
    return variant->choice[AXIS_noise] * CHOICE_COUNT + variant->choice[AXIS_derivatives];
}

static Truth *truth_of(Errors *e, const Variant *variant)
{
    Truth *truth = &e->truth[truth_index(variant)];
    if (truth->values)
        return truth;
    truth->values = errors_allocate(POINTS, sizeof *truth->values);
    truth->unknown = !autotune_reference(e->request, variant, e->vertices, truth->values);
    return truth;
}

bool errors_has_truth(Errors *e, const Variant *variant)
{
    return !truth_of(e, variant)->unknown ||
           message_fail(e->meter->error, sizeof e->meter->error,
                        "its values at %d points take the reference too many operations: filters "
                        "within filters, over "
                        "maps that cost much",
                        POINTS);
}

bool errors_open(Errors *e, Meter *m, const AutotuneRequest *request)
{
    FieldVertex plane[PLANE_VERTICES];
    double scale = request->scale > 0 ? request->scale : 1;
    FramebufferSpec spec = {.width = MEASURE_SIDE,
                            .height = MEASURE_SIDE,
                            .color_count = 1,
                            .color_format = GL_RGBA32F};
    *e = (Errors){.meter = m, .request = request};
    sample_points(e->vertices, request->range);
    sample_plane(plane,
                 &(PlaneView){.yaw = 0.3, .scale = scale, .aspect = 1, .height = MEASURE_SIDE});
    return (field_make(m->gl, e->vertices, POINTS, GL_POINTS, &e->points) &&
            field_make(m->gl, plane, PLANE_VERTICES, GL_TRIANGLE_STRIP, &e->view) &&
            framebuffer_make(m->gl, &spec, &e->picture)) ||
           message_fail(m->error, sizeof m->error, "%s", m->gl->error);
}

/* Returns n for n x n samples within about a second of drawing. */
static int mean_side(Errors *e, const MeterDraw *draw)
{
    const double seconds = clamp(e->request->seconds / 50, 0.05, 0.8);
    float *scratch = errors_allocate(MEASURE_SIDE * MEASURE_SIDE * 4, sizeof *scratch);
    meter_draw_mean(e->meter, draw, 1, scratch);
    double start = meter_now();
    meter_draw_mean(e->meter, draw, 2, scratch);
    double once = fmax((meter_now() - start) / 4, 1e-5);
    free(scratch);
    return (int)clamp(sqrt(seconds / once), 8, 2 * REFERENCE_SIDE);
}

/* Returns the supersampled picture of a slot, drawn without procedural antialiasing. */
static const float *mean_of(Errors *e, const Variant *variant, int slot)
{
    Truth *truth = truth_of(e, variant);
    if (truth->mean[slot])
        return truth->mean[slot];
    Variant plain;
    variant_of(e->request->options, &plain);
    plain.choice[AXIS_noise] = variant->choice[AXIS_noise];
    plain.choice[AXIS_derivatives] = variant->choice[AXIS_derivatives];
    plain.choice[AXIS_aa] = CHOICE_aa_none;
    /* exact coordinates: the reference must not round */
    plain.choice[AXIS_coordinates] = CHOICE_coordinates_long;
    MatcOptions options = variant_options(&plain, e->request->options);
    options.pass = "value";
    options.slot = slot_table[slot].name;
    MatcProgram *program =
        variant_compile(e->request->document, e->request->material, MATC_FRAGMENT, &options);
    Material material = {0};
    const MeterDraw draw = {&material, &e->view, &e->picture};
    float *mean = errors_allocate(MEASURE_SIDE * MEASURE_SIDE * 4, sizeof *mean);
    if (program && meter_make_material(e->meter, program, &material) &&
        meter_draw_mean(e->meter, &draw, mean_side(e, &draw), mean))
        truth->mean[slot] = mean;
    else
        free(mean);
    material_delete(&material);
    matc_program_free(program);
    return truth->mean[slot];
}

static Distance picture_distance(int slot, const float *found, const float *wanted)
{
    const SlotRow *row = &slot_table[slot];
    int components = type_table[row->type].components, count = MEASURE_SIDE * MEASURE_SIDE;
    double most = 0, squares = 0;
    for (int i = 0; i < count; i++)
        for (int component = 0; component < components; component++) {
            double want = clamp(wanted[4 * i + component], row->low, row->high),
                   got = found[4 * i + component];
            double d = isfinite(got)
                           ? fabs(clamp(got, row->low, row->high) - want) / fmax(1, fabs(want))
                           : INFINITY;
            most = fmax(most, d);
            squares += d * d;
        }
    return (Distance){most, sqrt(squares / (count * components))};
}

static Distance find_aliased(Errors *e, const Variant *variant, int slot, Material *material)
{
    Distance none = {NAN, NAN};
    if (!e->request->aliasing || slot == SLOT_normal || slot == SLOT_coatNormal)
        return none;
    const float *wanted = mean_of(e, variant, slot);
    float *found = errors_allocate(MEASURE_SIDE * MEASURE_SIDE * 4, sizeof *found);
    if (wanted &&
        meter_draw_mean(e->meter, &(MeterDraw){material, &e->view, &e->picture}, 1, found))
        none = picture_distance(slot, found, wanted);
    free(found);
    return none;
}

static Distance find_computed(Errors *e, const Variant *variant, int slot, Material *material)
{
    Distance result = {NAN, NAN};
    float(*rgba)[4] = errors_allocate(POINTS, sizeof *rgba);
    SlotValues *found = errors_allocate(POINTS, sizeof *found);
    if (meter_draw_points(e->meter, material, &e->points, rgba)) {
        for (int i = 0; i < POINTS; i++)
            for (int component = 0; component < 4; component++)
                found[i].component[slot][component] = rgba[i][component];
        result = autotune_distance((Slot)slot, found, truth_of(e, variant)->values, POINTS);
    }
    free(found);
    free(rgba);
    return result;
}

static const Known *find_known(const Errors *e, const char *fragment, int slot, int truth)
{
    for (int i = 0; i < e->known_count; i++)
        if (e->known[i].slot == slot && e->known[i].truth == truth &&
            variant_programs_equal(e->known[i].fragment, fragment))
            return &e->known[i];
    return NULL;
}

/* A program without varyings is constant over the surface and cannot alias. */
static bool is_constant(const char *fragment) { return !strstr(fragment, "\nin "); }

static const Known *learn(Errors *e, const Variant *variant, int slot, MatcProgram *program)
{
    Material material;
    const char *fragment = matc_output(program, MATC_FRAGMENT, NULL);
    Known known = {strdup(fragment), slot, truth_index(variant), {NAN, NAN}, {NAN, NAN}};
    if (!known.fragment)
        memory_exhausted();
    if (meter_make_material(e->meter, program, &material)) {
        known.computed = find_computed(e, variant, slot, &material);
        known.aliased =
            is_constant(fragment) ? (Distance){0, 0} : find_aliased(e, variant, slot, &material);
    }
    material_delete(&material);
    e->known = grow(e->known, e->known_count, &e->known_capacity, sizeof *e->known);
    e->known[e->known_count] = known;
    return &e->known[e->known_count++];
}

/* Measures a slot's error before packing. */
static void find_slot(Errors *e, Measured *m, int slot)
{
    MatcOptions options = variant_options(&m->variant, e->request->options);
    options.pass = "value";
    options.slot = slot_table[slot].name;
    MatcProgram *program =
        variant_compile(e->request->document, e->request->material, MATC_FRAGMENT, &options);
    if (!program)
        return;
    const Known *known =
        find_known(e, matc_output(program, MATC_FRAGMENT, NULL), slot, truth_index(&m->variant));
    if (!known)
        known = learn(e, &m->variant, slot, program);
    matc_program_free(program);
    m->computed[slot] = known->computed;
    m->aliased[slot] = known->aliased;
}

static bool find_packed(Errors *e, Measured *m, MatcProgram *program, Material *material)
{
    const Layout layout = (Layout)m->variant.layout;
    if (!errors_has_truth(e, &m->variant))
        return false;
    SlotValues *found = errors_allocate(POINTS, sizeof *found);
    bool fine = meter_make_material(e->meter, program, material) &&
                meter_open_layout(e->meter, layout, matc_output(program, MATC_UNPACK, NULL)) &&
                meter_draw_packed(e->meter, material, layout, &e->points, found);
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        m->packed[slot] =
            fine && e->meter->readers[layout].holds[slot]
                ? autotune_distance((Slot)slot, found, truth_of(e, &m->variant)->values, POINTS)
                : (Distance){NAN, NAN};
    free(found);
    return fine;
}

static void sum_up(Measured *m)
{
    m->error = m->rms = 0;
    m->aliasing = NAN;
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        m->error = fmax(m->error, m->packed[slot].maximum); /* fmax ignores NaN */
        m->rms = fmax(m->rms, m->packed[slot].rms);
        m->aliasing = fmax(m->aliasing, m->aliased[slot].rms);
    }
}

bool errors_measure(Errors *e, Measured *m, MatcProgram *program, Material *material)
{
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        m->computed[slot] = m->aliased[slot] = (Distance){NAN, NAN};
    if (!find_packed(e, m, program, material))
        return false;
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        find_slot(e, m, slot);
    sum_up(m);
    return true;
}

void errors_close(Errors *e)
{
    for (int i = 0; i < e->known_count; i++)
        free(e->known[i].fragment);
    for (int i = 0; i < CHOICE_COUNT * CHOICE_COUNT; i++) {
        free(e->truth[i].values);
        for (int slot = 0; slot < SLOT_COUNT; slot++)
            free(e->truth[i].mean[slot]);
    }
    field_delete(e->meter->gl, &e->points);
    field_delete(e->meter->gl, &e->view);
    framebuffer_delete(e->meter->gl, &e->picture);
    free(e->known);
}
