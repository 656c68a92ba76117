/* Lints: warnings about parts of a document without a visible effect. Every node is queried for
 * groups of properties by its users, and queries its inputs in turn. Inputs precede their users,
 * so one walk from the last node to the first finds all queries.
 *
 *     diffuse: { map: Granite, input: { map: UVTransform, scaleU: 8 } }
 *     Phong queries Granite for a color, Granite queries UVTransform for x, y and z, which
 *         UVTransform passes on: its u and v have no effect. */
#include "compiler/formula/formula.h"
#include "compiler/hints/lint.h"
#include "grammar/lobe_table.h"
#include "compiler/base/text.h"
#include <math.h>
#include <string.h>

/* -- Constants in another unit, colors in the place of a normal */

/* Lints for constants that seem to be in another unit, and for colors in the place of a normal. */

/* Returns the first component of a constant map, the largest of a list of numbers, or the
 * default of a param. False for other values. */
static bool component_of(const Value *value, double *component)
{
    const bool map = value->kind == VALUE_node && value->node->kind == KIND_Constant;
    const Value *number = map ? &value->node->params[0] : value;
    if (!value->given || (number->kind != VALUE_number && number->kind != VALUE_uniform))
        return false;
    const double *components =
        number->kind == VALUE_uniform ? number->uniform->initial : number->number;
    *component = components[0];
    for (int i = 1; !map && i < type_table[number->type].components; i++)
        *component = fabs(components[i]) > fabs(*component) ? components[i] : *component;
    return true;
}

/* Appends a conversion: "; 45 degrees are 0.7854" */
static void put_meant(Text *out, const UnitRow *unit, double number)
{
    const double meant = number * unit->factor;
    text_put(out, "");
    if (!*unit->other || meant < unit->low || meant > unit->high || fabs(number) < 2 * unit->high)
        return;
    text_put(out, "; ");
    text_plain(out, number);
    text_format(out, " %s are ", unit->other);
    text_plain(out, round(meant * 1e4) / 1e4);
}

void lint_unit(Session *session, const char *name, const UnitRow *unit, const Value *value)
{
    double number;
    if (!unit || unit == &unit_table[UNIT_gloss] || !component_of(value, &number) ||
        (number >= unit->low && number <= unit->high))
        return;
    Text is = text_new(session->arena), low = text_new(session->arena),
         high = text_new(session->arena);
    Text meant = text_new(session->arena);
    text_plain(&is, number);
    text_plain(&low, round(unit->low * 1e3) / 1e3);
    text_plain(&high, round(unit->high * 1e3) / 1e3);
    if (*unit->name)
        text_format(&is, " %s", unit->name);
    put_meant(&meant, unit, number);
    diag_add(session, value->span, DIAG_unusual_number, name, is.at, low.at, high.at, meant.at);
}

void lint_units(Session *session, const Node *node)
{
    const KindRow *row = &kind_table[node->kind];
    /* Values translated from another model were already linted as the author wrote them. */
    const bool made = node->written && node->written != node->kind;
    for (int i = 0; i < row->count && !made; i++) {
        const UnitRow *unit = unit_of(row->first + i);
        if (unit && node->params[i].given)
            lint_unit(session, node_written_param(node, i), unit, &node->params[i]);
    }
}

/* Returns true for a map that yields a pattern of colors or a single number, but no direction. */
static bool is_plain(const Node *map)
{
    const Section section = section_of(map->kind);
    const bool number =
        map->kind == KIND_Constant && type_table[map->params[0].type].components == 1;
    return number || section == SECTION_surface || section == SECTION_volume ||
           section == SECTION_dimensions;
}

