/* matc's command line: the table of its options, from which --help is generated. */
#include "compiler/base/file.h"
#include "compiler/base/memory.h"
#include "compiler/base/option.h"
#include "compiler/base/queue.h"
#include "compiler/base/warnings.h"
#include "compiler/choice.h"
#include "compiler/tool/options_fault.h"
#include "runtime/gl/context.h"
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stddef.h>
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

static const char *emit_name(const void *user, int i)
{
    (void)user;
    return emit_table[i].name;
}

static const char *gl_name(const void *user, int i)
{
    (void)user;
    return gl_kind_name((GlKind)i);
}

/* -- Values without an option kind of their own */

static const char *set_choice(void *to, const Option *option, const char *value)
{
    CommandLine *line = to;
    choice_set(&line->compile, option->name + 2, value); /* options_check validates the choice */
    return NULL;
}

static const char *level_name(const void *user, int i)
{
    static const char *const names[] = {"0", "1", "2"};
    (void)user;
    return names[i];
}

/* Sets the level of "-O", "-O0" to "-O3", "-Os". */
static const char *set_level(void *to, const Option *option, const char *level)
{
    CommandLine *line = to;
    if (level && (!level[0] || level[1] || !strchr("0123s", level[0])))
        return option_fault_value(&line->words, option->name, level,
                                  &(NameChoice){level_name, NULL, 3});
    line->compile.optimize = level && (level[0] == '0' || level[0] == '1') ? level[0] - '0' : 2;
    return NULL;
}

/* Collects "-Wno-a -Werror" as "no-a,error". */
static const char *add_warning(void *to, const Option *option, const char *setting)
{
    CommandLine *line = to;
    const char *before = line->compile.warnings;
    size_t size;
    Text all = text_new(&line->words);
    text_format(&all, "%s%s%s", before ? before : "", before ? "," : "", setting);
    line->compile.warnings = all.at;
    const char *wrong = warnings_fault(setting, &size);
    if (!wrong)
        return NULL;
    const char *name = strrchr(wrong, '=')        ? strrchr(wrong, '=') + 1
                       : strncmp(wrong, "no-", 3) ? wrong
                                                  : wrong + 3;
    return option_fault_value(&line->words, option->name, name,
                              &(NameChoice){warnings_name, NULL, DIAG_COUNT});
}

static void add_input(CommandLine *line, const char *path)
{
    enum { STEP = 256 };
    if (line->input_count % STEP == 0) {
        line->inputs =
            realloc(line->inputs, sizeof *line->inputs * (size_t)(line->input_count + STEP));
        if (!line->inputs)
            memory_exhausted();
    }
    line->inputs[line->input_count++] = path;
}

/* Reads "@FILE", a list of documents with one path per line. */
static const char *read_list(CommandLine *line, const char *path)
{
    size_t size;
    const char *why;
    char *text = file_read_named(path, &size, &why);
    if (!text) {
        Text out = text_new(&line->words);
        text_format(&out, "@%s: %s", path, why);
        return out.at;
    }
    line->lists = realloc(line->lists, sizeof *line->lists * (size_t)(line->list_count + 1));
    line->list_texts =
        realloc(line->list_texts, sizeof *line->list_texts * (size_t)(line->list_count + 1));
    if (!line->lists || !line->list_texts)
        memory_exhausted();
    line->lists[line->list_count] = path;
    line->list_texts[line->list_count++] = text;
    for (char *at = text, *end; *at; at = end) {
        size_t length = strcspn(at, "\r\n");
        end = at + length + (at[length] != 0);
        at[length] = 0;
        if (length && *at != '#')
            add_input(line, at);
    }
    return NULL;
}

static const char *take_input(void *to, const char *argument, bool literal)
{
    if (!literal && argument[0] == '@')
        return read_list(to, argument + 1);
    add_input(to, argument);
    return NULL;
}

/* -- Names from the tables in --help */

/* Appends ", name", or "name" for the first; ` (default)` after the default. */
static void put_name(Text *out, bool first, const char *name, bool is_default)
{
    text_format(out, "%s%s%s", first ? "" : ", ", name, is_default ? " (default)" : "");
}

