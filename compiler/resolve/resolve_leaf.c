/* Values of parameters that contain no map: numbers, booleans, keywords, images, waves,
 * transforms. Checks type and range, and applies the default, by the row of the tables. */
#include "compiler/images/image.h"
#include "compiler/resolve/resolve.h"
#include <math.h>
#include <string.h>

static void put_number(Text *out, const ParamRow *row, double value)
{
    if (row->type == PARAM_Int)
        text_int(out, (long)value);
    else
        text_double(out, value);
}

bool resolve_in_range(Resolver *r, const ParamRow *row, const Tree *tree, const Value *value)
{
    const double *components =
        value->kind == VALUE_uniform ? value->uniform->initial : value->number;
    for (int i = 0; i < type_table[value->type].components; i++) {
        if (components[i] >= row->low && components[i] <= row->high)
            continue;
        Text is = text_new(r->session->arena), low = text_new(r->session->arena),
             high = text_new(r->session->arena);
        put_number(&is, row, components[i]);
        put_number(&low, row, row->low);
        put_number(&high, row, row->high);
        diag_add(r->session, tree->span, DIAG_out_of_range, row->name, is.at, low.at, high.at);
        return false;
    }
    return true;
}

static bool resolve_whole(Resolver *r, const ParamRow *row, const Tree *tree, const Value *value)
{
    const double *number = value->kind == VALUE_uniform ? value->uniform->initial : value->number;
    /* the number is in the range of a GLSL int */
    if (*number == trunc(*number) && fabs(*number) < 2147483648.0)
        return true;
    diag_add(r->session, tree->span, DIAG_not_whole, row->name, tree_describe(r->session, tree));
    return false;
}

static bool resolve_bool(Resolver *r, const ParamRow *row, const Tree *tree, Value *value)
{
    bool yes = tree->kind == TREE_scalar && tree->plain && !strcmp(tree->text, "true");
    if (!yes && !(tree->kind == TREE_scalar && tree->plain && !strcmp(tree->text, "false"))) {
        diag_add(r->session, tree->span, DIAG_wrong_type, row->name, "true or false",
                 tree_describe(r->session, tree));
        return false;
    }
    *value = (Value){.kind = VALUE_number, .type = TYPE_bool, .number = {yes}};
    return true;
}

/* Lists the keywords of a list: "r, g, b or a". */
static const char *names_of_words(Resolver *r, ParamKind list)
{
    Text text = text_new(r->session->arena);
    for (int i = 0, first = 1; i < WORD_COUNT; i++) {
        if (keyword_table[i].list != list)
            continue;
        bool last = i + 1 == WORD_COUNT || keyword_table[i + 1].list != list;
        text_format(&text, "%s%s", first ? "" : last ? " or " : ", ", keyword_table[i].name);
        first = 0;
    }
    return text.at;
}

/* Returns the keyword of a list that is equivalent to false or true; -1 if the value is neither,
 * or no keyword is equivalent. */
static int truth_of(ParamKind list, const Tree *tree)
{
    const bool yes = tree->kind == TREE_scalar && tree->plain && !strcmp(tree->text, "true");
    const bool no = tree->kind == TREE_scalar && tree->plain && !strcmp(tree->text, "false");
    return yes || no ? word_of_truth(list, yes) : -1;
}

static bool resolve_word(Resolver *r, const ParamRow *row, const Tree *tree, Value *value)
{
    const int truth = truth_of(row->type, tree);
    if (truth >= 0) {
        *value = (Value){.kind = VALUE_number, .type = TYPE_int, .number = {truth}};
        return true;
    }
    for (int i = 0; tree->kind == TREE_scalar && i < WORD_COUNT; i++)
        if (keyword_table[i].list == row->type && !strcmp(keyword_table[i].name, tree->text)) {
            *value = (Value){.kind = VALUE_number, .type = TYPE_int, .number = {i}};
            return true;
        }
    diag_add(r->session, tree->span, DIAG_wrong_type, row->name, names_of_words(r, row->type),
             tree_describe(r->session, tree));
    return false;
}

static bool resolve_image(Resolver *r, const ParamRow *row, const Tree *tree, Value *value)
{
    if (tree->kind != TREE_scalar) {
        diag_add(r->session, tree->span, DIAG_wrong_type, row->name, "the name of an image file",
                 tree_describe(r->session, tree));
        return false;
    }
    *value = (Value){.kind = VALUE_image, .image = image_load(r, tree->text, tree->span)};
    return value->image != NULL;
}

static bool resolve_numeric(Resolver *r, const ParamRow *row, Tree *tree, Value *value)
{
    bool vector = row->type == PARAM_Vec3, constant = row->kind == KIND_Constant;
    const ComponentCount components = {vector ? 3 : 1, vector ? 3 : constant ? 4 : 1};
    if (!resolve_number(r, row->name, tree, components, value))
        return false;
    return (row->type != PARAM_Int || resolve_whole(r, row, tree, value)) &&
           resolve_in_range(r, row, tree, value);
}

/* Warns about `diffuse: #ff0000`, an empty value followed by a comment. */
static void warn_of_comment(Resolver *r, const Tree *tree)
{
    const Source *source = &r->session->sources[tree->span.file];
    if (tree->count || tree->span.start >= source->size)
        return;
    const char *at = source->text + tree->span.start;
    at += strspn(at, " ");
    uint32_t start = (uint32_t)(at - source->text);
    if (*at == '#')
        diag_add(r->session,
                 (Span){start, start + 1 + (uint32_t)strspn(at + 1, "0123456789abcdefABCDEF"),
                        tree->span.file},
                 DIAG_unquoted_color);
}

Value resolve_null(Resolver *r, const ParamRow *row, const Tree *tree)
{
    warn_of_comment(r, tree);
    return row->type == PARAM_Map && !row->components ? (Value){0} : resolve_default(r, row);
}

static bool resolve_transformation(Resolver *r, Tree *tree, Value *value)
{
    Transform *transform = ARENA_NEW(r->session->arena, Transform);
    *value = (Value){.kind = VALUE_transform, .transform = transform};
    return resolve_transform(r, tree, transform);
}

bool resolve_leaf(Resolver *r, const ParamRow *row, Tree *tree, Value *value)
{
    switch (row->type) {
    case PARAM_Float:
    case PARAM_Int:
    case PARAM_Vec3:
        return resolve_numeric(r, row, tree, value);
    case PARAM_Bool:
        return resolve_bool(r, row, tree, value);
    case PARAM_Image:
        return resolve_image(r, row, tree, value);
    case PARAM_Formula: /* a formula is resolved together with its maps */
        return true;
    case PARAM_Wave:
        value->kind = VALUE_wave;
        return resolve_wave(r, tree, &value->wave);
    case PARAM_Transform:
        return resolve_transformation(r, tree, value);
    default:
        return resolve_word(r, row, tree, value);
    }
}
