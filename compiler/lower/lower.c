/* The framework of lowering: queries of maps, their memo table, parameters as IR. */
#include "compiler/lower/area.h"
#include "compiler/lower/bump.h"
#include <string.h>

enum {
    MIN_ARM = 40,   /* min scalar operations of a map for which a choice may become a branch */
    FIRST_MEMO = 32 /* initial capacity of the memo table, enough for a small document */
};

typedef MapValue (*LowerMap)(Lower *l, const Node *node, Group group, const Env *env);

/* Lowers a volume map. The value is the same on every channel: the function of the position,
 * then its wave. */
static MapValue lower_volume(Lower *l, const Node *node, Group group, const Env *env);

#define OWN_LOWERING(name)    lower_##name
#define VOLUME_LOWERING(name) lower_volume
static const LowerMap lower_map[KIND_COUNT] = {
#define MAP(name, function, lowering, cost, doc) [KIND_##name] = lowering##_LOWERING(name),
#include "grammar/maps.def"
};

const Node *lower_param_node(const Node *node, int param)
{
    const Value *value = node_param(node, param);
    return value->kind == VALUE_node ? value->node : NULL;
}

/* Reports a uniform that is used both as an int and as a float. */
static void note_use(Lower *l, const Value *value, bool count)
{
    uint8_t *use = &l->uniform_use[value->uniform->index], now = count ? 1 : 2;
    if (*use && *use != now) {
        diag_add(l->session, value->span, DIAG_param_both, value->uniform->name);
        l->failed = true;
    }
    *use = now;
}

Ref lower_param(Lower *l, const Value *value, Type type)
{
    Ir *ir = l->ir;
    if (value->kind == VALUE_uniform) {
        const Uniform *uniform = value->uniform;
        note_use(l, value, type == TYPE_int);
        if (type == TYPE_int)
            return build_leaf(ir, OP_uniform, TYPE_int, uniform->index);
        Ref ref = build_leaf(ir, OP_uniform, uniform->type, uniform->index);
        return type == TYPE_bool ? ref : build_convert(ir, ref, type);
    }
    double numbers[4];
    if (l->job->from_buffer && value->given && type >= TYPE_float && value->type >= TYPE_float)
        return build_convert(ir, ir_constant(ir, value->type, value->number, value), type);
    value_number(value, type, numbers);
    return ir_const(ir, type, numbers);
}

void lower_reject_uniform(Lower *l, const Value *value, const char *name, const char *why)
{
    if (value->kind != VALUE_uniform)
        return;
    diag_add(l->session, value->span, DIAG_param_here, name, why);
    l->failed = true;
}

Ref lower_as_group(Lower *l, Ref value, Group group)
{
    Ir *ir = l->ir;
    if (group == GROUP_R)
        return value;
    return group == GROUP_IOR ? build_swizzle(ir, value, "x") : build_convert(ir, value, TYPE_vec3);
}

/* Doubles the memo: a hash table whose entries hold the whole key and the value, so that a
 * lookup reads no other memory. */
static void memo_grow(Lower *l)
{
    size_t size = l->memo ? 2 * (l->memo_mask + 1) : FIRST_MEMO;
    Memo *old = l->memo, *grown = ARENA_ARRAY(l->session->arena, Memo, size);
    for (size_t i = 0; old && i <= l->memo_mask; i++) {
        if (!old[i].key)
            continue;
        size_t at = old[i].key * 0x9E3779B97F4A7C15u >> 32 & (size - 1);
        while (grown[at].key)
            at = (at + 1) & (size - 1);
        grown[at] = old[i];
    }
    l->memo = grown;
    l->memo_mask = size - 1;
}

static Memo *memo_find(Lower *l, uint64_t key)
{
    if (2 * l->memo_count >= l->memo_mask)
        memo_grow(l);
    size_t at = key * 0x9E3779B97F4A7C15u >> 32 & l->memo_mask;
    while (l->memo[at].key && l->memo[at].key != key)
        at = (at + 1) & l->memo_mask;
    return &l->memo[at];
}

/* Returns the component that all components of a vector equal, or the value itself. */
static Ref repeated(const Ir *ir, Ref value)
{
    const IrNode *node = ir_at(ir, value);
    for (int i = 1; node->op == OP_vec && i < node->count; i++)
        if (ir_arg(ir, value, i) != ir_arg(ir, value, 0))
            return value;
    return node->op == OP_vec ? ir_arg(ir, value, 0) : value;
}

/* Marks the node as the value of a map or slot. A node that is another map's value already keeps
 * its first name. */
