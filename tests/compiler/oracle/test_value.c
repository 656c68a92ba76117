/* The central proof: the values that emitted programs draw equal the oracle's, for every
 * example, slot, level and target. tests/bounds.def has the tolerances; the table at the end
 * prints the errors. VALUE_ONLY=part-of-a-path in the environment selects documents and prints
 * more about each fault; VALUE_SEED=N takes other points. */
/* ctest: unsanitized unoptimized seconds=140 */
#include "tests/test.h"
#include "tests/draw/draw.h"
#include "tests/value/rounding.h"
#include "tests/draw/sampler.h"
#include "tests/value/verdicts.h"
#include "tests/value/ways.h"
#include "tests/value/workers.h"
#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NOISES = REFERENCE_NOISE_COUNT };
static const double SHARP = 1e-3;

/* State that all workers share. */
typedef struct {
    DocumentList documents;
    const Point *points;
    atomic_int next, programs, drawn;
    Verdicts verdicts; /* sharp: those whose hull and bound are below SHARP */
} Run;

/* Programs that differ in nothing but their slot draw the same: without textures and uniforms, once
 * is enough. */
typedef struct {
    uint64_t hash;
    float *rgba[2];
} Drawn;

typedef struct {
    Run *run;
    Drawer core, compat;
    Drawn *memo;
    int memo_count, memo_capacity;
    float scratch[2][POINT_COUNT * 4]; /* all of the target is read */
} Worker;

/* One material of a document: the oracle's values are made when they are first needed. */
typedef struct {
    Document *document;
    int number, material; /* the document's among all, and in it */
    Oracle *oracles[NOISES];
    Hull *hulls[NOISES][CHOICE_COUNT][2]; /* by noise, derivatives and side */
    Hull *sampled[2];                     /* by side, where the driver samples pictures */
} Subject;

/* Hulls of the material seen from behind, if only normals flip. */
static void turn_hulls(const Hull *front, Hull *back)
{
    static const Slot turned[] = {SLOT_normal, SLOT_coatNormal};
    memcpy(back, front, POINT_COUNT * sizeof *back);
    for (size_t i = 0; i < POINT_COUNT * sizeof turned / sizeof *turned; i++) {
        const size_t at = i / (sizeof turned / sizeof *turned);
        const Slot slot = turned[i % (sizeof turned / sizeof *turned)];
        for (int component = 0; component < 3; component++) {
            back[at].value.component[slot][component] = -front[at].value.component[slot][component];
            back[at].low.component[slot][component] = -front[at].high.component[slot][component];
            back[at].high.component[slot][component] = -front[at].low.component[slot][component];
        }
    }
}

static const Hull *hulls_of(Worker *w, Subject *s, ReferenceNoise noise, Choice derivatives,
                            bool front)
{
    Hull **hulls = &s->hulls[noise][derivatives][front];
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
        turn_hulls(hulls_of(w, s, noise, derivatives, true), *hulls);
        return *hulls;
    }
    oracle_derivatives(s->oracles[noise], derivatives);
    const bool steep = noise == REFERENCE_SIMPLEX || noise == REFERENCE_SIMPLEX_FLOAT;
    const PointSet points = {w->run->points, POINT_COUNT, front,
                             steep ? &reach_steep : &reach_float, false};
    points_hulls(s->oracles[noise], s->document->graph->materials[s->material].node, &points,
                 *hulls);
    return *hulls;
}

static const Hull *sampled_hulls_of(Worker *w, Subject *s, bool front)
{
    const Hull *exact = hulls_of(w, s, REFERENCE_LATTICE, CHOICE_derivatives_auto, front);
    Hull **sampled = &s->sampled[front];
    if (*sampled)
        return *sampled;
    *sampled = malloc(POINT_COUNT * sizeof **sampled);
    if (!*sampled)
        abort();
    memcpy(*sampled, exact, POINT_COUNT * sizeof **sampled);
    const PointSet points = {w->run->points, POINT_COUNT, front, &reach_float, false};
    sampler_widen(s->oracles[REFERENCE_LATTICE], s->document->graph, s->material, &points,
                  *sampled);
    return *sampled;
}

static void forget(Subject *s)
{
    free(s->sampled[0]);
    free(s->sampled[1]);
    for (int noise = 0; noise < NOISES; noise++) {
        oracle_close(s->oracles[noise]);
        for (int i = 0; i < 2 * CHOICE_COUNT; i++)
            free(s->hulls[noise][i / 2][i % 2]);
    }
}

/* One slot of one material, made in one way. */
typedef struct {
    Subject *subject;
    Slot slot;
    const Way *way;
    const Subjects *subjects;
    int governing; /* of the subjects */
    double bound;
    bool changed; /* the uniforms are not their defaults */
} Case;

