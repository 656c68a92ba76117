/* Blends: their items, weighted sums of items, and the sums' slopes. blend.c, blend_slope.c; the
 * map itself is in lower_blend.c. */
#ifndef MATC_BLEND_H
#define MATC_BLEND_H
#include "compiler/lower/lower.h"

enum {
    /* Scalar operations from which on one item counts as costly; below it, all items of a
     * Blend together count as cheap. */
    BLEND_CHEAP = 40,
    /* Number of items up to which mixing, with a branch for each costly item, is cheaper than a
     * binary search. */
    BLEND_MAX_MIXES = 8,
};

typedef struct {
    /* An item: its position on t, its value, and the variance that the value leaves out. */
    Ref value, result, variance;
} Stop;

/* Returns the position of t between two stops, 0 at `low` and 1 at `high`. The divisor is
 * guarded: equal values make a segment that is never taken. */
Ref blend_position(Lower *l, Ref t, Ref low, Ref high);
/* Returns the share of the step from a stop to the next that t has passed: 0 before both stops,
 * 1 after them. */
Ref blend_share(Lower *l, Ref t, const Stop *stop);
bool blend_is_costly(const Ir *ir, Ref result);
/* Returns shown ? value : 0, with the value's name. opt_guard.c makes a branch of the guard
 * where that pays. */
Ref blend_guarded(Lower *l, Ref shown, Ref value);
/* Puts each costly item behind a guard, so that it is computed only where it shows: between its
 * neighbors' values; `closed`: also exactly at them. Returns `stops` itself if no item is
 * costly. */
const Stop *blend_guarded_items(Lower *l, Ref t, const Stop *stops, int count, bool closed);
/* Returns true if mixing as a + t (b - a) loses no item to rounding against a greater one: all
 * items are in [0, 1], or are constants of similar size. */
bool blend_alike(const Ir *ir, const Stop *stops, int count);
/* Returns the sum of items times their weights, at a point of t (edge 0) or over a box. */
Ref blend_weights(Lower *l, Ref t, Ref edge, const Stop *stops, int count);
/* Returns the mean over a box of t with that edge. A costly item is computed only where its
 * weight is not 0. */
Ref blend_over(Lower *l, Ref t, Ref edge, const Stop *stops, int count);
/* Returns the variance of a weighted sum of items, in any of its forms; `edge` 0: at a point.
 * Returns 0 if no item has a variance. */
Ref blend_variance(Lower *l, Ref t, Ref edge, const Stop *stops, int count);

/* A sum of ascending items, weighted by their shares at a point of t. */
typedef struct Blended {
    Ref t;
    const Stop *stops;
    const Stop *within; /* the items again; costly items may be 0 where their weight is 0 */
    int count;
} Blended;
/* Records for slope.c that `value` is this sum. Returns false if the same value already is
 * another Blend, whose slopes may differ. blend_slope.c */
bool blend_note(Lower *l, Ref value, const Blended *blend);
#endif
