/* Checks which options can be combined. */
#include "compiler/base/text.h"
#include "compiler/choice.h"
#include "compiler/tool/layout_option.h"
#include "compiler/tool/options_fault.h"
#include <stdlib.h>
#include <string.h>

enum { LONGEST_FOLDER = 2048 };
/* Returns NULL or a fault. */
static const char *check_measuring(const CommandLine *line)
{
    if (line->max_error && line->compile.pass && strcmp(line->compile.pass, "gbuffer") != 0)
        return "--max-error is of the pass gbuffer";
    if ((line->pareto || line->max_error) && layout_is_custom(line->compile.layout))
        return "--pareto and --max-error know the built-in layouts only";
    if (line->pareto && (line->max_error || line->eval || line->folder || line->input_count > 1))
        return "--pareto takes one document, and neither --max-error, --eval nor -d";
    return NULL;
}

/* Returns NULL or a fault. */
static const char *check_output(const CommandLine *line)
{
    int emits = 0;
    for (int i = 0; i < EMIT_COUNT; i++)
        emits += line->emit[i];
    if (line->folder && strlen(line->folder) > LONGEST_FOLDER)
        return "the folder's name is too long";
    if (line->output && line->folder)
        return "-o and -d are mutually exclusive";
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
    if (line->depend && !line->folder && (!line->output || !strcmp(line->output, "-")) &&
        !line->depfile)
        return "-MD needs -o, -d or -MF";
    return NULL;
}

/* Checks options without effect unless another one is given. */
static const char *check_companions(const CommandLine *line)
{
    if (line->cases && !line->folder)
        return "--cases is of the set that -d writes; a document alone is read back in all cases";
    if (line->depfile && !line->depend)
        return "-MF names the depfile that -MD writes: give -MD, too";
    if (line->target && !line->depend)
        return "-MT names the target in the depfile that -MD writes: give -MD, too";
    if (line->cache_named && !line->folder)
        return "--cache is read and filled by -d alone: give -d, or leave it out";
    if (line->cache_limit && !line->cache)
        return "--cache-limit bounds the folder of --cache: give --cache, too";
    return NULL;
}

/* Checks that the options of every pass have existing values. */
static const char *check_names(CommandLine *line)
{
    for (int i = 0; i < line->pass_count; i++) {
        MatcOptions options = line->compile;
        NameChoice values;
        options.pass = line->passes[i];
        if (layout_is_custom(options.layout))
            options.layout = NULL; /* layout_open() checks the layout */
        const char *name = matc_options_fault(&options),
                   *value = name ? choice_value(&options, name) : NULL;
        if (!name)
            continue;
        Text option = text_new(&line->words);
        text_format(&option, "--%s", name);
        return value && options_values(option.at, &values)
                   ? option_fault_value(&line->words, option.at, value, &values)
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
    return fault ? fault : check_companions(line);
}
