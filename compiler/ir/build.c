/* Builders for values that take more than one operation. */
#include "compiler/ir/build.h"
#include <string.h>

Ref build_unary(Ir *ir, Op op, Ref a) { return ir_make(ir, (IrNode){.op = op, .count = 1}, &a); }

Ref build_float(Ir *ir, double value) { return ir_const(ir, TYPE_float, &value); }
Ref build_int(Ir *ir, double value) { return ir_const(ir, TYPE_int, &value); }
Ref build_vec3(Ir *ir, double x, double y, double z)
{
    return ir_const(ir, TYPE_vec3, (double[]){x, y, z});
}
Ref build_truth(Ir *ir, bool value) { return ir_const(ir, TYPE_bool, (double[]){value}); }
Ref build_all(Ir *ir, Type type, double value)
{
    return ir_const(ir, type, (double[]){value, value, value, value});
}
Ref build_leaf(Ir *ir, Op op, Type type, int index)
{
    return ir_make(ir, (IrNode){.op = op, .type = type, .payload = (uint32_t)index}, NULL);
}

Ref build_attribute(Ir *ir, int attribute, AttributePart part)
{
    return build_leaf(ir, OP_attribute, ir->graph->attributes[attribute]->type,
                      attribute * ATTRIBUTE_PARTS + (int)part);
}

Ref build_input(Ir *ir, Input input)
{
    return build_leaf(ir, OP_input, input_table[input].type, input);
}

Ref build_scale(Ir *ir, Ref a, double factor) { return build_mul(ir, a, build_float(ir, factor)); }
Ref build_square(Ir *ir, Ref a) { return build_mul(ir, a, a); }
Ref build_select_of(Ir *ir, const Ref x[3])
{
    return ir_make(ir, (IrNode){.op = OP_select, .type = ir_type(ir, x[1]), .count = 3}, x);
}

/* A guard is a select with the payload 1 whose other arm is 0. */
Ref build_guard_of(Ir *ir, const Ref x[2])
{
    const Type type = ir_type(ir, x[1]);
    const Ref args[] = {x[0], x[1], build_all(ir, type, 0)};
    return ir_make(ir, (IrNode){.op = OP_select, .type = type, .count = 3, .payload = 1}, args);
}

Ref build_linear(Ir *ir, const Ref *args, int count)
{
    return ir_make(ir, (IrNode){.op = OP_linear, .type = ir_type(ir, args[0]), .count = count},
                   args);
}

Type build_components_type(int components)
{
    static const Type types[] = {TYPE_float, TYPE_float, TYPE_vec2, TYPE_vec3, TYPE_vec4};
    return types[components];
}

Ref build_components(Ir *ir, Ref a, uint32_t components, int count)
{
    if (ir_components(ir, a) == 1)
        return count == 1 ? a : build_convert(ir, a, build_components_type(count));
    return ir_make(ir,
                   (IrNode){.op = OP_swizzle,
                            .type = build_components_type(count),
                            .count = 1,
                            .payload = components},
                   &a);
}

Ref build_component(Ir *ir, Ref a, int component)
{
    return build_components(ir, a, (uint32_t)component, 1);
}

/* Encodes a swizzle with two bits per component, the first lowest: "zx" of a vec3 has the
 * payload 2 | 0 << 2. */
Ref build_swizzle(Ir *ir, Ref a, const char *letters)
{
    uint32_t components = 0;
    int count = (int)strlen(letters);
    for (int i = 0; i < count; i++)
        components |= (letters[i] == 'w' ? 3u : (uint32_t)(letters[i] - 'x')) << 2 * i;
    return build_components(ir, a, components, count);
}

Ref build_vec_of(Ir *ir, Type type, const Ref *parts, int count)
{
    return ir_make(ir, (IrNode){.op = OP_vec, .type = type, .count = count}, parts);
}

Ref build_splat(Ir *ir, Ref a, Type type)
{
    return ir_type(ir, a) == type
               ? a
               : build_vec_of(ir, type, (Ref[]){a, a, a, a}, type_table[type].components);
}

/* Narrowing to a float takes the mean, to a vector the first components. Widening fills with 0,
 * and alpha with 1; a float is copied to every component except alpha. The vec2 (8, 4) becomes 6
 * as a float and (8, 4, 0, 1) as a vec4. The float 8 becomes (8, 8, 8, 1). */
Ref build_convert(Ir *ir, Ref a, Type type)
{
    Type from = ir_type(ir, a);
    int components = type_table[type].components;
    if (from == type)
        return a;
    Ref zero = 0, one = 0;
    if (components > type_table[from].components) {
        zero = build_float(ir, 0);
        one = build_float(ir, 1);
    }
    if (type == TYPE_float)
        return build_dot(ir, a, build_all(ir, from, 1.0 / type_table[from].components));
    if (components < type_table[from].components)
        return build_swizzle(ir, a, components == 2 ? "xy" : "xyz");
    switch (from) {
    case TYPE_vec2:
        return type == TYPE_vec3 ? build_vec(ir, type, a, zero) : build_vec(ir, type, a, zero, one);
    case TYPE_vec3:
        return build_vec(ir, type, a, one);
    default:
        return type == TYPE_vec4 ? build_vec(ir, type, a, a, a, one) : build_splat(ir, a, type);
    }
}

Ref build_call_of(Ir *ir, int function, const Ref *args, int count)
{
    return ir_make(ir,
                   (IrNode){.op = OP_call,
                            .type = function_row(function)->result,
                            .count = count,
                            .payload = (uint32_t)function},
                   args);
}

Ref build_apply(Ir *ir, int function, const Ref *args)
{
    const IrFunction *f = &ir->functions[function];
    return ir_make(ir,
                   (IrNode){.op = OP_apply,
                            .type = ir_type(ir, f->result),
                            .count = f->count,
                            .payload = (uint32_t)function},
                   args);
}

Ref build_kernel(Ir *ir, int function, const Ref *args, Ref size)
{
    const IrFunction *f = &ir->functions[function];
    Ref all[8];
    for (int i = 0; i < f->count; i++)
        all[i] = args[i];
    all[f->count] = size;
    return ir_make(ir,
                   (IrNode){.op = OP_kernel,
                            .type = ir_type(ir, f->result),
                            .count = f->count + 1,
                            .payload = (uint32_t)function},
                   all);
}

Ref build_plus_of(Ir *ir, const Ref x[2])
{
    return !x[0] ? x[1] : !x[1] ? x[0] : build_add_of(ir, x);
}
Ref build_times_of(Ir *ir, const Ref x[2]) { return x[1] ? build_mul_of(ir, x) : 0; }
Ref build_over_of(Ir *ir, const Ref x[2]) { return x[0] ? build_div_of(ir, x) : 0; }
Ref build_minus(Ir *ir, Ref a) { return a ? build_neg(ir, a) : 0; }
Ref build_or_zero(Ir *ir, Ref a, Type type) { return a ? a : build_all(ir, type, 0); }
