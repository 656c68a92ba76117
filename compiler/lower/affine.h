/* Values expressed as an affine function, with constant factors, of the value they start from. */
#ifndef MATC_AFFINE_H
#define MATC_AFFINE_H
#include "compiler/ir/build.h"

enum { AFFINE_COMPONENTS = 3 };

/* The affine form of one component: offset + sum of factor[i] * component i of the root. */
typedef struct {
    Ref root;    /* value from which the form starts; 0: the form is a constant */
    bool closed; /* component 4 of a vec4: no other affine form can start from the value */
    double factor[AFFINE_COMPONENTS], offset;
} Line;

/* The affine forms found so far. */
typedef struct {
    /* Index in `lines`, by Ref, of the node's first component, counted from 1; 0: the node is a
     * root. */
    uint32_t *first;
    size_t first_capacity;
    Line *lines;
    size_t count, capacity;
    Ref done; /* nodes below this Ref were processed */
} Affine;
#endif
