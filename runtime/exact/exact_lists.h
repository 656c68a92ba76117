/* Views of lights with exact shadows, for lists of triangles by cells: the list of a cell
 * contains every triangle that may occlude a point in the cell from the light. exact_cover.h
 * makes the lists. No GL.
 *
 * A spot light has one view, a light in all directions six of 90 degrees, as in shadow_views.h,
 * and a directional light one without perspective. Each view is a square of cells. */
#ifndef MATC_RENDER_EXACT_LISTS_H
#define MATC_RENDER_EXACT_LISTS_H
#include "gen/exact_lists_layout.h"
#include "runtime/exact/exact_triangles.h"

enum {
    EXACT_LISTS_PAIR = 2, /* words of a cell's entry */
    /* number of times that cells can be doubled in width, until one is left */
    EXACT_LISTS_COARSEST = 10,
    EXACT_LISTS_LIGHTS_MAX = 65535 /* maximum number of lights with headers */
};

typedef struct {
    uint32_t *heads; /* headers of the lights, in sequence */
    int light_count; /* number of lights with a header, in the order of the scene */
    size_t cells;    /* cells of all views: their words follow the headers */
} ExactLists;

/* Returns whether the light's shadows are exact. */
bool exact_lists_wanted(const SceneLight *light);
/* Makes headers with cells widened by 2^coarser. False: out of memory; *made is empty then. */
bool exact_lists_make(const Scene *scene, const ExactTriangles *triangles, int coarser,
                      ExactLists *made);
/* Frees the lists; also valid for a zeroed struct. */
void exact_lists_free(ExactLists *lists);
#endif
