/* matc's command line: reads files, calls the library, writes the results. Only the files
 * main*.c print, and only main() exits. */
#include "compiler/tool/main.h"
#include "compiler/base/session.h"
#include "compiler/base/output.h"
#include "compiler/base/text.h"
#include "compiler/base/watch.h"
#include "compiler/tool/batch.h"
#include "compiler/tool/cache.h"
#include "compiler/tool/layout_option.h"
#include "compiler/tool/options_fault.h"
#include "runtime/autotune/pareto.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { PROGRESS_STEP = 16 }; /* documents between updates of the progress line */

/* -- A batch */

static void say(void *user, const char *text)
{
    (void)user;
    if (isatty(STDERR_FILENO))
        fputs("\r\033[K", stderr); /* erases the progress line */
    fputs(text, stderr);
}

static void show_progress(void *user, int done, int documents)
{
    (void)user;
    if (done % PROGRESS_STEP == 0 || done == documents)
        fprintf(stderr, "\r%d of %d documents%s", done, documents,
                done == documents ? "\r\033[K" : "");
}

static void warn_of_cache(void *user, const char *folder, const char *why)
{
    Arena arena = {0};
    Text what = text_new(&arena);
    text_format(&what, "the cache %s", folder);
    main_complaint(user, SEVERITY_warning, what.at, why);
    arena_free(&arena);
}

static bool choose_for_batch(void *user, const MatcDocument *document, int material,
                             MatcOptions *options)
{
    const char *pass = options->pass;
    bool fine = main_choose(user, document, material, options) == EXIT_OK;
    options->pass = pass;
    return fine;
}

static void print_counts(const BatchResult *result)
{
    fprintf(stderr, "%d documents, %d materials, %d programs (", result->documents,
            result->materials, result->programs);
    for (int pass = 0, any = 0; pass < PASS_COUNT; pass++)
        if (result->passes[pass])
            fprintf(stderr, "%s%d %s", any++ ? ", " : "", result->passes[pass],
                    pass_table[pass].name);
    fprintf(stderr, "), %d with numbers from a buffer; %d files written\n", result->buffered,
            result->written);
}

static int run_batch(CommandLine *line, BatchResult *result)
{
    const BatchCalls calls = {say,
                              isatty(STDERR_FILENO) && line->input_count > 1 ? show_progress : NULL,
                              warn_of_cache, choose_for_batch, line};
    if (!batch_run(line, &calls, result))
        return EXIT_ERROR;
    if (line->stats)
        print_counts(result);
    return EXIT_OK;
}

/* Opens a custom layout for all compilations; `line->compile.custom` is to be freed. */
static int use_layout(CommandLine *line)
{
    char *fault;
    if (line->folder && line->compile.layout && !strcmp(line->compile.layout, "auto"))
        return EXIT_OK; /* the batch derives the layout from its materials */
    MatcLayout *layout = layout_open(line, &fault);
    if (fault)
        main_fault(line, fault);
    free(fault);
    if (layout)
        fputs(matc_layout_diagnostics(layout, line->diagnostics), stderr);
    bool fine = !fault && (!layout || matc_layout_ok(layout));
    if (layout && fine && line->stats && !line->explain)
        fputs(matc_layout_report(layout), stderr);
    line->compile.custom = layout;
    return fine ? EXIT_OK : EXIT_ERROR;
}

static void free_layout(CommandLine *line)
{
    matc_layout_free((MatcLayout *)line->compile.custom);
    line->compile.custom = NULL;
}

static int run_inputs(CommandLine *line)
{
    int status = EXIT_OK;
    for (int i = 0; i < line->input_count; i++)
        status |= main_document(line, line->inputs[i]);
    return status;
}

/* Adds the files that a run reads before its documents. */
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
        watch_layout(line, status != EXIT_OK);
    if (status == EXIT_OK)
        status = line->folder ? run_batch(line, result) : run_inputs(line);
    free_layout(line);
    return status;
}

static int explain_layout(CommandLine *line)
{
    int status = use_layout(line);
    if (status == EXIT_OK)
        fputs(matc_layout_report(line->compile.custom), stdout);
    free_layout(line);
    return status;
}

static int answer(const CommandLine *line, char *text, const char *otherwise)
{
    if (!text)
        return main_usage(line, otherwise);
    fputs(text, stdout);
    free(text);
    return EXIT_OK;
}

/* Prints all kinds of names, or one kind: "--list=maps", "--list maps". */
static int print_list(CommandLine *line)
{
    const char *kind = *line->list ? line->list : line->input_count ? line->inputs[0] : "";
    return answer(line, *kind ? matc_list_of(kind) : matc_list(),
                  options_fault_list(&line->words, kind));
}

