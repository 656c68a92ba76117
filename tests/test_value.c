/* The proof: what the emitted programs draw is what the oracle says, for every example, slot, level and target.
 * tests/bounds.def says how far they may be apart, and the table at the end how far they are.
 * VALUE_ONLY=part-of-a-path in the environment looks at those documents only, and says more of each fault. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include "tests/value/bounds.h"
#include "tests/value/documents.h"
#include "tests/value/draw.h"
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#ifndef SOURCE_FOLDER
#define SOURCE_FOLDER "."
#endif

typedef struct {
    Target target;
    int optimize;
    Choice choice; /* the one that is not its axis' default, if any; of aa that is none here */
    bool buffered; /* numbers of the document come from a buffer */
} Variant;

/* Without a footprint filtered maps have the values of plain ones. */
static const Variant variants[] = {
    {TARGET_glsl330, 0, CHOICE_noise_lattice, false},
    {TARGET_glsl330, 2, CHOICE_noise_lattice, false},
    {TARGET_glsl110, 2, CHOICE_noise_lattice, false},
    {TARGET_glsl450, 2, CHOICE_noise_lattice, false},
    {TARGET_essl300, 2, CHOICE_noise_lattice, false},
    {TARGET_glsl330, 2, CHOICE_noise_groimp, false},
    {TARGET_glsl110, 2, CHOICE_noise_groimp, false},
    {TARGET_glsl330, 2, CHOICE_noise_simplex, false},
    {TARGET_glsl110, 2, CHOICE_noise_simplex, false},
    {TARGET_glsl330, 2, CHOICE_derivatives_analytic, false},
    {TARGET_glsl110, 2, CHOICE_derivatives_analytic, false},
    {TARGET_glsl330, 2, CHOICE_aa_box, false},
    {TARGET_glsl330, 2, CHOICE_coordinates_long, false},
    {TARGET_glsl330, 2, CHOICE_trigonometry_bounded, false},
    {TARGET_glsl330, 2, CHOICE_powers_compensated, false},
    {TARGET_glsl330, 2, CHOICE_noise_lattice, true},
    {TARGET_glsl110, 2, CHOICE_noise_lattice, true},
    {TARGET_glsl450, 0, CHOICE_noise_lattice, true},
    {TARGET_glsl330, 0, CHOICE_aa_auto, false},
    {TARGET_glsl330, 2, CHOICE_aa_auto, false},
    {TARGET_glsl110, 2, CHOICE_aa_auto, false},
    {TARGET_essl300, 2, CHOICE_aa_auto, false},
};
enum { VARIANTS = sizeof variants / sizeof *variants, NOISES = REFERENCE_NOISE_COUNT };

/* The worst that was seen of values that a subject takes part in. */
typedef struct {
    bool seen;
    double miss;
    char where[160];
} Worst;

enum { FAULTS = 200 };
static const double SHARP = 1e-3;

/* A slot of a material that some variants draw wrongly, or that cannot be drawn. */
typedef struct {
    char slot[160]; /* document, material and slot; equal ones are one fault */
    int count;
    double miss;
    char worst[500];
} Fault;

/* What all workers share. */
typedef struct {
    DocumentList documents;
    const Point *points;
    atomic_int next;
    pthread_mutex_t lock; /* of what follows */
    Worst worst[SUBJECT_COUNT];
    int fault_count;
    long values, sharp; /* compared; and of these, those whose hull and bound are below SHARP */
    Fault faults[FAULTS];
    int programs, drawn;
} Run;

/* Programs that differ in nothing but their slot draw the same: without textures and uniforms, once is enough. */
typedef struct {
    uint64_t hash;
    float *rgba[2];
} Drawn;

typedef struct {
    Run *run;
    Drawer core, compat;
    Drawn *memo;
    int memo_count, memo_room;
    float scratch[2][POINT_COUNT * 4];
} Worker;

/* One material of a document: the oracle's values are made when they are first needed. */
typedef struct {
    Document *document;
    int material;
    Oracle *oracles[NOISES];
    Hull *hulls[NOISES][2][2]; /* by noise, exact derivatives and side */
} Subject;

static Fault *fault_of(Run *run, const char *slot)
{
    for (int i = 0; i < run->fault_count; i++)
        if (!strcmp(run->faults[i].slot, slot))
            return &run->faults[i];
    if (run->fault_count == FAULTS)
        return NULL;
    Fault *fault = &run->faults[run->fault_count++];
    snprintf(fault->slot, sizeof fault->slot, "%s", slot);
    return fault;
}

