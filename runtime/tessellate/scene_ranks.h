/* Triangles by their error: a heap, the largest first. */
#ifndef MATC_SCENE_RANKS_H
#define MATC_SCENE_RANKS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct {
    double error;
    uint32_t triangle, stamp; /* a rank counts as long as its triangle has that stamp */
} SceneRank;

typedef struct {
    SceneRank *ranks;
    size_t count, room;
} SceneRanks;

/* False: memory ran out. */
bool scene_ranks_put(SceneRanks *ranks, SceneRank rank);
/* The largest; there is one. */
SceneRank scene_ranks_take(SceneRanks *ranks);
void scene_ranks_end(SceneRanks *ranks);
#endif
