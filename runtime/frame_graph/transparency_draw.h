/* Choice of the technique for transparent surfaces: per-pixel linked lists or depth peeling. */
#ifndef MATC_FRAME_GRAPH_TRANSPARENCY_DRAW_H
#define MATC_FRAME_GRAPH_TRANSPARENCY_DRAW_H
#include "runtime/frame_graph/frame.h"

/* Checks that the driver supports the chosen technique. Returns false with a reason in the
 * context's error. */
bool transparency_check(GlContext *gl, const RendererOptions *options);
/* Returns the technique to try first: lists, unless the options ask for peeling or the driver
 * lacks them. */
Transparency transparency_first(const Renderer *renderer);
bool transparency_has_lists(const GlContext *gl);
/* Returns the max bytes of a buffer of fragments. */
size_t transparency_most_bytes(const Renderer *renderer);
/* Reports whether the scene has transparent surfaces and draws them by the technique `way`. */
bool transparency_is(const Renderer *renderer, Transparency way);
/* Sets a uniform of all programs of transparent surfaces. */
void transparency_set(Renderer *renderer, const char *name, float number);
/* Returns the driver's last two texture units, for textures of the passes. False if a material
 * already uses them; see the context's error. */
bool transparency_units(Renderer *renderer, int units[2]);
#endif
