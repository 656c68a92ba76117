/* The grammar as a generator. Writes YAML's flow style, so that indentation does not matter. */
#include "generate.h"
#include "grammar/tables.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum {
    MAX_DEFINITIONS = 2,
    MAX_PARAMS = 6,
    MAX_FILTERS = 2,
    MAX_ITEMS = 5,
    MAX_CHAIN = 3,
    MAX_INPUTS = 2,
    WIDEST_RELIEF = 64
};

typedef struct {
    Choices *c;
    Text *out;
    int left;        /* remaining number of maps */
    int definitions; /* definitions that may be referenced */
    int filters;     /* number of enclosing filters */
    int params;      /* number of uniforms */
    bool hostile;
    bool relief; /* generate a height map */
} Generator;

static void map_value(Generator *g);
static void put_map(Generator *g);
static void put_transformer(Generator *g);

static void put_number(Generator *g, double value)
{
    char text[32];
    snprintf(text, sizeof text, "%.9g", value);
    text_put(g->out, text);
}

static double any_number(Generator *g)
{
    return generate_number(g->c, -GENERATE_GREATEST, GENERATE_GREATEST, g->hostile);
}

/* Parameters that must be compile-time constants. */
static bool may_be_param(const ParamRow *row)
{
    return row->kind != KIND_Carpenter && strcmp(row->name, "octaves") &&
           strcmp(row->name, "sun") && strcmp(row->name, "turbidity") &&
           strcmp(row->name, "displacementBound") && strcmp(row->name, "dimensions");
}

static void begin_param(Generator *g)
{
    text_format(g->out, "{ param: p%d, default: ", g->params++);
}

static bool choose_param(Generator *g) { return g->params < MAX_PARAMS && chance(g->c, 1, 16); }

static void put_vector(Generator *g, int components, double low, double high)
{
    text_put(g->out, "[");
    for (int i = 0; i < components; i++) {
        text_put(g->out, i ? ", " : "");
        put_number(g, generate_number(g->c, low, high, g->hostile));
    }
    text_put(g->out, "]");
}

static void put_float(Generator *g)
{
    bool param = choose_param(g);
    if (param)
        begin_param(g);
    put_number(g, any_number(g));
    text_put(g->out, param ? " }" : "");
}

static void put_numeric(Generator *g, const ParamRow *row)
{
    bool param = may_be_param(row) && choose_param(g);
    double low = fmax(row->low, -GENERATE_GREATEST), high = fmin(row->high, GENERATE_GREATEST);
    if (row->kind == KIND_Carpenter && high == 2048)
        high = WIDEST_RELIEF; /* a large relief is slow and finds no more faults */
    if (param)
        begin_param(g);
    if (row->type == PARAM_Int) {
        double most = fmin(high, chance(g->c, 1, 8) ? 200 : 12), least = fmax(low, -3);
        put_number(g, least + (double)choose(g->c, (uint32_t)(most - least) + 1));
    } else if (row->type == PARAM_Vec3 && !chance(g->c, 1, 8)) {
        put_vector(g, 3, low, high);
    } else {
        double value = generate_number(g->c, low, high, g->hostile);
        put_number(
            g, row->kind == KIND_SunSkyLight && row->type == PARAM_Vec3 && value == 0 ? 1 : value);
    }
    text_put(g->out, param ? " }" : "");
}

static void put_wave(Generator *g, int depth)
{
    uint32_t kind = choose(g->c, WAVE_COUNT + (depth < MAX_CHAIN ? 3 : 0));
    if (kind < WAVE_COUNT) {
        text_put(g->out, wave_table[kind].name);
        return;
    }
    text_put(g->out, "{ wave: Chain, first: ");
    put_wave(g, depth + 1);
    if (chance(g->c, 1, 2)) {
        text_put(g->out, ", factor: ");
        put_float(g);
        text_put(g->out, ", shift: ");
        put_float(g);
    }
    if (chance(g->c, 1, 2)) {
        text_put(g->out, ", second: ");
        put_wave(g, depth + 1);
    }
    text_put(g->out, " }");
}

