/* Threads that take one tree after another; a fault is shrunk and reported at once. */
#include "compiler/layout/layout.h"
#include "stress.h"
#include "generate.h"
#include "shrink.h"
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#ifdef __GLIBC__
#include <malloc.h>
#endif

enum { THREADS_MAX = 64, SHRINK_TRIES = 3000, SHRINK_TRIES_DRAWN = 300, SHRINK_SECONDS = 20 };

typedef struct {
    const StressOptions *options;
    Point field[FIELD_COUNT];
    atomic_long next, done;
    atomic_int faults;
    pthread_mutex_t lock; /* protects the output and the total */
    TrialCount *total;
    double start;
} Run;

typedef struct {
    Run *run;
    Drawer core, compat, core_half, compat_half;
    bool can_draw;
    TrialCount count;
} Worker;

void stress_options_init(StressOptions *o)
{
    *o = (StressOptions){.generate = generate_document,
                         .seed = 1,
                         .count = 1000,
                         .validate_every = 100,
                         .draw_every = 500,
                         .points = 6,
                         .faults = 1,
                         .threads = 2,
                         .out = stderr};
    matc_options_init(&o->options);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

static bool open_drawers(Worker *w)
{
    const Point *field = w->run->field;
    const int targets = layout_targets(&layout_table[LAYOUT_thesis]);
    w->can_draw = drawer_open(&w->core, true, field, FIELD_COUNT) &&
                  drawer_open(&w->compat, false, field, FIELD_COUNT) &&
                  drawer_open_half(&w->core_half, true, field, FIELD_COUNT, targets) &&
                  drawer_open_half(&w->compat_half, false, field, FIELD_COUNT, targets);
    return w->can_draw;
}

static void close_drawers(Worker *w)
{
    drawer_close(&w->core);
    drawer_close(&w->compat);
    drawer_close(&w->core_half);
    drawer_close(&w->compat_half);
}

/* Sets up the drawing of a trial. */
static void plan_drawing(TrialPlan *plan, Worker *w)
{
    plan->core = &w->core;
    plan->compat = &w->compat;
    plan->core_half = &w->core_half;
    plan->compat_half = &w->compat_half;
}

static TrialPlan plan_of(Worker *w, long index)
{
    const StressOptions *o = w->run->options;
    TrialPlan plan = {.options = o->options,
                      .field = w->run->field,
                      .first = (int)(index * 7919 % FIELD_COUNT),
                      .count = o->points,
                      .pixel = pixel_number(index),
                      .greatest = GREATEST_VALUE,
                      .validate = o->validate_every && index % o->validate_every == 0};
    plan.oracle = o->options.aa && !strcmp(o->options.aa, "none");
    if (w->can_draw && o->draw_every && index % o->draw_every == 0)
        plan_drawing(&plan, w);
    return plan;
}

/* State for the test whether a script's document has the same kind of fault. */
typedef struct {
    TrialPlan plan;
    void (*generate)(Choices *choices, Text *text);
    FaultKind kind;
    double end;
} Search;

static bool has_fault(void *user, const uint32_t *script, int count)
{
    Search *s = user;
    Choices choices;
    TrialCount ignored = {0};
    TrialFault fault;
    Arena arena = {0};
    Text text = text_new(&arena);
    if (now() > s->end)
        return false;
    choices_script(&choices, script, count);
    s->generate(&choices, &text);
    trial_run(&s->plan, text.at, text.size, &ignored, &fault);
    arena_free(&arena);
    return fault.kind == s->kind;
}

static void write_document(const Run *run, long index, const char *text)
{
    char path[512];
    if (!run->options->folder)
        return;
    snprintf(path, sizeof path, "%s/stress-%llu-%ld.yaml", run->options->folder,
             (unsigned long long)run->options->seed, index);
    FILE *file = fopen(path, "w");
    if (!file)
        return;
    fputs(text, file);
    fclose(file);
    fprintf(run->options->out, "written to %s\n", path);
}

/* Shrinks and reports a fault. */
static void report(Worker *w, long index, const TrialPlan *plan, const Choices *choices,
                   const TrialFault *fault)
{
    Search search = {*plan, w->run->options->generate, fault->kind, now() + SHRINK_SECONDS};
    bool drawn = fault->kind >= FAULT_not_drawn || fault->kind == FAULT_packed;
    Shrinker shrinker = {has_fault, &search, drawn ? SHRINK_TRIES_DRAWN : SHRINK_TRIES};
    uint32_t script[MAX_CHOICES];
    memcpy(script, choices->made, sizeof script);
    if (!drawn)
        search.plan.core = NULL;
    search.plan.validate = fault->kind == FAULT_not_valid;
    int count = shrink(&shrinker, script, choices->count);
    Choices small;
    TrialCount ignored = {0};
    TrialFault last;
    Arena arena = {0};
    Text text = text_new(&arena);
    choices_script(&small, script, count);
    w->run->options->generate(&small, &text);
    trial_run(&search.plan, text.at, text.size, &ignored, &last);
    pthread_mutex_lock(&w->run->lock);
    fprintf(w->run->options->out,
            "fault: %s; --seed %llu --first %ld --count 1%s\n%s\nshrunk: %s\n%s",
            fault_names[fault->kind], (unsigned long long)w->run->options->seed, index,
            plan->core ? " --draw-every 1" : "", fault->text, last.text, text.at);
    write_document(w->run, index, text.at);
    pthread_mutex_unlock(&w->run->lock);
    arena_free(&arena);
}

static void show_progress(Run *run)
{
    long done = atomic_load(&run->done);
    double seconds = now() - run->start;
    fprintf(stderr, "\r%ld of %ld trees, %.0f a second, %d faults ", done, run->options->count,
            (double)done / fmax(seconds, 1e-3), atomic_load(&run->faults));
}

static void try_tree(Worker *w, long index)
{
    Choices choices;
    TrialFault fault;
    Arena arena = {0};
    Text text = text_new(&arena);
    TrialPlan plan = plan_of(w, index);
    choices_random(&choices, w->run->options->seed, (uint64_t)index);
    w->run->options->generate(&choices, &text);
    if (!trial_run(&plan, text.at, text.size, &w->count, &fault)) {
        atomic_fetch_add(&w->run->faults, 1);
        report(w, index, &plan, &choices, &fault);
    }
    arena_free(&arena);
}

static void *work(void *user)
{
    Run *run = user;
    Worker *w = calloc(1, sizeof *w);
    if (!w)
        abort();
    w->run = run;
    if (run->options->draw_every && !open_drawers(w))
        fprintf(run->options->out, "nothing is drawn: %s%s\n", w->core.error, w->compat.error);
    for (long i; (i = atomic_fetch_add(&run->next, 1)) < run->options->count;) {
        if (atomic_load(&run->faults) >= run->options->faults)
            break;
        try_tree(w, run->options->first + i);
        if (atomic_fetch_add(&run->done, 1) % 64 == 0 && run->options->progress)
            show_progress(run);
    }
    close_drawers(w);
    pthread_mutex_lock(&run->lock);
    for (size_t i = 0; i < sizeof w->count / sizeof(long); i++)
        ((long *)run->total)[i] += ((long *)&w->count)[i];
    pthread_mutex_unlock(&run->lock);
    free(w);
    return NULL;
}

/* Keeps freed memory: arenas are made and freed by the thousand, and requesting each from the
 * system is slow. */
static void keep_memory(void)
{
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 1 << 28);
    mallopt(M_TRIM_THRESHOLD, 1 << 28);
#endif
}

