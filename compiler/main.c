/* matc's command line: reads files, calls the library, writes what it made. The only file that prints or exits. */
#include "batch.h"
#include "compile.h"
#include "file.h"
#include "layout_option.h"
#include "options.h"
#include "output.h"
#include "runtime/measure/pareto.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { FINE = 0, FAULT = 1, USAGE = 2, LONGEST_PATH = 4096, LONGEST_MESSAGE = 8192, PROGRESS_STEP = 16 };

static int complain(const char *what, const char *why)
{
    fprintf(stderr, "matc: error: %s: %s\n", what, why);
    return FAULT;
}

static int usage(const char *what)
{
    fprintf(stderr, "matc: %s; see matc --help\n", what);
    return USAGE;
}

static void print_diagnostics(const char *text, const CommandLine *line)
{
    if (line->diagnostics == MATC_TEXT || strcmp(text, "[]\n") != 0)
        fputs(text, stderr);
}

/* The target spirv means SPIR-V where GLSL would be written. */
static MatcOutput output_of(const CommandLine *line, int emit)
{
    bool spirv = emit == EMIT_glsl && line->compile.target && !strcmp(line->compile.target, "spirv");
    return spirv ? MATC_SPIRV : (MatcOutput)emit_table[emit].output;
}

static int write_textures(const CommandLine *line, MatcProgram *program)
{
    char path[LONGEST_PATH];
    for (int i = 0; i < matc_texture_count(program); i++) {
        const MatcTexture *texture = matc_texture(program, i);
        size_t size;
        if (texture->path)
            continue;
        snprintf(path, sizeof path, "%s/%s.ktx", line->textures, texture->name);
        char *bytes = output_ktx(texture, &size);
        const char *why = output_write(path, bytes, size);
        free(bytes);
        if (why)
            return complain(path, why);
    }
    return FINE;
}

static int first_emit(const CommandLine *line)
{
    int emit = 0;
    while (!line->emit[emit])
        emit++;
    return emit;
}

static int write_output(const CommandLine *line, MatcDocument *document, MatcProgram *program)
{
    int emit = first_emit(line);
    size_t size = 0;
    const char *to = line->output ? line->output : "-";
    const char *text =
        emit == EMIT_tree ? matc_tree_text(document) : matc_output(program, output_of(line, emit), &size);
    const char *why = output_write(to, text, emit == EMIT_tree ? strlen(text) : size);
    if (why)
        return complain(to, why);
    return line->textures && program ? write_textures(line, program) : FINE;
}

static int write_depfile(const CommandLine *line, const MatcDocument *document)
{
    char path[LONGEST_PATH + 2];
    const char *to = line->output ? line->output : "-";
    int count = matc_depend_count(document);
    const char **files = calloc((size_t)count + 1, sizeof *files);
    if (!files)
        abort();
    snprintf(path, sizeof path, "%s.d", to);
    for (int i = 0; i < count; i++)
        files[i] = matc_depend(document, i);
    if (line->compile.layout && layout_is_file(line->compile.layout))
        files[count++] = line->compile.layout;
    const char *depfile = line->depfile ? line->depfile : path;
    const char *why = output_depfile(depfile, line->target ? line->target : to, files, count);
    free(files);
    return why ? complain(depfile, why) : FINE;
}

static unsigned wanted_outputs(const CommandLine *line)
{
    unsigned outputs = line->stats ? MATC_STATS : 0;
    for (int emit = 0; emit < EMIT_COUNT; emit++)
        if (line->emit[emit])
            outputs |= emit_table[emit].output | output_of(line, emit);
    return outputs;
}

/* What is measured; check_usage has seen the numbers. */
static ParetoSubject subject_of(const CommandLine *line, const MatcDocument *document, int material)
{
    ParetoSubject subject = {document, material, GL_KIND_osmesa,
                             line->range ? strtod(line->range, NULL) : measure_range};
    if (line->gl)
        gl_kind_find(line->gl, &subject.gl);
    return subject;
}

/* The options that a material is compiled with: with --max-error, those that measuring finds. */
static int choose_options(const CommandLine *line, const MatcDocument *document, int material, MatcOptions *options)
{
    char error[LONGEST_MESSAGE], *why;
    *options = line->compile;
    if (!line->max_error)
        return FINE;
    ParetoSubject subject = subject_of(line, document, material);
    if (!pareto_choose(&subject, strtod(line->max_error, NULL), options, &why, error, sizeof error))
        return complain("--max-error", error);
    if (line->stats)
        fputs(why, stderr);
    free(why);
    return FINE;
}