static void put_matrix(Generator *g)
{
    text_put(g->out, "{ matrix: [");
    for (int i = 0; i < 12; i++) {
        put_number(g, chance(g->c, 1, 2) ? any_number(g) : i % 5 == 0);
        text_put(g->out, ", ");
    }
    text_put(g->out, "0, 0, 0, 1] }");
}

static void put_transform(Generator *g)
{
    static const char *const parts[] = {"translation", "rotation", "scale", "shear"};
    uint32_t kind = choose(g->c, 4);
    if (kind == 3) {
        put_matrix(g);
        return;
    }
    text_put(g->out, "{ ");
    if (kind == 0) {
        text_put(g->out, "scale: ");
        put_float(g);
    } else if (kind == 1) {
        text_put(g->out, "translation: ");
        put_vector(g, 3, -GENERATE_GREATEST, GENERATE_GREATEST);
    } else {
        for (int i = 0, count = 0; i < 4; i++)
            if (i == 1 || chance(g->c, 1, 2)) {
                text_format(g->out, "%s%s: ", count++ ? ", " : "", parts[i]);
                put_vector(g, 3, -GENERATE_GREATEST, GENERATE_GREATEST);
            }
    }
    text_put(g->out, " }");
}

/* Ascending values, some of them equal; rarely unordered ones; `plain`: a list of maps. */
static void put_items(Generator *g, bool plain)
{
    int count = g->relief ? 2 + (int)choose(g->c, MAX_ITEMS - 1) : (int)choose(g->c, MAX_ITEMS + 1);
    bool any = chance(g->c, 1, 8);
    double value = generate_number(g->c, -2, 2, false);
    text_put(g->out, "[");
    for (int i = 0; i < count; i++) {
        text_put(g->out, i ? ", " : "");
        if (plain) {
            map_value(g);
            continue;
        }
        text_put(g->out, "{ value: ");
        if (any)
            put_float(g);
        else
            put_number(g, value);
        value += (double[]){0.5, 0.25, 1, 0, 1e-6, 1e4}[choose(g->c, g->hostile ? 6 : 4)];
        if (g->relief || !chance(g->c, 1, 16)) {
            text_put(g->out, ", input: ");
            map_value(g);
        }
        text_put(g->out, " }");
    }
    text_put(g->out, "]");
}

/* A keyword of a list. */
static void put_word(Generator *g, const ParamRow *row)
{
    int first = 0, count = 0;
    for (int i = 0; i < WORD_COUNT; i++)
        if (keyword_table[i].list == row->type && !count++)
            first = i;
    text_put(g->out, keyword_table[first + (int)choose(g->c, (uint32_t)count)].name);
}

/* True for a parameter that is a position, not a content. */
static bool is_place(const ParamRow *row)
{
    return !strcmp(row->name, "input") && row->kind != KIND_Blend && row->kind != KIND_Smooth3D &&
           row->kind != KIND_Laplace3D;
}

static void put_value(Generator *g, const ParamRow *row)
{
    switch (row->type) {
    case PARAM_Map:
        if (g->relief && is_place(row))
            put_transformer(g);
        else if (!param_is_number((int)(row - param_table)))
            map_value(g);
        else
            g->left <= 0 || chance(g->c, 1, 4) ? put_numeric(g, row) : put_map(g);
        break;
    case PARAM_Bool:
        text_put(g->out, chance(g->c, 1, 2) ? "true" : "false");
        break;
    case PARAM_Wave:
        put_wave(g, 0);
        break;
    case PARAM_Transform:
        put_transform(g);
        break;
    case PARAM_Image:
        text_put(g->out, chance(g->c, 1, 8) ? "null" : "tiles.png");
        break;
    case PARAM_List:
    case PARAM_Items:
        put_items(g, row->type == PARAM_List);
        break;
    default:
        param_is_word(row) ? put_word(g, row) : put_numeric(g, row);
    }
}

