/* What Blends are made of: their items, and the sums of them by weights. blend.c; the map itself is lower_blend.c. */
#ifndef MATC_BLEND_H
#define MATC_BLEND_H
#include "compiler/lower/lower.h"

enum {
    BLEND_CHEAP =
        40, /* scalar operations: an item that takes as many is costly; all items together below it are cheap */
    BLEND_MOST_MIXES = 8, /* items up to which mixing, and a branch for each costly one, beat searching */
};

typedef struct {
    Ref value, result, variance; /* of an item: where it lies on t, its answer and what that leaves out */
} Stop;

/* How far t is between two stops. The divisor is guarded: equal values make a segment that is never taken. */
Ref blend_position(Lower *l, Ref t, Ref low, Ref high);
bool blend_is_costly(const Ir *ir, Ref result);
/* shown ? value : 0, called as the value: a branch where that pays (opt_guard.c). */
Ref blend_guarded(Lower *l, Ref shown, Ref value);
/* No item is lost beside a greater one where they are mixed as a + t (b - a): all are in [0, 1], or constants of one size. */
bool blend_alike(const Ir *ir, const Stop *stops, int count);
/* Items times their weights, at a point of t. */
Ref blend_weights(Lower *l, Ref t, Ref edge, const Stop *stops, int count);
/* The mean over a box of t of that edge. A costly item is computed where its weight is not 0. */
Ref blend_over(Lower *l, Ref t, Ref edge, const Stop *stops, int count);
/* Of such a sum, whichever form it has; `edge` may be none. 0: nothing was left out. */
Ref blend_variance(Lower *l, Ref t, Ref edge, const Stop *stops, int count);
#endif
