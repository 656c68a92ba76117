/* Meshes with ray-marched displacement. All passes can draw the triangles of a grid
 * (displaced_grid.c). Passes that support ray marching (gpu_scene_trace.h) draw the patches' hulls
 * instead, whose program follows each pixel's ray through a pyramid of bounds of the grid's
 * triangles, and on to the exact surface. */
#ifndef MATC_DISPLACE_DISPLACED_TRACED_H
#define MATC_DISPLACE_DISPLACED_TRACED_H
#include "runtime/displace/displaced.h"

typedef struct {
    /* Draws hulls: writes the depth, and the surface point that the ray hits. The caller
     * sets its uniforms trace_viewer, trace_pixel and trace_offset. */
    Material trace;
    Mesh hulls;    /* closed hulls, facing outward; for parallax the base triangles */
    int triangles; /* number of triangles of a hull: 8, or 1 for parallax */
    /* Marches along the tangent plane of a base triangle: parallax_fragment.glsl. Shadow maps
     * use the grid. */
    bool parallax;
    int parts;             /* parts of a patch's edge: a power of two */
    Material levels, hull; /* compute programs of the pyramid, and of the hulls */
    GLuint nodes;
} DisplacedTrace;

/* Returns the state of ray marching; NULL: the mesh is not ray-marched. */
DisplacedTrace *displaced_traced(const Displaced *displaced);
/* Binds the inputs of the program and of trace_patch.glsl: rows and patches of the base,
 * triangles of the grid, nodes. */
void displaced_traced_bind(const Displaced *displaced, const Mesh *mesh);
#endif
