/* The thesis' tables of matbench indirect. */
#ifndef MATC_BENCH_INDIRECT_TABLE_H
#define MATC_BENCH_INDIRECT_TABLE_H
#include "runtime/renderer/renderer.h"

typedef struct {
    /* a folder with bunny.obj and dragon-small.ply; NULL: the folder of tests/meshes/fetch.sh */
    const char *meshes;
    int edge; /* width and height of the picture */
    bool timed;
} IndirectTable;

bool bench_indirect_table(GlContext *gl, const IndirectTable *table);
#endif
