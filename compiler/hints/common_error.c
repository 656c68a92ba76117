/* Hints for common errors of authors who know other formats. */
#include "compiler/hints/common_error.h"
#include "compiler/base/text.h"
#include "compiler/hints/hint.h"
#include <math.h>
#include <string.h>

/* Splits "45deg" into 45 and the unit "deg"; NULL unless the text is a number followed by
 * letters, a percent or a degree sign. */
static const char *unit_of(const Session *session, const char *text, double *number)
{
    const size_t digits = strspn(text, "+-.0123456789");
    const char *unit = text + digits + strspn(text + digits, " ");
    for (const char *c = unit; *c; c++)
        if (!text_is_letter(*c) && *c != '%' && !((unsigned char)*c & 0x80))
            return NULL;
    if (!*unit || text_same(unit, "e"))
        return NULL;
    /* The number is copied, since text_number() depends on the byte after it. */
    const char *alone = arena_string(session->arena, text, digits);
    return text_number(alone, digits, number) ? unit : NULL;
}

static bool report_unit(Resolver *r, const Tree *tree)
{
    double number;
    const char *unit = unit_of(r->session, tree->text, &number);
    if (!unit)
        return false;
    Text meant = text_new(r->session->arena);
    const bool degrees = text_same_start(unit, "deg", 3) || !strcmp(unit, "°"),
               percent = !strcmp(unit, "%");
    if (degrees)
        text_put(&meant, "; angles are in radians: ");
    else
        text_put(&meant, "; leave out the unit: ");
    text_double(&meant, degrees ? number * M_PI / 180 : percent ? number / 100 : number);
    diag_add(r->session, tree->span, DIAG_number_unit, tree->text, meant.at);
    return true;
}

bool common_error_number(Resolver *r, const Tree *tree)
{
    double number;
    if (tree->kind != TREE_scalar || !tree->count)
        return false;
    if (tree->plain)
        return report_unit(r, tree);
    if (!text_number(tree->text, tree->count, &number) || strlen(tree->text) != tree->count)
        return false;
    diag_add(r->session, tree->span, DIAG_quoted_number, tree->text);
    return true;
}

/* Words that are keys and need a colon. */
static bool is_key(const char *word)
{
    static const char *const others[] = {"map",   "material", "materials", "ref",
                                         "param", "defs",     "include",   "colors"};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (!strcmp(others[i], word))
            return true;
    for (int i = 0; i < PARAM_COUNT; i++)
        if (!strcmp(param_table[i].name, word))
            return true;
    return false;
}

bool common_error_key(Session *session, Span span, const char *text)
{
    const Source *source = &session->sources[span.file];
    const size_t size = strcspn(text, " :");
    if (!text[size] || !text[size + 1] || span.start + size >= source->size ||
        /* the text is in quotes, or folded over several lines */
        strncmp(source->text + span.start, text, size + 1) != 0)
        return false;
    const char *key = arena_string(session->arena, text, size);
    const uint32_t end = span.start + (uint32_t)size;
    if (!is_key(key))
        return false;
    if (text[size] == ':')
        diag_add(session, (Span){end, end + 1, span.file}, DIAG_no_space, key);
    else
        diag_add(session, (Span){span.start, end, span.file}, DIAG_no_colon, key);
    return true;
}

bool common_error_keys(Session *session, const Tree *object)
{
    for (uint32_t i = 0; i < object->count; i++)
        if (common_error_key(session, object->members[i].span, object->members[i].key))
            return true;
    return false;
}

bool common_error_hex(Resolver *r, const Tree *tree, const char *text)
{
    const size_t size = strlen(text);
    if (strspn(text, "0123456789abcdefABCDEF") != size || (size != 3 && size != 6 && size != 8))
        return false;
    Text near = text_new(r->session->arena);
    text_format(&near, "; did you mean \"#%s\"?", text);
    diag_add(r->session, tree->span, DIAG_unknown_color, text, near.at);
    return true;
}

/* Returns a map's correctly spelled name, found case-insensitively. */
static const char *map_name(const char *name)
{
    for (int kind = 0; kind < KIND_COUNT; kind++)
        if (kind_table[kind].lowering != LOWERING_MATERIAL &&
            text_same(kind_table[kind].name, name))
            return kind_table[kind].name;
    for (int i = 0; i < preset_count; i++)
        if (text_same(preset_table[i].name, name))
            return preset_table[i].name;
    return NULL;
}

static bool is_def(const Resolver *r, const char *name)
{
    for (size_t i = 0; i < r->def_count; i++)
        if (tree_find(r->defs[i], name))
            return true;
    return false;
}

static bool is_color(const char *name)
{
    for (int i = 0; i < color_count; i++)
        if (!strcmp(color_table[i].name, name))
            return true;
    return false;
}

bool common_error_map(Resolver *r, const Tree *tree)
{
    if (tree->kind != TREE_scalar || !text_is_letter(tree->text[0]) || is_color(tree->text))
        return false;
    if (common_error_key(r->session, tree->span, tree->text))
        return true;
    const char *map = map_name(tree->text);
    if (is_def(r, tree->text))
        diag_add(r->session, tree->span, DIAG_bare_name, tree->text, "a definition; use it with",
                 "ref", tree->text);
    else if (map)
        diag_add(r->session, tree->span, DIAG_bare_name, tree->text, "a map, not a color; write",
                 "map", map);
    else
        return hint_map_name(r, tree);
    return true;
}

const Member *common_error_case(const Tree *object, const char *key)
{
    for (uint32_t i = 0; i < object->count; i++)
        if (text_same(object->members[i].key, key))
            return &object->members[i];
    return NULL;
}

const char *common_error_foreign(Session *session, ForeignGroup group, Kind kind, const char *name)
{
    const char *here = diag_full(session) ? NULL : foreign_name(group, kind, name);
    if (!here)
        return NULL;
    Text text = text_new(session->arena);
    text_format(&text, "; here it is %s", here);
    return text.at;
}
