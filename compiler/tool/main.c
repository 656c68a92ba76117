/* matc's command line: reads files, calls the library, writes what it made. The only file that prints or exits. */
#include "compiler/base/text.h"
#include "compiler/tool/batch.h"
#include "compiler/tool/cache.h"
#include "compiler/base/diag.h"
#include "compiler/base/file.h"
#include "compiler/base/progress.h"
#include "compiler/tool/layout_option.h"
#include "compiler/tool/options_fault.h"
#include "runtime/measure/pareto.h"
#include "compiler/tool/single.h"
#include "compiler/base/watch.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum {
    FINE = 0,
    FAULT = 1,
    USAGE = 2,
    BY_SIGNAL = 128, /* and its number */
    LONGEST_MESSAGE = 8192,
    PROGRESS_STEP = 16
};

static double milliseconds_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec * 1e-6;
}

static void print_complaint(const CommandLine *line, Severity severity, const char *what, const char *why)
{
    Arena arena = {0};
    Text text = text_new(&arena);
    diag_complain(&text, line->diagnostics, severity, what, why);
    fputs(text.at, stderr);
    arena_free(&arena);
}

/* `what`: a file or an option; NULL: neither. */
static int complain(const CommandLine *line, const char *what, const char *why)
{
    print_complaint(line, SEVERITY_error, what, why);
    return FAULT;
}

/* Diagnostics, or what is wrong in a line. */
static void print_fault(const CommandLine *line, const char *fault)
{
    if (strchr(fault, '\n'))
        fputs(fault, stderr);
    else
        complain(line, NULL, fault);
}

static int usage(const CommandLine *line, const char *what)
{
    if (line->diagnostics == MATC_JSON)
        complain(line, NULL, what);
    else
        fprintf(stderr, "matc: %s; see matc --help\n", what);
    return USAGE;
}

static unsigned wanted_outputs(const CommandLine *line)
{
    unsigned outputs = line->stats ? MATC_STATS : 0;
    for (int emit = 0; emit < EMIT_COUNT; emit++)
        if (line->emit[emit])
            outputs |= emit_table[emit].output | options_emit_output(&line->compile, emit);
    return outputs;
}

/* What stands on the terminal's last line. */
typedef struct {
    double last;
} Shown;

static void show_measuring(void *user, int done, int total)
{
    Shown *shown = user;
    char what[64];
    Arena arena = {0};
    Text text = text_new(&arena);
    snprintf(what, sizeof what, "%d of %d programs measured", done, total);
    fputs(progress_line(&text, what, milliseconds_now() / 1e3, &shown->last), stderr);
    arena_free(&arena);
}

/* What is measured; check_usage has seen the numbers. */
static ParetoSubject subject_of(const CommandLine *line, const MatcDocument *document, int material, Shown *shown)
{
    ParetoSubject subject = {document,       material,
                             GL_KIND_osmesa, options_number(line->range, measure_range),
                             line->output,   isatty(STDERR_FILENO) ? show_measuring : NULL,
                             shown};
    if (line->gl)
        gl_kind_find(line->gl, &subject.gl);
    return subject;
}

/* A material that does not compile as it was asked for says why, and is not measured. */
static bool is_refused(const CommandLine *line, const MatcDocument *document, int material)
{
    MatcOptions options = line->compile;
    options.validate = false;
    MatcProgram *program = matc_compile(document, material, MATC_FRAGMENT, &options);
    bool refused = !matc_ok(program);
    if (refused)
        fputs(matc_program_diagnostics(program, line->diagnostics), stderr);
    matc_program_free(program);
    return refused;
}

/* The options that a material is compiled with: with --max-error, those that measuring finds. */
static int choose_options(const CommandLine *line, const MatcDocument *document, int material, MatcOptions *options)
{
    ParetoAnswer answer;
    *options = line->compile;
    if (!line->max_error)
        return FINE;
    if (is_refused(line, document, material))
        return FAULT;
    Shown shown = {0};
    ParetoSubject subject = subject_of(line, document, material, &shown);
    bool chosen = pareto_choose(&subject, options_number(line->max_error, 0), options, &answer);
    fputs(progress_erase(&shown.last), stderr);
    if (!chosen)
        return complain(line, "--max-error", answer.error);
    if (line->stats)
        fputs(answer.text, stderr);
    free(answer.text);
    return FINE;
}

