/* Bisection by the driver: what is put into buffers for bisect.glsl. */
#ifndef MATC_DISPLACE_DISPLACED_BISECTION_H
#define MATC_DISPLACE_DISPLACED_BISECTION_H
#include "runtime/displace/displaced_method.h"

/* Patches as bases, as bisect.glsl has them: so many words, from malloc; NULL: memory ran out. */
uint32_t *displaced_bisection_bases(const ScenePatches *patches, size_t *count);

/* Memory of a mesh, and counts of the last view. */
typedef struct {
    int leaves, splits, merges; /* of the last view */
    size_t kept,
        /* bytes: from view to view, of places in use and of ranges; and of what a view begins anew,
         * of all there is room for */
        scratch;
    int looks;     /* times that leaves were looked at, all or those that may have changed; */
    int looked;    /* and how many */
    double pixels; /* what an error may have had, so that triangles are enough */
} DisplacedBisectionCost;
DisplacedBisectionCost displaced_bisection_cost(const Displaced *displaced);
/* The leaves that there are, as base << 32 | number, in no order: from malloc, `*count` of them;
 * NULL: see the context's error. */
uint64_t *displaced_bisection_leaves(const Displaced *displaced, int *count);
#endif
