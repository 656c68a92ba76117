/* Evaluates the normal modifiers and the filters (semantics.md 2.7, 2.8). */
#include "compiler/oracle/oracle_maps.h"
#include "compiler/base/vec3.h"
#include <string.h>

/* The surface's tangent frame: normal and both tangents. */
typedef struct {
    double n[3], du[3], dv[3];
} Frame;

static void query_frame(Environment *environment, const Node *node, Frame *frame)
{
    oracle_query_input3(environment, node, GROUP_N, frame->n);
    oracle_query_input3(environment, node, GROUP_DU, frame->du);
    oracle_query_input3(environment, node, GROUP_DV, frame->dv);
}

static double guarded_length(const double v[3]) { return fmax(vec3_length(v), 1e-30); }

static double cross(const double a[3], const double b[3], int component)
{
    int i = (component + 1) % 3, j = (component + 2) % 3;
    return a[i] * b[j] - a[j] * b[i];
}

/* Returns the handedness: -1 for tangents that are left-handed around the normal, as mirrored
 * ones are, else 1. */
static double turning(const Frame *frame)
{
    double volume = 0;
    for (int i = 0; i < 3; i++)
        volume += cross(frame->du, frame->dv, i) * frame->n[i];
    return volume < 0 ? -1 : 1;
}

/* Returns a component of the frame after the tangents were raised along the normal by the given
 * slopes. The new normal is their cross product, not normalized, on the old normal's side. The
 * term n x n is left out: it is 0, but would be rounding noise as a difference of products of
 * steep slopes. */
static double raised(const Frame *frame, double slope_u, double slope_v, int channel)
{
    int component = component_of(channel);
    if (group_of(channel) == GROUP_DU)
        return frame->du[component] + slope_u * frame->n[component];
    if (group_of(channel) == GROUP_DV)
        return frame->dv[component] + slope_v * frame->n[component];
    const double normal = cross(frame->du, frame->dv, component) +
                          slope_u * cross(frame->n, frame->dv, component) +
                          slope_v * cross(frame->du, frame->n, component);
    return turning(frame) * normal;
}

static bool in_frame(int channel)
{
    return in_triple(channel, GROUP_N) || in_triple(channel, GROUP_DU) ||
           in_triple(channel, GROUP_DV);
}

/* Opens an adjacent point: (u, v) moved by `du` and `dv`, with the positions on the surface. A
 * Triplanar's map gets the projection of the point adjacent to the Triplanar's own; `projections`
 * has an element for each surrounding Triplanar. */
static Environment *open_beside(Environment *environment, double du, double dv,
                                Projection *projections)
{
    if (environment->outer) {
        oracle_project(open_beside(environment->outer, du, dv, projections + 1),
                       environment->triplanar, environment->axis, projections);
    } else {
        projections->surface = *environment->surface;
        double *root = projections->surface.root;
        const double *tangents =
            environment->mesh ? environment->mesh->root : environment->surface->root;
        root[channel_id(GROUP_U, 0)] += du;
        root[channel_id(GROUP_U, 1)] += dv;
        for (int i = 0; i < 3; i++) {
            root[channel_id(GROUP_P, i)] +=
                du * tangents[channel_id(GROUP_DU, i)] + dv * tangents[channel_id(GROUP_DV, i)];
            root[channel_id(GROUP_X, i)] +=
                du * projections->surface.local_u[i] + dv * projections->surface.local_v[i];
        }
        projections->environment =
            environment_open(environment->oracle, &projections->surface, environment->depth + 1);
    }
    projections->environment.origin = environment;
    projections->environment.centre =
        environment->oracle->derivatives != CHOICE_derivatives_analytic ? environment : NULL;
    return &projections->environment;
}

static double height_at(Environment *environment, const Height *height, double du, double dv)
{
    Projection capacity[LIMIT_FILTERS + 1];
    return height->at(open_beside(environment, du, dv, capacity), height->node, height->component);
}

/* Returns a step that is small compared with a float's rounding, so that both sides of a crease
 * can be distinguished, but large compared with a double's. */
static double slope_step(const Surface *surface)
{
    double size = 1;
    for (int i = 0; i < 3; i++) {
        size = fmax(size, fabs(surface->root[channel_id(GROUP_U, i)]));
        size = fmax(size, fabs(surface->root[channel_id(GROUP_X, i)]));
        size = fmax(size, fabs(surface->root[channel_id(GROUP_P, i)]));
    }
    return ldexp(size, -26);
}

