/* Constant folding and evaluation of IR. */
#ifndef MATC_FOLD_H
#define MATC_FOLD_H
#include "compiler/ir/ir.h"

enum { FOLD_OPERANDS = 16 };
typedef struct {
    Type type;
    double numbers[4];
} FoldArg;

/* Folds a node's operation over operand values. Returns false if ops.def has no FOLD row:
 * leaves, and nodes that run a function of the program. */
bool fold_value(const ReferenceContext *context, const IrNode *node, const FoldArg *args,
                double *result);

/* Evaluates the outputs of an Ir at a point: the second oracle, which executes the compiled
 * document. inputs[Input] describe the point; textures come from the context. result[i] holds
 * the components of output i. ir_eval.c. */
void ir_eval(const Ir *ir, const ReferenceContext *context, const double inputs[INPUT_COUNT][4],
             double result[MAX_OUTPUTS][4]);
/* Hook that changes each component of each node's value, to model rounding of a machine with
 * lower precision, or other errors. */
typedef struct {
    double (*round)(void *user, const IrNode *node, const FoldArg *args, double value);
    void *user;
} IrRounding;
void ir_eval_rounded(const Ir *ir, const ReferenceContext *context,
                     const double inputs[INPUT_COUNT][4], const IrRounding *rounding,
                     double result[MAX_OUTPUTS][4]);
#endif
