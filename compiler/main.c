/* matc's command line: reads files, calls the library, writes what it made. The only file that prints or exits. */
#include "file.h"
#include "options.h"
#include "output.h"
#include "runtime/measure/pareto.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { FINE = 0, FAULT = 1, USAGE = 2, LONGEST_PATH = 4096, LONGEST_MESSAGE = 8192 };

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

/* Where an output of a material goes. */
static const char *output_path(const CommandLine *line, const char *material, const char *suffix, char *room)
{
    if (!line->folder)
        return line->output ? line->output : "-";
    snprintf(room, LONGEST_PATH, "%s/%s%s", line->folder, material, suffix);
    return room;
}

static const char *suffix_of(const CommandLine *line, int emit)
{
    bool spirv = emit == EMIT_glsl && line->compile.target && !strcmp(line->compile.target, "spirv");
    return emit_table[spirv ? EMIT_spirv : emit].suffix;
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
        MatcTexture texture = *matc_texture(program, i);
        if (texture.path)
            continue;
        snprintf(path, sizeof path, "%s/%s.ktx", line->textures, texture.name);
        const char *why = output_ktx(path, &texture);
        if (why)
            return complain(path, why);
    }
    return FINE;
}

static int write_outputs(const CommandLine *line, MatcDocument *document, MatcProgram *program, const char *name)
{
    char path[LONGEST_PATH];
    for (int emit = 0; emit < EMIT_COUNT; emit++) {
        size_t size = 0;
        if (!line->emit[emit])
            continue;
        const char *text =
            emit == EMIT_tree ? matc_tree_text(document) : matc_output(program, output_of(line, emit), &size);
        const char *to = output_path(line, name, suffix_of(line, emit), path);
        const char *why = output_write(to, text, emit == EMIT_tree ? strlen(text) : size);
        if (why)
            return complain(to, why);
    }
    return line->textures && program ? write_textures(line, program) : FINE;
}

