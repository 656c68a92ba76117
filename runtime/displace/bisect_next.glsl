// Between two stages, by one thread: lists that were written are read next, and how many groups of threads that takes. First leaves merge, as long as any can; then others are bisected.
// BISECT_STEP: 0: leaves were looked at; 1, 3: of those to merge, to bisect some were chosen; 2, 4: and are done; 5: tiles were chosen. The last thread of the stage does it,
// since a dispatch takes a driver longer than a round of few triangles: whoever counts itself in as the last, after all that the others wrote.

// Groups of threads, for so many tasks, of which a group has so many.
void bisectSet(uint groups, uint count, uint each)
{
    bisect_work[groups] = max((count + each - 1u) / each, 1u); // one at least: its last thread goes on
    bisect_work[groups + 1u] = bisect_work[groups + 2u] = 1u;
}

void bisectNext()
{
    uint chosen = bisect_work[CHOSEN];
    if (BISECT_STEP == 5) {
        bisectSet(GROUPS, BISECT_TILE * chosen, 64u);
        return;
    }
    if (BISECT_STEP == 0)
        bisect_work[LOOKED] = chosen;
    if (BISECT_STEP == 1 || BISECT_STEP == 3) {
        uint live = bisect_work[HIGH] - bisect_work[FREE];
        if (BISECT_STEP == 3 && live + chosen > uint(bisect_room))
            bisect_work[FULL] = 1u;
        bisectSet(GROUPS_CHOSEN, bisect_work[FULL] != 0u ? 0u : chosen, BISECT_STEP == 3 ? BISECT_SPLITS : 64u);
        return;
    }
    bool merging = bisect_work[MERGED_ALL] == 0u;
    if (BISECT_STEP == 2 && merging) {
        bisect_work[MERGES] += chosen;
        bisect_work[MERGE_ROUNDS]++;
        bisect_work[MERGING] = chosen == 0u ? 0u : bisect_work[MERGING_NEXT];
        bisect_work[SWAPPED] ^= 1u;
    } else if (BISECT_STEP == 4 && !merging && bisect_work[FULL] == 0u) {
        bisect_work[FREE] = uint(max(int(bisect_work[FREE]), 0));
        bisect_work[SPLITS] += chosen;
        bisect_work[SPLIT_ROUNDS] += uint(chosen != 0u);
        bisect_work[WANTED] = bisect_work[WANTED_NEXT];
        bisect_work[SWAPPED] ^= 1u;
    }
    if (merging && bisect_work[MERGING] == 0u) {
        bisect_work[MERGED_ALL] = 1u;
        bisect_work[SWAPPED] = 0u; // wanted leaves are in the first of their lists still
    }
    bisect_work[CHOSEN] = bisect_work[MERGING_NEXT] = bisect_work[WANTED_NEXT] = 0u;
    bisectSet(GROUPS, bisect_work[FULL] != 0u ? 0u : bisect_work[bisect_work[MERGED_ALL] != 0u ? WANTED : MERGING], 64u);
}

// For how many groups there are tasks.
uint bisectGroups()
{
#if BISECT_STEP == 5
    return (bisect_work[HIGH] + 64u * BISECT_TILE - 1u) / (64u * BISECT_TILE);
#else
    return bisect_work[BISECT_STEP == 2 || BISECT_STEP == 4 ? GROUPS_CHOSEN : GROUPS];
#endif
}

void main()
{
#ifdef BISECT_WIDE
    // As many groups as the device runs at once, whatever there is to do: it waits longer for their number than for those that have nothing to do.
    uint groups = bisectGroups();
    for (uint group = gl_WorkGroupID.x; group < groups; group += gl_NumWorkGroups.x)
        bisectStage(group);
    memoryBarrierBuffer();
    barrier();
    bool last = gl_LocalInvocationIndex == 0u && atomicAdd(bisect_work[DONE], 1u) == gl_NumWorkGroups.x - 1u;
#else
    bisectStage(gl_WorkGroupID.x);
    memoryBarrierBuffer();
    bool last = atomicAdd(bisect_work[DONE], 1u) == 64u * gl_NumWorkGroups.x - 1u;
#endif
    memoryBarrierBuffer();
    if (last) {
        bisect_work[DONE] = 0u;
        bisectNext();
    }
}
