/* Intervals of every value of an IR: what opt_range rewrites by, and layouts are made from. */
#ifndef MATC_RANGE_H
#define MATC_RANGE_H
#include "compiler/ir/interval.h"
#include "compiler/ir/ir.h"

/* Where in Ranges.of a node's intervals begin, 0: it may be anything; and whether each of its lanes
 * has one there. */
typedef struct {
    uint32_t first : 31, by_lane : 1;
} RangePlace;

typedef struct Ranges {
    /* of each node that was looked at as many as it has lanes, or one; the first is of none */
    Interval *of;
    size_t used, room;     /* of them */
    RangePlace *place;     /* by Ref */
    size_t place_room;     /* of them */
    Ref count;             /* of nodes when they were found last */
    int lanes;             /* 1: one for all lanes of a node; FIELD_LANES: one a lane */
    struct Guards *guards; /* under way: range.c */
    uint64_t guarded;      /* marks of the nodes that the guards compare; 0: no guards */
    struct Seen *seen;     /* while they hold; NULL: there are none */
    /* by Ref: of what conditions compare, what this node is made of; range_mark. NULL: likewise */
    uint64_t *marks;
} Ranges;

/* Finds intervals of all nodes, in the arena. Arithmetic that rounds may exceed a bound by 1e-5 of
 * it. */
Ranges range_find(const Ir *ir, Arena *arena, int lanes);
/* Finds intervals of live nodes; other nodes are unbounded. Intervals found before in the same
 * arena are reused. Zero all members but `lanes` before the first call. */
void range_find_live(Ranges *r, const Ir *ir, Arena *arena, const uint8_t *live);
/* Something was found of it. */
static inline bool range_is_found(const Ranges *r, Ref ref)
{
    return ref < r->count && r->place[ref].first;
}
/* Finds intervals of the nodes that some roots reach. */
Ranges range_find_below(const Ir *ir, Arena *arena, int lanes, const Ref *roots, int count);
/* The interval of such a node holds to the last bit. */
bool range_is_exact(Op op);
/* Stored interval of a component: everywhere, and where the current guards hold. */
static inline Interval range_kept(const Ranges *r, Ref ref, int lane)
{
    const RangePlace place = ref < r->count ? r->place[ref] : (RangePlace){0};
    return !place.first ? everything : r->of[place.first + (place.by_lane ? (uint32_t)lane : 0)];
}
Interval range_guarded(const Ranges *r, const Ir *ir, Ref ref, int lane);
/* Interval of one component, or of their union if only that is stored. A node that is newer than
 * the ranges has the interval of all numbers. Only nodes that depend on a guarded node look at the
 * guards. */
static inline Interval range_of(const Ranges *r, const Ir *ir, Ref ref, int lane)
{
    const bool guarded = r->guarded && ref < r->count && r->marks[ref] & r->guarded;
    return guarded ? range_guarded(r, ir, ref, lane) : range_kept(r, ref, lane);
}
/* A bit for a node that a condition compares: all but 64 share theirs. */
static inline uint64_t range_mark(Ref ref) { return 1ull << (ref & 63); }
/* Nothing was found yet while guards held. */
struct Seen *range_seen_new(Arena *arena);
/* Intervals of the `lanes` components of a select. They share its guards, so all are found
 * together. */
void range_select(const Ranges *r, const Ir *ir, Ref ref, int lanes, Interval *found);
/* Interval that follows from the operands' intervals by the node's operation. */
Interval range_computed(const Ranges *r, const Ir *ir, Ref ref, int lane);
#endif
