/* The oracle's positions of displaced surface points. */
#ifndef MATC_VALUE_MOVE_H
#define MATC_VALUE_MOVE_H
#include "compiler/oracle/oracle.h"

typedef struct {
    const Surface *at;
    int count;
} MovePoints;

/* By a material of a document. False: it has faults. */
bool move_points(const char *path, int material, const MovePoints *points, double (*position)[3]);
/* The normals that they are shaded with there, of any length. */
bool move_normals(const char *path, int material, const MovePoints *points, double (*normal)[3]);
#endif
