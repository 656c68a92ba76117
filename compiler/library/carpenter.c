/* Diamond-square on a torus, semantics.md 2.2, for any size: the lines of a grid of n cells are
 * at floor(i width / n), so the cells are GroIMP's for powers of two and differ by at most a
 * texel for others. If lines coincide, a texel keeps its first value. The generator is seeded;
 * GroIMP ignores the seed and uses 0. */
#include "compiler/library/carpenter.h"
#include "compiler/library/java_random.h"
#include <math.h>

/* Bound of the texels: keeps sums of neighbors finite if a roughness below 0 makes the offsets
 * grow. */
#define GREATEST 1e30

typedef struct {
    int width, height;
    int lines; /* grid lines per axis at this level; every second line is from the previous level */
    double reach;
    uint64_t state;
    float *texels; /* heights of the texels; NaN if not yet computed */
} DisplacementFound;

static float *texel(DisplacementFound *r, int column, int row)
{
    int64_t x = (int64_t)(column & (r->lines - 1)) * r->width / r->lines;
    int64_t y = (int64_t)(row & (r->lines - 1)) * r->height / r->lines;
    return &r->texels[y * r->width + x];
}

/* Sets a texel to the mean of the texels at (column +- a, row +- b) and (column +- c, row +- d),
 * plus a random offset. */
static void subdivide(DisplacementFound *r, int column, int row, const int reach[4])
{
    float *target = texel(r, column, row);
    if (!isnan(*target))
        return;
    double sum = (double)*texel(r, column - reach[0], row - reach[1]) +
                 (double)*texel(r, column + reach[0], row + reach[1]) +
                 (double)*texel(r, column - reach[2], row - reach[3]) +
                 (double)*texel(r, column + reach[2], row + reach[3]);
    double value = sum / 4 + (double)java_random_signed(&r->state) * r->reach;
    *target = (float)fmax(fmin(value, GREATEST), -GREATEST);
}

/* Computes one level: the cell centers from their corners, then the edge midpoints from the four
 * adjacent texels. */
static void refine(DisplacementFound *r)
{
    static const int diagonal[4] = {1, 1, 1, -1}, straight[4] = {1, 0, 0, 1};
    for (int row = 0; row < r->lines; row += 2)
        for (int column = 0; column < r->lines; column += 2)
            subdivide(r, column + 1, row + 1, diagonal);
    for (int row = 0; row < r->lines; row += 2)
        for (int column = 0; column < r->lines; column += 2) {
            subdivide(r, column + 1, row, straight);
            subdivide(r, column, row + 1, straight);
        }
}

void carpenter_bake(const CarpenterRelief *carpenter, float *texels)
{
    const int width = carpenter->width, height = carpenter->height,
              greater = width > height ? width : height;
    DisplacementFound relief = {
        width, height, .lines = 2, .reach = carpenter->noise, java_random(carpenter->seed), texels};
    for (int i = 0; i < width * height; i++)
        texels[i] = NAN;
    texels[0] = (float)fmax(fmin(carpenter->color, GREATEST), -GREATEST);
    for (; relief.lines < 2 * greater; relief.lines *= 2) {
        refine(&relief);
        relief.reach *= exp2(-carpenter->roughness);
    }
}
