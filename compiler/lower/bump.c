/* Slopes of a displacement: `finite` are GroIMP's channels; `analytic` is the derivative of all
 * that is computed; `auto` combines both by one rule:
 *
 *     the derivative of what the displacement computes, by the chain rule, where a map with a
 *     STEP row (maps.def: it jumps, or is an image) has GroIMP's finite difference as its
 *     derivative by its own coordinate.
 *
 * Tiles of wood: a Blend along a Checker c (1 and 0, its u' = 8 u), with 0 at item 0 and w(x) at
 * item 1. At a point of a black square, .02 of u' before the edge to a white one:
 *     the Checker is one of two values, so the Blend is evaluated for both: H = c ? w : 0, and
 *     dH = (c ? dw : 0) + (w - 0) dc
 *     dc by u' is (c(u' + .05) - c(u')) / .05 = (1 - 0) / .05 = 20, and by u 8 times that: the
 *     edge has the slope 160 w
 * Within the squares the slope is 0 or dw, exactly; the edges are bevels of a tenth of a square.
 *
 * A displacement above such a map is lowered separately and without the local rules: its nodes
 * are not merged with others, whatever the optimizer joins later, and the plain forms have a
 * unique slope where two pieces meet. So all levels of -O have the same slopes. */
#include "compiler/lower/bump.h"
#include "compiler/lower/slope.h"

/* Converts a bool to 0 or 1. */
static Ref number(Lower *l, Ref value)
{
    Ir *ir = l->ir;
    if (ir_type(ir, value) != TYPE_bool)
        return value;
    return build_select(ir, value, build_float(ir, 1), build_float(ir, 0));
}

/* Returns the forward difference (f(q + h e) - f(q)) / h, e along one component. f has period 1,
 * so integers are dropped first: far from the origin the step would be lost to rounding. */
static Ref difference(Lower *l, Ref value, const Stepped *map, int component)
{
    Ir *ir = l->ir;
    const Type type = ir_type(ir, map->q.value);
    double step[4] = {0};
    step[component] = map->step[component];
    MapValue beyond = map->q;
    beyond.value = build_add(ir, build_fract(ir, map->q.value), ir_const(ir, type, step));
    Ref there = number(l, map->at(l, map->map, beyond));
    return build_scale(ir, build_sub(ir, there, number(l, value)), 1 / map->step[component]);
}

void bump_rise(Lower *l, Ref value, Ref q, const Ref rate[3])
{
    Ir *ir = l->ir;
    static const char *const component_name[] = {"x", "y", "z"};
    static const Direction directions[] = {DIRECTION_u, DIRECTION_v};
    for (int d = 0; d < 2 && !ir_is(ir, value, OP_const); d++) {
        Ref change = slope_of(l, q, directions[d]), slope = 0;
        for (int i = 0; change && i < ir_components(ir, q); i++)
            if (rate[i])
                slope = build_plus(
                    ir, slope,
                    build_mul(ir, rate[i], build_swizzle(ir, change, component_name[i])));
        slope_set(l, value, directions[d], slope);
    }
}

void bump_step(Lower *l, Ref value, const Stepped *map)
{
    Ref rate[3] = {0};
    if (!l->relief || ir_is(l->ir, value, OP_const))
        return;
    for (int i = 0; i < 3; i++)
        if (map->step[i] != 0)
            rate[i] = difference(l, value, map, i);
    bump_rise(l, value, map->q.value, rate);
}

/* Returns a map's red component. */
static Ref red(Lower *l, const Node *map, const Env *env)
{
    return build_swizzle(l->ir, lower_query(l, map, GROUP_R, env), "x");
}

static Risen computed(Lower *l, BumpValue *make, const Node *what, const Env *env)
{
    Ref value = make(l, what, env);
    Ref by_u = slope_of(l, value, DIRECTION_u), by_v = slope_of(l, value, DIRECTION_v);
    return (Risen){value, {by_u, by_v}};
}

static Manner manner(Lower *l, bool relief, Manner now)
{
    const Manner before = {l->cheap, l->ir->simplify};
    l->relief = relief;
    l->cheap = now.cheap;
    l->ir->simplify = now.simplify;
    return before;
}

MapValue bump_smooth(Lower *l, const Node *map, Group group, const Env *env)
{
    Env outside = *env;
    outside.relief = false;
    const Manner inside = manner(l, false, l->outside);
    MapValue answer = lower_map_value(l, map, group, &outside);
    manner(l, true, inside);
    return answer;
}

static Risen stepped(Lower *l, BumpValue *make, const Node *what, const Env *env)
{
    Env inside = *env;
    inside.relief = true;
    l->outside = manner(l, true, (Manner){false, NULL});
    const Risen risen = computed(l, make, what, &inside);
    manner(l, false, l->outside);
    return risen;
}

/* Returns the map's value for a derivative channel; 0: the constant 0. */
static Ref channel(Lower *l, const Node *displacement, Group group, const Env *env)
{
    Ref answer = lower_query(l, displacement, group, env);
    const double *known = ir_is(l->ir, answer, OP_const) ? ir_numbers(l->ir, answer) : NULL;
    return known && known[0] == 0 ? 0 : build_swizzle(l->ir, answer, "x");
}

static Slopes channels(Lower *l, const Node *displacement, const Env *env)
{
    Ref by_u = channel(l, displacement, GROUP_DU, env),
        by_v = channel(l, displacement, GROUP_DV, env);
    return (Slopes){by_u, by_v};
}

Risen bump_of(Lower *l, BumpValue *make, const Node *what, const Env *env)
{
    return l->job->choice[AXIS_derivatives] == CHOICE_derivatives_analytic
               ? computed(l, make, what, env)
               : stepped(l, make, what, env);
}

Slopes bump_slopes(Lower *l, const Node *bump, const Env *env)
{
    Ir *ir = l->ir;
    const Node *displacement = lower_param_node(bump, P_BumpMap_displacement);
    const Choice how = (Choice)l->job->choice[AXIS_derivatives];
    Slopes slopes = how == CHOICE_derivatives_finite ? channels(l, displacement, env)
                    : how == CHOICE_derivatives_analytic
                        ? computed(l, red, displacement, env).slopes
                        : stepped(l, red, displacement, env).slopes;
    lower_note_bump(l, displacement, slopes.u, slopes.v);
    slopes.u = build_or_zero(ir, slopes.u, TYPE_float);
    slopes.v = build_or_zero(ir, slopes.v, TYPE_float);
    return slopes;
}