static void lint_normals(Session *session, const Node *material)
{
    static const char *const names[] = {"input", "coatNormal", "tangent", "coatTangent"};
    const KindRow *row = &kind_table[material->kind];
    for (int i = 0; i < row->count; i++) {
        const Value *value = &material->params[i];
        size_t name = 0;
        if (value->kind != VALUE_node || !is_plain(value->node))
            continue;
        while (name < sizeof names / sizeof *names &&
               strcmp(names[name], param_table[row->first + i].name) != 0)
            name++;
        if (name == sizeof names / sizeof *names)
            continue;
        const bool direction = name >= 2;
        diag_add(session, value->span, direction ? DIAG_plain_direction : DIAG_plain_normal,
                 node_written_param(material, i),
                 value->node->kind == KIND_Constant ? "a number"
                                                    : kind_table[value->node->kind].name);
    }
}

/* -- Parts that no G-buffer stores */

/* Lints for parts of a physically based material that no G-buffer stores, or stores only
 * modified: UNSTORED and TILED of materials.def. */

static bool is_lost(const Node *node, int i)
{
    return param_is_unstored(kind_table[node->kind].first + i) && !value_is_zero(&node->params[i]);
}

/* Describes how an interior parameter of a closed mesh is modified when stored; NULL: stored
 * unchanged. */
static const char *dropped(const Node *node, int i)
{
    int weight;
    const char *what = param_dropped(kind_table[node->kind].first + i, &weight);
    const bool there = what && node->params[i].given && !value_is_zero(&node->params[i]) &&
                       !value_is_zero(node_param(node, weight));
    return there && value_is_zero(node_param(node, P_Principled_thinWalled)) ? what : NULL;
}

static void lint_lost(Session *session, const Node *material)
{
    for (int i = 0; i < kind_table[material->kind].count; i++) {
        const char *what = dropped(material, i);
        const Span span = material->params[i].span;
        if (is_lost(material, i))
            diag_add(session, span, DIAG_unstored, node_written_param(material, i),
                     node_written_name(material));
        else if (what)
            diag_add(session, span, DIAG_dropped, node_written_param(material, i),
                     node_written_name(material), what);
    }
}

static const double MIN_FUZZ = .2; /* min fuzz roughness of surface_principled.glsl */
/* min value of a color's largest component for which integer components look like bytes */
enum { LOOKS_LIKE_BYTE = 16, BYTE = 255 };

/* Properties that a node is queried for. The first two equal MOVES_xyz and MOVES_uv of tables.h. */
typedef enum {
    ASKED_xyz = MOVES_xyz,
    ASKED_uv = MOVES_uv,
    ASKED_color = 4,
    ASKED_shininess = 8, /* red component, which a material reads as an exponent */
    ASKED_slope = 16,    /* derivatives by u and v */
    ASKED_other = 32,    /* normal, index of refraction, world position */
    ASKED_light = 64,    /* color of light, of unbounded intensity */
    ASKED_shape = 128,   /* additional flag: the value displaces the surface */
    ASKED_shown = ASKED_color | ASKED_shininess,
} Asked;

typedef struct {
    Session *session;
    unsigned *asked;        /* per node index: a set of Asked bits */
    const Node **reader;    /* per node index: one of the nodes that query it */
    const unsigned *models; /* models of the graph's materials */
    bool saying;            /* all queries are known, so findings may be reported */
} LintFindings;

/* Returns the components of a number, or of a param's default. */
static int components_of(const Value *value, const double **components)
{
    if (value->kind != VALUE_number && value->kind != VALUE_uniform)
        return 0;
    *components = value->kind == VALUE_uniform ? value->uniform->initial : value->number;
    return type_table[value->type].components;
}

static bool is_byte(double component)
{
    return component >= 0 && component <= BYTE && component == trunc(component);
}

/* Lints a color's three components. */
static void lint_bytes(const LintFindings *d, Span span, const double *components)
{
    const double most = fmax(components[0], fmax(components[1], components[2]));
    if (most < LOOKS_LIKE_BYTE || !is_byte(components[0]) || !is_byte(components[1]) ||
        !is_byte(components[2]))
        return;
    Text hex = text_new(d->session->arena);
    text_format(&hex, "#%02x%02x%02x", (unsigned)components[0], (unsigned)components[1],
                (unsigned)components[2]);
    diag_add(d->session, span, DIAG_byte_color, hex.at);
}

