/* Colors of a document: hex colors, names, and the choice between linear light and sRGB.
 * `colors:` selects for a file, srgb(...) and linear(...) for one color. A file's choice applies
 * to the colors written in that file, wherever they are used. */
#include "compiler/hints/hint.h"
#include "compiler/hints/common_error.h"
#include "compiler/library/srgb.h"
#include "compiler/base/text.h"
#include "compiler/base/warnings.h"
#include <string.h>

enum { ADVISED_DIGITS = 3 }; /* decimals of numbers in the advice */

static const char *const space_names[] = {"linear", "srgb"};

static FileColors file_colors(const Resolver *r, uint32_t file)
{
    return file < r->file_color_capacity ? (FileColors)r->file_colors[file]
                                         : FILE_COLORS_undeclared;
}

bool resolve_is_srgb(const Resolver *r, uint32_t file)
{
    return file_colors(r, file) == FILE_COLORS_srgb;
}

bool resolve_color_space(Resolver *r, const Tree *document)
{
    const Member *colors = tree_find(document, "colors");
    if (!colors || tree_is_null(colors->value))
        return true;
    const Tree *name = colors->value;
    for (int srgb = 0; name->kind == TREE_scalar && srgb < 2; srgb++) {
        if (strcmp(name->text, space_names[srgb]) != 0)
            continue;
        const uint32_t file = name->span.file;
        r->file_colors = arena_reach(r->session->arena, r->file_colors, file,
                                     &r->file_color_capacity, sizeof *r->file_colors);
        r->file_colors[file] = (unsigned char)(srgb ? FILE_COLORS_srgb : FILE_COLORS_linear);
        return true;
    }
    diag_add(r->session, name->span, DIAG_wrong_type, "colors", "linear or srgb",
             tree_describe(r->session, name));
    return false;
}

/* -- Advice about hex colors without `colors:` */

/* Returns true if all components are 0 or 1, which are equal in sRGB and linear light. */
static bool is_pure(const double *components)
{
    bool pure = true;
    for (int component = 0; component < 3; component++)
        pure &= components[component] == 0 || components[component] == 1;
    return pure;
}

static bool is_advised(const Session *session, uint32_t file)
{
    for (size_t i = 0; i < session->diags.count; i++)
        if (session->diags.at[i].kind == DIAG_linear_colors &&
            session->diags.at[i].span.file == file)
            return true;
    return false;
}

/* Formats three components: "[0.91, 0.878, 0.8]". */
static const char *three_components(Session *session, const double *components, bool srgb)
{
    Text list = text_new(session->arena);
    for (int component = 0; component < 3; component++) {
        text_put(&list, component ? ", " : "[");
        text_rounded(&list, srgb ? srgb_decode(components[component]) : components[component],
                     ADVISED_DIGITS);
    }
    text_put(&list, "]");
    return list.at;
}

void resolve_advise_colors(Resolver *r, Span span, const char *hex, const double *components)
{
    Session *session = r->session;
    const bool off =
        warnings_severity(session_warnings(session), DIAG_linear_colors) == SEVERITY_none;
    if (off || file_colors(r, span.file) != FILE_COLORS_undeclared || is_pure(components) ||
        is_advised(session, span.file))
        return;
    diag_add(session, span, DIAG_linear_colors, hex, three_components(session, components, false),
             three_components(session, components, true));
}

static const char *color_name(const void *user, int i)
{
    (void)user;
    return color_table[i].name;
}

/* Parses #rgb, #rrggbb or #rrggbbaa. */
static bool hex_color(const char *text, Value *value)
{
    size_t size = strlen(text + 1);
    if (strspn(text + 1, "0123456789abcdefABCDEF") != size || (size != 3 && size != 6 && size != 8))
        return false;
    int components = size == 8 ? 4 : 3, digits = size == 3 ? 1 : 2;
    for (int i = 0; i < components; i++) {
        const char *at = text + 1 + i * digits;
        value->number[i] = (text_hex_digit(at[0]) * 16 + text_hex_digit(at[digits - 1])) / 255.0;
    }
    value->type = components == 4 ? TYPE_vec4 : TYPE_vec3;
    return true;
}

static bool named_color(Resolver *r, const Tree *tree, const char *text, Value *value)
{
    for (int i = 0; i < color_count; i++) {
        if (strcmp(color_table[i].name, text) != 0)
            continue;
        for (int component = 0; component < 3; component++)
            value->number[component] = color_table[i].rgb[component] / 255.0;
        value->type = TYPE_vec3;
        return true;
    }
    if (common_error_hex(r, tree, text) || hint_color_name(r, tree, text))
        return false;
    const char *near = diag_suggest(r->session, text, color_name, NULL, color_count);
    diag_add(r->session, tree->span, DIAG_unknown_color, text, near);
    return false;
}

/* Returns the color inside srgb(...) or linear(...) and sets *srgb: "srgb(orange)" -> "orange".
 * Other text is returned unchanged. */
static const char *within_space(Resolver *r, const char *text, bool *srgb)
{
    size_t size = strlen(text);
    for (int space = 0; space < 2; space++) {
        size_t before = strlen(space_names[space]);
        if (strncmp(text, space_names[space], before) != 0 || text[before] != '(' ||
            text[size - 1] != ')')
            continue;
        *srgb = space;
        return arena_string(r->session->arena, text + before + 1, size - before - 2);
    }
    return text;
}

bool resolve_color(Resolver *r, const Tree *tree, Value *value)
{
    bool srgb = resolve_is_srgb(r, tree->span.file);
    const char *text = within_space(r, tree->text, &srgb);
    if (text[0] == '#' && !hex_color(text, value)) {
        diag_add(r->session, tree->span, DIAG_bad_color, text);
        return false;
    }
    if (text[0] != '#' && !named_color(r, tree, text, value))
        return false;
    if (text == tree->text && text[0] == '#')
        resolve_advise_colors(r, tree->span, text, value->number);
    /* converts no alpha, which is a coverage and not light */
    for (int component = 0; srgb && component < 3; component++)
        value->number[component] = srgb_decode(value->number[component]);
    value->color = true;
    return true;
}
