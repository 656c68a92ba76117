/* Lowering of a pass: the environment that it starts from, and the outputs that it writes. */
#include "compiler/layout/layout.h"
#include "compiler/lower/lower.h"
#include "compiler/lower/slope.h"
#include "compiler/base/stack.h"
#include "grammar/lobe_table.h"
#include <string.h>

/* Returns true for passes with one viewer. A shadow pass may serve several lights, and the sky
 * looks the same from every position. */
static bool sees(Pass pass)
{
    return pass == PASS_gbuffer || pass == PASS_plane || pass == PASS_value;
}

Env lower_surface_env(Lower *l)
{
    Ir *ir = l->ir;
    static const Input direct[] = {
        [GROUP_P] = INPUT_P,   [GROUP_N] = INPUT_N, [GROUP_DU] = INPUT_DU,
        [GROUP_DV] = INPUT_DV, [GROUP_X] = INPUT_X, [GROUP_IOR] = INPUT_IOR};
    Env env = {.front = build_input(ir, INPUT_front), .seen = sees(l->job->pass)};
    env.eye_n = build_input(ir, INPUT_eyeN);
    for (int group = 0; group <= GROUP_IOR; group++)
        if (group != GROUP_U && group != GROUP_R)
            env.root[group] = build_input(ir, direct[group]);
    env.root[GROUP_U] = build_vec(ir, TYPE_vec3, build_input(ir, INPUT_U), build_float(ir, 0));
    env.root[GROUP_R] = build_all(ir, TYPE_vec4, 0);
    return env;
}

/* Replaces a divisor near 0 by a small positive number: the divisor is guarded, never the
 * quotient. */
static Ref nonzero(Lower *l, Ref x)
{
    Ir *ir = l->ir;
    const double least = 1e-30;
    Ref small = build_lt(ir, build_abs(ir, x), build_float(ir, least));
    return build_select(ir, small, build_float(ir, least), x);
}

/* Sets the derivatives by the surface's u and v of a value that the pass itself made. */
static void set_root(Lower *l, Ref value, Ref by_u, Ref by_v)
{
    slope_set(l, value, DIRECTION_u, by_u);
    slope_set(l, value, DIRECTION_v, by_v);
}

/* Returns the environment at the intersection of the view ray with the plane. Discards the pixel
 * if they do not intersect, and writes the depth. */
static Env plane_env(Lower *l)
{
    Ir *ir = l->ir;
    Env env = lower_surface_env(l);
    Ref u_axis = build_input(ir, INPUT_planeU), v_axis = build_input(ir, INPUT_planeV),
        ray = build_input(ir, INPUT_ray);
    Ref eye = build_input(ir, INPUT_eye), origin = build_input(ir, INPUT_planeOrigin);
    Ref normal = build_cross(ir, u_axis, v_axis), facing = build_dot(ir, ray, normal);
    Ref along =
        build_div(ir, build_dot(ir, build_sub(ir, origin, eye), normal), nonzero(l, facing));
    Ref p = build_add(ir, eye, build_mul(ir, ray, along)), from = build_sub(ir, p, origin);
    Ref u = build_div(ir, build_dot(ir, from, u_axis), nonzero(l, build_dot(ir, u_axis, u_axis)));
    Ref v = build_div(ir, build_dot(ir, from, v_axis), nonzero(l, build_dot(ir, v_axis, v_axis)));
    Ref uv = build_vec(ir, TYPE_vec3, u, v, build_float(ir, 0));
    Ref point = build_vec(ir, TYPE_vec4, p, build_float(ir, 1));
    Ref z = build_dot(ir, build_input(ir, INPUT_depthZ), point),
        w = build_dot(ir, build_input(ir, INPUT_clipW), point);
    Ref depth = build_div(ir, z, nonzero(l, w));
    ir_output(ir, OUT_discard, 0, build_le(ir, along, build_float(ir, 0)));
    ir_output(ir, OUT_depth, 0, build_clamp(ir, depth, build_float(ir, 0), build_float(ir, 1)));
    set_root(l, u, build_float(ir, 1), 0);
    set_root(l, v, 0, build_float(ir, 1));
    Ref right = build_vec3(ir, 1, 0, 0), up = build_vec3(ir, 0, 1, 0);
    set_root(l, uv, right, up);
    set_root(l, p, u_axis, v_axis);
    env.root[GROUP_P] = p;
    env.root[GROUP_X] = env.root[GROUP_U] = uv;
    env.root[GROUP_N] = normal;
    env.root[GROUP_DU] = u_axis;
    env.root[GROUP_DV] = v_axis;
    env.front = build_lt(ir, facing, build_float(ir, 0));
    env.eye_n = 0;
    return env;
}

