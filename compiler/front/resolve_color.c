/* Colours of a document: "#rgb" and its like, names, and whether they are linear light or sRGB. `colors:` says it for a file,
 * srgb(...) and linear(...) for one colour. What a file says holds for what is written in that file, wherever it is used. */
#include "compiler/front/hint.h"
#include "compiler/front/mistake.h"
#include "runtime/library/srgb.h"
#include "compiler/base/text.h"
#include <string.h>

static const char *const space_names[] = {"linear", "srgb"};

bool resolve_is_srgb(const Resolver *r, uint32_t file) { return file < r->srgb_room && r->srgb_files[file]; }

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
        r->srgb_files = arena_reach(r->session->arena, r->srgb_files, file, &r->srgb_room, sizeof *r->srgb_files);
        r->srgb_files[file] = srgb;
        return true;
    }
    diag_add(r->session, name->span, DIAG_wrong_type, "colors", "linear or srgb", tree_describe(r->session, name));
    return false;
}

static const char *color_name(const void *user, int i)
{
    (void)user;
    return color_table[i].name;
}

/* #rgb, #rrggbb, #rrggbbaa */
static bool hex_color(const char *text, Value *value)
{
    size_t size = strlen(text + 1);
    if (strspn(text + 1, "0123456789abcdefABCDEF") != size || (size != 3 && size != 6 && size != 8))
        return false;
    int lanes = size == 8 ? 4 : 3, digits = size == 3 ? 1 : 2;
    for (int i = 0; i < lanes; i++) {
        const char *at = text + 1 + i * digits;
        value->number[i] = (text_hex_digit(at[0]) * 16 + text_hex_digit(at[digits - 1])) / 255.0;
    }
    value->type = lanes == 4 ? TYPE_vec4 : TYPE_vec3;
    return true;
}

static bool named_color(Resolver *r, const Tree *tree, const char *text, Value *value)
{
    for (int i = 0; i < color_count; i++) {
        if (strcmp(color_table[i].name, text) != 0)
            continue;
        for (int lane = 0; lane < 3; lane++)
            value->number[lane] = color_table[i].rgb[lane] / 255.0;
        value->type = TYPE_vec3;
        return true;
    }
    if (mistake_hex(r, tree, text) || hint_color_name(r, tree, text))
        return false;
    const char *near = diag_suggest(r->session, text, color_name, NULL, color_count);
    diag_add(r->session, tree->span, DIAG_unknown_color, text, near);
    return false;
}

/* "srgb(orange)" -> "orange", and *srgb is set; a text of another form is itself. */
static const char *within_space(Resolver *r, const char *text, bool *srgb)
{
    size_t size = strlen(text);
    for (int space = 0; space < 2; space++) {
        size_t before = strlen(space_names[space]);
        if (strncmp(text, space_names[space], before) != 0 || text[before] != '(' || text[size - 1] != ')')
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
    for (int lane = 0; srgb && lane < 3; lane++) /* alpha is a share, and no light */
        value->number[lane] = srgb_decode(value->number[lane]);
    value->color = true;
    return true;
}
