/* Errors of encodings of unit normals, next to the figures of numerics.md 1.1: the angle between
 * a normal and its stored value. The benchmark prints them, and the test compares them with the
 * figures. */
#ifndef MATC_TESTS_NORMALS_H
#define MATC_TESTS_NORMALS_H
#include <stdbool.h>

typedef enum {
    STORE_snorm,   /* octahedron, 2^bits - 1 levels */
    STORE_unorm,   /* octahedron, 2^bits levels */
    STORE_precise, /* the best of the four codes around, 2^bits levels */
    STORE_precise_snorm,
    STORE_radix,     /* octahedron, 247 x 247 levels: in one half float */
    STORE_halves,    /* octahedron in two half floats */
    STORE_spheremap, /* 2^bits levels */
    STORE_spheremap_halves,
    STORE_xyz, /* each component 2^bits levels, normalized when read */
    STORE_xyz_halves
} NormalStore;

/* An encoding, with its figures of numerics.md 1.1 in degrees. */
typedef struct {
    const char *name;
    NormalStore store;
    int bits;
    bool hemisphere;           /* only directions with z >= 0 */
    double mean, rms, maximum; /* 0: not in the table */
} NormalRow;

/* Angles in degrees. */
typedef struct {
    double mean, rms, maximum;
} NormalAngles;

extern const NormalRow normal_table[];
extern const int normal_rows;

/* Measures over `directions` random directions, the same in every run, in double precision. */
NormalAngles normals_measure(const NormalRow *row, int directions);
/* Excess of the difference between a measured number and a figure over the figure's print
 * precision; 0 without a figure. */
double normals_off(double measured, double figure);
/* True if the directions include -z, where a spheremap is singular, so that its greatest angle
 * depends on chance. */
bool normals_are_singular(const NormalRow *row);
#endif
