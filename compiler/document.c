/* Library API: documents. */
#include "compiler/choice.h"
#include "compiler/base/memory.h"
#include "compiler/document.h"
#include "compiler/pipeline.h"
#include "compiler/resolve/resolve.h"
#include <stdlib.h>
#include <string.h>

const char *matc_version(void) { return MATC_VERSION; }

/* Creates a document with its text, not yet parsed. */
static MatcDocument *make(const char *name, const char *text, size_t size,
                          const MatcOptions *options)
{
    MatcDocument *d = calloc(1, sizeof *d);
    if (!d)
        memory_exhausted();
    d->options = choice_whole_options(options);
    d->session = session_open(&d->options, &d->arena);
    d->session.measure = d->options.measure;
    d->session.stage_start = session_now();
    size = text ? size : 0;
    name = name ? name : "";
    const Source source = {.name = arena_string(&d->arena, name, strlen(name)),
                           .text = arena_string(&d->arena, text ? text : "", size),
                           .size = size};
    ARENA_PUSH(&d->arena, d->session.sources, d->session.source_count, d->session.source_capacity,
               source);
    session_depend_on(&d->session, source.name);
    return d;
}

MatcDocument *matc_read(const char *name, const char *text, size_t size, const MatcOptions *options)
{
    MatcDocument *d = make(name, text, size, options);
    if (!text)
        diag_add(&d->session, NO_SPAN, DIAG_null_argument, "text");
    else if (choice_check(&d->session))
        d->graph = compile_front(&d->session, 0, &d->tree);
    return d;
}

MatcDocument *document_read(const char *name, const char *text, size_t size,
                            const MatcOptions *options)
{
    MatcDocument *d = make(name, text, size, options);
    if (!text)
        diag_add(&d->session, NO_SPAN, DIAG_null_argument, "text");
    else if (choice_check(&d->session))
        d->tree = read_document(&d->session, 0);
    return d;
}

void document_resolve(MatcDocument *d, Tree *tree)
{
    d->graph = tree ? resolve(&d->session, tree) : NULL;
}

void document_lend(const MatcDocument *d, Session *session)
{
    session->sources = d->session.sources;
    session->source_count = d->session.source_count;
    session->depends = d->session.depends;
}

void matc_document_free(MatcDocument *d)
{
    if (!d)
        return;
    arena_free(&d->arena);
    free(d);
}

int matc_material_count(const MatcDocument *d)
{
    return d && d->graph ? d->graph->material_count : 0;
}

const char *matc_material_name(const MatcDocument *d, int material)
{
    return material >= 0 && material < matc_material_count(d) ? d->graph->materials[material].name
                                                              : NULL;
}

int matc_material_find(const MatcDocument *d, const char *name)
{
    for (int i = 0; name && i < matc_material_count(d); i++)
        if (!strcmp(matc_material_name(d, i), name))
            return i;
    return -1;
}

int matc_depend_count(const MatcDocument *d) { return d ? (int)d->session.depends.count : 0; }

const char *matc_depend(const MatcDocument *d, int index)
{
    return index >= 0 && index < matc_depend_count(d) ? d->session.depends.at[index] : NULL;
}

int matc_error_count(const MatcDocument *d) { return d ? d->session.diags.errors : 0; }

const char *matc_tree_text(MatcDocument *d)
{
    if (!d || !d->tree)
        return "";
    Text out = text_new(&d->arena);
    tree_print(&out, d->tree);
    return out.at;
}

const char *matc_diagnostics(MatcDocument *d, MatcForm form)
{
    return d ? diag_all(&d->session, form) : "";
}
