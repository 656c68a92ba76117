/* Filters Smooth3D and Laplace3D: the input becomes one function of the root position and
 * texture coordinate, which is called at each point of a 3x3x3 kernel. Nested filters are
 * functions that call functions: the program grows by one function for each. All filters of one
 * depth share their arguments, so that equal inputs are equal nodes and one function. */
#include "compiler/lower/lower.h"
#include "compiler/lower/footprint.h"

/* Scalar operations of an input from which on its 27 evaluations become a loop. */
enum { LOOP_COST = 100 };

/* Returns an environment whose position and texture coordinate are the function's arguments. */
static Env shifted_env(Lower *l, const Env *outer, const Ref *arguments)
{
    Ir *ir = l->ir;
    Env env = *outer;
    env.number = outer->number + 1;
    env.root[GROUP_X] = arguments[0];
    env.root[GROUP_U] = build_vec(ir, TYPE_vec3, arguments[1], build_float(ir, 0));
    return env;
}

/* Drops the alpha, which is always 1 in a filter: colors keep three components at most. */
static Ref without_alpha(Lower *l, Ref value)
{
    Ir *ir = l->ir;
    return ir_type(ir, value) == TYPE_vec4 ? build_convert(ir, value, TYPE_vec3) : value;
}

static int make_function(Lower *l, const Node *input, Group group, const Env *env)
{
    Ir *ir = l->ir;
    Ref arguments[2];
    ir_arguments(ir, env->number, (Type[]){TYPE_vec3, TYPE_vec2}, 2, arguments);
    Ref root[] = {env->root[GROUP_X], build_swizzle(ir, env->root[GROUP_U], "xy")};
    for (int i = 0; i < 2; i++)
        /* the derivatives of a shifted point equal those of the point */
        for (int d = 0; d < DIRECTION_COUNT; d++)
            slope_set(l, arguments[i], (Direction)d, slope_of(l, root[i], (Direction)d));
    Env inner = shifted_env(l, env, arguments);
    l->filters++;
    Ref result = without_alpha(l, lower_query(l, input, group, &inner));
    l->filters--;
    return ir_function(ir, arguments, 2, result);
}

/* Returns the input at a point of the kernel, whose coordinates are -1, 0 or 1. */
static Ref at_neighbour(Lower *l, int function, const Env *env, Ref size, const int at[3])
{
    Ir *ir = l->ir;
    Ref offset = build_mul(ir, size, build_vec3(ir, 0.5 * at[0], 0.5 * at[1], 0.5 * at[2]));
    Ref uv =
        build_add(ir, build_swizzle(ir, env->root[GROUP_U], "xy"), build_swizzle(ir, offset, "xy"));
    return build_apply(ir, function, REFS(ir, build_add(ir, env->root[GROUP_X], offset), uv));
}

/* Returns the three sizes, the first parameters after `input`. */
static Ref filter_size(Lower *l, const Node *node)
{
    Ref size[3];
    for (int i = 0; i < 3; i++)
        size[i] = lower_param(l, &node->params[1 + i], TYPE_float);
    return build_vec_of(l->ir, TYPE_vec3, size, 3);
}

/* Treats the value as constant in differentiation, so that its evaluations are not all
 * differentiated. */
static MapValue steady(Lower *l, Ref value)
{
    slope_set(l, value, DIRECTION_right, 0);
    slope_set(l, value, DIRECTION_up, 0);
    return map_value_of(value);
}

/* Lowers a Smooth3D. A cheap input is written out as 27 calls. Drivers inline every call, so a
 * costly input would take minutes to compile: it is summed in a loop. */
MapValue lower_Smooth3D(Lower *l, const Node *node, Group group, const Env *env)
{
    Ir *ir = l->ir;
    int function = make_function(l, lower_param_node(node, P_Smooth3D_input), group, env);
    Ref size = filter_size(l, node), sum = 0;
    bool costly = lower_cost_below(ir, ir->functions[function].result, LOOP_COST) >= LOOP_COST;
    if (costly)
        sum = build_kernel(
            ir, function, REFS(ir, env->root[GROUP_X], build_swizzle(ir, env->root[GROUP_U], "xy")),
            size);
    for (int n = 0; !costly && n < KERNEL_POINTS; n++) {
        Ref value =
            at_neighbour(l, function, env, size, (int[3]){n / 9 - 1, n / 3 % 3 - 1, n % 3 - 1});
        sum = n ? build_add(ir, sum, value) : value;
    }
    return steady(l, build_scale(ir, sum, 1.0 / KERNEL_POINTS));
}

/* Lowers a Laplace3D: 1/2 of the center minus 1/12 of each neighbor, as a sum of differences,
 * which is exactly 0 where the input is constant. */
MapValue lower_Laplace3D(Lower *l, const Node *node, Group group, const Env *env)
{
    Ir *ir = l->ir;
    int function = make_function(l, lower_param_node(node, P_Laplace3D_input), group, env);
    Ref size = filter_size(l, node), centre = at_neighbour(l, function, env, size, (int[3]){0}),
        sum = 0;
    for (int n = 0; n < 6; n++) {
        int at[3] = {0};
        at[n / 2] = n % 2 * 2 - 1;
        Ref neighbour = at_neighbour(l, function, env, size, at);
        Ref difference = build_sub(ir, centre, neighbour);
        sum = n ? build_add(ir, sum, difference) : difference;
    }
    return steady(l, build_scale(ir, sum, 1.0 / 12));
}
