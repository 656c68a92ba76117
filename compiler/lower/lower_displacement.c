/* True displacement: the vertex stages move a point, and shading uses the normal of the exact
 * displaced surface, which the triangles approximate.
 *
 *     P' = P + x Tu/|Tu| + y Tv/|Tv| + (z + h) n,  (x, y, z) the displacementVector, h the red
 *     of `displacement`, both times the scale
 *     N' = dP'/du x dP'/dv, in which n changes over the surface as the mesh's normals do;
 *     Tu/|Tu| and Tv/|Tv| tilt with n, and rotate about it as the mesh's tangents do
 *
 * So a pixel's normal has the full slope at any tessellation: finer triangles change the surface
 * but not the shading. A plane z = 0, u = x, v = y, h = sin(u) / 10 at u = 0: dP'/du = (1, 0,
 * 0.1), N' = (-0.1, 0, 1). A ball of radius r has dn/du = Tu/r, so with h = r / 4 a tangent is
 * longer by a fourth, and tilts less by that factor: (1.25, 0, .1) along u, dv likewise, and N'
 * = (-.125, 0, 1.5625), parallel to (-.08, 0, 1).
 * Maps read the surface of the undisplaced mesh, so a color stays at its point however far that
 * moves.
 *
 * Alternatively a volume replaces the surface: along n it is solid from the red of
 * displacementVolume to its green, and from blue to alpha; a pair whose second value is not
 * greater is empty. The mesher computes the volume's normals, so the fragment program uses the
 * mesh's. */
#include "compiler/lower/bump.h"
#include "compiler/lower/slope.h"

/* Environment numbers in the memo, above all numbers that filters derive from others. */
enum { ENV_DISPLACED = 16, ENV_VERTEX = 32, ENV_CORNER = 64 };

static Ref height(Lower *l, const Displacement *d, const Env *env)
{
    return build_swizzle(l->ir, lower_query(l, d->height->node, GROUP_R, env), "x");
}

static Ref vector(Lower *l, const Displacement *d, const Env *env)
{
    return build_convert(l->ir, lower_query(l, d->vector->node, GROUP_R, env), TYPE_vec3);
}

/* Returns the sum of height and vector, as far as both are present. */
static Ref moved_by(Lower *l, const Displacement *d, const Env *env)
{
    Ir *ir = l->ir;
    if (d->vector->kind != VALUE_node)
        return height(l, d, env);
    Ref v = vector(l, d, env);
    if (d->height->kind != VALUE_node)
        return v;
    Ref zero = build_float(ir, 0);
    return build_add(ir, v, build_vec(ir, TYPE_vec3, zero, zero, height(l, d, env)));
}

/* Limits the displacement's length to `bound` in any direction, by the sum of its components'
 * magnitudes; a volume's components lie along one direction, and are clamped each. */
static Ref within(Lower *l, Ref value, double bound)
{
    Ir *ir = l->ir;
    const double least = 1e-30;
    const Type type = ir_type(ir, value);
    if (type != TYPE_vec3)
        return build_clamp(ir, value, build_all(ir, type, -bound), build_all(ir, type, bound));
    Ref size = build_max(ir, build_dot(ir, build_abs(ir, value), build_vec3(ir, 1, 1, 1)),
                         build_float(ir, least));
    return build_mul(
        ir, value, build_min(ir, build_float(ir, 1), build_div(ir, build_float(ir, bound), size)));
}

/* Empties a volume whose beginning is below the threshold: its end becomes its beginning. */
static Ref above(Lower *l, Ref heights, double threshold)
{
    Ir *ir = l->ir;
    Ref from[2], to[2];
    for (int i = 0; i < 2; i++) {
        from[i] = build_component(ir, heights, 2 * i);
        Ref low = build_lt(ir, from[i], build_float(ir, threshold));
        to[i] = build_select(ir, low, from[i], build_component(ir, heights, 2 * i + 1));
    }
    return build_vec(ir, TYPE_vec4, from[0], to[0], from[1], to[1]);
}

static Ref volume(Lower *l, const Displacement *d, const Env *env)
{
    return build_convert(l->ir, lower_query(l, d->volume->node, GROUP_R, env), TYPE_vec4);
}

Ref lower_displacement(Lower *l, const Node *displaced, const Env *env)
{
    const Displacement d = graph_displacement(displaced);
    const bool solid = graph_displaces_volume(displaced);
    double bound[4], threshold[4];
    Ref value = build_mul(l->ir, solid ? volume(l, &d, env) : moved_by(l, &d, env),
                          lower_param(l, d.scale, TYPE_float));
    lower_reject_uniform(l, d.bound, "displacementBound",
                         "bounding volumes are built before it is set");
    lower_reject_uniform(l, d.threshold, "displacementThreshold", "it selects the shape");
    if (d.bound->kind == VALUE_number) {
        value_number(d.bound, TYPE_float, bound);
        value = within(l, value, bound[0]);
    }
    if (!solid || d.threshold->kind != VALUE_number)
        return value;
    value_number(d.threshold, TYPE_float, threshold);
    return above(l, value, threshold[0]);
}

