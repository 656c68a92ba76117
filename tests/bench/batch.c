/* matbench batch: how fast many materials are compiled by one process, beside glslang's own time for their programs, with and
 * without validation and from a cache; how its memory grows with their number; and what a scene saves (batch_scene.c). */
#include "batch.h"
#include "batch_documents.h"
#include "matbench.h"
#include "compiler/validate.h"
#include <cjson/cJSON.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COUNT = 10000, THREADS = 2 };

/* Text of a program, by a key of the manifest; NULL: see stderr. */
static char *program_text(const BatchFolder *folder, const cJSON *program, const char *key)
{
    const cJSON *name = cJSON_GetObjectItem(program, key);
    char *text = name ? batch_read(folder, "out", name->valuestring) : NULL;
    if (!text)
        fprintf(stderr, "matbench: a program without %s\n", key);
    return text;
}

/* Seconds that glslang takes to parse and link a program; below 0: it fails. */
static double link_once(const char *vertex, const char *fragment)
{
    Arena arena = {0};
    MatcOptions options;
    const char *log = "";
    matc_options_init(&options);
    Compile c = {.options = &options, .arena = &arena};
    double start = bench_now();
    bool fine = validate(&c, TARGET_glsl330, vertex, fragment, &log);
    double seconds = bench_now() - start;
    if (!fine)
        fprintf(stderr, "matbench: %s\n", log);
    arena_free(&arena);
    return fine ? seconds : -1;
}

typedef struct {
    int programs;
    double bytes, seconds; /* of fragment programs; of glslang, one thread */
} Linked;

/* All programs of the manifest through glslang, one after the other; reading the files does not count. */
static bool link_all(const BatchFolder *folder, Linked *linked)
{
    char *text = batch_read(folder, "out", "manifest.json");
    cJSON *manifest = text ? cJSON_Parse(text) : NULL;
    const cJSON *program;
    bool fine = manifest != NULL;
    *linked = (Linked){0};
    cJSON_ArrayForEach(program, cJSON_GetObjectItem(manifest, "programs"))
    {
        char *vertex = program_text(folder, program, "vertex"), *fragment = program_text(folder, program, "fragment");
        double seconds = vertex && fragment ? link_once(vertex, fragment) : -1;
        if (!linked->programs && seconds >= 0)
            seconds = link_once(vertex, fragment); /* the first time glslang makes its tables */
        fine = fine && seconds >= 0;
        linked->programs++;
        linked->bytes += fragment ? (double)strlen(fragment) : 0;
        linked->seconds += seconds;
        free(vertex);
        free(fragment);
        if (!fine)
            break;
    }
    cJSON_Delete(manifest);
    free(text);
    return fine;
}

static void put_times(const char *what, int count, const BatchTimes *times)
{
    printf("%-38s %8.2f %10.0f %10.1f %9.1f\n", what, times->seconds, count / times->seconds, times->cpu / count * 1e6,
           (double)times->memory / 1024);
    fflush(stdout);
}

typedef struct {
    const char *what;
    const char *clear[2]; /* folders that are removed before; NULL: none */
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

static bool run(const BatchFolder *folder, const Run *row, BatchTimes *times)
{
    char cache[BATCH_PATH];
    const char *arguments[sizeof row->arguments / sizeof *row->arguments + 1] = {NULL};
    snprintf(cache, sizeof cache, "--cache=%s/cache", folder->path);
    for (int i = 0; row->arguments[i]; i++)
        arguments[i] = strcmp(row->arguments[i], "--cache") ? row->arguments[i] : cache;
    for (int i = 0; i < 2 && row->clear[i]; i++)
        batch_clear(folder, row->clear[i]);
    return batch_run(folder, "m", "out", arguments, times);
}

/* The first run is the validated one; then glslang alone. */
static bool measure_speed(BatchFolder *folder, int count)
{
    BatchTimes times;
    Linked linked;
    if (!batch_folder_fill(folder, "m", count, batch_different) || !run(folder, &runs[0], &times) ||
        !link_all(folder, &linked))
        return false;
    printf("%d different materials of %.0f bytes, %d programs of %.0f bytes, %d threads\n\n", count,
           (double)folder->bytes / count, linked.programs, linked.bytes / linked.programs, THREADS);
    printf("%-38s %8s %10s %10s %9s\n", "", "seconds", "materials", "CPU us", "peak MiB");
    printf("%-38s %8s %10s %10s\n", "", "", "a second", "each");
    put_times(runs[0].what, count, &times);
    printf("%-38s %8.2f %10.0f %10.1f\n", "glslang alone, one thread", linked.seconds, count / linked.seconds,
           linked.seconds / count * 1e6);
    printf("  validated / (glslang / %d threads)    %.3f; of CPU time %.3f\n", THREADS,
           times.seconds / (linked.seconds / THREADS), times.cpu / linked.seconds);
    for (size_t i = 1; i < sizeof runs / sizeof *runs; i++) {
        if (!run(folder, &runs[i], &times))
            return false;
        put_times(runs[i].what, count, &times);
    }
    return true;
}

static bool measure_memory(BatchFolder *folder, int count)
{
    BatchTimes times;
    printf("\nmemory, not validated\n");
    for (int n = count / 10 ? count / 10 : 1; n <= 4 * count; n = n < count ? count : 4 * n) {
        char what[64];
        if (!batch_folder_fill(folder, "m", n, batch_different) || !run(folder, &runs[1], &times))
            return false;
        snprintf(what, sizeof what, "%d materials", n);
        put_times(what, n, &times);
    }
    return true;
}

int bench_batch(int argc, char **argv)
{
    BatchFolder folder;
    const char *matc = MATC_PROGRAM;
    int count = COUNT;
    bool scene = true, speed = true;
    for (int i = 1; i < argc; i++) {
        if (!strcmp(argv[i], "--count") && i + 1 < argc)
            count = atoi(argv[++i]);
        else if (!strcmp(argv[i], "--matc") && i + 1 < argc)
            matc = argv[++i];
        else if (!strcmp(argv[i], "--scene"))
            speed = false;
        else if (!strcmp(argv[i], "--speed"))
            scene = false;
        else
            count = 0;
    }
    if (count < 1 || 4 * count > DIFFERENT_DOCUMENTS) {
        fputs("usage: matbench batch [--count N] [--matc PROGRAM] [--speed | --scene]\n", stderr);
        return 2;
    }
    if (!batch_folder_make(&folder, matc)) {
        perror(folder.path);
        return 1;
    }
    bool fine = (!speed || (measure_speed(&folder, count) && measure_memory(&folder, count))) &&
                (!scene || batch_measure_scene(&folder));
    batch_folder_remove(&folder);
    return !fine;
}
