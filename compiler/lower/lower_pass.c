/* What a pass computes: the environment it starts from and the outputs it writes. */
#include "compiler/lower/lower.h"
#include "compiler/lower/slope.h"
#include "compiler/base/stack.h"
#include <string.h>

Env lower_surface_env(Lower *l)
{
    static const Input direct[] = {[GROUP_P] = INPUT_P,   [GROUP_N] = INPUT_N, [GROUP_DU] = INPUT_DU,
                                   [GROUP_DV] = INPUT_DV, [GROUP_X] = INPUT_X, [GROUP_IOR] = INPUT_IOR};
    Env env = {.front = ir_input(l->ir, INPUT_front)};
    env.eye_n = ir_input(l->ir, INPUT_eyeN);
    for (int group = 0; group < GROUP_COUNT; group++)
        if (group != GROUP_U && group != GROUP_R)
            env.root[group] = ir_input(l->ir, direct[group]);
    env.root[GROUP_U] = ir_vec(l->ir, TYPE_vec3, REFS(l->ir, ir_input(l->ir, INPUT_U), number(l, 0)), 2);
    env.root[GROUP_R] = ir_const(l->ir, TYPE_vec4, (double[4]){0});
    return env;
}

#define dot(l, a, b)      ir_binary((l)->ir, OP_dot, a, b)
#define quotient(l, a, b) ir_binary((l)->ir, OP_div, a, b)

/* x away from 0, for a divisor: a denominator is guarded, never a result. */
static Ref nonzero(Lower *l, Ref x)
{
    const double least = 1e-30;
    Ref small = ir_binary(l->ir, OP_lt, ir_unary(l->ir, OP_abs, x), number(l, least));
    return ir_select(l->ir, small, number(l, least), x);
}

/* What the surface's u and v do to a value that the pass made for itself. */
static void set_root(Lower *l, Ref value, Ref by_u, Ref by_v)
{
    slope_set(l, value, DIRECTION_u, by_u);
    slope_set(l, value, DIRECTION_v, by_v);
}

/* Where the view ray meets the plane; the pixel is discarded where it does not, and its depth is written. */
static Env plane_env(Lower *l)
{
    Ir *ir = l->ir;
    Env env = lower_surface_env(l);
    Ref u_axis = ir_input(ir, INPUT_planeU), v_axis = ir_input(ir, INPUT_planeV), ray = ir_input(ir, INPUT_ray);
    Ref eye = ir_input(ir, INPUT_eye), origin = ir_input(ir, INPUT_planeOrigin);
    Ref normal = ir_binary(ir, OP_cross, u_axis, v_axis), facing = dot(l, ray, normal);
    Ref along = quotient(l, dot(l, sub(l, origin, eye), normal), nonzero(l, facing));
    Ref p = add(l, eye, mul(l, ray, along)), from = sub(l, p, origin);
    Ref u = quotient(l, dot(l, from, u_axis), nonzero(l, dot(l, u_axis, u_axis)));
    Ref v = quotient(l, dot(l, from, v_axis), nonzero(l, dot(l, v_axis, v_axis)));
    Ref uv = ir_vec(ir, TYPE_vec3, REFS(l->ir, u, v, number(l, 0)), 3);
    Ref point = ir_vec(ir, TYPE_vec4, REFS(l->ir, p, number(l, 1)), 2);
    Ref z = dot(l, ir_input(ir, INPUT_clipZ), point), w = dot(l, ir_input(ir, INPUT_clipW), point);
    Ref depth = quotient(l, z, nonzero(l, w));
    if (!target_table[l->job->target].zero_to_one)
        depth = add(l, mul(l, depth, number(l, 0.5)), number(l, 0.5));
    ir_output(ir, OUT_discard, 0, ir_binary(ir, OP_le, along, number(l, 0)));
    ir_output(ir, OUT_depth, 0, ir_ternary(ir, OP_clamp, depth, number(l, 0), number(l, 1)));
    set_root(l, u, number(l, 1), 0);
    set_root(l, v, 0, number(l, 1));
    Ref right = ir_vec3(ir, 1, 0, 0), up = ir_vec3(ir, 0, 1, 0);
    set_root(l, uv, right, up);
    set_root(l, p, u_axis, v_axis);
    env.root[GROUP_P] = p;
    env.root[GROUP_X] = env.root[GROUP_U] = uv;
    env.root[GROUP_N] = normal;
    env.root[GROUP_DU] = u_axis;
    env.root[GROUP_DV] = v_axis;
    env.front = ir_binary(ir, OP_lt, facing, number(l, 0));
    env.eye_n = 0;
    return env;
}

