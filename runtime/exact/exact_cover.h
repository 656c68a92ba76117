/* Lists of exact shadows, made by compute (exact_cover.glsl): for each cell of what a light sees,
 * the numbers of all triangles that cover any of it. One that only grazes the cell may be there,
 * too. So much memory: eight bytes for each cell, and four for each triangle in each cell that it
 * covers.
 *
 * Entries are counted; their number is read back; then they are listed, in no particular order. */
#ifndef MATC_RENDER_EXACT_COVER_H
#define MATC_RENDER_EXACT_COVER_H
#include "runtime/draw/material.h"
#include "runtime/exact/exact_lists.h"

typedef struct {
    Material cover, begins;
    /* buffers: heads, cells, lists; what the programs count, and blocks of rows */
    GLuint lists, work;
    size_t room, most;          /* words that the buffer of lists has, and may have */
    size_t blocks;              /* for which `work` has room */
    size_t words;               /* of the lists */
    int light_count, coarsened; /* with heads; times that cells were made twice as wide */
} ExactCover;

/* Compiles. `most`: words that lists may take. False: see the context's error; *made is empty
 * then. */
bool exact_cover_open(Store *store, size_t most, ExactCover *made);
/* Makes the lists of what is in a buffer of corners. Where they would take too much, cells are made
 * twice as wide, and again. False: see the context's error. */
bool exact_cover_make(ExactCover *cover, const Scene *scene, const ExactTriangles *triangles,
                      GLuint corners);
/* Entries of the longest list. */
int exact_cover_longest(const ExactCover *cover);
/* Without lists, but with its programs. */
void exact_cover_empty(ExactCover *cover);
/* Safe on an empty one, which it leaves behind. */
void exact_cover_close(ExactCover *cover);
#endif
