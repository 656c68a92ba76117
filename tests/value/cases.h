/* What is asked of each library function, and at which arguments: tests/functions.def. */
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
    const char *function;
    double bound;
    Unit unit;
    double reach;
    Argument arguments[CALL_ARGUMENTS];
} FunctionCase;

extern const FunctionCase function_cases[];
extern const int case_count;
/* The number of a library function or a volume map's by its name; FN_none: there is none. */
int function_find(const char *name);
#endif
