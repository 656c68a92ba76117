/* Walks rays through voxels in double. */
#include "tests/frame_reference/voxel_walk.h"
#include <math.h>
#include <stdlib.h>

enum { WORD = 32, COMPONENTS = 4 };

VoxelWords voxel_words(int size)
{
    const size_t count = (size_t)size * (size_t)size * (size_t)(size / WORD);
    return (VoxelWords){size, calloc(count, sizeof(uint32_t))};
}

static uint32_t *keyword_of(const VoxelWords *words, const int at[3])
{
    const size_t column = (size_t)at[1] * (size_t)words->size + (size_t)at[0];
    return &words->words[column * (size_t)(words->size / WORD) + (size_t)(at[2] / WORD)];
}

bool voxel_words_at(const VoxelWords *words, const int at[3])
{
    return *keyword_of(words, at) >> at[2] % WORD & 1;
}

void voxel_words_set(VoxelWords *words, const int at[3])
{
    *keyword_of(words, at) |= 1u << at[2] % WORD;
}

uint32_t *voxel_words_texels(const VoxelWords *words)
{
    const int count = words->size / WORD, layers = (count + COMPONENTS - 1) / COMPONENTS;
    const size_t plane = (size_t)words->size * (size_t)words->size;
    uint32_t *texels = calloc(plane * (size_t)layers * COMPONENTS, sizeof *texels);
    for (size_t column = 0; column < plane; column++)
        for (int i = 0; i < count; i++)
            texels[((size_t)(i / COMPONENTS) * plane + column) * COMPONENTS +
                   (size_t)(i % COMPONENTS)] = words->words[column * (size_t)count + (size_t)i];
    return texels;
}

/* -- a ray */

/* Clips a line to the map, to t in [begin, end]. */
static bool clip(const VoxelWords *words, const VoxelLine *line, double *begin, double *end)
{
    *begin = 0;
    *end = line->far;
    for (int k = 0; k < 3; k++) {
        const double low = -line->from[k], high = words->size - line->from[k], way = line->way[k];
        if (way == 0 && (low > 0 || high < 0))
            return false;
        if (way == 0)
            continue;
        *begin = fmax(*begin, fmin(low / way, high / way));
        *end = fmin(*end, fmax(low / way, high / way));
    }
    return *begin <= *end;
}

/* Parameter at which the line leaves a voxel along an axis. */
static double leaves(const VoxelLine *line, int axis, int at)
{
    return line->way[axis] == 0 ? INFINITY
                                : (at + (line->way[axis] > 0) - line->from[axis]) / line->way[axis];
}

VoxelMet voxel_walk(const VoxelWords *words, const VoxelLine *line)
{
    VoxelMet met = {.met = false};
    double end;
    if (!clip(words, line, &met.t, &end))
        return met;
    bool own = met.t == 0;
    for (int k = 0; k < 3; k++) {
        const double at = line->from[k] + met.t * line->way[k];
        /* on a face the point belongs to the voxel that the ray enters */
        const double place = line->way[k] < 0 ? ceil(at) - 1 : floor(at);
        own &= line->from[k] >= 0 && line->from[k] <= words->size;
        met.at[k] = (int)fmin(fmax(place, 0), words->size - 1);
    }
    for (;;) {
        const bool full = voxel_words_at(words, met.at);
        double t[3];
        int axis = 0;
        if (full && !own)
            return met.met = true, met;
        own &= full;
        for (int k = 0; k < 3; k++) {
            t[k] = leaves(line, k, met.at[k]);
            axis = t[k] <= t[axis] ? k : axis;
        }
        met.t = t[axis];
        met.at[axis] += line->way[axis] > 0 ? 1 : -1;
        if (!(met.t <= end) || met.at[axis] < 0 || met.at[axis] >= words->size)
            return met;
    }
}
