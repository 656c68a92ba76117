/* The command line: one table of options. */
#include "compiler/tool/options_fault.h"
#include "compiler/base/memory.h"
#include "compiler/tool/options_input.h"
#include "compiler/choice.h"
#include "compiler/base/file.h"
#include "compiler/base/queue.h"
#include "compiler/base/suggest.h"
#include "compiler/base/warnings.h"
#include "compiler/base/text.h"
#include <stddef.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

const EmitRow emit_table[EMIT_COUNT] = {
    {"glsl", ".frag", MATC_FRAGMENT, NULL},
    {"vertex", ".vert", MATC_VERTEX, ".vert.spv"},
    {"unpack", ".unpack.glsl", MATC_UNPACK, NULL},
    {"reflect", ".json", MATC_REFLECT, NULL},
    {"spirv", ".spv", MATC_SPIRV, NULL},
    {"ir", ".ir", MATC_IR, NULL},
    {"dot", ".dot", MATC_DOT, NULL},
    {"layout", ".layout.yaml", MATC_LAYOUT, NULL},
    {"tessvertex", ".tess.vert", MATC_TESSVERTEX, ".tess.vert.spv"},
    {"tesscontrol", ".tesc", MATC_TESSCONTROL, ".tesc.spv"},
    {"tesseval", ".tese", MATC_TESSEVAL, ".tese.spv"},
    {"geometryvertex", ".geom.vert", MATC_GEOMETRYVERTEX, ".geom.vert.spv"},
    {"geometry", ".geom", MATC_GEOMETRY, ".geom.spv"},
    {"displace", ".displace.glsl", MATC_DISPLACE, NULL},
    {"compute", ".comp", MATC_COMPUTE, ".comp.spv"},
    {"tree", ".tree", 0, NULL},
};

typedef enum {
    TAKES_text,
    TAKES_compile,
    TAKES_flag,
    TAKES_emit,
    TAKES_form,
    TAKES_novalidate,
    TAKES_maybe,
    TAKES_warning,
    TAKES_folder
} Takes;
typedef struct {
    const char *name;
    Takes takes;
    size_t member;
    const char *otherwise; /* of what may have a value: the one it has without */
} Option;

#define TEXT(name, member)                                                                                             \
    {                                                                                                                  \
        name, TAKES_text, offsetof(CommandLine, member), NULL                                                          \
    }
#define FLAG(name, member)                                                                                             \
    {                                                                                                                  \
        name, TAKES_flag, offsetof(CommandLine, member), NULL                                                          \
    }
static const Option options[] = {
    TEXT("-o", output),
    TEXT("-d", folder),
    TEXT("-j", jobs),
    TEXT("--cache", cache),
    TEXT("--cache-limit", cache_size),
    FLAG("--cache-stats", cache_stats),
    FLAG("-MD", depend),
    TEXT("-MF", depfile),
    TEXT("-MT", target),
    {"--target", TAKES_compile, 0, NULL},
    {"--pass", TAKES_compile, 0, NULL},
    {"--slot", TAKES_compile, 0, NULL},
    {"--layout", TAKES_compile, 0, NULL},
    {"--normals", TAKES_compile, 0, NULL},
    {"--precision", TAKES_compile, 0, NULL},
    {"--constants", TAKES_compile, 0, NULL},
    {"--noise", TAKES_compile, 0, NULL},
    {"--aa", TAKES_compile, 0, NULL},
    {"--derivatives", TAKES_compile, 0, NULL},
    {"--coordinates", TAKES_compile, 0, NULL},
    {"--powers", TAKES_compile, 0, NULL},
    {"--trigonometry", TAKES_compile, 0, NULL},
    TEXT("--layout-error", layout_error),
    TEXT("--cases", cases),
    TEXT("--material", material),
    TEXT("--eval", eval),
    TEXT("--explain", explain),
    TEXT("--textures", textures),
    TEXT("--max-error", max_error),
    TEXT("--range", range),
    TEXT("--gl", gl),
    FLAG("--pareto", pareto),
    {"--emit", TAKES_emit, 0, NULL},
    {"--diagnostics", TAKES_form, 0, NULL},
    {"--no-validate", TAKES_novalidate, 0, NULL},
    {"-W", TAKES_warning, 0, NULL},
    {"-I", TAKES_folder, 0, NULL},
    TEXT("--root", compile.root),
    FLAG("--check", compile.check),
    {"--list", TAKES_maybe, offsetof(CommandLine, list), ""},
    {"--schema", TAKES_maybe, offsetof(CommandLine, schema), OPTIONS_SCHEMA},
    FLAG("--stats", stats),
    FLAG("--watch", watch),
    FLAG("--help", help),
    FLAG("-h", help),
    FLAG("--version", version),
};
enum { OPTION_COUNT = sizeof options / sizeof *options };

static const char *emit_name(const void *user, int i)
{
    (void)user;
    return emit_table[i].name;
}

static const char *form_name(const void *user, int i)
{
    (void)user;
    return i ? "json" : "text";
}

