// Chooses the leaves to bisect now: all leaves at an edge together, if the edge is the bisected
// edge of each. If one leaf at the edge is coarser, it has to be bisected first: it joins the
// wanted leaves, which requests its own neighbors, and the leaf that requested it waits.

// Returns true if the leaf's whole ring consists of leaves. Otherwise `before` is the leaf that has
// to be bisected first, BISECT_NONE if it is missing. `least` is the least slot of the ring.
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

// Chooses the ring once, whichever of its leaves comes first.
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
        bisect_work[bisectWord(LIST_CHOSEN, atomicAdd(bisect_state[CHOSEN], 1u))] = found;
    }
    if (alone)
        bisect_work[bisectWord(LIST_CHOSEN, atomicAdd(bisect_state[CHOSEN], 1u))] = slot;
}

void bisectWantNext(uint slot)
{
    bisect_work[bisectWord(LIST_WANTED + 1u - bisect_state[SWAPPED],
        atomicAdd(bisect_state[WANTED_NEXT], 1u))] = slot;
}

void bisectChoose(uint group)
{
    uint i = bisectTask(group);
    if (i >= bisect_state[WANTED] || bisect_state[MERGED_ALL] == 0u)
        return;
    uint slot = bisect_work[bisectWord(LIST_WANTED + bisect_state[SWAPPED], i)];
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
            bisect_state[LOST] = 1u;
            return;
        }
        bisectWantNext(slot);
        if ((atomicOr(bisect_work[bisectWord(LIST_FLAGS, before)],
            FLAG_WANTED) & FLAG_WANTED) != 0u)
            return;
        slot = before;
        leaf = bisectLeaf(slot);
    }
}
