/* All checks of a trial that need no GL. */
#include "trial.h"
#include "compiler/layout/layout.h"
#include "generate.h"
#include "packed.h"
#include "spread.h"
#include "tests/value/bounds.h"
#include "compiler/lower/lower.h"
#include <stdio.h>
#include <string.h>

const char *const fault_names[] = {
    "none",     "document refused", "no IR",     "text of the IR", "not a number", "-O0",  "-O2",
    "in float", "packed",           "not valid", "not drawn",      "drawn NaN",    "drawn"};

/* Numbers of evaluations of a spread: FEW first, MANY before a fault is reported. */
enum { FEW = 12, MANY = 300 };
static const double double_bound = 1e-9;

bool trial_fault(Trial *t, FaultKind kind, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    vsnprintf(t->fault->text, sizeof t->fault->text, format, args);
    va_end(args);
    t->fault->kind = kind;
    return false;
}

static const char *reported(Session *session)
{
    Text out = text_new(session->arena);
    for (size_t i = 0; i < session->diags.count; i++)
        diag_print(&out, &session->diags.at[i], session->sources);
    return out.at ? out.at : "";
}

static bool open_document(Trial *t, const char *text, size_t size)
{
    t->options = t->plan->options;
    t->options.pixels = true;
    t->options.validate = false;
    t->options.read_file = generate_file;
    t->session = (Session){.options = &t->options, .arena = &t->arena, .check = true};
    Source source = {.name = "stress.yaml", .text = text, .size = size};
    ARENA_PUSH(&t->arena, t->session.sources, t->session.source_count, t->session.source_capacity,
               source);
    t->graph = compile_front(&t->session, 0, &t->tree);
    if (!t->graph || t->session.diags.errors || !t->graph->material_count)
        return trial_fault(t, FAULT_refused, "%s", reported(&t->session));
    t->material = t->graph->materials[0].node;
    Job job;
    choice_job(&t->options, &job);
    t->oracle = oracle_open(
        t->graph, &(ReferenceContext){.noise = job_noise(job.choice[AXIS_noise], job.target)});
    t->exact = job.choice[AXIS_derivatives] != CHOICE_derivatives_finite;
    oracle_derivatives(t->oracle, (Choice)job.choice[AXIS_derivatives]);
    t->count->nodes += t->graph->node_count;
    return true;
}

const Ir *trial_ir(Trial *t, Arena *arena, Pass pass, Slot slot, int level)
{
    Session session = {.options = &t->options, .arena = arena, .optimize = level, .check = true};
    Job job;
    choice_job(&t->options, &job);
    job.pass = pass;
    job.slot = slot;
    session.sources = t->session.sources;
    const Ir *ir = compile_ir(&session, t->graph, t->material, &job);
    if (!ir)
        trial_fault(t, FAULT_no_ir, "%s %s -O%d: %s", pass_table[pass].name, slot_table[slot].name,
                    level, reported(&session));
    return ir;
}

/* Selects the slots that are not constant, and one of the others. */
static void find_slots(Trial *t)
{
    int plain = 0;
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        Subjects subjects;
        subjects_of(t->material, (Slot)slot, &subjects);
        t->bumps[slot] =
            subjects.has[KIND_BumpMap] || (slot == SLOT_normal && oracle_displaced(t->material));
        for (int kind = 0; kind < KIND_COUNT; kind++)
            t->slots[slot] |= subjects.has[kind] && kind != KIND_Constant &&
                              kind_table[kind].lowering != LOWERING_MATERIAL;
        plain += !t->slots[slot];
    }
    if (plain)
        t->slots[t->plan->first % SLOT_COUNT] = true;
}

static bool reads_back(Trial *t, Arena *arena, const Ir *ir)
{
    Session session = {.options = &t->options, .arena = arena};
    const char *wrong = "";
    if (!ir->output_count)
        return true; /* the shadow program of an opaque material */
    Text first = text_new(arena), second = text_new(arena);
    ir_print(&first, ir);
    const Ir *back = ir_read(&session, first.at, t->graph, &wrong);
    if (!back)
        return trial_fault(t, FAULT_text, "ir_read: %s\n%s", wrong, first.at);
    ir_print(&second, back);
    return !strcmp(first.at, second.at) || trial_fault(t, FAULT_text, "it changes:\n%s", first.at);
}

/* The versions of a program: -O0, -O2, and -O0 with inlined constants that otherwise come from a
 * buffer. Expressions of such constants are folded by matc, but round as if the program computed
 * them. */
enum { AS_WRITTEN, OPTIMISED, WITH_NUMBERS, FORM_COUNT };

