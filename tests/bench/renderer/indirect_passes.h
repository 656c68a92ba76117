/* The table passes of matbench indirect. */
#ifndef MATC_BENCH_INDIRECT_PASSES_H
#define MATC_BENCH_INDIRECT_PASSES_H
#include "runtime/renderer/renderer.h"

typedef struct {
    /* indirect_scenes_bunny; NULL: the bunny from tests/meshes/fetch.sh */
    const char *mesh, *lift;
    int edge; /* width and height of the picture */
    bool timed;
} IndirectPasses;

bool bench_indirect_passes(GlContext *gl, const IndirectPasses *passes);
#endif
