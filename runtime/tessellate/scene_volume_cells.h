/* Triangles around what is solid: over each triangle of a grid stand prisms, one on the other, and
 * each is crossed by the surface where some of its corners are solid and some are not. */
#ifndef MATC_SCENE_VOLUME_CELLS_H
#define MATC_SCENE_VOLUME_CELLS_H
#include "runtime/gl/shape.h"
#include <stddef.h>

/* The solid intervals over one place. */
typedef struct {
    ShapeVertex at;
    /* solid from [0] to [1] and from [2] to [3]; nothing where the second is no more */
    double heights[4];
    double along[3]; /* where a height of 1 leads, in the object's space */
} SceneColumn;

typedef struct {
    const Shape *grid;
    const int *place; /* by vertex of the grid: the first that stands there, which has the column */
    const SceneColumn *columns;
    double low, step; /* level k is at low + k step */
    int levels;       /* nothing is solid at the first and at the last, which is this one */
} SceneLayers;

typedef enum {
    SCENE_NODE_up,    /* between levels `level` and the next, over vertex a */
    SCENE_NODE_along, /* between vertices a and b, at the level */
    SCENE_NODE_corner /* over vertex a, at the level: where a sheet's rim is closed */
} SceneNodeKind;

/* A vertex of the triangles. */
typedef struct {
    SceneNodeKind kind;
    uint32_t a, b;
    int level;
    int triangle; /* of the grid, one that it is over */
    /* an edge of that triangle, beyond which there is no other: it stands on the wall over it; -1:
     * it does not */
    int rim;
} SceneNode;

typedef struct {
    SceneNode *nodes;
    uint32_t *indices;
    size_t node_count, node_room, index_count, index_room;
} SceneCells;

bool scene_column_solid(const SceneColumn *column, double height);
/* Triangles that turn counterclockwise as they are seen from where it is not solid, each side of
 * which has another one. False: memory ran out, *made is empty. */
bool scene_volume_cells(const SceneLayers *layers, SceneCells *made);
void scene_cells_free(SceneCells *cells);
#endif