static Ref tangent(const Env *env, bool by_v) { return env->root[by_v ? GROUP_DV : GROUP_DU]; }

/* A displacement with its slopes, and the derivatives by u and v of the mesh's unit normal
 * (turns) and of its unit tangents' rotation about the normal (swings; index 0 for Tu, 1 for
 * Tv); 0: constant. */
typedef struct {
    Ref by;
    Slopes slopes, turns, swings[2];
} Carried;

/* Returns the part of the displaced tangent other than its rise along n: Tu + x_u Tu/|Tu| + y_u
 * Tv/|Tv| + x s_u + y t_u + z n_u, where s and t are the rotations of both unit tangents. */
static Ref slid(Lower *l, const Env *env, const Carried *m, bool by_v)
{
    Ir *ir = l->ir;
    const bool along_normal = ir_type(ir, m->by) == TYPE_float;
    const Ref slope = by_v ? m->slopes.v : m->slopes.u, turn = by_v ? m->turns.v : m->turns.u;
    Ref whole = tangent(env, by_v);
    if (turn)
        whole = build_add(
            ir, whole, build_mul(ir, turn, along_normal ? m->by : build_swizzle(ir, m->by, "z")));
    if (along_normal)
        return whole;
    Ref along_u = build_mul(ir, lower_unit(l, tangent(env, false)), build_swizzle(ir, slope, "x"));
    Ref along_v = build_mul(ir, lower_unit(l, tangent(env, true)), build_swizzle(ir, slope, "y"));
    whole = build_add(ir, build_add(ir, whole, along_u), along_v);
    for (int i = 0; i < 2; i++) {
        const Ref swing = by_v ? m->swings[i].v : m->swings[i].u;
        if (swing)
            whole = build_add(ir, whole, build_mul(ir, swing, build_component(ir, m->by, i)));
    }
    return whole;
}

/* Returns the rise of the displaced tangent along n: z_u - x n_u . Tu/|Tu| - y n_u . Tv/|Tv|. A
 * point moved along a tangent sinks where the surface curves down. */
static Ref rise(Lower *l, const Env *env, const Carried *m, bool by_v)
{
    Ir *ir = l->ir;
    const Ref slope = by_v ? m->slopes.v : m->slopes.u, turn = by_v ? m->turns.v : m->turns.u;
    if (ir_type(ir, slope) == TYPE_float)
        return slope;
    Ref up = build_swizzle(ir, slope, "z");
    for (int i = 0; i < 2 && turn; i++) {
        Ref bends = build_dot(ir, turn, lower_unit(l, tangent(env, i)));
        up = build_sub(ir, up, build_mul(ir, build_component(ir, m->by, i), bends));
    }
    return up;
}

/* Returns the displacement of a material and its slopes. */
static Carried moved_of(Lower *l, const Node *displaced, const Env *env)
{
    const Displacement d = graph_displacement(displaced);
    const Type type = d.volume->kind == VALUE_node   ? TYPE_vec4
                      : d.vector->kind == VALUE_node ? TYPE_vec3
                                                     : TYPE_float;
    /* The shape is independent of the viewer; only the displacement is queried in this
     * environment. */
    Env unseen = *env;
    unseen.seen = false;
    unseen.shape = true;
    const Risen risen = bump_of(l, lower_displacement, displaced, &unseen);
    const Ref by_u = build_or_zero(l->ir, risen.slopes.u, type),
              by_v = build_or_zero(l->ir, risen.slopes.v, type);
    return (Carried){.by = risen.value, .slopes = {by_u, by_v}};
}

/* Returns the derivative of the unit normal; 0: constant. */
static Ref uv_transform_chain(Lower *l, Ref normal, Direction direction)
{
    Ref change = slope_mesh_normal(l, normal, direction);
    return change ? lower_unit_slope(l, normal, change) : 0;
}

/* Returns the rotation of a unit tangent about the normal; its tilt belongs to the normal. 0:
 * the tangent does not rotate. */
static Ref swing_of(Lower *l, const Env *env, Ref tangent, Direction direction)
{
    Ir *ir = l->ir;
    const Ref change = slope_mesh_tangent(l, tangent, direction);
    if (!change)
        return 0;
    const Ref turn = lower_unit_slope(l, tangent, change), n = lower_unit(l, env->root[GROUP_N]);
    return build_sub(ir, turn, build_mul(ir, n, build_dot(ir, n, turn)));
}

