// Compacts the leaves: leaves in slots numbered above the leaf count move to free slots below it.
// First stage (BISECT_CHOOSE): lists the free slots below.
void main()
{
    uint i = gl_GlobalInvocationID.x, live = bisect_state[HIGH] - bisect_state[FREE];
#ifdef BISECT_CHOOSE
    if (i >= bisect_state[FREE])
        return;
    uint place = bisect_work[bisectWord(LIST_FREE, i)];
    if (place < live)
        bisect_work[bisectWord(LIST_CHOSEN, atomicAdd(bisect_state[CHOSEN], 1u))] = place;
#else
    uint from = live + i;
    if (from >= bisect_state[HIGH])
        return;
    Leaf leaf = bisectLeaf(from);
    if (leaf.number == 0u)
        return;
    uint slot = bisect_work[bisectWord(LIST_CHOSEN, atomicAdd(bisect_state[MERGING_NEXT], 1u))];
    for (uint k = 0u; k < 3u * BISECT_ROW; k++)
        bisect_rows[3u * BISECT_ROW * slot + k] = bisect_rows[3u * BISECT_ROW * from + k];
    bisectPut(slot, leaf);
    bisectPut(from, Leaf(0u, 0u, 0u, 0u));
    bisect_work[bisectWord(LIST_FLAGS, slot)] = bisect_work[bisectWord(LIST_FLAGS, from)];
    atomicMin(bisect_work[bisectWord(LIST_DUE, slot / BISECT_TILE)],
        bisect_work[bisectWord(LIST_DUE, from / BISECT_TILE)]);
    bisectInsert(bisectId(leaf.base, leaf.number), slot);
#endif
}