/* Inputs of a map are given more often than its numbers. A relief has to vary: its maps read the
 * surface's position or a transform of it, and its Blends have items. */
static bool is_given(Generator *g, const ParamRow *row)
{
    if (g->relief && (row->type == PARAM_Items || is_place(row)))
        return row->type == PARAM_Items || (g->left > 0 && chance(g->c, 1, 3));
    if (row->type == PARAM_Map || row->type == PARAM_Items || row->type == PARAM_List)
        return g->left > 0 && chance(g->c, 5, 6);
    return chance(g->c, 1, 2);
}

/* In a relief mostly a map with finite difference slopes; Blends, whose items end there, and
 * maps costly enough for a branch. */
static Kind choose_map(Generator *g)
{
    static const Kind first = KIND_Constant + 1;
    static const Kind rising[] = {KIND_Gradient, KIND_Gradient, KIND_Leopard,
                                  KIND_Wood,     KIND_Granite,  KIND_VolumeTurbulence,
                                  KIND_Blend,    KIND_Blend,    KIND_Blend,
                                  KIND_Checker,  KIND_ImageMap, KIND_Smooth3D};
    if (g->relief && chance(g->c, 7, 8))
        return rising[choose(g->c, sizeof rising / sizeof *rising)];
    return (Kind)(first + choose(g->c, KIND_COUNT - first));
}

/* Its inputs are read by their first components, because their widths are unknown here. */
static void put_expression(Generator *g)
{
    const int inputs = g->left > 1 ? (int)choose(g->c, MAX_INPUTS + 1) : 0;
    text_put(g->out, "{ map: Expression, is: '");
    generate_formula(g->c, g->out, inputs);
    text_put(g->out, "', with: {");
    for (int i = 0; i < inputs; i++) {
        text_format(g->out, "%s i%d: ", i ? "," : "", i);
        map_value(g);
    }
    text_put(g->out, " }");
    if (g->left > 0 && chance(g->c, 1, 4)) {
        text_put(g->out, ", input: ");
        put_transformer(g);
    }
    text_put(g->out, " }");
}

static void put_kind(Generator *g, Kind kind)
{
    bool filter = kind == KIND_Smooth3D || kind == KIND_Laplace3D || kind == KIND_Triplanar;
    if (filter && (g->filters == MAX_FILTERS || !chance(g->c, 1, 3)))
        kind = KIND_Checker, filter = false;
    const KindRow *row = &kind_table[kind];
    g->left--;
    if (kind == KIND_Expression) {
        put_expression(g);
        return;
    }
    g->filters += filter;
    text_format(g->out, "{ map: %s", row->name);
    for (int i = 0; i < row->count; i++)
        if (is_given(g, &param_table[row->first + i])) {
            text_format(g->out, ", %s: ", param_table[row->first + i].name);
            put_value(g, &param_table[row->first + i]);
        }
    text_put(g->out, " }");
    g->filters -= filter;
}

static void put_map(Generator *g) { put_kind(g, choose_map(g)); }

static void put_transformer(Generator *g)
{
    put_kind(g,
             (const Kind[]){KIND_UVTransform, KIND_XYZTransform, KIND_Turbulence}[choose(g->c, 3)]);
}

static void put_constant(Generator *g)
{
    int components = 1 + (int)choose(g->c, 4);
    bool param = choose_param(g);
    if (param)
        begin_param(g);
    if (components == 1)
        put_number(g, any_number(g));
    else
        put_vector(g, components, -GENERATE_GREATEST, GENERATE_GREATEST);
    text_put(g->out, param ? " }" : "");
}

static void map_value(Generator *g)
{
    if (g->definitions && chance(g->c, 1, 8))
        text_format(g->out, "{ ref: d%d }", (int)choose(g->c, (uint32_t)g->definitions));
    else if (g->left > 0 && chance(g->c, g->relief ? 7 : 6, 8))
        put_map(g);
    else
        put_constant(g);
}

static void put_material(Generator *g, int depth);

