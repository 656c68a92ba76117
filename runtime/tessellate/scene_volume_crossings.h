/* Intersections of a volume's surface with the edges of its prisms. */
#ifndef MATC_SCENE_VOLUME_CROSSINGS_H
#define MATC_SCENE_VOLUME_CROSSINGS_H
#include "runtime/tessellate/scene_volume.h"

/* Position of a node: over an edge between two places, from the lower number to the higher, so
 * that all nodes of one edge agree; and its height. */
typedef struct {
    int from, to;
    double t, height;  /* t from 0 at `from` to 1 at `to` */
    SceneColumn there; /* the solid intervals at the nearest evaluated position */
    double field;      /* f there: 0 on a surface, other values at a cliff */
} SceneSpot;

/* Returns the field f: positive inside the enabled pairs (bits), 0 on the surface: max((z - h0)
 * (h1 - z), (z - h2) (h3 - z)); an empty pair has heights as well. */
double scene_volume_field(const SceneColumn *column, unsigned pairs, double z);
/* Returns the bits of the pairs that are nonempty in any of the columns. */
unsigned scene_volume_pairs(const SceneColumn *columns, int count);
/* Returns a (1 - t) + b t, for all attributes of a vertex. */
ShapeVertex scene_volume_mixed(const ShapeVertex *a, const ShapeVertex *b, double t);
/* Finds a position for each node; `order` gets the numbers of all nodes, grouped by edge, from
 * below. False: as for SceneSolid. */
bool scene_volume_crossings(const SceneVolume *volume, const SceneLayers *layers,
                            const SceneCells *cells, SceneSpot *spots, uint32_t *order);
#endif