/* Returns a target other than the default one whose default is this layout; NULL: none. */
static const char *default_of(int layout)
{
    for (int i = 0; i < TARGET_COUNT; i++)
        if (i != TARGET_DEFAULT && target_table[i].layout == layout)
            return target_table[i].name;
    return NULL;
}

/* Lists the layouts: the default, the defaults of other targets, then all others. */
static void put_layouts(Text *out)
{
    const int first = target_table[TARGET_DEFAULT].layout;
    put_name(out, true, layout_table[first].name, true);
    for (int i = 0; i < LAYOUT_COUNT; i++)
        if (i != first && default_of(i))
            text_format(out, ", %s (default of %s)", layout_table[i].name, default_of(i));
    for (int i = 0; i < LAYOUT_COUNT; i++)
        if (i != first && !default_of(i))
            put_name(out, false, layout_table[i].name, false);
}

static void put_targets(Text *out)
{
    for (int i = 0; i < TARGET_COUNT; i++)
        put_name(out, i == 0, target_table[i].name, i == TARGET_DEFAULT);
}

static void put_passes(Text *out)
{
    for (int i = 0; i < PASS_COUNT; i++)
        put_name(out, i == 0, pass_table[i].name, i == PASS_gbuffer);
}

/* -- The table */

#define AT(member) offsetof(CommandLine, member)
#define HEADING(text)                                                                              \
    {                                                                                              \
        NULL, OPTION_heading, .help = text                                                         \
    }
#define TEXT(name, member, ...)                                                                    \
    {                                                                                              \
        name, OPTION_text, AT(member), ROW_HELP(__VA_ARGS__)                                       \
    }
#define FLAG(name, member, ...)                                                                    \
    {                                                                                              \
        name, OPTION_flag, AT(member), ROW_HELP(__VA_ARGS__)                                       \
    }
#define CHOICE(name, ...)                                                                          \
    {                                                                                              \
        name, OPTION_text, .set = set_choice, ROW_HELP(__VA_ARGS__)                                \
    }
