/* Splits polygons into triangles. */
#ifndef MATC_VIEW_POLYGON_H
#define MATC_VIEW_POLYGON_H
#include <stdbool.h>
#include <stddef.h>

/* Work for polygons that are not convex: at most the square of their corners each for usual shapes.
 */
enum { POLYGON_TESTS = 1 << 28 };

/* Storage that is reused for all polygons of a file; zero-initialized. */
typedef struct {
    float (*points)[3]; /* the caller writes the corners here */
    double (*flat)[2];  /* corners in the plane of the polygon */
    int *next, *previous, *triangles;
    size_t capacity;
    long tests; /* tests of all polygons so far */
} Polygon;

/* Makes space for a polygon of `count` corners. */
void polygon_reserve(Polygon *polygon, size_t count);
/* Splits the polygon of `count` corners in `points`: `triangles` gets three corner numbers for each
 * of count - 2 triangles. A convex polygon becomes a fan, any other is split by clipping its ears.
 * Returns false if the polygons exceed POLYGON_TESTS. */
bool polygon_split(Polygon *polygon, int count);
/* Computes twice the area vector of the polygon (Newell's method). */
void polygon_area(const Polygon *polygon, int count, double area[3]);
void polygon_free(Polygon *polygon);
#endif
