/* Hints for names that shipped library files define: which file to include. */
#include "compiler/base/text.h"
#include "compiler/hints/hint.h"
#include <string.h>

const LibraryName *hint_library_name(const char *name)
{
    for (int i = 0; i < library_name_count; i++)
        if (!strcmp(library_names[i].name, name))
            return &library_names[i];
    return NULL;
}

const char *hint_shipped(Session *session, const char *name)
{
    const LibraryName *shipped = diag_full(session) ? NULL : hint_library_name(name);
    Text text = text_new(session->arena);
    if (shipped)
        text_format(&text, "; it comes with matc: `include: %s`", shipped->file);
    return shipped ? text.at : NULL;
}

const char *hint_definition(Resolver *r, const char *name)
{
    const char *shipped = hint_shipped(r->session, name);
    bool defined = false;
    for (size_t i = 0; i < r->def_count; i++)
        defined |= tree_find(r->defs[i], name) != NULL;
    if (!defined && !shipped)
        return NULL;
    Text text = text_new(r->session->arena);
    text_format(&text, "; it is a definition, write `{ ref: %s }`%s", name, defined ? "" : shipped);
    return text.at;
}
