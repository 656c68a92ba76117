/* Interval analysis of all IR values, used by opt_range and to derive automatic layouts. */
#ifndef MATC_RANGE_H
#define MATC_RANGE_H
#include "compiler/ir/interval.h"
#include "compiler/ir/ir.h"

/* Index of a node's intervals in Ranges.of; 0: unbounded. by_component: one interval per component.
 */
typedef struct {
    uint32_t first : 31, by_component : 1;
} RangePlace;

typedef struct Ranges {
    /* intervals of the examined nodes, one per component or one each; index 0 is unused */
    Interval *of;
    size_t used, capacity; /* number of entries of `of`, and its capacity */
    RangePlace *place;     /* intervals of each node, by Ref */
    size_t place_capacity; /* capacity of `place` in entries */
    Ref count;             /* number of nodes at the last search */
    /* 1: one interval for all components of a node; FIELD_COMPONENTS: one per component */
    int components;
    struct Guards *guards; /* active guards: range.c */
    uint64_t guarded;      /* marks of the nodes that the guards compare; 0: no guards */
    struct Seen *seen;     /* cache of guarded intervals; NULL: none */
    /* Per Ref: marks of the compared nodes on which a node depends, see range_mark(). NULL: no
     * node is compared. */
    uint64_t *marks;
} Ranges;

/* Finds the intervals of all nodes, in the arena. Operations that round may exceed a bound by a
 * relative error of 1e-5. */
Ranges range_find(const Ir *ir, Arena *arena, int components);
/* Finds intervals of live nodes; other nodes are unbounded. Intervals found earlier in the same
 * arena are reused. Zero all members except `components` before the first call. */
void range_find_live(Ranges *r, const Ir *ir, Arena *arena, const uint8_t *live);
/* Returns true if an interval of the node is stored. */
static inline bool range_is_found(const Ranges *r, Ref ref)
{
    return ref < r->count && r->place[ref].first;
}
/* Finds intervals of the nodes that some roots reach. */
Ranges range_find_below(const Ir *ir, Arena *arena, int components, const Ref *roots, int count);
/* Returns true for operations whose intervals are exact, without rounding error. */
bool range_is_exact(Op op);
/* Returns the interval of a component as stored, regardless of guards; and while the current
 * guards hold. */
static inline Interval range_kept(const Ranges *r, Ref ref, int component)
{
    const RangePlace place = ref < r->count ? r->place[ref] : (RangePlace){0};
    return !place.first ? everything
                        : r->of[place.first + (place.by_component ? (uint32_t)component : 0)];
}
Interval range_guarded(const Ranges *r, const Ir *ir, Ref ref, int component);
/* Returns the interval of one component, or of their union if only that is stored. Nodes created
 * after the analysis are unbounded. Guards are consulted only for nodes that depend on a guarded
 * node. */
static inline Interval range_of(const Ranges *r, const Ir *ir, Ref ref, int component)
{
    const bool guarded = r->guarded && ref < r->count && r->marks[ref] & r->guarded;
    return guarded ? range_guarded(r, ir, ref, component) : range_kept(r, ref, component);
}
/* Returns the bit of a node that a condition compares; nodes share the 64 bits by their number
 * modulo 64. */
static inline uint64_t range_mark(Ref ref) { return 1ull << (ref & 63); }
/* Creates an empty cache of guarded intervals. */
struct Seen *range_seen_new(Arena *arena);
/* Finds the intervals of a select's `components` components together, since they share its guards.
 */
void range_select(const Ranges *r, const Ir *ir, Ref ref, int components, Interval *found);
/* Returns the interval that follows from the operands' intervals by the node's operation. */
Interval range_computed(const Ranges *r, const Ir *ir, Ref ref, int component);
#endif