/* Lints a single number as a color: `diffuse: 128` looks like a gray in bytes, unless it may be
 * a light intensity. `diffuse: 112233` has the digits of a hex color. */
static void lint_single(const LintFindings *d, const Value *value, double component, bool light)
{
    const char *text = d->session->sources[value->span.file].text + value->span.start;
    const size_t size = value->span.end - value->span.start;
    if (value->kind == VALUE_number && strspn(text, "0123456789") == size &&
        (size == 6 || size == 8)) {
        Text hex = text_new(d->session->arena);
        text_format(&hex, "#%.*s", (int)size, text);
        diag_add(d->session, value->span, DIAG_byte_color, hex.at);
    } else if (!light) {
        lint_bytes(d, value->span, (const double[3]){component, component, component});
    }
}

/* Lints the parameters r, g and b of a color or a material. */
static void lint_components(const LintFindings *d, const Node *node)
{
    double rgb[3];
    int found = 0;
    Span span = node->span;
    const KindRow *row = &kind_table[node->kind];
    for (int i = row->count - 1; i >= 0; i--) {
        const double *component;
        const char *at = strchr("rgb", param_table[row->first + i].name[0]);
        if (!at || param_table[row->first + i].name[1] ||
            !components_of(&node->params[i], &component))
            continue;
        rgb[at - "rgb"] = *component;
        found++;
        if (*component > 1)
            span = node->params[i].span;
    }
    if (found == 3)
        lint_bytes(d, span, rgb);
}

static void lint_constant(const LintFindings *d, const Node *node, unsigned asked)
{
    const double *components = NULL;
    const int count = components_of(&node->params[0], &components);
    if (asked & ASKED_color && node->kind == KIND_Constant && count >= 3)
        lint_bytes(d, node->params[0].span, components);
    else if (asked & ASKED_color && node->kind == KIND_Constant && count == 1)
        lint_single(d, &node->params[0], *components, asked & ASKED_light);
    else if (asked & ASKED_color)
        lint_components(d, node);
    if (asked & ASKED_shininess && count && *components > 1) {
        Text is = text_new(d->session->arena), shininess = text_new(d->session->arena);
        text_plain(&is, *components);
        text_plain(&shininess, round(1e3 * (1 - sqrt(1 - exp(-2 / *components)))) / 1e3);
        diag_add(d->session, node->params[0].span, DIAG_high_shininess, is.at, is.at, shininess.at);
    }
}

static void ask(LintFindings *d, const Node *reader, const Node *node, unsigned asked)
{
    if (!node || !asked)
        return;
    if (d->saying && section_of(node->kind) == SECTION_constant)
        lint_constant(d, node, asked);
    d->asked[node->index] |= asked;
    d->reader[node->index] = reader;
}

/* Returns the queries of a kind that has the parameter `dimensions`. */
static unsigned asked_by_dimensions(const Node *node)
{
    const KindRow *row = &kind_table[node->kind];
    double number[4] = {0};
    for (int i = 0; i < row->count; i++)
        if (!strcmp(param_table[row->first + i].name, "dimensions"))
            value_number(&node->params[i], TYPE_float, number);
    return number[0] < 3 ? ASKED_uv : ASKED_xyz;
}

/* Returns the queries that a formula makes of its point. */
static unsigned asked_of_point(const Node *node)
{
    const Value *is = node_param(node, P_Expression_is);
    const unsigned groups = is->kind == VALUE_formula ? is->formula->groups : 0;
    const unsigned coordinates =
        (groups >> GROUP_X & 1 ? ASKED_xyz : 0) | (groups >> GROUP_U & 1 ? ASKED_uv : 0);
    return coordinates | (groups & ~(1u << GROUP_X | 1u << GROUP_U) ? ASKED_other : 0);
}

/* Operands of math maps are colors of any intensity; for slopes and coordinates they are
 * numbers. */
