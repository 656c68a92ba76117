/* The oracle's positions of displaced surface points. */
#ifndef MATC_VALUE_MOVE_H
#define MATC_VALUE_MOVE_H
#include "compiler/oracle/oracle.h"

typedef struct {
    const Surface *at;
    int count;
} MovePoints;

/* Displaces points by a document's material. Returns false if the document has errors. */
bool move_points(const char *path, int material, const MovePoints *points, double (*position)[3]);
/* The shading normals of the displaced points, unnormalized. */
bool move_normals(const char *path, int material, const MovePoints *points, double (*normal)[3]);
#endif
