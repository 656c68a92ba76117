/* Blends: their items, weighted sums of them, and their slopes. blend.c, blend_slope.c; the map
 * itself is lower_blend.c. */
#ifndef MATC_BLEND_H
#define MATC_BLEND_H
#include "compiler/lower/lower.h"

enum {
    BLEND_CHEAP =
        /* scalar operations: an item that takes as many is costly; all items together below it are
         * cheap */
    40,
    /* items up to which mixing, and a branch for each costly one, beat searching */
    BLEND_MOST_MIXES = 8,
};

typedef struct {
    /* of an item: where it lies on t, its answer and what that leaves out */
    Ref value, result, variance;
} Stop;

/* How far t is between two stops. The divisor is guarded: equal values make a segment that is never
 * taken. */
Ref blend_position(Lower *l, Ref t, Ref low, Ref high);
/* How much of the way from a stop to the next t has behind it: 0 before both, 1 behind them. */
Ref blend_share(Lower *l, Ref t, const Stop *stop);
bool blend_is_costly(const Ir *ir, Ref result);
/* shown ? value : 0, called as the value: a branch where that pays (opt_guard.c). */
Ref blend_guarded(Lower *l, Ref shown, Ref value);
/* The items, each costly one behind a guard, so that it is computed only where it shows: between
 * its neighbours' values, or closed, on them, too. The items themselves where none is costly. */
const Stop *blend_guarded_items(Lower *l, Ref t, const Stop *stops, int count, bool closed);
/* No item is lost beside a greater one where they are mixed as a + t (b - a): all are in [0, 1], or
 * constants of one size. */
bool blend_alike(const Ir *ir, const Stop *stops, int count);
/* Items times their weights, at a point of t. */
Ref blend_weights(Lower *l, Ref t, Ref edge, const Stop *stops, int count);
/* The mean over a box of t of that edge. A costly item is computed where its weight is not 0. */
Ref blend_over(Lower *l, Ref t, Ref edge, const Stop *stops, int count);
/* Variance of such a sum, in any of its forms; `edge` is optional. 0: nothing was left out. */
Ref blend_variance(Lower *l, Ref t, Ref edge, const Stop *stops, int count);

/* A sum of ascending items, by their shares at a point of t. */
typedef struct Blended {
    Ref t;
    const Stop *stops;
    const Stop *within; /* the same; costly ones may be 0 where they do not show */
    int count;
} Blended;
/* Tells slope.c that the value is that. False: the same value is another Blend already, which may
 * have other slopes. blend_slope.c */
bool blend_note(Lower *l, Ref value, const Blended *blend);
#endif
