/* The different programs that a request's variants come out as. */
#ifndef MATC_MEASURE_CANDIDATES_H
#define MATC_MEASURE_CANDIDATES_H
#include "runtime/measure/measure.h"

/* A program of pass gbuffer, with its unpacking. */
typedef struct {
    Variant variant;
    MatcProgram *program;
} Candidate;

/* From malloc, the given variant first unless it does not compile; the programs are the caller's.
 * Counts in the list what is the same as another, and what does not compile. */
Candidate *candidates_make(const MeasureRequest *request, MeasuredList *list, int *count);
#endif