__attribute__((format(printf, 4, 5))) static void add_fault(Run *run, const char *slot, double miss, const char *format,
                                                            ...)
{
    va_list args;
    pthread_mutex_lock(&run->lock);
    Fault *fault = fault_of(run, slot);
    if (fault && (miss > fault->miss || !fault->count)) {
        va_start(args, format);
        vsnprintf(fault->worst, sizeof fault->worst, format, args);
        va_end(args);
        fault->miss = miss;
    }
    if (fault)
        fault->count++;
    pthread_mutex_unlock(&run->lock);
}

/* Of the material seen from behind, when nothing but the normal turns. */
static void turn_hulls(const Hull *front, Hull *back)
{
    memcpy(back, front, POINT_COUNT * sizeof *back);
    for (int i = 0; i < POINT_COUNT; i++)
        for (int lane = 0; lane < 3; lane++) {
            back[i].value.lane[SLOT_normal][lane] = -front[i].value.lane[SLOT_normal][lane];
            back[i].low.lane[SLOT_normal][lane] = -front[i].high.lane[SLOT_normal][lane];
            back[i].high.lane[SLOT_normal][lane] = -front[i].low.lane[SLOT_normal][lane];
        }
}

static const Hull *hulls_of(Worker *w, Subject *s, ReferenceNoise noise, bool exact, bool front)
{
    Hull **hulls = &s->hulls[noise][exact][front];
    if (*hulls)
        return *hulls;
    if (!s->oracles[noise])
        s->oracles[noise] = oracle_open(s->document->graph, &(ReferenceContext){.noise = noise});
    *hulls = calloc(POINT_COUNT, sizeof **hulls);
    if (!*hulls)
        abort();
    Subjects subjects;
    subjects_of(s->document->graph->materials[s->material].node, SLOT_normal, &subjects);
    if (!front && !subjects.has[KIND_SideSwitch]) {
        turn_hulls(hulls_of(w, s, noise, exact, true), *hulls);
        return *hulls;
    }
    oracle_exact_derivatives(s->oracles[noise], exact);
    const bool steep = noise == REFERENCE_SIMPLEX || noise == REFERENCE_SIMPLEX_FLOAT;
    const PointSet points = {w->run->points, POINT_COUNT, front, steep ? &reach_steep : &reach_float};
    points_hulls(s->oracles[noise], s->document->graph->materials[s->material].node, &points, *hulls);
    return *hulls;
}

static void forget(Subject *s)
{
    for (int noise = 0; noise < NOISES; noise++) {
        oracle_close(s->oracles[noise]);
        for (int i = 0; i < 4; i++)
            free(s->hulls[noise][i / 2][i % 2]);
    }
}

static const char *input_names = "u v  x y z  px py pz";

static void describe_point(const Point *p, char *text, size_t room)
{
    const float(*i)[3] = p->input;
    snprintf(text, room, "%.9g %.9g  %.9g %.9g %.9g  %.9g %.9g %.9g", i[INPUT_U][0], i[INPUT_U][1], i[INPUT_X][0],
             i[INPUT_X][1], i[INPUT_X][2], i[INPUT_P][0], i[INPUT_P][1], i[INPUT_P][2]);
}

/* One slot of one material by one variant. */
typedef struct {
    Subject *subject;
    Slot slot;
    const Variant *variant;
    const Subjects *subjects;
    int governing; /* of the subjects */
    double bound;
    bool changed; /* the uniforms are not their defaults */
} Case;

static void name_slot(const Case *c, char *text, size_t room)
{
    snprintf(text, room, "%s %s %s%s", document_name(c->subject->document),
             matc_material_name(c->subject->document->document, c->subject->material), slot_table[c->slot].name,
             c->changed ? " with other uniforms" : "");
}

static const char *variant_name(const Variant *v, bool front, char text[64])
{
    snprintf(text, 64, "%s -O%d %s%s%s", target_table[v->target].name, v->optimize, choice_table[v->choice].name,
             v->buffered ? " buffered" : "", front ? "" : " back");
    return text;
}

/* What a draw gave. */
typedef struct {
    const char *name;
    double worst;
    int values, sharp;
} Seen;

