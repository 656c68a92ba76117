/* The suffix of -o selects the output or the target unless an option does; it must not
 * contradict an option.
 *
 *     -o a.spv                    equals --target=spirv
 *     -o a.json                   equals --emit=reflect
 *     -o a.spv --target=glsl450   an error: the file would contain GLSL */
#include "compiler/base/text.h"
#include "compiler/choice.h"
#include "compiler/tool/options_fault.h"
#include <string.h>

typedef enum { CONTENT_glsl, CONTENT_spirv, CONTENT_other } Content;

static bool ends_with(const char *name, const char *suffix)
{
    const size_t size = strlen(name), length = suffix ? strlen(suffix) : 0;
    return length && size > length && !strcmp(name + size - length, suffix);
}

/* Returns the output with the longest matching suffix; EMIT_COUNT: none. *spirv: the suffix is
 * that of SPIR-V. */
static int emit_of_suffix(const char *name, bool *spirv)
{
    size_t longest = 0;
    int found = EMIT_COUNT;
    for (int i = 0; i < EMIT_COUNT; i++) {
        const char *const ends[2] = {emit_table[i].suffix, emit_table[i].spirv};
        for (int k = 0; k < 2; k++)
            if (ends_with(name, ends[k]) && strlen(ends[k]) > longest) {
                longest = strlen(ends[k]);
                found = i;
                *spirv = k == 1 || i == EMIT_spirv;
            }
    }
    return found == EMIT_spirv ? EMIT_glsl : found;
}

/* Returns true if an output is a program in GLSL or SPIR-V, depending on the target. */
static bool is_program(int emit)
{
    return emit == EMIT_glsl || emit == EMIT_spirv || emit == EMIT_unpack ||
           emit == EMIT_displace || emit_table[emit].spirv;
}

static int emit_asked(const CommandLine *line)
{
    int emit = 0;
    while (emit < EMIT_COUNT && !line->emit[emit])
        emit++;
    return emit;
}

static Content content_of(const CommandLine *line, int emit)
{
    const TargetRow *target = choice_target(&line->compile);
    const bool spirv = emit == EMIT_spirv ||
                       (emit != EMIT_unpack && emit != EMIT_displace && target && target->spirv);
    return !is_program(emit) ? CONTENT_other : spirv ? CONTENT_spirv : CONTENT_glsl;
}

static const char *contradiction(CommandLine *line, int named, bool spirv, int emit)
{
    const Content wanted = !is_program(named) ? CONTENT_other
                           : spirv            ? CONTENT_spirv
                                              : CONTENT_glsl;
    const Content content = content_of(line, emit);
    Text out = text_new(&line->words);
    if (wanted == content && (wanted != CONTENT_other || named == emit))
        return NULL;
    if (wanted == CONTENT_spirv && content == CONTENT_glsl)
        text_format(&out, "-o %s would hold GLSL: for SPIR-V give --target=spirv", line->output);
    else if (wanted == CONTENT_glsl && content == CONTENT_spirv)
        text_format(&out,
                    "-o %s would hold SPIR-V: for GLSL ask for no SPIR-V, or name a file .spv",
                    line->output);
    else
        text_format(&out, "-o %s is the name of --emit=%s, and would hold --emit=%s", line->output,
                    emit_table[named].name, emit_table[emit].name);
    return out.at;
}

const char *options_suffix(CommandLine *line)
{
    bool spirv = false;
    const int named =
        line->output && !line->folder ? emit_of_suffix(line->output, &spirv) : EMIT_COUNT;
    int emit = emit_asked(line);
    if (named == EMIT_COUNT || emit == EMIT_COUNT || line->eval || line->pareto)
        return NULL;
    if (!line->emit_named) {
        line->emit[emit] = false;
        line->emit[named] = true;
        emit = named;
    }
    if (spirv && !line->compile.target && content_of(line, emit) == CONTENT_glsl)
        choice_set(&line->compile, "target", "spirv");
    return contradiction(line, named, spirv, emit);
}
