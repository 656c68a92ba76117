/* Priority queue of triangles by error: a binary heap, the largest first. */
#ifndef MATC_SCENE_RANKS_H
#define MATC_SCENE_RANKS_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct {
    double error;
    uint32_t triangle, stamp; /* valid as long as the triangle has that stamp */
} SceneRank;

typedef struct {
    SceneRank *ranks;
    size_t count, capacity;
} SceneRanks;

/* Inserts a rank, or replaces the triangle's. False: out of memory. */
bool scene_ranks_put(SceneRanks *ranks, SceneRank rank);
/* Removes the largest; the queue must not be empty. */
SceneRank scene_ranks_take(SceneRanks *ranks);
void scene_ranks_end(SceneRanks *ranks);
#endif
