/* Evaluates NormalMap: a normal in tangent space. */
#include "compiler/oracle/oracle_maps.h"
#include "compiler/base/vec3.h"

/* Normalizes a vector; a zero vector stays 0. */
static void make_unit(double v[3])
{
    const double size = fmax(vec3_length(v), 1e-30);
    for (int i = 0; i < 3; i++)
        v[i] /= size;
}

/* Sets t to the vector that the normal map encodes: x along Tu, y along Tv, z along the normal. */
static void tangent_normal(Environment *environment, const Node *node, double t[3])
{
    const double scale = oracle_number(node, P_NormalMap_scale);
    for (int i = 0; i < 3; i++)
        t[i] =
            2 * oracle_query_param(environment, node, P_NormalMap_normal, channel_id(GROUP_R, i)) -
            1;
    if (oracle_number(node, P_NormalMap_twoChannel) != 0)
        t[2] = sqrt(fmax(1 - t[0] * t[0] - t[1] * t[1], 0));
    t[0] *= scale;
    t[1] *= oracle_number(node, P_NormalMap_flipY) != 0 ? -scale : scale;
}

/* Transforms t to world space, by the input's unit normal and tangents. */
static void turned_normal(const double t[3], const double n[3], double frame[2][3],
                          double normal[3])
{
    double along[3];
    const double leans = vec3_dot(frame[0], n);
    for (int i = 0; i < 3; i++)
        along[i] = frame[0][i] - leans * n[i];
    make_unit(along);
    double across[3];
    vec3_cross(n, along, across);
    const double side = vec3_dot(across, frame[1]) < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++)
        normal[i] = t[0] * along[i] + side * t[1] * across[i] + t[2] * n[i];
}

double oracle_NormalMap(Environment *environment, const Node *node, int channel)
{
    const bool of_frame =
        in_triple(channel, GROUP_N) || in_triple(channel, GROUP_DU) || in_triple(channel, GROUP_DV);
    if (!of_frame || node_param(node, P_NormalMap_normal)->kind == VALUE_none)
        return oracle_query_input(environment, node, channel);
    double n[3], frame[2][3], t[3], normal[3];
    oracle_query_input3(environment, node, GROUP_N, n);
    oracle_query_input3(environment, node, GROUP_DU, frame[0]);
    oracle_query_input3(environment, node, GROUP_DV, frame[1]);
    make_unit(n);
    tangent_normal(environment, node, t);
    turned_normal(t, n, frame, normal);
    if (group_of(channel) == GROUP_N)
        return normal[component_of(channel)];
    const double *tangent = frame[group_of(channel) == GROUP_DV];
    return tangent[component_of(channel)] -
           n[component_of(channel)] * vec3_dot(normal, tangent) / fmax(vec3_dot(normal, n), 1e-3);
}
