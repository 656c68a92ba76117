/* Which slots materials have together: sets of slots with the number of materials that have just
 * these. There is room for so many; those with the most slots stay, since small ones are the
 * likeliest to lie within another, and the rest become one. What stays are the first ones of all
 * that ever came, so that the order in which they come is of no account. */
#include "compiler/layout/auto_layout.h"
#include <string.h>

static int slot_count(unsigned slots) { return __builtin_popcount(slots); }

/* More slots first, then the smaller number. */
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
