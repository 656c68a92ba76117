/* Finds the intervals of the requested nodes, operands first. */
#include "compiler/ir/range.h"
#include <math.h>

static bool compares(const Ir *ir, Ref ref)
{
    return ir_is(ir, ref, OP_lt) || ir_is(ir, ref, OP_le);
}

static bool is_asked(const uint8_t *live, Ref ref) { return !live || live[ref]; }

/* Marks the nodes that a condition compares, and propagates the marks to their users. Returns
 * NULL if no node is compared. */
static uint64_t *mark_compared(const Ir *ir, Arena *arena, Ref count, const uint8_t *live)
{
    uint64_t *marks = NULL;
    for (Ref ref = 1; ref < count; ref++) {
        if (!compares(ir, ref) || !is_asked(live, ref))
            continue;
        marks = marks ? marks : ARENA_ARRAY(arena, uint64_t, count);
        for (int i = 0; i < 2; i++)
            marks[ir_arg(ir, ref, i)] = range_mark(ir_arg(ir, ref, i));
    }
    for (Ref ref = 1; marks && ref < count; ref++) {
        if (!is_asked(live, ref))
            continue;
        for (int i = 0; i < ir_at(ir, ref)->count; i++)
            marks[ref] |= marks[ir_arg(ir, ref, i)];
        if (ir_applies(ir, ref))
            marks[ref] |= marks[ir->functions[ir_at(ir, ref)->payload].result];
    }
    return marks;
}

/* Returns the number of stored intervals; a sampler, without components, gets one unbounded
 * interval. */
static int kept_components(const Ranges *r, const Ir *ir, Ref ref)
{
    const int components = ir_components(ir, ref);
    return r->components == 1 || components == 0 ? 1 : components;
}

static void compute(Ranges *r, const Ir *ir, Arena *arena, Ref ref)
{
    const int components = kept_components(r, ir, ref);
    const RangePlace place = {(uint32_t)r->used, components > 1};
    const bool at_once = r->marks && ir_is(ir, ref, OP_select);
    Interval found[4];
    if (at_once)
        range_select(r, ir, ref, components, found);
    for (int component = 0; component < components; component++) {
        const Interval range = at_once ? found[component] : range_computed(r, ir, ref, component);
        const bool none = isnan(range.low) || isnan(range.high);
        ARENA_PUSH(arena, r->of, r->used, r->capacity, none ? everything : range);
    }
    r->place[ref] = place;
}

/* Finds intervals of nodes below `count`: of live ones, or of all if `live` is NULL. */
static void find(Ranges *r, const Ir *ir, Arena *arena, Ref count, const uint8_t *live)
{
    r->count = count;
    r->place = arena_reach(arena, r->place, count, &r->place_capacity, sizeof *r->place);
    /* guards need one interval per component */
    r->marks = r->components > 1 ? mark_compared(ir, arena, count, live) : NULL;
    if (r->marks && !r->seen)
        r->seen = range_seen_new(arena);
    if (!r->used)
        ARENA_PUSH(arena, r->of, r->used, r->capacity, everything);
    for (Ref ref = 1; ref < count; ref++)
        if (!r->place[ref].first && is_asked(live, ref))
            compute(r, ir, arena, ref);
}

Ranges range_find(const Ir *ir, Arena *arena, int components)
{
    Ranges r = {.components = components};
    find(&r, ir, arena, (Ref)ir->count, NULL);
    return r;
}

void range_find_live(Ranges *r, const Ir *ir, Arena *arena, const uint8_t *live)
{
    find(r, ir, arena, (Ref)ir->count, live);
}

Ranges range_find_below(const Ir *ir, Arena *arena, int components, const Ref *roots, int count)
{
    Ref last = 0;
    for (int i = 0; i < count; i++)
        last = roots[i] > last ? roots[i] : last;
    uint8_t *live = ARENA_ARRAY(arena, uint8_t, last + 1);
    for (int i = 0; i < count; i++)
        live[roots[i]] = 1;
    ir_live_below(ir, live, last);
    Ranges r = {.components = components};
    find(&r, ir, arena, last + 1, live);
    return r;
}
