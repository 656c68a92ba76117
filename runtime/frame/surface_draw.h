/* How surfaces are drawn to targets. */
#ifndef MATC_FRAME_SURFACE_DRAW_H
#define MATC_FRAME_SURFACE_DRAW_H
#include "runtime/frame/frame.h"

/* State for drawing surfaces: the framebuffer and the depth test; then the initial state of a
 * context. */
void surface_draw_begin(const Render *render, const Framebuffer *framebuffer, GLenum test);
void surface_draw_end(const Render *render);
/* The view shows surfaces. Draws the cache's objects, as the view has them; the planes: those that
 * are opaque, or the others. */
bool surface_draw_is_shown(const Render *render);
void surface_draw_objects(Render *render, bool transparent);
void surface_draw_planes(Render *render, bool transparent);
#endif
