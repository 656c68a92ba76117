/* Finds and reads documents. */
#include "documents.h"
#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int by_name(const void *a, const void *b)
{
    return strcmp(*(char *const *)a, *(char *const *)b);
}

static void add_matches(DocumentList *list, const char *folder, const char *pattern)
{
    char full[4096];
    glob_t found = {0};
    snprintf(full, sizeof full, "%s/%s", folder, pattern);
    if (glob(full, 0, NULL, &found) == 0) {
        list->paths =
            realloc(list->paths, ((size_t)list->count + found.gl_pathc) * sizeof *list->paths);
        if (!list->paths)
            abort();
        for (size_t i = 0; i < found.gl_pathc; i++)
            /* these folders contain no documents */
            if (!strstr(found.gl_pathv[i], "/layouts/") && !strstr(found.gl_pathv[i], "/engine/"))
                list->paths[list->count++] = strdup(found.gl_pathv[i]);
    }
    globfree(&found);
}

static DocumentList documents_of(const char *folder, const char *const patterns[])
{
    DocumentList list = {0};
    for (; *patterns; patterns++)
        add_matches(&list, folder, *patterns);
    if (list.count)
        qsort(list.paths, (size_t)list.count, sizeof *list.paths, by_name);
    return list;
}

DocumentList documents_list(const char *folder)
{
    static const char *const patterns[] = {"examples/*.yaml", "examples/*.json",
                                           "examples/*/*.yaml", "examples/*/*.json", NULL};
    return documents_of(folder, patterns);
}

DocumentList documents_tried(const char *folder)
{
    static const char *const patterns[] = {"examples/*.yaml",    "examples/*.json",
                                           "examples/*/*.yaml",  "examples/*/*.json",
                                           "tests/value/*.yaml", NULL};
    return documents_of(folder, patterns);
}

DocumentList documents_in(const char *folder)
{
    DocumentList list = {0};
    add_matches(&list, folder, "*.yaml");
    return list;
}

void documents_free(DocumentList *list)
{
    for (int i = 0; i < list->count; i++)
        free(list->paths[i]);
    free(list->paths);
    *list = (DocumentList){0};
}

static char *read_text(Arena *arena, const char *path, size_t *size)
{
    FILE *file = fopen(path, "rb");
    if (!file)
        return NULL;
    Text text = text_new(arena);
    char part[4096];
    text_add(&text, "", 0);
    for (size_t got; (got = fread(part, 1, sizeof part, file)) > 0;)
        text_add(&text, part, got);
    fclose(file);
    *size = text.size;
    return text.at;
}

static bool take_text(Document *d, const char *path, const char *text, size_t size)
{
    matc_options_init(&d->options);
    d->options.pixels = true;
    d->document = matc_read(path, text, size, &d->options);
    d->session =
        (Session){.options = &d->options, .arena = &d->arena, .optimize = 2, .check = true};
    Source source = {.name = path, .text = text, .size = size};
    ARENA_PUSH(&d->arena, d->session.sources, d->session.source_count, d->session.source_capacity,
               source);
    d->graph = compile_front(&d->session, 0, &d->tree);
    return d->graph && d->graph->material_count && matc_error_count(d->document) == 0;
}

bool document_open(Document *d, const char *path)
{
    size_t size = 0;
    *d = (Document){.path = path};
    char *text = read_text(&d->arena, path, &size);
    return text && take_text(d, path, text, size);
}

bool document_open_text(Document *d, const char *text)
{
    *d = (Document){.path = "text.yaml"};
    return take_text(d, d->path, text, strlen(text));
}

bool document_is_library(const Document *d)
{
    return d->session.diags.count == 1 && d->session.diags.at[0].kind == DIAG_definitions_only;
}

const char *document_fault(Document *d)
{
    return d->document ? matc_diagnostics(d->document, MATC_TEXT) : "cannot be read";
}

const char *document_name(const Document *d)
{
    const char *found = strstr(d->path, "examples/");
    return found ? found + strlen("examples/") : d->path;
}

void document_close(Document *d)
{
    matc_document_free(d->document);
    arena_free(&d->arena);
    *d = (Document){0};
}

void document_set_uniform(Document *d, int uniform, const double value[4])
{
    /* const is cast away: the uniform was allocated in our arena */
    Uniform *u = (Uniform *)(uintptr_t)d->graph->uniforms[uniform];
    memcpy(u->initial, value, sizeof u->initial);
}
