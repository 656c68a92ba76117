/* Triplanar: the surface points that its maps get, and their weights. */
#include "compiler/oracle/oracle_maps.h"
#include "compiler/library/references.h"

enum { AXES = 3, COMPONENTS = 4 };

static const int maps_of[AXES] = {P_Triplanar_x, P_Triplanar_y, P_Triplanar_z};

static const Node *map_at(const Node *node, int param)
{
    const Value *value = node_param(node, param);
    return value->kind == VALUE_node ? value->node : NULL;
}

/* Returns the map of an axis, or of the next axis that has one. */
static const Node *map_of(const Node *node, int axis)
{
    for (int i = 0; i < AXES; i++)
        if (map_at(node, maps_of[(axis + i) % AXES]))
            return map_at(node, maps_of[(axis + i) % AXES]);
    return NULL;
}

void oracle_project(Environment *outer, const Node *triplanar, int axis, Projection *made)
{
    static const int u_of[AXES] = {1, 0, 0}, v_of[AXES] = {2, 2, 1};
    double p[3];
    oracle_query_input3(outer, triplanar, GROUP_X, p);
    made->surface = *outer->surface;
    made->surface.root[channel_id(GROUP_U, 0)] = p[u_of[axis]];
    made->surface.root[channel_id(GROUP_U, 1)] = p[v_of[axis]];
    made->surface.root[channel_id(GROUP_U, 2)] = 0;
    made->environment = environment_open(outer->oracle, &made->surface, outer->depth + 1);
    made->environment.mesh = outer->mesh;
    made->environment.outer = outer;
    made->environment.triplanar = triplanar;
    made->environment.axis = axis;
}

static double position(Environment *environment, const Node *node, int component)
{
    return oracle_query_input(environment, node, channel_id(GROUP_X, component));
}

/* Sets the weights by axis, at the center of the difference quotient: adjacent points use the
 * same weights. */
static void weights_at(Environment *environment, const Node *node, double weight[AXES])
{
    Environment *at = environment->origin ? environment->origin : environment;
    double slope[AXES][2], normal[AXES], sum = 0;
    for (int i = 0; i < AXES; i++)
        oracle_slopes_exact(at, &(Height){position, node, i}, slope[i]);
    for (int i = 0; i < AXES; i++) {
        const double *y = slope[(i + 1) % AXES], *z = slope[(i + 2) % AXES];
        normal[i] = y[0] * z[1] - z[0] * y[1];
    }
    reference_of(FN_safeNormalize)(NULL, normal, normal);
    for (int i = 0; i < AXES; i++) {
        weight[i] = pow(fmax(fabs(normal[i]), 1e-37), oracle_number(node, P_Triplanar_sharpness));
        sum += weight[i];
    }
    double above = 0;
    for (int i = 0; i < AXES; i++) {
        weight[i] = fmax(weight[i] / sum - 1 / 64., 0);
        above += weight[i];
    }
    for (int i = 0; i < AXES; i++)
        weight[i] /= above;
}

/* Evaluates all components of the color projected along an axis. */
static void query_side(Environment *environment, const Node *node, int axis,
                       double color[COMPONENTS])
{
    Projection here, origin;
    oracle_project(environment, node, axis, &here);
    if (environment->origin) {
        oracle_project(environment->origin, node, axis, &origin);
        here.environment.origin = &origin.environment;
        here.environment.centre = environment->centre ? &origin.environment : NULL;
    }
    for (int i = 0; i < COMPONENTS; i++)
        color[i] = oracle_query(&here.environment, map_of(node, axis), channel_id(GROUP_R, i));
}

double oracle_Triplanar(Environment *environment, const Node *node, int channel)
{
    double weight[AXES], sum[COMPONENTS] = {0}, color[COMPONENTS];
    if (!map_of(node, 0))
        return component_of(channel) == 3;
    weights_at(environment, node, weight);
    for (int axis = 0; axis < AXES; axis++) {
        query_side(environment, node, axis, color);
        for (int i = 0; i < COMPONENTS; i++)
            sum[i] += weight[axis] * color[i];
    }
    for (int i = 0; i < COMPONENTS; i++)
        memo_set(environment, node, channel_id(group_of(channel), i), sum[i]);
    return sum[component_of(channel)];
}