#define ROW_HELP(label_, help_) .label = label_, .help = help_
static const Option options[] = {
    HEADING("usage: matc [options] document...\n\n"
            "Compiles material graphs (YAML, JSON; - is standard input) to GLSL and "
            "SPIR-V.\n\noutput\n"),
    TEXT("-o", output, " FILE",
         "write to FILE; - (default) is standard output. The suffix selects the output\nunless an "
         "option does: .spv is SPIR-V"),
    TEXT("-d", folder, " DIR",
         "write NAME.frag etc. to DIR for all materials of all documents, each program once,\nand "
         "manifest.json, which lists the programs of each material; --pass may name several"),
    {"-j", OPTION_int, AT(threads), .min = 1, .max = MAX_THREADS, .clamped = true,
     .wants = "-j expects a number of threads, at least 1", .label = " N",
     .help = "number of threads (default: all processors)"},
    HEADING("  @FILE                read document names from FILE, one per line; lines that start "
            "with # are ignored\n"),
    TEXT("--cache", cache, " DIR",
         "with -d: cache results in DIR for later runs; also set by MATC_CACHE"),
    {"--cache-limit", OPTION_int, AT(cache_limit), .min = 1, .max = INT_MAX, .clamped = true,
     .wants = "--cache-limit expects a number of MiB, at least 1", .label = "=MIB",
     .help = "size of the cache (default: 1024); least recently used entries are removed first"},
    FLAG("--cache-stats", cache_stats, NULL, "print the contents and hits of the cache"),
    {"--emit", OPTION_set, AT(emit), .words = {emit_name, NULL, EMIT_COUNT}, .label = "=LIST",
     .help = "glsl (default), vertex, tessvertex, tesscontrol, tesseval,\n"
             "geometryvertex, geometry, compute, displace, unpack, reflect, layout,\n"
             "spirv, ir, dot, tree; several need -d. With --target=spirv all stages are SPIR-V"},
    TEXT("--textures", textures, " DIR", "write the textures that matc generates to DIR, as KTX"),
    FLAG("--watch", watch, NULL,
         "with -o or -d: keep running, and compile again whenever an input file changes"),
    {"-I", OPTION_list, AT(compile.include), AT(compile.include_count), .label = " DIR",
     .help = "search path of `include:`, after the document's folder and before the\ndefinitions "
             "that come with matc"},
    TEXT("--root", compile.root, "=DIR",
         "read no file outside DIR that a document names, after resolving links; for "
         "untrusted\ndocuments"),
    FLAG("-MD", depend, ", -MF FILE, -MT T",
         "write a depfile for make and ninja; set its name; set its target"),
    TEXT("-MF", depfile, NULL, NULL),
    TEXT("-MT", target, NULL, NULL),
    HEADING("program\n"),
    {"--target", OPTION_text, 0, .set = set_choice, .label = "=T", .put_help = put_targets,
     .help = ""},
    {"--pass", OPTION_text, 0, .set = set_choice, .label = "=P", .put_help = put_passes,
     .help = ""},
    CHOICE("--slot", "=S", "for --pass=value: diffuse (default), normal, specular, ..."),
    {"--layout", OPTION_text, 0, .set = set_choice, .label = "=L", .put_help = put_layouts,
     .help = "; a file;\n"
             "auto: the smallest that stores all given materials. --explain L shows the fields"},
    {"--layout-error", OPTION_real, AT(layout_error), .min = DBL_TRUE_MIN, .max = 0.5,
     .wants = "--layout-error expects a number above 0, at most 0.5", .label = "=E",
     .help = "of auto: max error of a color's square root (default: 0.00196), other slots in "
             "proportion"},
    {"--cases", OPTION_word, AT(cases), .words = OPTION_WORDS("used", OPTIONS_CASES_ALL),
     .label = "=C",
     .help = "with -d, the cases of the layout that the unpacking code supports: used (default), "
             "those\nof the given materials; all, also for materials that are compiled later"},
    CHOICE("--normals", "=N", "space of G-buffer normals: eye (default) or world"),
    CHOICE("--precision", "=P",
           "fast (default), balanced, exact: sets --noise, --coordinates, --powers and "
           "--trigonometry,\nunless given"),
    CHOICE("--constants", "=C",
           "baked, uniform: numbers of the document come from a uniform block; auto (default): "
           "with -d,\nthose that differ between materials that can share a program"),
    CHOICE("--noise", "=N", "lattice (default), groimp, simplex"),
    CHOICE("--coordinates", "=C", "plain (default), long: scales and offsets lose no accuracy"),
    CHOICE("--powers", "=P", "squaring (default), pow, compensated"),
    CHOICE("--trigonometry", "=T", "native (default), bounded"),
    CHOICE("--aa", "=A", "auto (default), none, box, aniso: antialiasing by means over the pixel"),
    CHOICE("--derivatives", "=D", "auto (default), finite, analytic: how BumpMap computes slopes"),
    TEXT("--material", material, "=NAME", "a material of `materials:` (default: the only one)"),
    {"-O", OPTION_maybe, 0, .set = set_level, .label = "0, -O1, -O2",
     .help = "optimization level: none, some, all (default); -O, -O3 and -Os are -O2"},
    HEADING("measuring\n"),
    {"--max-error", OPTION_real, AT(max_error), .min = DBL_TRUE_MIN, .max = INFINITY,
     .wants = "--max-error expects a number above 0", .label = "=E",
     .help = "choose the fastest values of options that are not given, with errors of all slots "
             "within E"},
    FLAG("--pareto", pareto, NULL,
         "print run time and error of all values of options that are not given; -o BASENAME: "
         "also\nwrite .csv, .svg and .png"),
    {"--range", OPTION_real, AT(range), .min = DBL_TRUE_MIN, .max = 1e30,
     .wants = "--range expects a number above 0", .label = "=R",
     .help = "measure for coordinates in [-R, R] (default: 4)"},
    {"--gl", OPTION_index, AT(gl), .words = {gl_name, NULL, GL_KIND_count}, .label = "=KIND",
     .help = "measure on osmesa (default, in software) or egl (on a GPU if available)"},
    HEADING("queries\n"),
    TEXT("--eval", eval, " \"u=.3 v=.4\"",
         "print the values of all slots at a point, by the C reference"),
    {"--list", OPTION_maybe, AT(list), .otherwise = "", .label = "[=KIND]",
     .help = "list materials, maps, waves, channels, slots, ..., or one kind"},
    HEADING("  --list FILE          list the definitions that a document contains or includes\n"),
    TEXT("--explain", explain, " NAME",
         "describe a name of these lists; with a FILE, a definition"),
    {"--schema", OPTION_maybe, AT(schema), .otherwise = OPTIONS_SCHEMA, .label = "[=OF]",
     .help = "print the JSON Schema of document (default), layout, manifest or reflection"},
    HEADING("  --schema FILE        the schema of documents, with the definitions that FILE "
            "contains or includes\n"),
    FLAG("--stats", stats, NULL,
         "print times, nodes and cost of every stage, and choices with reasons, to standard error"),
    {"--diagnostics", OPTION_index, AT(diagnostics), .words = OPTION_WORDS("text", "json"),
     .label = "=FORM", .help = "text (default), json"},
    {"-W", OPTION_text, 0, .set = add_warning, .label = "no-NAME",
     .help = "disable a warning; -Werror, -Werror=NAME: treat all warnings, or one, as "
             "errors.\n--explain warnings lists the names"},
    {"--no-validate", OPTION_clear, AT(compile.validate), .help = "do not validate with glslang"},
    FLAG("--check", compile.check, NULL, "check the IR after every pass"),
    FLAG("--help", help, ", --version", ""),
    FLAG("-h", help, NULL, NULL),
    FLAG("--version", version, NULL, NULL),
    HEADING("\nExit status: 0 success, 1 error in a document or file, 2 wrong usage.\n"),
};

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