static int print_pareto(const CommandLine *line, const MatcDocument *document, int material)
{
    char error[LONGEST_MESSAGE], *table;
    ParetoSubject subject = subject_of(line, document, material);
    if (!pareto_measure(&subject, &line->compile, line->output, &table, error, sizeof error))
        return complain("--pareto", error);
    fputs(table, stdout);
    free(table);
    return FINE;
}

/* Compiles a material, and writes it if it has no fault. */
static int compile_material(const CommandLine *line, MatcDocument *document, int material)
{
    MatcOptions options;
    if (choose_options(line, document, material, &options) != FINE)
        return FAULT;
    MatcProgram *program = matc_compile(document, material, wanted_outputs(line), &options);
    print_diagnostics(matc_program_diagnostics(program, line->diagnostics), line);
    int status = matc_ok(program) ? FINE : FAULT;
    if (status == FINE && line->stats)
        fputs(matc_output(program, MATC_STATS, NULL), stderr);
    if (status == FINE)
        status = write_output(line, document, program);
    if (status == FINE && line->depend)
        status = write_depfile(line, document);
    matc_program_free(program);
    return status;
}

static int eval_material(const CommandLine *line, const MatcDocument *document, int material)
{
    const char *fault;
    char *values = matc_eval(document, material, line->eval, &line->compile, &fault);
    if (!values)
        return usage(fault);
    fputs(values, stdout);
    free(values);
    return FINE;
}

/* The material that is meant, or -1: a fault, reported. */
static int choose_material(const CommandLine *line, const MatcDocument *document)
{
    if (line->material) {
        int found = matc_material_find(document, line->material);
        if (found < 0)
            complain(line->material, "no such material in the document");
        return found;
    }
    if (matc_material_count(document) == 1)
        return 0;
    fputs("matc: error: the document has several materials; name one with --material, or use -d:\n", stderr);
    for (int i = 0; i < matc_material_count(document); i++)
        fprintf(stderr, "  %s\n", matc_material_name(document, i));
    return -1;
}

static int run_document(const CommandLine *line, MatcDocument *document)
{
    if (!matc_material_count(document))
        return FAULT;
    int material = choose_material(line, document);
    if (material < 0)
        return FAULT;
    if (line->pareto)
        return print_pareto(line, document, material);
    return line->eval ? eval_material(line, document, material) : compile_material(line, document, material);
}

static int run_input(const CommandLine *line, const char *path)
{
    size_t size;
    const char *why;
    char *text = strcmp(path, "-") ? file_read(path, &size, &why) : file_read_from(STDIN_FILENO, &size, &why);
    if (!text)
        return complain(path, why);
    MatcDocument *document = matc_read(strcmp(path, "-") ? path : "<stdin>", text, size, &line->compile);
    free(text);
    print_diagnostics(matc_diagnostics(document, line->diagnostics), line);
    bool tree_only = line->emit[EMIT_tree] && !line->folder && !line->depend && !line->textures;
    int status = FAULT;
    if (!tree_only)
        status = run_document(line, document);
    else if (matc_material_count(document))
        status = write_output(line, document, NULL);
    matc_document_free(document);
    return status;
}

/* -- a batch */

static void say(void *user, const char *text)
{
    const CommandLine *line = user;
    if (isatty(STDERR_FILENO))
        fputs("\r\033[K", stderr); /* over the progress */
    print_diagnostics(text, line);
}

