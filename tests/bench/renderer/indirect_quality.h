/* The table quality of matbench indirect. */
#ifndef MATC_BENCH_INDIRECT_QUALITY_H
#define MATC_BENCH_INDIRECT_QUALITY_H
#include "runtime/renderer/renderer.h"

typedef struct {
    int edge; /* of the picture, in pixels */
    bool timed;
} IndirectQuality;

bool bench_indirect_quality(GlContext *gl, const IndirectQuality *quality);
#endif
