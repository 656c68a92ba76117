/* Hints for text that is valid YAML with an unintended meaning: `n = value` in place of `n:
 * value`, Windows paths in double quotes, documents without `material:`. */
#include "compiler/base/text.h"
#include "compiler/hints/hint.h"
#include <string.h>

/* -- `n = fbm(p, 3)` */

static size_t word_size(const char *text)
{
    size_t size = 0;
    while (text_is_alphanumeric(text[size]) || text[size] == '_')
        size++;
    return text_is_letter(*text) || *text == '_' ? size : 0;
}

/* Formats a value as it must be written: a formula in quotes after '=', a color in quotes, a
 * number or a word unchanged. */
static const char *written_value(Session *session, const char *value, size_t size)
{
    Text text = text_new(session->arena);
    double number;
    const char *alone = arena_string(session->arena, value, size);
    const bool bare = text_number(alone, size, &number) || word_size(alone) == size;
    text_format(&text, bare ? "%s" : *alone == '#' ? "\"%s\"" : "\"= %s\"", alone);
    return text.at;
}

/* Reports "n = fbm(p, 3)" with its correction, which ends at the line's end. Returns false for
 * other text. */
static bool assigned(Session *session, Span span, const char *text)
{
    const size_t name = word_size(text), space = strspn(text + name, " ");
    const char *value = text + name + space + 1;
    if (!name || text[name + space] != '=' || *value == '=')
        return false;
    value += strspn(value, " ");
    const Source *source = &session->sources[span.file];
    const char *line = source->text + span.start, *end = line + strcspn(line, "\r\n");
    size_t size = strlen(value);
    const bool same = span.start < source->size && !strncmp(line, text, name);
    if (same && (size_t)(end - line) > (size_t)(value - text) &&
        (size_t)(end - line) - (size_t)(value - text) < size)
        size = (size_t)(end - line) - (size_t)(value - text);
    diag_add(session, span, DIAG_assigned, arena_string(session->arena, text, name),
             written_value(session, value, size));
    return true;
}

bool hint_assigned(Session *session, const Tree *tree)
{
    if (tree->kind == TREE_scalar)
        return tree->plain && assigned(session, tree->span, tree->text);
    for (uint32_t i = 0; tree->kind == TREE_object && i < tree->count; i++)
        if (tree_is_null(tree->members[i].value) &&
            assigned(session, tree->members[i].span, tree->members[i].key))
            return true;
    return false;
}

/* -- "C:\new\bricks.png" */

bool hint_backslash(Session *session, Span span)
{
    const Source *source = &session->sources[span.file];
    const char *at = source->text + span.start, *end = source->text + span.end;
    if (span.file == NO_FILE || span.end > source->size || at == end || *at != '"')
        return false;
    while (at < end && !(*at == '\\' && !strchr("\\\"/", at[1])))
        at += *at == '\\' ? 2 : 1;
    if (at >= end)
        return false;
    const uint32_t start = (uint32_t)(at - source->text);
    diag_add(session, (Span){start, start + 1, span.file}, DIAG_backslash);
    return true;
}

/* -- A document without a material */

static const char *material_called(const char *name)
{
    for (int kind = 0; kind < KIND_COUNT; kind++)
        if (kind_table[kind].lowering == LOWERING_MATERIAL &&
            text_same(kind_table[kind].name, name))
            return kind_table[kind].name;
    return NULL;
}

const char *hint_no_material(Session *session, const Tree *document)
{
    Text hint = text_new(session->arena);
    text_put(&hint, "");
    if (tree_find(document, "map"))
        text_put(&hint,
                 "; a map belongs in a material: `material: Phong` and `diffuse: { map: ... }`");
    for (uint32_t i = 0; i < document->count && !hint.size; i++) {
        const char *name = material_called(document->members[i].key);
        if (name)
            text_format(&hint, "; write `material: %s`, with its parameters at the same level",
                        name);
    }
    return hint.at;
}
