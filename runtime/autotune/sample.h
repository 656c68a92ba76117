/* Geometry for measurements: points with arbitrary shader inputs, one fragment each, and a plane
 * in perspective up to its horizon. */
#ifndef MATC_AUTOTUNE_SAMPLE_H
#define MATC_AUTOTUNE_SAMPLE_H
#include "compiler/oracle/oracle.h"
#include "runtime/gpu_material/field.h"

enum { POINTS_WIDTH = 64, POINTS_HEIGHT = 32, POINTS = POINTS_WIDTH * POINTS_HEIGHT };

/* Fills in points with a low-discrepancy distribution: coordinates in [-range, range], uniformly
 * distributed unit normals, orthonormal tangents. Deterministic. */
void sample_points(FieldVertex points[POINTS], double range);
/* Sets the C reference's surface from exactly the point's floats, front-facing, with ior 1. */
void sample_surface(const FieldVertex *point, Surface *surface);

/* View of the plane z = 0 from one unit above. The horizon is the picture's upper edge. */
typedef struct {
    double yaw;    /* angle from the x axis in radians */
    double scale;  /* units of u and v per length unit */
    double aspect; /* aspect ratio of the picture: width over height */
    int height;    /* height of the picture in pixels */
    /* Offset added to x and y, and times `scale` to u and v: moves the plane away from the
     * origin. */
    double shift[2];
} PlaneView;
enum { PLANE_VERTICES = 4 };
void sample_plane(FieldVertex vertices[PLANE_VERTICES], const PlaneView *view);
#endif