static const char *option_name(const void *user, int i)
{
    (void)user;
    return options[i].name;
}

static bool read_emit(CommandLine *line, const char *list, const char **fault)
{
    memset(line->emit, 0, sizeof line->emit);
    line->emit_named = true;
    for (size_t size; *list; list += size + (list[size] == ',')) {
        size = strcspn(list, ",");
        int i = 0;
        while (i < EMIT_COUNT && (strlen(emit_table[i].name) != size || strncmp(emit_table[i].name, list, size) != 0))
            i++;
        if (i == EMIT_COUNT) {
            const char *word = arena_string(&line->words, list, size);
            *fault = options_fault_value(&line->words, "--emit", word, &(NameChoice){emit_name, NULL, EMIT_COUNT});
            return false;
        }
        line->emit[i] = true;
    }
    return true;
}

/* "-Wno-a -Werror": "no-a,error" */
static bool add_warning(CommandLine *line, const char *setting, const char **fault)
{
    const char *before = line->compile.warnings;
    size_t size;
    Text all = text_new(&line->words);
    text_format(&all, "%s%s%s", before ? before : "", before ? "," : "", setting);
    line->compile.warnings = all.at;
    const char *wrong = warnings_fault(setting, &size);
    if (!wrong)
        return true;
    const char *name = strrchr(wrong, '=') ? strrchr(wrong, '=') + 1 : strncmp(wrong, "no-", 3) ? wrong : wrong + 3;
    *fault = options_fault_warning(&line->words, name);
    return false;
}

static void add_folder(CommandLine *line, const char *folder)
{
    const char **folders = ARENA_ARRAY(&line->words, const char *, line->compile.include_count + 1);
    for (int i = 0; i < line->compile.include_count; i++)
        folders[i] = line->compile.include[i];
    folders[line->compile.include_count++] = folder;
    line->compile.include = folders;
}

static bool set_option(CommandLine *line, const Option *option, const char *value, const char **fault)
{
    char *member = (char *)line + option->member;
    switch (option->takes) {
    case TAKES_text:
        *(const char **)(void *)member = value;
        return true;
    case TAKES_maybe:
        *(const char **)(void *)member = value ? value : option->otherwise;
        return true;
    case TAKES_compile:
        return choice_set(&line->compile, option->name + 2, value); /* options_check looks at it */
    case TAKES_flag:
        *(bool *)member = true;
        return true;
    case TAKES_novalidate:
        line->compile.validate = false;
        return true;
    case TAKES_emit:
        return read_emit(line, value, fault);
    case TAKES_folder:
        add_folder(line, value);
        return true;
    case TAKES_warning:
        return add_warning(line, value, fault);
    case TAKES_form:
        line->diagnostics = !strcmp(value, "json") ? MATC_JSON : MATC_TEXT;
        *fault = options_fault_value(&line->words, "--diagnostics", value, &(NameChoice){form_name, NULL, 2});
        return !strcmp(value, "json") || !strcmp(value, "text");
    }
    return false;
}

static bool takes_value(const Option *option)
{
    return option->takes == TAKES_text || option->takes == TAKES_compile || option->takes == TAKES_emit ||
           option->takes == TAKES_form || option->takes == TAKES_maybe || option->takes == TAKES_warning ||
           option->takes == TAKES_folder;
}

static const char *lacks_value(CommandLine *line, const Option *option)
{
    Text out = text_new(&line->words);
    NameChoice values;
    text_format(&out, "%s wants a value", option->name);
    if (option->takes == TAKES_compile && options_fault_values(option->name + 2, &values))
        text_format(&out, ": %s", suggest_list(&line->words, &values));
    return out.at;
}

static const char *unknown_option(CommandLine *line, const char *arg)
{
    const char *name = arena_string(&line->words, arg, strcspn(arg, "="));
    Text out = text_new(&line->words);
    if (!strncmp(arg, "-O", 2))
        return options_fault_level(&line->words, arg + 2);
    for (int i = 0; i < OPTION_COUNT; i++)
        if (!strcmp(options[i].name, name)) {
            text_format(&out, "%s takes no value", name);
            return out.at;
        }
    text_format(&out, "there is no option '%s'%s", name, suggest(&line->words, name, option_name, NULL, OPTION_COUNT));
    return out.at;
}

/* "--name value", "--name=value", and "-oFILE" as compilers have it. */
static bool read_option(CommandLine *line, char **argv, int *i, const char **fault)
{
    const char *arg = argv[*i];
    for (int k = 0; k < OPTION_COUNT; k++) {
        const Option *option = &options[k];
        size_t size = strlen(option->name);
        if (strncmp(arg, option->name, size) != 0)
            continue;
        if (!arg[size] && (!takes_value(option) || option->takes == TAKES_maybe))
            return set_option(line, option, NULL, fault);
        if (!takes_value(option))
            continue;
        if (!arg[size] && !argv[*i + 1]) {
            *fault = lacks_value(line, option);
            return false;
        }
        if (!arg[size])
            return set_option(line, option, argv[++*i], fault);
        if (arg[size] == '=' && size > 2)
            return set_option(line, option, arg + size + 1, fault);
        if (size == 2)
            return set_option(line, option, arg + size, fault);
    }
    *fault = unknown_option(line, arg);
    return false;
}

