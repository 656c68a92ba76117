/* The points of cells that are nearest to one: the references of cells2, cells3 and their like, and
 * what their statistics are made of.
 *
 * Which cells to ask. With p at (1 - a, 1 - b, 1 - c) of its cell, a, b, c in [0, 1/2], as the
 * sides are alike otherwise, the cell itself and the one beside it along an axis have a point each.
 * Their greatest distance bounds that of the second nearest, F2, by the axis that suits best:
 *     euclidean   (1 + a)^2 + (1 - b)^2 + (1 - c)^2 <= 3   F2 <= sqrt 3; in two dimensions
 *                                                          F2^2 <= 2 + 1/2
 *     manhattan   (1 + a) + (1 - b) + (1 - c) <= 3         F2 <= 3; in two dimensions F2 <= 2
 *     chebyshev   1 + a <= 3/2
 * A cell that is k away along an axis is at least k - 1 far. So none beyond 2 counts, but for
 * manhattan distances in three dimensions, where none beyond 3 does. Less jitter moves all points
 * towards the middles, and no bound grows. Not even the nearest is always in the 3 x 3 cells around
 * p: of p in a corner all four there may have their points sqrt 2 away, and one of a cell two away
 * is 1 away. */
#ifndef MATC_LIBRARY_CELLS_H
#define MATC_LIBRARY_CELLS_H
#include "compiler/library/reference.h"

enum { CELLS_REACH = 3 }; /* cells on either side that may have one of the nearest two */

/* As the words of Distance and CellsValue are numbered, and the functions' arguments. */
typedef enum { CELLS_EUCLIDEAN, CELLS_MANHATTAN, CELLS_CHEBYSHEV } CellsDistance;
enum { CELLS_FIRST, CELLS_SECOND, CELLS_BETWEEN };

typedef struct {
    double distance, away[3]; /* from p to it */
    double number;            /* its cell's, in [0, 1) */
    int cell[3];              /* as many cells from p's own */
} CellsPoint;
typedef struct {
    CellsPoint first, second;
} CellsPair;
typedef struct {
    int dimensions; /* 2 or 3 */
    double p[3], jitter;
    CellsDistance how;
} CellsQuestion;

CellsPair cells_nearest(ReferenceNoise noise, const CellsQuestion *question);
#endif
