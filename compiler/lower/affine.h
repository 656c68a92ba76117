/* Values as constants made them of one that they start from. */
#ifndef MATC_AFFINE_H
#define MATC_AFFINE_H
#include "compiler/ir/build.h"

enum { AFFINE_LANES = 3 };

/* One lane as offset + sum of factor[i] * lane i of the root. */
typedef struct {
    Ref root;    /* 0: a constant */
    bool closed; /* a lane that others cannot start from: the fourth one */
    double factor[AFFINE_LANES], offset;
} Line;

/* The lines found so far. */
typedef struct {
    /* by Ref: of its lanes in `lines`, from 1; 0: the node is what others start from */
    uint32_t *first;
    size_t first_room;
    Line *lines;
    size_t count, room;
    Ref done; /* nodes below it were looked at */
} Affine;
#endif
