// Transition between two stages, by one thread: the lists that were written are read next, and the
// number of workgroups is computed. Leaves merge first, as long as any can; then others are
// bisected. Steps: 0: leaves were evaluated; 1, 3: leaves to merge, to bisect were chosen; 2, 4:
// they are merged, bisected; 5: tiles were chosen. The stage's last thread does the transition,
// since a dispatch would take longer than a round of few triangles: threads count themselves after
// their writes, and the last one to do so continues.

// Rounds of at most this size are left to bisect_single_workgroup.glsl, if present, and are not
// counted.
#ifdef BISECT_WIDE
const uint FEW_MERGING = 256u, FEW_WANTED = 56u;
#else
const uint FEW_MERGING = 0u, FEW_WANTED = 0u;
#endif

// Sets the workgroups of an indirect dispatch for `count` tasks, `each` per workgroup.
void bisectSet(uint groups, uint count, uint each)
{
    // at least one workgroup, whose last thread does the transition
    bisect_state[groups] = max((count + each - 1u) / each, 1u);
    bisect_state[groups + 1u] = bisect_state[groups + 2u] = 1u;
}

void bisectNext(int step)
{
    uint chosen = bisect_state[CHOSEN];
    if (step == 5) {
        bisectSet(GROUPS, BISECT_TILE * chosen, 64u);
        return;
    }
    if (step == 0)
        bisect_state[LOOKED] = chosen;
    if (step == 1 || step == 3) {
        uint live = bisect_state[HIGH] - bisect_state[FREE];
        if (step == 3 && live + chosen > uint(bisect_capacity))
            bisect_state[FULL] = 1u;
        bisectSet(GROUPS_CHOSEN, bisect_state[FULL] != 0u ? 0u : chosen, step == 3 ? BISECT_SPLITS
            : BISECT_THREADS);
        return;
    }
    bool merging = bisect_state[MERGED_ALL] == 0u;
    if (step == 2 && merging) {
        bisect_state[MERGES] += chosen;
        bisect_state[MERGE_ROUNDS] += uint(bisect_state[MERGING] > FEW_MERGING);
        bisect_state[MERGING] = chosen == 0u ? 0u : bisect_state[MERGING_NEXT];
        bisect_state[SWAPPED] ^= 1u;
    } else if (step == 4 && !merging && bisect_state[FULL] == 0u) {
        bisect_state[FREE] = uint(max(int(bisect_state[FREE]), 0));
        bisect_state[SPLITS] += chosen;
        bisect_state[SPLIT_ROUNDS] += uint(chosen != 0u && bisect_state[WANTED] > FEW_WANTED);
        bisect_state[WANTED] = bisect_state[WANTED_NEXT];
        bisect_state[SWAPPED] ^= 1u;
    }
    if (merging && bisect_state[MERGING] == 0u) {
        bisect_state[MERGED_ALL] = 1u;
        bisect_state[SWAPPED] = 0u; // wanted leaves are still in the first of their lists
    }
    bisect_state[CHOSEN] = bisect_state[MERGING_NEXT] = bisect_state[WANTED_NEXT] = 0u;
    bisectSet(GROUPS, bisect_state[FULL] != 0u ? 0u
        : bisect_state[bisect_state[MERGED_ALL] != 0u ? WANTED : MERGING], 64u);
}

#ifndef BISECT_FEW
// Returns the number of workgroups that have tasks.
uint bisectGroups()
{
#if BISECT_STEP == 0
    return gl_NumWorkGroups.x;
#else
    return bisect_state[BISECT_STEP == 2 || BISECT_STEP == 4 ? GROUPS_CHOSEN : GROUPS];
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
    bool last = gl_LocalInvocationIndex == 0u && atomicAdd(bisect_state[DONE], 1u) ==
        gl_NumWorkGroups.x - 1u;
#else
    BISECT_STAGE(gl_WorkGroupID.x);
    memoryBarrierBuffer();
    bool last = atomicAdd(bisect_state[DONE], 1u) == 64u * gl_NumWorkGroups.x - 1u;
#endif
    memoryBarrierBuffer();
    if (last) {
        bisect_state[DONE] = 0u;
        bisectNext(BISECT_STEP);
    }
}
#endif
