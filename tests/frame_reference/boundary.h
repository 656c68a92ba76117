/* Distance between the shadow boundaries of two pictures of the same points. */
#ifndef MATC_FRAME_BOUNDARY_H
#define MATC_FRAME_BOUNDARY_H
#include <stdbool.h>

/* Square pictures whose pixels have positions in a plane; lengths are in the plane's units. */
typedef struct {
    int edge; /* pixels per side */
    const double (*places)[2];
    /* light without shadows; pixels with 0 or less are not measured */
    const float *light;
    const float *truth; /* true share of the light that arrives: below 1/2 is in shadow */
    /* max distance of adjacent pixels; a greater one separates two surfaces */
    double widest;
} Boundary;

/* Length of the true shadow boundary, within 3 % for boundaries that run in all directions. */
double boundary_length(const Boundary *boundary);
/* Area of points that are wrongly in shadow or wrongly lit by these shares: divided by the
 * length, the mean distance of the boundaries. */
double boundary_area(const Boundary *boundary, const float *shares);
#endif
