/* Validates a program by glslang, and draws its values. */
#include "compiler/layout/layout.h"
#include "generate.h"
#include "spread.h"
#include "trial.h"
#include "tests/value/bounds.h"
#include "compiler/lower/lower.h"
#include "compiler/pipeline.h"
#include <stdlib.h>
#include <string.h>

/* every 16th point is compared; all are checked for NaN */
enum { FEW = 8, MANY = 400, JUDGED_STEP = 16 };
/* max filters of a drawn tree: drivers inline the 27 evaluations of each */
enum { MAX_FILTERS = 1 };
/* max node evaluations for the spreads of a slot, which is then skipped */
static const double MAX_WORK = 2e7;

typedef struct {
    Target target;
    int optimize;
} Variant;
static const Variant variants[] = {{TARGET_glsl330, 0},
                                   {TARGET_glsl330, 2},
                                   {TARGET_glsl110, 2},
                                   {TARGET_glsl450, 2},
                                   {TARGET_essl300, 2}};
enum { VARIANTS = sizeof variants / sizeof *variants };

/* Layout for drawing to half floats: the options' layout, or another one if that has integer
 * words, which cannot be NaN. */
static const LayoutRow *half_layout(const Trial *t, Target target)
{
    Job job;
    MatcOptions options = t->options;
    options.target = target_table[target].name;
    return choice_job(&options, &job) || layout_has_words(job.layout) ? &layout_table[LAYOUT_thesis]
                                                                      : job.layout;
}

static bool is_written(const MatcOptions *options, Target target)
{
    Job job;
    return target_table[target].words ||
           (!choice_job(options, &job) && !layout_has_words(job.layout));
}

bool trial_validate(Trial *t, const char *text, size_t size)
{
    MatcOptions options = t->options;
    MatcDocument *document = matc_read("stress.yaml", text, size, &options);
    bool fine = true;
    options.validate = true;
    for (int target = 0; target < TARGET_COUNT && fine; target++) {
        options.target = target_table[target].name;
        if (!is_written(&options, (Target)target))
            continue;
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT | MATC_VERTEX, &options);
        fine = matc_ok(program) ||
               trial_fault(t, FAULT_not_valid, "%s", matc_program_diagnostics(program, MATC_TEXT));
        t->count->validated++;
        matc_program_free(program);
    }
    matc_document_free(document);
    return fine;
}

/* Expected values of a document's slot at the field's points. */
typedef struct {
    Trial *trial;
    MatcDocument *document;
    Slot slot;
    Arena arena;
    const Ir *ir[2][2]; /* with the noise of glsl330 and of glsl110; unoptimized and optimized */
    ReferenceTexture textures[2][2][EVALUATE_TEXTURES];
    Oracle *oracles[2];
    Evaluation (*exact)[FIELD_COUNT]; /* evaluations with either noise */
    double bound;
    double work, each; /* work done; work of one evaluation */
    float *rgba[4];
} Drawing;

static ReferenceContext context_of(const Drawing *d, int noise, int level)
{
    return (ReferenceContext){d->ir[noise][level]->noise, d->textures[noise][level]};
}

static bool make_ir(Drawing *d, int noise)
{
    static const Target targets[] = {TARGET_glsl330, TARGET_glsl110};
    Trial *t = d->trial;
    t->options.target = target_table[targets[noise]].name;
    for (int level = 0; level < 2; level++) {
        d->ir[noise][level] = trial_ir(t, &d->arena, PASS_value, d->slot, 2 * level);
        if (d->ir[noise][level])
            evaluate_textures(&d->arena, d->ir[noise][level], d->textures[noise][level]);
    }
    t->options.target = NULL;
    return d->ir[noise][0] && d->ir[noise][1];
}

static void inputs_at(const TrialPlan *plan, int point, double inputs[INPUT_COUNT][4])
{
    evaluate_inputs(&plan->field[point], true, inputs);
    pixel_inputs(plan->pixel, inputs);
}

