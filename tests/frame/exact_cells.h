/* Reads the cells of a light with exact shadows, by the words of the list's head: for tests of
 * the lists. */
#ifndef MATC_EXACT_CELLS_H
#define MATC_EXACT_CELLS_H
#include "runtime/exact/exact_lists.h"

/* A polygon in the axes of a cube face. */
typedef struct {
    double at[16][3];
    int count;
} ExactPolygon;

float exact_cell_number(const uint32_t *head, int word);
/* The cell of a point; -1 if the light does not see the point. */
long exact_cell_of(const uint32_t *head, const double at[3]);
ExactPolygon exact_cell_polygon(const uint32_t *head, ExactCorners *corners, int face);
/* True if a cell, enlarged on all sides by the share `wider` of its width, overlaps a polygon;
 * clips the polygon by the cell's sides. */
bool exact_cell_has(const uint32_t *head, const ExactPolygon *of, const int cell[2], double wider);
#endif
