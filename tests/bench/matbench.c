/* matbench: measures the performance and accuracy that matc promises. Every figure in docs/
 * comes from one of its subcommands. */
#include "matbench.h"
#include "compiler/base/progress.h"
#include "compiler/base/suggest.h"
#include "runtime/autotune/meter.h"
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

const char *bench_gl_name(const void *user, int i)
{
    (void)user;
    return gl_kind_name((GlKind)i);
}

void bench_show(const char *what)
{
    Arena arena = {0};
    Text line = text_new(&arena);
    double none = 0; /* time of the last line: no rate limit */
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

static const Option plain_options[] = {BENCH_UNTIMED, BENCH_HELP};
static const struct Command {
    const char *name;
    int (*run)(const BenchOptions *options);
    const char *doc;
    const Option *options; /* NULL: plain_options */
    SuggestName *table;    /* its tables' names, as possible arguments */
    const char *words;     /* other arguments, for --help */
    bool own;              /* parses its arguments itself */
} commands[] = {
    {"cells", .run = bench_cells,
     .doc = "what cells are replaced with far away, measured: the rows of grammar/cells.def"},
    {"compile", bench_compile, "time of every stage, a ladder of sizes, a process, glslang's share",
     .words = "[MATC]"},
    {"glslang", bench_glslang, "only validates two files; `compile` measures a process of it",
     .words = "VERTEX FRAGMENT"},
    {"layout", .run = bench_layout,
     .doc = "time to pack and unpack by every encoding, beside its error"},
    {"surfaces", .run = bench_surfaces,
     .doc = "the most common Principled materials in 16 bytes a pixel: what each slot is off, and "
            "what packing takes"},
    {"error", bench_error,
     "run time against error of every variant; --quick: coarse, in half a minute",
     .options = bench_error_options},
    {"batch", bench_batch,
     "many materials in one process, beside glslang's time; what a scene's materials share",
     .options = bench_batch_options},
    {"instructions", .run = bench_instructions,
     .doc = "instructions after spirv-opt -O, beside shaders written by hand"},
    {"functions", .run = bench_functions,
     .doc = "what the driver makes of exponentials, sines and their inverses, beside what is "
            "stated"},
    {"guards", .run = bench_guards,
     .doc = "guards that formulas of examples were made with, and those that intervals left"},
    {"growth", bench_growth,
     "time at n, 2 n, 4 n, 8 n of documents of every kind, and the exponent", .words = "[NAME]..."},
    {"noise", bench_noise, "time of noise, beside noise of others written anew",
     .options = bench_noise_options},
    {"render", bench_render,
     "what a frame takes by materials, lights, objects, passes, transparent fragments, beside a "
     "forward renderer",
     .options = bench_render_options, .table = bench_render_table},
    {"thesis", bench_thesis,
     "tables 5.2 to 5.6 of the thesis on Proteus, its numbers beside ours: there : here",
     .options = bench_thesis_options, .table = bench_thesis_table},
    {"shadows", bench_shadows,
     "how far ends of shadows are from the true ones, and what they take, by every method",
     .options = bench_shadows_options, .table = bench_shadows_table},
    {"indirect", bench_indirect,
     "slice maps, and rays through voxels by levels, voxel by voxel, by the thesis' march",
     .options = bench_indirect_options, .table = bench_indirect_table_name},
    {"displacement", bench_displacement,
     "how far displaced triangles are from the surface by their number, and how many are drawn a "
     "second",
     .options = bench_displacement_options, .table = bench_displacement_table},
    {"stress", bench_stress, "random documents, tried in every way; a fault is shrunk",
     .own = true},
};

enum { COMMANDS = sizeof commands / sizeof *commands };

static const char *command_name(const void *user, int i)
{
    (void)user;
    return commands[i].name;
}

static void put_usage(FILE *to)
{
    fputs("usage: matbench COMMAND [options]; matbench COMMAND --help has its options\n\n", to);
    for (int i = 0; i < COMMANDS; i++)
        fprintf(to, "  %-14s %s\n", commands[i].name, commands[i].doc);
}

static int refuse(const char *word)
{
    Arena arena = {0};
    if (word)
        fprintf(stderr, "matbench: unknown command '%s'%s\n", word,
                suggest(&arena, word, command_name, NULL, COMMANDS));
    put_usage(stderr);
    arena_free(&arena);
    return 2;
}

/* Takes the name of a table, or any word if the command has no tables. */
static const char *take_word(void *to, const char *word, bool literal)
{
    BenchOptions *o = to;
    NameChoice tables = {o->table, NULL, 0};
    (void)literal;
    if (!o->table) {
        o->words[o->word_count++] = word;
        return NULL;
    }
    for (; o->table(NULL, tables.count); tables.count++)
        if (!strcmp(o->table(NULL, tables.count), word)) {
            o->tables |= 1u << tables.count;
            return NULL;
        }
    return option_fault_value(&o->arena, "tables", word, &tables);
}

static OptionTable table_of(const struct Command *command)
{
    OptionTable table = {command->options ? command->options : plain_options, 1, NULL, take_word};
    while (strcmp(table.rows[table.count - 1].name, "--help") != 0)
        table.count++;
    return table;
}

static void put_help(const struct Command *command, const OptionTable *table, Text *out)
{
    text_format(out, "usage: matbench %s [options]", command->name);
    for (int i = 0; command->table && command->table(NULL, i); i++)
        text_format(out, " [%s]", command->table(NULL, i));
    text_format(out, "%s%s\n\n%s\n\n", command->words ? " " : "",
                command->words ? command->words : "", command->doc);
    option_put_help(out, table->rows, table->count);
}

static int run(const struct Command *command, int argc, char **argv)
{
    BenchOptions o = {.timed = true, .table = command->table, .arguments = argv};
    const OptionTable table = table_of(command);
    Text help = text_new(&o.arena);
    int status = 0;
    o.argument_count = argc;
    o.words = ARENA_ARRAY(&o.arena, const char *, argc);
    const char *fault = command->own ? NULL : option_read(&table, &o, &o.arena, argc, argv);
    if (!fault && o.word_count && !command->words)
        fault = option_fault_number(&o.arena, "it takes no more than options", o.words[0]);
    if (fault) {
        fprintf(stderr, "matbench: %s; see matbench %s --help\n", fault, command->name);
        status = 2;
    } else if (o.help) {
        put_help(command, &table, &help);
        fputs(help.at, stdout);
    } else {
        status = command->run(&o);
    }
    arena_free(&o.arena);
    return status;
}

int main(int argc, char **argv)
{
    /* line buffering, so that pipes receive rows as they are measured */
    setvbuf(stdout, NULL, _IOLBF, BUFSIZ);
    for (int i = 0; i < COMMANDS && argc > 1; i++)
        if (!strcmp(argv[1], commands[i].name))
            return run(&commands[i], argc - 1, argv + 1);
    if (argc < 2 || strcmp(argv[1], "--help") != 0)
        return refuse(argc > 1 ? argv[1] : NULL);
    put_usage(stdout);
    return 0;
}