static bool drawing_open(Drawing *d)
{
    Trial *t = d->trial;
    d->work = 0;
    for (int i = 0; i < 2; i++) {
        if (!make_ir(d, i))
            return false;
        d->each = (double)d->ir[i][0]->count * pow(27, t->material->filters);
        ReferenceContext context = context_of(d, i, 0);
        d->oracles[i] = oracle_open(t->graph, &context);
        for (int k = 0; k < FIELD_COUNT; k++) {
            double inputs[INPUT_COUNT][4];
            inputs_at(t->plan, k, inputs);
            evaluate_double(d->ir[i][0], &context, (const double(*)[4])inputs, &d->exact[i][k]);
        }
    }
    return true;
}

/* One component of a variant's drawing at a point: the drawn and the expected value. */
typedef struct {
    int noise, optimize; /* noise and level of the variant */
    int point, component;
    double want, got;
} DrawnComponent;

/* Distance of a drawn number from the spread of the program as written and, for an optimized
 * program, from that program's spread: the optimized mix rounds relative to its greater operand.
 * By `count` evaluations of each. */
static double spread_of(Drawing *d, const DrawnComponent *drawn, int count)
{
    double inputs[INPUT_COUNT][4], miss = INFINITY;
    inputs_at(d->trial->plan, drawn->point, inputs);
    for (int level = 0; level <= drawn->optimize / 2; level++) {
        Spread spread;
        ReferenceContext context = context_of(d, drawn->noise, level);
        const Evaluated at = {d->ir[drawn->noise][level], &context, (const double(*)[4])inputs,
                              (const double(*)[4])d->exact[drawn->noise][drawn->point].value};
        d->trial->count->spreads++;
        d->work += d->each * count;
        spread_make(&at, MACHINE_float, count, &spread);
        miss = fmin(miss, spread_miss(&spread, 0, drawn->component, drawn->want, drawn->got));
    }
    return miss;
}

static bool judge(Drawing *d, int noise, const Variant *v, int k, const double want[4])
{
    Trial *t = d->trial;
    const float *got = &d->rgba[0][4 * k];
    for (int component = 0; component < type_table[slot_table[d->slot].type].components;
         component++) {
        const DrawnComponent drawn = {noise,     v->optimize,     k,
                                      component, want[component], got[component]};
        double miss = fabs(got[component] - want[component]) / fmax(1, fabs(want[component]));
        t->count->drawn_values++;
        t->count->judged += miss <= d->bound;
        for (int count = FEW; count <= MANY && miss > d->bound; count *= MANY / FEW) {
            if (d->work > MAX_WORK)
                return true;
            miss = spread_of(d, &drawn, count);
        }
        const float *u = t->plan->field[k].input[INPUT_U], *x = t->plan->field[k].input[INPUT_X];
        if (miss > d->bound)
            return trial_fault(t, FAULT_drawn_value,
                               "%s -O%d %s lane %d is %.9g, should be %.9g, at point %d: u=%.9g "
                               "v=%.9g x=%.9g y=%.9g z=%.9g",
                               target_table[v->target].name, v->optimize, slot_table[d->slot].name,
                               component, got[component], want[component], k, u[0], u[1], x[0],
                               x[1], x[2]);
    }
    return true;
}

static bool compare(Drawing *d, const Variant *v)
{
    Trial *t = d->trial;
    int noise = !target_table[v->target].words;
    for (int k = 0; k < FIELD_COUNT; k++) {
        if (d->exact[noise][k].peak > t->plan->greatest)
            continue;
        for (int component = 0; component < 4; component++)
            if (!isfinite(d->rgba[0][4 * k + component]))
                return trial_fault(t, FAULT_drawn_nan, "%s -O%d %s lane %d at point %d",
                                   target_table[v->target].name, v->optimize,
                                   slot_table[d->slot].name, component, k);
    }
    for (int k = t->plan->first % JUDGED_STEP; k < FIELD_COUNT && !t->plan->only_finite;
         k += JUDGED_STEP) {
        Surface surface;
        SlotValues values;
        if (d->exact[noise][k].peak > t->plan->greatest || point_is_extreme(&t->plan->field[k]))
            continue;
        point_surface(&t->plan->field[k], true, &surface);
        if (t->plan->oracle && !t->exact)
            oracle_material(d->oracles[noise], t->material, &surface, &values);
        else
            memcpy(values.component[d->slot], d->exact[noise][k].value[0],
                   sizeof values.component[0]);
        if (!judge(d, noise, v, k, values.component[d->slot]))
            return false;
    }
    return true;
}

