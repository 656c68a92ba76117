/* Distinct programs among the variants of a measurement. */
#ifndef MATC_AUTOTUNE_CANDIDATES_H
#define MATC_AUTOTUNE_CANDIDATES_H
#include "runtime/autotune/autotune.h"

/* A program of pass gbuffer with its unpacking code. */
typedef struct {
    Variant variant;
    MatcProgram *program;
} Candidate;

/* Compiles all variants and keeps one candidate per distinct program. Returns an array from
 * malloc, beginning with the base variant unless that fails to compile; the caller frees the
 * programs. Counts duplicates in list->same and failures in list->refused. */
Candidate *candidates_make(const AutotuneRequest *request, MeasuredList *list, int *count);
#endif
