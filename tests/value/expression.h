/* IR written as a formula, for tests of single rules:
 *
 *     x y z                the local position's components
 *     v w                  local and world position, vec3
 *     u                    texture coordinate, vec2
 *     front true false     truth values
 *     2 -0.5 2i 5u         floats, an int, a uint
 *     [1, 0, 0]            a constant vector
 *     vec2(x, 1)           a vector of its parts
 *     v.xz                 a swizzle
 *     mul(x, 2)            an operation of ops.def, or a function of functions.def or a map
 *
 * `-x` is not accepted: write neg(x), the IR's operation. */
#ifndef MATC_VALUE_EXPRESSION_H
#define MATC_VALUE_EXPRESSION_H
#include "compiler/ir/ir.h"

/* Returns the node; 0 for a syntax error. */
Ref expression_read(Ir *ir, const char *text);
/* Prints text that expression_read reads to the same node. */
void expression_print(Text *out, const Ir *ir, Ref ref);
#endif
