/* Normal modifiers: BumpMap and WaveMap tilt the tangents by a slope along the normal; NormalMap
 * replaces the normal. */
#include "compiler/lower/bump.h"

Ref lower_unit(Lower *l, Ref n)
{
    Ir *ir = l->ir;
    const double least = 1e-30;
    Ref size = build_max(ir, build_length(ir, n), build_float(ir, least));
    return build_mul(ir, n, build_div(ir, build_float(ir, 1), size));
}

Ref lower_unit_slope(Lower *l, Ref n, Ref change)
{
    Ir *ir = l->ir;
    const double least = 1e-30;
    Ref unit = lower_unit(l, n), size = build_max(ir, build_length(ir, n), build_float(ir, least));
    Ref across = build_sub(ir, change, build_mul(ir, unit, build_dot(ir, unit, change)));
    return build_mul(ir, across, build_div(ir, build_float(ir, 1), size));
}

static Frame input_frame(Lower *l, const Node *input, const Env *env)
{
    Ref n = lower_query(l, input, GROUP_N, env);
    Frame f = {.tu = lower_query(l, input, GROUP_DU, env)};
    f.tv = lower_query(l, input, GROUP_DV, env);
    f.unit = lower_unit(l, n);
    return f;
}

/* Returns the raised normal n' = Tu' x Tv', on n's side. In the expanded product the term du dv
 * (n x n) is 0 and left out: for steep slopes it would be dominated by float rounding. Tangents
 * of the opposite handedness, as mirrored texture coordinates and transforms make them, would
 * flip the normal:
 *   n = (0, 0, 1), Tu = (-1, 0, 0), Tv = (0, 1, 0), du = 0.1, dv = 0: a rise towards -x, so the
 *   normal leans to x. Tu x Tv + n x (du Tv - dv Tu) = (0, 0, -1) + (-0.1, 0, 0); (Tu x Tv) . n
 *   < 0, so n' = (0.1, 0, 1) */
Ref lower_raised_normal(Lower *l, const Frame *f, const Ref slope[2])
{
    Ir *ir = l->ir;
    Ref flat = build_cross(ir, f->tu, f->tv);
    Ref across = build_sub(ir, build_mul(ir, f->tv, slope[0]), build_mul(ir, f->tu, slope[1]));
    Ref normal = build_add(ir, flat, build_cross(ir, f->unit, across));
    Ref turns_left =
        build_lt(ir, build_dot(ir, f->flat ? f->flat : flat, f->unit), build_float(ir, 0));
    return build_select(ir, turns_left, build_neg(ir, normal), normal);
}

/* Returns the tilted vector that `group` selects: Tu' = Tu + du n, Tv' = Tv + dv n, n' = Tu' x
 * Tv' with the unit normal n. */
static Ref tilted(Lower *l, const Frame *f, const Ref slope[2], Group group)
{
    Ir *ir = l->ir;
    if (group == GROUP_N)
        return lower_raised_normal(l, f, slope);
    const bool by_v = group == GROUP_DV;
    return build_add(ir, by_v ? f->tv : f->tu, build_mul(ir, f->unit, slope[by_v]));
}

static bool is_frame(Group group)
{
    return group == GROUP_N || group == GROUP_DU || group == GROUP_DV;
}

static Slopes turned_by(Lower *l, const Node *transform, Slopes slopes)
{
    Ref u = lower_uv_tangent(l, transform, slopes.u, slopes.v, GROUP_DU),
        v = lower_uv_tangent(l, transform, slopes.u, slopes.v, GROUP_DV);
    return (Slopes){u, v};
}

/* Returns a column of the transform: the new slopes along u (0) and along v (1). */
static Slopes column_of(Lower *l, const UvTransformChain *turn, int column)
{
    Ir *ir = l->ir;
    Ref u = build_float(ir, column == 0), v = build_float(ir, column == 1);
    return turn->transform ? turned_by(l, turn->transform, (Slopes){u, v}) : turn->column[column];
}

/* Appends a node above the chain `below`. */
static UvTransformChain turned_at(Lower *l, const UvTransformChain *below, const Node *node)
{
    if (node->kind != KIND_UVTransform)
        return *below;
    if (!below->count)
        return (UvTransformChain){.known = true, .count = 1, .transform = node};
    UvTransformChain turn = {.known = true, .count = below->count + 1};
    for (int i = 0; i < 2; i++)
        turn.column[i] = turned_by(l, node, column_of(l, below, i));
    return turn;
}

