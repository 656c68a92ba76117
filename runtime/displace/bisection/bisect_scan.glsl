// Selects the tiles of leaves to evaluate: those for which the camera has moved far enough, or all.
uniform int bisect_fresh; // 1: the first view, without an earlier one; else 0

// Returns true if the tile is due, and marks it as evaluated.
bool bisectIsDue(uint tile)
{
    uint due = bisectWord(LIST_DUE, tile);
    if (BISECT_TILE * tile >= bisect_state[HIGH] ||
        (bisect_fresh == 0 && bisect_gone < uintBitsToFloat(bisect_work[due])))
        return false;
    bisect_work[due] = floatBitsToUint(BISECT_SURE);
    return true;
}

#ifdef BISECT_SCAN
void bisectStage(uint group)
{
    uint tile = bisectTask(group);
    if (bisectIsDue(tile))
        bisect_work[bisectWord(LIST_CHOSEN, atomicAdd(bisect_state[CHOSEN], 1u))] = tile;
}
#endif
