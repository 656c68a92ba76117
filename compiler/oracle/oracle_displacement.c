/* True displacement (semantics.md 4.8): the offset of a point, its slopes, and the frame of the
 * displaced surface. */
#include "compiler/oracle/oracle_maps.h"
#include "compiler/base/vec3.h"
#include <math.h>

enum { ALONG_N = 2 };

/* Sets begin and end of a volume's solid intervals. An interval whose begin is below the
 * threshold becomes empty. */
static void solid_heights(Environment *environment, const Displacement *d, double bound,
                          double heights[ORACLE_HEIGHTS])
{
    const double scale = oracle_float(d->scale);
    for (int component = 0; component < ORACLE_HEIGHTS; component++)
        heights[component] =
            fmax(-bound, fmin(bound, scale * oracle_query(environment, d->volume->node,
                                                          channel_id(GROUP_R, component))));
    for (int component = 0; d->threshold->kind != VALUE_none && component < ORACLE_HEIGHTS;
         component += 2)
        if (heights[component] < oracle_float(d->threshold))
            heights[component + 1] = heights[component];
}

/* Sets the displacement along dP/du, dP/dv and the normal. */
void oracle_move_by(Environment *environment, const Node *displaced, double move[ORACLE_HEIGHTS])
{
    const Displacement d = graph_displacement(displaced);
    const double scale = oracle_float(d.scale);
    double size = 0, bound = d.bound->kind == VALUE_none ? INFINITY : oracle_float(d.bound);
    if (graph_displaces_volume(displaced)) {
        solid_heights(environment, &d, bound, move);
        return;
    }
    move[ORACLE_HEIGHTS - 1] = 0;
    for (int component = 0; component < 3; component++)
        move[component] =
            d.vector->kind == VALUE_node
                ? scale * oracle_query(environment, d.vector->node, channel_id(GROUP_R, component))
                : 0;
    if (d.height->kind == VALUE_node)
        move[ALONG_N] += scale * oracle_query(environment, d.height->node, channel_id(GROUP_R, 0));
    for (int component = 0; component < 3; component++)
        size += fabs(move[component]);
    for (int component = 0; component < 3 && size > bound; component++)
        move[component] *= bound / size;
}

static double component_of_move(Environment *environment, const Node *displaced, int component)
{
    double move[ORACLE_HEIGHTS];
    oracle_move_by(environment, displaced, move);
    return move[component];
}

void oracle_move(Environment *environment, const Node *displaced, OracleDisplacement *d)
{
    const bool volume = graph_displaces_volume(displaced),
               /* without a vector map the point moves along the normal only */
        along_normal = !volume && graph_displacement(displaced).vector->kind != VALUE_node;
    *d = (OracleDisplacement){0};
    oracle_move_by(environment, displaced, d->by);
    for (int component = along_normal ? ALONG_N : 0; component < (volume ? ORACLE_HEIGHTS : 3);
         component++) {
        double slope[2];
        oracle_slopes(environment, &(Height){component_of_move, displaced, component}, slope);
        d->by_u[component] = slope[0];
        d->by_v[component] = slope[1];
    }
}

static double length(const double v[3]) { return fmax(vec3_length(v), 1e-30); }

/* Sets the derivative of n / |n| if n changes by `change`. */
static void uv_transform_chain(const double n[3], const double change[3], double turn[3])
{
    const double size = length(n), along = vec3_dot(n, change) / (size * size);
    for (int i = 0; i < 3; i++)
        turn[i] = (change[i] - along * n[i]) / size;
}

/* Returns the rate at which a point moved along Tu by x and along Tv by y sinks: the normal
 * tilts toward the tangents. */
static double falls(const OracleDisplacement *d, const double turn[3], const double tu[3],
                    const double tv[3])
{
    return d->by[0] * vec3_dot(turn, tu) / length(tu) + d->by[1] * vec3_dot(turn, tv) / length(tv);
}

/* Sets the derivative of a unit tangent by its rotation about the normal. */
static void swing_of(const double n[3], const double tangent[3], const double change[3],
                     double swing[3])
{
    double turn[3];
    uv_transform_chain(tangent, change, turn);
    const double size = length(n), along = vec3_dot(n, turn) / (size * size);
    for (int i = 0; i < 3; i++)
        swing[i] = turn[i] - along * n[i];
}

/* Adds the derivative by u (0) or by v (1) of the displacement's x and y that results from the
 * tangents' rotation. */
static void add_swings(const OracleDisplacement *d, const Surface *surface, bool by_v,
                       double slid[3])
{
    static const Group tangents[] = {GROUP_DU, GROUP_DV};
    for (int k = 0; k < 2; k++) {
        double swing[3];
        swing_of(&surface->root[channel_id(GROUP_N, 0)], &surface->root[channel_id(tangents[k], 0)],
                 surface->tangent_slopes[k][by_v], swing);
        for (int i = 0; i < 3; i++)
            slid[i] += d->by[k] * swing[i];
    }
}

void oracle_displace(Environment *environment, const Node *displaced, Surface *surface)
{
    OracleDisplacement d;
    oracle_move(environment, displaced, &d);
    double *n = &surface->root[channel_id(GROUP_N, 0)],
           *tu = &surface->root[channel_id(GROUP_DU, 0)],
           *tv = &surface->root[channel_id(GROUP_DV, 0)];
    double slid_u[3], slid_v[3], flat[3], across[3], lifted[3], mesh[3], turn_u[3], turn_v[3];
    const double size_n = length(n), size_u = length(tu), size_v = length(tv);
    vec3_cross(tu, tv, mesh);
    const double side = vec3_dot(mesh, n) < 0 ? -1 : 1;
    uv_transform_chain(n, surface->normal_u, turn_u);
    uv_transform_chain(n, surface->normal_v, turn_v);
    const double up_u = d.by_u[ALONG_N] - falls(&d, turn_u, tu, tv),
                 up_v = d.by_v[ALONG_N] - falls(&d, turn_v, tu, tv);
    for (int i = 0; i < 3; i++) {
        slid_u[i] = tu[i] + d.by_u[0] * tu[i] / size_u + d.by_u[1] * tv[i] / size_v +
                    d.by[ALONG_N] * turn_u[i];
        slid_v[i] = tv[i] + d.by_v[0] * tu[i] / size_u + d.by_v[1] * tv[i] / size_v +
                    d.by[ALONG_N] * turn_v[i];
    }
    add_swings(&d, surface, false, slid_u);
    add_swings(&d, surface, true, slid_v);
    for (int i = 0; i < 3; i++) {
        const double unit = n[i] / size_n;
        across[i] = up_u * slid_v[i] - up_v * slid_u[i];
        tu[i] = slid_u[i] + up_u * unit;
        tv[i] = slid_v[i] + up_v * unit;
    }
    /* The cross product of the new tangents omits n x n, which is 0, but would be rounding noise
     * on steep slopes. */
    vec3_cross(slid_u, slid_v, flat);
    vec3_cross(n, across, lifted);
    for (int i = 0; i < 3; i++)
        n[i] = side * (flat[i] + lifted[i] / size_n);
}
