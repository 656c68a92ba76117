/* Sorts many lights along Morton's curve, on which points close in space are mostly close.
 * Lights near a group of pixels then share few of the words with their bits (far_blocks.glsl),
 * and a pixel reads fewer words.
 *
 *     A cell's number interleaves the bits of its coordinates x, y, z: cell (3, 0, 1) is binary
 *         001 101, 13, in the bit order z, y, x. */
#include "runtime/light/light_far.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BITS = 10 /* bits of a cell's coordinate */ };

typedef struct {
    float texels[LIGHT_PLAIN_TEXELS][4];
    uint32_t cell;
} Placed;

/* Sorts by cell; lights of one cell by their texels, which makes the order unique. */
static int compare(const void *left, const void *right)
{
    const Placed *a = left, *b = right;
    return a->cell != b->cell ? (a->cell > b->cell) - (a->cell < b->cell)
                              : memcmp(a->texels, b->texels, sizeof a->texels);
}

static void find_box(float (*lights)[LIGHT_PLAIN_TEXELS][4], int count, float low[3], float high[3])
{
    for (int axis = 0; axis < 3; axis++) {
        low[axis] = INFINITY;
        high[axis] = -INFINITY;
        for (int i = 0; i < count; i++) {
            low[axis] = fminf(low[axis], lights[i][LIGHT_PLACE][axis]);
            high[axis] = fmaxf(high[axis], lights[i][LIGHT_PLACE][axis]);
        }
    }
}

static uint32_t cell_of(const float place[3], const float low[3], const float high[3])
{
    uint32_t cell = 0;
    for (int axis = 0; axis < 3; axis++) {
        const double wide = (double)high[axis] - low[axis],
                     part = wide > 0 ? ((double)place[axis] - low[axis]) / wide : 0;
        const uint32_t at = (uint32_t)(part * ((1 << BITS) - 1));
        for (int bit = 0; bit < BITS; bit++)
            cell |= (at >> bit & 1) << (3 * bit + axis);
    }
    return cell;
}

bool light_order(float (*lights)[LIGHT_PLAIN_TEXELS][4], int count)
{
    float low[3], high[3];
    Placed *placed = malloc(((size_t)count + 1) * sizeof *placed);
    if (!placed)
        return false;
    find_box(lights, count, low, high);
    for (int i = 0; i < count; i++) {
        memcpy(placed[i].texels, lights[i], sizeof placed[i].texels);
        placed[i].cell = cell_of(lights[i][LIGHT_PLACE], low, high);
    }
    qsort(placed, (size_t)count, sizeof *placed, compare);
    for (int i = 0; i < count; i++)
        memcpy(lights[i], placed[i].texels, sizeof placed[i].texels);
    free(placed);
    return true;
}
