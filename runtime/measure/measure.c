/* Measures variants one after the other: errors first, then all times together. */
#include "runtime/measure/candidates.h"
#include "runtime/gl/message.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

const double measure_range = 4;

enum { LEAST_ROUNDS = 5, SOFTWARE_SIDE = 512, HARDWARE_SIDE = 2048, MOST_MEAN = 16, REFERENCE_SIDE = 16 };

/* A program of pass value whose errors are known: variants often share it. */
typedef struct {
    char *fragment;
    int slot, truth; /* of the reference */
    Distance computed, aliased;
} Known;

/* Values that several variants are compared with. */
typedef struct {
    SlotValues *values;      /* by the C reference */
    bool unknown;            /* they take it too many operations */
    float *mean[SLOT_COUNT]; /* supersampled; NULL: not made yet */
} Truth;

typedef struct {
    Meter *meter;
    const MeasureRequest *request;
    FieldVertex vertices[POINTS];
    Field points, view;
    Framebuffer picture;
    Known *known;
    int known_count, known_room;
    Truth truth[CHOICE_COUNT * CHOICE_COUNT]; /* by the choices of noise and derivatives */
    Material *materials;                      /* of pass gbuffer, one for each of the list */
    double start;
} Work;

static void *grow(void *list, int count, int *room, size_t size)
{
    if (count < *room)
        return list;
    *room = *room ? 2 * *room : 16;
    list = realloc(list, (size_t)*room * size);
    if (!list)
        abort();
    return list;
}

static void *make(size_t count, size_t size)
{
    void *memory = calloc(count ? count : 1, size);
    if (!memory)
        abort();
    return memory;
}

/* Two noises are two pictures, and so are two kinds of derivatives. */
static int truth_index(const Variant *variant)
{
    return variant->choice[AXIS_noise] * CHOICE_COUNT + variant->choice[AXIS_derivatives];
}

static Truth *truth_of(Work *w, const Variant *variant)
{
    Truth *truth = &w->truth[truth_index(variant)];
    if (truth->values)
        return truth;
    truth->values = make(POINTS, sizeof *truth->values);
    truth->unknown = !measure_reference(w->request, variant, w->vertices, truth->values);
    return truth;
}

/* What nothing can be compared with is not measured. */
static bool has_truth(Work *w, const Variant *variant)
{
    return !truth_of(w, variant)->unknown ||
           message_fail(w->meter->error, sizeof w->meter->error,
                        "its values at %d points take the reference too many operations: filters within filters, over "
                        "maps that cost much",
                        POINTS);
}

static bool make_work(Work *w)
{
    FieldVertex plane[PLANE_VERTICES];
    Meter *m = w->meter;
    double scale = w->request->scale > 0 ? w->request->scale : 1;
    FramebufferSpec spec = {
        .width = MEASURE_SIDE, .height = MEASURE_SIDE, .color_count = 1, .color_format = GL_RGBA32F};
    sample_points(w->vertices, w->request->range);
    sample_plane(plane, &(PlaneView){.yaw = 0.3, .scale = scale, .aspect = 1, .height = MEASURE_SIDE});
    return (field_make(m->gl, w->vertices, POINTS, GL_POINTS, &w->points) &&
            field_make(m->gl, plane, PLANE_VERTICES, GL_TRIANGLE_STRIP, &w->view) &&
            framebuffer_make(m->gl, &spec, &w->picture)) ||
           message_fail(m->error, sizeof m->error, "%s", m->gl->error);
}

/* n for n x n samples: as many as a second of drawing allows. */
static int mean_side(Work *w, const MeterDraw *draw)
{
    const double seconds = clamp(w->request->seconds / 50, 0.05, 0.8);
    float *scratch = make(MEASURE_SIDE * MEASURE_SIDE * 4, sizeof *scratch);
    meter_draw_mean(w->meter, draw, 1, scratch);
    double start = meter_now();
    meter_draw_mean(w->meter, draw, 2, scratch);
    double once = fmax((meter_now() - start) / 4, 1e-5);
    free(scratch);
    return (int)clamp(sqrt(seconds / once), 8, 2 * REFERENCE_SIDE);
}

