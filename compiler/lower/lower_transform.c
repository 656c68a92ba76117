/* Coordinate transformers: they change their own coordinate and pass every other channel on. */
#include "compiler/lower/area.h"
#include <math.h>

static bool is_zero(const Ir *ir, Ref ref) { return ir_is_number(ir, ref, 0); }

/* Multiplies a matrix of scalars, m[row][column], by q; a diagonal matrix becomes a product per
 * component. */
static Ref times_matrix(Lower *l, Ref m[3][3], int size, Ref q)
{
    Ir *ir = l->ir;
    Type type = size == 2 ? TYPE_vec2 : TYPE_vec3;
    bool diagonal = true;
    for (int i = 0; i < size; i++)
        for (int k = 0; k < size; k++)
            diagonal &= i == k || is_zero(ir, m[i][k]);
    if (diagonal)
        return build_mul(
            ir, q,
            build_vec_of(ir, type, REFS(ir, m[0][0], m[1][1], size == 3 ? m[2][2] : 0), size));
    Ref args[4] = {q};
    for (int k = 0; k < size; k++)
        args[k + 1] =
            build_vec_of(ir, type, REFS(ir, m[0][k], m[1][k], size == 3 ? m[2][k] : 0), size);
    return build_linear(ir, args, size + 1);
}

/* Transforms a mean: variances of independent components are summed by the squares of their
 * factors. */
static MapValue turned(Lower *l, Ref m[3][3], int size, MapValue q)
{
    Ref squares[3][3] = {{0}};
    MapValue answer = map_value_of(times_matrix(l, m, size, q.value));
    if (!q.variance)
        return answer;
    for (int i = 0; i < size; i++)
        for (int k = 0; k < size; k++)
            squares[i][k] = build_square(l->ir, m[i][k]);
    answer.variance = times_matrix(l, squares, size, q.variance);
    return answer;
}

/* Sets the 2x2 part of a UVTransform's matrix: uv' = m (uv - offset). */
static void uv_matrix(Lower *l, const Node *node, Ref m[3][3])
{
    Ir *ir = l->ir;
    Ref angle = lower_param(l, node_param(node, P_UVTransform_angle), TYPE_float);
    Ref c = build_cos(ir, angle), s = build_sin(ir, angle);
    Ref scale_u = lower_param(l, node_param(node, P_UVTransform_scaleU), TYPE_float);
    Ref scale_v = lower_param(l, node_param(node, P_UVTransform_scaleV), TYPE_float);
    Ref sheared =
        build_mul(ir, lower_param(l, node_param(node, P_UVTransform_shear), TYPE_float), scale_v);
    m[0][0] = build_add(ir, build_mul(ir, scale_u, c), build_mul(ir, sheared, s));
    m[0][1] = build_sub(ir, build_mul(ir, scale_u, s), build_mul(ir, sheared, c));
    m[1][0] = build_neg(ir, build_mul(ir, scale_v, s));
    m[1][1] = build_mul(ir, scale_v, c);
}

/* Returns 1/x, and 0 for 0: a texture scaled to 0 has no tangent. */
static Ref guarded_inverse(Lower *l, Ref x)
{
    Ir *ir = l->ir;
    Ref flat = build_eq(ir, x, build_float(ir, 0));
    Ref inverse = build_div(ir, build_float(ir, 1), build_select(ir, flat, build_float(ir, 1), x));
    return build_select(ir, flat, build_float(ir, 0), inverse);
}

Ref lower_uv_tangent(Lower *l, const Node *node, Ref du, Ref dv, Group group)
{
    Ir *ir = l->ir;
    Ref m[3][3];
    uv_matrix(l, node, m);
    Ref determinant =
        build_sub(ir, build_mul(ir, m[0][0], m[1][1]), build_mul(ir, m[0][1], m[1][0]));
    Ref inverse = guarded_inverse(l, determinant);
    Ref by_u = group == GROUP_DU ? m[1][1] : build_neg(ir, m[0][1]);
    Ref by_v = group == GROUP_DU ? build_neg(ir, m[1][0]) : m[0][0];
    return build_add(ir, build_mul(ir, du, build_mul(ir, by_u, inverse)),
                     build_mul(ir, dv, build_mul(ir, by_v, inverse)));
}

/* Returns m ((u, v) - offset); w is unchanged. */
static MapValue turned_uv(Lower *l, const Node *node, MapValue uvw)
{
    Ir *ir = l->ir;
    Ref m[3][3];
    uv_matrix(l, node, m);
    Ref offset_u = lower_param(l, node_param(node, P_UVTransform_offsetU), TYPE_float);
    Ref offset_v = lower_param(l, node_param(node, P_UVTransform_offsetV), TYPE_float);
    Ref offset = build_vec(ir, TYPE_vec2, offset_u, offset_v);
    MapValue uv = map_value_swizzle(l, uvw, "xy");
    uv.value = build_sub(ir, uv.value, offset);
    uv = turned(l, m, 2, uv);
    MapValue answer =
        map_value_of(build_vec(ir, TYPE_vec3, uv.value, build_swizzle(ir, uvw.value, "z")));
    if (uv.variance)
        answer.variance =
            build_vec(ir, TYPE_vec3, uv.variance, build_swizzle(ir, uvw.variance, "z"));
    return answer;
}

