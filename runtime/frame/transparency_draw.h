/* How what is transparent is drawn: the choice, and what it takes. */
#ifndef MATC_FRAME_TRANSPARENCY_DRAW_H
#define MATC_FRAME_TRANSPARENCY_DRAW_H
#include "runtime/frame/frame.h"

/* The choice can be met. False: see the context's error. */
bool transparency_check(GlContext *gl, const RenderOptions *options);
/* Lists, if nothing else is wanted, and there are some. */
Transparency transparency_first(const Render *render);
bool transparency_has_lists(const GlContext *gl);
/* Greatest size of a buffer of fragments. */
size_t transparency_most_bytes(const Render *render);
/* Something is transparent, and that is how it is drawn. */
bool transparency_is(const Render *render, Transparency way);
/* Sets a number of all programs of what is transparent. */
void transparency_set(Render *render, const char *name, float number);
/* The last units that the driver has, for textures of the passes, number 0 and 1. False: a material
 * takes them. */
bool transparency_units(Render *render, int units[2]);
#endif
