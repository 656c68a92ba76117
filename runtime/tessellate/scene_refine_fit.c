#include "runtime/tessellate/scene_refine_fit.h"
#include <math.h>
#include <stdlib.h>

static const double STEP = 0.7; /* of a step of Jacobi's: two whole ones overshoot */
/* Of the square that a place's worst triangle misses: one that misses less is flat. */
static const double FLAT = 0.02 * 0.02;

typedef struct {
    /* of its triangles: what they miss; the squares of the best and the worst */
    double sum[3], area, low, high;
} Around;

static void add_triangle(const SceneBisection *b, uint32_t triangle, const SceneMiss *miss,
                         Around *around)
{
    for (int corner = 0; corner < 3; corner++) {
        Around *at = &around[b->place_of[b->triangles[triangle].vertex[corner]]];
        for (int lane = 0; lane < 3; lane++)
            at->sum[lane] += miss->area * miss->mean[lane];
        at->area += miss->area;
        at->low = fmin(at->low, miss->square);
        at->high = fmax(at->high, miss->square);
    }
}

bool scene_refine_fit(const SceneBisection *b, const SceneMiss *misses, double least,
                      double (*to)[3])
{
    Around *around = calloc(b->place_count + 1, sizeof *around);
    if (!around)
        return false;
    for (size_t i = 0; i < b->place_count; i++)
        around[i].low = INFINITY;
    for (size_t i = 0; i < b->count; i++)
        add_triangle(b, (uint32_t)i, &misses[i], around);
    for (size_t i = 0; i < b->place_count; i++)
        for (int lane = 0; around[i].low > fmax(least, FLAT * around[i].high) && lane < 3; lane++)
            to[i][lane] += STEP * around[i].sum[lane] / around[i].area;
    free(around);
    return true;
}
