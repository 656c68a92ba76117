/* Lines of --stats on displaced surfaces. */
#ifndef MATC_RENDERER_DISPLACED_STATS_H
#define MATC_RENDERER_DISPLACED_STATS_H
#include "runtime/frame_graph/frame.h"

/* Writes which surfaces are ray-marched, which are drawn as grids of triangles instead and why,
 * and the cell size of volumes. Writes nothing for a scene without such surfaces. */
void displaced_stats_put(Text *out, const Renderer *renderer);
#endif
