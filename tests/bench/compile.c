/* matbench compile: the time of each compiler stage (median of many runs in one process), the
 * growth of CPU time with the size of the document, the time of a whole process, and glslang's
 * share in all of these. */
#include "matbench.h"
#include "compiler/matc.h"
#include "compiler/pipeline.h"
#include "compiler/emit/validate.h"
#include <math.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

enum { RUNS = 301, LADDER_RUNS = 31, PROCESS_RUNS = 41, MAX_STAGES = 64 };

extern char **environ;

/* The material of peers.md, section 2: a checker of two colors, mixed to white by four octaves
 * of noise. */
static const char peers_document[] =
    "material: Phong\n"
    "diffuse:\n"
    "  map: Blend\n"
    "  blend:\n"
    "  - value: -1\n"
    "    input:\n"
    "      map: Checker\n"
    "      color1: [0.8, 0.1, 0.1]\n"
    "      color2: [0.1, 0.1, 0.8]\n"
    "      input: { map: UVTransform, scaleU: 4, scaleV: 4 }\n"
    "  - { value: 1, input: 1 }\n"
    "  input: { map: VolumeTurbulence, octaves: 4, noiseRatio: 0.5, size: 8 }\n";

static MatcOptions options_for(bool validate)
{
    MatcOptions options;
    matc_options_init(&options);
    options.validate = validate;
    options.check = false;
    return options;
}

/* CPU time, hardly affected by other programs. */
static double processor_now(void)
{
    struct timespec time;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return (double)time.tv_sec + (double)time.tv_nsec * 1e-9;
}

/* Seconds of one whole compilation, including the release of memory. */
static double compile_once(const char *text, size_t size, const MatcOptions *options)
{
    double start = processor_now();
    MatcDocument *document = matc_read("bench.yaml", text, size, options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, options);
    bool ok = matc_ok(program);
    if (!ok)
        fputs(matc_program_diagnostics(program, MATC_TEXT), stderr);
    matc_program_free(program);
    matc_document_free(document);
    double seconds = processor_now() - start;
    return ok ? seconds : -1;
}

double bench_compile_least(const char *text, size_t size, const MatcOptions *options, int runs)
{
    double least = NAN;
    for (int i = 0; i < runs; i++) {
        double once = compile_once(text, size, options);
        if (once < 0)
            exit(1);
        least = fmin(least, once);
    }
    return least;
}

typedef struct {
    const char *name;
    double seconds[RUNS];
} Stage;

static void add_time(Stage *stages, int *count, const char *name, double seconds, int run)
{
    int i = 0;
    while (i < *count && strcmp(stages[i].name, name) != 0)
        i++;
    if (i == *count)
        stages[(*count)++].name = name;
    stages[i].seconds[run] += seconds;
}

static void print_stages(bool timed)
{
    static Stage stages[MAX_STAGES];
    int count = 0;
    MatcOptions options = options_for(false);
    for (int run = 0; run < (timed ? RUNS : 1); run++) {
        Arena arena = {0};
        Session session = {.options = &options, .arena = &arena, .optimize = 2, .measure = true};
        Source source = {
            .name = "bench.yaml", .text = peers_document, .size = sizeof peers_document - 1};
        ARENA_PUSH(&arena, session.sources, session.source_count, session.source_capacity, source);
        Tree *tree;
        Products products;
        Job job;
        choice_job(&(MatcOptions){0}, &job);
        session.stage_start = session_now();
        Graph *graph = compile_front(&session, 0, &tree);
        Ir *ir = compile_ir(&session, graph, graph->materials[0].node, &job);
        compile_back(&session, ir, &job, &products);
        for (size_t i = 0; i < session.stat_count; i++)
            add_time(stages, &count, session.stats[i].name, session.stats[i].seconds, run);
        arena_free(&arena);
    }
    printf("stage        microseconds (median of %d)\n", RUNS);
    for (int i = 0; i < count; i++)
        if (strcmp(stages[i].name, "validate") != 0)
            printf("%-12s %8s\n", stages[i].name,
                   NUMBER(2, timed ? bench_median(stages[i].seconds, RUNS) * 1e6 : NAN));
}

