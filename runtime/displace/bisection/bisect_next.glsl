// Between two stages, by one thread: lists that were written are read next, and how many groups of
// threads that takes. First leaves merge, as long as any can; then others are bisected. Steps: 0:
// leaves were looked at; 1, 3: of those to merge, to bisect some were chosen; 2, 4: and are done;
// 5: tiles were chosen. The last thread of the stage does it, since a dispatch takes a driver
// longer than a round of few triangles: whoever counts itself in as the last, after all that the
// others wrote.

// Rounds of no more triangles are for bisect_few.glsl, where it is, and are not counted.
#ifdef BISECT_WIDE
const uint FEW_MERGING = 256u, FEW_WANTED = 56u;
#else
const uint FEW_MERGING = 0u, FEW_WANTED = 0u;
#endif

// Groups of threads, for so many tasks, of which a group has so many.
void bisectSet(uint groups, uint count, uint each)
{
    bisect_head[groups] = max((count + each - 1u) / each, 1u); // one at least: its last thread goes on
    bisect_head[groups + 1u] = bisect_head[groups + 2u] = 1u;
}

void bisectNext(int step)
{
    uint chosen = bisect_head[CHOSEN];
    if (step == 5) {
        bisectSet(GROUPS, BISECT_TILE * chosen, 64u);
        return;
    }
    if (step == 0)
        bisect_head[LOOKED] = chosen;
    if (step == 1 || step == 3) {
        uint live = bisect_head[HIGH] - bisect_head[FREE];
        if (step == 3 && live + chosen > uint(bisect_room))
            bisect_head[FULL] = 1u;
        bisectSet(GROUPS_CHOSEN, bisect_head[FULL] != 0u ? 0u : chosen, step == 3 ? BISECT_SPLITS : BISECT_THREADS);
        return;
    }
    bool merging = bisect_head[MERGED_ALL] == 0u;
    if (step == 2 && merging) {
        bisect_head[MERGES] += chosen;
        bisect_head[MERGE_ROUNDS] += uint(bisect_head[MERGING] > FEW_MERGING);
        bisect_head[MERGING] = chosen == 0u ? 0u : bisect_head[MERGING_NEXT];
        bisect_head[SWAPPED] ^= 1u;
    } else if (step == 4 && !merging && bisect_head[FULL] == 0u) {
        bisect_head[FREE] = uint(max(int(bisect_head[FREE]), 0));
        bisect_head[SPLITS] += chosen;
        bisect_head[SPLIT_ROUNDS] += uint(chosen != 0u && bisect_head[WANTED] > FEW_WANTED);
        bisect_head[WANTED] = bisect_head[WANTED_NEXT];
        bisect_head[SWAPPED] ^= 1u;
    }
    if (merging && bisect_head[MERGING] == 0u) {
        bisect_head[MERGED_ALL] = 1u;
        bisect_head[SWAPPED] = 0u; // wanted leaves are in the first of their lists still
    }
    bisect_head[CHOSEN] = bisect_head[MERGING_NEXT] = bisect_head[WANTED_NEXT] = 0u;
    bisectSet(GROUPS, bisect_head[FULL] != 0u ? 0u : bisect_head[bisect_head[MERGED_ALL] != 0u ? WANTED : MERGING], 64u);
}

#ifndef BISECT_FEW
// For how many groups there are tasks.
uint bisectGroups()
{
#if BISECT_STEP == 0
    return gl_NumWorkGroups.x;
#else
    return bisect_head[BISECT_STEP == 2 || BISECT_STEP == 4 ? GROUPS_CHOSEN : GROUPS];
#endif
}

void main()
{
#ifdef BISECT_WIDE
    // As many groups as the device runs at once, whatever there is to do: it waits longer for their
    // number than for those that have nothing to do.
    uint groups = bisectGroups();
    for (uint group = gl_WorkGroupID.x; group < groups; group += gl_NumWorkGroups.x)
        BISECT_STAGE(group);
    memoryBarrierBuffer();
    barrier();
    bool last = gl_LocalInvocationIndex == 0u && atomicAdd(bisect_head[DONE], 1u) == gl_NumWorkGroups.x - 1u;
#else
    BISECT_STAGE(gl_WorkGroupID.x);
    memoryBarrierBuffer();
    bool last = atomicAdd(bisect_head[DONE], 1u) == 64u * gl_NumWorkGroups.x - 1u;
#endif
    memoryBarrierBuffer();
    if (last) {
        bisect_head[DONE] = 0u;
        bisectNext(BISECT_STEP);
    }
}
#endif
