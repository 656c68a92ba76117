// Transition between two stages, by one thread: the lists that were written are read next, and the
// number of workgroups is computed. Leaves merge first, as long as any can; then others are
// bisected. Steps: 0: leaves were evaluated; 1, 3: leaves to merge, to bisect were chosen; 2, 4:
// they are merged, bisected; 5: tiles were chosen. The stage's last thread does the transition,
// since a dispatch would take longer than a round of few triangles: threads count themselves after
// their writes, and the last one to do so continues.

// Rounds of at most this size are left to bisect_few.glsl, if present, and are not counted.
#ifdef BISECT_WIDE
const uint FEW_MERGING = 256u, FEW_WANTED = 56u;
#else
const uint FEW_MERGING = 0u, FEW_WANTED = 0u;
#endif

// Sets the workgroups of an indirect dispatch for `count` tasks, `each` per workgroup.
void bisectSet(uint groups, uint count, uint each)
{
    // at least one: its last thread does the transition
    bisect_head[groups] = max((count + each - 1u) / each, 1u);
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
        if (step == 3 && live + chosen > uint(bisect_capacity))
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
        bisect_head[SWAPPED] = 0u; // wanted leaves are still in the first of their lists
    }
    bisect_head[CHOSEN] = bisect_head[MERGING_NEXT] = bisect_head[WANTED_NEXT] = 0u;
    bisectSet(GROUPS, bisect_head[FULL] != 0u ? 0u : bisect_head[bisect_head[MERGED_ALL] != 0u ? WANTED : MERGING], 64u);
}

#ifndef BISECT_FEW
// Returns the number of workgroups that have tasks.
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
    // A fixed number of workgroups, as many as the GPU runs at once: reading their number for an
    // indirect dispatch takes longer than idle workgroups.
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