static void show_progress(void *user, int done, int documents)
{
    (void)user;
    if (done % PROGRESS_STEP == 0 || done == documents)
        fprintf(stderr, "\r%d of %d documents%s", done, documents, done == documents ? "\r\033[K" : "");
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

static int run_batch(CommandLine *line)
{
    BatchResult result;
    const BatchCalls calls = {say, isatty(STDERR_FILENO) && line->input_count > 1 ? show_progress : NULL,
                              choose_for_batch, line};
    if (!batch_run(line, &calls, &result))
        return FAULT;
    if (line->stats)
        print_counts(&result);
    return FINE;
}

static int run(CommandLine *line)
{
    int status = FINE;
    if (line->folder)
        return run_batch(line);
    for (int i = 0; i < line->input_count; i++)
        status |= run_input(line, line->inputs[i]);
    return status;
}

/* A layout of one's own, for all that follows. `line->compile.custom` is to be freed. */
static int use_layout(CommandLine *line)
{
    char *fault;
    MatcLayout *layout = layout_open(line, &fault);
    if (fault)
        fprintf(stderr, strchr(fault, '\n') ? "%s" : "matc: error: %s\n", fault);
    free(fault);
    if (layout)
        print_diagnostics(matc_layout_diagnostics(layout, line->diagnostics), line);
    bool fine = !fault && (!layout || matc_layout_ok(layout));
    if (layout && fine && line->stats && !line->explain)
        fputs(matc_layout_report(layout), stderr);
    line->compile.custom = layout;
    return fine ? FINE : FAULT;
}

static int explain_layout(CommandLine *line)
{
    int status = use_layout(line);
    if (status == FINE)
        fputs(matc_layout_report(line->compile.custom), stdout);
    return status;
}

static int answer(char *text, const char *otherwise)
{
    if (!text)
        return usage(otherwise);
    fputs(text, stdout);
    free(text);
    return FINE;
}

/* NULL, or what is wrong. */
static const char *check_measuring(const CommandLine *line)
{
    char *end = NULL;
    if (line->max_error && (!(strtod(line->max_error, &end) > 0) || *end))
        return "--max-error wants a number above 0";
    if (line->range && (!(strtod(line->range, &end) > 0) || *end || strtod(line->range, &end) > 1e30))
        return "--range wants a number above 0";
    if (line->gl && !gl_kind_find(line->gl, &(GlKind){0}))
        return "--gl: osmesa or egl";
    if (line->max_error && line->compile.pass && strcmp(line->compile.pass, "gbuffer") != 0)
        return "--max-error is of the pass gbuffer";
    if ((line->pareto || line->max_error) && layout_is_custom(line->compile.layout))
        return "--pareto and --max-error know the built-in layouts only";
    if (line->pareto && (line->max_error || line->eval || line->folder || line->input_count > 1))
        return "--pareto takes one document, and neither --max-error, --eval nor -d";
    return NULL;
}

/* NULL, or what is wrong. */
static const char *check_output(const CommandLine *line)
{
    int emits = 0;
    for (int i = 0; i < EMIT_COUNT; i++)
        emits += line->emit[i];
    if (line->folder && strlen(line->folder) > LONGEST_PATH / 2)
        return "the folder's name is too long";
    if (line->output && line->folder)
        return "-o and -d exclude each other";
    if (line->input_count > 1 && !line->folder)
        return line->output ? "several documents need -d, not -o" : "several documents need -d";
    if (!emits)
        return "--emit names nothing";
    if (emits > 1 && !line->folder)
        return "several outputs need -d";
    if (line->pass_count > 1 && !line->folder)
        return "several passes need -d";
    if (line->eval && line->folder)
        return "--eval prints, and does not go with -d";
    if (line->depend && !line->folder && (!line->output || !strcmp(line->output, "-")) && !line->depfile)
        return "-MD needs -o, -d or -MF";
    return NULL;
}

static int check_usage(const CommandLine *line)
{
    char room[LONGEST_MESSAGE];
    const char *fault = NULL;
    for (int i = 0; i < line->pass_count && !fault; i++) {
        MatcOptions options = line->compile;
        options.pass = line->passes[i];
        if (layout_is_custom(options.layout))
            options.layout = NULL; /* use_layout looks at it */
        fault = matc_options_fault(&options);
    }
    if (fault) {
        snprintf(room, sizeof room, "--%s names what does not exist", fault);
        return usage(room);
    }
    if (!line->input_count)
        return usage("no document");
    if ((fault = check_measuring(line)) || (fault = check_output(line)))
        return usage(fault);
    return FINE;
}

int main(int argc, char **argv)
{
    CommandLine line;
    const char *fault;
    if (!options_read(&line, argc, argv, &fault)) {
        options_free(&line);
        return usage(fault);
    }
    line.compile.pixels = line.eval || line.textures || line.pareto || line.max_error;
    line.compile.measure = line.stats;
    int status = FINE;
    if (line.help)
        fputs(options_help, stdout);
    else if (line.version)
        puts("matc " MATC_VERSION);
    else if (line.schema)
        status = answer(matc_schema(), "");
    else if (line.list)
        status = answer(matc_list(), "");
    else if (line.explain && layout_is_file(line.explain))
        status = explain_layout(&line);
    else if (line.explain)
        status = answer(matc_explain(line.explain), "nothing has that name; see --list");
    else if ((status = check_usage(&line)) == FINE && (status = use_layout(&line)) == FINE)
        status = run(&line);
    matc_layout_free((MatcLayout *)line.compile.custom);
    options_free(&line);
    if (fflush(stdout) || ferror(stdout))
        status |= complain("standard output", strerror(errno));
    return status & USAGE ? USAGE : status;
}
