/* Effect of rounding on a value: an IR is evaluated many times, each operation with a random error
 * up to its bound. Where a function jumps or is steep, the values are far apart; a correct
 * program's value is among them. */
#ifndef MATC_STRESS_SPREAD_H
#define MATC_STRESS_SPREAD_H
#include "tests/value/evaluate.h"

typedef enum { MACHINE_double, MACHINE_float } Machine;

typedef struct {
    double low[MAX_OUTPUTS][4], high[MAX_OUTPUTS][4];
} Spread;

/* A program at a point, and its exact results. */
typedef struct {
    const Ir *ir;
    const ReferenceContext *context;
    const double (*inputs)[4]; /* INPUT_COUNT inputs */
    const double (*value)[4];  /* MAX_OUTPUTS values */
} Evaluated;

/* Computes the spread of `count` evaluations; includes the exact value. */
void spread_make(const Evaluated *at, Machine machine, int count, Spread *spread);
/* Distance of a number from the spread, in units of max(1, |value|), with the spread widened by
 * its own width on both sides. */
double spread_miss(const Spread *spread, int output, int component, double value, double number);

/* An evaluation in double, and statistics of its nodes. */
typedef struct {
    double value[MAX_OUTPUTS][4];
    double peak; /* greatest finite magnitude of all nodes */
    bool finite; /* all nodes are finite */
} Evaluation;
void evaluate_double(const Ir *ir, const ReferenceContext *context,
                     const double inputs[INPUT_COUNT][4], Evaluation *e);
/* Evaluates with every result rounded to float, and denormals flushed to 0. */
void evaluate_float(const Ir *ir, const ReferenceContext *context,
                    const double inputs[INPUT_COUNT][4], Evaluation *e);
#endif
