/* Pareto front of a list, and choice of a variant from a list. */
#include "runtime/autotune/autotune.h"
#include <math.h>

/* Returns whether a dominates b. Less than 1% more precision does not justify a slower variant. */
static bool beats(const FrontPoint *a, const FrontPoint *b)
{
    const double alike = 1.01;
    return a->time <= b->time && a->error <= alike * b->error &&
           (a->time < b->time || a->error < b->error);
}

void front_mark(FrontPoint *points, int count)
{
    for (int i = 0; i < count; i++) {
        points[i].front = !isnan(points[i].time) && !isnan(points[i].error);
        for (int k = 0; k < count && points[i].front; k++)
            points[i].front = !beats(&points[k], &points[i]);
    }
}

static bool holds_as_much(const Measured *candidate, const Measured *first)
{
    for (int slot = 0; slot < SLOT_COUNT; slot++)
        if (isnan(candidate->packed[slot].maximum) && !isnan(first->packed[slot].maximum))
            return false;
    return true;
}

int autotune_choose(const MeasuredList *list, double most, int *best)
{
    int chosen = -1;
    *best = -1;
    for (int i = 0; i < list->count; i++) {
        const Measured *m = &list->at[i];
        if (!holds_as_much(m, &list->at[0]))
            continue;
        if (*best < 0 || m->error < list->at[*best].error)
            *best = i;
        if (m->error <= most && (chosen < 0 || m->nanoseconds < list->at[chosen].nanoseconds))
            chosen = i;
    }
    return chosen;
}
