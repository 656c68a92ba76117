/* The layout of a command line: read from a file, or derived from all materials of all
 * documents. */
#include "compiler/tool/layout_option.h"
#include "compiler/base/file.h"
#include "compiler/base/memory.h"
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void fail(char **fault, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void fail(char **fault, const char *format, ...)
{
    va_list args;
    va_start(args, format);
    if (vasprintf(fault, format, args) < 0)
        memory_exhausted();
    va_end(args);
}

static bool ends_in(const char *text, const char *suffix)
{
    size_t size = strlen(text), end = strlen(suffix);
    return size > end && !strcmp(text + size - end, suffix);
}

bool layout_is_file(const char *layout)
{
    return strchr(layout, '/') || ends_in(layout, ".yaml") || ends_in(layout, ".yml") ||
           ends_in(layout, ".json");
}

bool layout_is_custom(const char *layout)
{
    return layout && (layout_is_file(layout) || !strcmp(layout, "auto"));
}

static MatcLayout *read_file_of(const char *path, const MatcOptions *options, char **fault)
{
    size_t size;
    const char *why;
    char *text = file_read(path, &size, &why);
    if (!text) {
        fail(fault, "%s: %s", path, why);
        return NULL;
    }
    MatcLayout *layout = matc_layout_read(path, text, size, options);
    free(text);
    return layout;
}

/* Adds the selected materials of a document. Their faults are reported when the document is
 * compiled. */
static bool add_document(MatcRanges *ranges, const CommandLine *line, const char *path,
                         char **fault)
{
    size_t size;
    const char *why;
    char *text = file_read(path, &size, &why), *wrong = NULL;
    if (!text) {
        fail(fault, "%s: %s", path, why);
        return false;
    }
    MatcDocument *document = matc_read(path, text, size, &line->compile);
    free(text);
    for (int i = 0; i < matc_material_count(document) && !wrong; i++)
        if (!line->material || !strcmp(line->material, matc_material_name(document, i)))
            matc_ranges_add(ranges, document, i, &line->compile, &wrong);
    if (!matc_material_count(document))
        fail(fault, "%s", matc_diagnostics(document, line->diagnostics));
    else if (wrong)
        fail(fault, "%s", wrong);
    free(wrong);
    matc_document_free(document);
    return !*fault;
}

static MatcLayout *make_auto(const CommandLine *line, char **fault)
{
    MatcRanges ranges;
    matc_ranges_init(&ranges);
    for (int i = 0; i < line->input_count; i++) {
        if (!strcmp(line->inputs[i], "-")) {
            fail(fault, "--layout=auto: standard input cannot be read twice");
            return NULL;
        }
        if (!add_document(&ranges, line, line->inputs[i], fault))
            return NULL;
    }
    return matc_layout_for(&ranges, line->layout_error, &line->compile);
}

MatcLayout *layout_open(const CommandLine *line, char **fault)
{
    const char *name = line->explain ? line->explain : line->compile.layout;
    *fault = NULL;
    if (!name)
        return NULL;
    if (layout_is_file(name))
        return read_file_of(name, &line->compile, fault);
    return !line->explain && !strcmp(name, "auto") ? make_auto(line, fault) : NULL;
}