static unsigned asked_by_math(unsigned asked)
{
    if (asked & (ASKED_shown | ASKED_light))
        return ASKED_color | ASKED_light;
    return asked & ASKED_slope ? ASKED_slope : ASKED_other;
}

/* Returns the queries that a map makes of its input when the map itself is queried. */
static unsigned asked_of_input(const Node *node, unsigned asked)
{
    const KindRow *row = &kind_table[node->kind];
    const bool items = row->count > 1 && node->params[1].kind == VALUE_items;
    switch (section_of(node->kind)) {
    case SECTION_surface:
        return ASKED_uv;
    case SECTION_volume:
        return ASKED_xyz;
    case SECTION_dimensions:
        return asked_by_dimensions(node);
    case SECTION_expression:
        return asked_of_point(node);
    case SECTION_math:
        return asked_by_math(asked);
    case SECTION_blend:
        return items ? ASKED_xyz : asked;
    case SECTION_normal:
        return asked | ASKED_uv | ASKED_other;
    default:
        return asked;
    }
}

/* Returns the queries that a material or map makes of the map of a parameter. */
static unsigned asked_of_param(const Node *node, const ParamRow *param, unsigned asked)
{
    if (section_of(node->kind) == SECTION_normal)
        return ASKED_slope;
    if (section_of(node->kind) == SECTION_math)
        return asked_by_math(asked);
    if (section_of(node->kind) != SECTION_material)
        return asked;
    if (!strcmp(param->name, "displacement") || !strcmp(param->name, "displacementVector"))
        return ASKED_color | ASKED_shape;
    if (strstr(param->name, "hininess"))
        return ASKED_shininess;
    if ((node->kind == KIND_Principled || node->kind == KIND_Layer) &&
        !param_is_colored((int)(param - param_table)))
        return ASKED_color | ASKED_light; /* the number may have any magnitude */
    return strcmp(param->name, "emissive") ? ASKED_color : ASKED_color | ASKED_light;
}

static void ask_below(LintFindings *d, const Node *node, unsigned asked)
{
    const KindRow *row = &kind_table[node->kind];
    const bool material = section_of(node->kind) == SECTION_material;
    const unsigned shape = asked & ASKED_shape;
    for (int i = 0; i < row->count && (material || asked); i++) {
        const ParamRow *param = &param_table[row->first + i];
        const Value *value = &node->params[i];
        for (int k = 0; value->kind == VALUE_items && k < value->items->count; k++)
            ask(d, node, value->items->item[k].input,
                node->kind == KIND_Expression ? ASKED_other | shape : asked);
        if (value->kind != VALUE_node || param->type != PARAM_Map)
            continue;
        const bool input = !strcmp(param->name, "input") || !strcmp(param->name, "coatNormal");
        ask(d, node, value->node,
            shape | (!input     ? asked_of_param(node, param, asked)
                     : material ? ASKED_other
                                : asked_of_input(node, asked)));
    }
}

/* Returns the transform map that changes exactly these coordinates. */
static const char *mover(unsigned moves)
{
    for (int kind = 0; kind < KIND_COUNT; kind++)
        if (kind_table[kind].moves == moves)
            return kind_table[kind].name;
    return "";
}

/* Lints a transform map or a normal modifier whose effect is not queried. */
static void lint_use(const LintFindings *d, const Node *node)
{
    const unsigned asked = d->asked[node->index], moves = kind_table[node->kind].moves;
    const Value *input = &node->params[0];
    const bool through = input->kind == VALUE_node;
    const bool moved = asked & moves || (moves & MOVES_uv && asked & ASKED_slope);
    const char *name = kind_table[node->kind].name;
    if (asked & ASKED_shown && (!through || !(moved || asked & ASKED_other)))
        diag_add(d->session, node->span, DIAG_no_color, name,
                 through ? "it returns the color of its input" : "it is black, with alpha 0");
    else if (moves && !moved && asked & (ASKED_uv | ASKED_xyz))
        diag_add(d->session, node->span, DIAG_unread_transform,
                 kind_table[d->reader[node->index]->kind].name,
                 asked & ASKED_xyz ? "x, y and z" : "u and v", name,
                 mover(asked & (ASKED_uv | ASKED_xyz)));
}

