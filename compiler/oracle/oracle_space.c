/* Evaluates the coordinate transformers (semantics.md 2.6). They forward all channels that they
 * do not change. */
#include "compiler/oracle/oracle_maps.h"

/* A map of texture coordinates: (u', v') = linear * ((u, v) - offset). */
typedef struct {
    double linear[2][2], offset[2];
} UVMap;

static UVMap uv_map(const Node *node)
{
    double c = cos(oracle_number(node, P_UVTransform_angle)),
           s = sin(oracle_number(node, P_UVTransform_angle));
    double scale_u = oracle_number(node, P_UVTransform_scaleU),
           scale_v = oracle_number(node, P_UVTransform_scaleV);
    double shear = oracle_number(node, P_UVTransform_shear) * scale_v;
    return (UVMap){
        .linear = {{scale_u * c + shear * s, scale_u * s - shear * c}, {-scale_v * s, scale_v * c}},
        .offset = {oracle_number(node, P_UVTransform_offsetU),
                   oracle_number(node, P_UVTransform_offsetV)},
    };
}

/* Sets the inverse of the linear part, whose determinant is scaleU * scaleV. A singular map has
 * no inverse: there the tangents become 0 rather than infinite. */
static void uv_inverse(const Node *node, const UVMap *map, double inverse[2][2])
{
    double determinant =
        oracle_number(node, P_UVTransform_scaleU) * oracle_number(node, P_UVTransform_scaleV);
    double factor = determinant != 0 ? 1 / determinant : 0;
    inverse[0][0] = map->linear[1][1] * factor;
    inverse[0][1] = -map->linear[0][1] * factor;
    inverse[1][0] = -map->linear[1][0] * factor;
    inverse[1][1] = map->linear[0][0] * factor;
}

static double uv_tangent(Environment *environment, const Node *node, int channel)
{
    UVMap map = uv_map(node);
    double inverse[2][2];
    uv_inverse(node, &map, inverse);
    int column = group_of(channel) == GROUP_DU ? 0 : 1, component = component_of(channel);
    return oracle_query_input(environment, node, channel_id(GROUP_DU, component)) *
               inverse[0][column] +
           oracle_query_input(environment, node, channel_id(GROUP_DV, component)) *
               inverse[1][column];
}

void oracle_uv_slopes(const Node *node, double slope[2])
{
    UVMap map = uv_map(node);
    double inverse[2][2], u = slope[0], v = slope[1];
    uv_inverse(node, &map, inverse);
    slope[0] = u * inverse[0][0] + v * inverse[1][0];
    slope[1] = u * inverse[0][1] + v * inverse[1][1];
}

static const Node *input_of(const Node *node)
{
    const Value *input = &node->params[0];
    return input->kind == VALUE_node ? input->node : NULL;
}

static SlopeTurn *uv_transform_at(Oracle *oracle, const Node *node)
{
    size_t number = node_number(&oracle->arena, &oracle->turned, node);
    oracle->turns = arena_reach(&oracle->arena, oracle->turns, number, &oracle->turn_capacity,
                                sizeof *oracle->turns);
    return &oracle->turns[number];
}

/* Returns the product of the UVTransforms from a node down its inputs. Every node caches its
 * own, so a chain is walked once. */
static SlopeTurn uv_transform_chain(Oracle *oracle, const Node *node)
{
    const Node **chain = NULL;
    size_t count = 0, capacity = 0;
    SlopeTurn turn = {true, {{1, 0}, {0, 1}}};
    for (; node && !uv_transform_at(oracle, node)->known; node = input_of(node))
        ARENA_PUSH(&oracle->arena, chain, count, capacity, node);
    if (node)
        turn = *uv_transform_at(oracle, node);
    while (count--) {
        if (chain[count]->kind == KIND_UVTransform)
            for (int i = 0; i < 2; i++) /* transforms (1, 0) and (0, 1) */
                oracle_uv_slopes(chain[count], turn.m[i]);
        *uv_transform_at(oracle, chain[count]) = turn;
    }
    return turn;
}

void oracle_turn_slopes(Oracle *oracle, const Node *input, double slope[2])
{
    const SlopeTurn turn = uv_transform_chain(oracle, input);
    const double u = slope[0], v = slope[1];
    slope[0] = u * turn.m[0][0] + v * turn.m[1][0];
    slope[1] = u * turn.m[0][1] + v * turn.m[1][1];
}