/* Deviation of the height on one side from the line through the heights at the point and on the
 * other side; and its rounding error. */
typedef struct {
    double bend, rounding;
} Bend;

/* Computes the bend on one side; `here` is the height at the point. Both sides have different
 * distances: from the middle of a stair's step, equal distances would cross as many steps up as
 * down. Rounding has two sources: the height, and the point, whose coordinates are up to 2^26 /
 * part of its movement. */
static Bend bend_at(Environment *environment, const Height *height, const double move[2],
                    double part, double here)
{
    const double ulp = ldexp(1, -52), back = 0.618, du = part * move[0], dv = part * move[1];
    double ahead = height_at(environment, height, du, dv);
    double behind = height_at(environment, height, -back * du, -back * dv);
    double of_height = 12 * ulp * fabs(here),
           of_point = 4 * ulp * fabs(ahead - behind) * ldexp(1 / part, 26);
    return (Bend){fabs(ahead - here - (here - behind) / back), of_height + of_point};
}

/* Checks for a smooth curve, whose deviation is quadratic in the step, and over a small part of
 * the step no more than rounding; a stair deviates by a whole step or by none, over whatever
 * part.
 *   sin(x) at 1, 2^-26 to either side: deviates by 2e-16; over a tenth of that by 2e-18
 *   ceil(1e9 x) there: by -1, 0 or 1 of 30 steps; over a tenth of that by -1, 0 or 1 of 3 */
static bool is_smooth(Environment *environment, const Height *height, const double move[2])
{
    enum { PARTS = 8 };
    /* steps wider than this are not conclusive for maps with periods of at most 1 */
    const double shrink = 0.41, widest = ldexp(1, -10);
    if (fmax(move[0], move[1]) > widest)
        return false;
    const double here = height_at(environment, height, 0, 0);
    const Bend whole = bend_at(environment, height, move, 1, here);
    double part = 1;
    for (int i = 0; i < PARTS; i++) {
        part *= shrink;
        Bend bend = bend_at(environment, height, move, part, here);
        if (bend.bend > 2 * part * part * whole.bend + bend.rounding)
            return false;
    }
    return true;
}

/* Returns the derivative along a direction (1 or 0 of u and of v) from a difference. A one-sided
 * span uses the parabola through three points, since a straight line would be off by a part of
 * the slope's own derivative: noise has different curvatures on both sides of a lattice point. */
static double slope_along(Environment *environment, const Height *height, const double along[2],
                          double h)
{
    double ahead = environment->oracle->ahead * h, behind = environment->oracle->behind * h;
    double far = ahead != 0 ? ahead : behind, half = far / 2;
    double at_far = height_at(environment, height, far * along[0], far * along[1]);
    if (ahead != 0 && behind != 0)
        return (at_far - height_at(environment, height, behind * along[0], behind * along[1])) /
               (ahead - behind);
    double here = height_at(environment, height, 0, 0);
    double at_half = height_at(environment, height, half * along[0], half * along[1]);
    return (4 * (at_half - here) - (at_far - here)) / far;
}

void oracle_slopes(Environment *environment, const Height *height, double slope[2])
{
    const double h = slope_step(environment->surface);
    slope[0] = slope_along(environment, height, (double[]){1, 0}, h);
    slope[1] = slope_along(environment, height, (double[]){0, 1}, h);
    if (environment->oracle->judges && !(is_smooth(environment, height, (double[]){h, 0}) &&
                                         is_smooth(environment, height, (double[]){0, h})))
        environment->oracle->rough = true;
}

/* Returns the derivative of a smooth function near the point, to a few ulp: central differences
 * over steps from wide to narrow, each extrapolated with the previous ones to a step of 0
 * (Ridders 1982). The result is the entry with the least difference to its neighbors plus
 * rounding error.
 *     x^3 at 1: steps of 1/2 and 1/8 give 3.25 and 3.015625, and (16 * 3.015625 - 3.25) / 15 = 3 */
