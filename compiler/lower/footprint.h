/* The footprint of a pixel in a value, for --aa: its width, sample positions, and the variance
 * that a mean has left out. */
#ifndef MATC_FOOTPRINT_H
#define MATC_FOOTPRINT_H
#include "compiler/lower/map_value.h"
#include "compiler/lower/slope.h"

enum {
    MAX_TAPS = 4,
    MAX_SPLITS = 4, /* max nesting of checkers whose colors are kept apart */
};

/* A box of a footprint: its center, and its edge lengths per component. */
typedef struct {
    Ref middle, edges;
} Tap;

/* Returns true for a kind whose mean over the pixel has a closed form, which --aa=auto may use. */
bool footprint_may_average(Kind kind);
/* Returns true if the current map is averaged over the pixel. Maps below Smooth3D and Laplace3D
 * are not: the filters sample them many times themselves. */
bool footprint_is_filtered(const Lower *l);
/* Boxes of equal weight that cover the pixel's footprint on a coordinate: one, or with
 * --aa=aniso MAX_TAPS along the longer side. Returns their number; 0: the coordinate is
 * constant over the pixel. */
int footprint_taps(Lower *l, MapValue coordinate, Tap taps[MAX_TAPS]);
/* Returns the longer side of the footprint, and the edges of the boxes along it; 0 unless
 * --aa=aniso. */
Ref footprint_longer(Lower *l, MapValue coordinate, Ref *edges);
/* Returns MAX_TAPS points distributed over the footprint, for functions without a closed mean;
 * 0 as above. */
int footprint_points(Lower *l, Ref coordinate, Ref points[MAX_TAPS]);
/* Returns the edges per component of a box with the same variance as the value within the pixel,
 * from its slope and the variance it has left out. 0: the value is constant. Otherwise the edges
 * are shader values that may be 0; a box without edges is its center, so divisions by an edge
 * need a guard. */
Ref footprint_edges(Lower *l, MapValue a);
/* Returns the maximum over the components. */
Ref footprint_greatest_component(Lower *l, Ref value);
/* Splits `scale` times a coordinate into an integer and a fraction in [-1/2, 1/2], for
 * --coordinates=long. The coordinate must be an affine function with constant factors. Returns
 * false if the coordinate is exact as it is, or not affine. affine.c */
typedef struct {
    Ref whole, fraction;
} LongCoordinate;
bool affine_coordinate(Lower *l, Ref coordinate, double scale, LongCoordinate *parts);
/* Returns part / edge, for a part that is 0 where the edge is 0; the result is 0 there. */
Ref footprint_over_edge(Lower *l, Ref part, Ref edge);
/* Returns max(b / 2 - |x|, 0)^2 / (2 b): the excess of the mean of max(x, 0) over a box of edge
 * b over max(x, 0); 0 without a box. */
Ref footprint_box_corner(Lower *l, Ref x, Ref edge);
#endif