void lower_mark_head(Ir *ir, Ref value, uint32_t origin)
{
    value = repeated(ir, value);
    IrNode *node = &ir->nodes[value];
    if (node->op == OP_const || node->op == OP_input || node->op == OP_attribute ||
        ir_is_head(ir, value))
        return;
    node->origin = origin;
    ir_set_head(ir, value, true);
}

/* Returns a draw call's value; it becomes an input of the program when first queried. */
static Ref root_of(Lower *l, Group group, const Env *env)
{
    Ir *ir = l->ir;
    if (group == GROUP_T)
        return build_input(ir, INPUT_time);
    if (group == GROUP_O)
        return env->shape ? build_float(ir, 0) : build_input(ir, INPUT_object);
    if (group == GROUP_E)
        return env->seen ? build_input(ir, INPUT_viewer)
                         : build_vec(ir, TYPE_vec4, env->root[GROUP_N], build_float(ir, 0));
    if (group == GROUP_P && l->job->origin)
        return build_add(ir, env->root[GROUP_P], build_input(ir, INPUT_origin));
    return env->root[group];
}

static void note_averageable(Lower *l, const Node *map, Group group, const Env *env)
{
    const MetMap met = {map, group, !env->number && !env->relief};
    ARENA_PUSH(l->session->arena, l->averageable.at, l->averageable.count, l->averageable.capacity,
               met);
    l->averageable.mingled |= !met.outside;
}

MapValue lower_map_value(Lower *l, const Node *map, Group group, const Env *env)
{
    if (!map || group_is_draws(group))
        return map_value_of(root_of(l, group, env));
    if (env->relief && !map->steps)
        return bump_smooth(l, map, group, env);
    uint64_t key =
        ((uint64_t)(2 * env->number + env->relief) << 32 | (uint64_t)map->index) * GROUP_COUNT +
        group + 1;
    Memo *memo = memo_find(l, key);
    /* a lowering without means may reuse only values without a mean */
    if (memo->key && (l->averaged_below || !memo->averaged)) {
        l->averaged |= memo->averaged;
        return memo->answer;
    }
    if (l->ir->count > LIMIT_IR_NODES) {
        if (!l->failed)
            diag_add(l->session, map->span, DIAG_graph_too_large, LIMIT_IR_NODES);
        l->failed = true;
        return map_value_of(env->root[group]);
    }
    uint32_t origin = l->ir->origin;
    const Node *above = l->map;
    l->ir->origin = ir_origin(l->ir, map);
    l->map = map;
    const bool beside = l->averaged; /* true if an earlier map was averaged */
    if (l->job->choice[AXIS_aa] == CHOICE_aa_auto && footprint_may_average(map->kind) &&
        !l->filters)
        note_averageable(l, map, group, env);
    l->averaged = l->job->choice[AXIS_aa] == CHOICE_aa_auto && footprint_is_filtered(l);
    MapValue answer = lower_map[map->kind](l, map, group, env);
    l->map = above;
    lower_mark_head(l->ir, answer.value, l->ir->origin);
    l->ir->origin = origin;
    memo = memo_find(l, key); /* the table may have moved while the map was lowered */
    l->memo_count += !memo->key;
    *memo = (Memo){key, answer, l->averaged};
    l->averaged |= beside;
    return answer;
}

/* Returns a map's own cost. A material counts 1, so that in nested mixes at most `limit` nodes
 * are visited. */
static int own_cost(const Node *map)
{
    return kind_table[map->kind].cost + (kind_table[map->kind].lowering == LOWERING_MATERIAL);
}

static void add_costs(const Node *map, int limit, MapCosts *costs)
{
    costs->points += own_cost(map);
    costs->averageable += footprint_may_average(map->kind);
    for (int i = 0; i < kind_table[map->kind].count && costs->points < limit; i++) {
        const Value *value = &map->params[i];
        if (value->kind == VALUE_node)
            add_costs(value->node, limit, costs);
        for (int k = 0;
             value->kind == VALUE_items && k < value->items->count && costs->points < limit; k++)
            if (value->items->item[k].input)
                add_costs(value->items->item[k].input, limit, costs);
    }
}

MapCosts lower_map_costs(const Node *map, int limit)
{
    MapCosts costs = {0};
    if (map)
        add_costs(map, limit, &costs);
    return costs;
}

bool lower_wants_branch(const Node *map) { return lower_map_costs(map, MIN_ARM).points >= MIN_ARM; }

