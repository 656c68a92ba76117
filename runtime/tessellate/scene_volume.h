/* A volume in a surface's place, as plain triangles. */
#ifndef MATC_SCENE_VOLUME_H
#define MATC_SCENE_VOLUME_H
#include "runtime/tessellate/scene_volume_cells.h"

/* Sets `heights` and `along` of so many columns by where they are (`at`). False: it takes too many
 * operations, or more memory than there is. */
typedef bool SceneSolid(void *user, SceneColumn *columns, int count);

typedef struct {
    SceneSolid *solid;
    void *user;
    int parts;     /* of an edge of the shape; 0: by the next */
    int triangles; /* about how many there shall be */
} SceneVolume;

/* Makes the solid parts over a shape, closed where it ends. Pieces and gaps that are thinner than a
 * step may be missed: across, an edge's part of the shape; along the normal no more than that, nor
 * than a quarter of what each pair of heights, and the gap between both, is thick where it is
 * thickest. `base` has what the points stand over. `steps`: how wide the cells are in the mean, and
 * how high, in units of heights. False: *made is empty. */
bool scene_volume(const Shape *from, const SceneVolume *volume, Shape *made, double steps[2]);
#endif