static int print_pareto(const CommandLine *line, const MatcDocument *document, int material)
{
    ParetoAnswer answer;
    if (is_refused(line, document, material))
        return FAULT;
    Shown shown = {0};
    ParetoSubject subject = subject_of(line, document, material, &shown);
    bool measured = pareto_measure(&subject, &line->compile, &answer);
    fputs(progress_erase(&shown.last), stderr);
    if (!measured)
        return complain(line, "--pareto", answer.error);
    fputs(answer.text, stdout);
    free(answer.text);
    return FINE;
}

/* Compiles a material, and writes it if it has no fault. */
static int compile_material(const CommandLine *line, MatcDocument *document, int material)
{
    MatcOptions options;
    char path[SINGLE_PATH];
    if (choose_options(line, document, material, &options) != FINE)
        return FAULT;
    MatcProgram *program = matc_compile(document, material, wanted_outputs(line), &options);
    fputs(matc_program_diagnostics(program, line->diagnostics), stderr);
    int status = matc_ok(program) ? FINE : FAULT;
    if (status == FINE && line->stats)
        fputs(matc_output(program, MATC_STATS, NULL), stderr);
    const char *why = status == FINE ? single_write(line, document, program, path) : NULL;
    if (why)
        status = complain(line, path, why);
    matc_program_free(program);
    return status;
}

static int eval_material(const CommandLine *line, const MatcDocument *document, int material)
{
    const char *fault;
    char *values = matc_eval(document, material, line->eval, &line->compile, &fault);
    if (!values)
        return usage(line, fault);
    fputs(values, stdout);
    free(values);
    return FINE;
}

static void complain_of_several(const CommandLine *line, const MatcDocument *document)
{
    static const char why[] = "the document has several materials; name one with --material, or use -d";
    if (line->diagnostics == MATC_JSON) {
        complain(line, NULL, why);
        return;
    }
    fprintf(stderr, "matc: error: %s:\n", why);
    for (int i = 0; i < matc_material_count(document); i++)
        fprintf(stderr, "  %s\n", matc_material_name(document, i));
}

static const char *material_name(const void *document, int i) { return matc_material_name(document, i); }

static void complain_of_material(const CommandLine *line, const MatcDocument *document)
{
    Arena arena = {0};
    const NameChoice names = {material_name, document, matc_material_count(document)};
    complain(line, NULL, options_fault_value(&arena, "--material", line->material, &names));
    arena_free(&arena);
}

/* The material that is meant, or -1: a fault, reported. */
static int choose_material(const CommandLine *line, const MatcDocument *document)
{
    if (line->material) {
        int found = matc_material_find(document, line->material);
        if (found < 0)
            complain_of_material(line, document);
        return found;
    }
    if (matc_material_count(document) == 1)
        return 0;
    complain_of_several(line, document);
    return -1;
}

static int run_document(const CommandLine *line, MatcDocument *document)
{
    if (!matc_material_count(document))
        return matc_error_count(document) ? FAULT : complain(line, NULL, "the document has no material to compile");
    int material = choose_material(line, document);
    if (material < 0)
        return FAULT;
    if (line->pareto)
        return print_pareto(line, document, material);
    return line->eval ? eval_material(line, document, material) : compile_material(line, document, material);
}

static int write_tree(const CommandLine *line, MatcDocument *document)
{
    char path[SINGLE_PATH];
    const char *why = single_write(line, document, NULL, path);
    return why ? complain(line, path, why) : FINE;
}

static int run_input(const CommandLine *line, const char *path)
{
    size_t size;
    const char *why;
    char *text = strcmp(path, "-") ? file_read_named(path, &size, &why) : file_read_from(STDIN_FILENO, &size, &why);
    if (!text && line->watched)
        watch_list_add(line->watched, path);
    if (!text)
        return complain(line, path, why);
    MatcDocument *document = matc_read(strcmp(path, "-") ? path : "<stdin>", text, size, &line->compile);
    free(text);
    fputs(matc_diagnostics(document, line->diagnostics), stderr);
    for (int i = 0; line->watched && i < matc_depend_count(document); i++)
        watch_list_add(line->watched, matc_depend(document, i));
    bool tree_only = line->emit[EMIT_tree] && !line->folder && !line->depend && !line->textures;
    int status = FAULT;
    if (!tree_only)
        status = run_document(line, document);
    else if (!matc_error_count(document))
        status = write_tree(line, document);
    matc_document_free(document);
    return status;
}

