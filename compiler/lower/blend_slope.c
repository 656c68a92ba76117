/* Slopes of Blends at a point. The weights of both segments that meet at an item have a kink
 * there, and by rounding one segment may end after the next has begun. So each segment's slope
 * counts from its item on, below the next item's value, as the walk and the search decide.
 *
 *     items at 0, .3 and 1 with values a, b, c; with s = clamp(t / .3), r = clamp((t - .3) / .7)
 *     within:  da (1 - s) + db (s - r) + dc r
 *     along t: ((b - a) / .3 (0 <= t and t < .3) + (c - b) / .7 (.3 <= t and t <= 1)) dt */
#include "compiler/lower/area.h"
#include "compiler/lower/blend.h"
#include "compiler/lower/slope.h"
#include <string.h>

static bool is_same(const Blended *a, const Blended *b)
{
    return a->t == b->t && a->count == b->count &&
           !memcmp(a->stops, b->stops, sizeof *a->stops * (size_t)a->count);
}

/* Returns true if `value` was made from the items and t, and is not one of them. */
static bool is_new(Ref value, const Blended *blend)
{
    for (int i = 0; i < blend->count; i++)
        if (value <= blend->within[i].result)
            return false;
    return value > blend->t;
}

/* Returns 1 where t is in the segment that ends at item i, else 0. The last segment includes its
 * end (lower_blend.c, is_below). */
static Ref is_along(Lower *l, const Blended *blend, int i)
{
    Ir *ir = l->ir;
    const Stop *stops = blend->stops;
    Ref begun = build_step(ir, stops[i - 1].value, blend->t);
    return i == blend->count - 1 ? build_mul(ir, begun, build_step(ir, blend->t, stops[i].value))
                                 : build_sub(ir, begun, build_step(ir, stops[i].value, blend->t));
}

/* Returns the Blend's derivative by t. Exactly at an item, the slope of the adjacent segment
 * counts. */
static Ref rate(Lower *l, const Blended *blend)
{
    Ir *ir = l->ir;
    const bool has_guards = blend->within != blend->stops;
    const Stop *stops = has_guards
                            ? blend_guarded_items(l, blend->t, blend->stops, blend->count, true)
                            : blend->stops;
    Ref sum = 0;
    for (int i = 1; i < blend->count; i++) {
        const Stop *from = &stops[i - 1], *to = &stops[i];
        if (from->result == to->result)
            continue;
        Ref rise = build_mul(ir, build_sub(ir, to->result, from->result),
                             area_known_inverse(l, from->value, to->value));
        sum = build_plus(ir, sum, build_mul(ir, rise, is_along(l, blend, i)));
    }
    return sum;
}

static const SlopeTerm *terms(Lower *l, const void *what)
{
    const Blended *blend = what;
    Ir *ir = l->ir;
    SlopeTerm *term = ARENA_ARRAY(l->session->arena, SlopeTerm, blend->count + 1);
    Ref share = build_float(ir, 1);
    for (int i = 0; i < blend->count; i++) {
        Ref next = i + 1 < blend->count ? blend_share(l, blend->t, &blend->stops[i]) : 0;
        term[i + 1] =
            (SlopeTerm){blend->within[i].result, next ? build_sub(ir, share, next) : share};
        share = next;
    }
    term[0] = (SlopeTerm){blend->t, rate(l, blend)};
    return term;
}

bool blend_note(Lower *l, Ref value, const Blended *blend)
{
    if (ir_is(l->ir, blend->t, OP_const) || !is_new(value, blend))
        return true;
    const Blended *kept = memcpy(ARENA_NEW(l->session->arena, Blended), blend, sizeof *blend);
    const Blended *before = slope_set_sum(l, value, terms, kept, blend->count + 1);
    return !before || is_same(before, blend);
}
