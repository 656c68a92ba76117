// Which leaves are bisected now: all at an edge together, and only those of whom each has it as the
// edge that is bisected. Where one has not, that one comes first, and is wanted from now on: so it
// asks for whom it needs itself, and what asked for it waits.

// Whether the leaf's whole ring is there; else who of it has to be bisected first, BISECT_NONE
// where that is nobody. `least` is the first place of all.
bool bisectComplete(uint slot, Leaf leaf, Ring ring, out uint least, out uint before)
{
    least = slot;
    before = BISECT_NONE;
    for (uint n = 0u; n < ring.count; n++) {
        uint base = leaf.base, number;
        bisectMember(ring, n, base, number);
        uint found = bisectFind(base, number);
        if (found == BISECT_NONE) {
            before = bisectFind(base, number >> 1);
            return false;
        }
        least = min(least, found);
    }
    return true;
}

// Once, whoever of the ring says so.
void bisectTakeRing(uint slot, Leaf leaf, Ring ring, uint least)
{
    if ((atomicOr(bisect_work[bisectWord(LIST_FLAGS, least)], FLAG_CHOSEN) & FLAG_CHOSEN) != 0u)
        return;
    bool alone = true;
    for (uint n = 0u; n < ring.count; n++) {
        uint base = leaf.base, number;
        bisectMember(ring, n, base, number);
        uint found = bisectFind(base, number);
        alone = alone && found != slot;
        bisect_work[bisectWord(LIST_CHOSEN, atomicAdd(bisect_head[CHOSEN], 1u))] = found;
    }
    if (alone)
        bisect_work[bisectWord(LIST_CHOSEN, atomicAdd(bisect_head[CHOSEN], 1u))] = slot;
}

void bisectWantNext(uint slot)
{
    bisect_work[bisectWord(LIST_WANTED + 1u - bisect_head[SWAPPED], atomicAdd(bisect_head[WANTED_NEXT], 1u))] = slot;
}

void bisectChoose(uint group)
{
    uint i = bisectTask(group);
    if (i >= bisect_head[WANTED] || bisect_head[MERGED_ALL] == 0u)
        return;
    uint slot = bisect_work[bisectWord(LIST_WANTED + bisect_head[SWAPPED], i)];
    Leaf leaf = bisectLeaf(slot);
    if (leaf.number == 0u || (bisect_work[bisectWord(LIST_FLAGS, slot)] & FLAG_WANTED) == 0u)
        return;
    for (;;) {
        uint least, before;
        Ring ring = bisectRing(leaf.base, leaf.number, bisectCorners(leaf.base, leaf.number));
        if (bisectComplete(slot, leaf, ring, least, before)) {
            bisectTakeRing(slot, leaf, ring, least);
            return;
        }
        if (before == BISECT_NONE) {
            bisect_head[LOST] = 1u;
            return;
        }
        bisectWantNext(slot);
        if ((atomicOr(bisect_work[bisectWord(LIST_FLAGS, before)], FLAG_WANTED) & FLAG_WANTED) != 0u)
            return;
        slot = before;
        leaf = bisectLeaf(slot);
    }
}
