/* What goes together on a command line. */
#include "compiler/base/text.h"
#include "compiler/choice.h"
#include "compiler/tool/layout_option.h"
#include "compiler/tool/options_fault.h"
#include <stdlib.h>
#include <string.h>

enum { LONGEST_FOLDER = 2048 };
static const double LARGEST_RANGE = 1e30, LARGEST_ERROR = 0.5;

static bool is_within(double number, double largest) { return number > 0 && number <= largest; }

/* NULL, or what is wrong. */
static const char *check_measuring(CommandLine *line)
{
    Arena *words = &line->words;
    if (!(options_number(line->max_error, 1) > 0))
        return options_fault_number(words, "--max-error wants a number above 0", line->max_error);
    if (!is_within(options_number(line->range, 1), LARGEST_RANGE))
        return options_fault_number(words, "--range wants a number above 0", line->range);
    if (!is_within(options_number(line->layout_error, LARGEST_ERROR), LARGEST_ERROR))
        return options_fault_number(words, "--layout-error wants a number above 0, of at most 0.5", line->layout_error);
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
    if (line->folder && strlen(line->folder) > LONGEST_FOLDER)
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
    if (line->watch && !line->folder && (!line->output || !strcmp(line->output, "-")))
        return "--watch needs -o or -d";
    for (int i = 0; i < line->input_count && line->watch; i++)
        if (!strcmp(line->inputs[i], "-"))
            return "standard input cannot be watched";
    if (line->depend && !line->folder && (!line->output || !strcmp(line->output, "-")) && !line->depfile)
        return "-MD needs -o, -d or -MF";
    return NULL;
}

static const char *case_value(const void *user, int i)
{
    (void)user;
    return i ? OPTIONS_CASES_ALL : "used";
}

/* --cases is of what -d writes for all materials together. */
static const char *check_cases(CommandLine *line)
{
    const NameChoice values = {case_value, NULL, 2};
    if (!line->cases)
        return NULL;
    if (strcmp(line->cases, case_value(NULL, 0)) != 0 &&
        strcmp(line->cases, case_value(NULL, 1)) != 0)
        return options_fault_value(&line->words, "--cases", line->cases, &values);
    return line->folder
               ? NULL
               : "--cases is of the set that -d writes; a document alone is read back in all cases";
}

/* What has no effect alone. */
static const char *check_companions(const CommandLine *line)
{
    if (line->depfile && !line->depend)
        return "-MF names the depfile that -MD writes: give -MD, too";
    if (line->target && !line->depend)
        return "-MT names the target in the depfile that -MD writes: give -MD, too";
    if (line->cache_named && !line->folder)
        return "--cache is read and filled by -d alone: give -d, or leave it out";
    if (line->cache_size && !line->cache)
        return "--cache-limit bounds the folder of --cache: give --cache, too";
    return NULL;
}

/* The options of every pass name what exists. */
static const char *check_names(CommandLine *line)
{
    for (int i = 0; i < line->pass_count; i++) {
        MatcOptions options = line->compile;
        NameChoice values;
        options.pass = line->passes[i];
        if (layout_is_custom(options.layout))
            options.layout = NULL; /* layout_open looks at it */
        const char *name = matc_options_fault(&options), *value = name ? choice_value(&options, name) : NULL;
        if (!name)
            continue;
        Text option = text_new(&line->words);
        text_format(&option, "--%s", name);
        return value && options_fault_values(name, &values)
                   ? options_fault_value(&line->words, option.at, value, &values)
                   : option.at;
    }
    return NULL;
}

const char *options_check(CommandLine *line)
{
    const char *fault = check_names(line);
    if (!fault)
        fault = options_suffix(line);
    if (!fault && line->eval)
        fault = options_fault_point(&line->words, line->eval);
    if (!fault && !line->input_count)
        fault = "no document";
    if (!fault)
        fault = check_measuring(line);
    if (!fault)
        fault = check_output(line);
    if (!fault)
        fault = check_cases(line);
    return fault ? fault : check_companions(line);
}