/* -- a batch */

static void say(void *user, const char *text)
{
    (void)user;
    if (isatty(STDERR_FILENO))
        fputs("\r\033[K", stderr); /* over the progress */
    fputs(text, stderr);
}

static void show_progress(void *user, int done, int documents)
{
    (void)user;
    if (done % PROGRESS_STEP == 0 || done == documents)
        fprintf(stderr, "\r%d of %d documents%s", done, documents, done == documents ? "\r\033[K" : "");
}

static void warn_of_cache(void *user, const char *folder, const char *why)
{
    Arena arena = {0};
    Text what = text_new(&arena);
    text_format(&what, "the cache %s", folder);
    print_complaint(user, SEVERITY_warning, what.at, why);
    arena_free(&arena);
}

static bool choose_for_batch(void *user, const MatcDocument *document, int material, MatcOptions *options)
{
    const char *pass = options->pass;
    bool fine = choose_options(user, document, material, options) == FINE;
    options->pass = pass;
    return fine;
}

static void print_counts(const BatchResult *result)
{
    fprintf(stderr, "%d documents, %d materials, %d programs (", result->documents, result->materials,
            result->programs);
    for (int pass = 0, any = 0; pass < PASS_COUNT; pass++)
        if (result->passes[pass])
            fprintf(stderr, "%s%d %s", any++ ? ", " : "", result->passes[pass], pass_table[pass].name);
    fprintf(stderr, "), %d with numbers from a buffer; %d files written\n", result->buffered, result->written);
}

static int run_batch(CommandLine *line, BatchResult *result)
{
    const BatchCalls calls = {say, isatty(STDERR_FILENO) && line->input_count > 1 ? show_progress : NULL, warn_of_cache,
                              choose_for_batch, line};
    if (!batch_run(line, &calls, result))
        return FAULT;
    if (line->stats)
        print_counts(result);
    return FINE;
}

/* A layout of one's own, for all that follows. `line->compile.custom` is to be freed. */
static int use_layout(CommandLine *line)
{
    char *fault;
    if (line->folder && line->compile.layout && !strcmp(line->compile.layout, "auto"))
        return FINE; /* the batch makes it of what it reads */
    MatcLayout *layout = layout_open(line, &fault);
    if (fault)
        print_fault(line, fault);
    free(fault);
    if (layout)
        fputs(matc_layout_diagnostics(layout, line->diagnostics), stderr);
    bool fine = !fault && (!layout || matc_layout_ok(layout));
    if (layout && fine && line->stats && !line->explain)
        fputs(matc_layout_report(layout), stderr);
    line->compile.custom = layout;
    return fine ? FINE : FAULT;
}

static void free_layout(CommandLine *line)
{
    matc_layout_free((MatcLayout *)line->compile.custom);
    line->compile.custom = NULL;
}

static int run_inputs(CommandLine *line)
{
    int status = FINE;
    for (int i = 0; i < line->input_count; i++)
        status |= run_input(line, line->inputs[i]);
    return status;
}

/* What a run reads before it meets its documents. */
static void watch_layout(CommandLine *line, bool failed)
{
    if (line->compile.layout && layout_is_file(line->compile.layout))
        watch_list_add(line->watched, line->compile.layout);
    for (int i = 0; failed && i < line->input_count; i++)
        watch_list_add(line->watched, line->inputs[i]);
}

static int run(CommandLine *line, BatchResult *result)
{
    *result = (BatchResult){0};
    int status = use_layout(line);
    if (line->watched)
        watch_layout(line, status != FINE);
    if (status == FINE)
        status = line->folder ? run_batch(line, result) : run_inputs(line);
    free_layout(line);
    return status;
}

static int explain_layout(CommandLine *line)
{
    int status = use_layout(line);
    if (status == FINE)
        fputs(matc_layout_report(line->compile.custom), stdout);
    free_layout(line);
    return status;
}

static int answer(const CommandLine *line, char *text, const char *otherwise)
{
    if (!text)
        return usage(line, otherwise);
    fputs(text, stdout);
    free(text);
    return FINE;
}

/* All kinds of names, or one: "--list=maps", "--list maps". */
static int print_list(CommandLine *line)
{
    const char *kind = *line->list ? line->list : line->input_count ? line->inputs[0] : "";
    return answer(line, *kind ? matc_list_of(kind) : matc_list(), options_fault_list(&line->words, kind));
}

