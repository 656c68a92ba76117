/* Translates a material of another model to a Principled by the rows of translations.def.
 * Formulas over numbers are folded to numbers, so a material without maps compiles to the same
 * program as the equivalent Principled.
 *
 *     material: glTF, roughnessFactor: 0.5,
 *         metallicRoughnessTexture: { map: ImageMap, image: mr.png }
 *     becomes    roughness: { map: Expression, with: { both parameters },
 *                is: roughnessFactor * metallicRoughnessTexture.g }, and so on */
#include "compiler/formula/formula.h"
#include "compiler/hints/lint.h"
#include "compiler/resolve/resolve.h"
#include "grammar/translation_tables.h"
#include <float.h>
#include <math.h>

static const Type type_of_components[] = {TYPE_float, TYPE_float, TYPE_vec2, TYPE_vec3, TYPE_vec4};

/* The material, and the inputs of the formula being read. */
typedef struct {
    Resolver *r;
    Kind kind;
    Span span; /* span of the material's name */
    const Value *params;
    Item *items;
    size_t count, capacity;
    Names names;
    const Value *given; /* the first input given in the document; NULL: all are defaults */
} Foreign;

static Span place(void *user, uint32_t start, uint32_t end)
{
    (void)start, (void)end; /* Rows have no faults: tests read all of them. */
    return ((const Foreign *)user)->span;
}

static int find_param(Kind kind, const char *name)
{
    const KindRow *row = &kind_table[kind];
    for (int i = 0; i < row->count; i++)
        if (!strcmp(param_table[row->first + i].name, name))
            return i;
    return -1;
}

/* Returns a keyword of one of the material's parameters, as a number. */
static int find_word(Kind kind, const char *name)
{
    const KindRow *row = &kind_table[kind];
    for (int i = 0; i < row->count; i++)
        for (int word = 0; word < WORD_COUNT; word++)
            if (keyword_table[word].list == param_table[row->first + i].type &&
                !strcmp(keyword_table[word].name, name))
                return word;
    return -1;
}

static const Node *number_node(Foreign *s, double number)
{
    const Value value = {.kind = VALUE_number, .type = TYPE_float, .number = {number}};
    return resolve_make_constant(s->r, (Node){.span = s->span}, value);
}

static const Node *node_of(Foreign *s, const Value *value)
{
    if (value->kind == VALUE_node)
        return value->node;
    if (value->kind == VALUE_uniform)
        return resolve_make_constant(s->r, (Node){.span = value->span}, *value);
    return number_node(s, value->number[0]);
}

static int find_input(void *user, const char *name, const FormulaStep *step, int *width)
{
    (void)step;
    Foreign *s = user;
    const int known = names_find(&s->names, name), param = find_param(s->kind, name);
    const int word = param < 0 ? find_word(s->kind, name) : -1;
    if (known >= 0) {
        *width = s->items[known].width;
        return known;
    }
    if (param < 0 && word < 0)
        return FORMULA_UNKNOWN;
    Item item = {.value = {.kind = VALUE_number, .type = TYPE_float}, .span = s->span, .width = 1};
    item.input = param < 0 ? number_node(s, word) : node_of(s, &s->params[param]);
    if (param >= 0) {
        item.width = param_table[kind_table[s->kind].first + param].components > 1 ? 4 : 1;
        item.numbers = !param_is_colored(kind_table[s->kind].first + param);
        if (!s->given && s->params[param].given)
            s->given = &s->params[param];
    }
    ARENA_PUSH(s->r->session->arena, s->items, s->count, s->capacity, item);
    *width = item.width;
    return names_add(s->r->session->arena, &s->names, name);
}

static const Formula *read_formula(Foreign *s, const char *text)
{
    s->items = NULL;
    s->count = s->capacity = 0;
    s->names = (Names){0};
    s->given = NULL;
    const FormulaSource source = {.session = s->r->session,
                                  .text = text,
                                  .size = (uint32_t)strlen(text),
                                  .user = s,
                                  .span = place,
                                  .input = find_input};
    return formula_read(&source);
}

/* Returns an input's value in the components that the formula reads; false: not known at compile
 * time. */
static bool known_input(const Item *item, double components[4])
{
    const Node *node = item->input;
    if (node->kind != KIND_Constant || node->params->kind != VALUE_number)
        return false;
    if (item->width == 1) /* selects the red component */
        components[0] = components[1] = components[2] = components[3] = node->params->number[0];
    else
        value_number(node->params, TYPE_vec4, components);
    return true;
}

/* Evaluates the formula, using `guess` for unknown inputs; with a NULL guess an unknown input
 * fails. Returns false if the value is unknown or not finite. */
static bool value_with(const Foreign *s, const Formula *formula, const double guess[4],
                       double result[4])
{
    double(*capacity)[4] =
        arena_zero(s->r->session->arena, (s->count + formula->count) * sizeof *capacity);
    bool known = !formula->groups && !formula->meshed;
    for (size_t i = 0; known && i < s->count; i++)
        if (!known_input(&s->items[i], capacity[i])) {
            known = guess != NULL;
            for (int component = 0; known && component < 4; component++)
                capacity[i][component] = guess[s->items[i].width > 1 ? component : 0];
        }
    const FormulaPoint point = {.inputs = (const double(*)[4])capacity,
                                .values = capacity + s->count};
    if (known)
        formula_value(formula, &point, result);
    for (int component = 0; known && component < formula->width; component++)
        known = fabs(result[component]) <= FLT_MAX;
    return known;
}

