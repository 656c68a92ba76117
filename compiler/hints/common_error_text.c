/* Hints for texts in the place of a number, list or color: a list without brackets, a formula
 * without '=', an image's file name, the name of a param. */
#include "compiler/base/text.h"
#include "compiler/formula/formula.h"
#include "compiler/hints/hint.h"
#include "compiler/hints/common_error.h"
#include <string.h>

enum { MAX_SHOWN = 80 }; /* max bytes of a text that a hint repeats */

/* Returns "0.1 0.2 0.3" or "(0.1, 0.2, 0.3)" as a list in brackets; NULL: the text is no list of
 * numbers. */
static const char *list_of(const Session *session, const char *text)
{
    Text list = text_new(session->arena);
    int count = 0;
    text_put(&list, "[");
    for (const char *at = text + strspn(text, "( "); *at; at += strspn(at, ", ])")) {
        const size_t size = strcspn(at, ", ])");
        const char *number = arena_string(session->arena, at, size);
        double value;
        if (!text_number(number, size, &value))
            return NULL;
        text_format(&list, "%s%s", count++ ? ", " : "", number);
        at += size;
    }
    text_put(&list, "]");
    return count > 1 ? list.at : NULL;
}

bool common_error_list(Resolver *r, const Tree *tree)
{
    if (tree->kind != TREE_scalar || !tree->plain || tree->count > MAX_SHOWN)
        return false;
    const char *list = list_of(r->session, tree->text);
    if (list && r->one_number && r->param)
        diag_add(r->session, tree->span, DIAG_wrong_type, r->param, "one number or a map",
                 tree_describe(r->session, tree));
    else if (list)
        diag_add(r->session, tree->span, DIAG_bare_list, list);
    return list != NULL;
}

static bool ends_as_picture(const Tree *tree)
{
    static const char *const endings[] = {".png",  ".jpg", ".jpeg", ".exr", ".bmp", ".gif",
                                          ".tga",  ".tif", ".webp", ".hdr", ".PNG", ".JPG",
                                          ".JPEG", ".EXR", ".BMP",  ".GIF"};
    for (size_t i = 0; i < sizeof endings / sizeof *endings; i++) {
        const size_t size = strlen(endings[i]);
        if (tree->count > size && !strcmp(tree->text + tree->count - size, endings[i]))
            return true;
    }
    return false;
}

/* Returns true if the text has an operator or a call, or is a quantity of formulas. */
static bool looks_like_formula(const char *text, size_t size)
{
    static const char *const colors[] = {"srgb(", "linear(", "rgb(", "rgba(", "hsl(", "hsv(", "#"};
    for (size_t i = 0; i < sizeof colors / sizeof *colors; i++)
        if (!strncmp(text, colors[i], strlen(colors[i])))
            return false;
    if (quantity_named(text, (uint32_t)size) != QUANTITY_none)
        return true;
    const bool starts = text_is_alphanumeric(*text) || strchr("(.-+!", *text);
    return starts && (strpbrk(text, "*/^(?<>") || strstr(text, " - ") || strstr(text, " + "));
}

bool common_error_formula(Resolver *r, const Tree *tree)
{
    if (tree->kind != TREE_scalar || !tree->count || strlen(tree->text) != tree->count)
        return false;
    if (ends_as_picture(tree) && hint_backslash(r->session, tree->span))
        return true;
    if (ends_as_picture(tree)) {
        diag_add(r->session, tree->span, DIAG_bare_name, tree->text,
                 "an image file, not a color; write", "map: ImageMap, image", tree->text);
        return true;
    }
    if (!looks_like_formula(tree->text, tree->count))
        return false;
    diag_add(r->session, tree->span, DIAG_bare_formula,
             tree->count > MAX_SHOWN ? "..." : tree->text);
    return true;
}

/* Returns the parameter of the current definition with this name; NULL: none. */
static const Member *parameter_called(const Resolver *r, const char *name)
{
    const Member *params = r->definition ? tree_find(r->definition->value, "params") : NULL;
    return params && params->value->kind == TREE_object ? tree_find(params->value, name) : NULL;
}

bool common_error_param(Resolver *r, const Tree *tree)
{
    if (tree->kind != TREE_scalar)
        return false;
    const bool own = parameter_called(r, tree->text);
    if (!own && names_find(&r->uniform_names, tree->text) < 0)
        return false;
    Text name = text_new(r->session->arena);
    text_format(&name, "%s%s", tree->text, own ? "" : ", default: ...");
    diag_add(r->session, tree->span, DIAG_bare_name, tree->text,
             own ? "a parameter; use it with" : "a param; use it with", "param", name.at);
    return true;
}