/* The supersampled picture of a slot, without antialiasing. */
static const float *mean_of(Work *w, const Variant *variant, int slot)
{
    Truth *truth = truth_of(w, variant);
    if (truth->mean[slot])
        return truth->mean[slot];
    Variant plain;
    variant_of(w->request->options, &plain);
    plain.choice[AXIS_noise] = variant->choice[AXIS_noise];
    plain.choice[AXIS_derivatives] = variant->choice[AXIS_derivatives];
    plain.choice[AXIS_aa] = CHOICE_aa_none;
    plain.choice[AXIS_coordinates] = CHOICE_coordinates_long; /* what rounds a coordinate is no reference */
    MatcOptions options = variant_options(&plain, w->request->options);
    options.pass = "value";
    options.slot = slot_table[slot].name;
    MatcProgram *program = variant_compile(w->request->document, w->request->material, MATC_FRAGMENT, &options);
    Material material = {0};
    const MeterDraw draw = {&material, &w->view, &w->picture};
    float *mean = make(MEASURE_SIDE * MEASURE_SIDE * 4, sizeof *mean);
    if (program && meter_make_material(w->meter, program, &material) &&
        meter_draw_mean(w->meter, &draw, mean_side(w, &draw), mean))
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
    int lanes = type_table[row->type].lanes, count = MEASURE_SIDE * MEASURE_SIDE;
    double most = 0, squares = 0;
    for (int i = 0; i < count; i++)
        for (int lane = 0; lane < lanes; lane++) {
            double want = clamp(wanted[4 * i + lane], row->low, row->high), got = found[4 * i + lane];
            double d = isfinite(got) ? fabs(clamp(got, row->low, row->high) - want) / fmax(1, fabs(want)) : INFINITY;
            most = fmax(most, d);
            squares += d * d;
        }
    return (Distance){most, sqrt(squares / (count * lanes))};
}

static Distance find_aliased(Work *w, const Variant *variant, int slot, Material *material)
{
    Distance none = {NAN, NAN};
    if (!w->request->aliasing || slot == SLOT_normal)
        return none;
    const float *wanted = mean_of(w, variant, slot);
    float *found = make(MEASURE_SIDE * MEASURE_SIDE * 4, sizeof *found);
    if (wanted && meter_draw_mean(w->meter, &(MeterDraw){material, &w->view, &w->picture}, 1, found))
        none = picture_distance(slot, found, wanted);
    free(found);
    return none;
}

static Distance find_computed(Work *w, const Variant *variant, int slot, Material *material)
{
    Distance result = {NAN, NAN};
    float(*rgba)[4] = make(POINTS, sizeof *rgba);
    SlotValues *found = make(POINTS, sizeof *found);
    if (meter_draw_points(w->meter, material, &w->points, rgba)) {
        for (int i = 0; i < POINTS; i++)
            for (int lane = 0; lane < 4; lane++)
                found[i].lane[slot][lane] = rgba[i][lane];
        result = measure_distance((Slot)slot, found, truth_of(w, variant)->values, POINTS);
    }
    free(found);
    free(rgba);
    return result;
}

static const Known *find_known(const Work *w, const char *fragment, int slot, int truth)
{
    for (int i = 0; i < w->known_count; i++)
        if (w->known[i].slot == slot && w->known[i].truth == truth &&
            variant_programs_equal(w->known[i].fragment, fragment))
            return &w->known[i];
    return NULL;
}

/* What does not vary over the surface has no varyings; it is neither slow nor aliased. */
static bool is_constant(const char *fragment) { return !strstr(fragment, "\nin "); }