int stress_run(const StressOptions *options, TrialCount *total)
{
    Run *run = calloc(1, sizeof *run);
    pthread_t threads[THREADS_MAX];
    int count = options->threads < 1             ? 1
                : options->threads > THREADS_MAX ? THREADS_MAX
                                                 : options->threads;
    if (!run)
        abort();
    keep_memory();
    run->options = options;
    run->total = total;
    run->start = now();
    hostile_points(run->field);
    pthread_mutex_init(&run->lock, NULL);
    for (int i = 0; i < count; i++)
        if (pthread_create(&threads[i], NULL, work, run))
            abort();
    for (int i = 0; i < count; i++)
        pthread_join(threads[i], NULL);
    if (options->progress)
        show_progress(run), fputc('\n', stderr);
    int faults = atomic_load(&run->faults);
    pthread_mutex_destroy(&run->lock);
    free(run);
    return faults;
}

int stress_document(const StressOptions *options, const char *text, size_t size, TrialCount *total)
{
    Run *run = calloc(1, sizeof *run);
    Worker *w = calloc(1, sizeof *w);
    if (!run || !w)
        abort();
    run->options = options;
    hostile_points(run->field);
    w->run = run;
    int faults = !options->draw_every || open_drawers(w) ? 0 : 1;
    for (long i = 0; !faults && i < options->count; i++) {
        TrialFault fault;
        TrialPlan plan = plan_of(w, options->first + i);
        if (!options->draw_every || i % options->draw_every)
            plan.core = NULL;
        else
            plan_drawing(&plan, w);
        plan.only_finite = true;
        plan.greatest = INFINITY;
        if (trial_run(&plan, text, size, total, &fault))
            continue;
        faults++;
        fprintf(options->out, "fault: %s, pixel %ld: %s\n", fault_names[fault.kind],
                options->first + i, fault.text);
    }
    close_drawers(w);
    free(w);
    free(run);
    return faults;
}
