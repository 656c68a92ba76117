/* Hints for literal colors and lists in the place of a single number, with the parameter that
 * accepts them. */
#include "compiler/base/text.h"
#include "compiler/hints/hint.h"
#include "compiler/hints/common_error.h"
#include <math.h>
#include <string.h>

static bool reads_number(const ParamRow *row)
{
    return row->type == PARAM_Map && param_is_number((int)(row - param_table));
}

/* A list of a single number has its own message. A param may have several components, since
 * other places may read all of them. */
bool hint_number_list(Resolver *r, const ParamRow *row, const Tree *tree)
{
    double number;
    if (tree->kind != TREE_list || !reads_number(row) ||
        (tree->count == 1 && tree_number(tree->items[0], &number)))
        return false;
    diag_add(r->session, tree->span, DIAG_wrong_type, row->name, "one number or a map",
             tree_describe(r->session, tree));
    return true;
}

static size_t without_end(const char *name, size_t size, const char *end)
{
    const size_t length = strlen(end);
    const bool ends = size > length && !strncmp(name + size - length, end, length);
    return ends ? size - length : size;
}

/* Returns the parameter of the same kind that takes the color: emission -> emissionColor,
 * emissiveStrength -> emissiveFactor, base -> base_color. NULL: none. */
static const char *color_sibling(const ParamRow *row)
{
    static const char *const ends[] = {"Color", "_color", "ColorFactor", "Factor"};
    const KindRow *kind = &kind_table[row->kind];
    size_t stem = without_end(row->name, strlen(row->name), "Weight");
    stem = without_end(row->name, without_end(row->name, stem, "Factor"), "Strength");
    for (int i = kind->first; i < kind->first + kind->count; i++)
        for (size_t k = 0; k < sizeof ends / sizeof *ends; k++)
            if (!strncmp(param_table[i].name, row->name, stem) &&
                !strcmp(param_table[i].name + stem, ends[k]) && param_table[i].type == PARAM_Map &&
                !param_is_number(i))
                return param_table[i].name;
    return NULL;
}

static bool is_gray(const double components[4], int count)
{
    bool gray = true;
    for (int i = 1; i < count && i < 3; i++)
        gray &= components[i] == components[0];
    return gray;
}

/* Returns the components of a literal, or of a param whose default is written as a color. 0:
 * neither. */
static int literal_components(const Value *constant, const double **components)
{
    if (constant->kind != VALUE_number && !(constant->kind == VALUE_uniform && constant->color))
        return 0;
    *components = constant->kind == VALUE_number ? constant->number : constant->uniform->initial;
    return type_table[constant->type].components;
}

bool hint_number_color(Resolver *r, const ParamRow *row, const Tree *tree, const Value *constant)
{
    const double *components = NULL;
    const int count = reads_number(row) ? literal_components(constant, &components) : 0;
    if (!count || is_gray(components, count))
        return false;
    Text list = text_new(r->session->arena), mend = text_new(r->session->arena);
    for (int i = 0; i < count; i++) {
        text_put(&list, i ? ", " : "[");
        text_rounded(&list, components[i], 3);
    }
    text_put(&list, "]");
    const char *sibling = color_sibling(row);
    text_put(&mend, "");
    if (sibling)
        text_format(&mend, "; did you mean %s, or a number?", sibling);
    diag_add(r->session, tree->span, DIAG_color_number, row->name, list.at, mend.at);
    return true;
}