/* Keeps the worst of a draw, for the subject whose bound counts or, where none stands out, for all that take part. */
static void record(Run *run, const Case *c, const Seen *seen)
{
    pthread_mutex_lock(&run->lock);
    run->values += seen->values;
    run->sharp += seen->sharp;
    for (int i = 0; i < SUBJECT_COUNT; i++) {
        Worst *w = &run->worst[i];
        bool counts = i == c->governing || (c->governing == SUBJECT_DEFAULT && !bound_table[i].bound);
        if (!c->subjects->has[i] || !counts || (w->seen && seen->worst <= w->miss))
            continue;
        w->seen = true;
        w->miss = seen->worst;
        snprintf(w->where, sizeof w->where, "%s", seen->name);
    }
    pthread_mutex_unlock(&run->lock);
}

/* So far out that differences of the oracle's doubles are no measure of a derivative, or the bounded sine's bound is no more. */
static const float far_for_slopes = 1000, far_for_sines = 1e5f;
/* Where half a texel is lost beside the coordinate: the sampler's own are floats, too. */
static const float far_for_samplers = 100;
static bool point_is_far(const Point *point, float far)
{
    float greatest = 0;
    for (int i = 0; i < 3; i++) {
        greatest = fmaxf(greatest, fabsf(point->input[INPUT_X][i]));
        greatest = fmaxf(greatest, fmaxf(fabsf(point->input[INPUT_P][i]), fabsf(point->input[INPUT_U][i])));
    }
    return greatest > far;
}

/* Simplex noise is 0 at lattice points, where checkers have their edges: what it moves from there stays within a rounding. */
static bool point_on_edges(const Point *point)
{
    const float near = 1e-5f, *u = point->input[INPUT_U];
    return fabsf(4 * u[0] - rintf(4 * u[0])) < near && fabsf(4 * u[1] - rintf(4 * u[1])) < near;
}

static bool is_sharp(const Hull *hull, const Case *c, int lane)
{
    double width = hull->high.lane[c->slot][lane] - hull->low.lane[c->slot][lane];
    return 3 * width / fmax(1, fabs(hull->value.lane[c->slot][lane])) + c->bound < SHARP;
}

/* Pictures come through the driver's sampler, whose weights and results have eight bits: two codes, and as much more as a Blend along
 * them is steep, or an exponent: -2 / ln(s (2 - s)) grows by a tenth from s = 0.80 to 0.81. Slopes of them, which a BumpMap takes, are test_filtered_picture's. */
static const double sampler_bound = 2. / 255, sampler_blend_bound = 10. / 255;

static bool is_sampled(const Variant *variant, const Subjects *subjects)
{
    return variant->choice == CHOICE_aa_auto && subjects->has[KIND_ImageMap];
}

static double bound_of(const Variant *variant, const Subjects *subjects, int governing)
{
    const double bound = bound_table[governing].bound;
    const bool steep = subjects->has[KIND_Blend] || subjects->has[SUBJECT_SLOTS + (int)SLOT_shininess];
    return !is_sampled(variant, subjects) ? bound : fmax(bound, steep ? sampler_blend_bound : sampler_bound);
}

/* The worst lane of all points against the oracle; one fault a draw. */
static void compare(Worker *w, const Case *c, bool front, const float *rgba)
{
    Choice choice = c->variant->choice;
    Choice basis = choice_table[choice].axis == AXIS_noise ? choice : CHOICE_noise_lattice;
    ReferenceNoise noise = job_noise(basis, c->variant->target);
    bool exact = choice == CHOICE_derivatives_analytic, steep = choice == CHOICE_noise_simplex;
    bool sampled = is_sampled(c->variant, c->subjects), bumped = c->subjects->has[KIND_BumpMap];
    const Hull *hulls = hulls_of(w, c->subject, noise, exact, front);
    int lanes = type_table[slot_table[c->slot].type].lanes, point = 0, lane = 0, bad = 0, sharp = 0;
    double worst = 0;
    for (int i = 0; i < POINT_COUNT; i++)
        for (int k = 0; k < lanes; k++) {
            double miss = hull_miss(&hulls[i], c->slot, k, rgba[4 * i + k]);
            bool far = point_is_extreme(&w->run->points[i]) ||
                       (exact && point_is_far(&w->run->points[i], far_for_slopes)) ||
                       (choice == CHOICE_trigonometry_bounded && point_is_far(&w->run->points[i], far_for_sines)) ||
                       (sampled && (bumped || point_is_far(&w->run->points[i], far_for_samplers))) ||
                       (steep && point_on_edges(&w->run->points[i]));
            if (far && isfinite(rgba[4 * i + k]))
                continue;
            sharp += is_sharp(&hulls[i], c, k);
            bad += miss > c->bound;
            if (miss > worst) {
                worst = miss;
                point = i;
                lane = k;
            }
        }
    char name[160], variant[64];
    name_slot(c, name, sizeof name);
    record(w->run, c, &(Seen){name, worst, POINT_COUNT * lanes, sharp});
    if (!bad)
        return;
    char at[200];
    describe_point(&w->run->points[point], at, sizeof at);
    add_fault(w->run, name, worst,
              "%s: %d values; worst %.2g, bound %.2g (%s): drawn %.9g, oracle %.9g in [%.9g, %.9g] at point %d: %s",
              variant_name(c->variant, front, variant), bad, worst, c->bound, subject_name(c->governing),
              rgba[4 * point + lane], hulls[point].value.lane[c->slot][lane], hulls[point].low.lane[c->slot][lane],
              hulls[point].high.lane[c->slot][lane], point, at);
}

