/* Distance between the shadow boundaries of two pictures of the same points. */
#ifndef MATC_FRAME_BOUNDARY_H
#define MATC_FRAME_BOUNDARY_H
#include <stdbool.h>

/* Square pictures, whose pixels know their places in a plane: what is there is measured in its
 * units. */
typedef struct {
    int edge; /* pixels */
    const double (*places)[2];
    /* that would arrive if there were no shadows; where it is not above 0, nothing is measured */
    const float *light;
    const float *truth; /* the share of it that arrives: below 1/2 is in the shadow */
    /* between pixels beside each other; what is further apart is two surfaces */
    double widest;
} Boundary;

/* Length of the true shadow's end, within 3 % for ends that run in all directions. */
double boundary_length(const Boundary *boundary);
/* Area of points that are in the shadow by these shares and not by the truth, or the other way
 * round: over the length, the mean distance of their ends. */
double boundary_area(const Boundary *boundary, const float *shares);
#endif