static const Known *learn(Work *w, const Variant *variant, int slot, MatcProgram *program)
{
    Material material;
    const char *fragment = matc_output(program, MATC_FRAGMENT, NULL);
    Known known = {strdup(fragment), slot, truth_index(variant), {NAN, NAN}, {NAN, NAN}};
    if (!known.fragment)
        abort();
    if (meter_make_material(w->meter, program, &material)) {
        known.computed = find_computed(w, variant, slot, &material);
        known.aliased = is_constant(fragment) ? (Distance){0, 0} : find_aliased(w, variant, slot, &material);
    }
    material_delete(&material);
    w->known = grow(w->known, w->known_count, &w->known_room, sizeof *w->known);
    w->known[w->known_count] = known;
    return &w->known[w->known_count++];
}

/* The errors of a slot before it is packed. */
static void measure_slot(Work *w, Measured *m, int slot)
{
    MatcOptions options = variant_options(&m->variant, w->request->options);
    options.pass = "value";
    options.slot = slot_table[slot].name;
    MatcProgram *program = variant_compile(w->request->document, w->request->material, MATC_FRAGMENT, &options);
    if (!program)
        return;
    const Known *known = find_known(w, matc_output(program, MATC_FRAGMENT, NULL), slot, truth_index(&m->variant));
    if (!known)
        known = learn(w, &m->variant, slot, program);
    matc_program_free(program);
    m->computed[slot] = known->computed;
    m->aliased[slot] = known->aliased;
}

static bool measure_packed(Work *w, Measured *m, MatcProgram *program, Material *material)
{
    const Layout layout = (Layout)m->variant.layout;
    if (!has_truth(w, &m->variant))
        return false;
    SlotValues *found = make(POINTS, sizeof *found);
    bool fine = meter_make_material(w->meter, program, material) &&
                meter_open_layout(w->meter, layout, matc_output(program, MATC_UNPACK, NULL)) &&
                meter_draw_packed(w->meter, material, layout, &w->points, found);
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        m->packed[slot] = fine && w->meter->readers[layout].holds[slot]
                              ? measure_distance((Slot)slot, found, truth_of(w, &m->variant)->values, POINTS)
                              : (Distance){NAN, NAN};
    free(found);
    return fine;
}

static void sum_up(Measured *m)
{
    m->error = m->rms = 0;
    m->aliasing = NAN;
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        m->error = fmax(m->error, m->packed[slot].maximum); /* fmax passes a NaN over */
        m->rms = fmax(m->rms, m->packed[slot].rms);
        m->aliasing = fmax(m->aliasing, m->aliased[slot].rms);
    }
}

/* Two thirds of the time for errors, the rest for times. */
static bool has_time(const Work *w) { return meter_now() - w->start < w->request->seconds * 2 / 3; }

static void measure_errors(Work *w, Candidate *candidates, int count, MeasuredList *list)
{
    list->at = make((size_t)count, sizeof *list->at);
    w->materials = make((size_t)count, sizeof *w->materials);
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
        for (int slot = 0; slot < SLOT_COUNT; slot++)
            m->computed[slot] = m->aliased[slot] = (Distance){NAN, NAN};
        if (!measure_packed(w, m, candidates[i].program, material)) {
            material_delete(material);
            list->refused++;
            continue;
        }
        for (int slot = 0; slot < SLOT_COUNT; slot++)
            measure_slot(w, m, slot);
        sum_up(m);
        list->count++;
    }
}

/* Targets to be timed with: one set a layout. */
static bool make_targets(Work *w, const MeasuredList *list, Framebuffer targets[LAYOUT_COUNT], Framebuffer *plain)
{
    int side = w->meter->gl->hardware ? HARDWARE_SIDE : SOFTWARE_SIDE;
    FramebufferSpec spec = {.width = side, .height = side, .color_count = 1, .color_format = GL_RGBA16F};
    for (int i = 0; i < list->count; i++) {
        int layout = list->at[i].variant.layout;
        if (!targets[layout].name && !meter_make_targets(w->meter, (Layout)layout, side, side, &targets[layout]))
            return false;
    }
    return framebuffer_make(w->meter->gl, &spec, plain) ||
           message_fail(w->meter->error, sizeof w->meter->error, "%s", w->meter->gl->error);
}