static int write_depfile(const CommandLine *line, const MatcDocument *document, const char *name)
{
    char output[LONGEST_PATH], path[LONGEST_PATH + 2];
    int emit = 0;
    while (!line->emit[emit])
        emit++;
    const char *to = output_path(line, name, suffix_of(line, emit), output);
    snprintf(path, sizeof path, "%s.d", to);
    const char *depfile = line->depfile ? line->depfile : path;
    const char *why = output_depfile(depfile, line->target ? line->target : to, document);
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

/* Two materials of one name would overwrite each other in the folder of -d. */
static bool take_name(const CommandLine *line, const char *name)
{
    for (int i = 0; line->folder && i < line->taken->count; i++)
        if (!strcmp(line->taken->at[i], name))
            return false;
    char **more = realloc(line->taken->at, sizeof *more * (size_t)(line->taken->count + 1));
    if (!more || !(more[line->taken->count] = strdup(name)))
        abort();
    line->taken->at = more;
    line->taken->count++;
    return true;
}

static int write_material(const CommandLine *line, MatcDocument *document, MatcProgram *program, const char *name)
{
    if (!take_name(line, name))
        return complain(name, "a material of this name was written to the folder already");
    int status = write_outputs(line, document, program, name);
    return status == FINE && line->depend ? write_depfile(line, document, name) : status;
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

/* Compiles a document's materials, all or the one that is meant; writes them if none has a fault. */
static int compile_materials(const CommandLine *line, MatcDocument *document, int only)
{
    int count = matc_material_count(document), status = FINE;
    MatcProgram **programs = calloc((size_t)count, sizeof *programs);
    if (!programs)
        abort();
    for (int i = 0; i < count; i++) {
        MatcOptions options;
        if (only >= 0 && i != only)
            continue;
        if (choose_options(line, document, i, &options) != FINE) {
            status = FAULT;
            continue;
        }
        programs[i] = matc_compile(document, i, wanted_outputs(line), &options);
        print_diagnostics(matc_program_diagnostics(programs[i], line->diagnostics), line);
        if (!matc_ok(programs[i]))
            status = FAULT;
        else if (line->stats)
            fputs(matc_output(programs[i], MATC_STATS, NULL), stderr);
    }
    for (int i = 0; i < count && status == FINE; i++)
        if (programs[i])
            status = write_material(line, document, programs[i], matc_material_name(document, i));
    for (int i = 0; i < count; i++)
        matc_program_free(programs[i]);
    free(programs);
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

/* The material that is meant, or -1: all of them, which only -d can take. -2: a fault, reported. */
static int choose_material(const CommandLine *line, const MatcDocument *document)
{
    if (line->material) {
        int found = matc_material_find(document, line->material);
        if (found < 0)
            complain(line->material, "no such material in the document");
        return found < 0 ? -2 : found;
    }
    if (matc_material_count(document) == 1)
        return 0;
    if (line->folder && !line->eval && !line->pareto)
        return -1;
    fputs("matc: error: the document has several materials; name one with --material, or use -d:\n", stderr);
    for (int i = 0; i < matc_material_count(document); i++)
        fprintf(stderr, "  %s\n", matc_material_name(document, i));
    return -2;
}

static int run_document(const CommandLine *line, MatcDocument *document)
{
    if (!matc_material_count(document))
        return FAULT;
    int material = choose_material(line, document);
    if (material == -2)
        return FAULT;
    if (line->pareto)
        return print_pareto(line, document, material);
    return line->eval ? eval_material(line, document, material) : compile_materials(line, document, material);
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
        status = write_outputs(line, document, NULL, "");
    matc_document_free(document);
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
    if (line->pareto && (line->max_error || line->eval || line->folder || line->input_count > 1))
        return "--pareto takes one document, and neither --max-error, --eval nor -d";
    return NULL;
}

static int check_usage(const CommandLine *line)
{
    static char room[128];
    const char *fault = matc_options_fault(&line->compile);
    int emits = 0;
    for (int i = 0; i < EMIT_COUNT; i++)
        emits += line->emit[i];
    if (fault) {
        snprintf(room, sizeof room, "--%s names what does not exist", fault);
        return usage(room);
    }
    if (!line->input_count)
        return usage("no document");
    if ((fault = check_measuring(line)))
        return usage(fault);
    if (line->folder && strlen(line->folder) > LONGEST_PATH / 2)
        return usage("the folder's name is too long");
    if (line->output && line->folder)
        return usage("-o and -d exclude each other");
    if (line->output && line->input_count > 1)
        return usage("several documents need -d, not -o");
    if (!emits)
        return usage("--emit names nothing");
    if (emits > 1 && !line->folder)
        return usage("several outputs need -d");
    if (line->depend && !line->folder && (!line->output || !strcmp(line->output, "-")) && !line->depfile)
        return usage("-MD needs -o, -d or -MF");
    return FINE;
}

int main(int argc, char **argv)
{
    CommandLine line;
    Names taken = {0};
    const char *fault;
    if (!options_read(&line, argc, argv, &fault)) {
        free(line.inputs);
        return usage(fault ? fault : "out of memory");
    }
    line.compile.pixels = line.eval || line.textures || line.pareto || line.max_error;
    line.compile.measure = line.stats;
    line.taken = &taken;
    int status = FINE;
    if (line.help)
        fputs(options_help, stdout);
    else if (line.version)
        puts("matc " MATC_VERSION);
    else if (line.schema)
        status = answer(matc_schema(), "");
    else if (line.list)
        status = answer(matc_list(), "");
    else if (line.explain)
        status = answer(matc_explain(line.explain), "nothing has that name; see --list");
    else if ((status = check_usage(&line)) == FINE) {
        if (line.folder && mkdir(line.folder, 0777) && errno != EEXIST)
            status = complain(line.folder, strerror(errno));
        for (int i = 0; i < line.input_count; i++)
            status |= run_input(&line, line.inputs[i]);
    }
    for (int i = 0; i < taken.count; i++)
        free(taken.at[i]);
    free(taken.at);
    free(line.inputs);
    if (fflush(stdout) || ferror(stdout))
        status |= complain("standard output", strerror(errno));
    return status & USAGE ? USAGE : status;
}