MapValue lower_UVTransform(Lower *l, const Node *node, Group group, const Env *env)
{
    const Node *input = lower_param_node(node, P_UVTransform_input);
    if (group == GROUP_DU || group == GROUP_DV) {
        Ref du = lower_query(l, input, GROUP_DU, env), dv = lower_query(l, input, GROUP_DV, env);
        return map_value_of(lower_uv_tangent(l, node, du, dv, group));
    }
    MapValue answer = lower_map_value(l, input, group, env);
    return group == GROUP_U ? turned_uv(l, node, answer) : answer;
}

/* Multiplies 3x3 matrices of scalars: result = a b. */
static void matrix_product(Lower *l, Ref a[3][3], Ref b[3][3], Ref result[3][3])
{
    Ir *ir = l->ir;
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) {
            result[i][k] = build_mul(ir, a[i][0], b[0][k]);
            for (int j = 1; j < 3; j++)
                result[i][k] = build_add(ir, result[i][k], build_mul(ir, a[i][j], b[j][k]));
        }
}

static void identity(Lower *l, Ref m[3][3])
{
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            m[i][k] = build_float(l->ir, i == k);
}

/* Sets m to the rotation about an axis: x 0, y 1, z 2. */
static void rotation(Lower *l, int axis, Ref angle, Ref m[3][3])
{
    Ir *ir = l->ir;
    int i = (axis + 1) % 3, k = (axis + 2) % 3;
    Ref c = build_cos(ir, angle), s = build_sin(ir, angle);
    identity(l, m);
    m[i][i] = m[k][k] = c;
    m[i][k] = build_neg(ir, s);
    m[k][i] = s;
}

/* Sets m to the matrix Rz Ry Rx S H of a component transformation. */
static void component_matrix(Lower *l, const Transform *transform, Ref m[3][3])
{
    Ir *ir = l->ir;
    static const char *const component[] = {"x", "y", "z"};
    Ref angles = lower_param(l, &transform->rotation, TYPE_vec3), turn[3][3], before[3][3];
    Ref scale = lower_param(l, &transform->scale, TYPE_vec3),
        shear = lower_param(l, &transform->shear, TYPE_vec3);
    identity(l, m);
    m[0][1] = build_swizzle(ir, shear, "x");
    m[0][2] = build_swizzle(ir, shear, "y");
    m[1][2] = build_swizzle(ir, shear, "z");
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++)
            m[i][k] = build_mul(ir, m[i][k], build_swizzle(ir, scale, component[i]));
    for (int axis = 0; axis < 3; axis++) {
        rotation(l, axis, build_swizzle(ir, angles, component[axis]), turn);
        for (int i = 0; i < 9; i++)
            before[i / 3][i % 3] = m[i / 3][i % 3];
        matrix_product(l, turn, before, m);
    }
}

/* Returns M q, the point q transformed by a Transform. */
static MapValue transformed(Lower *l, const Transform *transform, MapValue q)
{
    Ir *ir = l->ir;
    Ref m[3][3], shift;
    switch (transform->kind) {
    case TRANSFORM_scale:
        return map_value_scaled(l, q, lower_param(l, &transform->scale, TYPE_float));
    case TRANSFORM_translation:
        return map_value_moved(l, q, lower_param(l, &transform->translation, TYPE_vec3));
    case TRANSFORM_matrix:
        for (int i = 0; i < 9; i++)
            m[i / 3][i % 3] = build_float(ir, transform->matrix[i / 3 * 4 + i % 3]);
        shift = build_vec3(ir, transform->matrix[3], transform->matrix[7], transform->matrix[11]);
        break;
    default:
        component_matrix(l, transform, m);
        shift = lower_param(l, &transform->translation, TYPE_vec3);
        break;
    }
    return map_value_moved(l, turned(l, m, 3, q), shift);
}

MapValue lower_XYZTransform(Lower *l, const Node *node, Group group, const Env *env)
{
    const Node *input = lower_param_node(node, P_XYZTransform_input);
    if (group != GROUP_X)
        return lower_map_value(l, input, group, env);
    double global[4];
    value_number(node_param(node, P_XYZTransform_useGlobal), TYPE_float, global);
    MapValue q = lower_map_value(l, input, global[0] != 0 ? GROUP_P : GROUP_X, env);
    const Value *transform = node_param(node, P_XYZTransform_transform);
    return transform->kind == VALUE_transform ? transformed(l, transform->transform, q) : q;
}

/* Lowers a Turbulence: q + amount DTurb(q), for the position and for the texture coordinate
 * alike. */
MapValue lower_Turbulence(Lower *l, const Node *node, Group group, const Env *env)
{
    enum { MAX_OCTAVES = 10 };
    MapValue q = lower_map_value(l, lower_param_node(node, P_Turbulence_input), group, env);
    if (group != GROUP_X && group != GROUP_U)
        return q;
    const Value *octaves = node_param(node, P_Turbulence_octaves);
    lower_reject_uniform(l, octaves, "octaves", "the loop over the octaves has a fixed length");
    double given[4];
    value_number(octaves, TYPE_float, given);
    Ref n = build_int(l->ir, clamp(given[0], 1, MAX_OCTAVES));
    Ref frequency = lower_param(l, node_param(node, P_Turbulence_frequencyRatio), TYPE_float);
    Ref noise_ratio = lower_param(l, node_param(node, P_Turbulence_noiseRatio), TYPE_float);
    MapValue offset = area_vector_turbulence(l, q, (Ref[]){n, frequency, noise_ratio});
    offset = map_value_scaled(l, offset,
                              lower_param(l, node_param(node, P_Turbulence_amount), TYPE_vec3));
    return map_value_sum(l, q, offset);
}
