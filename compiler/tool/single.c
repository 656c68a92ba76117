/* Writes the results for one material. */
#include "compiler/tool/single.h"
#include "compiler/base/memory.h"
#include "compiler/tool/depfile.h"
#include "compiler/base/file.h"
#include "compiler/tool/layout_option.h"
#include "compiler/base/output.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *put_textures(Outputs *files, const CommandLine *line, MatcProgram *program,
                                char path[SINGLE_PATH])
{
    const char *why = NULL;
    for (int i = 0; i < matc_texture_count(program) && !why; i++) {
        const MatcTexture *texture = matc_texture(program, i);
        size_t size;
        if (texture->path)
            continue;
        snprintf(path, SINGLE_PATH, "%s/%s.ktx", line->textures, texture->name);
        char *bytes = output_ktx(texture, &size);
        why = outputs_put(files, path, bytes, size);
        free(bytes);
    }
    return why;
}

/* Returns true if --watch is given and the file already has these bytes. */
static bool is_written(const CommandLine *line, const char *to, const char *bytes, size_t size)
{
    size_t old_size;
    const char *why;
    char *old = line->watch ? file_read(to, &old_size, &why) : NULL;
    bool same = old && old_size == size && !memcmp(old, bytes, size);
    free(old);
    return same;
}

static const char *put_output(Outputs *files, const CommandLine *line, MatcDocument *document,
                              MatcProgram *program, char path[SINGLE_PATH])
{
    int emit = 0;
    size_t size = 0;
    while (!line->emit[emit])
        emit++;
    snprintf(path, SINGLE_PATH, "%s", line->output ? line->output : "-");
    const char *text = emit == EMIT_tree ? matc_tree_text(document)
                                         : options_emit_text(&line->compile, emit, program, &size);
    size = emit == EMIT_tree ? strlen(text) : size;
    return is_written(line, path, text, size) ? NULL : outputs_put(files, path, text, size);
}

/* Lists the files on which the document depends, without standard input. */
static int list_files(const CommandLine *line, const MatcDocument *document, const char **files)
{
    int count = 0;
    for (int i = !strcmp(line->inputs[0], "-"); i < matc_depend_count(document); i++)
        files[count++] = matc_depend(document, i);
    if (line->compile.layout && layout_is_file(line->compile.layout))
        files[count++] = line->compile.layout;
    return count;
}

/* Returns the depfile's text, from malloc; NULL if a name cannot be represented, which is copied
 * to `path`. */
static char *make_depfile(const CommandLine *line, const MatcDocument *document,
                          char path[SINGLE_PATH])
{
    const char *to = line->output ? line->output : "-", *bad;
    const char **files = calloc((size_t)matc_depend_count(document) + 1, sizeof *files);
    if (!files)
        memory_exhausted();
    char *text = depfile_text(line->target ? line->target : to, files,
                              list_files(line, document, files), &bad);
    if (!text)
        snprintf(path, SINGLE_PATH, "%s", bad);
    free(files);
    return text;
}

static const char *put_depfile(Outputs *files, const CommandLine *line, const char *text,
                               char path[SINGLE_PATH])
{
    const char *to = line->output ? line->output : "-";
    snprintf(path, SINGLE_PATH, "%s%s", line->depfile ? line->depfile : to,
             line->depfile ? "" : ".d");
    return outputs_put(files, path, text, strlen(text));
}

/* Writes the output last, since standard output cannot be withdrawn. */
const char *single_write(const CommandLine *line, MatcDocument *document, MatcProgram *program,
                         char path[SINGLE_PATH])
{
    Outputs files = {0};
    bool depend = line->depend && program;
    char *depfile = depend ? make_depfile(line, document, path) : NULL;
    if (depend && !depfile)
        return depfile_why;
    const char *why = depfile ? put_depfile(&files, line, depfile, path) : NULL;
    if (!why && line->textures && program)
        why = put_textures(&files, line, program, path);
    if (!why)
        why = put_output(&files, line, document, program, path);
    if (!why)
        why = outputs_commit(&files);
    if (why && !strcmp(path, "-"))
        snprintf(path, SINGLE_PATH, "standard output");
    outputs_close(&files);
    free(depfile);
    return why;
}
