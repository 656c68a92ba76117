/* Formulas of a document: their text, the maps that they name, and the number of components of
 * each map in them. */
#include "compiler/formula/formula.h"
#include "compiler/base/text.h"
#include "compiler/hints/hint.h"
#include "compiler/hints/common_error.h"
#include "compiler/resolve/resolve_definition.h"
#include <float.h>
#include <math.h>
#include <string.h>

/* A formula and the maps that it reads, each once. */
typedef struct {
    Resolver *r;
    const Tree *text, *with; /* `with` may be NULL: no named inputs */
    /* Arguments of the definition's parameters that the text names; NULL: none. */
    const Tree *arguments;
    /* parameters of the definition, looked up for an unknown name; NULL: none */
    const Tree *parameters;
    uint32_t skipped; /* bytes of the text before the formula */
    Item *items;
    size_t count, capacity;
    Names names;
} Inputs;

static Span place(void *user, uint32_t start, uint32_t end)
{
    const Inputs *in = user;
    return tree_place(in->r->session, in->text, start + in->skipped, end + in->skipped);
}

static const Member *definition(const Resolver *r, const char *name)
{
    const Member *found = NULL;
    for (size_t i = 0; i < r->def_count && !found; i++)
        found = tree_find(r->defs[i], name);
    return found;
}

/* Returns the arguments that a definition passes to its formula. */
static const Tree *arguments_of(const Tree *text)
{
    return text->scoped ? ((const ScopedTree *)(const void *)text)->arguments : NULL;
}

static bool stands_in(const Tree *text, const Tree *tree)
{
    return tree->span.file == text->span.file && tree->span.start <= text->span.start &&
           text->span.end <= tree->span.end;
}

/* Returns the parameters of the definition that contains the text. */
static const Tree *parameters_around(const Inputs *in)
{
    for (size_t k = 0; k < in->r->def_count; k++)
        for (uint32_t i = 0; i < in->r->defs[k]->count; i++) {
            const Tree *definition = in->r->defs[k]->members[i].value;
            const Member *params = tree_find(definition, "params");
            if (params && params->value->kind == TREE_object && stands_in(in->text, definition))
                return params->value;
        }
    return NULL;
}

/* Enumerates the names of parameters, of `with:`, then of definitions. */
static const char *name_of(const void *user, int i)
{
    const Inputs *in = user;
    if (i < LIMIT_DEFINITION_PARAMS)
        return in->parameters && i < (int)in->parameters->count ? in->parameters->members[i].key
                                                                : NULL;
    i -= LIMIT_DEFINITION_PARAMS;
    if (in->with && i < (int)in->with->count)
        return in->with->members[i].key;
    i -= in->with ? (int)in->with->count : 0;
    for (size_t k = 0; k < in->r->def_count; k++) {
        if (i < (int)in->r->defs[k]->count)
            return in->r->defs[k]->members[i].key;
        i -= (int)in->r->defs[k]->count;
    }
    return NULL;
}

static int name_count(const Inputs *in)
{
    size_t count = LIMIT_DEFINITION_PARAMS + (in->with ? in->with->count : 0);
    for (size_t k = 0; k < in->r->def_count; k++)
        count += in->r->defs[k]->count;
    return (int)count;
}

/* Returns the value of a name; a definition with parameters is instantiated with its defaults.
 * Returns NULL after reporting a fault. */
static Tree *tree_of(Inputs *in, const Member *member)
{
    if (!resolve_is_definition(member->value))
        return member->value;
    Tree *use = ARENA_NEW(in->r->session->arena, Tree);
    use->kind = TREE_object;
    use->span = in->text->span;
    Tree *tree = resolve_definition(in->r, member, use);
    return tree;
}

/* Reports an unknown name. A formula can read a param only through `with:`. After a failed
 * include no name is reported, since the file might define it. */
static int report_unknown(Inputs *in, const char *name, const FormulaStep *step)
{
    Resolver *r = in->r;
    Text hint = text_new(r->session->arena);
    if (r->lacks_file)
        return FORMULA_REPORTED;
    in->parameters = parameters_around(in);
    if (names_find(&r->uniform_names, name) < 0)
        return FORMULA_UNKNOWN;
    text_format(&hint, "; to use a param write `with: { %s: { param: %s, default: ... } }`", name,
                name);
    diag_add(r->session, place(in, step->start, step->end), DIAG_formula_unknown, name, hint.at);
    return FORMULA_REPORTED;
}