/* Lints a queried map without its image, formula or items. */
static void lint_lack(const LintFindings *d, const Node *node)
{
    const KindRow *row = &kind_table[node->kind];
    for (int i = 0; i < row->count && d->asked[node->index]; i++) {
        const ParamRow *param = &param_table[row->first + i];
        const Value *value = &node->params[i];
        if (param->type == PARAM_Image && value->kind == VALUE_none)
            diag_add(d->session, node->span, DIAG_no_picture, row->name, param->name);
        if (param->type == PARAM_Formula && value->kind != VALUE_formula)
            diag_add(d->session, node->span, DIAG_no_formula, row->name, param->name);
        if (param->type == PARAM_List && (value->kind != VALUE_items || !value->items->count))
            diag_add(d->session, node->span, DIAG_no_maps, row->name, param->name);
        if (param->type == PARAM_Items && (value->kind != VALUE_items || !value->items->count))
            diag_add(d->session, node->span, DIAG_no_items, row->name, param->name);
    }
}

/* Returns the material that displaces the front side: the material itself, or one within
 * switches. NULL: none. */
static const Node *displaced_front(const Node *material)
{
    while (material && !graph_displaces(material)) {
        const Value *front = material->kind == KIND_SideSwitch
                                 ? node_param(material, P_SideSwitch_frontShader)
                                 : NULL;
        material = front && front->kind == VALUE_node ? front->node : NULL;
    }
    return material;
}

static bool same_map(const Value *a, const Value *b)
{
    return a->kind == b->kind && (a->kind != VALUE_node || a->node == b->node);
}

static const Value *first_map(const Displacement *d)
{
    return d->volume->kind == VALUE_node   ? d->volume
           : d->height->kind == VALUE_node ? d->height
                                           : d->vector;
}

/* Lints parameters that a volume overrides, and parameters that only volumes use. */
static void lint_volume(const LintFindings *d, const Node *node)
{
    const Displacement has = graph_displacement(node);
    if (has.volume->kind != VALUE_node && has.threshold->kind != VALUE_none)
        diag_add(d->session, has.threshold->span, DIAG_no_volume);
    if (has.volume->kind != VALUE_node)
        return;
    if (has.height->kind == VALUE_node)
        diag_add(d->session, has.height->span, DIAG_volume_displacement, "displacement");
    if (has.vector->kind == VALUE_node)
        diag_add(d->session, has.vector->span, DIAG_volume_displacement, "displacementVector");
}

/* A surface has a single shape, that of its front: lints a different displacement on the back. */
static void lint_back(const LintFindings *d, const Node *node)
{
    const Value *back = node_param(node, P_SideSwitch_backShader);
    const Node *shape = displaced_front(node),
               *other = back->kind == VALUE_node ? displaced_front(back->node) : NULL;
    if (!other || other == shape)
        return;
    const Displacement has = graph_displacement(other);
    const Value *height = first_map(&has);
    const Displacement seen = shape ? graph_displacement(shape) : has;
    if (!shape || !same_map(seen.height, has.height) || !same_map(seen.vector, has.vector) ||
        !same_map(seen.volume, has.volume))
        diag_add(d->session, height->span, DIAG_back_displacement);
}

/* Lints parts of a Phong that are lost when a Layer converts it to a Principled. */
static void lint_layered(const LintFindings *d, const Node *base)
{
    static const int lost[] = {P_Phong_ambient, P_Phong_diffuseTransparency};
    for (size_t i = 0; base->kind == KIND_Phong && i < sizeof lost / sizeof *lost; i++) {
        const Value *value = node_param(base, lost[i]);
        if (!value_is_zero(value))
            diag_add(d->session, value->span, DIAG_layered_loss, param_table[lost[i]].name);
    }
}

