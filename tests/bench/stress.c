/* matbench stress: tries any number of random documents in every mode. A failing document is
 * shrunk to a small one. */
#include "matbench.h"
#include "tests/stress/modes.h"
#include "tests/stress/stress.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char help[] =
    "usage: matbench stress [--count=N] [--seed=S] [--first=N] [--threads=N] [--points=N] "
    "[--faults=N]\n"
    "    [--validate-every=N] [--draw-every=N] [--folder=path] [--mode=M] [--trees=relief] "
    "[--aa=box and other choices "
    "of matc]\n\n"
    "  --count           documents (1000)\n"
    "  --first           number of the first of them (0)\n"
    "  --points          of the surface, for each program (6)\n"
    "  --faults          ends after so many (1)\n"
    "  --validate-every  every Nth is shown to glslang for all targets (100; 0: none)\n"
    "  --draw-every      every Nth is drawn (500; 0: none)\n"
    "  --trees           relief: those of displacements alone\n"
    "  --folder          where the documents of faults are written\n"
    "  --mode            a row of tests/stress/modes.def:"
#define MODE(name, ...) " " #name
#include "tests/stress/modes.def"
    "\n";

static bool read_number(StressOptions *o, const char *name, const char *value)
{
    long number = strtol(value, NULL, 0);
    if (!strcmp(name, "count"))
        o->count = number;
    else if (!strcmp(name, "seed"))
        o->seed = strtoull(value, NULL, 0);
    else if (!strcmp(name, "first"))
        o->first = number;
    else if (!strcmp(name, "threads"))
        o->threads = (int)number;
    else if (!strcmp(name, "points"))
        o->points = (int)number;
    else if (!strcmp(name, "faults"))
        o->faults = (int)number;
    else if (!strcmp(name, "validate-every"))
        o->validate_every = number;
    else if (!strcmp(name, "draw-every"))
        o->draw_every = number;
    else
        return false;
    return true;
}

/* --name=value or --name value. */
static bool read_options(StressOptions *o, int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        char *equals = strchr(argv[i], '=');
        if (strncmp(argv[i], "--", 2) != 0 || (!equals && i + 1 == argc))
            return false;
        const char *name = argv[i] + 2, *value = equals ? equals + 1 : argv[++i];
        if (equals)
            *equals = 0;
        const StressMode *mode = strcmp(name, "mode") ? NULL : stress_mode(value);
        if (mode)
            stress_mode_set(mode, &o->options);
        else if (!strcmp(name, "folder"))
            o->folder = value;
        else if (!strcmp(name, "trees") && !strcmp(value, "relief"))
            o->generate = generate_relief;
        else if (!read_number(o, name, value) && !matc_options_set(&o->options, name, value))
            return false;
    }
    return matc_options_fault(&o->options) == NULL;
}

int bench_stress(const BenchOptions *given)
{
    StressOptions options;
    TrialCount n = {0};
    stress_options_init(&options);
    options.folder = ".";
    options.progress = isatty(2);
    const bool asked = given->argument_count == 2 && !strcmp(given->arguments[1], "--help");
    if (asked || !read_options(&options, given->argument_count, given->arguments)) {
        fputs(help, asked ? stdout : stderr);
        return asked ? 0 : 2;
    }
    double start = bench_now();
    int faults = stress_run(&options, &n);
    double seconds = bench_now() - start;
    printf("%ld trees of %ld maps and materials, seed %llu, %.0f s, %.0f a second, %d faults\n",
           n.trees, n.nodes, (unsigned long long)options.seed, seconds, (double)n.trees / seconds,
           faults);
    printf("%ld values of IR in double, %ld spreads; %ld points left the range of values\n",
           n.values, n.spreads, n.beyond);
    if (n.slopes)
        printf("%ld slots at points where exact derivatives are known\n", n.slopes);
    printf("%ld programs validated, %ld drawn, %ld of %ld drawn values within the bound itself\n",
           n.validated, n.programs, n.judged, n.drawn_values);
    return faults != 0;
}