/* A program in its versions, and its textures. */
typedef struct {
    Arena arena;
    const Ir *ir[FORM_COUNT];
    ReferenceTexture textures[FORM_COUNT][EVALUATE_TEXTURES];
    ReferenceContext context[FORM_COUNT];
    const char *name;
    Pixel pixel;
    double greatest; /* a greater intermediate value excuses every result */
} Program;

static bool calls(const Ir *ir, Function function)
{
    for (size_t i = 0; i < ir->count; i++)
        if (ir->nodes[i].op == OP_call && ir->nodes[i].payload == (uint32_t)function)
            return true;
    return false;
}

/* Pixel size for a program. A sampler with implicit derivatives has no footprint here. A picture
 * is sampled implicitly or with an explicit footprint depending on whether its first use is in a
 * branch, which the optimizer may change; a program with both gets a pixel of size 0. */
static Pixel pixel_of(const Trial *t, const Program *p)
{
    bool sees = false, reported = false;
    for (int form = 0; form < FORM_COUNT; form++) {
        sees |= calls(p->ir[form], FN_imageSampled) || calls(p->ir[form], FN_imageCentred);
        reported |= calls(p->ir[form], FN_imageSampledOver);
    }
    return sees && reported ? (Pixel){0, 0} : t->plan->pixel;
}

static bool make_form(Trial *t, Program *p, Pass pass, Slot slot, int form)
{
    const char *constants = t->options.constants;
    if (form == WITH_NUMBERS)
        t->options.constants = "baked";
    p->ir[form] = trial_ir(t, &p->arena, pass, slot, form == OPTIMISED ? 2 : 0);
    t->options.constants = constants;
    if (!p->ir[form])
        return false;
    evaluate_textures(&p->arena, p->ir[form], p->textures[form]);
    p->context[form] = (ReferenceContext){p->ir[form]->noise, p->textures[form]};
    return true;
}

static bool make_program(Trial *t, Program *p, Pass pass, Slot slot)
{
    p->arena = (Arena){0};
    p->greatest = pass == PASS_value ? t->plan->greatest : GREATEST_VALUE;
    p->name = pass == PASS_value ? slot_table[slot].name : pass_table[pass].name;
    if (!make_form(t, p, pass, slot, AS_WRITTEN) || !make_form(t, p, pass, slot, OPTIMISED))
        return false;
    p->ir[WITH_NUMBERS] = p->ir[AS_WRITTEN];
    p->context[WITH_NUMBERS] = p->context[AS_WRITTEN];
    if (p->ir[AS_WRITTEN]->constant_count + p->ir[OPTIMISED]->constant_count > 0 &&
        !make_form(t, p, pass, slot, WITH_NUMBERS))
        return false;
    p->pixel = pixel_of(t, p);
    return reads_back(t, &p->arena, p->ir[OPTIMISED]);
}

/* A program at one point. */
typedef struct {
    Program *program;
    const Point *point;
    bool front;
    double inputs[INPUT_COUNT][4];
    Evaluation exact[2]; /* by optimization level */
} Spot;

static const char *where(const Spot *s)
{
    static _Thread_local char text[400];
    const float(*i)[3] = s->point->input;
    snprintf(
        text, sizeof text,
        "%s at u=%.9g v=%.9g x=%.9g y=%.9g z=%.9g px=%.9g py=%.9g pz=%.9g nx=%.9g ny=%.9g nz=%.9g "
        "dpxdu=%.9g dpydu=%.9g dpzdu=%.9g dpxdv=%.9g dpydv=%.9g dpzdv=%.9g front=%d",
        s->program->name, i[INPUT_U][0], i[INPUT_U][1], i[INPUT_X][0], i[INPUT_X][1], i[INPUT_X][2],
        i[INPUT_P][0], i[INPUT_P][1], i[INPUT_P][2], i[INPUT_N][0], i[INPUT_N][1], i[INPUT_N][2],
        i[INPUT_DU][0], i[INPUT_DU][1], i[INPUT_DU][2], i[INPUT_DV][0], i[INPUT_DV][1],
        i[INPUT_DV][2], s->front);
    return text;
}

/* The plane and the eye, in passes that have them, are those of the point. */
static void spot_open(Spot *s, Program *program, const Point *point, bool front)
{
    *s = (Spot){.program = program, .point = point, .front = front};
    evaluate_inputs(point, front, s->inputs);
    pixel_inputs(program->pixel, s->inputs);
    memcpy(s->inputs[INPUT_planeU], s->inputs[INPUT_DU], sizeof s->inputs[0]);
    memcpy(s->inputs[INPUT_planeV], s->inputs[INPUT_DV], sizeof s->inputs[0]);
    memcpy(s->inputs[INPUT_eye], s->inputs[INPUT_P], sizeof s->inputs[0]);
    s->inputs[INPUT_depthZ][2] = s->inputs[INPUT_clipW][2] = -1;
    s->inputs[INPUT_depthZ][3] = -1;
}

