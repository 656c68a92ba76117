/* Numbers, lists of numbers, colors and params, as values of parameters. */
#include "compiler/base/text.h"
#include "compiler/hints/hint.h"
#include "compiler/hints/common_error.h"
#include "compiler/graph/reserved.h"
#include "compiler/resolve/resolve.h"
#include <float.h>
#include <math.h>
#include <string.h>

static const Type type_of_components[] = {TYPE_float, TYPE_float, TYPE_vec2, TYPE_vec3, TYPE_vec4};

bool resolve_fits_float(Resolver *r, const char *what, const Tree *tree, double number)
{
    if (fabs(number) <= FLT_MAX)
        return true;
    diag_add(r->session, tree->span, DIAG_too_large_number, what, tree->text);
    return false;
}

/* Reports [0.5] where 0.5 is sufficient. */
static bool report_single(Resolver *r, const char *what, const Tree *list,
                          ComponentCount components)
{
    double number;
    if (components.least > 1 || !tree_number(list->items[0], &number))
        return false;
    diag_add(r->session, list->span, DIAG_single_list, what, list->items[0]->text);
    return true;
}

static bool number_list(Resolver *r, const char *what, const Tree *tree, ComponentCount components,
                        Value *value)
{
    if (tree->count == 1 &&
        (common_error_list(r, tree->items[0]) || report_single(r, what, tree, components)))
        return false;
    if (tree->count < 2 || (int)tree->count < components.least ||
        (int)tree->count > components.most) {
        Text wanted = text_new(r->session->arena);
        if (components.most == 1)
            text_put(&wanted, "a number");
        else if (components.least == components.most)
            text_format(&wanted, "%d numbers", components.least);
        else
            text_format(&wanted, "%d to %d numbers", components.least > 2 ? components.least : 2,
                        components.most);
        diag_add(r->session, tree->span, DIAG_wrong_count, what, wanted.at, (int)tree->count);
        return false;
    }
    for (uint32_t i = 0; i < tree->count; i++) {
        const Tree *item = tree->items[i];
        if (!tree_number(item, &value->number[i])) {
            diag_add(r->session, item->span, DIAG_not_number, what,
                     tree_describe(r->session, item));
            return false;
        }
        if (!resolve_fits_float(r, what, item, value->number[i]))
            return false;
    }
    value->type = type_of_components[tree->count];
    return true;
}

static bool is_identifier(const char *name)
{
    if (!text_is_letter(name[0]))
        return false;
    for (; *name; name++)
        if (!text_is_alphanumeric(*name) && *name != '_')
            return false;
    return true;
}

static bool same_default(const Uniform *uniform, const Value *value)
{
    return uniform->type == value->type &&
           !memcmp(uniform->initial, value->number,
                   sizeof(double) * (size_t)type_table[value->type].components);
}

/* Returns the uniform with that name, created on first use. */
static bool name_uniform(Resolver *r, const Tree *name, Value *value)
{
    int found = names_find(&r->uniform_names, name->text);
    if (found >= 0) {
        const Uniform *known = r->uniforms[found];
        if (!same_default(known, value)) {
            diag_add(r->session, name->span, DIAG_param_conflict, name->text);
            diag_add(r->session, known->span, DIAG_first_given);
            return false;
        }
        value->uniform = known;
        return true;
    }
    if (r->uniform_count >= LIMIT_PARAMS) {
        diag_add(r->session, name->span, DIAG_too_many_params, LIMIT_PARAMS);
        return false;
    }
    Uniform *uniform = ARENA_NEW(r->session->arena, Uniform);
    *uniform = (Uniform){.name = name->text,
                         .type = value->type,
                         .span = name->span,
                         .index = (int)r->uniform_count};
    memcpy(uniform->initial, value->number, sizeof value->number);
    ARENA_PUSH(r->session->arena, r->uniforms, r->uniform_count, r->uniform_capacity, uniform);
    names_add(r->session->arena, &r->uniform_names, uniform->name);
    value->uniform = uniform;
    return true;
}

/* Resolves { param: name, default: number, list or color } */
static bool param(Resolver *r, const char *what, Tree *tree, ComponentCount components,
                  Value *value)
{
    const Member *initial = tree_find(tree, "default");
    const Tree *name = tree_find(tree, "param")->value;
    for (uint32_t i = 0; i < tree->count; i++) {
        const char *key = tree->members[i].key;
        if (strcmp(key, "param") != 0 && strcmp(key, "default") != 0) {
            diag_add(r->session, tree->members[i].span, DIAG_param_keys, key);
            return false;
        }
    }
    if (name->kind != TREE_scalar || !is_identifier(name->text)) {
        diag_add(r->session, name->span, DIAG_param_name, tree_describe(r->session, name));
        return false;
    }
    if (reserved_has(name->text)) {
        diag_add(r->session, name->span, DIAG_param_reserved, name->text);
        return false;
    }
    if (!initial) {
        diag_add(r->session, tree->span, DIAG_missing_key, "a param", "default");
        return false;
    }
    if (initial->value->kind == TREE_object) {
        diag_add(r->session, initial->value->span, DIAG_wrong_type, "the default of a param",
                 "a number, a list or a color", "an object");
        return false;
    }
    if (!resolve_number(r, what, initial->value, components, value) ||
        !name_uniform(r, name, value))
        return false;
    value->kind = VALUE_uniform;
    value->span = tree->span;
    return true;
}

bool resolve_number(Resolver *r, const char *what, Tree *tree, ComponentCount components,
                    Value *value)
{
    *value = (Value){.kind = VALUE_number, .given = true, .span = tree->span};
    double number;
    if (tree->kind == TREE_object && tree_find(tree, "param"))
        return param(r, what, tree, components, value);
    if (resolve_is_formula(tree))
        return resolve_known_formula(r, what, tree, components, value);
    if (tree->kind == TREE_list)
        return number_list(r, what, tree, components, value);
    if (tree_number(tree, &number)) {
        value->type = TYPE_float;
        value->number[0] = number;
        return resolve_fits_float(r, what, tree, number);
    }
    if (components.most >= 3 && tree->kind == TREE_scalar && !tree->plain &&
        strlen(tree->text) >= 6 && common_error_hex(r, tree, tree->text))
        return false;
    if (hint_value(r, what, tree, components) || common_error_number(r, tree) ||
        common_error_list(r, tree) || common_error_formula(r, tree))
        return false;
    if (tree->kind == TREE_scalar && tree->plain && tree->count &&
        strchr("+-.0123456789", tree->text[0])) {
        diag_add(r->session, tree->span, DIAG_bad_number, tree->text);
        return false;
    }
    if (tree->kind == TREE_scalar && components.most >= 3 && !tree_is_null(tree))
        return resolve_color(r, tree, value);
    diag_add(r->session, tree->span, DIAG_wrong_type, what,
             components.most == 1 ? "a number" : "a number, a list of numbers or a color",
             tree_describe(r->session, tree));
    return false;
}
