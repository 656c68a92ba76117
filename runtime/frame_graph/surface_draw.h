/* Drawing of surfaces into targets. */
#ifndef MATC_FRAME_GRAPH_SURFACE_DRAW_H
#define MATC_FRAME_GRAPH_SURFACE_DRAW_H
#include "runtime/frame_graph/frame.h"

/* Begin: binds the framebuffer and enables the depth test. End: restores the context's initial
 * state. */
void surface_draw_begin(const Renderer *renderer, const Framebuffer *framebuffer, GLenum test);
void surface_draw_end(const Renderer *renderer);
/* Reports whether the view shows surfaces. The other two draw the GPU scene's objects in the view's
 * style, and its infinite planes; each draws either the opaque or the transparent ones. */
bool surface_draw_is_shown(const Renderer *renderer);
void surface_draw_objects(Renderer *renderer, bool transparent);
void surface_draw_planes(Renderer *renderer, bool transparent);
#endif
