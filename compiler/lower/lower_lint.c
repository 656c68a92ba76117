/* Lints for parts of a document that show nothing, by the intervals of the lowered values.
 *
 *     { map: Blend, blend: [{ value: -1, input: red }, { value: 0, input: blue }], input: { map:
 *     Wood } }
 *     Wood is a distance, at least 0: the result is blue everywhere.
 *
 *     { map: BumpMap, displacement: { map: Checker, color1: 0.5, color2: 0.5 } }
 *     An edge has the slope (0.5 - 0.5) / 0.05: flat everywhere, as is a Blend outside its
 *     items, or a map whose coordinate is scaled by 0. An image may have a single color: its
 *     texels are not read at compile time, and no warning is given. */
#include "compiler/ir/range.h"
#include "compiler/lower/lower.h"

struct Crossing {
    const Node *blend;
    Ref coordinate;
    const struct Crossing *next;
};

struct DisplacementFound {
    const Node *displacement;
    Ref slope[2];
    const struct DisplacementFound *next;
};

static const Items *items_of(const Node *blend) { return node_param(blend, P_Blend_blend)->items; }

void lower_note_crossing(Lower *l, const Node *blend, Ref coordinate)
{
    const Items *items = items_of(blend);
    if (items->count < 2 || l->job->from_buffer)
        return;
    for (int i = 0; i < items->count; i++)
        if (items->item[i].value.kind != VALUE_number ||
            (i && items->item[i].value.number[0] < items->item[i - 1].value.number[0]))
            return;
    struct Crossing *crossing = ARENA_NEW(l->session->arena, struct Crossing);
    *crossing = (struct Crossing){blend, coordinate, l->crossing};
    l->crossing = crossing;
}

static void note(Session *session, const Node *blend, Interval x)
{
    const Items *items = items_of(blend);
    const double first = items->item[0].value.number[0],
                 last = items->item[items->count - 1].value.number[0];
    const bool below = x.high <= first, above = x.low >= last;
    Text bound = text_new(session->arena), item = text_new(session->arena);
    if (!below && !above)
        return;
    text_plain(&bound, below ? x.high : x.low);
    text_plain(&item, below ? first : last);
    diag_add(session, blend->span, DIAG_unreached_items, below ? "at most" : "at least", bound.at,
             below ? "first" : "last", item.at);
}

void lower_note_bump(Lower *l, const Node *displacement, Ref by_u, Ref by_v)
{
    struct DisplacementFound *relief = ARENA_NEW(l->session->arena, struct DisplacementFound);
    *relief = (struct DisplacementFound){displacement, {by_u, by_v}, l->reliefs};
    l->reliefs = relief;
}

static bool is_nought(const Ranges *ranges, const Ir *ir, Ref slope)
{
    const Interval x = slope ? range_of(ranges, ir, slope, 0) : (Interval){0, 0};
    return x.low == 0 && x.high == 0;
}

void lower_lint(Lower *l)
{
    Arena arena = {0};
    Ref *roots = NULL;
    size_t count = 0, capacity = 0;
    for (const struct Crossing *at = l->crossing; at; at = at->next)
        ARENA_PUSH(&arena, roots, count, capacity, at->coordinate);
    for (const struct DisplacementFound *at = l->reliefs; at; at = at->next)
        for (int i = 0; i < 2; i++)
            ARENA_PUSH(&arena, roots, count, capacity, at->slope[i]);
    const Ranges ranges = range_find_below(l->ir, &arena, 1, roots, (int)count);
    for (const struct Crossing *at = l->crossing; at; at = at->next)
        note(l->session, at->blend, range_of(&ranges, l->ir, at->coordinate, 0));
    for (const struct DisplacementFound *at = l->reliefs; at; at = at->next)
        if (is_nought(&ranges, l->ir, at->slope[0]) && is_nought(&ranges, l->ir, at->slope[1]))
            diag_add(l->session, at->displacement->span, DIAG_flat_displacement);
    arena_free(&arena);
}
