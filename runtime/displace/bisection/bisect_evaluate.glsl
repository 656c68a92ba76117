// Evaluates leaves: each may have to be bisected, or may merge with its sibling into their parent.
// A fresh evaluation also fills the hash table with all leaves and the free list with free slots;
// otherwise both are valid already.
void bisectLook(uint slot)
{
    Leaf leaf = bisectLeaf(slot);
    uint at = bisectWord(LIST_FLAGS, slot), had = bisect_fresh != 0 ? 0u
        : bisect_work[at] & FLAG_LESS, flags = 0u;
    if (leaf.number == 0u) {
        if (bisect_fresh != 0)
            bisect_work[bisectWord(LIST_FREE, atomicAdd(bisect_state[FREE], 1u))] = slot;
    } else {
        if (bisect_fresh != 0)
            bisectInsert(bisectId(leaf.base, leaf.number), slot);
        Answers answers =
            bisectAnswers(Asked(slot, leaf, leaf, bisectCorners(leaf.base, leaf.number),
            (leaf.number & 1u) == 0u));
        bisectDue(slot, answers);
        if (answers.own > 0.0) {
            flags = FLAG_WANTED;
            bisect_work[bisectWord(LIST_WANTED, atomicAdd(bisect_state[WANTED], 1u))] = slot;
        } else if (answers.parent <= 0.0) {
            flags = had == 0u ? FLAG_LESS | FLAG_ASKED : FLAG_LESS;
            // a failed bisection waits for a leaf of its ring, and is tried when that leaf need not
            // be bisected any more
            if (had == 0u)
                bisect_work[bisectWord(LIST_MERGING, atomicAdd(bisect_state[MERGING], 1u))] = slot;
        }
    }
    bisect_work[at] = flags;
}

#ifdef BISECT_WIDE
// Each workgroup selects the due tiles among its own, which saves a dispatch: an empty one takes a
// GPU as long as evaluating thousands of leaves.
shared uint look_tiles[BISECT_LOOK_TILES], look_count;

void bisectStage(uint group)
{
    uint tile = BISECT_LOOK_TILES * group + gl_LocalInvocationIndex;
    if (gl_LocalInvocationIndex == 0u)
        look_count = 0u;
    memoryBarrierShared();
    barrier();
    if (gl_LocalInvocationIndex < BISECT_LOOK_TILES && bisectIsDue(tile))
        look_tiles[atomicAdd(look_count, 1u)] = tile;
    memoryBarrierBuffer();
    memoryBarrierShared();
    barrier();
    for (uint i = gl_LocalInvocationIndex; i < BISECT_TILE * look_count; i += BISECT_THREADS) {
        uint slot = BISECT_TILE * look_tiles[i / BISECT_TILE] + i % BISECT_TILE;
        if (slot < bisect_state[HIGH])
            bisectLook(slot);
    }
    if (gl_LocalInvocationIndex == 0u && look_count != 0u)
        atomicAdd(bisect_state[CHOSEN], look_count);
    barrier(); // the next tiles reset the count
}
#else
void bisectStage(uint group)
{
    uint i = bisectTask(group);
    if (i >= BISECT_TILE * bisect_state[CHOSEN])
        return;
    uint slot = BISECT_TILE * bisect_work[bisectWord(LIST_CHOSEN, i / BISECT_TILE)] +
        i % BISECT_TILE;
    if (slot < bisect_state[HIGH])
        bisectLook(slot);
}
#endif
