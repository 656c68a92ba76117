/* The table path of matbench indirect. */
#ifndef MATC_BENCH_INDIRECT_PATH_H
#define MATC_BENCH_INDIRECT_PATH_H
#include "runtime/renderer/renderer.h"

bool bench_indirect_path(GlContext *gl);
#endif
