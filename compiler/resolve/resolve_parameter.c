/* Parameters of definitions: `count: 8`, or `count: { default: 8, type: number, min: 1, max: 64,
 * doc: "Stripes." }`. Requirements that the type does not express are checked where the
 * definition uses the argument. */
#include "compiler/resolve/resolve_parameter.h"
#include <string.h>

static const char *const type_names[PARAMETER_TYPES] = {"number", "color",     "map",  "material",
                                                        "wave",   "transform", "bool", "text"};

static const char *type_name(const void *user, int i)
{
    (void)user;
    return type_names[i];
}

static bool has_any(const Tree *tree, const char *const keys[], int count)
{
    for (int i = 0; i < count; i++)
        if (tree_find(tree, keys[i]))
            return true;
    return false;
}

static bool is_truth(const Tree *tree)
{
    return tree->kind == TREE_scalar && tree->plain &&
           (!strcmp(tree->text, "true") || !strcmp(tree->text, "false"));
}

static bool is_number(const Tree *tree)
{
    double number;
    return tree->kind == TREE_scalar && tree_number(tree, &number);
}

/* Returns true for a formula, which can replace any value made of numbers. */
static bool is_formula(const Tree *tree)
{
    return tree->kind == TREE_scalar && tree->text[0] == '=';
}

/* Infers a parameter's type from its default. */
static ParameterType type_of(const Tree *tree)
{
    static const char *const transforms[] = {"scale", "translation", "rotation", "shear", "matrix"};
    if (tree->kind == TREE_list)
        return PARAMETER_color;
    if (tree->kind == TREE_object)
        return tree_find(tree, "material")    ? PARAMETER_material
               : tree_find(tree, "wave")      ? PARAMETER_wave
               : tree_find(tree, "param")     ? PARAMETER_number
               : has_any(tree, transforms, 5) ? PARAMETER_transform
                                              : PARAMETER_map;
    if (is_number(tree))
        return PARAMETER_number;
    if (is_truth(tree))
        return PARAMETER_bool;
    for (int i = 0; i < color_count; i++)
        if (!strcmp(color_table[i].name, tree->text))
            return PARAMETER_color;
    for (int i = 0; i < WAVE_COUNT; i++)
        if (!strcmp(wave_table[i].name, tree->text))
            return PARAMETER_wave;
    return tree_is_null(tree) || strchr("#=", tree->text[0]) || !strncmp(tree->text, "srgb(", 5)
               ? PARAMETER_color
               : PARAMETER_text;
}

const char *resolve_parameter_type(ParameterType type) { return type_names[type]; }

/* Returns true if a type accepts an argument. Colors and maps are interchangeable. */
static bool fits(ParameterType type, const Tree *tree)
{
    /* other faults in them are reported by name */
    static const char *const others[] = {"map", "material", "wave", "ref"};
    const bool scalar = tree->kind == TREE_scalar, object = tree->kind == TREE_object;
    switch (type) {
    case PARAMETER_number:
        return is_number(tree) || is_formula(tree) || (object && tree_find(tree, "param"));
    case PARAMETER_color:
    case PARAMETER_map:
        return !is_truth(tree) && !(object && tree_find(tree, "material"));
    case PARAMETER_material:
        return object && (tree_find(tree, "material") || tree_find(tree, "ref"));
    case PARAMETER_wave:
        return (scalar && !is_number(tree)) || (object && tree_find(tree, "wave"));
    case PARAMETER_transform:
        return object && !has_any(tree, others, 4);
    case PARAMETER_bool:
        return is_truth(tree);
    default:
        return scalar;
    }
}

static bool read_type(Resolver *r, const Tree *tree, ParameterType *type)
{
    for (int i = 0; tree->kind == TREE_scalar && i < PARAMETER_TYPES; i++)
        if (!strcmp(type_names[i], tree->text)) {
            *type = (ParameterType)i;
            return true;
        }
    const char *near =
        tree->kind == TREE_scalar
            ? diag_suggest_or_list(r->session, tree->text,
                                   &(NameChoice){type_name, NULL, PARAMETER_TYPES}, "; there are ")
            : "";
    diag_add(r->session, tree->span, DIAG_parameter_type, tree_describe(r->session, tree), near);
    return false;
}

static const char *const declaration_keys[] = {"default", "type", "doc", "min", "max"};
enum { DECLARATION_KEYS = sizeof declaration_keys / sizeof *declaration_keys };

static const char *declaration_key(const void *user, int i)
{
    (void)user;
    return declaration_keys[i];
}

static bool is_declaration(const Tree *tree)
{
    return tree->kind == TREE_object && (tree_find(tree, "default") || tree_find(tree, "type")) &&
           !tree_find(tree, "param");
}

static bool read_bound(Resolver *r, const Tree *declaration, const char *key, const Tree **bound)
{
    const Member *member = tree_find(declaration, key);
    *bound = member ? member->value : NULL;
    if (!member || is_number(member->value))
        return true;
    diag_add(r->session, member->value->span, DIAG_wrong_type, key, "a number",
             tree_describe(r->session, member->value));
    return false;
}

/* Parses name: default, or name: { default, type, doc, min, max } */
bool resolve_parameter(Resolver *r, const Member *member, Parameter *p)
{
    Tree *tree = member->value;
    *p = (Parameter){.member = member, .init = tree, .type = PARAMETER_map};
    if (!is_declaration(tree)) {
        p->type = type_of(tree);
        return true;
    }
    const Member *init = tree_find(tree, "default"), *type = tree_find(tree, "type");
    for (uint32_t i = 0; i < tree->count; i++) {
        const char *key = tree->members[i].key;
        bool known = false;
        for (int k = 0; k < DECLARATION_KEYS; k++)
            known |= !strcmp(key, declaration_keys[k]);
        if (!known)
            return diag_add(r->session, tree->members[i].span, DIAG_declaration_keys, key,
                            diag_suggest(r->session, key, declaration_key, NULL, DECLARATION_KEYS));
    }
    p->init = init ? init->value : NULL;
    if (init)
        p->type = type_of(init->value);
    if (type && !read_type(r, type->value, &p->type))
        return false;
    return read_bound(r, tree, "min", &p->low) && read_bound(r, tree, "max", &p->high);
}

void resolve_report_parameter(Resolver *r, const Member *definition, const Parameter *p)
{
    diag_add(r->session, p->member->span, DIAG_parameter_here, p->member->key, definition->key);
}

static bool in_bounds(Resolver *r, const Parameter *p, const Tree *tree)
{
    double low = 0, high = 0, number = 0;
    if (!tree_number(tree, &number) || (!p->low && !p->high))
        return true;
    const bool below = p->low && tree_number(p->low, &low) && number < low;
    const bool above = p->high && tree_number(p->high, &high) && number > high;
    if (!above && !below)
        return true;
    diag_add(r->session, tree->span, DIAG_out_of_range, p->member->key, tree->text,
             p->low ? p->low->text : "any", p->high ? p->high->text : "any");
    return false;
}

bool resolve_argument(Resolver *r, const Member *definition, const Parameter *p, const Tree *tree)
{
    static const char *const wanted[PARAMETER_TYPES] = {
        "a number", "a color or a map", "a map or a color", "a material",
        "a wave",   "a transformation", "true or false",    "a word"};
    const bool suits = fits(p->type, tree);
    if (suits && (tree->kind != TREE_scalar || in_bounds(r, p, tree)))
        return true;
    if (!suits)
        diag_add(r->session, tree->span, DIAG_wrong_type, p->member->key, wanted[p->type],
                 tree_describe(r->session, tree));
    resolve_report_parameter(r, definition, p);
    return false;
}
