/* GLSL that displaces a point. Shared by move.c, vertex.c, compute.c and displace.c. */
#ifndef MATC_MOVE_H
#define MATC_MOVE_H
#include "compiler/emit/emit.h"

/* The attributes of displacement, such as "vec3 displacementNormal". */
enum { MOVE_ATTRIBUTES = 4 };
extern const char *const move_attributes[MOVE_ATTRIBUTES];
/* Marks the attributes that the displacement reads. */
void move_mark(const VertexMove *move, bool attribute[MOVE_ATTRIBUTES]);
/* Sets the variables that matc_displacement() reads. */
void move_put_inputs(Text *out, const VertexMove *move);
/* Writes the displaced world position to matc_worldPosition. A volume yields its highest point,
 * or the surface's own where nothing is solid. */
void move_put(Text *out, const VertexMove *move);
#endif
