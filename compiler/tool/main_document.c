/* Processes one document: selects its material, measures it if requested, compiles or evaluates
 * it, and writes the result. */
#include "compiler/tool/main.h"
#include "compiler/base/file.h"
#include "compiler/base/progress.h"
#include "compiler/base/session.h"
#include "compiler/base/watch.h"
#include "compiler/tool/options_fault.h"
#include "compiler/tool/single.h"
#include "runtime/autotune/pareto.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static unsigned wanted_outputs(const CommandLine *line)
{
    unsigned outputs = line->stats ? MATC_STATS : 0;
    for (int emit = 0; emit < EMIT_COUNT; emit++)
        if (line->emit[emit])
            outputs |= emit_table[emit].output | options_emit_outputs(&line->compile, emit);
    return outputs;
}

/* State of the terminal's progress line. */
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
    fputs(progress_line(&text, what, session_now(), &shown->last), stderr);
    arena_free(&arena);
}

/* Returns the description of the variants to measure. */
static ParetoSubject subject_of(const CommandLine *line, const MatcDocument *document, int material,
                                Shown *shown)
{
    return (ParetoSubject){document,     material,
                           line->gl,     line->range > 0 ? line->range : measure_range,
                           line->output, isatty(STDERR_FILENO) ? show_measuring : NULL,
                           shown};
}

/* Reports a material that does not compile with the requested options; it is not measured. */
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

int main_choose(const CommandLine *line, const MatcDocument *document, int material,
                MatcOptions *options)
{
    ParetoChoice answer;
    *options = line->compile;
    if (!line->max_error)
        return EXIT_OK;
    if (is_refused(line, document, material))
        return EXIT_ERROR;
    Shown shown = {0};
    ParetoSubject subject = subject_of(line, document, material, &shown);
    bool chosen = pareto_choose(&subject, line->max_error, options, &answer);
    fputs(progress_erase(&shown.last), stderr);
    if (!chosen)
        return main_complain(line, "--max-error", answer.error);
    if (line->stats)
        fputs(answer.text, stderr);
    free(answer.text);
    return EXIT_OK;
}

static int print_pareto(const CommandLine *line, const MatcDocument *document, int material)
{
    ParetoChoice answer;
    if (is_refused(line, document, material))
        return EXIT_ERROR;
    Shown shown = {0};
    ParetoSubject subject = subject_of(line, document, material, &shown);
    bool measured = pareto_measure(&subject, &line->compile, &answer);
    fputs(progress_erase(&shown.last), stderr);
    if (!measured)
        return main_complain(line, "--pareto", answer.error);
    fputs(answer.text, stdout);
    free(answer.text);
    return EXIT_OK;
}

/* Compiles a material, and writes it if it has no fault. */
static int compile_material(const CommandLine *line, MatcDocument *document, int material)
{
    MatcOptions options;
    char path[SINGLE_PATH];
    if (main_choose(line, document, material, &options) != EXIT_OK)
        return EXIT_ERROR;
    MatcProgram *program = matc_compile(document, material, wanted_outputs(line), &options);
    fputs(matc_program_diagnostics(program, line->diagnostics), stderr);
    int status = matc_ok(program) ? EXIT_OK : EXIT_ERROR;
    if (status == EXIT_OK && line->stats)
        fputs(matc_output(program, MATC_STATS, NULL), stderr);
    const char *why = status == EXIT_OK ? single_write(line, document, program, path) : NULL;
    if (why)
        status = main_complain(line, path, why);
    matc_program_free(program);
    return status;
}

static int eval_material(const CommandLine *line, const MatcDocument *document, int material)
{
    const char *fault;
    char *values = matc_eval(document, material, line->eval, &line->compile, &fault);
    if (!values)
        return main_usage(line, fault);
    fputs(values, stdout);
    free(values);
    return EXIT_OK;
}

static void complain_of_several(const CommandLine *line, const MatcDocument *document)
{
    static const char why[] =
        "the document has several materials; name one with --material, or use -d";
    if (line->diagnostics == MATC_JSON) {
        main_complain(line, NULL, why);
        return;
    }
    fprintf(stderr, "matc: error: %s:\n", why);
    for (int i = 0; i < matc_material_count(document); i++)
        fprintf(stderr, "  %s\n", matc_material_name(document, i));
}

static const char *material_name(const void *document, int i)
{
    return matc_material_name(document, i);
}

static void complain_of_material(const CommandLine *line, const MatcDocument *document)
{
    Arena arena = {0};
    const NameChoice names = {material_name, document, matc_material_count(document)};
    main_complain(line, NULL, option_fault_value(&arena, "--material", line->material, &names));
    arena_free(&arena);
}

/* Returns the selected material, or -1 after reporting a fault. */
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
        return matc_error_count(document)
                   ? EXIT_ERROR
                   : main_complain(line, NULL, "the document has no material to compile");
    int material = choose_material(line, document);
    if (material < 0)
        return EXIT_ERROR;
    if (line->pareto)
        return print_pareto(line, document, material);
    return line->eval ? eval_material(line, document, material)
                      : compile_material(line, document, material);
}

static int write_tree(const CommandLine *line, MatcDocument *document)
{
    char path[SINGLE_PATH];
    const char *why = single_write(line, document, NULL, path);
    return why ? main_complain(line, path, why) : EXIT_OK;
}

/* Returns the command line's options with advice turned on, which is off in the library and in
 * batches. -Wno-linear_colors is placed after it and remains effective. */
static MatcOptions with_advice(const CommandLine *line, Arena *arena)
{
    MatcOptions options = line->compile;
    const char *given = options.warnings;
    Text settings = text_new(arena);
    text_format(&settings, "%s%s%s", diag_table[DIAG_linear_colors].name, given ? "," : "",
                given ? given : "");
    options.warnings = settings.at;
    return options;
}

int main_document(const CommandLine *line, const char *path)
{
    size_t size;
    const char *why;
    char *text = file_read_document(path, &size, &why);
    if (!text && line->watched)
        watch_list_add(line->watched, path);
    if (!text)
        return main_complain(line, path, why);
    Arena settings = {0};
    const MatcOptions options = with_advice(line, &settings);
    MatcDocument *document = matc_read(file_document_name(path), text, size, &options);
    free(text);
    fputs(matc_diagnostics(document, line->diagnostics), stderr);
    for (int i = 0; line->watched && i < matc_depend_count(document); i++)
        watch_list_add(line->watched, matc_depend(document, i));
    bool tree_only = line->emit[EMIT_tree] && !line->folder && !line->depend && !line->textures;
    int status = EXIT_ERROR;
    if (!tree_only)
        status = run_document(line, document);
    else if (!matc_error_count(document))
        status = write_tree(line, document);
    matc_document_free(document);
    arena_free(&settings);
    return status;
}
