/* Cells around random points: what the maps Cells and CellCentre are, and `cells` of formulas.
 * cells.c */
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
enum { CELLS_FEWEST_DIMENSIONS = 2, CELLS_MOST_DIMENSIONS = 3 };

/* Cells of a coordinate. */
typedef struct {
    int dimensions, distance, measure;
    Ref jitter;
} Cells;

/* At a place that lies `beside` the coordinate; 0: at itself. */
Ref cells_at(Lower *l, const Cells *cells, Ref q, Ref beside);
/* The mean over the pixel, a box or several. The centre's mean is the place itself. */
Answer cells_over_pixel(Lower *l, const Cells *cells, Answer q);
/* Statistics of distances to the points around a position, F1 or `edge`, as formulas have them. */
Ref cells_of(Lower *l, Ref p, bool edge);
/* The mean and the variance over many cells of a map of MaterialX's, by its arguments: for a number
 * none count but the last, `dimensions`; for a point `jitter`, `style`, `dimensions`. False: it is
 * not known what the map is before it is drawn. */
bool cells_far(Lower *l, Far far, const Ref *args, Answer *made);
#endif
