/* Rays through voxels in double, by definition: visits every plane that a ray crosses, in order. */
#ifndef MATC_VOXEL_WALK_H
#define MATC_VOXEL_WALK_H
#include <stdbool.h>
#include <stdint.h>

/* Voxels as in a slice map: columns of size / 32 words, ordered along x first. */
typedef struct {
    int size;
    uint32_t *words;
} VoxelWords;

VoxelWords voxel_words(int size); /* all voxels empty; the words from malloc */
bool voxel_words_at(const VoxelWords *words, const int at[3]);
void voxel_words_set(VoxelWords *words, const int at[3]);
/* The words as texels of RGBA32UI, one layer for each 128 voxels. From malloc. */
uint32_t *voxel_words_texels(const VoxelWords *words);

typedef struct {
    double from[3], way[3], far;
} VoxelLine;

typedef struct {
    bool met;
    int at[3];
    double t;
} VoxelMet;

/* The first full voxel at 0 <= t <= far; full voxels that contain the ray's start are skipped up
 * to the first empty one. */
VoxelMet voxel_walk(const VoxelWords *words, const VoxelLine *line);
#endif
