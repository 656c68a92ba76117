// Which leaves are bisected now: all at an edge together, and only those of whom each has it as the edge that is bisected. Where one has not, that one comes first, and so on; what was asked for waits.
void bisectStage(uint group)
{
    uint i = bisectTask(group), swapped = bisect_work[SWAPPED];
    if (i >= bisect_work[WANTED] || bisect_work[MERGED_ALL] == 0u)
        return;
    uint slot = bisect_work[bisectWord(LIST_WANTED + swapped, i)], at = slot;
    Leaf leaf = bisectLeaf(slot);
    if (leaf.number == 0u || (bisect_work[bisectWord(LIST_FLAGS, slot)] & FLAG_WANTED) == 0u)
        return;
    for (;;) {
        Ring ring = bisectRing(leaf.base, leaf.number, bisectCorners(leaf.base, leaf.number));
        uint least = at, before = BISECT_NONE;
        for (uint n = 0u; n < ring.count && before == BISECT_NONE; n++) {
            uint base = leaf.base, number;
            bisectMember(ring, n, base, number);
            uint found = bisectFind(base, number);
            if (found == BISECT_NONE)
                before = bisectFind(base, number >> 1);
            if (found == BISECT_NONE && before == BISECT_NONE) {
                bisect_work[LOST] = 1u;
                return;
            }
            least = min(least, found);
        }
        if (before == BISECT_NONE) {
            if ((atomicOr(bisect_work[bisectWord(LIST_FLAGS, least)], FLAG_CHOSEN) & FLAG_CHOSEN) == 0u) {
                bool alone = true;
                for (uint n = 0u; n < ring.count; n++) {
                    uint base = leaf.base, number;
                    bisectMember(ring, n, base, number);
                    uint found = bisectFind(base, number);
                    alone = alone && found != at;
                    bisect_work[bisectWord(LIST_CHOSEN, atomicAdd(bisect_work[CHOSEN], 1u))] = found;
                }
                if (alone)
                    bisect_work[bisectWord(LIST_CHOSEN, atomicAdd(bisect_work[CHOSEN], 1u))] = at;
            }
            break;
        }
        at = before;
        leaf = bisectLeaf(at);
    }
    if (at != slot)
        bisect_work[bisectWord(LIST_WANTED + 1u - swapped, atomicAdd(bisect_work[WANTED_NEXT], 1u))] = slot;
}
