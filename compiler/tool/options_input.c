/* The documents that a command line names. */
#include "compiler/tool/options_input.h"
#include "compiler/base/file.h"
#include "compiler/base/memory.h"
#include "compiler/base/text.h"
#include <stdlib.h>
#include <string.h>

void options_add_input(CommandLine *line, const char *path)
{
    enum { STEP = 256 };
    if (line->input_count % STEP == 0) {
        line->inputs = realloc(line->inputs, sizeof *line->inputs * (size_t)(line->input_count + STEP));
        if (!line->inputs)
            memory_exhausted();
    }
    line->inputs[line->input_count++] = path;
}

bool options_read_list(CommandLine *line, const char *path, const char **fault)
{
    size_t size;
    const char *why;
    char *text = file_read_named(path, &size, &why);
    if (!text) {
        Text out = text_new(&line->words);
        text_format(&out, "@%s: %s", path, why);
        *fault = out.at;
        return false;
    }
    line->lists = realloc(line->lists, sizeof *line->lists * (size_t)(line->list_count + 1));
    line->list_texts = realloc(line->list_texts, sizeof *line->list_texts * (size_t)(line->list_count + 1));
    if (!line->lists || !line->list_texts)
        memory_exhausted();
    line->lists[line->list_count] = path;
    line->list_texts[line->list_count++] = text;
    for (char *at = text, *end; *at; at = end) {
        size_t length = strcspn(at, "\r\n");
        end = at + length + (at[length] != 0);
        at[length] = 0;
        if (length && *at != '#')
            options_add_input(line, at);
    }
    return true;
}
