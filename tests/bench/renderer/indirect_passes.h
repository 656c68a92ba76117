/* The table passes of matbench indirect. */
#ifndef MATC_BENCH_INDIRECT_PASSES_H
#define MATC_BENCH_INDIRECT_PASSES_H
#include "runtime/renderer/renderer.h"

typedef struct {
    /* indirect_scenes_bunny; NULL: the bunny, where tests/meshes/fetch.sh has put it */
    const char *mesh, *lift;
    int edge; /* of the picture, in pixels */
    bool timed;
} IndirectPasses;

bool bench_indirect_passes(GlContext *gl, const IndirectPasses *passes);
#endif
