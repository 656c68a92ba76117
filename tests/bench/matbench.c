/* matbench: measures what matc promises. Every figure in docs/ comes from one of its subcommands. */
#include "matbench.h"
#include "compiler/base/progress.h"
#include "compiler/base/suggest.h"
#include "runtime/measure/meter.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

double bench_now(void) { return meter_now(); }
double bench_median(double *values, int count) { return meter_median(values, count); }

const char *bench_number(char text[BENCH_NUMBER], int decimals, double value)
{
    snprintf(text, BENCH_NUMBER, isnan(value) ? "-" : "%.*f", decimals, value);
    return text;
}

bool bench_untimed(int argc, char **argv) { return argc > 1 && !strcmp(argv[1], "--untimed"); }

void bench_show(const char *what)
{
    Arena arena = {0};
    Text line = text_new(&arena);
    double none = 0; /* each line is worth its own time */
    if (isatty(STDERR_FILENO))
        fputs(progress_line(&line, what, bench_now(), &none), stderr);
    arena_free(&arena);
}

long bench_peak_memory(void)
{
    struct rusage usage;
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
}

static const struct {
    const char *name;
    int (*run)(int argc, char **argv);
    const char *doc;
    bool reads; /* options of its own; the others take --untimed alone */
} commands[] = {
    {"cells", bench_cells, "what cells are replaced with far away, measured: the rows of grammar/cells.def", false},
    {"compile", bench_compile, "time of every stage, a ladder of sizes, a process, glslang's share", false},
    {"glslang", bench_glslang, "only validates two files; `compile` measures a process of it", false},
    {"layout", bench_layout, "time to pack and unpack by every encoding, beside its error", false},
    {"surfaces", bench_surfaces, "the most common Principled materials in 16 bytes a pixel: what each slot is off, and what packing takes", false},
    {"error", bench_error, "run time against error of every variant; --quick: coarse, in half a minute", true},
    {"batch", bench_batch, "many materials in one process, beside glslang's time; what a scene's materials share",
     true},
    {"instructions", bench_instructions, "instructions after spirv-opt -O, beside shaders written by hand", false},
    {"functions", bench_functions,
     "what the driver makes of exponentials, sines and their inverses, beside what is stated", false},
    {"guards", bench_guards, "guards that formulas of examples were made with, and those that intervals left", false},
    {"growth", bench_growth, "time at n, 2 n, 4 n, 8 n of documents of every kind, and the exponent", false},
    {"noise", bench_noise, "time of noise, beside noise of others written anew", true},
    {"render", bench_render,
     "what a frame takes by materials, lights, objects, passes, transparent fragments, beside a forward renderer",
     true},
    {"thesis", bench_thesis, "tables 5.2 to 5.6 of the thesis on Proteus, its numbers beside ours: there : here", true},
    {"shadows", bench_shadows, "how far ends of shadows are from the true ones, and what they take, by every method",
     true},
    {"indirect", bench_indirect, "slice maps, and rays through voxels by levels, voxel by voxel, by the thesis' march",
     true},
    {"displacement", bench_displacement, "how far displaced triangles are from the surface by their number, and how many are drawn a second", true},
    {"stress", bench_stress, "random documents, tried in every way; a fault is shrunk", true},
};

enum { COMMANDS = sizeof commands / sizeof *commands };

static const char *command_name(const void *user, int i)
{
    (void)user;
    return commands[i].name;
}

static int say_usage(const char *word)
{
    Arena arena = {0};
    if (word)
        fprintf(stderr, "matbench: there is no command '%s'%s\n", word,
                suggest(&arena, word, command_name, NULL, COMMANDS));
    fputs("usage: matbench COMMAND [options]\n\n", stderr);
    for (int i = 0; i < COMMANDS; i++)
        fprintf(stderr, "  %-14s %s\n", commands[i].name, commands[i].doc);
    arena_free(&arena);
    return 2;
}

static int run(int command, int argc, char **argv)
{
    for (int i = 1; i < argc && !commands[command].reads; i++)
        if (!strncmp(argv[i], "--", 2) && strcmp(argv[i], "--untimed") != 0) {
            fprintf(stderr, "matbench: %s: there is no option '%s', but --untimed\n", commands[command].name, argv[i]);
            return 2;
        }
    return commands[command].run(argc, argv);
}

int main(int argc, char **argv)
{
    for (int i = 0; i < COMMANDS && argc > 1; i++)
        if (!strcmp(argv[1], commands[i].name))
            return run(i, argc - 1, argv + 1);
    return say_usage(argc > 1 ? argv[1] : NULL);
}
