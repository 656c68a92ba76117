/* Slot sets of materials: sets of slots with the number of materials that use exactly these
 * slots. The capacity is limited: the sets with the most slots stay, since small sets are most
 * likely contained in others, and the rest are merged into one. The kept sets are the first of
 * all sets ever added in a fixed order, so the result does not depend on the order of insertion. */
#include "compiler/layout/auto_layout.h"
#include <string.h>

static int slot_count(unsigned slots) { return __builtin_popcount(slots); }

/* Orders sets by decreasing number of slots, then by value. */
static bool comes_before(unsigned a, unsigned b)
{
    return slot_count(a) != slot_count(b) ? slot_count(a) > slot_count(b) : a < b;
}

static void add_other(MatcSlotSet *others, MatcSlotSet set)
{
    others->slots |= set.slots;
    others->materials += set.materials;
}

void auto_sets_add(MatcRanges *ranges, MatcSlotSet set)
{
    MatcSlotSet *at = ranges->sets, *end = ranges->sets + ranges->set_count;
    while (at < end && comes_before(at->slots, set.slots))
        at++;
    if (at < end && at->slots == set.slots) {
        at->materials += set.materials;
        return;
    }
    if (at == ranges->sets + MATC_SETS) {
        add_other(&ranges->others, set);
        return;
    }
    if (ranges->set_count == MATC_SETS)
        add_other(&ranges->others, *--end);
    else
        ranges->set_count++;
    memmove(at + 1, at, (size_t)(end - at) * sizeof *at);
    *at = set;
}

void auto_sets_join(MatcRanges *ranges, const MatcRanges *other)
{
    for (int i = 0; i < other->set_count; i++)
        auto_sets_add(ranges, other->sets[i]);
    add_other(&ranges->others, other->others);
}
