// Leaves become their parents: all that have one middle of an edge as their newest corner, if none of these has other leaves, or has to be bisected. First stage: who can, of those that may.
#ifdef BISECT_CHOOSE
// Both children of it are leaves, and it need not be bisected.
bool bisectMay(uint base, uint number)
{
    uint first = bisectFind(base, 2u * number);
    return first != BISECT_NONE && (bisect_work[bisectWord(LIST_FLAGS, first)] & FLAG_LESS) != 0u &&
           bisectFind(base, 2u * number + 1u) != BISECT_NONE;
}

// Once, whoever says so.
void bisectTake(uint slot)
{
    if ((atomicOr(bisect_work[bisectWord(LIST_FLAGS, slot)], FLAG_CHOSEN) & FLAG_CHOSEN) == 0u)
        bisect_work[bisectWord(LIST_CHOSEN, atomicAdd(bisect_work[CHOSEN], 1u))] = slot;
}

// Who cannot leaves the list. It is asked again when another of its ring has become a leaf, and else never.
void bisectStage(uint group)
{
    uint i = bisectTask(group), swapped = bisect_work[SWAPPED];
    if (i >= bisect_work[MERGING])
        return;
    uint slot = bisect_work[bisectWord(LIST_MERGING + swapped, i)];
    Leaf leaf = bisectLeaf(slot);
    uint number = leaf.number >> 1;
    Ring ring = bisectRing(leaf.base, number, bisectParent(leaf.number, bisectCorners(leaf.base, leaf.number)));
    bool may = bisectMay(leaf.base, number);
    for (uint n = 0u; n < ring.count && may; n++) {
        uint base = leaf.base, other;
        bisectMember(ring, n, base, other);
        may = bisectMay(base, other);
    }
    atomicAnd(bisect_work[bisectWord(LIST_FLAGS, slot)], ~FLAG_ASKED);
    if (!may)
        return;
    bisectTake(slot);
    for (uint n = 0u; n < ring.count; n++) { // who has waited is in no list
        uint base = leaf.base, other;
        bisectMember(ring, n, base, other);
        bisectTake(bisectFind(base, 2u * other));
    }
}
#else
// Second stage, of each that can: its first child's place is its own from now on, and its second child's is free.
void bisectAsk(uint slot)
{
    bisect_work[bisectWord(LIST_MERGING + 1u - bisect_work[SWAPPED], atomicAdd(bisect_work[MERGING_NEXT], 1u))] = slot;
}

// That triangle's first child, where it is a leaf that waits for others, is asked next; once, whoever says so.
void bisectAskAgain(uint base, uint number)
{
    uint first = bisectFind(base, 2u * number);
    if (first == BISECT_NONE || (bisect_work[bisectWord(LIST_FLAGS, first)] & FLAG_LESS) == 0u)
        return;
    if ((atomicOr(bisect_work[bisectWord(LIST_FLAGS, first)], FLAG_ASKED) & FLAG_ASKED) == 0u)
        bisectAsk(first);
}

void bisectStage(uint group)
{
    uint i = bisectTask(group);
    if (i >= bisect_work[CHOSEN])
        return;
    uint slot = bisect_work[bisectWord(LIST_CHOSEN, i)];
    Leaf leaf = bisectLeaf(slot);
    uint other = bisectFind(leaf.base, leaf.number + 1u);
    leaf = Leaf(leaf.base, leaf.number >> 1, leaf.behind, bisectLeaf(other).behind);
    for (uint k = 0u; k < BISECT_ROW; k++) { // (c, a, m) and (b, c, m) to (a, b, c)
        uint at = 3u * BISECT_ROW * slot + k, from = 3u * BISECT_ROW * other + k;
        float c = bisect_rows[at];
        bisect_rows[at] = bisect_rows[at + BISECT_ROW];
        bisect_rows[at + BISECT_ROW] = bisect_rows[from];
        bisect_rows[at + 2u * BISECT_ROW] = c;
        bisect_rows[from + BISECT_ROW] = bisect_rows[from + 2u * BISECT_ROW] = bisect_rows[from]; // it has no area
    }
    Corners t = bisectCorners(leaf.base, leaf.number), parent = bisectParent(leaf.number, t);
    BisectBase at = bisectBase(leaf.base);
    bool even = (leaf.number & 1u) == 0u;
    float wants = even ? bisectWants(at, leaf.base, leaf.number >> 1, parent, leaf.behind) : BISECT_SURE;
    bool less = wants <= 0.0;
    bisectDue(slot, min(abs(bisectWants(at, leaf.base, leaf.number, t, leaf.own)), abs(wants)));
    bisectPut(slot, leaf);
    bisectPut(other, Leaf(0u, 0u, 0u, 0u));
    bisect_work[bisectWord(LIST_FLAGS, slot)] = less ? FLAG_LESS | FLAG_ASKED : 0u;
    bisect_work[bisectWord(LIST_FLAGS, other)] = 0u;
    bisect_work[bisectWord(LIST_FREE, atomicAdd(bisect_work[FREE], 1u))] = other;
    memoryBarrierBuffer(); // who finds it has its flags
    bisectInsert(bisectId(leaf.base, leaf.number), slot);
    if (less)
        bisectAsk(slot);
    if (leaf.number == 1u || (even && !less))
        return; // nobody waits for it: its ring stays
    bisectAskAgain(leaf.base, leaf.number >> 1);
    Ring ring = bisectRing(leaf.base, leaf.number >> 1, parent);
    for (uint n = 0u; n < ring.count; n++) {
        uint base = leaf.base, number;
        bisectMember(ring, n, base, number);
        bisectAskAgain(base, number);
    }
}
#endif
