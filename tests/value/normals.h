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
    STORE_xyz, /* each component 2^bits levels, normalised when read */
    STORE_xyz_halves
} NormalStore;

/* With what numerics.md 1.1 has for it, degrees. */
typedef struct {
    const char *name;
    NormalStore store;
    int bits;
    bool hemisphere;           /* directions of z >= 0 alone */
    double mean, rms, maximum; /* 0: the table has none */
} NormalRow;

/* Angles in degrees. */
typedef struct {
    double mean, rms, maximum;
} NormalAngles;

extern const NormalRow normal_table[];
extern const int normal_rows;

/* Over so many random directions, the same ones in every run, in double precision. */
NormalAngles normals_measure(const NormalRow *row, int directions);
/* By how much of a figure a measured number misses it, beyond what the figure's digits leave open;
 * 0 where there is none. */
double normals_off(double measured, double figure);
/* The direction that looks away is among them, where a spheremap is singular: its greatest angle is
 * chance. */
bool normals_are_singular(const NormalRow *row);
#endif
