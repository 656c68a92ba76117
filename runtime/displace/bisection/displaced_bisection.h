/* Displacement by bisection on the GPU: the input buffer of bisect.glsl, and statistics. */
#ifndef MATC_DISPLACE_DISPLACED_BISECTION_H
#define MATC_DISPLACE_DISPLACED_BISECTION_H
#include "runtime/displace/displaced_method.h"

/* Converts patches to bases in the layout of bisect.glsl: `*count` words, from malloc; NULL: out
 * of memory. */
uint32_t *displaced_bisection_bases(const ScenePatches *patches, size_t *count);

/* Memory of a mesh, and statistics of the last view. */
typedef struct {
    int leaves, splits, merges; /* counts of the last view */
    /* Bytes that persist from view to view, for used slots and ranges; and bytes of scratch
     * data, for all slots. */
    size_t kept, scratch;
    int looks;     /* number of evaluation passes, over all tiles of leaves or the due ones */
    int looked;    /* leaf slots evaluated by these passes */
    double pixels; /* tolerated deviation in pixels for which the triangles sufficed */
} DisplacedBisectionCost;
DisplacedBisectionCost displaced_bisection_cost(const Displaced *displaced);
/* Returns the current leaves as base << 32 | number, unordered: `*count` of them, from malloc;
 * NULL: failed, see the context's error. */
uint64_t *displaced_bisection_leaves(const Displaced *displaced, int *count);
#endif