/* Returns the argument of `--list=` or `--schema=`; NULL: none. */
static const char *word_asked(const CommandLine *line)
{
    const char *given = line->schema ? line->schema : line->list;
    return given && *given && strcmp(given, OPTIONS_SCHEMA) ? given : NULL;
}

/* Returns true for queries about documents: --list=FILE, --list FILE..., --explain NAME FILE, and
 * --schema likewise. */
static bool asks_of_documents(const CommandLine *line)
{
    const char *word = word_asked(line), *first = word                ? word
                                                  : line->input_count ? line->inputs[0]
                                                                      : "";
    if (line->schema || line->list)
        return main_is_document(first);
    return line->explain && line->input_count;
}

static int answer_of_documents(CommandLine *line)
{
    int status = word_asked(line) ? main_definitions(line, word_asked(line)) : EXIT_OK;
    for (int i = 0; i < line->input_count; i++)
        status |= main_definitions(line, line->inputs[i]);
    return status;
}

static int print_cache(const CommandLine *line)
{
    if (!line->cache)
        return main_usage(line, "--cache-stats needs --cache or MATC_CACHE");
    char *text = cache_statistics(line->cache);
    if (!text)
        return main_complain(line, line->cache, text_error(errno));
    fputs(text, stdout);
    free(text);
    return EXIT_OK;
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
    return fault ? main_usage(line, fault) : EXIT_OK;
}

static bool read_command_line(CommandLine *line, int argc, char **argv, const char **fault)
{
    bool fine = options_read(line, argc, argv, fault);
    line->compile.pixels = line->eval || line->textures || line->pareto || line->max_error;
    line->compile.measure = line->stats;
    line->cache_named = line->cache != NULL;
    if (!line->cache && getenv("MATC_CACHE") && *getenv("MATC_CACHE"))
        line->cache = getenv("MATC_CACHE");
    return fine;
}

/* -- Watching */

static void run_and_tell(CommandLine *line, Watch *watch)
{
    BatchResult result;
    WatchList files = {0};
    double start = session_now();
    for (int i = 0; i < line->list_count; i++)
        watch_list_add(&files, line->lists[i]);
    if (line->compile.layout && layout_is_file(line->compile.layout))
        watch_list_add(&files, line->compile.layout);
    line->watched = &files;
    int status = run(line, &result);
    const long took = lround((session_now() - start) * 1e3);
    watch_set(watch, (const char *const *)files.at, files.count);
    const char *s = files.count == 1 ? "" : "s";
    if (status != EXIT_OK)
        fprintf(stderr, "matc: nothing written; watching %d file%s\n", files.count, s);
    else if (line->folder)
        fprintf(stderr, "matc: %d files written for %d materials in %ld ms; watching %d file%s\n",
                result.written, result.materials, took, files.count, s);
    else
        fprintf(stderr, "matc: %s in %ld ms; watching %d file%s\n", line->output, took, files.count,
                s);
    watch_list_free(&files);
}

/* Runs until a signal arrives. Lists of documents are reread each time. */
static int run_watching(CommandLine *line, int argc, char **argv)
{
    Watch *watch = watch_open();
    const char *fault;
    int signal;
    run_and_tell(line, watch);
    while (!(signal = watch_next(watch))) {
        options_free(line);
        if (!read_command_line(line, argc, argv, &fault))
            main_usage(line, fault);
        else if (check_usage(line) == EXIT_OK)
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
    int status = EXIT_OK;
    output_hold_streams();
    arena_keep_pages();
    if (!read_command_line(&line, argc, argv, &fault)) {
        status = main_usage(&line, fault);
        options_free(&line);
        return status;
    }
    if (line.help)
        print_help();
    else if (line.version)
        puts("matc " MATC_VERSION);
    else if (asks_of_documents(&line))
        status = answer_of_documents(&line);
    else if (line.schema)
        status = answer(&line, matc_schema(line.schema),
                        option_fault_value(&line.words, "--schema", line.schema,
                                           &(NameChoice){schema_name, NULL, 4}));
    else if (line.list)
        status = print_list(&line);
    else if (line.explain && layout_is_file(line.explain))
        status = explain_layout(&line);
    else if (line.explain)
        status = answer(&line, matc_explain(line.explain),
                        options_fault_explain(&line.words, line.explain));
    else if (line.cache_stats)
        status = print_cache(&line);
    else if ((status = check_usage(&line)) == EXIT_OK)
        status = line.watch ? run_watching(&line, argc, argv) : run(&line, &result);
    options_free(&line);
    /* another status means that the failure may have been reported */
    if ((fflush(stdout) || ferror(stdout)) && status == EXIT_OK)
        status = main_complain(&line, "standard output", text_error(errno));
    return status < BY_SIGNAL && status & USAGE ? USAGE : status;
}
