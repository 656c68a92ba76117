/* Intervals of every value of an IR: what opt_range rewrites by, and layouts are made from. */
#ifndef MATC_RANGE_H
#define MATC_RANGE_H
#include "compiler/ir/ir.h"

typedef struct {
    double low, high;
} Interval;

typedef struct {
    Interval *of;          /* by Ref, `lanes` of each */
    Ref count;             /* of nodes when they were found */
    int lanes;             /* 1: one for all lanes of a node; FIELD_LANES: one a lane */
    struct Guards *guards; /* under way: range_guard.c */
} Ranges;

/* Of all nodes, in the arena. Arithmetic that rounds may pass a bound by a rounding's worth: 1e-5 of it. */
Ranges range_find(const Ir *ir, Arena *arena, int lanes);
/* The interval of such a node holds to the last bit. */
bool range_is_exact(Op op);
/* Of a lane, or of all lanes together where that is all that is kept. What came later may be anything. */
Interval range_of(const Ranges *r, const Ir *ir, Ref ref, int lane);

/* Parts of it. The interval that is kept; that which follows from the operands' by the node's operation. */
Interval range_kept(const Ranges *r, const Ir *ir, Ref ref, int lane);
Interval range_computed(const Ranges *r, const Ir *ir, Ref ref, int lane);
/* Of a select: each arm where it is taken, by what its condition says of the value that it compares. range_guard.c */
Interval range_select(const Ranges *r, const Ir *ir, Ref ref, int lane);
/* Where arms are under way: what holds there of a node. */
Interval range_guarded(const Ranges *r, const Ir *ir, Ref ref, int lane);
#endif