static int print_cache(const CommandLine *line)
{
    if (!line->cache)
        return usage(line, "--cache-stats wants --cache or MATC_CACHE");
    char *text = cache_statistics(line->cache);
    if (!text)
        return complain(line, line->cache, text_error(errno));
    fputs(text, stdout);
    free(text);
    return FINE;
}

static const char *gl_name(const void *user, int i)
{
    (void)user;
    return i ? "egl" : "osmesa";
}

static const char *schema_name(const void *user, int i)
{
    static const char *const names[] = {"document", "layout", "manifest", "reflection"};
    (void)user;
    return names[i];
}

static int check_usage(CommandLine *line)
{
    const char *fault = options_check(line);
    if (!fault && line->gl && !gl_kind_find(line->gl, &(GlKind){0}))
        fault = options_fault_value(&line->words, "--gl", line->gl, &(NameChoice){gl_name, NULL, 2});
    return fault ? usage(line, fault) : FINE;
}

static bool read_command_line(CommandLine *line, int argc, char **argv, const char **fault)
{
    bool fine = options_read(line, argc, argv, fault);
    line->compile.pixels = line->eval || line->textures || line->pareto || line->max_error;
    line->compile.measure = line->stats;
    if (!line->cache && getenv("MATC_CACHE") && *getenv("MATC_CACHE"))
        line->cache = getenv("MATC_CACHE");
    return fine;
}

/* -- watching */

static void run_and_tell(CommandLine *line, Watch *watch)
{
    BatchResult result;
    WatchList files = {0};
    double start = milliseconds_now();
    for (int i = 0; i < line->list_count; i++)
        watch_list_add(&files, line->lists[i]);
    if (line->compile.layout && layout_is_file(line->compile.layout))
        watch_list_add(&files, line->compile.layout);
    line->watched = &files;
    int status = run(line, &result);
    const long took = lround(milliseconds_now() - start);
    watch_set(watch, (const char *const *)files.at, files.count);
    if (status != FINE)
        fprintf(stderr, "matc: nothing written; watching %d files\n", files.count);
    else if (line->folder)
        fprintf(stderr, "matc: %d files written for %d materials in %ld ms; watching %d files\n", result.written,
                result.materials, took, files.count);
    else
        fprintf(stderr, "matc: %s in %ld ms; watching %d files\n", line->output, took, files.count);
    watch_list_free(&files);
}

/* Until a signal comes. Lists of documents are read again every time. */
static int run_watching(CommandLine *line, int argc, char **argv)
{
    Watch *watch = watch_open();
    const char *fault;
    int signal;
    run_and_tell(line, watch);
    while (!(signal = watch_next(watch))) {
        options_free(line);
        if (!read_command_line(line, argc, argv, &fault))
            usage(line, fault);
        else if (check_usage(line) == FINE)
            run_and_tell(line, watch);
    }
    watch_close(watch);
    return BY_SIGNAL + signal;
}

static void print_help(void)
{
    Arena arena = {0};
    fputs(options_help(&arena), stdout);
    arena_free(&arena);
}

int main(int argc, char **argv)
{
    CommandLine line;
    BatchResult result;
    const char *fault;
    int status = FINE;
    if (!read_command_line(&line, argc, argv, &fault)) {
        status = usage(&line, fault);
        options_free(&line);
        return status;
    }
    if (line.help)
        print_help();
    else if (line.version)
        puts("matc " MATC_VERSION);
    else if (line.schema)
        status = answer(&line, matc_schema(line.schema),
                        options_fault_value(&line.words, "--schema", line.schema, &(NameChoice){schema_name, NULL, 4}));
    else if (line.list)
        status = print_list(&line);
    else if (line.explain && layout_is_file(line.explain))
        status = explain_layout(&line);
    else if (line.explain)
        status = answer(&line, matc_explain(line.explain), options_fault_explain(&line.words, line.explain));
    else if (line.cache_stats)
        status = print_cache(&line);
    else if ((status = check_usage(&line)) == FINE)
        status = line.watch ? run_watching(&line, argc, argv) : run(&line, &result);
    options_free(&line);
    if (fflush(stdout) || ferror(stdout))
        status |= complain(&line, "standard output", text_error(errno));
    return status < BY_SIGNAL && status & USAGE ? USAGE : status;
}
