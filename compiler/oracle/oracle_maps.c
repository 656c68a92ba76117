/* Evaluates constants, volume functions with their waves, and Blend (semantics.md 2.1, 2.3, 2.4,
 * 2.5). */
#include "compiler/oracle/oracle_maps.h"
#include "compiler/base/vec3.h"
#include <assert.h>

static MapValue *const answers[KIND_COUNT] = {
#define MAP_VALUE_OWN(name)                      oracle_##name
#define MAP_VALUE_VOLUME(name)                   oracle_volume
#define MAP(name, function, lowering, cost, doc) [KIND_##name] = MAP_VALUE_##lowering(name),
#include "grammar/maps.def"
};

double oracle_map_value(Environment *environment, const Node *node, int channel)
{
    assert(answers[node->kind]); /* the node is a map, not a material */
    return answers[node->kind](environment, node, channel);
}

/* Evaluates a constant, which has the same value on every channel, except that derivative
 * channels are 0. */
static double constant(int channel, const double rgba[4])
{
    return is_derivative(channel) ? 0 : rgba[component_of(channel)];
}

double oracle_Constant(Environment *environment, const Node *node, int channel)
{
    (void)environment;
    double rgba[4];
    value_number(node_param(node, P_Constant_value), TYPE_vec4, rgba);
    return constant(channel, rgba);
}

double oracle_RGBColor(Environment *environment, const Node *node, int channel)
{
    (void)environment;
    double rgba[4] = {oracle_number(node, P_RGBColor_r), oracle_number(node, P_RGBColor_g),
                      oracle_number(node, P_RGBColor_b), 1};
    return constant(channel, rgba);
}

double oracle_Graytone(Environment *environment, const Node *node, int channel)
{
    (void)environment;
    double value = oracle_number(node, P_Graytone_value);
    return constant(channel, (double[4]){value, value, value, 1});
}

static double named_wave(WaveKind kind, double v)
{
    switch (kind) {
#define WAVE(name, reference, build, doc)                                                          \
    case WAVE_##name:                                                                              \
        return reference;
#include "grammar/waves.def"
    case WAVE_Chain:
        break; /* Chain has no row in the table */
    }
    assert(!"a wave");
    return v;
}

/* Evaluates a waveform at v; NULL is the identity. */
static double wave(const Environment *environment, const Wave *of, double v)
{
    oracle_spend(environment, WAVE_WORK);
    if (!of)
        return v;
    if (of->kind != WAVE_Chain)
        return named_wave(of->kind, v);
    double first = wave(environment, of->first, v);
    return wave(environment, of->second,
                oracle_float(&of->factor) * first + oracle_float(&of->shift));
}

/* Offsets of VOLUME_PARAMS in a volume map's parameters, and of the first parameter after them. */
enum {
    VOLUME_WAVE = P_Gradient_waveForm - P_Gradient_input,
    VOLUME_FREQUENCY = P_Gradient_frequency - P_Gradient_input,
    VOLUME_PHASE = P_Gradient_phase - P_Gradient_input,
    VOLUME_OWN
};

double oracle_waved(const Environment *environment, const Node *node, double value)
{
    int first = kind_table[node->kind].first;
    const Value *form = node_param(node, first + VOLUME_WAVE);
    double argument = oracle_number(node, first + VOLUME_FREQUENCY) * value +
                      oracle_number(node, first + VOLUME_PHASE);
    return wave(environment, form->kind == VALUE_wave ? form->wave : NULL, argument);
}

double oracle_same_of_all(const Environment *environment, const Node *node, int channel,
                          double value)
{
    for (int component = 0; component < 3; component++)
        memo_set(environment, node, channel_id(group_of(channel), component), value);
    return value;
}

enum { VOLUME_ARGUMENTS = 64 }; /* capacity for a position and 20 parameters of three components */

/* Appends a parameter's components to a function's arguments; returns their new count. */
static int append(const Node *node, int param, double *args, int count)
{
    assert(count + 3 <= VOLUME_ARGUMENTS);
    if (param_table[param].type == PARAM_Vec3) {
        oracle_number3(node, param, &args[count]);
        return count + 3;
    }
    double value = oracle_number(node, param);
    /* the default of a uniform may have a fraction */
    args[count] = param_table[param].type == PARAM_Int ? trunc(value) : value;
    return count + 1;
}

/* A volume map in an environment, as a function of its position. */
typedef struct {
    const Environment *environment;
    const Node *node;
} Volume;

static double volume_at(const void *map, const double p[3])
{
    const Volume *v = map;
    const KindRow *row = &kind_table[v->node->kind];
    double args[VOLUME_ARGUMENTS] = {p[0], p[1], p[2]}, result[4];
    int count = 3;
    for (int i = VOLUME_OWN; i < row->count; i++)
        count = append(v->node, row->first + i, args, count);
    oracle_call(v->environment, FN_FIRST_MAP + (int)v->node->kind, args, result);
    return oracle_waved(v->environment, v->node, result[0]);
}

/* Returns the step of the finite difference of a discontinuous volume map; 0: the map is
 * continuous. */
static double volume_step(Kind kind)
{
    return kind == KIND_Mandel || kind == KIND_Julia ? 0.005 : 0;
}