static UvTransformChain *uv_transform_at(Lower *l, const Node *node)
{
    l->turns = arena_reach(l->session->arena, l->turns, (size_t)node->index, &l->turn_capacity,
                           sizeof *l->turns);
    return &l->turns[node->index];
}

/* Returns the product of the UVTransforms from a node down its inputs. Each node caches its own
 * product, so a chain is walked once. */
static UvTransformChain uv_transform_chain(Lower *l, const Node *node)
{
    const Node **chain = NULL;
    size_t count = 0, capacity = 0;
    UvTransformChain turn = {.known = true};
    for (; node && !uv_transform_at(l, node)->known;
         node = lower_param_node(node, kind_table[node->kind].first))
        ARENA_PUSH(l->session->arena, chain, count, capacity, node);
    if (node)
        turn = *uv_transform_at(l, node);
    while (count--) {
        turn = turned_at(l, &turn, chain[count]);
        *uv_transform_at(l, chain[count]) = turn;
    }
    return turn;
}

/* Converts slopes to the input's tangents: UVTransforms transform the slopes as they do the
 * tangents. */
static Slopes along_tangents(Lower *l, const Node *input, Slopes slopes)
{
    Ir *ir = l->ir;
    const UvTransformChain turn = uv_transform_chain(l, input);
    if (turn.count <= 1)
        return turn.count ? turned_by(l, turn.transform, slopes) : slopes;
    Ref u = build_add(ir, build_mul(ir, slopes.u, turn.column[0].u),
                      build_mul(ir, slopes.v, turn.column[1].u));
    Ref v = build_add(ir, build_mul(ir, slopes.u, turn.column[0].v),
                      build_mul(ir, slopes.v, turn.column[1].v));
    return (Slopes){u, v};
}

MapValue lower_BumpMap(Lower *l, const Node *node, Group group, const Env *env)
{
    Ir *ir = l->ir;
    const double step = 0.02;
    const Node *input = lower_param_node(node, P_BumpMap_input),
               *displacement = lower_param_node(node, P_BumpMap_displacement);
    if (!is_frame(group) || !displacement)
        return lower_map_value(l, input, group, env);
    Frame frame = input_frame(l, input, env);
    Ref strength = lower_param(l, node_param(node, P_BumpMap_strength), TYPE_float);
    Ref k = build_scale(ir, strength, step);
    Slopes slopes = bump_slopes(l, node, env);
    if (l->job->choice[AXIS_derivatives] != CHOICE_derivatives_finite)
        slopes = along_tangents(l, input, slopes);
    return map_value_of(
        tilted(l, &frame, REFS(ir, build_mul(ir, k, slopes.u), build_mul(ir, k, slopes.v)), group));
}

static bool is_true(const Node *node, int param)
{
    double number[4];
    value_number(node_param(node, param), TYPE_float, number);
    return number[0] != 0;
}

/* Returns the tangent-space normal that a normal map's color encodes. */
static Ref tangent_normal(Lower *l, const Node *node, const Env *env)
{
    Ir *ir = l->ir;
    Ref color = build_convert(
        ir, lower_query(l, lower_param_node(node, P_NormalMap_normal), GROUP_R, env), TYPE_vec3);
    Ref t = build_sub(ir, build_scale(ir, color, 2), build_vec3(ir, 1, 1, 1));
    Ref scale = lower_param(l, node_param(node, P_NormalMap_scale), TYPE_float),
        xy = build_swizzle(ir, t, "xy");
    Ref z = build_swizzle(ir, t, "z");
    if (is_true(node, P_NormalMap_twoChannel)) {
        Ref rest = build_sub(ir, build_float(ir, 1), build_dot(ir, xy, xy));
        z = build_sqrt(ir, build_max(ir, rest, build_float(ir, 0)));
    }
    xy = build_mul(ir, xy, scale);
    if (is_true(node, P_NormalMap_flipY))
        xy = build_mul(ir, xy, ir_const(ir, TYPE_vec2, (double[]){1, -1}));
    return build_vec(ir, TYPE_vec3, xy, z);
}

/* Returns v / |v|; 0 if |v| is 0. */
static Ref unit(Lower *l, Ref v)
{
    Ir *ir = l->ir;
    const double least = 1e-30;
    Ref size = build_max(ir, build_length(ir, v), build_float(ir, least));
    return build_mul(ir, v, build_div(ir, build_float(ir, 1), size));
}

/* Transforms t from tangent space: t.x T + t.y B + t.z n, with T along Tu and B on the side of
 * Tv, both perpendicular to n. */