/* The last row of formulas.def, of 36 operations. */
static const char *largest_formula(void)
{
    static const char *const formulas[] = {
#define FORMULA(name, formula, hand) formula,
#include "formulas.def"
    };
    return formulas[sizeof formulas / sizeof *formulas - 1];
}

/* Cost of a formula in a document, compared with a number in the formula's place. */
static void print_formula(bool timed)
{
    char with[1024];
    static const char without[] = "material: Phong\ndiffuse: 0.5\n";
    const size_t size = (size_t)snprintf(with, sizeof with, "material: Phong\ndiffuse: \"= %s\"\n",
                                         largest_formula());
    const MatcOptions options = options_for(false);
    const double own = bench_compile_least(with, size, &options, timed ? RUNS : 0),
                 plain =
                     bench_compile_least(without, sizeof without - 1, &options, timed ? RUNS : 0);
    printf("\na formula of 36 operations takes %s microseconds more than a number\n",
           NUMBER(1, (own - plain) * 1e6));
}

/* A document of about `nodes` values (scalars, lists, objects): a Blend of Checkers under
 * transforms, 16 values an item. */
static char *ladder_document(int nodes, size_t *size)
{
    enum { VALUES_OF_FRAME = 10, VALUES_OF_ITEM = 16 };
    int items =
        nodes > VALUES_OF_FRAME + VALUES_OF_ITEM ? (nodes - VALUES_OF_FRAME) / VALUES_OF_ITEM : 0;
    char *text = NULL;
    FILE *out = open_memstream(&text, size);
    fputs("material: Phong\ndiffuse:\n  map: Blend\n  input: { map: Gradient, direction: [1, 0, 0] "
          "}\n  blend:\n",
          out);
    if (!items)
        fputs("  - { value: 0 }\n", out);
    for (int i = 0; i < items; i++)
        fprintf(
            out,
            "  - value: %d\n    input: { map: Checker, color1: [0.%d, 0.5, 0.25], color2: 0.%d,\n"
            "      input: { map: UVTransform, scaleU: %d, input: { map: Turbulence, octaves: 2 } } "
            "}\n",
            i, i % 10, i % 7, i + 1);
    fclose(out);
    return text;
}

/* With the default options, and with --aa=none, which lowers a document only once
 * (compiler/lower/budget.c). */
static void print_ladder(bool timed)
{
    const int runs = timed ? LADDER_RUNS : 0;
    printf("\nnodes      bytes   microseconds   microseconds a node   with --aa=none   fragment "
           "bytes\n");
    for (int nodes = 10; nodes <= 100000; nodes *= 10) {
        size_t size;
        char *text = ladder_document(nodes, &size);
        MatcOptions options = options_for(false), plain = options;
        plain.aa = "none";
        double seconds = bench_compile_least(text, size, &options, runs),
               once = bench_compile_least(text, size, &plain, runs);
        MatcDocument *document = matc_read("bench.yaml", text, size, &options);
        MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT, &options);
        size_t bytes;
        matc_output(program, MATC_FRAGMENT, &bytes);
        printf("%5d %10zu %14s %21s %16s %16zu\n", nodes, size, NUMBER(1, seconds * 1e6),
               NUMBER(3, seconds * 1e6 / nodes), NUMBER(3, once * 1e6 / nodes), bytes);
        matc_program_free(program);
        matc_document_free(document);
        free(text);
    }
}

/* Minimum CPU time of a process, which must succeed; otherwise -1. */
static double process_least(char **argv)
{
    double least = INFINITY;
    for (int i = 0; i < PROCESS_RUNS; i++) {
        pid_t child;
        int status;
        struct rusage usage;
        if (posix_spawn(&child, argv[0], NULL, NULL, argv, environ) ||
            wait4(child, &status, 0, &usage) < 0 || status)
            return -1;
        const struct timeval user = usage.ru_utime, system = usage.ru_stime;
        least = fmin(least, (double)(user.tv_sec + system.tv_sec) +
                                (double)(user.tv_usec + system.tv_usec) * 1e-6);
    }
    return least;
}

static bool write_file(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    bool fine = file && fputs(text, file) >= 0;
    return file && !fclose(file) && fine;
}

