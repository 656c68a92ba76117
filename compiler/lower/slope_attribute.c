/* Derivatives by the surface's u and v of mesh attributes, the mesh's normal and its tangents.
 * Over a triangle an attribute a is linear, and so are u and v. With the changes of a, u and v
 * to the next pixels, a_x = a_u u_x + a_v v_x and a_y = a_u u_y + a_v v_y. By Cramer's rule a_u
 * = (a_x v_y - a_y v_x) / d and a_v = (a_y u_x - a_x u_y) / d with d = u_x v_y - u_y v_x; 0
 * where d is 0.
 *
 *     a = 3 u, u changes by .1 to the right, v by .1 upward: a_x = .3, a_y = 0, d = .01, a_u =
 *     .3 * .1 / .01 = 3 */
#include "compiler/lower/slope.h"
#include "compiler/ir/build.h"

static Ref by_surface(Ir *ir, Ref ax, Ref ay, bool by_v)
{
    const double least = 1e-30;
    Ref x = build_input(ir, INPUT_UX), ux = build_swizzle(ir, x, "x"),
        vx = build_swizzle(ir, x, "y");
    Ref y = build_input(ir, INPUT_UY), uy = build_swizzle(ir, y, "x"),
        vy = build_swizzle(ir, y, "y");
    Ref p = build_mul(ir, ux, vy), q = build_mul(ir, uy, vx), d = build_sub(ir, p, q),
        size = build_abs(ir, d);
    Ref none = build_lt(ir, size, build_float(ir, least)), one = build_float(ir, 1);
    Ref over = build_div(ir, one, build_select(ir, none, one, d));
    over = build_select(ir, none, build_float(ir, 0), over);
    p = build_mul(ir, by_v ? ay : ax, by_v ? ux : vy);
    q = build_mul(ir, by_v ? ax : ay, by_v ? uy : vx);
    return build_mul(ir, build_sub(ir, p, q), over);
}

Ref slope_attribute(Lower *l, Ref ref, Direction direction)
{
    const uint32_t payload = ir_at(l->ir, ref)->payload;
    const int attribute = (int)attribute_of(payload);
    if (attribute_part(payload) != ATTRIBUTE_value)
        return 0;
    Ref ax = build_attribute(l->ir, attribute, ATTRIBUTE_by_x),
        ay = build_attribute(l->ir, attribute, ATTRIBUTE_by_y);
    if (direction == DIRECTION_right || direction == DIRECTION_up)
        return direction == DIRECTION_right ? ax : ay;
    return by_surface(l->ir, ax, ay, direction == DIRECTION_v);
}

/* Returns the input that a value is; INPUT_COUNT: the value is no input. */
static Input input_of(const Ir *ir, Ref value)
{
    return ir_is(ir, value, OP_input) ? (Input)ir_at(ir, value)->payload : INPUT_COUNT;
}

static Ref slope_varying(Ir *ir, const Input changes[2], Direction direction)
{
    Ref by_x = build_input(ir, changes[0]), by_y = build_input(ir, changes[1]);
    return by_surface(ir, by_x, by_y, direction == DIRECTION_v);
}

Ref slope_mesh_normal(Lower *l, Ref normal, Direction direction)
{
    const Input input = input_of(l->ir, normal);
    if (input == INPUT_cornerN)
        return build_input(l->ir, direction == DIRECTION_v ? INPUT_cornerNV : INPUT_cornerNU);
    return input == INPUT_N ? slope_varying(l->ir, (Input[]){INPUT_NX, INPUT_NY}, direction) : 0;
}

Ref slope_mesh_tangent(Lower *l, Ref tangent, Direction direction)
{
    const Input input = input_of(l->ir, tangent);
    const bool by_v = direction == DIRECTION_v;
    switch (input) {
    case INPUT_cornerDU:
        return build_input(l->ir, by_v ? INPUT_cornerDUV : INPUT_cornerDUU);
    case INPUT_cornerDV:
        return build_input(l->ir, by_v ? INPUT_cornerDVV : INPUT_cornerDUV);
    case INPUT_DU:
        return slope_varying(l->ir, (Input[]){INPUT_DUX, INPUT_DUY}, direction);
    case INPUT_DV:
        return slope_varying(l->ir, (Input[]){INPUT_DVX, INPUT_DVY}, direction);
    default:
        return 0;
    }
}
