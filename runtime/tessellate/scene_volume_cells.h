/* Triangles around a solid: over each triangle of a grid there are stacked prisms, and each is
 * crossed by the surface if some of its corners are solid and some are not. */
#ifndef MATC_SCENE_VOLUME_CELLS_H
#define MATC_SCENE_VOLUME_CELLS_H
#include "runtime/gl/shape.h"
#include <stddef.h>

/* The solid intervals along the displacement over one place. */
typedef struct {
    ShapeVertex at;
    /* solid from [0] to [1] and from [2] to [3]; empty if the second is not greater */
    double heights[4];
    double along[3]; /* vector of a height of 1, in object space */
} SceneColumn;

typedef struct {
    const Shape *grid;
    /* indexed by vertex of the grid: the first vertex at its place, which has the column */
    const int *place;
    const SceneColumn *columns;
    double low, step; /* level k is at height low + k step */
    int levels;       /* number of the last level; the first and the last have no solid */
} SceneLayers;

typedef enum {
    SCENE_NODE_up,    /* the node is over vertex a, between `level` and the next level */
    SCENE_NODE_along, /* the node is between vertices a and b, at `level` */
    /* the node is over vertex a, at `level`, and closes the volume at the shape's boundary */
    SCENE_NODE_corner
} SceneNodeKind;

/* A vertex of the triangles that bound the volume. */
typedef struct {
    SceneNodeKind kind;
    uint32_t a, b;
    int level;
    int triangle; /* the grid's triangle below the node */
    /* Boundary edge of that triangle whose wall contains the node; -1: not on a wall. */
    int rim;
} SceneNode;

typedef struct {
    SceneNode *nodes;
    uint32_t *indices;
    size_t node_count, node_capacity, index_count, index_capacity;
} SceneCells;

bool scene_column_solid(const SceneColumn *column, double height);
/* Makes triangles that are counterclockwise as seen from outside the solid, with a neighbor at
 * each side. False: out of memory, *made is empty. */
bool scene_volume_cells(const SceneLayers *layers, SceneCells *made);
void scene_cells_free(SceneCells *cells);
#endif