/* As many rounds as the rest of the time allows. */
static int find_rounds(Work *w, const MeterDraw *draws, int count)
{
    double *scratch = make((size_t)count, sizeof *scratch), start = meter_now();
    meter_time(w->meter, draws, count, 1, scratch);
    double once = meter_now() - start, left = w->request->seconds - (start - w->start) - once;
    free(scratch);
    return (int)clamp(left / fmax(once, 1e-3) - 2, LEAST_ROUNDS, MEASURE_ROUNDS);
}

static bool measure_times(Work *w, MeasuredList *list)
{
    Framebuffer targets[LAYOUT_COUNT], plain;
    Material constant = {0};
    MeterDraw *draws = make((size_t)list->count + 1, sizeof *draws);
    double *nanoseconds = make((size_t)list->count + 1, sizeof *nanoseconds);
    memset(targets, 0, sizeof targets);
    memset(&plain, 0, sizeof plain);
    bool fine = make_targets(w, list, targets, &plain) && meter_make_constant(w->meter, &constant);
    draws[0] = (MeterDraw){&constant, &w->view, &plain};
    for (int i = 0; i < list->count; i++)
        draws[1 + i] = (MeterDraw){&w->materials[i], &w->view, &targets[list->at[i].variant.layout]};
    fine = fine && meter_time(w->meter, draws, list->count + 1, find_rounds(w, draws, list->count + 1), nanoseconds);
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
    FrontPoint *points = make((size_t)list->count, sizeof *points);
    for (int front = 0; front < 2; front++) {
        for (int i = 0; i < list->count; i++)
            points[i] = (FrontPoint){list->at[i].nanoseconds, front ? list->at[i].aliasing : list->at[i].error, false};
        front_mark(points, list->count);
        for (int i = 0; i < list->count; i++)
            *(front ? &list->at[i].alias_front : &list->at[i].front) = points[i].front;
    }
    free(points);
}

static void discard(Work *w, int materials)
{
    GlContext *gl = w->meter->gl;
    for (int i = 0; i < materials; i++)
        material_delete(&w->materials[i]);
    for (int i = 0; i < w->known_count; i++)
        free(w->known[i].fragment);
    for (int i = 0; i < CHOICE_COUNT * CHOICE_COUNT; i++) {
        free(w->truth[i].values);
        for (int slot = 0; slot < SLOT_COUNT; slot++)
            free(w->truth[i].mean[slot]);
    }
    field_delete(gl, &w->points);
    field_delete(gl, &w->view);
    framebuffer_delete(gl, &w->picture);
    free(w->materials);
    free(w->known);
    free(w);
}

bool measure_variants(Meter *meter, const MeasureRequest *request, MeasuredList *list)
{
    Work *w = make(1, sizeof *w);
    int count;
    *list = (MeasuredList){0};
    w->meter = meter;
    w->request = request;
    w->start = meter_now();
    *meter->error = 0;
    Variant base;
    variant_of(request->options, &base);
    bool fine = make_work(w) && has_truth(w, &base);
    if (fine) {
        Candidate *candidates = candidates_make(request, list, &count);
        measure_errors(w, candidates, count, list);
        for (int i = 0; i < count; i++)
            matc_program_free(candidates[i].program);
        free(candidates);
        fine = list->count > 0 ? measure_times(w, list)
                               : *meter->error || message_fail(meter->error, sizeof meter->error,
                                                               "the material compiles in no way that is asked for");
        fine = fine && list->count > 0;
    }
    if (fine)
        mark_fronts(list);
    discard(w, list->count);
    if (!fine)
        measure_free(list);
    return fine;
}

void measure_free(MeasuredList *list)
{
    free(list->at);
    *list = (MeasuredList){0};
}
