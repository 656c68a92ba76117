/* The footprint of a pixel in a value, for --aa: its width, where to sample it, and the variance
 * that a mean has left out. */
#ifndef MATC_FOOTPRINT_H
#define MATC_FOOTPRINT_H
#include "compiler/lower/answer.h"
#include "compiler/lower/slope.h"

enum {
    MOST_TAPS = 4,
    MOST_SPLITS = 4, /* checkers within checkers whose colours are told apart */
};

/* One box: its middle and its edges by lane. */
typedef struct {
    Ref middle, edges;
} Tap;

/* A kind whose mean over the pixel is a closed form, which --aa=auto may take. */
bool footprint_may_average(Kind kind);
/* Whether maps are averaged over the pixel. What Smooth3D and Laplace3D evaluate many times is not:
 * they sample it themselves. */
bool footprint_is_filtered(const Lower *l);
/* The boxes that stand for the pixel's footprint on a coordinate, of equal weight: one, or
 * MOST_TAPS along the longer side with --aa=aniso. 0: the coordinate is the same all over the
 * pixel. */
int footprint_taps(Lower *l, Answer coordinate, Tap taps[MOST_TAPS]);
/* The longer side of the footprint, and the edges of the boxes along it; 0 but for --aa=aniso. */
Ref footprint_longer(Lower *l, Answer coordinate, Ref *edges);
/* MOST_TAPS points spread over the footprint; 0 as above. For functions of which nothing better is
 * known. */
int footprint_points(Lower *l, Ref coordinate, Ref points[MOST_TAPS]);
/* Edges by lane of a box that varies as much as the value does within the pixel: by its slope and
 * by what it has left out. 0: it does not vary. Else they are numbers of the shader that may be 0,
 * and a box without edges is its middle: whoever divides by an edge guards that. */
Ref footprint_edges(Lower *l, Answer a);
/* The greatest lane. */
Ref footprint_greatest_lane(Lower *l, Ref value);
/* `scale` times a coordinate that constants scaled, turned and moved, as a whole number and a
 * fraction in [-1/2, 1/2], for --coordinates=long. False: it is exact as it is, or not of that
 * kind. affine.c */
typedef struct {
    Ref whole, fraction;
} LongCoordinate;
bool affine_coordinate(Lower *l, Ref coordinate, double scale, LongCoordinate *parts);
/* part / b of a part that is 0 where b is: 0 there. */
Ref footprint_over_edge(Lower *l, Ref part, Ref edge);
/* max(b / 2 - |x|, 0)^2 / (2 b): what the mean of max(x, 0) over a box of edge b has more than
 * max(x, 0); 0 without a box. */
Ref footprint_box_corner(Lower *l, Ref x, Ref edge);
#endif
