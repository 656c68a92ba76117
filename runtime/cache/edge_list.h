/* The lines of a picture along which its colour jumps: outlines of objects as the camera sees them,
 * their creases, horizons of planes. In double, on the scene's own numbers; no GL. What hides them
 * is for who draws them to find out. */
#ifndef MATC_RENDER_EDGE_LIST_H
#define MATC_RENDER_EDGE_LIST_H
#include "runtime/cache/view_space.h"
#include "runtime/cache/edge_mesh.h"

enum { EDGE_LIST_PIECE = 32 /* pixels: longer lines are cut */, EDGE_LIST_TEXELS = 2 };

/* One end: pixels from the picture's lower left corner, and the depth there, as the target of depth
 * has it; it is linear along a line. */
typedef struct {
    float x, y, depth;
    float crease; /* 1: what is on both sides of the line is as far away; 0: it is an outline */
} EdgeEnd;

typedef struct {
    EdgeEnd (*lines)[EDGE_LIST_TEXELS]; /* both ends: as many texels */
    int count, room;
} EdgeList;

/* Edges of an object that is no plane. False: out of memory; *made is empty then. */
bool edge_list_mesh(const Scene *scene, const SceneObject *object, EdgeMesh *made);
/* Likewise. */
bool edge_list_make(const Scene *scene, const ViewSpace *space, const int size[2], EdgeList *made);
/* Safe on an empty one. */
void edge_list_free(EdgeList *list);
#endif