static int find_input(void *user, const char *name, const FormulaStep *step, int *width)
{
    Inputs *in = user;
    Resolver *r = in->r;
    const Member *member = in->with ? tree_find(in->with, name) : NULL;
    if (!member && in->arguments)
        member = tree_find(in->arguments, name);
    bool fault = false;
    int number = names_find(&in->names, name);
    if (number >= 0) {
        *width = in->items[number].input ? in->items[number].input->width : 1;
        return number;
    }
    if (!member && !(member = definition(r, name)))
        return report_unknown(in, name, step);
    if (member->value->open) {
        diag_add(r->session, place(in, step->start, step->end), DIAG_cycle, name);
        return FORMULA_REPORTED;
    }
    Tree *tree = tree_of(in, member);
    const Node *node = tree ? resolve_map(r, tree, &fault) : NULL;
    if (fault || !tree)
        return FORMULA_REPORTED;
    const Item item = {
        .value = {.kind = VALUE_number, .type = TYPE_float}, .input = node, .span = member->span};
    ARENA_PUSH(r->session->arena, in->items, in->count, in->capacity, item);
    *width = node ? node->width : 3;
    return names_add(r->session->arena, &in->names, name);
}

/* Returns the document's attribute with that name, created on first use. */
static int find_attribute(void *user, const FormulaAttribute *given)
{
    const Inputs *in = user;
    Resolver *r = in->r;
    const Span span = place(user, given->start, given->end);
    const int found = names_find(&r->attribute_names, given->name);
    if (found >= 0) {
        const MeshAttribute *known = r->attributes[found];
        const size_t size = sizeof(double) * (size_t)type_table[given->type].components;
        if (known->type == given->type && !memcmp(known->initial, given->initial, size))
            return found;
        diag_add(r->session, span, DIAG_attribute_conflict, given->name);
        diag_add(r->session, known->span, DIAG_first_given);
        return FORMULA_REPORTED;
    }
    if (r->attribute_count == LIMIT_ATTRIBUTES) {
        diag_add(r->session, span, DIAG_too_many_attributes, LIMIT_ATTRIBUTES);
        return FORMULA_REPORTED;
    }
    MeshAttribute *attribute = ARENA_NEW(r->session->arena, MeshAttribute);
    *attribute = (MeshAttribute){
        .name = given->name, .type = given->type, .span = span, .index = (int)r->attribute_count};
    memcpy(attribute->initial, given->initial, sizeof attribute->initial);
    ARENA_PUSH(r->session->arena, r->attributes, r->attribute_count, r->attribute_capacity,
               attribute);
    return names_add(r->session->arena, &r->attribute_names, attribute->name);
}

static void keep(Resolver *r, const Inputs *in, const Formula *formula, Value *params)
{
    const int first = kind_table[KIND_Expression].first;
    Items *items = ARENA_NEW(r->session->arena, Items);
    *items = (Items){(int)in->count, in->items};
    params[P_Expression_is - first] =
        (Value){.kind = VALUE_formula, .formula = formula, .given = true, .span = in->text->span};
    if (in->count)
        params[P_Expression_with - first] =
            (Value){.kind = VALUE_items, .items = items, .given = true, .span = in->text->span};
}

/* Detects an unquoted `= mix(red, #00ff00, u)`: YAML ends the text before the '#'. */
static void report_hash(const Inputs *in)
{
    const Span span = in->text->span;
    const Source *source = &in->r->session->sources[span.file];
    uint32_t at = span.end;
    while (at < source->size && (source->text[at] == ' ' || source->text[at] == '\t'))
        at++;
    if (in->text->plain && at > span.end && at < source->size && source->text[at] == '#')
        diag_add(in->r->session, (Span){at, at + 1, span.file}, DIAG_hash_formula);
}

static void advise_color(void *user, uint32_t start, uint32_t end, const double *components)
{
    const Inputs *in = user;
    const char *hex =
        arena_string(in->r->session->arena, in->text->text + in->skipped + start, end - start);
    resolve_advise_colors(in->r, place(user, start, end), hex, components);
}

static const Formula *read_formula(Inputs *in)
{
    const Tree *text = in->text;
    in->skipped = resolve_is_formula(text);
    const FormulaSource source = {
        .session = in->r->session,
        .text = text->text + in->skipped,
        .size = text->count - in->skipped,
        .srgb = resolve_is_srgb(in->r, text->span.file),
        .user = in,
        .color = advise_color,
        .span = place,
        .input = find_input,
        .attribute = find_attribute,
        .names = {name_of, in, name_count(in)},
    };
    const Formula *formula = formula_read(&source);
    if (!formula)
        report_hash(in);
    return formula;
}

