// Runs all rounds in one dispatch by a single workgroup, as long as they have few triangles: a
// barrier within a workgroup takes a tenth of the time of a dispatch. Larger rounds are left to the
// other stages.
void bisectWait()
{
    bisectFence();
    barrier();
}

// Runs bisectNext() on the first thread, between two barriers: all threads have read the state that
// it changes, and read the changed state afterwards.
void bisectNextWaiting(int step)
{
    bisectWait();
    if (gl_LocalInvocationIndex == 0u)
        bisectNext(step);
    bisectWait();
}

// Merges leaves, or makes the children of bisected leaves. Both share one call of bisectAnswers(),
// since a driver's compiler takes up to seconds for each call.
void bisectChange(bool merging, uint group)
{
    uint asked = merging ? bisect_state[CHOSEN] : bisectDivide(group);
    for (uint task = bisectTask(merging ? group : 0u); task < asked; task += merging ? asked
        : BISECT_THREADS) {
        Asked a;
        if (merging)
            bisectMergeBegin(task, a);
        else
            bisectSplitBegin(task / 2u, task % 2u, a);
        Answers answers = bisectAnswers(a);
        bisectDue(a.slot, answers);
        if (merging)
            bisectMergeEnd(a, answers);
        else
            bisectSplitEnd(a, answers);
    }
    if (!merging)
        bisectTurn(); // the next group of leaves reuses the shared memory
}

void main()
{
    if (gl_LocalInvocationIndex < BISECT_COUNTS)
        bisect_state[gl_LocalInvocationIndex] = bisect_work[gl_LocalInvocationIndex];
    bisectWait();
    for (;;) {
        bool merging = bisect_state[MERGED_ALL] == 0u;
        uint count = merging ? bisect_state[MERGING] : bisect_state[WANTED];
        if (count == 0u || count > (merging ? FEW_MERGING : FEW_WANTED) ||
            bisect_state[FULL] != 0u || bisect_state[LOST] != 0u)
            break;
        for (uint group = 0u; BISECT_THREADS * group < count; group++)
            if (merging)
                bisectMergeChoose(group);
            else
                bisectChoose(group);
        bisectNextWaiting(merging ? 1 : 3);
        uint groups = bisect_state[GROUPS_CHOSEN];
        for (uint group = 0u; group < groups; group++)
            bisectChange(merging, group);
        bisectNextWaiting(merging ? 2 : 4);
    }
    if (gl_LocalInvocationIndex < BISECT_COUNTS)
        bisect_work[gl_LocalInvocationIndex] = bisect_state[gl_LocalInvocationIndex];
}