static void name_slot(const Case *c, char *text, size_t capacity)
{
    snprintf(text, capacity, "%s %s %s%s", document_name(c->subject->document),
             matc_material_name(c->subject->document->document, c->subject->material),
             slot_table[c->slot].name, c->changed ? " with other uniforms" : "");
}

static bool is_sharp(const Hull *hull, const Case *c, int component)
{
    double width =
        hull->high.component[c->slot][component] - hull->low.component[c->slot][component];
    return 3 * width / fmax(1, fabs(hull->value.component[c->slot][component])) + c->bound < SHARP;
}

/* How far a drawn number lies outside of its hull or, of a few numbers of a bump, outside of what
 * rounding makes of its program. */
static double miss_of(const Case *c, const DrawnNumber *drawn, int *excused)
{
    MatcOptions options = c->subject->document->options;
    double miss = hull_miss(drawn->hull, c->slot, drawn->component, drawn->number);
    const bool is_bump =
        c->slot == SLOT_normal && (c->subjects->has[KIND_BumpMap] || c->subjects->displaced);
    if (miss <= c->bound || !isfinite(drawn->number) || !is_bump || *excused == ROUNDING_NUMBERS)
        return miss;
    ++*excused;
    way_options(c->way, c->slot, &options);
    return fmin(
        miss, rounding_miss(c->subject->document, c->subject->material, &options, drawn, c->bound));
}

/* The worst component of all points against the oracle; one fault a draw. */
static void compare(Worker *w, const Case *c, bool front, const float *rgba)
{
    const Hull *hulls =
        way_samples(c->way, c->subjects)
            ? sampled_hulls_of(w, c->subject, front)
            : hulls_of(w, c->subject, way_noise(c->way), way_derivatives(c->way), front);
    int components = type_table[slot_table[c->slot].type].components, point = 0, component = 0,
        bad = 0, sharp = 0, excused = 0;
    double worst = 0;
    for (int i = 0; i < POINT_COUNT; i++) {
        const bool judged = way_judges(c->way, c->subjects, &w->run->points[i]);
        for (int k = 0; k < components; k++) {
            if (!judged && isfinite(rgba[4 * i + k]))
                continue;
            const DrawnNumber drawn = {c->slot, k,         &w->run->points[i],
                                       front,   &hulls[i], rgba[4 * i + k]};
            const double miss = miss_of(c, &drawn, &excused);
            sharp += is_sharp(&hulls[i], c, k);
            bad += miss > c->bound;
            if (miss > worst) {
                worst = miss;
                point = i;
                component = k;
            }
        }
    }
    char name[160], way[64];
    name_slot(c, name, sizeof name);
    verdicts_record(&w->run->verdicts, &(Seen){name, worst, POINT_COUNT * components, sharp,
                                               c->subjects, c->governing});
    if (!bad)
        return;
    char at[200];
    point_describe(&w->run->points[point], at, sizeof at);
    verdicts_fault(&w->run->verdicts, name, worst,
                   "%s: %d values; worst %.2g, bound %.2g (%s): drawn %.9g, oracle %.9g in [%.9g, "
                   "%.9g] at point %d: %s",
                   way_name(c->way, front, way), bad, worst, c->bound, subject_name(c->governing),
                   rgba[4 * point + component], hulls[point].value.component[c->slot][component],
                   hulls[point].low.component[c->slot][component],
                   hulls[point].high.component[c->slot][component], point, at);
}

/* Hash of the text behind its comments, which name the slot and the choices. */
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
    if (w->memo_count == w->memo_capacity) {
        w->memo_capacity = w->memo_capacity ? 2 * w->memo_capacity : 256;
        w->memo = realloc(w->memo, (size_t)w->memo_capacity * sizeof *w->memo);
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
    for (int front = strstr(shading->fragment, "gl_FrontFacing") ? 0 : 1; front < 2 && drawn;
         front++)
        drawn = drawer_draw(drawer, &material, front, &rgba[front], 1);
    material_delete(&material);
    atomic_fetch_add(&w->run->drawn, 1);
    return drawn;
}

static void check_program(Worker *w, const Case *c, MatcProgram *program)
{
    Shading shading = {.fragment = matc_output(program, MATC_FRAGMENT, NULL),
                       .target = c->way->target,
                       .program = program,
                       .graph = c->subject->document->graph};
    float *rgba[2] = {w->scratch[0], w->scratch[1]};
    bool plain = !matc_texture_count(program) && !matc_uniform_count(program) &&
                 !matc_constant_count(program),
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
        char name[160], way[64];
        name_slot(c, name, sizeof name);
        verdicts_fault(&w->run->verdicts, name, 1e9, "%s: %s", way_name(c->way, true, way),
                       drawer->error);
        return;
    }
    compare(w, c, true, rgba[1]);
    if (strstr(shading.fragment, "gl_FrontFacing"))
        compare(w, c, false, rgba[0]);
}

