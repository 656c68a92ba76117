/* Checks the words that a G-buffer program writes: within the range of its targets, and equal at
 * every level of optimization. */
#ifndef MATC_STRESS_PACKED_H
#define MATC_STRESS_PACKED_H
#include "compiler/layout/layout.h"

/* True if a component fits its target: a finite half float, or an integer of its bits. */
bool packed_in_range(double value, const FormatRow *format);
/* A word at -O0 and -O2, and the last word of each G-buffer, which may contain the case. */
typedef struct {
    double word[2], last[2];
} PackedPair;
/* The packed values may differ by rounding: each code must be equal or adjacent. */
bool packed_agree(const LayoutRow *layout, int target, int component, const PackedPair *pair);
#endif