/* Returns the environment of the sky along the view ray: position and normal are directions, u
 * and v are longitude and latitude. */
static Env sky_env(Lower *l)
{
    Ir *ir = l->ir;
    Env env = lower_surface_env(l);
    Ref ray = build_input(ir, INPUT_ray), direction = build_call(ir, FN_safeNormalize, ray);
    Ref x = build_swizzle(ir, direction, "x"), y = build_swizzle(ir, direction, "y"),
        z = build_swizzle(ir, direction, "z");
    Ref down = build_clamp(ir, build_neg(ir, z), build_float(ir, -1), build_float(ir, 1));
    Ref turn = build_atan2(ir, y, build_neg(ir, x));
    Ref u = build_add(ir, build_scale(ir, turn, 0.5 / M_PI), build_float(ir, 0.5));
    Ref v = build_scale(ir, build_acos(ir, down), 1 / M_PI);
    set_root(l, u, 0, 0);
    set_root(l, v, 0, 0);
    set_root(l, direction, 0, 0);
    env.root[GROUP_P] = env.root[GROUP_X] = direction;
    env.root[GROUP_U] = build_vec(ir, TYPE_vec3, u, v, build_float(ir, 0));
    env.root[GROUP_N] = build_neg(ir, direction);
    env.root[GROUP_DU] = env.root[GROUP_DV] = build_vec3(ir, 0, 0, 0);
    env.front = build_truth(ir, true);
    env.eye_n = 0;
    return env;
}

static void write_shadow(Lower *l, const Node *material, const Env *env)
{
    Ir *ir = l->ir;
    Ref mean = build_convert(ir, lower_slot(l, material, SLOT_transparency, env), TYPE_float);
    ir_output(ir, OUT_discard, 0, build_lt(ir, build_float(ir, 0.5), mean));
}

static void write_sky(Lower *l, const Node *material, const Env *env)
{
    Ir *ir = l->ir;
    Ref light = build_add(ir, lower_slot(l, material, SLOT_diffuse, env),
                          lower_slot(l, material, SLOT_emissive, env));
    const double most = slot_table[SLOT_emissive].high; /* greatest half float */
    light = build_clamp(ir, light, build_float(ir, -most), build_float(ir, most));
    ir_output(ir, OUT_color, 0, build_convert(ir, light, TYPE_vec4));
}

static void write_slots(Lower *l, const Node *material, const Env *env)
{
    l->ir->slots = lower_needed_slots(l, material, env);
    /* outputs the slots in the form that the G-buffer stores */
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        ir_output(l->ir, OUT_color, slot,
                  slot == SLOT_anisotropy ? lower_stored_anisotropy(l, material, env)
                                          : lower_slot(l, material, (Slot)slot, env));
}

Env lower_pass_env(Lower *l)
{
    return l->job->pass == PASS_plane ? plane_env(l)
           : l->job->pass == PASS_sky ? sky_env(l)
                                      : lower_surface_env(l);
}

Lower lower_start(const LowerRequest *what, int optimize)
{
    const Job *job = what->job;
    Lower l = {.session = what->session,
               .graph = what->graph,
               .ir = ir_new(what->session, what->graph),
               .job = job,
               .simplify = what->simplify,
               .cheap = optimize > 0,
               .layout_slots = job->layout ? layout_slots(job->layout) : 0};
    l.ir->simplify = optimize > 0 ? what->simplify : NULL;
    l.ir->keep_pow = job->choice[AXIS_powers] == CHOICE_powers_pow;
    l.ir->noise = job_noise(job->choice[AXIS_noise], job->target);
    l.ir->origin = ORIGIN_SURFACE;
    l.uniform_use = ARENA_ARRAY(what->session->arena, uint8_t, what->graph->uniform_count);
    return l;
}

