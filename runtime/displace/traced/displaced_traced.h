/* Meshes that are traced. All passes have the triangles of a grid (displaced_grid.c); those that
 * know of it (cache_trace.h) draw the hulls of patches instead, whose program follows each pixel's
 * ray through a pyramid of what the grid's triangles are within, and on to the surface. */
#ifndef MATC_DISPLACE_DISPLACED_TRACED_H
#define MATC_DISPLACE_DISPLACED_TRACED_H
#include "runtime/displace/displaced.h"

typedef struct {
    Material
        /* draws hulls: depth, and where a ray met the surface; its uniforms trace_viewer,
         * trace_pixel and trace_offset are the caller's */
        trace;
    Mesh hulls;    /* closed, turned outward; of parallax base triangles */
    int triangles; /* of a hull: 8, or 1 */
    /* along the tangent plane of a base triangle: parallax_fragment.glsl. Shadow maps have the
     * grid */
    bool parallax;
    int parts;             /* of an edge of a patch: a power of two */
    Material levels, hull; /* compute the pyramid, and the hulls */
    GLuint nodes;
} DisplacedTrace;

/* NULL: it is not traced. */
DisplacedTrace *displaced_traced(const Displaced *displaced);
/* Binds what the program, and trace_patch.glsl, read: rows and patches of the base, triangles of
 * the grid, nodes. */
void displaced_traced_bind(const Displaced *displaced, const Mesh *mesh);
#endif
