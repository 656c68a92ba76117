/* Library API: descriptions of the definitions of a document and its includes. */
#include "compiler/document.h"
#include "compiler/base/json_write.h"
#include "compiler/base/memory.h"
#include "compiler/describe/describe.h"
#include "compiler/resolve/resolve_parameter.h"
#include "compiler/resolve/resolve_definition.h"
#include "grammar/library_table.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SHIPPED_FOLDER "<matc>/" /* prefix of the paths of shipped files: include.c */

static const char *doc_of(const Tree *tree)
{
    const Member *doc = tree->kind == TREE_object ? tree_find(tree, "doc") : NULL;
    return doc && doc->value->kind == TREE_scalar ? doc->value->text : "";
}

static char *text_given(Arena *arena, const Text *out)
{
    char *text = out->size ? memory_checked(strdup(out->at)) : NULL;
    arena_free(arena);
    return text;
}

/* Returns the first definition with that name, as in the document. */
static const Member *definition_of(const MatcDocument *d, const char *name)
{
    const Member *found = NULL;
    for (int i = 0; d && name && d->graph && i < d->graph->def_count && !found; i++)
        found = tree_find(d->graph->defs[i], name);
    return found;
}

char *matc_definitions(const MatcDocument *d)
{
    Arena arena = {0};
    Text out = text_new(&arena);
    for (int i = 0; d && d->graph && i < d->graph->def_count; i++) {
        const Tree *defs = d->graph->defs[i];
        if (defs->count)
            text_format(&out, "%s%s\n", out.size ? "\n" : "",
                        d->session.sources[defs->span.file].name);
        for (uint32_t k = 0; k < defs->count; k++)
            if (definition_of(d, defs->members[k].key) == &defs->members[k])
                text_format(&out, "  %-24s  %s\n", defs->members[k].key,
                            doc_of(defs->members[k].value));
    }
    return text_given(&arena, &out);
}

/* Returns a parameter's range: "1 to 512", "from 1 on", or "". */
static const char *range_of(Arena *arena, const Parameter *p)
{
    Text out = text_new(arena);
    if (p->low && p->high)
        text_format(&out, "%s to %s", p->low->text, p->high->text);
    else if (p->low || p->high)
        text_format(&out, p->low ? "from %s on" : "up to %s",
                    p->low ? p->low->text : p->high->text);
    return out.size ? out.at : "";
}

/* Returns a parameter's default: its text, or its kind. */
static const char *default_of(const Parameter *p)
{
    const Member *kind = p->init && p->init->kind == TREE_object ? tree_find(p->init, "map") : NULL;
    if (!p->init)
        return "(none)";
    return p->init->kind == TREE_scalar               ? p->init->text
           : kind && kind->value->kind == TREE_scalar ? kind->value->text
                                                      : "...";
}

static void put_parameters(Arena *arena, Text *out, Session *session, const Tree *params)
{
    Resolver r = {.session = session};
    text_put(out, "\nParameters: name, type, default, range\n");
    for (uint32_t i = 0; i < params->count; i++) {
        Parameter p;
        if (resolve_parameter(&r, &params->members[i], &p))
            text_format(out, "  %-12s  %-9s  %-10s  %-10s  %s\n", params->members[i].key,
                        resolve_parameter_type(p.type), default_of(&p), range_of(arena, &p),
                        doc_of(params->members[i].value));
    }
}

char *matc_explain_definition(MatcDocument *d, const char *name)
{
    Arena arena = {0};
    Text out = text_new(&arena);
    const Member *definition = definition_of(d, name);
    if (!definition)
        return NULL;
    const Tree *tree = definition->value;
    const Source *source = &d->session.sources[definition->span.file];
    const Member *params = tree->kind == TREE_object ? tree_find(tree, "params") : NULL;
    text_format(&out, "%s (definition)\n", name);
    if (*doc_of(tree))
        text_format(&out, "%s\n", doc_of(tree));
    text_format(&out, "\nIn %s, line %d\n", source->name,
                source_position(source, definition->span.start).line);
    if (params && params->value->kind == TREE_object)
        put_parameters(&arena, &out, &d->session, params->value);
    text_put(&out, "\nUse\n");
    if (!strncmp(source->name, SHIPPED_FOLDER, sizeof SHIPPED_FOLDER - 1))
        text_format(&out, "  include: %s\n", source->name + sizeof SHIPPED_FOLDER - 1);
    text_format(&out, "  { ref: %s }\n", name);
    return text_given(&arena, &out);
}

/* Returns the page of a library definition with its parameters; NULL if unknown. */
static char *explain_shipped(const char *name)
{
    const LibraryName *shipped = NULL;
    for (int i = 0; i < library_name_count && !shipped; i++)
        shipped = strcmp(library_names[i].name, name) ? NULL : &library_names[i];
    if (!shipped)
        return NULL;
    Arena arena = {0};
    Text text = text_new(&arena);
    MatcOptions options;
    matc_options_init(&options);
    text_format(&text, "include: %s\n", shipped->file);
    MatcDocument *document = matc_read("<library>", text.at, text.size, &options);
    char *page = matc_explain_definition(document, name);
    matc_document_free(document);
    arena_free(&arena);
    return page;
}

