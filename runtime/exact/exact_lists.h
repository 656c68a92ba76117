/* Views of lights with exact shadows on the triangles, for lists of them by cells:
 * whatever hides a point of a cell from the light is in the cell's list. exact_cover.h makes the
 * lists. No GL.
 *
 * A light sees one view, all around (six views of 90 degrees, as shadow_views.h has them), or,
 * directional, one without perspective. Each is a square of cells. */
#ifndef MATC_RENDER_EXACT_LISTS_H
#define MATC_RENDER_EXACT_LISTS_H
#include "gen/exact_lists_layout.h"
#include "runtime/exact/exact_triangles.h"

enum {
    EXACT_LISTS_PAIR = 2, /* words of a cell */
    /* times that cells can be made twice as wide: one is left then */
    EXACT_LISTS_COARSEST = 10,
    EXACT_LISTS_LIGHTS_MOST = 65535 /* that can have heads */
};

typedef struct {
    uint32_t *heads; /* one behind the other */
    int light_count; /* that have one, in the order of the scene */
    size_t cells;    /* of all views: their words follow the heads */
} ExactLists;

/* A light's shadows are exact. */
bool exact_lists_wanted(const SceneLight *light);
/* Heads with cells that are 2^coarser times as wide as they would be. False: memory ran out; *made
 * is empty then. */
bool exact_lists_make(const Scene *scene, const ExactTriangles *triangles, int coarser,
                      ExactLists *made);
/* Safe on an empty one. */
void exact_lists_free(ExactLists *lists);
#endif
