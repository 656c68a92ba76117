/* The table quality of matbench indirect. */
#ifndef MATC_BENCH_INDIRECT_QUALITY_H
#define MATC_BENCH_INDIRECT_QUALITY_H
#include "runtime/renderer/renderer.h"

typedef struct {
    int edge; /* width and height of the picture */
    bool timed;
} IndirectQuality;

bool bench_indirect_quality(GlContext *gl, const IndirectQuality *quality);
#endif