/* Checks that every node is finite, as written and optimized, in double and in float; returns
 * false without a fault if values exceed the limits. */
static bool is_finite(Trial *t, Spot *s, bool *beyond)
{
    Evaluation rounded;
    for (int i = 0; i < 2; i++) {
        evaluate_double(s->program->ir[i], &s->program->context[i], (const double(*)[4])s->inputs,
                        &s->exact[i]);
        *beyond |= s->exact[i].peak > s->program->greatest;
    }
    t->count->beyond += *beyond;
    for (int i = 0; i < 2 && !*beyond; i++) {
        if (!s->exact[i].finite)
            return trial_fault(t, FAULT_infinite, "-O%d %s", 2 * i, where(s));
        evaluate_float(s->program->ir[i], &s->program->context[i], (const double(*)[4])s->inputs,
                       &rounded);
        if (!rounded.finite && rounded.peak <= s->program->greatest)
            return trial_fault(t, FAULT_float, "-O%d %s", 2 * i, where(s));
    }
    return true;
}

/* One component of an output at a level, and its expected value. */
typedef struct {
    int level, output, component;
    double want;
} Expected;

/* The spread is computed only if the values differ. */
static bool agrees(Trial *t, Spot *s, const Expected *e)
{
    const double got = s->exact[e->level].value[e->output][e->component], want = e->want;
    if (fabs(got - want) <= double_bound * fmax(1, fabs(want)))
        return true;
    const Evaluated at = {s->program->ir[WITH_NUMBERS], &s->program->context[WITH_NUMBERS],
                          (const double(*)[4])s->inputs, (const double(*)[4])s->exact[0].value};
    double miss = INFINITY;
    for (int count = FEW; count <= MANY && miss > double_bound; count *= MANY / FEW) {
        Spread spread;
        t->count->spreads++;
        spread_make(&at, MACHINE_double, count, &spread);
        miss = fmax(spread_miss(&spread, e->output, e->component, want, got),
                    spread_miss(&spread, e->output, e->component, got, want));
    }
    return miss <= double_bound ||
           trial_fault(t, e->level ? FAULT_level_2 : FAULT_level_0,
                       "lane %d is %.17g, should be %.17g: %s", e->component, got, want, where(s));
}

static bool try_slot(Trial *t, Program *p, Slot slot)
{
    for (int i = 0; i < t->plan->count; i++) {
        Spot s;
        TrialWanted wanted;
        bool beyond = false, front = (t->plan->first + i) % 4 != 0;
        const Point *point = &t->plan->field[(t->plan->first + i) % FIELD_COUNT];
        spot_open(&s, p, point, front);
        if (!is_finite(t, &s, &beyond))
            return false;
        if (beyond)
            continue;
        trial_query_oracle(t, point, front, slot, &wanted);
        for (int component = 0; component < type_table[slot_table[slot].type].components;
             component++) {
            double written = s.exact[0].value[0][component],
                   want = wanted.known ? wanted.value.component[slot][component] : written;
            double tolerance = wanted.tolerance.component[slot][component];
            t->count->slopes += wanted.known && tolerance > 0;
            if (tolerance > 0 && fabs(want - written) <= tolerance)
                want = written; /* the optimized program is compared with the unoptimized one */
            for (int level = 0; level < 2; level++)
                if (!agrees(t, &s, &(Expected){level, 0, component, want}))
                    return false;
            t->count->values += 2;
        }
    }
    return true;
}

static int output_of(const Ir *ir, int target)
{
    int i = 0;
    while (i < ir->output_count &&
           (ir->outputs[i].kind != OUT_color || ir->outputs[i].index != target))
        i++;
    return i;
}

/* Checks that the codes of the thesis' pairs have no special exponent of a half float. */
static bool pairs_in_range(Trial *t, const Spot *s, const LayoutRow *layout)
{
    Placement placement;
    if (layout_allocate(layout, 0, &placement))
        return trial_fault(t, FAULT_packed, "the layout does not fit");
    for (int i = 0; i < placement.count; i++) {
        const Piece *piece = &placement.pieces[i];
        if (piece->field->encoding != ENCODING_pair)
            continue;
        double v = s->exact[1].value[output_of(s->program->ir[1], piece->target)][piece->component];
        if (!(v >= 1 && v <= 65504))
            return trial_fault(t, FAULT_packed, "the pair of target %d lane %d is %g: %s",
                               piece->target, piece->component, v, where(s));
    }
    return true;
}

