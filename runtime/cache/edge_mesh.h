/* Edges of a mesh where its silhouette may be, or where shading is discontinuous. Adjacency of
 * faces is found by positions, so that vertices with different attributes meet. No GL. */
#ifndef MATC_RENDER_EDGE_MESH_H
#define MATC_RENDER_EDGE_MESH_H
#include "runtime/gl/shape.h"

typedef struct {
    float ends[2][3];
    float normals[2][3]; /* of the faces on both sides, of any length */
    float apexes[2][3];  /* their third corners */
    /* only one face is there, or more than two: it is seen whichever way they face */
    bool open;
    bool crease; /* the shade jumps all along it */
} MeshEdge;

typedef struct {
    MeshEdge *edges;
    int count;
    bool solid;             /* it is closed, and its faces show their fronts outwards */
    double low[3], high[3]; /* the box around it */
} EdgeMesh;

/* False: out of memory; *made is empty then. */
bool edge_mesh_make(const Shape *shape, EdgeMesh *made);
/* Safe on an empty one. */
void edge_mesh_free(EdgeMesh *mesh);
#endif
