/* Values of operations on numbers. */
#ifndef MATC_FOLD_H
#define MATC_FOLD_H
#include "compiler/ir/ir.h"

enum { FOLD_OPERANDS = 16 };
typedef struct {
    Type type;
    double numbers[4];
} FoldArg;

/* Folds a node's operation over operand values; false where ops.def has no FOLD: leaves, and nodes
 * that run a function of the program. */
bool fold_value(const ReferenceContext *context, const IrNode *node, const FoldArg *args,
                double *result);

/* Evaluates the outputs of an Ir at a point: the second oracle, which runs what the compiler made
 * of a document. inputs[Input] are the point; textures those of the context. result[i] are the
 * lanes of output i. ir_eval.c. */
void ir_eval(const Ir *ir, const ReferenceContext *context, const double inputs[INPUT_COUNT][4],
             double result[MOST_OUTPUTS][4]);
/* Hooks that change each component of each node's value: rounding of a machine with fewer digits,
 * or other errors. */
typedef struct {
    double (*round)(void *user, const IrNode *node, const FoldArg *args, double value);
    void *user;
} IrRounding;
void ir_eval_rounded(const Ir *ir, const ReferenceContext *context,
                     const double inputs[INPUT_COUNT][4], const IrRounding *rounding,
                     double result[MOST_OUTPUTS][4]);
#endif