static const Node *expression(Foreign *s, const Formula *formula)
{
    Value *params = ARENA_ARRAY(s->r->session->arena, Value, kind_table[KIND_Expression].count);
    const int first = kind_table[KIND_Expression].first;
    Items *items = ARENA_NEW(s->r->session->arena, Items);
    *items = (Items){(int)s->count, s->items};
    params[P_Expression_is - first] =
        (Value){.kind = VALUE_formula, .formula = formula, .span = s->span};
    params[P_Expression_with - first] =
        (Value){.kind = VALUE_items, .items = items, .span = s->span};
    return resolve_make_node(s->r,
                             (Node){.kind = KIND_Expression, .span = s->span, .params = params});
}

/* Returns true if the value is 0 for any value of the unknown maps, because a known factor is 0.
 * Tested with several guesses. */
static bool is_nothing(const Foreign *s, const Formula *formula)
{
    static const double guesses[][4] = {{.3, .6, .9, .2}, {0, .5, 0, .7}, {1, 0, .4, 1}};
    for (size_t i = 0; i < sizeof guesses / sizeof *guesses; i++) {
        double found[4] = {0};
        if (!value_with(s, formula, guesses[i], found) || found[0] != 0)
            return false;
    }
    return true;
}

static bool holds(Foreign *s, const char *where)
{
    const Formula *formula = where ? read_formula(s, where) : NULL;
    return !where || !formula || !is_nothing(s, formula);
}

/* Returns the value of a parameter of Principled; VALUE_none after reporting a number that is
 * too large. */
static Value translated(Foreign *s, const char *text)
{
    const int alone = find_param(s->kind, text);
    const int own = kind_table[s->kind].first;
    if (alone >= 0) {
        Value same = s->params[alone];
        same.written = (int16_t)(1 + own + alone);
        return same;
    }
    const Formula *formula = read_formula(s, text);
    if (!formula)
        return (Value){0};
    Value number = {.kind = VALUE_number, .type = type_of_components[formula->width]};
    const Node *node = value_with(s, formula, NULL, number.number)
                           ? resolve_make_constant(s->r, (Node){.span = s->span}, number)
                           : expression(s, formula);
    return (Value){.kind = node ? VALUE_node : VALUE_none,
                   .node = node,
                   .given = s->given != NULL,
                   .written = (int16_t)(s->given ? 1 + own + (s->given - s->params) : 0),
                   .span = s->given ? s->given->span : s->span};
}

/* Unwraps a Constant for a parameter that takes no map. */
static Value as_number(Value value)
{
    if (value.kind != VALUE_node || value.node->kind != KIND_Constant)
        return value;
    Value number = value.node->params[0];
    number.given = value.given;
    number.written = value.written;
    number.span = value.span;
    return number;
}

/* Applies a NormalMap with the material's map to the normal `there`. */
static Value over_normal(Foreign *s, const TranslationRow *row, Value there)
{
    const int own = kind_table[s->kind].first, first = kind_table[KIND_NormalMap].first;
    const Value *map = &s->params[row->map - own];
    if (map->kind != VALUE_node)
        return there;
    Value *params = ARENA_ARRAY(s->r->session->arena, Value, kind_table[KIND_NormalMap].count);
    for (int i = 0; i < kind_table[KIND_NormalMap].count; i++)
        params[i] = resolve_default(s->r, &param_table[first + i]);
    params[P_NormalMap_input - first] = there;
    params[P_NormalMap_normal - first] = *map;
    params[P_NormalMap_scale - first] = s->params[row->scale - own];
    const Node *node = resolve_make_node(
        s->r, (Node){.kind = KIND_NormalMap, .span = map->span, .params = params});
    return (Value){.kind = node ? VALUE_node : VALUE_none,
                   .node = node,
                   .given = true,
                   .written = (int16_t)(1 + row->map),
                   .span = map->span};
}

static void report_losses(Foreign *s)
{
    for (int i = 0; i < loss_count; i++) {
        const LossRow *row = &loss_table[i];
        if (param_table[row->param].kind != s->kind)
            continue;
        const Value *param = &s->params[row->param - kind_table[s->kind].first];
        const Formula *formula = param->given ? read_formula(s, row->formula) : NULL;
        if (formula && !is_nothing(s, formula))
            diag_add(s->r->session, param->span, DIAG_translation_loss,
                     param_table[row->param].name, kind_table[s->kind].name, row->what);
    }
}

bool resolve_is_foreign(Kind kind)
{
    for (int i = 0; i < translation_count; i++)
        if (translation_table[i].from == kind)
            return true;
    return false;
}

const Node *resolve_translate(Resolver *r, Node of)
{
    Foreign s = {.r = r, .kind = of.kind, .span = of.span, .params = of.params};
    const KindRow *row = &kind_table[KIND_Principled];
    const int displacement = P_Principled_displacement - row->first;
    Value *params = ARENA_ARRAY(r->session->arena, Value, row->count);
    bool fine = true;
    for (int i = 0; i < displacement; i++)
        params[i] = resolve_default(r, &param_table[row->first + i]);
    for (int i = displacement; i < row->count; i++)
        params[i] = of.params[i - row->count + kind_table[of.kind].count];
    for (int i = 0; i < translation_count; i++) {
        const TranslationRow *rule = &translation_table[i];
        Value *value = &params[rule->to - row->first];
        if (rule->from != of.kind || !holds(&s, rule->where))
            continue;
        *value = rule->formula ? translated(&s, rule->formula) : over_normal(&s, rule, *value);
        if (param_table[rule->to].type != PARAM_Map)
            *value = as_number(*value);
        fine &= value->kind != VALUE_none || !param_table[rule->to].components;
    }
    lint_units(r->session, &of); /* checks values in the author's units */
    report_losses(&s);
    of.written = of.kind;
    of.kind = KIND_Principled;
    of.params = params;
    return fine ? resolve_make_node(r, of) : NULL;
}
