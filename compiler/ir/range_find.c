/* The intervals of all nodes that are asked for, operands first. */
#include "compiler/ir/range.h"
#include <math.h>
#include <string.h>

static bool compares(const Ir *ir, Ref ref) { return ir_is(ir, ref, OP_lt) || ir_is(ir, ref, OP_le); }

/* A bit for each node that a condition compares with something, all but 64 of them sharing theirs; and those of its operands. */
static uint64_t *mark_compared(const Ir *ir, Arena *arena, const Ranges *r)
{
    uint64_t *marks = ARENA_ARRAY(arena, uint64_t, r->count);
    bool any = false;
    for (Ref ref = 1; ref < r->count; ref++) {
        if (!r->first[ref] || !compares(ir, ref))
            continue;
        any = true;
        for (int i = 0; i < 2; i++)
            marks[ir_arg(ir, ref, i)] = range_mark(ir_arg(ir, ref, i));
    }
    for (Ref ref = 1; any && ref < r->count; ref++) {
        if (!r->first[ref])
            continue;
        for (int i = 0; i < ir_at(ir, ref)->count; i++)
            marks[ref] |= marks[ir_arg(ir, ref, i)];
        if (ir_applies(ir, ref))
            marks[ref] |= marks[ir->functions[ir_at(ir, ref)->payload].result];
    }
    return marks;
}

/* A sampler has no lane; of it, too, anything is said. */
static int kept_lanes(const Ranges *r, const Ir *ir, Ref ref)
{
    return r->lanes == 1 || ir_lanes(ir, ref) == 0 ? 1 : ir_lanes(ir, ref);
}

/* Room for the intervals of nodes below `count`: of those that are live; NULL: of all. */
static Ranges make_room(const Ir *ir, Arena *arena, int lanes, Ref count, const uint8_t *live)
{
    Ranges r = {.first = ARENA_ARRAY(arena, uint32_t, count), .count = count, .lanes = lanes};
    uint32_t used = 1;
    for (Ref ref = 1; ref < count; ref++)
        if (!live || live[ref]) {
            r.first[ref] = used;
            used += (uint32_t)kept_lanes(&r, ir, ref);
        }
    r.of = arena_alloc(arena, used * sizeof *r.of);
    return r;
}

/* Of as many lanes as `r` keeps. */
static void keep_found(Ranges *r, const Ir *ir, Ref ref, const Ranges *before)
{
    memcpy(&r->of[r->first[ref]], &before->of[before->first[ref]], sizeof *r->of * (size_t)kept_lanes(r, ir, ref));
}

static void compute(Ranges *r, const Ir *ir, Ref ref)
{
    for (int lane = 0; lane < kept_lanes(r, ir, ref); lane++) {
        const Interval range = range_computed(r, ir, ref, lane);
        const bool none = isnan(range.low) || isnan(range.high);
        r->of[r->first[ref] + (uint32_t)lane] = none ? everything : range;
    }
}

static Ranges find(const Ir *ir, Arena *arena, Ranges r, const Ranges *before)
{
    const int lanes = r.lanes;
    if (lanes > 1) { /* all lanes as one know no guards */
        r.seen = range_seen_new(arena);
        r.marks = mark_compared(ir, arena, &r);
    }
    for (Ref ref = 1; ref < r.count; ref++)
        if (r.first[ref] && before && range_is_found(before, ref))
            keep_found(&r, ir, ref, before);
        else if (r.first[ref])
            compute(&r, ir, ref);
    return r;
}

Ranges range_find(const Ir *ir, Arena *arena, int lanes) { return range_find_live(ir, arena, lanes, NULL, NULL); }

Ranges range_find_live(const Ir *ir, Arena *arena, int lanes, const uint8_t *live, const Ranges *before)
{
    return find(ir, arena, make_room(ir, arena, lanes, (Ref)ir->count, live), before);
}

Ranges range_find_below(const Ir *ir, Arena *arena, int lanes, const Ref *roots, int count)
{
    Ref last = 0;
    for (int i = 0; i < count; i++)
        last = roots[i] > last ? roots[i] : last;
    uint8_t *live = ARENA_ARRAY(arena, uint8_t, last + 1);
    for (int i = 0; i < count; i++)
        live[roots[i]] = 1;
    ir_live_below(ir, live, last);
    return find(ir, arena, make_room(ir, arena, lanes, last + 1, live), NULL);
}