bool resolve_formula(Resolver *r, const Tree *text, const Tree *with, Value *params)
{
    Inputs in = {.r = r, .text = text, .with = with, .arguments = arguments_of(text)};
    const Formula *formula = read_formula(&in);
    if (!formula)
        return false;
    for (uint32_t i = 0; with && i < with->count; i++)
        if (names_find(&in.names, with->members[i].key) < 0)
            diag_add(r->session, with->members[i].span, DIAG_unread_name, with->members[i].key);
    keep(r, &in, formula, params);
    return true;
}

/* Names a part of a formula that is unknown at compile time; NULL: all parts are known. */
static const char *unknown_part(const Inputs *in, const Formula *formula)
{
    if (formula->groups || formula->meshed)
        return formula->groups ? "the point" : "the mesh";
    for (size_t i = 0; i < in->count; i++) {
        const Node *node = in->items[i].input;
        if (!node || node->kind != KIND_Constant || node->params->kind != VALUE_number)
            return in->names.at[i];
    }
    for (size_t i = 0; i < formula->count; i++)
        if (formula->steps[i].kind == FORMULA_term && term_table[formula->steps[i].row].noisy)
            return "noise";
    return NULL;
}

bool resolve_known_formula(Resolver *r, const char *what, const Tree *text,
                           ComponentCount components, Value *value)
{
    static const Type types[] = {TYPE_float, TYPE_float, TYPE_vec2, TYPE_vec3, TYPE_vec4};
    Inputs in = {.r = r, .text = text, .arguments = arguments_of(text)};
    const Formula *formula = read_formula(&in);
    if (!formula)
        return false;
    const char *part = unknown_part(&in, formula);
    if (part || (formula->width != 1 &&
                 (formula->width < components.least || formula->width > components.most))) {
        if (part)
            diag_add(r->session, text->span, DIAG_formula_varies, what, part);
        else
            diag_add(r->session, text->span, DIAG_wrong_count, what,
                     components.most == 1 ? "a number" : "three numbers", formula->width);
        return false;
    }
    double(*known)[4] = arena_zero(r->session->arena, (in.count + formula->count) * sizeof *known);
    for (size_t i = 0; i < in.count; i++) {
        value_number(in.items[i].input->params, types[in.items[i].input->width], known[i]);
        for (int component = 1; in.items[i].input->width == 1 && component < 4; component++)
            known[i][component] = known[i][0];
    }
    const FormulaPoint point = {.inputs = (const double(*)[4])known, .values = known + in.count};
    formula_value(formula, &point, value->number);
    value->type = types[formula->width];
    for (int component = 0; component < formula->width; component++)
        if (!(fabs(value->number[component]) <= FLT_MAX)) {
            diag_add(r->session, text->span, DIAG_too_large_number, what, text->text);
            return false;
        }
    return true;
}

/* Checks with: { name: map, ... }, including maps that the formula does not read. */
static bool check_names(Resolver *r, const Tree *with)
{
    bool fine = true;
    if (hint_assigned(r->session, with))
        return false;
    if (with->kind != TREE_object) {
        diag_add(r->session, with->span, DIAG_wrong_type, "with",
                 "maps by name, `{ a: black, b: white }`", tree_describe(r->session, with));
        return false;
    }
    for (uint32_t i = 0; i < with->count; i++) {
        const Member *member = &with->members[i];
        const char *key = member->key;
        bool named = member->size > 0 && (text_is_letter(*key) || *key == '_'), fault = false;
        for (uint32_t k = 0; k < member->size; k++)
            named &= text_is_alphanumeric(key[k]) || key[k] == '_';
        const bool hides = term_named(key, member->size) != TERM_none ||
                           quantity_named(key, member->size) != QUANTITY_none ||
                           vector_named(key, member->size) ||
                           formula_special_named(key, member->size) != SPECIAL_none;
        if (!named || hides)
            diag_add(r->session, member->span, hides ? DIAG_formula_hides : DIAG_formula_input_name,
                     key);
        resolve_map(r, member->value, &fault);
        fine &= named && !hides && !fault;
    }
    return fine;
}

bool resolve_expression(Resolver *r, const Tree *tree, Value *params)
{
    const Member *with = tree_find(tree, "with"), *is = tree_find(tree, "is");
    if (with && tree_is_null(with->value))
        with = NULL;
    const bool fine = !with || check_names(r, with->value);
    if (!is || tree_is_null(is->value))
        return fine;
    if (is->value->kind != TREE_scalar) {
        diag_add(r->session, is->value->span, DIAG_wrong_type, "is",
                 "a formula (in quotes if it starts with a bracket)",
                 tree_describe(r->session, is->value));
        return false;
    }
    return fine && resolve_formula(r, is->value, with ? with->value : NULL, params);
}
