/* Where a volume's surface crosses the edges of its prisms. */
#ifndef MATC_SCENE_VOLUME_SPOTS_H
#define MATC_SCENE_VOLUME_SPOTS_H
#include "runtime/tessellate/scene_volume.h"

/* Position of a node: over an edge of two places, from the lower number to the higher, so that all
 * nodes of one edge have it; and its height. */
typedef struct {
    int from, to;
    double t, height;  /* 0 to 1 from `from` to `to` */
    SceneColumn there; /* what is solid as near as the surface was looked for */
    double field;      /* of it there: 0 on a surface, elsewhere at a cliff */
} SceneSpot;

/* Above 0 where one of the pairs that count (bits) is solid, 0 on its surface: max((z - h0) (h1 -
 * z), (z - h2) (h3 - z)); a pair that is nowhere near has heights as well. */
double scene_volume_field(const SceneColumn *column, unsigned pairs, double z);
/* Which of the two pairs some of these columns have, as bits. */
unsigned scene_volume_pairs(const SceneColumn *columns, int count);
/* a (1 - t) + b t, of all that a vertex has. */
ShapeVertex scene_volume_mixed(const ShapeVertex *a, const ShapeVertex *b, double t);
/* One for each node; `order` gets the numbers of all, those over one edge together, from below.
 * False: as of SceneSolid. */
bool scene_volume_spots(const SceneVolume *volume, const SceneLayers *layers,
                        const SceneCells *cells, SceneSpot *spots, uint32_t *order);
#endif
