/* A volume that replaces a surface, as plain triangles. */
#ifndef MATC_SCENE_VOLUME_H
#define MATC_SCENE_VOLUME_H
#include "runtime/tessellate/scene_volume_cells.h"

/* Sets `heights` and `along` of `count` columns from their positions (`at`). False: too many
 * operations, or out of memory. */
typedef bool SceneSolid(void *user, SceneColumn *columns, int count);

typedef struct {
    SceneSolid *solid;
    void *user;
    int parts;     /* parts of an edge of the shape; 0: chosen by `triangles` */
    int triangles; /* approximate number of triangles */
} SceneVolume;

/* Makes the solid parts over a shape, closed at its boundary. Pieces and gaps thinner than a
 * step may be missed: the step across is an edge's part of the shape; along the normal it is at
 * most that, and at most a quarter of the thickness of each pair of heights, and of the gap
 * between them, at their thickest places. `base` has the points below the vertices. `steps`:
 * mean width and height of the cells, in units of heights. False: *made is empty. */
bool scene_volume(const Shape *from, const SceneVolume *volume, Shape *made, double steps[2]);
#endif
