/* Builders of IR nodes: build_add(ir, a, b) returns the node a + b, an existing equal node, or
 * the node to which a + b simplifies.
 *
 * Nodes are numbered in order of creation, but C leaves the evaluation order of arguments open.
 * Builders with several operands are therefore macros over REFS, which creates the operands from
 * left to right under any C compiler:
 *
 *     build_mix(ir, build_float(ir, 0), build_abs(ir, x), t)
 *         creates 0, |x|, mix(0, |x|, t) in this order
 *
 * tests/sources/order.sh finds calls that leave the order open. */
#ifndef MATC_BUILD_H
#define MATC_BUILD_H
#include "compiler/ir/ir.h"

/* Creates up to five nodes from left to right. Yields them as an array that lives until the end
 * of the expression. */
#define REFS(ir, ...)                                                                              \
    REFS_PICK(__VA_ARGS__, REFS_5, REFS_4, REFS_3, REFS_2, REFS_1, )(ir, __VA_ARGS__).at
#define REFS_COUNT(...)                       REFS_PICK(__VA_ARGS__, 5, 4, 3, 2, 1, )
#define REFS_PICK(a, b, c, d, e, chosen, ...) chosen

#define REFS_1(ir, a)    (build_hold(ir, a), build_held(ir, 1))
#define REFS_2(ir, a, b) (build_hold(ir, a), build_hold(ir, b), build_held(ir, 2))
#define REFS_3(ir, a, b, c)                                                                        \
    (build_hold(ir, a), build_hold(ir, b), build_hold(ir, c), build_held(ir, 3))
#define REFS_4(ir, a, b, c, d)                                                                     \
    (build_hold(ir, a), build_hold(ir, b), build_hold(ir, c), build_hold(ir, d), build_held(ir, 4))
#define REFS_5(ir, a, b, c, d, e)                                                                  \
    (build_hold(ir, a), build_hold(ir, b), build_hold(ir, c), build_hold(ir, d),                   \
     build_hold(ir, e), build_held(ir, 5))

typedef struct {
    Ref at[5];
} Refs;

static inline void build_hold(Ir *ir, Ref ref)
{
    ARENA_PUSH(ir->arena, ir->held, ir->held_count, ir->held_capacity, ref);
}

static inline Refs build_held(Ir *ir, size_t count)
{
    Refs refs = {{0}};
    ir->held_count -= count;
    for (size_t i = 0; i < count; i++)
        refs.at[i] = ir->held[ir->held_count + i];
    return refs;
}

/* A builder for every operation of ops.def that is written as an operator or a call:
 * build_<op>() takes one operand, build_<op>_of() an array of operands. */
