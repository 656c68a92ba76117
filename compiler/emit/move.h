/* How a point is displaced, in GLSL. Between move.c and vertex.c, compute.c, displace.c. */
#ifndef MATC_MOVE_H
#define MATC_MOVE_H
#include "compiler/emit/emit.h"

/* The attributes of displacement, as "vec3 displacementNormal". */
enum { MOVE_ATTRIBUTES = 4 };
extern const char *const move_attributes[MOVE_ATTRIBUTES];
/* Marks those that it reads. */
void move_mark(const VertexMove *move, bool attribute[MOVE_ATTRIBUTES]);
/* Sets the variables that matc_displacement() reads. */
void move_put_inputs(Text *out, const VertexMove *move);
/* The displaced position in the world, as matc_worldPosition. Of a volume it is the highest, and
 * where nothing is solid the surface's own. */
void move_put(Text *out, const VertexMove *move);
#endif