static double slope_extrapolated(Environment *environment, const Height *height,
                                 const double along[2], double widest)
{
    enum { STEPS = 9, SHRINK = 4 };
    double row[STEPS] = {0}, before[STEPS], best = 0, least = INFINITY, h = widest;
    for (int i = 0; i < STEPS; i++, h /= SHRINK) {
        const double ahead = height_at(environment, height, h * along[0], h * along[1]),
                     behind = height_at(environment, height, -h * along[0], -h * along[1]),
                     rounding = ldexp(fmax(fabs(ahead), fabs(behind)), -53) / h;
        memcpy(before, row, sizeof before);
        row[0] = (ahead - behind) / (2 * h);
        double power = 1;
        for (int k = 1; k <= i; k++) {
            power *= SHRINK * SHRINK;
            row[k] = row[k - 1] + (row[k - 1] - before[k - 1]) / (power - 1);
            const double error =
                fmax(fabs(row[k] - row[k - 1]), fabs(row[k] - before[k - 1])) + rounding;
            if (error < least)
                least = error, best = row[k];
        }
    }
    return best;
}

void oracle_slopes_exact(Environment *environment, const Height *height, double slope[2])
{
    const double widest = ldexp(slope_step(environment->surface), 20);
    oracle_slopes(environment, height, slope);
    for (int i = 0; i < 2 && environment->oracle->ahead != 0 && environment->oracle->behind != 0;
         i++)
        slope[i] = slope_extrapolated(environment, height, (double[]){!i, i}, widest);
}

/* Caches all channels of the frame after the tangents were raised; returns the requested one. */
static double raised_frame(Environment *environment, const Node *node, const Frame *frame,
                           const double slope[2], int channel)
{
    static const Group groups[] = {GROUP_N, GROUP_DU, GROUP_DV};
    for (int i = 0; i < 9; i++) {
        int of = channel_id(groups[i / 3], i % 3);
        memo_set(environment, node, of, raised(frame, slope[0], slope[1], of));
    }
    return raised(frame, slope[0], slope[1], channel);
}

static double red(Environment *environment, const Node *map, int component)
{
    return oracle_query(environment, map, channel_id(GROUP_R, component));
}

double oracle_BumpMap(Environment *environment, const Node *node, int channel)
{
    bool flat = node_param(node, P_BumpMap_displacement)->kind == VALUE_none;
    if (flat || !in_frame(channel))
        return oracle_query_input(environment, node, channel);
    Frame frame;
    query_frame(environment, node, &frame);
    double k = 0.02 * oracle_number(node, P_BumpMap_strength) / guarded_length(frame.n);
    double slope[2];
    if (environment->oracle->derivatives != CHOICE_derivatives_finite) {
        oracle_slopes(environment,
                      &(Height){red, node_param(node, P_BumpMap_displacement)->node, 0}, slope);
        /* The slopes are applied along the input's tangents, so UVTransforms below transform
         * both. */
        const Value *input = node_param(node, P_BumpMap_input);
        oracle_turn_slopes(environment->oracle, input->kind == VALUE_node ? input->node : NULL,
                           slope);
    } else {
        slope[0] =
            oracle_query_param(environment, node, P_BumpMap_displacement, channel_id(GROUP_DU, 0));
        slope[1] =
            oracle_query_param(environment, node, P_BumpMap_displacement, channel_id(GROUP_DV, 0));
    }
    return raised_frame(environment, node, &frame, (double[]){k * slope[0], k * slope[1]}, channel);
}

/* A range of channels. */
typedef struct {
    int first, count;
} Components;

/* Origin and frequencies of a WaveMap's waves. */
typedef struct {
    double u, v, count_u, count_v;
} WavePoint;

/* Moves the point to the top face of a box: u in [1/4, 1/2], v in [1/3, 2/3] of its texture
 * layout. The waves are then relative to the face. */
static void move_to_box_top(WavePoint *point)
{
    point->u -= 1. / 4;
    point->v -= 1. / 3;
    point->count_u *= 4;
    point->count_v *= 3;
}

static bool on_box_top(const WavePoint *point)
{
    return point->u >= 0 && point->u <= 1. / 4 && point->v >= 0 && point->v <= 1. / 3;
}

double oracle_WaveMap(Environment *environment, const Node *node, int channel)
{
    if (!in_frame(channel))
        return oracle_query_input(environment, node, channel);
    WavePoint point = {oracle_query_input(environment, node, channel_id(GROUP_U, 0)),
                       oracle_query_input(environment, node, channel_id(GROUP_U, 1)),
                       oracle_number(node, P_WaveMap_uCount),
                       oracle_number(node, P_WaveMap_vCount)};
    bool box_top = oracle_number(node, P_WaveMap_boxTop) != 0;
    if (box_top)
        move_to_box_top(&point);
    if (box_top && !on_box_top(&point))
        return oracle_query_input(environment, node, channel);
    Frame frame;
    query_frame(environment, node, &frame);
    double k = oracle_number(node, P_WaveMap_amplitude) / guarded_length(frame.n);
    double omega_u = 2 * M_PI * point.count_u, omega_v = 2 * M_PI * point.count_v;
    double slope_u = -omega_u * sin(omega_u * point.u) * cos(omega_v * point.v);
    double slope_v = -omega_v * cos(omega_u * point.u) * sin(omega_v * point.v);
    return raised(&frame, k * slope_u, k * slope_v, channel);
}