/* Returns the page of a library definition, followed by pages of the name from the tables. */
char *matc_explain(const char *name)
{
    if (!name)
        return NULL;
    char *shipped = explain_shipped(name), *known = describe_explain(name);
    if (!shipped || !known)
        return shipped ? shipped : known;
    const size_t size = strlen(shipped) + strlen(known) + sizeof "\n";
    char *both = malloc(size);
    if (!both)
        abort();
    snprintf(both, size, "%s\n%s", shipped, known);
    free(shipped);
    free(known);
    return both;
}

/* Writes the schema of an argument: a value of its type within its range, or a param of the
 * enclosing definition. */
static void put_argument_schema(Text *out, const Member *member, const Parameter *p)
{
    static const char *const types[PARAMETER_TYPES] = {
        [PARAMETER_number] = "{\"$ref\": \"#/$defs/number\"}",
        [PARAMETER_color] = "{\"$ref\": \"#/$defs/map\"}",
        [PARAMETER_map] = "{\"$ref\": \"#/$defs/map\"}",
        [PARAMETER_material] = "{\"$ref\": \"#/$defs/material\"}",
        [PARAMETER_wave] = "{\"$ref\": \"#/$defs/wave\"}",
        [PARAMETER_transform] = "{\"$ref\": \"#/$defs/transform\"}",
        [PARAMETER_bool] = "{\"type\": [\"boolean\", \"null\"]}",
        [PARAMETER_text] = "{\"type\": [\"string\", \"null\"]}",
    };
    double bound;
    text_put(out, "{");
    json_member(out, "description", doc_of(member->value));
    text_format(out, ", \"anyOf\": [%s, {\"type\": \"object\", \"required\": [\"param\"]}]",
                types[p->type]);
    if (p->low && tree_number(p->low, &bound)) {
        text_put(out, ", \"minimum\": ");
        text_double(out, bound);
    }
    if (p->high && tree_number(p->high, &bound)) {
        text_put(out, ", \"maximum\": ");
        text_double(out, bound);
    }
    text_put(out, "}");
}

/* Writes the schema of a use of a definition, inside the document or at its top level. */
static void put_use_schema(Text *out, Session *session, const Member *definition, bool outermost)
{
    const Tree *tree = definition->value;
    const Member *params = tree->kind == TREE_object ? tree_find(tree, "params") : NULL;
    const uint32_t count = params && params->value->kind == TREE_object ? params->value->count : 0;
    Resolver r = {.session = session};
    Text wanted = text_new(out->arena);
    text_put(out, "        {\n          ");
    json_member(out, "description", doc_of(tree));
    text_put(out, ",\n          \"type\": \"object\", \"additionalProperties\": false, "
                  "\"properties\": {\n            \"ref\": {\"const\": ");
    json_string(out, definition->key);
    text_put(out, "}");
    for (uint32_t i = 0; i < count; i++) {
        Parameter p;
        if (!resolve_parameter(&r, &params->value->members[i], &p) ||
            (outermost && resolve_is_document_key(params->value->members[i].key)))
            continue;
        text_put(out, ",\n            ");
        json_key(out, params->value->members[i].key);
        put_argument_schema(out, &params->value->members[i], &p);
        if (!p.init) {
            text_put(&wanted, ", ");
            json_string(&wanted, params->value->members[i].key);
        }
    }
    if (outermost) {
        text_put(out, ",\n");
        describe_beside(out);
    }
    text_put(out, "\n          }, \"required\": [\"ref\"");
    text_put(out, wanted.size ? wanted.at : "");
    text_put(out, "]\n        }");
}

/* Writes uses of all definitions of a document and its includes, for "anyOf". */
static void put_uses_schema(Text *out, MatcDocument *d, bool outermost)
{
    bool first = true;
    text_put(out, "{\n      \"description\": \"A map or material of `defs:`, the document's own or "
                  "of a file that it "
                  "includes.\",\n"
                  "      \"type\": \"object\", \"required\": [\"ref\"], \"anyOf\": [\n");
    for (int i = 0; i < d->graph->def_count; i++)
        for (uint32_t k = 0; k < d->graph->defs[i]->count; k++) {
            const Member *member = &d->graph->defs[i]->members[k];
            if (definition_of(d, member->key) != member)
                continue;
            text_put(out, first ? "" : ",\n");
            put_use_schema(out, &d->session, member, outermost);
            first = false;
        }
    text_put(out, first ? "        false\n      ]\n    }" : "\n      ]\n    }");
}

char *matc_document_schema(MatcDocument *d)
{
    Arena arena = {0};
    Text ref = text_new(&arena), document = text_new(&arena);
    if (!d || !d->graph)
        return NULL;
    put_uses_schema(&ref, d, false);
    put_uses_schema(&document, d, true);
    char *schema = describe_document_schema(ref.at, document.at);
    arena_free(&arena);
    return schema;
}