/* The sky seen along the ray: position and normal are directions, u and v longitude and latitude. */
static Env sky_env(Lower *l)
{
    Ir *ir = l->ir;
    Env env = lower_surface_env(l);
    Ref ray = ir_input(ir, INPUT_ray), direction = ir_call(ir, FN_safeNormalize, &ray, 1);
    Ref x = ir_swizzle(ir, direction, "x"), y = ir_swizzle(ir, direction, "y"), z = ir_swizzle(ir, direction, "z");
    Ref down = ir_ternary(ir, OP_clamp, ir_unary(ir, OP_neg, z), number(l, -1), number(l, 1));
    Ref turn = ir_binary(ir, OP_atan2, y, ir_unary(ir, OP_neg, x));
    Ref u = add(l, mul(l, turn, number(l, 0.5 / M_PI)), number(l, 0.5));
    Ref v = mul(l, ir_unary(ir, OP_acos, down), number(l, 1 / M_PI));
    set_root(l, u, 0, 0);
    set_root(l, v, 0, 0);
    set_root(l, direction, 0, 0);
    env.root[GROUP_P] = env.root[GROUP_X] = direction;
    env.root[GROUP_U] = ir_vec(ir, TYPE_vec3, REFS(l->ir, u, v, number(l, 0)), 3);
    env.root[GROUP_N] = ir_unary(ir, OP_neg, direction);
    env.root[GROUP_DU] = env.root[GROUP_DV] = ir_vec3(ir, 0, 0, 0);
    env.front = ir_const(ir, TYPE_bool, (double[]){1});
    env.eye_n = 0;
    return env;
}

static void write_shadow(Lower *l, const Node *material, const Env *env)
{
    Ref mean = ir_convert(l->ir, lower_slot(l, material, SLOT_transparency, env), TYPE_float);
    ir_output(l->ir, OUT_discard, 0, ir_binary(l->ir, OP_lt, number(l, 0.5), mean));
}

static void write_sky(Lower *l, const Node *material, const Env *env)
{
    Ref light = add(l, lower_slot(l, material, SLOT_diffuse, env), lower_slot(l, material, SLOT_emissive, env));
    const double most = slot_table[SLOT_emissive].high; /* what a half float holds */
    light = ir_ternary(l->ir, OP_clamp, light, number(l, -most), number(l, most));
    ir_output(l->ir, OUT_color, 0, ir_convert(l->ir, light, TYPE_vec4));
}

static void write_slots(Lower *l, const Node *material, const Env *env)
{
    l->ir->slots = lower_needed_slots(l, material, env);
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        ir_output(l->ir, OUT_color, slot, lower_slot(l, material, (Slot)slot, env));
}

static Env pass_env(Lower *l)
{
    return l->job->pass == PASS_plane ? plane_env(l) : l->job->pass == PASS_sky ? sky_env(l) : lower_surface_env(l);
}

static Lower start(Session *session, const Graph *graph, const Job *job, Simplify *simplify, int optimize)
{
    Lower l = {.session = session,
               .graph = graph,
               .ir = ir_new(session, graph),
               .job = job,
               .simplify = simplify,
               .cheap = optimize > 0};
    l.ir->simplify = optimize > 0 ? simplify : NULL;
    l.ir->keep_pow = job->choice[AXIS_powers] == CHOICE_powers_pow;
    l.ir->noise = job_noise(job->choice[AXIS_noise], job->target);
    l.ir->hint = HINT_SURFACE;
    l.uniform_use = ARENA_ARRAY(session->arena, uint8_t, graph->uniform_count);
    return l;
}

/* The same at every level: where nothing is simplified, it is found on an IR of its own. So it is where numbers that come from
 * a buffer hide which slots are absent, and no case has all of those that may be there. */
static int find_case(Lower *l, const Node *material, const Env *env)
{
    const int none = l->job->layout->case_count;
    int number = none == 1 ? 0 : l->cheap ? lower_layout_case(l, material, env) : none;
    if (number < none || l->failed)
        return number % none;
    Job job = *l->job;
    job.from_buffer = false;
    Lower probe = start(l->session, l->graph, &job, l->simplify, 1);
    Env own = pass_env(&probe);
    number = lower_layout_case(&probe, material, &own);
    if (number == none)
        lower_no_case(&probe, material, &own);
    l->failed |= probe.failed;
    return number % none;
}

/* A constant transparency, which needs no compiling of its own to be known. */
static void note_opacity(Lower *l, const Node *material, const Env *env)
{
    Ref t = lower_slot(l, material, SLOT_transparency, env);
    if (!ir_is(l->ir, t, OP_const))
        return;
    const double *lane = ir_numbers(l->ir, t);
    l->ir->opacity = lane[0] <= 0 && lane[1] <= 0 && lane[2] <= 0 ? OPACITY_opaque : OPACITY_transparent;
}

static void write_pass(Lower *l, const Node *material)
{
    const Job *job = l->job;
    Env env = pass_env(l);
    switch (job->pass) {
    case PASS_gbuffer:
    case PASS_plane:
        lower_layout(l, find_case(l, material, &env), material, &env);
        if (l->cheap && !job->from_buffer)
            note_opacity(l, material, &env);
        break;
    case PASS_sky:
        write_sky(l, material, &env);
        break;
    case PASS_shadow:
        write_shadow(l, material, &env);
        break;
    case PASS_value:
        if (job->all_slots)
            write_slots(l, material, &env);
        else
            ir_output(l->ir, OUT_color, 0, ir_convert(l->ir, lower_slot(l, material, job->slot, &env), TYPE_vec4));
        break;
    case PASS_depth:
    case PASS_COUNT:
        break;
    }
}

typedef struct {
    Lower *l;
    const Node *material;
} Writing;

static void write_on_stack(void *user)
{
    const Writing *writing = user;
    write_pass(writing->l, writing->material);
}

Ir *lower(Session *session, const Graph *graph, const Node *material, const Job *job, Simplify *simplify)
{
    Lower l = start(session, graph, job, simplify, session->optimize);
    stack_run(material ? material->depth : 0, write_on_stack, &(Writing){&l, material});
    return l.failed ? NULL : l.ir;
}