Env lower_displaced_env(Lower *l, const Node *displaced, const Env *env)
{
    Ir *ir = l->ir;
    Carried m = moved_of(l, displaced, env);
    m.turns.u = uv_transform_chain(l, env->root[GROUP_N], DIRECTION_u);
    m.turns.v = uv_transform_chain(l, env->root[GROUP_N], DIRECTION_v);
    for (int i = 0; i < 2 && ir_type(ir, m.by) != TYPE_float; i++) {
        m.swings[i].u = swing_of(l, env, tangent(env, i), DIRECTION_u);
        m.swings[i].v = swing_of(l, env, tangent(env, i), DIRECTION_v);
    }
    const Ref up_u = rise(l, env, &m, false), up_v = rise(l, env, &m, true), up[2] = {up_u, up_v};
    Frame f = {.tu = slid(l, env, &m, false)};
    Env moved = *env;
    f.tv = slid(l, env, &m, true);
    f.unit = lower_unit(l, env->root[GROUP_N]);
    f.flat = build_cross(ir, tangent(env, false), tangent(env, true));
    moved.number += ENV_DISPLACED;
    moved.root[GROUP_N] = lower_raised_normal(l, &f, up);
    moved.root[GROUP_DU] = build_add(ir, f.tu, build_mul(ir, f.unit, up[0]));
    moved.root[GROUP_DV] = build_add(ir, f.tv, build_mul(ir, f.unit, up[1]));
    moved.eye_n = 0;
    return moved;
}

/* Returns the displacement as a vector: three components, a height being the last; four for a
 * volume. */
static Ref as_vector(Lower *l, Ref value)
{
    Ir *ir = l->ir;
    Ref zero = build_float(ir, 0);
    return ir_type(ir, value) == TYPE_float ? build_vec(ir, TYPE_vec3, zero, zero, value) : value;
}

static void put(Lower *l, int target, Ref value)
{
    ir_output(l->ir, OUT_color, target, build_convert(l->ir, as_vector(l, value), TYPE_vec4));
}

void lower_write_displacement(Lower *l, const Node *displaced, const Env *env)
{
    Ref none = build_float(l->ir, 0);
    Slopes s = {none, none};
    Env shape = *env; /* environment for the shape, as for the slopes */
    shape.shape = true;
    if (displaced)
        s = moved_of(l, displaced, env).slopes;
    put(l, 0, displaced ? lower_displacement(l, displaced, &shape) : none);
    put(l, 1, s.u);
    put(l, 2, s.v);
}

/* A vertex before displacement. Its inputs differ from those of fragments, and displacement
 * shares no computation with shading. */
typedef struct {
    int number; /* number of the environment */
    Input p, n, du, dv, u, x;
} VertexInputs;
static const VertexInputs displaced_inputs = {ENV_VERTEX,     INPUT_vertexP,  INPUT_vertexN,
                                              INPUT_vertexDU, INPUT_vertexDV, INPUT_vertexU,
                                              INPUT_vertexX};
static const VertexInputs corner_inputs = {ENV_CORNER,     INPUT_cornerP,  INPUT_cornerN,
                                           INPUT_cornerDU, INPUT_cornerDV, INPUT_cornerU,
                                           INPUT_cornerX};

static Env vertex_env(Lower *l, const VertexInputs *of)
{
    Ir *ir = l->ir;
    Env env = {.front = build_truth(ir, true), .number = of->number, .shape = true};
    env.root[GROUP_P] = build_input(ir, of->p);
    env.root[GROUP_N] = build_input(ir, of->n);
    env.root[GROUP_DU] = build_input(ir, of->du);
    env.root[GROUP_DV] = build_input(ir, of->dv);
    env.root[GROUP_U] = build_vec(ir, TYPE_vec3, build_input(ir, of->u), build_float(ir, 0));
    env.root[GROUP_X] = build_input(ir, of->x);
    env.root[GROUP_R] = build_all(ir, TYPE_vec4, 0);
    env.root[GROUP_IOR] = build_input(ir, INPUT_IOR);
    return env;
}

/* Outputs the normal that a fragment at this vertex would have. */
static void output_normal(Lower *l, const Node *displaced)
{
    Ir *ir = l->ir;
    const uint32_t origin = ir->origin;
    const Env env = vertex_env(l, &corner_inputs);
    ir->origin = ORIGIN_SLOTS + SLOT_normal;
    ir_output(
        ir, OUT_normal, 0,
        build_call(ir, FN_safeNormalize, lower_displaced_env(l, displaced, &env).root[GROUP_N]));
    ir->origin = origin;
}

/* Pictures are read by texel fetches at full resolution: the height of a point must not depend
 * on the triangle, so that triangles on both sides of an edge agree. A compute program also
 * outputs the normal, by the same slopes as a fragment program. */
void lower_displace_vertices(Lower *l, const Node *displaced)
{
    const Job *whole = l->job;
    Job job = *whole;
    if (!displaced || whole->moved)
        return;
    const Env env = vertex_env(l, &displaced_inputs);
    job.choice[AXIS_aa] = CHOICE_aa_none;
    l->job = &job;
    Ref value = lower_displacement(l, displaced, &env);
    if (!ir_is_number(l->ir, value, 0)) {
        l->ir->displaced = displaced;
        ir_output(l->ir, OUT_displacement, 0, value);
        if (whole->computed && !graph_displaces_volume(displaced))
            output_normal(l, displaced);
    }
    l->job = whole;
}
