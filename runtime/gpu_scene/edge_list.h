/* Lines of a picture along which its color jumps, for antialiasing: object silhouettes, creases,
 * horizons of planes. Computed in double from the scene's own numbers, without GL calls. The
 * lines include hidden ones; the pass that draws them tests visibility. */
#ifndef MATC_RENDER_EDGE_LIST_H
#define MATC_RENDER_EDGE_LIST_H
#include "runtime/gpu_scene/view_space.h"
#include "runtime/gpu_scene/edge_mesh.h"

enum {
    EDGE_LIST_PIECE = 32 /* max length in pixels; longer lines are cut */,
    EDGE_LIST_TEXELS = 2
};

/* An end of a line: position in pixels from the picture's lower left corner, and depth as in the
 * target depth, which is linear along a line. */
typedef struct {
    float x, y, depth;
    float crease; /* 1: a crease, whose sides have the same depth; 0: a silhouette */
} EdgeEnd;

typedef struct {
    EdgeEnd (*lines)[EDGE_LIST_TEXELS]; /* two ends per line, a texel each */
    int count, capacity;
} EdgeList;

/* Finds the edges of an object that is no plane. Returns false if memory runs out, with *made
 * empty. */
bool edge_list_mesh(const Scene *scene, const SceneObject *object, EdgeMesh *made);
/* Finds all lines of a picture of `size` pixels. Returns false if memory runs out, with *made
 * empty. */
bool edge_list_make(const Scene *scene, const ViewSpace *space, const int size[2], EdgeList *made);
/* Frees the list; safe on an empty one. */
void edge_list_free(EdgeList *list);
#endif