static Surface shifted(const Surface *from, const double shift[3])
{
    Surface surface = *from;
    for (int i = 0; i < 3; i++)
        surface.root[channel_id(GROUP_X, i)] += shift[i];
    for (int i = 0; i < 2; i++)
        surface.root[channel_id(GROUP_U, i)] += shift[i];
    return surface;
}

/* Evaluates the input on some components of a group, at a surface point whose local position and
 * texture coordinate are offset by `shift`. */
static void shifted_input(Environment *environment, const Node *node, const Components *components,
                          const double shift[3], double result[3])
{
    Oracle *oracle = environment->oracle;
    const Environment *origin = environment->origin ? environment->origin : environment;
    const Surface here = shifted(environment->surface, shift),
                  middle = shifted(origin->surface, shift);
    Environment moved = environment_open(oracle, &here, environment->depth + 1);
    Environment moved_centre = environment_open(oracle, &middle, environment->depth + 2);
    moved.origin = environment->origin ? &moved_centre : NULL;
    moved.centre = environment->centre ? &moved_centre : NULL;
    for (int i = 0; i < components->count; i++)
        result[i] = oracle_query_input(&moved, node, components->first + i);
}

enum { CENTRE = 13 }; /* index of the center among the 27 cells */

/* Weights of a 3x3x3 kernel, by the number of the three indices that differ from the center's. */
typedef double Kernel[4];

/* Evaluates a filter as a sum of differences to the center: a constant yields exactly itself or
 * 0, without the rounding of the weights' sum. All components of a group are evaluated together,
 * since they share their points. */
static double filtered(Environment *environment, const Node *node, int channel,
                       const double size[3], const Kernel kernel)
{
    const Components components = {channel_id(group_of(channel), 0),
                                   group_of(channel) == GROUP_IOR ? 1 : 3};
    double centre[3] = {0}, value[3] = {0}, sum[3] = {0}, weights = 0;
    if (component_of(channel) >= components.count)
        return 1;
    shifted_input(environment, node, &components, (double[3]){0}, centre);
    for (int cell = 0; cell < 27 && !oracle_spent(environment->oracle); cell++) {
        int offset[3] = {cell % 3 - 1, cell / 3 % 3 - 1, cell / 9 - 1};
        double weight = kernel[(offset[0] != 0) + (offset[1] != 0) + (offset[2] != 0)];
        if (weight == 0)
            continue;
        double shift[3];
        for (int i = 0; i < 3; i++)
            shift[i] = size[i] * offset[i] / 2;
        weights += weight;
        if (cell != CENTRE)
            shifted_input(environment, node, &components, shift, value);
        for (int i = 0; cell != CENTRE && i < components.count; i++)
            sum[i] += weight * (value[i] - centre[i]);
    }
    for (int i = 0; i < components.count; i++) {
        /* the weights of either kernel add up to 0 or 1 */
        sum[i] += centre[i] * (fabs(weights) < 1e-12 ? 0 : 1);
        memo_set(environment, node, components.first + i, sum[i]);
    }
    return sum[component_of(channel)];
}

double oracle_Smooth3D(Environment *environment, const Node *node, int channel)
{
    static const Kernel kernel = {1. / 27, 1. / 27, 1. / 27, 1. / 27};
    double size[3] = {oracle_number(node, P_Smooth3D_sx), oracle_number(node, P_Smooth3D_sy),
                      oracle_number(node, P_Smooth3D_sz)};
    return filtered(environment, node, channel, size, kernel);
}

double oracle_Laplace3D(Environment *environment, const Node *node, int channel)
{
    static const Kernel kernel = {6. / 12, -1. / 12, 0, 0};
    double size[3] = {oracle_number(node, P_Laplace3D_sx), oracle_number(node, P_Laplace3D_sy),
                      oracle_number(node, P_Laplace3D_sz)};
    return filtered(environment, node, channel, size, kernel);
}
