// Leaves become their parents: all that have one middle of an edge as their newest corner, if none of these has other leaves, or has to be bisected. First stage: who can, of those that may.
#ifdef BISECT_CHOOSE
// Both children of it are leaves, and it need not be bisected: now; or never, as its first child is a leaf and it has to be; or perhaps when leaves below have merged.
const int NOW = 0, LATER = 1, NEVER = 2;

int bisectMay(uint base, uint number)
{
    uint first = bisectFind(base, 2u * number);
    if (first == BISECT_NONE)
        return LATER;
    if ((bisect_work[bisectWord(LIST_FLAGS, first)] & FLAG_LESS) == 0u)
        return NEVER;
    return bisectFind(base, 2u * number + 1u) != BISECT_NONE ? NOW : LATER;
}

// Who can never, since one of its ring has to be bisected, leaves the list: most of those that are there only so that the mesh conforms.
void bisectStage()
{
    uint i = gl_GlobalInvocationID.x, swapped = bisect_work[SWAPPED];
    if (i >= bisect_work[MERGING])
        return;
    uint slot = bisect_work[bisectWord(LIST_MERGING + swapped, i)];
    Leaf leaf = bisectLeaf(bisect_leaves[slot]);
    uint number = leaf.number >> 1;
    Ring ring = bisectRing(leaf.base, number, bisectParent(leaf.number, bisectCorners(leaf.base, leaf.number)));
    int may = bisectMay(leaf.base, number);
    for (uint n = 0u; n < ring.count && may != NEVER; n++) {
        uint base = leaf.base, other;
        bisectMember(ring, n, base, other);
        may = max(may, bisectMay(base, other));
    }
    if (may == NOW)
        bisect_work[bisectWord(LIST_CHOSEN, atomicAdd(bisect_work[CHOSEN], 1u))] = slot;
    else if (may == LATER)
        bisect_work[bisectWord(LIST_MERGING + 1u - swapped, atomicAdd(bisect_work[MERGING_NEXT], 1u))] = slot;
}
#else
// Second stage, of each that can: its first child's place is its own from now on, and its second child's is free.
void bisectStage()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= bisect_work[CHOSEN])
        return;
    uint slot = bisect_work[bisectWord(LIST_CHOSEN, i)];
    Leaf leaf = bisectLeaf(bisect_leaves[slot]);
    uint other = bisectFind(leaf.base, leaf.number + 1u);
    leaf = Leaf(leaf.base, leaf.number >> 1, leaf.behind, bisectLeaf(bisect_leaves[other]).behind);
    for (uint k = 0u; k < BISECT_ROW; k++) { // (c, a, m) and (b, c, m) to (a, b, c)
        uint at = 3u * BISECT_ROW * slot + k, from = 3u * BISECT_ROW * other + k;
        float c = bisect_rows[at];
        bisect_rows[at] = bisect_rows[at + BISECT_ROW];
        bisect_rows[at + BISECT_ROW] = bisect_rows[from];
        bisect_rows[at + 2u * BISECT_ROW] = c;
        bisect_rows[from + BISECT_ROW] = bisect_rows[from + 2u * BISECT_ROW] = bisect_rows[from]; // it has no area
    }
    bisect_leaves[slot] = bisectPack(leaf);
    bisect_leaves[other] = uvec2(0u);
    bisect_work[bisectWord(LIST_FREE, atomicAdd(bisect_work[FREE], 1u))] = other;
    bisectInsert(bisectId(leaf.base, leaf.number), slot);
    uint flags = FLAG_MERGED;
    if (leaf.number > 1u && (leaf.number & 1u) == 0u &&
        !bisectWants(leaf.base, leaf.number >> 1, bisectParent(leaf.number, bisectCorners(leaf.base, leaf.number)), leaf.behind)) {
        flags |= FLAG_LESS;
        bisect_work[bisectWord(LIST_MERGING + 1u - bisect_work[SWAPPED], atomicAdd(bisect_work[MERGING_NEXT], 1u))] = slot;
    }
    bisect_work[bisectWord(LIST_FLAGS, slot)] = flags;
    bisect_work[bisectWord(LIST_FLAGS, other)] = FLAG_MERGED;
}
#endif
