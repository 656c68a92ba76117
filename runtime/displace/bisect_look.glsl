// Looks at each leaf: it is to be bisected, or with its sibling to become its parent; and what there is comes into the table.
void main()
{
    uint slot = gl_GlobalInvocationID.x;
    if (slot >= bisect_work[HIGH])
        return;
    uvec2 bits = bisect_leaves[slot];
    Leaf leaf = bisectLeaf(bits);
    uint flags = 0u;
    if (leaf.number == 0u) {
        bisect_work[bisectWord(LIST_FREE, atomicAdd(bisect_work[FREE], 1u))] = slot;
    } else {
        Corners t = bisectCorners(leaf.base, leaf.number);
        bisectInsert(uvec2(bits.x, bits.y & 255u), slot);
        if (bisectWants(leaf.base, leaf.number, t, leaf.own)) {
            bisect_work[bisectWord(LIST_WANTED, atomicAdd(bisect_work[WANTED], 1u))] = slot;
        } else if ((leaf.number & 1u) == 0u &&
                   !bisectWants(leaf.base, leaf.number >> 1, bisectParent(leaf.number, t), leaf.behind)) {
            flags = FLAG_LESS;
            bisect_work[bisectWord(LIST_MERGING, atomicAdd(bisect_work[MERGING], 1u))] = slot;
        }
    }
    bisect_work[bisectWord(LIST_FLAGS, slot)] = flags;
}
