/* Blends whose coordinate never comes between their items: warnings, by the intervals of what was lowered.
 *
 *     { map: Blend, blend: [{ value: -1, input: red }, { value: 0, input: blue }], input: { map: Wood } }
 *     Wood is a distance, at least 0: it is blue everywhere. */
#include "compiler/ir/range.h"
#include "compiler/lower/lower.h"

struct Crossing {
    const Node *blend;
    Ref coordinate;
    const struct Crossing *next;
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

static void doubt(Session *session, const Node *blend, Interval x)
{
    const Items *items = items_of(blend);
    const double first = items->item[0].value.number[0], last = items->item[items->count - 1].value.number[0];
    const bool below = x.high <= first, above = x.low >= last;
    Text bound = text_new(session->arena), item = text_new(session->arena);
    if (!below && !above)
        return;
    text_plain(&bound, below ? x.high : x.low);
    text_plain(&item, below ? first : last);
    diag_add(session, blend->span, DIAG_unreached_items, below ? "at most" : "at least", bound.at,
             below ? "first" : "last", item.at);
}

void lower_doubt_crossings(Lower *l)
{
    Arena arena = {0};
    if (!l->crossing)
        return;
    const Ranges ranges = range_find(l->ir, &arena, 1);
    for (const struct Crossing *at = l->crossing; at; at = at->next)
        doubt(l->session, at->blend, range_of(&ranges, l->ir, at->coordinate, 0));
    arena_free(&arena);
}