/* Draws a compiled program into the first `targets` of rgba. */
static bool draw(Drawing *d, const Variant *v, bool half, int targets)
{
    Trial *t = d->trial;
    const TrialPlan *plan = t->plan;
    MatcOptions options = t->options;
    options.pass = half ? "gbuffer" : "value";
    options.layout = half ? half_layout(t, v->target)->name : NULL;
    options.slot = slot_table[d->slot].name;
    options.target = target_table[v->target].name;
    options.optimize = v->optimize;
    MatcProgram *program = matc_compile(d->document, 0, MATC_FRAGMENT, &options);
    bool old = !target_table[v->target].in_out, fine = false;
    Drawer *drawer = old    ? (half ? plan->compat_half : plan->compat)
                     : half ? plan->core_half
                            : plan->core;
    if (matc_ok(program)) {
        char *text = pixel_program(plan->pixel, matc_output(program, MATC_FRAGMENT, NULL));
        Shading shading = {text, NULL, v->target, program, t->graph};
        Material material;
        fine = drawer_material(drawer, &shading, &material) &&
               drawer_draw(drawer, &material, true, d->rgba, targets);
        material_delete(&material);
        free(text);
        t->count->programs++;
    }
    if (!fine)
        trial_fault(t, FAULT_not_drawn, "%s -O%d: %s%s", options.target, v->optimize,
                    matc_program_diagnostics(program, MATC_TEXT), drawer->error);
    matc_program_free(program);
    return fine;
}

static Choice trigonometry_of(const Trial *t)
{
    Job job;
    choice_job(&t->options, &job);
    return (Choice)job.choice[AXIS_trigonometry];
}

static bool draw_slot(Drawing *d)
{
    Subjects subjects;
    subjects_of(d->trial->material, d->slot, &subjects);
    d->bound = bound_table[subject_governing(&subjects, trigonometry_of(d->trial))].bound;
    bool fine = drawing_open(d);
    for (int i = 0; i < VARIANTS && fine; i++)
        fine = draw(d, &variants[i], false, 1) && compare(d, &variants[i]);
    oracle_close(d->oracles[0]);
    oracle_close(d->oracles[1]);
    d->oracles[0] = d->oracles[1] = NULL;
    arena_free(&d->arena);
    d->arena = (Arena){0};
    return fine;
}

/* Checks half-float targets after a G-buffer pass: no NaN and no infinity, whatever the
 * intermediate values are. */
static bool draw_packed(Drawing *d)
{
    Trial *t = d->trial;
    for (int i = 0; i < VARIANTS; i += 2) {
        const int targets = layout_targets(half_layout(t, variants[i].target));
        if (!draw(d, &variants[i], true, targets))
            return false;
        for (int k = 0; k < 4 * FIELD_COUNT * targets; k++) {
            float v = d->rgba[k / (4 * FIELD_COUNT)][k % (4 * FIELD_COUNT)];
            if (!isfinite(v))
                return trial_fault(t, FAULT_packed,
                                   "%s -O%d: target %d lane %d holds %g at point %d",
                                   target_table[variants[i].target].name, variants[i].optimize,
                                   k / (4 * FIELD_COUNT), k % 4, v, k % (4 * FIELD_COUNT) / 4);
        }
    }
    return true;
}

bool trial_draw(Trial *t, const char *text, size_t size)
{
    if (t->material->filters > MAX_FILTERS)
        return true;
    Drawing d = {.trial = t, .document = matc_read("stress.yaml", text, size, &t->options)};
    d.exact = malloc(2 * sizeof *d.exact);
    for (int i = 0; i < 4; i++)
        d.rgba[i] = malloc(sizeof(float) * 4 * FIELD_COUNT);
    if (!d.exact || !d.rgba[0] || !d.rgba[1] || !d.rgba[2] || !d.rgba[3])
        abort();
    bool fine = true;
    for (int slot = 0; slot < SLOT_COUNT && fine; slot++) {
        d.slot = (Slot)slot;
        fine = !t->slots[slot] || draw_slot(&d);
    }
    fine = fine && (!t->plan->core_half || draw_packed(&d));
    for (int i = 0; i < 4; i++)
        free(d.rgba[i]);
    free(d.exact);
    matc_document_free(d.document);
    return fine;
}