/* Lints a fuzz roughness below the minimum of the fuzz lobe. */
static void lint_fuzz(const LintFindings *d, const Node *node)
{
    const Value *rough =
        node->kind == KIND_Principled ? node_param(node, P_Principled_fuzzRoughness) : NULL;
    const double *components;
    if (!rough || value_is_zero(node_param(node, P_Principled_fuzz)))
        return;
    const Span span = rough->span;
    if (rough->kind == VALUE_node && rough->node->kind == KIND_Constant)
        rough = &rough->node->params[0];
    if (components_of(rough, &components) && components[0] < MIN_FUZZ)
        diag_add(d->session, span, DIAG_narrow_fuzz);
}

/* Lints a Mix of materials of which one displaces the surface, and materials of different models
 * whose slots have different meanings. */
static void lint_mixed(const LintFindings *d, const Node *node)
{
    const KindRow *row = &kind_table[node->kind];
    const char *name = node->kind == KIND_MixMaterial ? "Mix" : node_written_name(node);
    unsigned models = 0;
    for (int i = 0; i < row->count; i++)
        if (param_table[row->first + i].type == PARAM_Material &&
            node->params[i].kind == VALUE_node)
            models |= d->models[node->params[i].node->index];
    if (node->kind == KIND_Layer && models & MODEL_LOBE(LOBE_coat))
        diag_add(d->session, node->span, DIAG_two_coats);
    const Value *base = node->kind == KIND_Layer ? node_param(node, P_Layer_base) : NULL;
    if (base && base->kind == VALUE_node)
        lint_layered(d, base->node);
    if (node->kind != KIND_AlgorithmSwitch && models >> MODEL_Phong & 1 &&
        models >> MODEL_Principled & 1)
        diag_add(d->session, node->span, DIAG_mixed_models, name);
    for (int i = 0; i < row->count; i++) {
        const Value *value = &node->params[i];
        const bool one = node->kind == KIND_MixMaterial || node->kind == KIND_Layer;
        if (one && param_table[row->first + i].type == PARAM_Material &&
            value->kind == VALUE_node && graph_displaces(value->node))
            diag_add(d->session, value->node->span, DIAG_mixed_displacement, name, name);
    }
}

/* Lints a formula in a displacement, where some quantities have no value. */
static void lint_shape(const LintFindings *d, const Node *node)
{
    const Value *is = node_param(node, P_Expression_is);
    if (is->kind != VALUE_formula)
        return;
    if (is->formula->meshed)
        diag_add(d->session, node->span, DIAG_displaced_attribute,
                 "attributes of the mesh as their defaults");
    if (is->formula->groups >> GROUP_O & 1)
        diag_add(d->session, node->span, DIAG_displaced_attribute, "objectRandom as 0");
}

/* Reports lints of a node; called in document order, inputs before their users. */
static void say(LintFindings *d, const Node *node)
{
    const Section section = section_of(node->kind);
    if (section == SECTION_material)
        lint_components(d, node), lint_mixed(d, node), lint_lost(d->session, node),
            lint_fuzz(d, node), lint_volume(d, node), lint_normals(d->session, node);
    if (node->kind == KIND_SideSwitch)
        lint_back(d, node);
    if (section == SECTION_transform || section == SECTION_normal)
        lint_use(d, node);
    if (node->kind == KIND_Expression && d->asked[node->index] & ASKED_shape)
        lint_shape(d, node);
    lint_units(d->session, node);
    lint_lack(d, node);
}

void lint_graph(Session *session, const Graph *graph, const Node *const *nodes, size_t count)
{
    LintFindings d = {session, ARENA_ARRAY(session->arena, unsigned, graph->node_count),
                      ARENA_ARRAY(session->arena, const Node *, graph->node_count), graph->models,
                      false};
    for (size_t i = count; i--;)
        ask_below(&d, nodes[i], d.asked[nodes[i]->index]);
    d.saying = true;
    for (size_t i = 0; i < count; i++) {
        say(&d, nodes[i]);
        ask_below(&d, nodes[i], d.asked[nodes[i]->index]);
    }
}