static void check_way(Worker *w, const Case *c)
{
    MatcOptions options = c->subject->document->options;
    way_options(c->way, c->slot, &options);
    MatcProgram *program =
        matc_compile(c->subject->document->document, c->subject->material, MATC_FRAGMENT, &options);
    char name[160], way[64];
    name_slot(c, name, sizeof name);
    if (matc_ok(program))
        check_program(w, c, program);
    else
        verdicts_fault(&w->run->verdicts, name, 1e9, "%s: %s", way_name(c->way, true, way),
                       matc_program_diagnostics(program, MATC_TEXT));
    matc_program_free(program);
    atomic_fetch_add(&w->run->programs, 1);
}

static void check_material(Worker *w, Subject subject, bool changed)
{
    const Document *document = subject.document;
    for (int slot = 0; slot < SLOT_COUNT; slot++) {
        Subjects subjects;
        subjects_of(document->graph->materials[subject.material].node, (Slot)slot, &subjects);
        for (int i = 0; i < way_count; i++) {
            const Way *way = &way_table[i];
            const int governing = subject_governing(&subjects, way->choice);
            const double bound = way_bound(way, document, governing);
            if (way_taken(way, (Slot)slot, subject.number + subject.material) &&
                way_matters(way, &subjects))
                check_way(w,
                          &(Case){&subject, (Slot)slot, way, &subjects, governing, bound, changed});
        }
    }
    forget(&subject);
}

/* Other values than the defaults, which programs and oracle must take from the uniforms alone.
 * Counts stay whole. */
static void change_uniforms(Document *document)
{
    for (int i = 0; i < document->graph->uniform_count; i++) {
        const Uniform *u = document->graph->uniforms[i];
        double value[4];
        for (int component = 0; component < 4; component++)
            value[component] =
                u->initial[component] > 2 && u->initial[component] == floor(u->initial[component])
                    ? u->initial[component] + 1
                    : (float)(u->initial[component] * 0.625 + 0.0625 * (component + 1));
        document_set_uniform(document, i, value);
    }
}

static void check_document(Worker *w, int number)
{
    const char *path = w->run->documents.paths[number];
    Document document;
    bool good = document_open(&document, path);
    if (!good && document_is_library(&document)) {
        document_close(&document);
        return;
    }
    if (!good) {
        verdicts_fault(&w->run->verdicts, path, 1e9, "%s", document_fault(&document));
        document_close(&document);
        return;
    }
    for (int i = 0; i < document.graph->material_count; i++)
        check_material(w, (Subject){.document = &document, .number = number, .material = i}, false);
    if (document.graph->uniform_count) {
        change_uniforms(&document);
        for (int i = 0; i < document.graph->material_count; i++)
            check_material(w, (Subject){.document = &document, .number = number, .material = i},
                           true);
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
        verdicts_fault(&run->verdicts, "no context", 1e9, "%s%s", w->core.error, w->compat.error);
        free(w);
        return NULL;
    }
    for (int i; (i = atomic_fetch_add(&run->next, 1)) < run->documents.count;) {
        const char *only = getenv("VALUE_ONLY");
        if (!only || strstr(run->documents.paths[i], only))
            check_document(w, i);
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

static void examples_draw_what_they_mean(void **state)
{
    (void)state;
    static Run run;
    static Point points[POINT_COUNT];
    const char *seed = getenv("VALUE_SEED");
    points_make_others(points, seed ? atoi(seed) : 0);
    run.documents = documents_tried(SOURCE_FOLDER);
    run.points = points;
    verdicts_open(&run.verdicts);
    assert_true(run.documents.count > 100);
    workers_run(work, &run);
    documents_free(&run.documents);
    const Verdicts *seen = &run.verdicts;
    print_message("%d programs, %d drawn, %ld values, %.1f %% of them judged within %g\n",
                  run.programs, run.drawn, seen->values,
                  100. * (double)seen->sharp / (double)seen->values, SHARP);
    verdicts_print(seen);
    assert_true(seen->fault_count || getenv("VALUE_ONLY") ||
                seen->sharp > 0.85 * (double)seen->values);
    if (seen->fault_count)
        fail_msg("%d slots are wrong; points are given as u v  x y z  px py pz", seen->fault_count);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(examples_draw_what_they_mean),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