/* Of the text behind its comments, which name the slot and the choices. */
static uint64_t hash_text(const char *text, Target target)
{
    uint64_t hash = 14695981039346656037u + (uint64_t)target;
    const char *comment = strstr(text, "// matc");
    while (comment && !strncmp(comment, "//", 2))
        comment = strchr(comment, '\n') + 1;
    for (const char *at = comment ? comment : text; *at; at++)
        hash = (hash ^ (unsigned char)*at) * 1099511628211u;
    return hash;
}

static Drawn *remember(Worker *w, uint64_t hash)
{
    for (int i = 0; i < w->memo_count; i++)
        if (w->memo[i].hash == hash)
            return &w->memo[i];
    if (w->memo_count == w->memo_room) {
        w->memo_room = w->memo_room ? 2 * w->memo_room : 256;
        w->memo = realloc(w->memo, (size_t)w->memo_room * sizeof *w->memo);
        if (!w->memo)
            abort();
    }
    w->memo[w->memo_count] = (Drawn){.hash = hash};
    return &w->memo[w->memo_count++];
}

static bool draw_sides(Worker *w, const Shading *shading, float *const rgba[2])
{
    Drawer *drawer = target_table[shading->target].in_out ? &w->core : &w->compat;
    Material material;
    bool drawn = drawer_material(drawer, shading, &material);
    for (int front = strstr(shading->fragment, "gl_FrontFacing") ? 0 : 1; front < 2 && drawn; front++)
        drawn = drawer_draw(drawer, &material, front, &rgba[front], 1);
    material_delete(&material);
    pthread_mutex_lock(&w->run->lock);
    w->run->drawn++;
    pthread_mutex_unlock(&w->run->lock);
    return drawn;
}

static void check_program(Worker *w, const Case *c, MatcProgram *program)
{
    Shading shading = {.fragment = matc_output(program, MATC_FRAGMENT, NULL),
                       .target = c->variant->target,
                       .program = program,
                       .graph = c->subject->document->graph};
    float *rgba[2] = {w->scratch[0], w->scratch[1]};
    bool plain = !matc_texture_count(program) && !matc_uniform_count(program) && !matc_constant_count(program),
         drawn = false;
    if (plain) {
        Drawn *memo = remember(w, hash_text(shading.fragment, shading.target));
        drawn = memo->rgba[1] != NULL;
        for (int side = 0; side < 2 && !drawn; side++)
            memo->rgba[side] = malloc(sizeof w->scratch[0]);
        memcpy(rgba, memo->rgba, sizeof rgba);
    }
    if (!drawn && !draw_sides(w, &shading, rgba)) {
        Drawer *drawer = target_table[shading.target].in_out ? &w->core : &w->compat;
        char name[160], variant[64];
        name_slot(c, name, sizeof name);
        add_fault(w->run, name, 1e9, "%s: %s", variant_name(c->variant, true, variant), drawer->error);
        return;
    }
    compare(w, c, true, rgba[1]);
    if (strstr(shading.fragment, "gl_FrontFacing"))
        compare(w, c, false, rgba[0]);
}