double oracle_volume(Environment *environment, const Node *node, int channel)
{
    if (component_of(channel) == 3)
        return 1;
    const double step = volume_step(node->kind);
    const Volume volume = {environment, node};
    double p[3], p0[3];
    oracle_query_input3(environment, node, GROUP_X, p);
    if (!environment->centre || step == 0)
        return oracle_same_of_all(environment, node, channel, volume_at(&volume, p));
    oracle_query_input3(environment->centre, node, GROUP_X, p0);
    const Stepped map = {volume_at, &volume, {step, step, step}};
    return oracle_same_of_all(environment, node, channel, oracle_along_steps(&map, p0, p));
}

double oracle_Gradient(Environment *environment, const Node *node, int channel)
{
    if (component_of(channel) == 3)
        return 1;
    double p[3], direction[3];
    oracle_query_input3(environment, node, GROUP_X, p);
    oracle_number3(node, P_Gradient_direction, direction);
    double f = vec3_dot(p, direction);
    return oracle_same_of_all(environment, node, channel, oracle_waved(environment, node, f));
}

double oracle_VolumeTurbulence(Environment *environment, const Node *node, int channel)
{
    if (component_of(channel) == 3)
        return 1;
    double size = oracle_number(node, P_VolumeTurbulence_size);
    double octaves = clamp(trunc(oracle_number(node, P_VolumeTurbulence_octaves)), 1, 11);
    double ratio = oracle_number(node, P_VolumeTurbulence_noiseRatio);
    double p[3], sum;
    oracle_query_input3(environment, node, GROUP_X, p);
    oracle_call(environment, FN_turbulence,
                (double[]){size * p[0], size * p[1], size * p[2], octaves,
                           oracle_number(node, P_VolumeTurbulence_frequencyRatio), ratio},
                &sum);
    double f = fabs(ratio) > 1 ? sum * pow(fabs(ratio), 1 - octaves) : sum;
    return oracle_same_of_all(environment, node, channel, oracle_waved(environment, node, f));
}

static double item_value(const Item *item) { return oracle_float(&item->value); }

/* Returns the index of the first item whose value is above t; the item count if t is above all
 * values. */
static int item_above(const Items *items, double t)
{
    int i = 0;
    while (i < items->count && !(item_value(&items->item[i]) > t))
        i++;
    return i;
}

/* Evaluates the Blend at t. All items before the one above t have values of at most t, so the
 * two mixed items never have equal values. */
static double blend_at(Environment *environment, const Items *items, double t, int channel)
{
    int above = item_above(items, t);
    oracle_spend(environment, (double)ITEM_WORK * above);
    if (above == 0)
        return oracle_query(environment, items->item[0].input, channel);
    const Item *a = &items->item[above - 1], *b = a + 1;
    double value = oracle_query(environment, a->input, channel);
    if (above == items->count)
        return value;
    double low = item_value(a), high = item_value(b);
    return (value * (high - t) + oracle_query(environment, b->input, channel) * (t - low)) /
           (high - low);
}

/* The coordinate of a Blend: a map's position, local or in world space. */
typedef struct {
    const Node *map;
    Group group;
} Along;

static const Node *node_of(const Value *value)
{
    return value->kind == VALUE_node ? value->node : NULL;
}

static bool is_checker(const Node *map)
{
    return map && (map->kind == KIND_Checker || map->kind == KIND_VolumeChecker);
}

/* Skips maps that pass the coordinate on, down to the map that defines it. */
static Along answering(Along a)
{
    for (; a.map; a.map = node_of(&a.map->params[0])) {
        const Kind kind = a.map->kind;
        if (kind == KIND_XYZTransform && a.group == GROUP_X) {
            if (node_param(a.map, P_XYZTransform_transform)->kind == VALUE_transform)
                return a;
            a.group = oracle_number(a.map, P_XYZTransform_useGlobal) != 0 ? GROUP_P : GROUP_X;
            continue;
        }
        bool empty = kind == KIND_Blend && (node_param(a.map, P_Blend_blend)->kind != VALUE_items ||
                                            !node_param(a.map, P_Blend_blend)->items->count);
        bool passes = kind == KIND_XYZTransform || kind == KIND_UVTransform ||
                      kind == KIND_BumpMap || kind == KIND_WaveMap || kind == KIND_NormalMap ||
                      (kind == KIND_Turbulence && a.group == GROUP_P) || empty;
        if (!passes)
            return a;
    }
    return a;
}

/* Blends along a coordinate. At an adjacent point a Blend along a Checker is the mean of the
 * Blends along both colors, weighted by the checker's share; nested checkers up to a depth of
 * `within`. */
static double blend_along(Environment *environment, const Items *items, Along along, int channel,
                          int within)
{
    const Along a = answering(along);
    if (!environment->centre || !within || !is_checker(a.map))
        return blend_at(environment, items,
                        oracle_query(environment, along.map, channel_id(along.group, 0)), channel);
    const int color1 = a.map->kind == KIND_Checker ? P_Checker_color1 : P_VolumeChecker_color1;
    const double share = oracle_odd_share(environment, a.map);
    double mean = 0;
    for (int i = 0; i < 2; i++) {
        const double part = i ? 1 - share : share;
        const Along color = {node_of(node_param(a.map, color1 + i)), a.group};
        if (part != 0)
            mean += part * blend_along(environment, items, color, channel, within - 1);
    }
    return mean;
}

double oracle_Blend(Environment *environment, const Node *node, int channel)
{
    enum { WITHIN = 4 };
    const Value *blend = node_param(node, P_Blend_blend);
    if (blend->kind != VALUE_items || blend->items->count == 0)
        return oracle_query_input(environment, node, channel);
    const Along along = {node_of(node_param(node, P_Blend_input)), GROUP_X};
    return blend_along(environment, blend->items, along, channel, WITHIN);
}
