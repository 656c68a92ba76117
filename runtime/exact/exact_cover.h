/* Lists of exact shadows, made by compute (exact_cover.glsl): for each cell of a light's view,
 * the numbers of all triangles that cover any part of it; triangles that barely touch the cell
 * may be included. Memory: eight bytes per cell, and four per triangle and covered cell.
 *
 * Entries are counted, their number is read back, and then they are listed, in arbitrary order. */
#ifndef MATC_RENDER_EXACT_COVER_H
#define MATC_RENDER_EXACT_COVER_H
#include "runtime/gpu_material/material.h"
#include "runtime/exact/exact_lists.h"

typedef struct {
    Material cover, begins;
    /* Buffers: headers, cells, lists; counters of the programs, and blocks of rows. */
    GLuint lists, work;
    size_t capacity, most; /* words of the buffer of lists, and max words */
    size_t blocks;         /* capacity of `work` */
    size_t words;          /* words that the lists use */
    /* lights with headers; number of times that cells were doubled in width */
    int light_count, coarsened;
} ExactCover;

/* Compiles the programs. `most`: limit of the lists in words. False: failed, see the context's
 * error; *made is empty then. */
bool exact_cover_open(Store *store, size_t most, ExactCover *made);
/* Makes the lists of the triangles in the buffer `corners`. If they exceed the limit, cells are
 * doubled in width, repeatedly. False: failed, see the context's error. */
bool exact_cover_make(ExactCover *cover, const Scene *scene, const ExactTriangles *triangles,
                      GLuint corners);
/* Returns the number of entries of the longest list. */
int exact_cover_longest(const ExactCover *cover);
/* Deletes the lists, and keeps the programs. */
void exact_cover_empty(ExactCover *cover);
/* Frees all resources and zeroes the struct; also valid for a zeroed struct. */
void exact_cover_close(ExactCover *cover);
#endif
