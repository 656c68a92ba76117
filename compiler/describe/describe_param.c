/* Pages of parameters by name, with the maps, materials and scene parts that have them, and
 * their keywords. Equal descriptions are merged into a paragraph. */
#include "compiler/describe/describe.h"
#include <string.h>

enum { PARAMS = PARAM_COUNT + SCENE_PARAM_COUNT, KEYWORD_WIDTH = 14 };

/* Returns the i-th row: parameters of maps and materials, then those of scenes. */
static const ParamRow *row_of(int i)
{
    return i < PARAM_COUNT ? &param_table[i] : &scene_param_table[i - PARAM_COUNT].param;
}

static const char *owner_of(int i)
{
    return i < PARAM_COUNT ? kind_table[param_table[i].kind].name
                           : scene_kind_table[scene_param_table[i - PARAM_COUNT].kind].name;
}

static const char *type_of(int i)
{
    return i < PARAM_COUNT ? describe_type(row_of(i))
                           : describe_scene_type(&scene_param_table[i - PARAM_COUNT]);
}

static const char *range_of(Arena *arena, int i)
{
    Text text = text_new(arena);
    text_put(&text, "");
    if (i < PARAM_COUNT || scene_param_table[i - PARAM_COUNT].value == SCENE_VALUE_plain)
        describe_range(&text, row_of(i));
    return text.at;
}

static bool says_same(Arena *arena, int a, int b)
{
    const ParamRow *x = row_of(a), *y = row_of(b);
    return !strcmp(x->doc, y->doc) && !strcmp(type_of(a), type_of(b)) && x->type == y->type &&
           x->components == y->components && !memcmp(x->init, y->init, sizeof x->init) &&
           !strcmp(range_of(arena, a), range_of(arena, b));
}

static void put_choices(Text *out, const ParamRow *row)
{
    for (int i = 0; i < WORD_COUNT && param_is_word(row); i++)
        if (keyword_table[i].list == row->type)
            text_format(out, "  %-*s  %s\n", KEYWORD_WIDTH, keyword_table[i].name,
                        keyword_table[i].doc);
}

/* Writes a paragraph for all owners of parameters that are described like the i-th. */
static void put_paragraph(Text *out, int i, bool done[PARAMS])
{
    const ParamRow *row = row_of(i);
    const char *before = "of ", *range = range_of(out->arena, i);
    for (int k = i; k < PARAMS; k++)
        if (!done[k] && !strcmp(row_of(k)->name, row->name) && says_same(out->arena, i, k)) {
            text_format(out, "%s%s", before, owner_of(k));
            before = ", ";
            done[k] = true;
        }
    text_format(out, "\n  %s, default ", type_of(i));
    describe_default(out, row, NULL);
    text_format(out, "%s%s. %s\n", *range ? ", " : "", range, row->doc);
    put_choices(out, row);
}

void describe_params(Text *out, const char *name, DescribeCompare *same)
{
    bool done[PARAMS] = {false}, begun = false;
    for (int i = 0; i < PARAMS; i++) {
        if (done[i] || same(name, row_of(i)->name) != 0)
            continue;
        if (!begun)
            text_format(out, "%s%s (parameter)\n", out->size ? "\n" : "", row_of(i)->name);
        begun = true;
        put_paragraph(out, i, done);
    }
}

/* Returns the name of a parameter whose value is a keyword of that list. */
static const char *param_with(ParamKind list)
{
    for (int i = 0; i < PARAMS; i++)
        if (row_of(i)->type == list)
            return row_of(i)->name;
    return "a parameter";
}

void describe_words(Text *out, const char *name, DescribeCompare *same)
{
    for (int i = 0; i < WORD_COUNT; i++)
        if (same(name, keyword_table[i].name) == 0)
            text_format(out, "%s%s (choice of %s)\n%s\n", out->size ? "\n" : "",
                        keyword_table[i].name, param_with(keyword_table[i].list),
                        keyword_table[i].doc);
}
