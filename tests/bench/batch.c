/* matbench batch: the rate at which one process compiles many materials, next to glslang's own
 * time for their programs, with and without validation and from a cache; the growth of memory
 * with the number of materials; and what a scene saves (batch_scene.c). */
#include "batch.h"
#include "batch_documents.h"
#include "matbench.h"
#include "compiler/emit/validate.h"
#include <cjson/cJSON.h>
#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

enum { COUNT = 10000, THREADS = 2, RUNS = 5, FEW_RUNS = 2, PARTS = 10 };

/* The texts of a batch's programs. */
typedef struct {
    char *vertex, *fragment;
} Pair;
typedef struct {
    Pair *at;
    int count;
    double bytes;    /* bytes of fragment programs */
    atomic_int next; /* next pair to link */
    atomic_bool failed;
} Pairs;

/* Text of a program, by a key of the manifest; NULL after a message on standard error. */
static char *program_text(const BatchFolder *folder, const cJSON *program, const char *key)
{
    const cJSON *name = cJSON_GetObjectItem(program, key);
    char *text = name ? batch_read(folder, "out", name->valuestring) : NULL;
    if (!text)
        fprintf(stderr, "matbench: a program without %s\n", key);
    return text;
}

static bool read_pairs(const BatchFolder *folder, Pairs *pairs)
{
    char *text = batch_read(folder, "out", "manifest.json");
    cJSON *manifest = text ? cJSON_Parse(text) : NULL;
    const cJSON *programs = cJSON_GetObjectItem(manifest, "programs"), *program;
    bool fine = manifest != NULL;
    pairs->at = calloc((size_t)cJSON_GetArraySize(programs) + 1, sizeof *pairs->at);
    if (!pairs->at)
        abort();
    cJSON_ArrayForEach(program, programs)
    {
        Pair *pair = &pairs->at[pairs->count++];
        *pair = (Pair){program_text(folder, program, "vertex"),
                       program_text(folder, program, "fragment")};
        pairs->bytes += pair->fragment ? (double)strlen(pair->fragment) : 0;
        fine = fine && pair->vertex && pair->fragment;
    }
    cJSON_Delete(manifest);
    free(text);
    return fine;
}

static void free_pairs(Pairs *pairs)
{
    for (int i = 0; i < pairs->count; i++) {
        free(pairs->at[i].vertex);
        free(pairs->at[i].fragment);
    }
    free(pairs->at);
}

static bool link_pair(const Pair *pair)
{
    Arena arena = {0};
    MatcOptions options;
    const char *log = "";
    matc_options_init(&options);
    Session session = {.options = &options, .arena = &arena};
    bool fine =
        validate(&session, TARGET_glsl330, &(ProgramTexts){pair->vertex, pair->fragment, 0}, &log);
    if (!fine)
        fprintf(stderr, "matbench: %s\n", log);
    arena_free(&arena);
    return fine;
}

static void *link_rest(void *user)
{
    Pairs *pairs = user;
    for (int i = pairs->next++; i < pairs->count && !pairs->failed; i = pairs->next++)
        if (!link_pair(&pairs->at[i]))
            pairs->failed = true;
    return NULL;
}