/* Writes the document and both programs to a folder. */
static bool write_files(char *document_path, char *vertex_path, char *fragment_path)
{
    MatcOptions options = options_for(false);
    MatcDocument *document =
        matc_read("bench.yaml", peers_document, sizeof peers_document - 1, &options);
    MatcProgram *program = matc_compile(document, 0, MATC_FRAGMENT | MATC_VERTEX, &options);
    bool fine = write_file(document_path, peers_document) &&
                write_file(vertex_path, matc_output(program, MATC_VERTEX, NULL)) &&
                write_file(fragment_path, matc_output(program, MATC_FRAGMENT, NULL));
    matc_program_free(program);
    matc_document_free(document);
    return fine;
}

static void put_process(double bare, double full, double glslang)
{
    printf("\nprocess: without validation %s ms; with validation %s ms, glslang alone %s ms: matc "
           "adds %s ms\n",
           NUMBER(2, bare * 1e3), NUMBER(2, full * 1e3), NUMBER(2, glslang * 1e3),
           NUMBER(2, (full - glslang) * 1e3));
}

/* Compares a process of matc with one that only does glslang's part: parses and links the same
 * two programs. */
static void print_process(const char *matc)
{
    char folder[] = "/tmp/matbenchXXXXXX", document[64], vertex[64], fragment[64], self[1024] = {0};
    if (!mkdtemp(folder) || readlink("/proc/self/exe", self, sizeof self - 1) < 0)
        return;
    snprintf(document, sizeof document, "%s/m.yaml", folder);
    snprintf(vertex, sizeof vertex, "%s/m.vert", folder);
    snprintf(fragment, sizeof fragment, "%s/m.frag", folder);
    if (write_files(document, vertex, fragment)) {
        double bare = process_least(
            (char *[]){(char *)matc, document, "-o", "/dev/null", "--no-validate", NULL});
        double full = process_least((char *[]){(char *)matc, document, "-o", "/dev/null", NULL});
        double glslang = process_least((char *[]){self, "glslang", vertex, fragment, NULL});
        put_process(bare, full, glslang);
    }
    remove(document);
    remove(vertex);
    remove(fragment);
    rmdir(folder);
}

static char *read_program(const char *path)
{
    char *text = calloc(1, 1 << 20);
    FILE *file = fopen(path, "r");
    if (!file || !text || !fread(text, 1, (1 << 20) - 1, file))
        exit(1);
    fclose(file);
    return text;
}

int bench_glslang(const BenchOptions *options)
{
    if (options->word_count != 2)
        return 2;
    Arena arena = {0};
    const char *log;
    MatcOptions checked = options_for(true);
    Session session = {.options = &checked, .arena = &arena};
    char *vertex = read_program(options->words[0]), *fragment = read_program(options->words[1]);
    bool fine = validate(&session, TARGET_glsl330, &(ProgramTexts){vertex, fragment, 0}, &log);
    free(vertex);
    free(fragment);
    arena_free(&arena);
    return !fine;
}

int bench_compile(const BenchOptions *options)
{
    const size_t size = sizeof peers_document - 1;
    bool timed = options->timed;
    arena_keep_pages(); /* as matc does */
    const MatcOptions plain = options_for(false), checked = options_for(true);
    bench_show("one document");
    double bare = bench_compile_least(peers_document, size, &plain, timed ? RUNS : 0);
    double full = bench_compile_least(peers_document, size, &checked, timed ? RUNS / 5 : 0);
    bench_show("");
    printf("checker mixed with four octaves of noise (%zu bytes of YAML)\n", size);
    printf("  without validation %s ms; with validation %s ms; glslang's share %s %%\n\n",
           NUMBER(4, bare * 1e3), NUMBER(3, full * 1e3), NUMBER(1, 100 * (full - bare) / full));
    print_stages(timed);
    print_formula(timed);
    print_ladder(timed);
    if (options->word_count)
        timed ? print_process(options->words[0]) : put_process(NAN, NAN, NAN);
    printf("peak memory %s KiB\n", NUMBER(0, timed ? (double)bench_peak_memory() : NAN));
    return 0;
}
