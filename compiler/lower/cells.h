/* Cellular noise (Worley): the maps Cells and CellCentre, and `cells` in formulas. cells.c */
#ifndef MATC_CELLS_H
#define MATC_CELLS_H
#include "compiler/lower/lower.h"

enum {
    CELLS_VALUE_F1,
    CELLS_VALUE_F2,
    CELLS_VALUE_edge,
    CELLS_VALUE_random,
    CELLS_VALUE_centre,
    CELLS_VALUE_COUNT
};
enum { CELLS_FEWEST_DIMENSIONS = 2, CELLS_MAX_DIMENSIONS = 3 };

/* Settings of one cellular noise: dimensions, distance metric, measured value, jitter of the
 * points. */
typedef struct {
    int dimensions, distance, measure;
    Ref jitter;
} Cells;

/* Returns the value at the position q + `beside`; beside 0: at q itself. */
Ref cells_at(Lower *l, const Cells *cells, Ref q, Ref beside);
/* Returns the mean over the pixel, as one box or several. The mean of the cell center is the
 * position itself. */
MapValue cells_over_pixel(Lower *l, const Cells *cells, MapValue q);
/* Returns the distances to the feature points around a position as formulas use them: F1 or
 * `edge`. */
Ref cells_of(Lower *l, Ref p, bool edge);
/* Returns the mean and variance over many cells of a MaterialX cell map, from its arguments:
 * only the last, `dimensions`, for a number; `jitter`, `style`, `dimensions` for a point.
 * Returns false if the arguments are not known at compile time. */
bool cells_far(Lower *l, Far far, const Ref *args, MapValue *made);
#endif
