/* Tables of matbench render about passes. A function returns false after it reported an error on
 * standard error. */
#ifndef RENDER_PASSES_H
#define RENDER_PASSES_H
#include "render_time.h"

bool bench_passes(const Bench *bench);
bool bench_fragments(const Bench *bench);
/* Cost of a light by surface, relative to Phong's. */
bool bench_lobes(const Bench *bench);
#endif
