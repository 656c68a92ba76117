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

/* A program at a point, and what it gives there, exactly. */
typedef struct {
    const Ir *ir;
    const ReferenceContext *context;
    const double (*inputs)[4]; /* of INPUT_COUNT */
    const double (*value)[4];  /* of MAX_OUTPUTS */
} Evaluated;

/* Spread of `count` evaluations. The exact value is included. */
void spread_make(const Evaluated *at, Machine machine, int count, Spread *spread);
/* How far a number lies outside, in units of max(1, |value|), the spread taken to be wider by its
 * own width on both sides. */
double spread_miss(const Spread *spread, int output, int component, double value, double number);

/* An evaluation as exact as doubles are, and what was seen on the way. */
typedef struct {
    double value[MAX_OUTPUTS][4];
    double peak; /* greatest finite number of all nodes */
    bool finite; /* all of them */
} Evaluation;
void evaluate_double(const Ir *ir, const ReferenceContext *context,
                     const double inputs[INPUT_COUNT][4], Evaluation *e);
/* Every operation's result rounded to float, denormals to 0. */
void evaluate_float(const Ir *ir, const ReferenceContext *context,
                    const double inputs[INPUT_COUNT][4], Evaluation *e);
#endif