double oracle_UVTransform(Environment *environment, const Node *node, int channel)
{
    if (in_triple(channel, GROUP_DU) || in_triple(channel, GROUP_DV))
        return uv_tangent(environment, node, channel);
    if (group_of(channel) != GROUP_U || component_of(channel) > 1)
        return oracle_query_input(environment, node, channel);
    UVMap map = uv_map(node);
    double u = oracle_query_input(environment, node, channel_id(GROUP_U, 0)) - map.offset[0];
    double v = oracle_query_input(environment, node, channel_id(GROUP_U, 1)) - map.offset[1];
    const double *row = map.linear[component_of(channel)];
    return row[0] * u + row[1] * v;
}

/* Rotates q about an axis, right-handed: about z, x turns toward y. */
static void rotate(double q[3], int axis, double angle)
{
    int i = (axis + 1) % 3, j = (axis + 2) % 3;
    double c = cos(angle), s = sin(angle);
    double a = c * q[i] - s * q[j];
    q[j] = s * q[i] + c * q[j];
    q[i] = a;
}

/* Applies M = T Rz Ry Rx S H, from the right: shear, scale, rotate about x, y, z, translate. */
static void transform_components(const Transform *transform, double q[3])
{
    double translation[3], rotation[3], scale[3], shear[3];
    oracle_vec3(&transform->translation, translation);
    oracle_vec3(&transform->rotation, rotation);
    oracle_vec3(&transform->scale, scale);
    oracle_vec3(&transform->shear, shear);
    q[0] += shear[0] * q[1] + shear[1] * q[2];
    q[1] += shear[2] * q[2];
    for (int i = 0; i < 3; i++)
        q[i] *= scale[i];
    for (int axis = 0; axis < 3; axis++)
        rotate(q, axis, rotation[axis]);
    for (int i = 0; i < 3; i++)
        q[i] += translation[i];
}

static void transform_scale(const Transform *transform, double q[3])
{
    double scale = oracle_float(&transform->scale);
    for (int i = 0; i < 3; i++)
        q[i] *= scale;
}

static void transform_translation(const Transform *transform, double q[3])
{
    double translation[3];
    oracle_vec3(&transform->translation, translation);
    for (int i = 0; i < 3; i++)
        q[i] += translation[i];
}

static void transform_matrix(const Transform *transform, double q[3])
{
    double p[3] = {q[0], q[1], q[2]};
    for (int i = 0; i < 3; i++) {
        const double *row = &transform->matrix[4 * i];
        q[i] = row[0] * p[0] + row[1] * p[1] + row[2] * p[2] + row[3];
    }
}

static void apply(const Transform *transform, double q[3])
{
    switch (transform->kind) {
    case TRANSFORM_scale:
        transform_scale(transform, q);
        break;
    case TRANSFORM_translation:
        transform_translation(transform, q);
        break;
    case TRANSFORM_matrix:
        transform_matrix(transform, q);
        break;
    case TRANSFORM_components:
        transform_components(transform, q);
        break;
    }
}

double oracle_XYZTransform(Environment *environment, const Node *node, int channel)
{
    if (!in_triple(channel, GROUP_X))
        return oracle_query_input(environment, node, channel);
    double q[3];
    bool global = oracle_number(node, P_XYZTransform_useGlobal) != 0;
    oracle_query_input3(environment, node, global ? GROUP_P : GROUP_X, q);
    const Value *transform = node_param(node, P_XYZTransform_transform);
    if (transform->kind == VALUE_transform)
        apply(transform->transform, q);
    return q[component_of(channel)];
}

/* Adds noise, evaluated at the requested triple (local position or texture coordinate), to that
 * triple. */
double oracle_Turbulence(Environment *environment, const Node *node, int channel)
{
    if (!in_triple(channel, GROUP_X) && !in_triple(channel, GROUP_U))
        return oracle_query_input(environment, node, channel);
    double q[3], amount[3], offset[3];
    oracle_query_input3(environment, node, group_of(channel), q);
    oracle_number3(node, P_Turbulence_amount, amount);
    double octaves = clamp(trunc(oracle_number(node, P_Turbulence_octaves)), 1, 10);
    oracle_call(environment, FN_vectorTurbulence,
                (double[]){q[0], q[1], q[2], octaves,
                           oracle_number(node, P_Turbulence_frequencyRatio),
                           oracle_number(node, P_Turbulence_noiseRatio)},
                offset);
    for (int component = 0; component < 3; component++) {
        q[component] += amount[component] * offset[component];
        memo_set(environment, node, channel_id(group_of(channel), component), q[component]);
    }
    return q[component_of(channel)];
}
