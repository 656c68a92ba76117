/* Nearest cell points: the reference of cells2, cells3 and their variants, and the source of
 * their statistics.
 *
 * Search bound. By symmetry let p be at (1 - a, 1 - b, 1 - c) in its cell, a, b, c in [0, 1/2].
 * The cell itself and the adjacent cell along an axis have a point each. The larger of the two
 * distances bounds that of the second nearest, F2; choose the best axis:
 *     Euclidean   (1 + a)^2 + (1 - b)^2 + (1 - c)^2 <= 3   F2 <= sqrt 3; in two dimensions
 *                                                          F2^2 <= 2 + 1/2
 *     Manhattan   (1 + a) + (1 - b) + (1 - c) <= 3         F2 <= 3; in two dimensions F2 <= 2
 *     Chebyshev   1 + a <= 3/2
 * A cell k away along an axis is at least k - 1 distant. So ring 2 suffices, except for
 * Manhattan distances in three dimensions, which need ring 3. Less jitter moves all points
 * toward the cell centers, and no bound grows. The 3 x 3 neighborhood does not suffice even for
 * the nearest point: with p in a corner all four adjacent points may be sqrt 2 away, while a
 * point of a cell two away is 1 away. */
#ifndef MATC_LIBRARY_CELLS_H
#define MATC_LIBRARY_CELLS_H
#include "compiler/library/reference.h"

enum { CELLS_REACH = 3 }; /* rings of cells that may contain one of the nearest two points */

/* Numbered like the keywords of Distance and CellsValue, and the functions' arguments. */
typedef enum { CELLS_EUCLIDEAN, CELLS_MANHATTAN, CELLS_CHEBYSHEV } CellsDistance;
enum { CELLS_FIRST, CELLS_SECOND, CELLS_BETWEEN };

typedef struct {
    double distance, away[3]; /* distance, and the vector from p to the point */
    double number;            /* random number of the cell, in [0, 1) */
    int cell[3];              /* offset of the cell from the cell of p */
} CellsPoint;
typedef struct {
    CellsPoint first, second;
} CellsPair;
typedef struct {
    int dimensions; /* number of dimensions, 2 or 3 */
    double p[3], jitter;
    CellsDistance how;
} CellsQuestion;

CellsPair cells_nearest(ReferenceNoise noise, const CellsQuestion *question);
#endif