MapValue lower_arm(Lower *l, const Node *map, Group group, const Env *env)
{
    const bool branches = lower_wants_branch(map);
    l->arms += branches;
    MapValue answer = lower_map_value(l, map, group, env);
    l->arms -= branches;
    return answer;
}

Ref lower_query(Lower *l, const Node *map, Group group, const Env *env)
{
    return lower_map_value(l, map, group, env).value;
}

MapValue lower_waved(Lower *l, const Node *node, MapValue f)
{
    enum { WAVE_FORM = 1, FREQUENCY, PHASE };
    const Value *wave = &node->params[WAVE_FORM];
    MapValue v = map_value_scaled(l, f, lower_param(l, &node->params[FREQUENCY], TYPE_float));
    v = map_value_moved(l, v, lower_param(l, &node->params[PHASE], TYPE_float));
    return wave->kind == VALUE_wave ? lower_wave(l, wave->wave, v) : v;
}

enum { MAX_OWN = 7 };

/* A volume map and its own parameters. */
typedef struct {
    const Node *node;
    Ref args[MAX_OWN];
    int count;
} Volume;

static MapValue volume_map_value(Lower *l, const Volume *v, MapValue p)
{
    return lower_waved(l, v->node, area_volume(l, v->node->kind, p, v->args, v->count));
}

static Ref volume_at(Lower *l, const void *map, MapValue p)
{
    return volume_map_value(l, map, p).value;
}

static MapValue lower_volume(Lower *l, const Node *node, Group group, const Env *env)
{
    enum { FIRST_OWN = 4 };
    const KindRow *row = &kind_table[node->kind];
    const Node *input = node->params[0].kind == VALUE_node ? node->params[0].node : NULL;
    Volume volume = {.node = node};
    Stepped steps = {.at = volume_at, .map = &volume, .q = lower_map_value(l, input, GROUP_X, env)};
    for (int i = FIRST_OWN; i < row->count; i++) {
        static const Type type_of[] = {
            [PARAM_Float] = TYPE_float, [PARAM_Int] = TYPE_int, [PARAM_Vec3] = TYPE_vec3};
        volume.args[volume.count++] =
            lower_param(l, &node->params[i], type_of[param_table[row->first + i].type]);
    }
    MapValue answer = volume_map_value(l, &volume, steps.q);
    for (int i = 0; i < row->step_components; i++)
        steps.step[i] = row->step;
    if (row->step_components)
        bump_step(l, answer.value, &steps);
    return map_value_as_group(l, answer, group);
}

/* Lowers a Gradient: dot(p, direction). */
MapValue lower_Gradient(Lower *l, const Node *node, Group group, const Env *env)
{
    MapValue p = lower_map_value(l, lower_param_node(node, P_Gradient_input), GROUP_X, env);
    Ref direction = lower_param(l, node_param(node, P_Gradient_direction), TYPE_vec3);
    return map_value_as_group(l, lower_waved(l, node, map_value_dot(l, p, direction)), group);
}

/* Returns a = max(|omega|, 1)^(1 - n), which normalizes the sum of octaves that grow. */
static Ref octave_scale(Lower *l, Ref omega, double octaves)
{
    Ir *ir = l->ir;
    Ref one = build_float(ir, 1), size = build_abs(ir, omega);
    return build_pow(ir, build_max(ir, size, one), build_float(ir, 1 - octaves));
}

/* Lowers a VolumeTurbulence: a Turb(size p). */
MapValue lower_VolumeTurbulence(Lower *l, const Node *node, Group group, const Env *env)
{
    enum { MAX_OCTAVES = 11 };
    const Value *octaves = node_param(node, P_VolumeTurbulence_octaves);
    lower_reject_uniform(l, octaves, "octaves", "the loop over the octaves has a fixed length");
    double given[4];
    value_number(octaves, TYPE_float, given);
    double n = clamp(given[0], 1, MAX_OCTAVES);
    MapValue p = lower_map_value(l, lower_param_node(node, P_VolumeTurbulence_input), GROUP_X, env);
    Ref omega = lower_param(l, node_param(node, P_VolumeTurbulence_noiseRatio), TYPE_float);
    Ref size = lower_param(l, node_param(node, P_VolumeTurbulence_size), TYPE_float);
    Ref frequency = lower_param(l, node_param(node, P_VolumeTurbulence_frequencyRatio), TYPE_float);
    p = map_value_scaled(l, p, size);
    MapValue f = area_turbulence(l, p, (Ref[]){build_int(l->ir, n), frequency, omega});
    f = map_value_scaled(l, f, octave_scale(l, omega, n));
    return map_value_as_group(l, lower_waved(l, node, f), group);
}