static double cpu_now(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return (double)(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           (double)(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec) * 1e-6;
}

/* Time for glslang alone to parse and link all pairs, with `threads` threads. */
static BatchTimes link_all(Pairs *pairs, int threads)
{
    pthread_t others[THREADS];
    link_pair(&pairs->at[0]); /* the first call initializes glslang's tables */
    pairs->next = 0;
    double start = bench_now(), cpu = cpu_now();
    for (int i = 1; i < threads; i++)
        if (pthread_create(&others[i], NULL, link_rest, pairs))
            pairs->failed = true;
    link_rest(pairs);
    for (int i = 1; i < threads && !pairs->failed; i++)
        pthread_join(others[i], NULL);
    return (BatchTimes){bench_now() - start, cpu_now() - cpu, 0};
}

static void put_times(const char *what, int count, const BatchTimes *times)
{
    bool timed = !isnan(times->seconds);
    printf("%-38s %8s %10s", what, NUMBER(2, times->seconds), NUMBER(0, count / times->seconds));
    if (times->cpu > 0 || !timed)
        printf(" %10s", NUMBER(1, times->cpu / count * 1e6));
    if (times->memory)
        printf(" %9s", NUMBER(1, timed ? (double)times->memory / 1024 : NAN));
    putchar('\n');
    fflush(stdout);
}

typedef struct {
    const char *what;
    const char *clear[2]; /* folders to remove first; NULL: none */
    const char *arguments[8];
} Run;

static const Run runs[] = {
    {"validated", {"out"}, {"-j", "2", "--emit=glsl,vertex"}},
    {"not validated", {"out"}, {"-j", "2", "--no-validate"}},
    {"not validated, one thread", {"out"}, {"-j", "1", "--no-validate"}},
    {"  the same again: nothing to write", {NULL}, {"-j", "2", "--no-validate"}},
    {"into an empty cache", {"out", "cache"}, {"-j", "2", "--no-validate", "--cache"}},
    {"from the cache", {"out"}, {"-j", "2", "--no-validate", "--cache"}},
    {"  the same again: nothing to write", {NULL}, {"-j", "2", "--no-validate", "--cache"}},
};

static const Run scene_run = {
    "not validated", {"out"}, {"-j", "2", "--no-validate", "--constants=baked"}};

static void write_scene(int index, Text *out)
{
    const char *family;
    batch_scene(index, out, &family);
}

static bool run_list(const BatchFolder *folder, const char *list, const Run *row, BatchTimes *times)
{
    char cache[BATCH_PATH];
    const char *arguments[sizeof row->arguments / sizeof *row->arguments + 1] = {NULL};
    snprintf(cache, sizeof cache, "--cache=%s/cache", folder->path);
    for (int i = 0; row->arguments[i]; i++)
        arguments[i] = strcmp(row->arguments[i], "--cache") ? row->arguments[i] : cache;
    for (int i = 0; i < 2 && row->clear[i]; i++)
        batch_clear(folder, row->clear[i]);
    return batch_run(folder, list, "out", arguments, times);
}

static const BatchTimes untimed = {NAN, NAN, 1}, untimed_alone = {NAN, NAN, 0};

/* Minimum of several runs, because other processes only make a run longer. Each run begins in
 * the same state. Untimed: runs only the first row, without validation. */
static bool run(const BatchFolder *folder, const Run *row, bool timed, BatchTimes *times)
{
    static const Run programs = {"", {"out"}, {"-j", "2", "--emit=glsl,vertex", "--no-validate"}};
    const int most = row == &runs[0] ? FEW_RUNS : RUNS;
    BatchTimes once;
    if (!timed) {
        *times = untimed;
        return row != &runs[0] || run_list(folder, "m", &programs, &once);
    }
    bench_show(row->what);
    for (int i = 0; i < most; i++) {
        if (!run_list(folder, "m", row, &once))
            return false;
        if (!i || once.seconds < times->seconds)
            *times = once;
    }
    bench_show("");
    return true;
}

/* The first run validates, and glslang alone is measured next to it. */
static bool measure_validated(const BatchFolder *folder, int count, bool timed)
{
    BatchTimes times;
    Pairs pairs = {0};
    bool fine = run(folder, &runs[0], timed, &times) && read_pairs(folder, &pairs);
    BatchTimes one = untimed_alone, several = untimed_alone;
    if (fine && timed) {
        bench_show("glslang alone");
        one = link_all(&pairs, 1);
        several = link_all(&pairs, THREADS);
        bench_show("");
    }
    fine = fine && !pairs.failed;
    if (fine) {
        printf("%d different materials of %.0f bytes, %d programs of %.0f bytes, %d threads\n\n",
               count, (double)folder->bytes / count, pairs.count, pairs.bytes / pairs.count,
               THREADS);
        printf("%-38s %8s %10s %10s %9s\n", "", "seconds", "materials", "CPU us", "peak MiB");
        printf("%-38s %8s %10s %10s\n", "", "", "a second", "each");
        put_times(runs[0].what, count, &times);
        put_times("glslang alone, one thread", count, &one);
        put_times("glslang alone, two threads", count, &several);
        printf("  validated / (glslang by one thread / %d) %s; CPU time / glslang's by one thread "
               "%s, by %d %s\n",
               THREADS, NUMBER(3, times.seconds / (one.seconds / THREADS)),
               NUMBER(3, times.cpu / one.cpu), THREADS, NUMBER(3, times.cpu / several.cpu));
    }
    free_pairs(&pairs);
    return fine;
}

/* Compiles parts of a set as separate batches, then the whole set in both orders, with one
 * cache: measures the cache's size and speed. */
static bool measure_cache(BatchFolder *folder, int count)
{
    static const Run shared = {"from the cache of all these",
                               {"out"},
                               {"-j", "2", "--no-validate", "--constants=uniform", "--cache"}};
    BatchTimes times;
    char name[32];
    batch_clear(folder, "cache");
    for (int part = 0; part < PARTS; part++) {
        snprintf(name, sizeof name, "part%d", part);
        if (!batch_folder_list(folder, name, part * count / PARTS, (part + 1) * count / PARTS,
                               false) ||
            !run_list(folder, name, &shared, &times))
            return false;
    }
    if (!batch_folder_list(folder, "back", 0, count, true) ||
        !run_list(folder, "m", &shared, &times) || !run_list(folder, "back", &shared, &times) ||
        !run(folder, &shared, true, &times))
        return false;
    char *manifest = batch_read(folder, "out", "manifest.json");
    cJSON *json = manifest ? cJSON_Parse(manifest) : NULL;
    BatchCache cache = batch_cache(folder);
    printf("\nmaterials of a scene, their numbers in buffers: a cache that %d parts of the set, "
           "the set and the set in "
           "the other order share\n",
           PARTS);
    printf("%d documents, %d programs: %ld entries of %.1f MiB\n", count,
           cJSON_GetArraySize(cJSON_GetObjectItem(json, "programs")), cache.entries,
           (double)cache.bytes / (1 << 20));
    put_times(shared.what, count, &times);
    cJSON_Delete(json);
    free(manifest);
    return true;
}

static bool measure_speed(BatchFolder *folder, int count, bool timed)
{
    BatchTimes times;
    if (!batch_folder_fill(folder, "m", count, batch_different) ||
        !measure_validated(folder, count, timed))
        return false;
    for (size_t i = 1; i < sizeof runs / sizeof *runs; i++) {
        if (!run(folder, &runs[i], timed, &times))
            return false;
        put_times(runs[i].what, count, &times);
    }
    if (!batch_folder_fill(folder, "m", count, write_scene) ||
        !run(folder, &scene_run, timed, &times))
        return false;
    printf("\nmaterials of a scene, of %.0f bytes, every number in its program\n",
           (double)folder->bytes / count);
    put_times(scene_run.what, count, &times);
    return !timed || measure_cache(folder, count);
}

static bool measure_memory(BatchFolder *folder, int count, bool timed)
{
    BatchTimes times;
    printf("\nmemory, not validated\n");
    for (int n = count / 10 ? count / 10 : 1; n <= 4 * count; n = n < count ? count : 4 * n) {
        char what[64];
        if (timed && !batch_folder_fill(folder, "m", n, batch_different))
            return false;
        if (!run(folder, &runs[1], timed, &times))
            return false;
        snprintf(what, sizeof what, "%d materials", n);
        put_times(what, n, &times);
    }
    return true;
}

const Option bench_batch_options[] = {
    BENCH_UNTIMED,
    BENCH_INT("--count", count, " N", 1, DIFFERENT_DOCUMENTS / 4, "a number of materials",
              "materials of the smallest batch"),
    BENCH_TEXT("--matc", matc, " PROGRAM", "the compiler that is measured"),
    BENCH_FLAG("--speed", speed, "only how fast batches are compiled"),
    BENCH_FLAG("--scene", scene, "only what the materials of a scene share"),
    BENCH_FLAG("--cache", cache, "only what a cache saves"),
    BENCH_GL,
    BENCH_HELP,
};

int bench_batch(const BenchOptions *options)
{
    BatchFolder folder;
    const int count = options->count ? options->count : COUNT;
    const bool timed = options->timed, cache = options->cache;
    const bool speed = !cache && (options->speed || !options->scene);
    const bool scene = !cache && (options->scene || !options->speed);
    if (!batch_folder_make(&folder, options->matc ? options->matc : MATC_PROGRAM)) {
        perror(folder.path);
        return 1;
    }
    bool fine = (!speed ||
                 (measure_speed(&folder, count, timed) && measure_memory(&folder, count, timed))) &&
                (!cache || (batch_folder_fill(&folder, "m", count, write_scene) &&
                            measure_cache(&folder, count))) &&
                (!scene || batch_measure_scene(&folder, options->gl, timed));
    batch_folder_remove(&folder);
    return !fine;
}