#define BUILD_1(name)                                                                              \
    static inline Ref build_##name(Ir *ir, Ref a)                                                  \
    {                                                                                              \
        return ir_make(ir, (IrNode){.op = OP_##name, .count = 1}, &a);                             \
    }
#define BUILD_2(name)                                                                              \
    static inline Ref build_##name##_of(Ir *ir, const Ref x[2])                                    \
    {                                                                                              \
        return ir_make(ir, (IrNode){.op = OP_##name, .count = 2}, x);                              \
    }
#define BUILD_3(name)                                                                              \
    static inline Ref build_##name##_of(Ir *ir, const Ref x[3])                                    \
    {                                                                                              \
        return ir_make(ir, (IrNode){.op = OP_##name, .count = 3}, x);                              \
    }
#define BUILD_prefix(name, arity) BUILD_##arity(name)
#define BUILD_infix(name, arity)  BUILD_##arity(name)
#define BUILD_call(name, arity)   BUILD_##arity(name)
#define BUILD_special(name, arity)
#define OP(name, shape, glsl, arity, rule, doc) BUILD_##shape(name, arity)
#include "grammar/ops.def"

#define build_add(ir, a, b)      build_add_of(ir, REFS(ir, a, b))
#define build_sub(ir, a, b)      build_sub_of(ir, REFS(ir, a, b))
#define build_mul(ir, a, b)      build_mul_of(ir, REFS(ir, a, b))
#define build_div(ir, a, b)      build_div_of(ir, REFS(ir, a, b))
#define build_min(ir, a, b)      build_min_of(ir, REFS(ir, a, b))
#define build_max(ir, a, b)      build_max_of(ir, REFS(ir, a, b))
#define build_step(ir, a, b)     build_step_of(ir, REFS(ir, a, b))
#define build_mod(ir, a, b)      build_mod_of(ir, REFS(ir, a, b))
#define build_pow(ir, a, b)      build_pow_of(ir, REFS(ir, a, b))
#define build_atan2(ir, a, b)    build_atan2_of(ir, REFS(ir, a, b))
#define build_lt(ir, a, b)       build_lt_of(ir, REFS(ir, a, b))
#define build_le(ir, a, b)       build_le_of(ir, REFS(ir, a, b))
#define build_eq(ir, a, b)       build_eq_of(ir, REFS(ir, a, b))
#define build_ne(ir, a, b)       build_ne_of(ir, REFS(ir, a, b))
#define build_and(ir, a, b)      build_and_of(ir, REFS(ir, a, b))
#define build_or(ir, a, b)       build_or_of(ir, REFS(ir, a, b))
#define build_dot(ir, a, b)      build_dot_of(ir, REFS(ir, a, b))
#define build_cross(ir, a, b)    build_cross_of(ir, REFS(ir, a, b))
#define build_shift(ir, a, b)    build_shift_of(ir, REFS(ir, a, b))
#define build_join(ir, a, b)     build_join_of(ir, REFS(ir, a, b))
#define build_clamp(ir, a, b, c) build_clamp_of(ir, REFS(ir, a, b, c))
#define build_mix(ir, a, b, c)   build_mix_of(ir, REFS(ir, a, b, c))
/* Builds a node whose operation is known only at run time. */
Ref build_unary(Ir *ir, Op op, Ref a);
#define build_binary(ir, which, a, b) ir_make(ir, (IrNode){.op = which, .count = 2}, REFS(ir, a, b))

/* Constants: a float, an int, a vector, a boolean; build_all() sets every component of a type. */
Ref build_float(Ir *ir, double value);
Ref build_int(Ir *ir, double value);
Ref build_vec3(Ir *ir, double x, double y, double z);
Ref build_truth(Ir *ir, bool value);
Ref build_all(Ir *ir, Type type, double value);
Ref build_input(Ir *ir, Input input);
Ref build_attribute(Ir *ir, int attribute, AttributePart part);
/* Builds a leaf: a uniform, texture or constant with the given index. */
Ref build_leaf(Ir *ir, Op op, Type type, int index);

/* Returns the products a * factor and a * a. */
Ref build_scale(Ir *ir, Ref a, double factor);
Ref build_square(Ir *ir, Ref a);
/* Selects a where the condition holds, otherwise b; a and b have one type. */
#define build_select(ir, condition, a, b) build_select_of(ir, REFS(ir, condition, a, b))
Ref build_select_of(Ir *ir, const Ref x[3]);
/* Guards a costly value: `a` where `shows` holds; elsewhere 0, which no user reads. opt_guard
 * removes the guard if the value is computed in any case. */
#define build_guard(ir, shows, a) build_guard_of(ir, REFS(ir, shows, a))
Ref build_guard_of(Ir *ir, const Ref x[2]);
static inline bool build_is_guard(const Ir *ir, Ref ref)
{
    return ir_is(ir, ref, OP_select) && ir_at(ir, ref)->payload;
}
/* Multiplies a vector by a matrix: args[0] is the vector, args[1] and the following are the
 * columns. */
Ref build_linear(Ir *ir, const Ref *args, int count);

/* Swizzles a vector: by letters of "xyzw", by two bits per component, or a single component by
 * its number. A float has only the component x. */
Ref build_swizzle(Ir *ir, Ref a, const char *letters);
Ref build_components(Ir *ir, Ref a, uint32_t components, int count);
Ref build_component(Ir *ir, Ref a, int component);
/* Returns float, vec2, vec3 or vec4 for 1 to 4 components. */
Type build_components_type(int components);
/* Builds a vector from parts; their components together are those of the type. */
#define build_vec(ir, type, ...)                                                                   \
    build_vec_of(ir, type, REFS(ir, __VA_ARGS__), REFS_COUNT(__VA_ARGS__))
Ref build_vec_of(Ir *ir, Type type, const Ref *parts, int count);
/* Copies a float into every component of the type; a value of that type is returned unchanged. */
Ref build_splat(Ir *ir, Ref a, Type type);
/* Converts between types by the width rules of docs/reference/semantics.md. */
Ref build_convert(Ir *ir, Ref a, Type type);

/* Calls: build_call() of a library function, build_apply() of a function of the program.
 * build_kernel() sums such a function over the KERNEL_POINTS points around its arguments, half
 * of `size` apart; GLSL gets a loop. */
#define build_call(ir, function, ...)                                                              \
    build_call_of(ir, function, REFS(ir, __VA_ARGS__), REFS_COUNT(__VA_ARGS__))
Ref build_call_of(Ir *ir, int function, const Ref *args, int count);
Ref build_apply(Ir *ir, int function, const Ref *args);
Ref build_kernel(Ir *ir, int function, const Ref *args, Ref size);

/* Sums and products whose operands may be zero everywhere. The null node 0 represents zero, so
 * derivatives and variances of constant values create no nodes. In order: a + b; factor a; a /
 * b; -a; and build_or_zero(), which returns the node, or zeros of the type for the null node. */
#define build_plus(ir, a, b)       build_plus_of(ir, REFS(ir, a, b))
#define build_times(ir, factor, a) build_times_of(ir, REFS(ir, factor, a))
#define build_over(ir, a, b)       build_over_of(ir, REFS(ir, a, b))
Ref build_plus_of(Ir *ir, const Ref x[2]);
Ref build_times_of(Ir *ir, const Ref x[2]);
Ref build_over_of(Ir *ir, const Ref x[2]);
Ref build_minus(Ir *ir, Ref a);
Ref build_or_zero(Ir *ir, Ref a, Type type);
#endif