static void put_material_parameter(Generator *g, const ParamRow *row, int depth)
{
    text_format(g->out, "%s%s: ", depth ? ", " : "\n", row->name);
    if (row->type == PARAM_Material)
        put_material(g, depth + 1);
    else
        put_value(g, row);
}

/* Mostly a Phong. Mixes and coats may be nested, switches are outermost. */
static Kind choose_material(Choices *c, int depth)
{
    static const Kind others[] = {
        KIND_RGBA,       KIND_SunSkyLight, KIND_Principled,  KIND_glTF,       KIND_StandardSurface,
        KIND_UsdPreview, KIND_Layer,       KIND_MixMaterial, KIND_SideSwitch, KIND_AlgorithmSwitch};
    return chance(c, 1, 4) ? others[choose(c, depth > 1 ? 6 : depth ? 8 : 10)] : KIND_Phong;
}

/* Documents do not displace surfaces, except for bump slopes, since the comparison has no vertices.
 * tests/compiler/lower/test_displacement.c tests displacement. */
static bool moves_surface(const ParamRow *row)
{
    return !strncmp(row->name, "displacement", strlen("displacement"));
}

/* a material with more parameters gets fewer of them, displacement included */
enum { OWN_MANY = 10 };

static void put_material(Generator *g, int depth)
{
    const KindRow *row = &kind_table[choose_material(g->c, depth)];
    text_format(g->out, depth ? "{ material: %s" : "material: %s", row->name);
    for (int i = 0; i < row->count; i++)
        if (!moves_surface(&param_table[row->first + i]) &&
            chance(g->c, row->count > OWN_MANY ? 2 : 4, 6))
            put_material_parameter(g, &param_table[row->first + i], depth);
    text_put(g->out, depth ? " }" : "\n");
}

void generate_document(Choices *c, Text *out)
{
    static const int sizes[] = {1, 2, 3, 5, 8, 12, 20, LARGEST_TREE};
    int definitions = chance(c, 1, 4) ? 1 + (int)choose(c, MAX_DEFINITIONS) : 0;
    int size = sizes[choose(c, sizeof sizes / sizeof *sizes)];
    Generator g = {.c = c, .out = out, .left = size, .hostile = chance(c, 1, 2)};
    if (chance(c, 1, 4))
        text_put(out, "colors: srgb\n");
    if (definitions)
        text_put(out, "defs:\n");
    for (int i = 0; i < definitions; i++) {
        g.left = size / 3;
        g.filters = MAX_FILTERS; /* the definition may be used within other filters */
        text_format(out, "  d%d: ", i);
        map_value(&g);
        g.definitions = i + 1;
        text_put(out, "\n");
    }
    g.left = size;
    g.filters = 0;
    put_material(&g, 0);
}

/* A height for a BumpMap, or for displacement: then the normal is that of the displaced surface. */
void generate_relief(Choices *c, Text *out)
{
    static const int sizes[] = {1, 2, 4, 6, 9, 14};
    static const char bump[] = "input: { map: BumpMap, displacement: ",
                      *const moves[] = {bump,
                                        bump,
                                        bump,
                                        bump,
                                        "displacementScale: 0.25\ndisplacement: ",
                                        "displacementVector: "};
    Generator g = {.c = c, .out = out, .hostile = chance(c, 1, 8), .relief = true};
    g.left = sizes[choose(c, sizeof sizes / sizeof *sizes)];
    const char *begin = moves[choose(c, sizeof moves / sizeof *moves)];
    text_format(out, "material: Phong\n%s", begin);
    put_map(&g);
    if (begin == bump && chance(c, 1, 3)) {
        g.left = 2;
        text_put(out, ", input: ");
        put_map(&g);
    }
    text_put(out, begin == bump ? " }\n" : "\n");
}

void generate_map(Choices *c, Text *out, int size)
{
    Generator g = {.c = c, .out = out, .left = size, .hostile = chance(c, 1, 2)};
    map_value(&g);
}