static void check_variant(Worker *w, const Case *c)
{
    MatcOptions options = c->subject->document->options;
    options.pass = "value";
    options.slot = slot_table[c->slot].name;
    options.target = target_table[c->variant->target].name;
    const ChoiceRow *choice = &choice_table[c->variant->choice];
    options.aa = "none";
    matc_options_set(&options, axis_table[choice->axis].name, choice->name);
    options.optimize = c->variant->optimize;
    options.constants = c->variant->buffered ? "uniform" : "baked";
    options.validate = false;
    MatcProgram *program = matc_compile(c->subject->document->document, c->subject->material, MATC_FRAGMENT, &options);
    char name[160], variant[64];
    name_slot(c, name, sizeof name);
    if (matc_ok(program))
        check_program(w, c, program);
    else
        add_fault(w->run, name, 1e9, "%s: %s", variant_name(c->variant, true, variant),
                  matc_program_diagnostics(program, MATC_TEXT));
    matc_program_free(program);
    pthread_mutex_lock(&w->run->lock);
    w->run->programs++;
    pthread_mutex_unlock(&w->run->lock);
}

/* Whether a choice can change what the subjects make. */
static bool matters(Choice choice, const Subjects *subjects)
{
    if (choice == CHOICE_aa_auto) /* means are aa=box's */
        return subjects->has[KIND_ImageMap] || subjects->has[KIND_Checker] || subjects->has[KIND_Gradient];
    if (axis_table[choice_table[choice].axis].first == (int)choice)
        return true;
    if (choice_table[choice].axis == AXIS_noise)
        return subjects_noise(subjects);
    return choice_table[choice].axis != AXIS_derivatives || subjects->has[KIND_BumpMap];
}

/* Of pictures of 16 bits a target without such textures keeps 11 bits, which drivers may cut off: 2^-11 of the value. */
static double half_bound(const Document *document, Target target)
{
    for (int i = 0; i < document->graph->image_count && !target_table[target].word_textures; i++)
        if (document->graph->images[i]->bits == 16)
            return 0x1p-11;
    return 0;
}

static void check_material(Worker *w, Document *document, int material, bool changed)
{
    Subject subject = {.document = document, .material = material};
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        Subjects subjects;
        subjects_of(document->graph->materials[material].node, (Slot)slot, &subjects);
        for (int i = 0; i < VARIANTS; i++) {
            int governing = subject_governing(&subjects, variants[i].choice);
            if (matters(variants[i].choice, &subjects))
                check_variant(w, &(Case){&subject, (Slot)slot, &variants[i], &subjects, governing,
                                         fmax(half_bound(document, variants[i].target),
                                              bound_of(&variants[i], &subjects, governing)),
                                         changed});
        }
    }
    forget(&subject);
}

/* Other values than the defaults, which programs and oracle must take from the uniforms alone. Counts stay whole. */
static void change_uniforms(Document *document)
{
    for (int i = 0; i < document->graph->uniform_count; i++) {
        const Uniform *u = document->graph->uniforms[i];
        double value[4];
        for (int lane = 0; lane < 4; lane++)
            value[lane] = u->initial[lane] > 2 && u->initial[lane] == floor(u->initial[lane])
                              ? u->initial[lane] + 1
                              : (float)(u->initial[lane] * 0.625 + 0.0625 * (lane + 1));
        document_set_uniform(document, i, value);
    }
}

static void check_document(Worker *w, const char *path)
{
    Document document;
    bool good = document_open(&document, path);
    if (!good && document_is_library(&document)) {
        document_close(&document);
        return;
    }
    if (!good) {
        add_fault(w->run, path, 1e9, "%s", document_fault(&document));
        document_close(&document);
        return;
    }
    for (int i = 0; i < document.graph->material_count; i++)
        check_material(w, &document, i, false);
    if (document.graph->uniform_count) {
        change_uniforms(&document);
        for (int i = 0; i < document.graph->material_count; i++)
            check_material(w, &document, i, true);
    }
    document_close(&document);
}

static void *work(void *user)
{
    Run *run = user;
    Worker *w = calloc(1, sizeof *w);
    if (!w)
        abort();
    w->run = run;
    if (!drawer_open(&w->core, true, run->points, POINT_COUNT) ||
        !drawer_open(&w->compat, false, run->points, POINT_COUNT)) {
        add_fault(run, "no context", 1e9, "%s%s", w->core.error, w->compat.error);
        free(w);
        return NULL;
    }
    for (int i; (i = atomic_fetch_add(&run->next, 1)) < run->documents.count;) {
        const char *only = getenv("VALUE_ONLY");
        if (!only || strstr(run->documents.paths[i], only))
            check_document(w, run->documents.paths[i]);
    }
    drawer_close(&w->core);
    drawer_close(&w->compat);
    for (int i = 0; i < w->memo_count; i++)
        for (int side = 0; side < 2; side++)
            free(w->memo[i].rgba[side]);
    free(w->memo);
    free(w);
    return NULL;
}