const char *options_emit_text(const MatcOptions *options, int emit, const MatcProgram *program,
                              size_t *size)
{
    const MatcOutput output = (MatcOutput)emit_table[emit_row(options, emit)].output;
    return is_spirv(options, emit) ? matc_spirv(program, output, size)
                                   : matc_output(program, output, size);
}

const char *options_emit_suffix(const MatcOptions *options, int emit)
{
    return is_spirv(options, emit) ? emit_table[emit].spirv
                                   : emit_table[emit_row(options, emit)].suffix;
}

/* Parses "gbuffer,shadow". */
static const char *read_passes(CommandLine *line)
{
    const char *list = line->compile.pass ? line->compile.pass : "gbuffer";
    char *at = line->pass_list = strdup(list);
    if (!at)
        memory_exhausted();
    for (char *next; at; at = next) {
        if ((next = strchr(at, ',')))
            *next++ = 0;
        for (int i = 0; i < line->pass_count; i++)
            if (!strcmp(line->passes[i], at))
                return "--pass names a pass twice";
        if (line->pass_count == MAX_PASSES)
            return "--pass names too many passes";
        line->passes[line->pass_count++] = at;
    }
    return NULL;
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

/* Finds the form of messages in advance, since a fault may precede --diagnostics. */
static MatcForm form_asked_for(int argc, char **argv)
{
    for (int i = 1; i < argc && strcmp(argv[i], "--") != 0; i++)
        if (!strcmp(argv[i], "--diagnostics=json"))
            return MATC_JSON;
    return MATC_TEXT;
}

bool options_read(CommandLine *line, int argc, char **argv, const char **fault)
{
    const OptionTable table = {options, sizeof options / sizeof *options, options_values,
                               take_input};
    *line = (CommandLine){0};
    matc_options_init(&line->compile);
    line->diagnostics = form_asked_for(argc, argv);
    *fault = option_read(&table, line, &line->words, argc, argv);
    for (int i = 0; i < EMIT_COUNT; i++)
        line->emit_named |= line->emit[i];
    line->emit[EMIT_glsl] |= !line->emit_named;
    if (!*fault)
        *fault = read_passes(line);
    return !*fault;
}

const char *options_help(Arena *arena)
{
    Text out = text_new(arena);
    option_put_help(&out, options, sizeof options / sizeof *options);
    return out.at;
}
