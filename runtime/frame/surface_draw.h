/* Drawing of surfaces into targets. */
#ifndef MATC_FRAME_SURFACE_DRAW_H
#define MATC_FRAME_SURFACE_DRAW_H
#include "runtime/frame/frame.h"

/* Begin: binds the framebuffer and enables the depth test. End: restores the context's initial
 * state. */
void surface_draw_begin(const Render *render, const Framebuffer *framebuffer, GLenum test);
void surface_draw_end(const Render *render);
/* Reports whether the view shows surfaces. The other two draw the GPU scene's objects in the view's
 * style, and its infinite planes; each draws either the opaque or the transparent ones. */
bool surface_draw_is_shown(const Render *render);
void surface_draw_objects(Render *render, bool transparent);
void surface_draw_planes(Render *render, bool transparent);
#endif
