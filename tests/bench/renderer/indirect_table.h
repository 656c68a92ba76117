/* The thesis' tables of matbench indirect. */
#ifndef MATC_BENCH_INDIRECT_TABLE_H
#define MATC_BENCH_INDIRECT_TABLE_H
#include "runtime/renderer/renderer.h"

typedef struct {
    /* a folder with bunny.obj and dragon-small.ply; NULL: where tests/meshes/fetch.sh puts them */
    const char *meshes;
    int edge; /* of the picture, in pixels */
    bool timed;
} IndirectTable;

bool bench_indirect_table(GlContext *gl, const IndirectTable *table);
#endif
