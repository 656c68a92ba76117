// Merges leaves into their parents: all leaves around the midpoint of an edge that is their newest
// corner, if their parents have no other leaves and need not be bisected. First stage: chooses
// among the leaves that may merge. A parent may merge if both children are leaves and it need not
// be bisected.
bool bisectMay(uint base, uint number, out uvec2 children)
{
    children = bisectFindChildren(base, number);
    return children.x != BISECT_NONE && children.y != BISECT_NONE &&
        (bisect_work[bisectWord(LIST_FLAGS, children.x)] & FLAG_LESS) != 0u;
}

// Chooses a pair of children once, whichever leaf comes first. The slot of the second child is
// stored in a list that is unused until leaves are bisected.
void bisectTake(uvec2 children)
{
    if ((atomicOr(bisect_work[bisectWord(LIST_FLAGS, children.x)],
        FLAG_CHOSEN) & FLAG_CHOSEN) != 0u)
        return;
    uint i = atomicAdd(bisect_state[CHOSEN], 1u);
    bisect_work[bisectWord(LIST_CHOSEN, i)] = children.x;
    bisect_work[bisectWord(LIST_WANTED + 1u, i)] = children.y;
}

// Chooses pairs of leaves to merge. Leaves that cannot merge leave the list. They are tried again
// only when another triangle of their ring has become a leaf.
void bisectMergeChoose(uint group)
{
    uint i = bisectTask(group), swapped = bisect_state[SWAPPED];
    if (i >= bisect_state[MERGING])
        return;
    uint slot = bisect_work[bisectWord(LIST_MERGING + swapped, i)];
    Leaf leaf = bisectLeaf(slot);
    uint number = leaf.number >> 1;
    uvec2 own, children;
    Ring ring = bisectRing(leaf.base, number,
        bisectParent(leaf.number, bisectCorners(leaf.base, leaf.number)));
    bool may = bisectMay(leaf.base, number, own);
    for (uint n = 0u; n < ring.count && may; n++) {
        uint base = leaf.base, other;
        bisectMember(ring, n, base, other);
        may = bisectMay(base, other, children);
    }
    atomicAnd(bisect_work[bisectWord(LIST_FLAGS, slot)], ~FLAG_ASKED);
    if (!may)
        return;
    bisectTake(own);
    if (ring.count == 1u)
        bisectTake(children); // a waiting leaf is in no list
    for (uint n = 0u; n < ring.count && ring.count != 1u; n++) {
        uint base = leaf.base, other;
        bisectMember(ring, n, base, other);
        bisectTake(bisectFindChildren(base, other));
    }
}

// Second stage, for each chosen pair: the parent takes the first child's slot, and the second
// child's slot becomes free. Puts a leaf into the next round's list of merges.
void bisectAsk(uint slot)
{
    bisect_work[bisectWord(LIST_MERGING + 1u - bisect_state[SWAPPED],
        atomicAdd(bisect_state[MERGING_NEXT], 1u))] = slot;
}

// Puts a triangle's first child into the next round's list if it is a leaf that waits for its ring;
// only once, whichever thread comes first.
void bisectAskAgain(uint base, uint number)
{
    uint first = bisectFind(base, 2u * number);
    if (first == BISECT_NONE || (bisect_work[bisectWord(LIST_FLAGS, first)] & FLAG_LESS) == 0u)
        return;
    if ((atomicOr(bisect_work[bisectWord(LIST_FLAGS, first)], FLAG_ASKED) & FLAG_ASKED) == 0u)
        bisectAsk(first);
}

// Merges rows: (c, a, m) and (b, c, m) become (a, b, c), and a freed slot without area. Reads
// everything first, since alternating reads and writes would wait for each.
void bisectMergeRows(uint at, uint from)
{
    float rows[3u * BISECT_ROW];
    for (uint k = 0u; k < BISECT_ROW; k++) {
        rows[k] = bisect_rows[at + BISECT_ROW + k];
        rows[BISECT_ROW + k] = bisect_rows[from + k];
        rows[2u * BISECT_ROW + k] = bisect_rows[at + k];
    }
    for (uint k = 0u; k < 3u * BISECT_ROW; k++)
        bisect_rows[at + k] = rows[k];
    for (uint k = 0u; k < 3u; k++)
        bisect_rows[from + BISECT_ROW + k] = bisect_rows[from + 2u * BISECT_ROW + k] =
            rows[BISECT_ROW + k];
}

void bisectMergeBegin(uint i, out Asked a)
{
    uint slot = bisect_work[bisectWord(LIST_CHOSEN, i)],
        other = bisect_work[bisectWord(LIST_WANTED + 1u, i)];
    Leaf first = bisectLeaf(slot), second = bisectLeaf(other);
    Leaf leaf = Leaf(first.base, first.number >> 1, first.behind, second.behind);
    a = Asked(slot, first, leaf, bisectCorners(leaf.base, leaf.number), (leaf.number & 1u) == 0u);
    bisectMergeRows(3u * BISECT_ROW * slot, 3u * BISECT_ROW * other);
    bisectReplace(other, second, Leaf(0u, 0u, 0u, 0u));
    bisect_work[bisectWord(LIST_FLAGS, other)] = 0u;
    bisect_work[bisectWord(LIST_FREE, atomicAdd(bisect_state[FREE], 1u))] = other;
}

void bisectMergeEnd(Asked a, Answers answers)
{
    Leaf leaf = a.leaf;
    bool less = answers.parent <= 0.0;
    bisectReplace(a.slot, a.had, leaf);
    bisect_work[bisectWord(LIST_FLAGS, a.slot)] = less ? FLAG_LESS | FLAG_ASKED : 0u;
    bisectFence(); // flags are visible before the table entry
    bisectInsert(bisectId(leaf.base, leaf.number), a.slot);
    if (less)
        bisectAsk(a.slot);
    if (leaf.number == 1u || (a.even && !less))
        return; // no leaf waits for a merge: the ring is unchanged
    bisectAskAgain(leaf.base, leaf.number >> 1);
    Ring ring = bisectRing(leaf.base, leaf.number >> 1,
        bisectParent(leaf.number, bisectCorners(leaf.base, leaf.number)));
    for (uint n = 0u; n < ring.count; n++) {
        uint base = leaf.base, number;
        bisectMember(ring, n, base, number);
        bisectAskAgain(base, number);
    }
}

#ifndef BISECT_FEW
void bisectMerge(uint group)
{
    if (bisectTask(group) >= bisect_state[CHOSEN])
        return;
    Asked a;
    bisectMergeBegin(bisectTask(group), a);
    Answers answers = bisectAnswers(a);
    bisectDue(a.slot, answers);
    bisectMergeEnd(a, answers);
}
#endif