static void print_table(const Run *run)
{
    print_message("%d programs, %d drawn, %ld values, %.1f %% of them judged within %g\n", run->programs, run->drawn,
                  run->values, 100. * (double)run->sharp / (double)run->values, SHARP);
    print_message("%-24s %9s %9s  worst at\n", "subject", "bound", "worst");
    for (int i = 0; i < SUBJECT_COUNT; i++)
        if (run->worst[i].seen && bound_table[i].bound > 0)
            print_message("%-24s %9.2g %9.2g  %s\n", subject_name(i), bound_table[i].bound, run->worst[i].miss,
                          run->worst[i].where);
        else if (run->worst[i].seen)
            print_message("%-24s %9s %9.2g  %s\n", subject_name(i), "", run->worst[i].miss, run->worst[i].where);
}

enum { WORKERS_MOST = 8 };

static void examples_draw_what_they_mean(void **state)
{
    (void)state;
    static Run run;
    static Point points[POINT_COUNT];
    pthread_t workers[WORKERS_MOST];
    long count = sysconf(_SC_NPROCESSORS_ONLN);
    count = count < 1 ? 1 : count > WORKERS_MOST ? WORKERS_MOST : count;
    points_make(points);
    run.documents = documents_list(SOURCE_FOLDER);
    run.points = points;
    pthread_mutex_init(&run.lock, NULL);
    assert_true(run.documents.count > 100);
    for (long i = 0; i < count; i++)
        assert_int_equal(pthread_create(&workers[i], NULL, work, &run), 0);
    for (long i = 0; i < count; i++)
        pthread_join(workers[i], NULL);
    documents_free(&run.documents);
    print_table(&run);
    assert_true(run.fault_count || getenv("VALUE_ONLY") || run.sharp > 0.85 * (double)run.values);
    for (int i = 0; i < run.fault_count; i++)
        print_error("%s (%d): %s\n", run.faults[i].slot, run.faults[i].count, run.faults[i].worst);
    if (run.fault_count)
        fail_msg("%d slots are wrong; points are given as %s", run.fault_count, input_names);
}

/* A fragment program that shows one input, and the side in its fourth lane. */
static void show_input(char *text, size_t room, bool core, Input input)
{
    const char *type = type_table[input_table[input].type].name, *name = input_table[input].glsl;
    snprintf(text, room, "#version %s\n%s %s %s;\n%svoid main() { %s = vec4(%s%s, gl_FrontFacing ? 1.0 : 0.0); }",
             core ? "330 core" : "110", core ? "in" : "varying", type, name, core ? "out vec4 c;\n" : "",
             core ? "c" : "gl_FragData[0]", name, input == INPUT_U ? ", 0.0" : "");
}

static void compare_input(const Point *points, Input input, bool front, const float *rgba)
{
    for (int i = 0; i < POINT_COUNT; i++) {
        assert_true(rgba[4 * i + 3] == front);
        for (int lane = 0; lane < type_table[input_table[input].type].lanes; lane++) {
            float want = points[i].input[input][lane], got = rgba[4 * i + lane];
            bool flushed = got == 0 && fabsf(want) < WAVE_LEAST;
            if (got != want && !flushed)
                fail_msg("%s, point %d: %.9g instead of %.9g", input_table[input].glsl, i, got, want);
        }
    }
}

/* What all else rests on: a fragment program gets the very floats of a point, on either side and in either context. */
static void inputs_arrive_exactly(void **state)
{
    (void)state;
    static Point points[POINT_COUNT];
    static float texels[POINT_COUNT * 4];
    float *rgba = texels;
    points_make(points);
    for (int core = 0; core < 2; core++) {
        Drawer drawer;
        assert_true(drawer_open(&drawer, core, points, POINT_COUNT));
        for (int input = 0; input < POINT_VARYINGS; input++) {
            char text[512];
            show_input(text, sizeof text, core, (Input)input);
            Shading shading = {.fragment = text, .target = core ? TARGET_glsl330 : TARGET_glsl110};
            Material material;
            if (!drawer_material(&drawer, &shading, &material))
                fail_msg("%s", drawer.error);
            for (int front = 0; front < 2; front++) {
                if (!drawer_draw(&drawer, &material, front, &rgba, 1))
                    fail_msg("%s", drawer.error);
                compare_input(points, (Input)input, front, rgba);
            }
            material_delete(&material);
        }
        drawer_close(&drawer);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(inputs_arrive_exactly),
        cmocka_unit_test(examples_draw_what_they_mean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
