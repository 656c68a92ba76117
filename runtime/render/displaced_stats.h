/* Lines of --stats on how surfaces are displaced. */
#ifndef MATC_RENDER_DISPLACED_STATS_H
#define MATC_RENDER_DISPLACED_STATS_H
#include "runtime/frame/frame.h"

/* Lines: what is traced, and what has a grid instead, and why; how fine the cells of volumes are.
 * Nothing where nothing is. */
void displaced_stats_put(Text *out, const Render *render);
#endif