static Ref from_tangents(Lower *l, const Frame *f, Ref t)
{
    Ir *ir = l->ir;
    Ref along = build_mul(ir, f->unit, build_dot(ir, f->tu, f->unit));
    Ref tangent = unit(l, build_sub(ir, f->tu, along)), across = build_cross(ir, f->unit, tangent);
    Ref mirrored = build_lt(ir, build_dot(ir, across, f->tv), build_float(ir, 0));
    Ref bitangent = build_select(ir, mirrored, build_neg(ir, across), across);
    return build_linear(ir, REFS(ir, t, tangent, bitangent, f->unit), 4);
}

MapValue lower_NormalMap(Lower *l, const Node *node, Group group, const Env *env)
{
    Ir *ir = l->ir;
    /* Minimum cosine between the new normal and the old: tangents of a normal that lies flat
     * would be infinite. */
    const double least = 1e-3;
    const Node *input = lower_param_node(node, P_NormalMap_input);
    if (!is_frame(group) || !lower_param_node(node, P_NormalMap_normal))
        return lower_map_value(l, input, group, env);
    Frame frame = input_frame(l, input, env);
    Ref normal = from_tangents(l, &frame, tangent_normal(l, node, env));
    if (group == GROUP_N)
        return map_value_of(normal);
    Ref tangent = group == GROUP_DU ? frame.tu : frame.tv;
    Ref upright = build_max(ir, build_dot(ir, normal, frame.unit), build_float(ir, least));
    Ref rise = build_div(ir, build_dot(ir, normal, tangent), upright);
    return map_value_of(build_sub(ir, tangent, build_mul(ir, frame.unit, rise)));
}

/* A factor of the height cos(a) cos(b), a = 2 pi count x, and its slope by x. */
typedef struct {
    Ref height, slope;
} Ripple;

static Ripple ripple(Lower *l, Ref x, Ref count)
{
    Ir *ir = l->ir;
    Ref rate = build_scale(ir, count, 2 * M_PI), angle = build_mul(ir, rate, x);
    Ref height = build_cos(ir, angle), sine = build_sin(ir, angle);
    return (Ripple){height, build_neg(ir, build_mul(ir, rate, sine))};
}

/* Returns true where (u, v), relative to (1/4, 1/3), is in the top face of a box's texture
 * layout: u in [1/4, 1/2], v in [1/3, 2/3]. */
static Ref in_box_top(Lower *l, Ref u, Ref v)
{
    Ir *ir = l->ir;
    Ref zero = build_float(ir, 0);
    Ref along_u = build_and(ir, build_le(ir, zero, u), build_le(ir, u, build_float(ir, 1.0 / 4)));
    Ref along_v = build_and(ir, build_le(ir, zero, v), build_le(ir, v, build_float(ir, 1.0 / 3)));
    return build_and(ir, along_u, along_v);
}

MapValue lower_WaveMap(Lower *l, const Node *node, Group group, const Env *env)
{
    Ir *ir = l->ir;
    const Node *input = lower_param_node(node, P_WaveMap_input);
    if (!is_frame(group))
        return lower_map_value(l, input, group, env);
    double box_top[4];
    value_number(node_param(node, P_WaveMap_boxTop), TYPE_float, box_top);
    Ref uvw = lower_query(l, input, GROUP_U, env), u = build_swizzle(ir, uvw, "x"),
        v = build_swizzle(ir, uvw, "y");
    Ref u_count = lower_param(l, node_param(node, P_WaveMap_uCount), TYPE_float);
    Ref v_count = lower_param(l, node_param(node, P_WaveMap_vCount), TYPE_float);
    if (box_top[0] != 0) {
        u = build_sub(ir, u, build_float(ir, 1.0 / 4));
        v = build_sub(ir, v, build_float(ir, 1.0 / 3));
        u_count = build_scale(ir, u_count, 4);
        v_count = build_scale(ir, v_count, 3);
    }
    Frame frame = input_frame(l, input, env);
    Ref k = lower_param(l, node_param(node, P_WaveMap_amplitude), TYPE_float);
    Ripple a = ripple(l, u, u_count), b = ripple(l, v, v_count);
    Ref by_u = build_mul(ir, k, build_mul(ir, a.slope, b.height)),
        by_v = build_mul(ir, k, build_mul(ir, a.height, b.slope));
    Ref result = tilted(l, &frame, REFS(ir, by_u, by_v), group);
    if (box_top[0] != 0)
        result = build_select(ir, in_box_top(l, u, v), result, lower_query(l, input, group, env));
    return map_value_of(result);
}