static bool read_level(CommandLine *line, const char *arg)
{
    if (strncmp(arg, "-O", 2) != 0 || (arg[2] && arg[3]) || !strchr("0123s", arg[2]))
        return false; /* strchr finds the end of "-O" too */
    line->compile.optimize = arg[2] == '0' || arg[2] == '1' ? arg[2] - '0' : 2;
    return true;
}

static int emit_row(const MatcOptions *options, int emit)
{
    const TargetRow *target = choice_target(options);
    return emit == EMIT_glsl && target && target->spirv ? EMIT_spirv : emit;
}

static bool is_spirv(const MatcOptions *options, int emit)
{
    const TargetRow *target = choice_target(options);
    return emit_table[emit].spirv && target && target->spirv;
}

unsigned options_emit_outputs(const MatcOptions *options, int emit)
{
    return emit_table[emit_row(options, emit)].output | (is_spirv(options, emit) ? MATC_SPIRV : 0);
}

const char *options_emit_text(const MatcOptions *options, int emit, const MatcProgram *program, size_t *size)
{
    const MatcOutput output = (MatcOutput)emit_table[emit_row(options, emit)].output;
    return is_spirv(options, emit) ? matc_spirv(program, output, size) : matc_output(program, output, size);
}

const char *options_emit_suffix(const MatcOptions *options, int emit)
{
    return is_spirv(options, emit) ? emit_table[emit].spirv : emit_table[emit_row(options, emit)].suffix;
}

double options_number(const char *text, double otherwise)
{
    double number;
    return !text ? otherwise : text_number(text, strlen(text), &number) ? number : NAN;
}

/* A whole number from 1 to the most; NULL is none. */
static bool read_count(const char *text, long most, long *count)
{
    char *end = NULL;
    if (!text)
        return true;
    *count = strtol(text, &end, 10);
    if (*count > most)
        *count = most;
    return end != text && !*end && *count >= 1;
}

static bool read_counts(CommandLine *line, const char **fault)
{
    const long most_mib = 1l << 40;
    long threads = 0;
    if (!read_count(line->jobs, MOST_THREADS, &threads)) {
        *fault = options_fault_number(&line->words, "-j wants a number of threads, from 1 on", line->jobs);
        return false;
    }
    line->threads = (int)threads;
    if (read_count(line->cache_size, most_mib, &line->cache_limit))
        return true;
    *fault = options_fault_number(&line->words, "--cache-limit wants a number of MiB, from 1 on", line->cache_size);
    return false;
}

/* "gbuffer,shadow" */
static bool read_passes(CommandLine *line, const char **fault)
{
    const char *list = line->compile.pass ? line->compile.pass : "gbuffer";
    char *at = line->pass_list = strdup(list);
    if (!at)
        memory_exhausted();
    *fault = "--pass names too many passes";
    for (char *next; at; at = next) {
        if ((next = strchr(at, ',')))
            *next++ = 0;
        for (int i = 0; i < line->pass_count; i++)
            if (!strcmp(line->passes[i], at)) {
                *fault = "--pass names a pass twice";
                return false;
            }
        if (line->pass_count == MOST_PASSES)
            return false;
        line->passes[line->pass_count++] = at;
    }
    return true;
}

void options_free(CommandLine *line)
{
    arena_free(&line->words);
    free(line->pass_list);
    for (int i = 0; i < line->list_count; i++)
        free(line->list_texts[i]);
    free(line->list_texts);
    free(line->lists);
    free(line->inputs);
}

/* A fault of an option is said in the form that one behind it asks for. */
static MatcForm form_asked_for(int argc, char **argv)
{
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++)
        if (!strcmp(argv[i], "--diagnostics=json"))
            return MATC_JSON;
    return MATC_TEXT;
}

bool options_read(CommandLine *line, int argc, char **argv, const char **fault)
{
    *line = (CommandLine){0};
    matc_options_init(&line->compile);
    line->emit[EMIT_glsl] = true;
    line->diagnostics = form_asked_for(argc, argv);
    *fault = NULL;
    bool only_files = false;
    for (int i = 1; i < argc; i++) {
        const char *arg = argv[i];
        if (!only_files && !strcmp(arg, "--"))
            only_files = true;
        else if (!only_files && arg[0] == '@') {
            if (!options_read_list(line, arg + 1, fault))
                return false;
        } else if (only_files || arg[0] != '-' || !arg[1])
            options_add_input(line, arg);
        else if (!read_level(line, arg) && !read_option(line, argv, &i, fault))
            return false;
    }
    if (!read_counts(line, fault) || !read_passes(line, fault))
        return false;
    *fault = NULL;
    return true;
}
