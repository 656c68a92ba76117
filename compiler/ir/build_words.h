/* Short forms of the builders of build.h for the tables of grammar/. The IR is the variable `ir`
 * at the place where a row is expanded: a row reads MUL(UNARY(cos, a), K(2)) instead of
 * build_mul(ir, build_cos(ir, a), build_float(ir, 2)). Included by .c files only. */
#ifndef MATC_BUILD_WORDS_H
#define MATC_BUILD_WORDS_H
#include "compiler/ir/build.h"

#define K(x)             build_float(ir, x)
#define UNARY(op, a)     build_##op(ir, a)
#define BINARY(op, a, b) build_##op(ir, a, b)
#define ADD(a, b)        build_add(ir, a, b)
#define SUB(a, b)        build_sub(ir, a, b)
#define MUL(a, b)        build_mul(ir, a, b)
#define DIV(a, b)        build_div(ir, a, b)
#define MAX(a, b)        build_max(ir, a, b)
#define STEP(a, b)       build_step(ir, a, b)
#define POW(a, b)        build_pow(ir, a, b)
#define TWICE(a)         build_scale(ir, a, 2)
#define SCALED(a, k)     build_scale(ir, a, k)
#endif
