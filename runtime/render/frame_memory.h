/* The memory of a frame's targets: textures by the plan's pieces, and the size of a tile that it
 * holds. */
#ifndef MATC_RENDER_FRAME_MEMORY_H
#define MATC_RENDER_FRAME_MEMORY_H
#include "runtime/frame/frame.h"

/* The size of targets and the margin around a tile, and their place: by the plan and the memory
 * that the caller allows. */
void frame_memory_size(Render *render);
/* The camera is another: the margin is still enough. */
bool frame_memory_fits(const Render *render);
/* Makes render->targets.memory and render->targets.textures, of that size. False: out of memory. */
bool frame_memory_make(Render *render);
void frame_memory_delete(Render *render);
#endif