/* Checks the range of a picture, or of the layout's G-buffer. */
static bool in_range(Trial *t, const Spot *s, const LayoutRow *layout)
{
    const Ir *ir = s->program->ir[1];
    for (int target = 0; target < (layout ? layout_targets(layout) : 1); target++)
        for (int component = 0; component < 4; component++) {
            double v = s->exact[1].value[output_of(ir, target)][component];
            if (!packed_in_range(v,
                                 &format_table[layout ? layout->formats[target] : FORMAT_RGBA16F]))
                return trial_fault(t, FAULT_packed, "target %d lane %d is %g: %s", target,
                                   component, v, where(s));
        }
    return !layout || pairs_in_range(t, s, layout);
}

/* The layout that a pass writes; NULL: the pass writes no G-buffer. */
static const LayoutRow *layout_of(const Trial *t, Pass pass)
{
    Job job;
    return pass != PASS_gbuffer && pass != PASS_plane ? NULL
           : choice_job(&t->options, &job)            ? NULL
                                                      : job.layout;
}

/* Compares an output at -O2 with -O0: words by their fields. Differences beyond adjacent codes
 * must be explained by rounding. */
static bool output_agrees(Trial *t, Spot *s, const LayoutRow *layout, int output)
{
    const IrOutput *out = &s->program->ir[0]->outputs[output];
    const bool words =
        layout && out->kind == OUT_color && format_table[layout->formats[out->index]].words;
    double last[2] = {0};
    for (int level = 0; level < 2 && words; level++)
        last[level] =
            s->exact[level].value[output_of(s->program->ir[level], layout_targets(layout) - 1)][3];
    for (int component = 0; component < 4; component++) {
        const double want = s->exact[0].value[output][component];
        if (words && packed_agree(layout, out->index, component,
                                  &(PackedPair){{want, s->exact[1].value[output][component]},
                                                {last[0], last[1]}}))
            continue;
        if (!agrees(t, s, &(Expected){1, output, component, want}))
            return false;
    }
    return true;
}

/* True for an output of vertices, or for a discard that is missing at -O2 because it never
 * happens. */
static bool is_other(const Program *p, int output)
{
    return !ir_is_of_fragments(&p->ir[0]->outputs[output]) ||
           (output < p->ir[1]->output_count && !ir_is_of_fragments(&p->ir[1]->outputs[output]));
}

/* Checks a pass of the whole material: finite, and equal at -O2 and -O0. */
static bool try_pass(Trial *t, Pass pass)
{
    Program p;
    const LayoutRow *layout = layout_of(t, pass);
    bool fine = make_program(t, &p, pass, SLOT_diffuse);
    for (int i = 0; i < t->plan->count && fine; i++) {
        Spot s;
        bool beyond = false;
        spot_open(&s, &p, &t->plan->field[(t->plan->first + i) % FIELD_COUNT], i % 4 != 0);
        fine = is_finite(t, &s, &beyond);
        if (fine && !beyond && pass != PASS_shadow)
            fine = in_range(t, &s, layout);
        for (int output = 0; fine && !beyond && output < p.ir[0]->output_count; output++)
            fine = is_other(&p, output) || output_agrees(t, &s, layout, output);
    }
    arena_free(&p.arena);
    return fine;
}

static bool try_slots(Trial *t)
{
    bool fine = true;
    for (int slot = 0; slot < SLOT_COUNT && fine; slot++) {
        Program p;
        if (!t->slots[slot])
            continue;
        fine = make_program(t, &p, PASS_value, (Slot)slot) && try_slot(t, &p, (Slot)slot);
        arena_free(&p.arena);
    }
    return fine;
}

bool trial_run(const TrialPlan *plan, const char *text, size_t size, TrialCount *count,
               TrialFault *fault)
{
    static const Pass others[] = {PASS_plane, PASS_sky, PASS_shadow, PASS_gbuffer};
    Trial t = {.plan = plan, .count = count, .fault = fault};
    *fault = (TrialFault){0};
    count->trees++;
    bool fine = open_document(&t, text, size);
    if (fine)
        find_slots(&t);
    fine = fine && try_slots(&t) && try_pass(&t, PASS_gbuffer);
    fine = fine && (plan->first % 4 == 3 || try_pass(&t, others[plan->first % 4]));
    fine = fine && (!plan->validate || trial_validate(&t, text, size));
    fine = fine && (!plan->core || trial_draw(&t, text, size));
    if (t.oracle)
        oracle_close(t.oracle);
    arena_free(&t.arena);
    return fine;
}
