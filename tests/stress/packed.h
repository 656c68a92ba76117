/* Checks the words that a G-buffer program writes: within the range of its targets, and equal at
 * every level of optimization. */
#ifndef MATC_STRESS_PACKED_H
#define MATC_STRESS_PACKED_H
#include "compiler/layout/layout.h"

/* A component of a target: a finite half float, or a whole number of its bits. */
bool packed_in_range(double value, const FormatRow *format);
/* Two words of the same place, and of the last one of their G-buffer, which may mark the case. */
typedef struct {
    double word[2], last[2];
} PackedPair;
/* Their fields come from values that roundings may have set apart: each code is the same, or a
 * neighbour. */
bool packed_agree(const LayoutRow *layout, int target, int component, const PackedPair *pair);
#endif
