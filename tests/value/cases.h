/* Arguments at which each library function is tested: tests/functions.def, and for volume maps
 * the POINTS lines of grammar/maps.def. */
#ifndef MATC_VALUE_CASES_H
#define MATC_VALUE_CASES_H
#include "tuple.h"

typedef enum {
    UNIT_ABSOLUTE,
    UNIT_RELATIVE,
    UNIT_VECTOR,
    UNIT_MIXED,
    UNIT_ULP,
    UNIT_STRENGTH,
    UNIT_SLOPE,
    UNIT_TURN,
    UNIT_CODE
} Unit;

typedef struct {
    int function;
    double bound;
    Unit unit;
    double reach;
    Argument arguments[CALL_ARGUMENTS];
} FunctionCase;

extern const FunctionCase function_cases[];
extern const int case_count;
/* Case of a volume map without a POINTS line: all of its parameters' ranges. */
FunctionCase case_of_ranges(Kind kind);
/* Seed of a case's random numbers, from its function's name, so that other rows do not influence
 * it. */
uint64_t case_random(const FunctionCase *row, int seed);
#endif
