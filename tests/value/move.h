/* Where the oracle has points of a surface once it is displaced. */
#ifndef MATC_VALUE_MOVE_H
#define MATC_VALUE_MOVE_H
#include "compiler/oracle/oracle.h"

typedef struct {
    const Surface *at;
    int count;
} MovePoints;

/* By a material of a document. False: it has faults. */
bool move_points(const char *path, int material, const MovePoints *points, double (*position)[3]);
#endif
