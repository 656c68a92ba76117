/* Inputs of a batch: all of its files; and inputs in the output folder, which no output may
 * replace. */
#include "compiler/tool/batch_state.h"
#include "compiler/base/memory.h"
#include "compiler/tool/layout_option.h"
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

void batch_inputs(const Batch *b, StringSet *files)
{
    for (int d = 0; d < b->document_count; d++)
        for (int i = !strcmp(b->documents[d].path, "-"); i < b->documents[d].depend_count; i++)
            string_set_add(files, b->documents[d].depends[i], NULL);
    for (int i = 0; i < b->line->list_count; i++)
        string_set_add(files, b->line->lists[i], NULL);
    if (b->line->compile.layout && layout_is_file(b->line->compile.layout))
        string_set_add(files, b->line->compile.layout, NULL);
}

/* Returns true if the path's folder is the given folder. */
static bool lies_in(const char *path, size_t size, const struct stat *folder)
{
    struct stat info;
    char *name = size ? strndup(path, size) : sets_copy(".");
    if (!name)
        memory_exhausted();
    bool same =
        !stat(name, &info) && info.st_dev == folder->st_dev && info.st_ino == folder->st_ino;
    free(name);
    return same;
}

/* Consecutive files are mostly in the same folder, so the last result is cached. */
static void list_within(StringSet *within, const StringSet *files, const char *folder)
{
    struct stat info;
    const char *last = NULL;
    size_t last_size = 0;
    bool inside = false;
    if (stat(folder, &info))
        return;
    for (int i = 0; i < files->count; i++) {
        const char *path = files->at[i], *slash = strrchr(path, '/');
        size_t size = slash ? (size_t)(slash - path) + 1 : 0;
        if (!last || size != last_size || memcmp(path, last, size) != 0)
            inside = lies_in(path, size, &info);
        last = path;
        last_size = size;
        if (inside)
            string_set_add(within, path + size, NULL);
    }
}

bool batch_reads(const Batch *b, const char *name)
{
    return string_set_find(&b->within, name) >= 0;
}

void batch_spare_inputs(Batch *b)
{
    StringSet files = {0};
    batch_inputs(b, &files);
    list_within(&b->within, &files, b->line->folder);
    string_set_free(&files);
    for (int i = 0; i < b->within.count; i++)
        if (staging_holds(b->staging, b->within.at[i]))
            batch_complain_within(b, NULL, b->line->folder, b->within.at[i],
                                  "an output would overwrite this input file");
}
