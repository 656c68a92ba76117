/* For each light whose shadows are exact: lists of the triangles that may stand between it and a point, by cells of what it sees. Whatever hides
 * a point of a cell from the light is in the cell's list; a triangle that only grazes the cell may be, too. No GL.
 *
 * A light sees one view, all around (six views of 90 degrees, as shadow_views.h has them), or, directional, one without perspective. Each is a
 * square of cells. So much memory: four bytes for each cell, and for each triangle in each cell that it covers. */
#ifndef MATC_RENDER_EXACT_LISTS_H
#define MATC_RENDER_EXACT_LISTS_H
#include "runtime/render/exact_triangles.h"

/* Words of a light's head, as exact.glsl has them; ROWS and what is before are floats. */
typedef enum {
    EXACT_LISTS_FROM,       /* three: the light's position; directional: the way to it, of unit length */
    EXACT_LISTS_PLACED = 3, /* 1: it has a position */
    EXACT_LISTS_ROWS,       /* four each: lanes of a place, of (point - position, 1), or of (point, 1) */
    EXACT_LISTS_VIEWS = 16, /* 1, or 6 */
    EXACT_LISTS_SIZE,       /* cells of a view's edge */
    EXACT_LISTS_CELLS, /* the word in which the first cell's list begins; the next has its end, and the next cell's begin */
    EXACT_LISTS_HEAD
} ExactListsWord;

typedef struct {
    uint32_t *words; /* heads; then, light by light, words where lists begin, and lists: numbers of triangles */
    size_t count;    /* of words */
    int *heads;      /* of each light of the scene: the number of its head; -1: it has none */
    int light_count; /* that have one */
    int coarsened;   /* times that cells were made twice as wide, so that there are no more words than there may be */
    size_t longest;  /* list */
} ExactLists;

typedef struct {
    const Scene *scene;
    const ExactTriangles *triangles;
    size_t most; /* words */
} ExactListsSource;

/* A light's shadows are exact. */
bool exact_lists_wanted(const SceneLight *light);
/* False: memory ran out, made->count 0; or there are more triangles than words, even where a view has one cell only: made->count of them at
 * least are needed. *made has nothing to free then. */
bool exact_lists_make(const ExactListsSource *source, ExactLists *made);
/* Safe on an empty one. */
void exact_lists_free(ExactLists *lists);
#endif
