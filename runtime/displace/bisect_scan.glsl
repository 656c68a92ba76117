// Which tiles of leaves are looked at: those that the camera has moved far enough for, or all.
uniform int bisect_fresh; // 1: nothing is known of any view before

void bisectStage(uint group)
{
    uint tile = bisectTask(group);
    if (BISECT_TILE * tile >= bisect_work[HIGH])
        return;
    uint due = bisectWord(LIST_DUE, tile);
    if (bisect_fresh == 0 && bisect_gone < uintBitsToFloat(bisect_work[due]))
        return;
    bisect_work[due] = floatBitsToUint(BISECT_SURE);
    bisect_work[bisectWord(LIST_CHOSEN, atomicAdd(bisect_work[CHOSEN], 1u))] = tile;
}
