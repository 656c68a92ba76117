/* Memory of a frame's targets: textures by the plan's pieces of memory, and the size of a tile
 * that fits into memory. */
#ifndef MATC_RENDERER_FRAME_MEMORY_H
#define MATC_RENDERER_FRAME_MEMORY_H
#include "runtime/frame_graph/frame.h"

/* Computes the targets' size, the guard band around a tile, and the tile's position, from the
 * plan and the memory that the caller allows. */
void frame_memory_size(Renderer *renderer);
/* Reports whether the guard band is still wide enough after a change of the camera. */
bool frame_memory_fits(const Renderer *renderer);
/* Makes render->targets.memory and render->targets.textures of the computed size. False if
 * memory runs out. */
bool frame_memory_make(Renderer *renderer);
void frame_memory_delete(Renderer *renderer);
#endif