/* Warns if the layout loses the coat's own normal. Uses a separate IR, so that the program is
 * the same in all layouts. */
static void warn_left_out(Lower *l, const Node *material)
{
    const LayoutRow *row = l->job->layout;
    if (!l->cheap || row->case_count < 2 || !material || l->layout_slots >> SLOT_coatNormal & 1 ||
        !(l->graph->models[material->index] & MODEL_LOBE(LOBE_coat)))
        return;
    Lower probe =
        lower_start(&(LowerRequest){l->session, l->graph, material, l->job, l->simplify}, 1);
    const Env own = lower_pass_env(&probe);
    lower_left_out(&probe, material, &own);
    l->failed |= probe.failed;
}

/* Returns the layout's case. The case is the same at every level of -O: without simplification
 * it is found on a separate IR. A separate IR is also needed where constants in a buffer hide
 * which slots are absent, and no case holds all slots that may be present. */
static int find_case(Lower *l, const Node *material, const Env *env)
{
    const int none = l->job->layout->case_count;
    warn_left_out(l, material);
    int number = none == 1 ? 0 : l->cheap ? lower_layout_case(l, material, env) : none;
    if (number < none || l->failed)
        return number % none;
    Job job = *l->job;
    job.from_buffer = false;
    Lower probe =
        lower_start(&(LowerRequest){l->session, l->graph, material, &job, l->simplify}, 1);
    Env own = lower_pass_env(&probe);
    number = lower_layout_case(&probe, material, &own);
    if (number == none)
        number = lower_nearest_case(&probe, material, &own);
    if (number == none)
        lower_no_case(&probe, material, &own);
    l->failed |= probe.failed;
    return number % none;
}

/* Records whether a constant transparency is 0, which is then known without a separate
 * compilation. */
static void note_opacity(Lower *l, const Node *material, const Env *env)
{
    Ref t = lower_slot(l, material, SLOT_transparency, env);
    if (!ir_is(l->ir, t, OP_const))
        return;
    const double *component = ir_numbers(l->ir, t);
    l->ir->opacity = component[0] <= 0 && component[1] <= 0 && component[2] <= 0
                         ? OPACITY_opaque
                         : OPACITY_transparent;
}

static void write_pass(Lower *l, const Node *material)
{
    Ir *ir = l->ir;
    const Job *job = l->job;
    Env env = lower_pass_env(l);
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
            ir_output(ir, OUT_color, 0,
                      build_convert(ir, lower_slot(l, material, job->slot, &env), TYPE_vec4));
        break;
    case PASS_displacement:
        lower_write_displacement(l, lower_displaced(material), &env);
        break;
    case PASS_depth:
    case PASS_COUNT:
        break;
    }
    if (job->pass == PASS_gbuffer || job->pass == PASS_shadow || job->pass == PASS_depth ||
        (job->pass == PASS_value && !job->all_slots))
        lower_displace_vertices(l, lower_displaced(material));
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

static bool write(Lower *l, const Node *material)
{
    stack_run(material ? material->depth : 0, write_on_stack, &(Writing){l, material});
    return !l->failed;
}

Ir *lower_averaging(Lower *l, const LowerRequest *what, int below)
{
    *l = lower_start(what, what->session->optimize);
    l->averaged_below = below;
    if (!write(l, what->material))
        return NULL;
    lower_lint(l);
    slope_done(l);
    return l->ir;
}

int lower_cost_of_points(const Lower *l, const Node *material)
{
    Arena arena = {0};
    Session session = *l->session;
    Lower points = *l;
    int nodes, cost = -1;
    session.arena = &arena;
    session.diags = (DiagList){0};
    points.session = &session;
    points.ir = ir_fork(l->ir, &session);
    points.averaged_below = 0;
    points.slots = NULL;
    if (write(&points, material)) {
        slope_done(&points);
        ir_measure(points.ir, &nodes, &cost);
    }
    ir_done(points.ir);
    arena_free(&arena);
    return cost;
}
