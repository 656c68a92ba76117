// Looks at leaves: each is to be bisected, or with its sibling to become its parent. A fresh look
// puts what there is into the table, and places that are free into their list; else both are there.
void bisectLook(uint slot)
{
    Leaf leaf = bisectLeaf(slot);
    uint at = bisectWord(LIST_FLAGS, slot), had = bisect_fresh != 0 ? 0u : bisect_work[at] & FLAG_LESS, flags = 0u;
    if (leaf.number == 0u) {
        if (bisect_fresh != 0)
            bisect_work[bisectWord(LIST_FREE, atomicAdd(bisect_head[FREE], 1u))] = slot;
    } else {
        if (bisect_fresh != 0)
            bisectInsert(bisectId(leaf.base, leaf.number), slot);
        Answers answers = bisectAnswers(Asked(slot, leaf, leaf, bisectCorners(leaf.base, leaf.number), (leaf.number & 1u) == 0u));
        bisectDue(slot, answers);
        if (answers.own > 0.0) {
            flags = FLAG_WANTED;
            bisect_work[bisectWord(LIST_WANTED, atomicAdd(bisect_head[WANTED], 1u))] = slot;
        } else if (answers.parent <= 0.0) {
            flags = had == 0u ? FLAG_LESS | FLAG_ASKED : FLAG_LESS;
            if (had == 0u) // else it waits for one of its ring, which is asked when it need not be bisected any more
                bisect_work[bisectWord(LIST_MERGING, atomicAdd(bisect_head[MERGING], 1u))] = slot;
        }
    }
    bisect_work[at] = flags;
}

#ifdef BISECT_WIDE
// A group chooses of its own tiles, a stage less: an empty one takes a device as long as it takes
// to look at thousands.
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
        if (slot < bisect_head[HIGH])
            bisectLook(slot);
    }
    if (gl_LocalInvocationIndex == 0u && look_count != 0u)
        atomicAdd(bisect_head[CHOSEN], look_count);
    barrier(); // the count is begun anew by who goes on
}
#else
void bisectStage(uint group)
{
    uint i = bisectTask(group);
    if (i >= BISECT_TILE * bisect_head[CHOSEN])
        return;
    uint slot = BISECT_TILE * bisect_work[bisectWord(LIST_CHOSEN, i / BISECT_TILE)] + i % BISECT_TILE;
    if (slot < bisect_head[HIGH])
        bisectLook(slot);
}
#endif
