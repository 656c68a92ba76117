/* Drawings that measure a material: points, a fragment each, whose inputs are given floats; and a
 * plane in perspective up to its horizon. */
#ifndef MATC_MEASURE_SAMPLE_H
#define MATC_MEASURE_SAMPLE_H
#include "compiler/oracle/oracle.h"
#include "runtime/draw/field.h"

enum { POINTS_WIDTH = 64, POINTS_HEIGHT = 32, POINTS = POINTS_WIDTH * POINTS_HEIGHT };

/* Points spread evenly in [-range, range] on every coordinate, with unit normals at any angle and
 * unit tangents at right angles to them. The same ones at every call. */
void sample_points(FieldVertex points[POINTS], double range);
/* The oracle's surface at the point: the very same floats, from the front, ior 1. */
void sample_surface(const FieldVertex *point, Surface *surface);

/* Where the plane z = 0 is seen from, one unit above it. The horizon is the picture's upper
 * edge. */
typedef struct {
    double yaw;    /* radians from the x axis */
    double scale;  /* u and v a unit of length */
    double aspect; /* width over height */
    int height;    /* of the picture, pixels */
    /* added to x and y, and times scale to u and v: how far from the origin it lies */
    double shift[2];
} PlaneView;
enum { PLANE_VERTICES = 4 };
void sample_plane(FieldVertex vertices[PLANE_VERTICES], const PlaneView *view);
#endif
